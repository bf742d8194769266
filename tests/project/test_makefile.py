"""What make does before the first package is there: with a real Python, and lock files without packages."""

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

OLD = """#!/bin/sh
test "$1" != -V || echo "Python 3.9.1"
"""
PROJECT = """[build-system]
requires = []
build-backend = "backend"
backend-path = ["."]
"""
BACKEND = """
import zipfile
def build_editable(folder, *_):
    info = "project-1.dist-info"
    with zipfile.ZipFile(f"{folder}/project-1-py3-none-any.whl", "w") as wheel:
        wheel.writestr(f"{info}/METADATA", "Metadata-Version: 2.1\\nName: project\\nVersion: 1\\n")
        wheel.writestr(f"{info}/WHEEL", "Wheel-Version: 1.0\\nRoot-Is-Purelib: true\\nTag: py3-none-any\\n")
        wheel.writestr(f"{info}/RECORD", "")
    return "project-1-py3-none-any.whl"
"""
"""The smallest build backend, so that installing the project takes no package."""
INSTALLING = "installing the packages of "

Make = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture
def folder(tmp_path: Path, project_folder: Path) -> Path:
    """A project with a Makefile and empty lock files, in a folder with a space in its name."""
    if shutil.which("make") is None:
        pytest.skip("make is not installed")
    folder = tmp_path / "a project"
    (folder / "scripts").mkdir(parents=True)
    shutil.copy(project_folder / "scripts" / "environment.py", folder / "scripts")
    rules = (project_folder / "Makefile").read_text("utf-8")
    (folder / "Makefile").write_text(f"{rules}\nagain:\n\t@$(MAKE) .venv/for-use\n", "utf-8")
    for name in ("requirements.lock", "requirements-dev.lock"):
        (folder / name).touch()
    (folder / "pyproject.toml").write_text(PROJECT, "utf-8")
    (folder / "backend.py").write_text(BACKEND, "utf-8")
    (tmp_path / "old").write_text(OLD, "utf-8")
    (tmp_path / "old").chmod(0o755)
    return folder


def started(folder: Path, *words: str, activated: bool = False) -> subprocess.Popen[str]:
    variables = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    if activated:
        variables["VIRTUAL_ENV"] = str(folder / ".venv")
        variables["PATH"] = f"{folder / '.venv' / 'bin'}:{variables['PATH']}"
    return subprocess.Popen(
        ["make", *words],
        cwd=folder,
        env=variables,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )


def ended(process: subprocess.Popen[str]) -> tuple[int, str]:
    _, errors = process.communicate(timeout=300)
    return process.returncode, errors


def base() -> str:
    """A Python that is in no environment."""
    return str(Path(sys.base_prefix) / "bin" / "python3")


def make(folder: Path, target: str = ".venv/for-use", python: str | None = None) -> tuple[int, str]:
    return ended(started(folder, target, f"PYTHON={python or base()}"))


@pytest.mark.slow
def test_packages_are_installed_once(folder: Path) -> None:
    code, told = make(folder)
    assert (code, told.count(INSTALLING)) == (0, 1), told
    mark = folder / ".venv" / "mark"
    mark.touch()  # goes with the environment
    assert make(folder) == (0, "")
    assert make(folder, python=str(Path(base()).resolve())) == (0, "")
    for words in ([".venv/for-use"], ["again"]):
        assert ended(started(folder, *words, activated=True)) == (0, "")
    assert ended(started(folder, "again", f"PYTHON={base()}")) == (0, "")
    code, told = make(folder, ".venv/for-development")
    assert (code, told.count(INSTALLING)) == (0, 1), told
    assert make(folder) == (0, "")
    later = time.time() + 10
    os.utime(folder / "requirements.lock", (later, later))
    code, told = make(folder)
    assert (code, told.count(INSTALLING), mark.exists()) == (0, 1, True), told


@pytest.mark.slow
def test_what_was_interrupted_or_moved_is_begun_anew(folder: Path) -> None:
    process = started(folder, ".venv/for-use", f"PYTHON={base()}")
    while not (folder / ".venv" / "pyvenv.cfg").exists():  # Python's venv is at work
        assert process.poll() is None
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)
    code, told = ended(process)
    assert code != 0
    assert "interrupted; the next make begins the installation anew" in told
    assert make(folder)[0] == 0
    assert make(folder) == (0, "")
    (folder / ".venv" / "unfinished").touch()  # as after an interrupt of pip
    assert INSTALLING in make(folder)[1]
    moved = folder.with_name("elsewhere")
    folder.rename(moved)
    assert INSTALLING in make(moved)[1]
    assert make(moved) == (0, "")
    assert [each.name for each in moved.glob(".venv?*")] == [".venv.lock"]


@pytest.mark.slow
def test_of_two_at_once_one_waits(folder: Path) -> None:
    both = [started(folder, ".venv/for-use", f"PYTHON={base()}") for _ in range(2)]
    told = [ended(process) for process in both]
    assert [code for code, _ in told] == [0, 0], told
    errors = "".join(text for _, text in told)
    assert errors.count(INSTALLING) == 1
    assert errors.count("another make is installing packages here; waiting for it") == 1
    assert make(folder) == (0, "")


@pytest.mark.parametrize(
    ("python", "words"),
    [
        ("../old", "needs Python 3.11 or newer, but '../old' is Python 3.9.1; run make PYTHON="),
        ("../none", "'../none' is not there; install Python 3.11 or newer"),
    ],
)
def test_python_that_will_not_do_is_named_in_a_sentence(folder: Path, python: str, words: str) -> None:
    code, told = make(folder, python=python)
    assert code != 0
    said = [line for line in told.splitlines() if not line.startswith("make")]
    assert len(said) == 1 and words in said[0]


def test_environment_of_somebody_else_is_named_and_kept(folder: Path) -> None:
    (folder / ".venv").mkdir()
    (folder / ".venv" / "theirs").touch()
    code, told = make(folder)
    assert code != 0
    assert "was not made by make; move it away" in told
    assert (folder / ".venv" / "theirs").exists()
