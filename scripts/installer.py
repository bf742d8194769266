"""Run pip quietly, and say in one sentence why it failed. Standard library only."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

# What pip prints, by reason; the first reason with a sign in pip's output is given. An index that cannot be
# reached also leads to "No matching distribution", so it comes first.
REASONS = (
    (
        (
            "ConnectTimeoutError",
            "Connection refused",
            "Connection reset",
            "ConnectionError",
            "Failed to establish a new connection",
            "Network is unreachable",
            "NewConnectionError",
            "ProxyError",
            "ReadTimeoutError",
            "Temporary failure in name resolution",
        ),
        "packages are missing and the package index cannot be reached; connect to the network, or set pip's "
        "proxy or index, and run the same command again",
    ),
    (
        ("DO NOT MATCH THE HASHES",),
        "a downloaded package is not the one the lock file names; check which index pip is set to",
    ),
    (("No space left on device",), "the disk is full"),
    (
        ("No matching distribution", "Could not find a version"),
        "the index has no wheel of a locked package for this Python and computer; "
        "run make PYTHON=/path/to/another/python",
    ),
    (("No module named pip",), "the environment has no pip; remove .venv and run the same command again"),
)


class InstallError(Exception):
    """The environment could not be made: one sentence, below it the last lines of the tool that failed."""

    def __init__(self, sentence: str, lines: Sequence[str] = ()) -> None:
        super().__init__("\n".join([sentence, *(f"  {line}" for line in lines)]))


def run_pip(python: Path, arguments: Sequence[str]) -> None:
    """Run pip, showing on a terminal the package it is at and nothing else.

    Args:
        python: Interpreter whose pip runs; its environment is changed.
        arguments: pip's own arguments, the command first.

    Raises:
        InstallError: if pip fails; the reason in one sentence, then pip's last lines.
    """
    # -I keeps the user's PYTHONPATH and user site out of it; -u lets the progress be seen in time.
    command = [str(python), "-Iu", "-m", "pip", "--disable-pip-version-check", "--no-input", *arguments]
    lines = []
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            if line.strip() and not line.startswith("Ignoring "):
                lines.append(line.rstrip())
            if line.startswith("Collecting "):
                show_progress(line.split()[1])
    show_progress("")
    if process.returncode != 0:
        raise InstallError(f"error: {reason(lines)}; pip's last lines are:", lines[-12:])


def compile_packages(python: Path) -> None:
    """Compile the installed packages, whatever PYTHONDONTWRITEBYTECODE and pip's own settings say.

    Uncompiled, the first import of the packages takes seconds longer, every time if nothing may be written.
    All processors take part, which pip's own compiling does not do.
    """
    code = (
        "import compileall, sysconfig\n"
        "compileall.compile_dir(sysconfig.get_path('purelib'), quiet=2, workers=0)"
    )
    # Packages ship files that are not meant to compile (templates, syntax of other Pythons), so the result
    # says nothing.
    subprocess.run([str(python), "-I", "-c", code], capture_output=True)


def reason(lines: Sequence[str]) -> str:
    """Return why pip failed, in words for somebody who does not know pip."""
    text = "\n".join(lines)
    for signs, sentence in REASONS:
        if any(sign in text for sign in signs):
            return sentence
    return "pip failed"


def show_progress(package: str) -> None:
    """Overwrite the terminal's line with a package's name; an empty one clears the line."""
    if sys.stderr.isatty():
        print(f"\r\033[K  {package}" if package else "\r\033[K", end="", file=sys.stderr, flush=True)
