"""What make does before the first package is there, with a Python that only notes how it is called."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

FAKE = """#!/bin/sh
echo "$*" >>calls
case "$*" in
  *sys.version_info*) echo "$0 3.11" ;;
  "-m venv --clear .venv") rm -rf .venv; mkdir -p .venv/bin; cp "$0" .venv/bin/python ;;
esac
"""
OLD = """#!/bin/sh
test "$1" != -V || echo "Python 3.9.1"
"""

Make = Callable[..., subprocess.CompletedProcess[str]]


@pytest.fixture
def folder(tmp_path: Path, project_folder: Path) -> Path:
    """A project with a Makefile and empty lock files, in a folder with a space in its name."""
    if shutil.which("make") is None:
        pytest.skip("make is not installed")
    folder = tmp_path / "a project"
    folder.mkdir()
    shutil.copy(project_folder / "Makefile", folder)
    for name in ("requirements.lock", "requirements-dev.lock", "pyproject.toml"):
        (folder / name).touch()
    for name, text in (("python", FAKE), ("old", OLD)):
        (tmp_path / name).write_text(text, encoding="utf-8")
        (tmp_path / name).chmod(0o755)
    return folder


@pytest.fixture
def make(folder: Path) -> Make:
    def run(target: str = ".venv/for-use", python: str = "../python") -> subprocess.CompletedProcess[str]:
        (folder / "calls").unlink(missing_ok=True)
        variables = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
        command = ["make", target, f"PYTHON={python}"]
        return subprocess.run(command, cwd=folder, env=variables, capture_output=True, text=True)

    return run


def installs(folder: Path) -> list[str]:
    """Return how pip was called, and whether the environment was made."""
    calls = (folder / "calls").read_text(encoding="utf-8").splitlines()
    return [call.split()[-1] for call in calls if " install " in call or " venv " in call]


def test_second_run_installs_nothing(make: Make, folder: Path) -> None:
    assert make().returncode == 0
    assert installs(folder) == [".venv", "requirements.lock", "."]
    assert make().returncode == 0
    assert installs(folder) == []


def test_development_packages_hold_those_for_use(make: Make, folder: Path) -> None:
    make(".venv/for-development")
    make()
    assert installs(folder) == []


def test_changed_lock_is_installed(make: Make, folder: Path) -> None:
    make()
    later = (folder / ".venv" / "for-use").stat().st_mtime + 10
    os.utime(folder / "requirements.lock", (later, later))
    make()
    assert installs(folder) == ["requirements.lock", "."]


def test_interrupted_installation_starts_again(make: Make, folder: Path) -> None:
    make()
    (folder / ".venv" / "unfinished").touch()
    make()
    assert installs(folder) == [".venv", "requirements.lock", "."]


def test_moved_project_makes_the_environment_again(make: Make, folder: Path) -> None:
    make()
    moved = folder.with_name("elsewhere")
    folder.rename(moved)
    folder.symlink_to(moved)
    make()
    assert installs(moved)[0] == ".venv"


@pytest.mark.parametrize(
    ("python", "words"),
    [
        ("../old", "needs Python 3.11 or newer, but '../old' is Python 3.9.1; run make PYTHON="),
        ("../none", "'../none' is not there; install Python 3.11 or newer"),
    ],
)
def test_python_that_will_not_do_is_named_in_a_sentence(make: Make, python: str, words: str) -> None:
    ended = make(python=python)
    assert ended.returncode != 0
    said = [line for line in ended.stderr.splitlines() if not line.startswith("make")]
    assert len(said) == 1 and words in said[0]


def test_environment_of_somebody_else_is_named_and_kept(make: Make, folder: Path) -> None:
    (folder / ".venv").mkdir()
    (folder / ".venv" / "theirs").touch()
    ended = make()
    assert "was not made by make; move it away" in ended.stderr
    assert (folder / ".venv" / "theirs").exists()
