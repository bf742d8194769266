"""Runs the blocks of a page as a reader would who copies them one by one.

``python -m scripts.site.running docs/tutorial.md`` runs a page and writes what its blocks print into it.
"""

import contextlib
import doctest
import io
import os
import shlex
import subprocess
import sys
import tempfile
from argparse import ArgumentParser
from collections.abc import Iterator
from pathlib import Path

from scripts.site.blocks import Block, blocks, with_outputs
from trimmer.command_line.main import main as trimmer_command

PROJECT = Path(__file__).resolve().parents[2]
_SHELL_SIGNS = frozenset("|<>&;$*`")


class PageError(AssertionError):
    """A block does not do what its page says; the message names page, line and the difference."""


def run_page(page: Path, folder: Path, *, slow: bool) -> dict[int, str]:
    """Run the blocks of a page in a folder and return what they print, by their lines.

    Args:
        page: A Markdown file.
        folder: Where the blocks run; ``examples`` is put there, and what they write stays.
        slow: Whether slow blocks are run too.

    Raises:
        PageError: if a block prints something else than the page says, or ends with another exit code.
    """
    printed: dict[int, str] = {}
    try:
        for block, text in _ran(page, folder, slow):
            printed[block.line] = text
            if block.output is not None and not _agrees(block.output, text):
                raise PageError(_told(page, block, _difference(block.output, text)))
    finally:
        if "matplotlib.pyplot" in sys.modules:
            sys.modules["matplotlib.pyplot"].close("all")
    return printed


def _ran(page: Path, folder: Path, slow: bool) -> Iterator[tuple[Block, str]]:
    examples = folder / "examples"
    if not examples.exists():
        examples.symlink_to(PROJECT / "examples", target_is_directory=True)
    names: dict[str, object] = {"__name__": "__main__"}
    with contextlib.chdir(folder):
        for block in blocks(page.read_text(encoding="utf-8")):
            if block.title is not None and block.language != "sh":
                Path(block.title).write_text(block.content, encoding="utf-8")
            if block.is_run and (slow or not block.slow):
                yield (
                    block,
                    _python(page, block, names) if block.language == "python" else _shell(page, block),
                )


def _python(page: Path, block: Block, names: dict[str, object]) -> str:
    code = compile("\n" * (block.line - 1) + block.content, str(page), "exec")
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(code, names)
    return printed.getvalue()


def _shell(page: Path, block: Block) -> str:
    """Run commands: plain ones of this package in this process, as imports take longer than work."""
    commands = [line for line in block.content.replace("\\\n", " ").splitlines() if line.strip()]
    plain = all(line.startswith("trimmer ") and not _SHELL_SIGNS & set(line) for line in commands)
    code, text, complaint = _inside(commands) if plain else _outside(block.content)
    if code != block.exit_code:
        raise PageError(_told(page, block, f"exit code {code} in place of {block.exit_code}\n{complaint}"))
    return complaint if code else text


def _inside(commands: list[str]) -> tuple[int, str, str]:
    code = 0
    with (
        contextlib.redirect_stdout(io.StringIO()) as printed,
        contextlib.redirect_stderr(io.StringIO()) as complained,
    ):
        for command in commands:
            try:
                code = trimmer_command(shlex.split(command)[1:])
            except SystemExit as ended:
                code = int(ended.code or 0)
    return code, printed.getvalue(), complained.getvalue()


def _outside(script: str) -> tuple[int, str, str]:
    function = f'trimmer() {{ {shlex.quote(sys.executable)} -m trimmer "$@"; }}; set -eo pipefail\n'
    variables = os.environ | {"PYTHONPATH": str(PROJECT)}
    ended = subprocess.run(
        ["bash", "-c", function + script], env=variables, capture_output=True, text=True, check=False
    )
    return ended.returncode, ended.stdout, ended.stderr


def _agrees(shown: str, printed: str) -> bool:
    return doctest.OutputChecker().check_output(
        shown, printed, doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    )


def _difference(shown: str, printed: str) -> str:
    example = doctest.Example("", shown)
    return doctest.OutputChecker().output_difference(example, printed, doctest.REPORT_NDIFF)


def _told(page: Path, block: Block, what: str) -> str:
    return f"{page}, line {block.line}:\n{block.content}\n{what}"


def _write_outputs(page: Path) -> None:
    with tempfile.TemporaryDirectory() as name:
        printed = {block.line: text for block, text in _ran(page.resolve(), Path(name), slow=True)}
    content = page.read_text(encoding="utf-8")
    page.write_text(with_outputs(content, printed), encoding="utf-8")


if __name__ == "__main__":
    parser = ArgumentParser(description="Run the blocks of pages, and write what they print into the pages.")
    parser.add_argument("pages", type=Path, nargs="+", metavar="PAGE")
    for page in parser.parse_args().pages:
        _write_outputs(page)
