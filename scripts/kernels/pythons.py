"""Other versions of Python: where they are, and an environment for each with the locked packages."""

import hashlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
LOCK = PROJECT / "requirements-dev.lock"
VERSIONS = ("3.11", "3.12", "3.13")
"""Those that the package is for."""
MADE = "made-from"
"""File of an environment that is complete; it says what it was made from."""


def other_versions() -> list[str]:
    """Return the versions that the package is for, except that of this process."""
    return [each for each in VERSIONS if each != "{}.{}".format(*sys.version_info)]


def interpreter(version: str) -> Path | None:
    """Return an interpreter that can make environments, from PATH or pyenv; None if there is none."""
    question = "import ensurepip, sys, venv; print('{}.{}'.format(*sys.version_info))"
    for path in _candidates(version):
        told = subprocess.run([path, "-I", "-c", question], capture_output=True, text=True, check=False)
        if told.stdout.strip() == version:
            return path
    return None


def _candidates(version: str) -> Iterator[Path]:
    places = [Path(folder) for folder in os.environ.get("PATH", "").split(os.pathsep) if folder]
    pyenv = Path(os.environ.get("PYENV_ROOT") or Path.home() / ".pyenv")
    places += sorted((pyenv / "versions").glob(f"{version}*/bin"), reverse=True)
    yield from (path for place in places if os.access(path := place / f"python{version}", os.X_OK))


def environment(base: Path, version: str, folder: Path) -> Path:
    """Return the interpreter of an environment with the locked packages and this project; make it if need be.

    Args:
        base: Interpreter to make it with.
        version: Its version.
        folder: Where the environments are.

    Raises:
        subprocess.CalledProcessError: if it cannot be made; what pip says is on standard error.
    """
    home = folder / f"python-{version}"
    python = home / "bin" / "python"
    state = f"{base} {hashlib.sha256(LOCK.read_bytes()).hexdigest()} {PROJECT}"
    if (home / MADE).is_file() and (home / MADE).read_text(encoding="utf-8") == state:
        return python
    print(f"installing the locked packages for Python {version}; this takes some minutes, once", flush=True)
    subprocess.run([base, "-m", "venv", "--clear", home], check=True)
    install = [python, "-I", "-m", "pip", "--disable-pip-version-check", "--no-input", "install", "--quiet"]
    locked = ["--require-hashes", "--no-deps", "--only-binary=:all:", "--no-compile", "--requirement", LOCK]
    subprocess.run([*install, *locked], check=True)
    project = ["--no-index", "--no-deps", "--no-build-isolation", "--editable", PROJECT]
    subprocess.run([*install, *project], check=True)
    (home / MADE).write_text(state, encoding="utf-8")
    return python
