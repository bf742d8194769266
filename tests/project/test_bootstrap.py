"""Making .venv: what is said when it cannot be made, and when it is made again."""

from __future__ import annotations

import ast
import importlib.util
import os
import shutil
import subprocess
import sys
from pathlib import Path

import environment as environment_module
import installer
import pytest
from environment import Environment, base_python, make_environment, update
from installer import InstallError, run_pip


class Steps(list[str]):
    """The steps that `update` took, recorded instead of done."""


@pytest.fixture
def steps(monkeypatch: pytest.MonkeyPatch) -> Steps:
    taken = Steps()

    def make(environment: Environment) -> None:
        taken.append("make")
        environment.programs.mkdir(parents=True, exist_ok=True)
        environment.python.touch()

    monkeypatch.setattr(environment_module, "make_environment", make)
    monkeypatch.setattr(environment_module, "install_packages", lambda _, lock: taken.append(lock))
    monkeypatch.setattr(environment_module, "install_project", lambda _: taken.append("project"))
    return taken


@pytest.fixture
def environment(tmp_path: Path) -> Environment:
    for name in ("requirements.lock", "requirements-dev.lock", "pyproject.toml"):
        (tmp_path / name).write_text(name, encoding="utf-8")
    return Environment(tmp_path)


def take(steps: Steps) -> list[str]:
    taken = list(steps)
    steps.clear()
    return taken


def test_second_run_does_nothing(environment: Environment, steps: Steps) -> None:
    update(environment, "requirements.lock")
    assert take(steps) == ["make", "requirements.lock", "project"]
    update(environment, "requirements.lock")
    assert take(steps) == []


def test_changed_lock_makes_the_environment_again(environment: Environment, steps: Steps) -> None:
    update(environment, "requirements.lock")
    take(steps)
    (environment.project / "requirements.lock").write_text("other", encoding="utf-8")
    update(environment, "requirements.lock")
    assert take(steps) == ["make", "requirements.lock", "project"]


def test_changed_pyproject_installs_only_the_project(environment: Environment, steps: Steps) -> None:
    update(environment, "requirements.lock")
    take(steps)
    (environment.project / "pyproject.toml").write_text("other", encoding="utf-8")
    update(environment, "requirements.lock")
    assert take(steps) == ["project"]


def test_development_packages_are_added(environment: Environment, steps: Steps) -> None:
    update(environment, "requirements.lock")
    take(steps)
    update(environment, "requirements-dev.lock")
    assert take(steps) == ["requirements-dev.lock", "project"]
    update(environment, "requirements.lock")
    assert take(steps) == []


def test_interrupted_installation_starts_again(
    environment: Environment, steps: Steps, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupt(environment: Environment, lock: str) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(environment_module, "install_packages", interrupt)
        with pytest.raises(KeyboardInterrupt):
            update(environment, "requirements.lock")
    take(steps)
    update(environment, "requirements.lock")
    assert take(steps) == ["make", "requirements.lock", "project"]


def test_interrupted_addition_starts_again(
    environment: Environment, steps: Steps, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Adding the development packages may leave the others half replaced."""
    update(environment, "requirements.lock")

    def interrupt(environment: Environment, lock: str) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(environment_module, "install_packages", interrupt)
        with pytest.raises(KeyboardInterrupt):
            update(environment, "requirements-dev.lock")
    take(steps)
    update(environment, "requirements.lock")
    assert take(steps) == ["make", "requirements.lock", "project"]


def test_moved_project_makes_the_environment_again(
    environment: Environment, steps: Steps, tmp_path_factory: pytest.TempPathFactory
) -> None:
    update(environment, "requirements.lock")
    take(steps)
    moved = Environment(tmp_path_factory.mktemp("moved") / "project with space")
    shutil.copytree(environment.project, moved.project)
    update(moved, "requirements.lock")
    assert take(steps) == ["make", "requirements.lock", "project"]


def test_environment_made_here_is_replaced(environment: Environment) -> None:
    environment.folder.mkdir()
    environment.marker.touch()
    (environment.folder / "half").touch()
    # ensurepip costs seconds and does not matter here.
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(environment_module, "subprocess", FakeSubprocess())
        make_environment(environment)
    assert [path.name for path in environment.folder.iterdir()] == [environment.marker.name]


class FakeSubprocess:
    """Stands for the module: running anything succeeds and does nothing."""

    def run(self, command: list[str], **_: object) -> subprocess.CompletedProcess[str]:
        return subprocess.CompletedProcess(command, 0, "", "")


def test_environment_of_somebody_else_is_kept(environment: Environment) -> None:
    environment.programs.mkdir(parents=True)
    environment.python.touch()
    (environment.folder / "theirs").touch()
    make_environment(environment)
    assert (environment.folder / "theirs").exists()


def test_broken_environment_of_somebody_else_is_named_and_kept(environment: Environment) -> None:
    environment.folder.mkdir()
    (environment.folder / "theirs").touch()
    with pytest.raises(InstallError, match="was not made by make; remove it"):
        make_environment(environment)
    assert (environment.folder / "theirs").exists()


def test_python_without_ensurepip_is_told_the_package(monkeypatch: pytest.MonkeyPatch) -> None:
    find_spec = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name == "ensurepip" else find_spec(name)
    )
    with pytest.raises(InstallError) as caught:
        base_python()
    version = "{}.{}".format(*sys.version_info[:2])
    assert str(caught.value).endswith(f"apt install python{version}-venv")
    assert "\n" not in str(caught.value)


def test_unreachable_index_is_told_from_a_missing_package(monkeypatch: pytest.MonkeyPatch) -> None:
    """The real pip, with an index on a port where nobody listens."""
    for name in [name for name in os.environ if name.startswith("PIP_")]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("PIP_CONFIG_FILE", os.devnull)
    monkeypatch.setenv("PIP_INDEX_URL", "http://127.0.0.1:9/simple")
    # pip 23 lets one retry pass before it says why.
    monkeypatch.setenv("PIP_RETRIES", "1")
    with pytest.raises(InstallError) as caught:
        run_pip(Path(sys.executable), ["install", "--dry-run", "no-such-package"])
    first = str(caught.value).splitlines()[0]
    assert "index cannot be reached" in first


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("ERROR: No matching distribution found for numpy==9", "no wheel"),
        ("ERROR: THESE PACKAGES DO NOT MATCH THE HASHES FROM THE REQUIREMENTS FILE.", "not the one"),
        ("ERROR: [Errno 28] No space left on device", "disk is full"),
        ("python: No module named pip", "no pip"),
        ("something new", "pip failed"),
    ],
)
def test_reason_for_what_pip_says(line: str, words: str) -> None:
    assert words in installer.reason([line])


def test_too_old_python_is_told(project_folder: Path) -> None:
    code = (
        "import runpy, sys; sys.version_info = (3, 9, 1, 'final', 0);"
        f"runpy.run_path({str(project_folder / 'scripts/bootstrap.py')!r}, run_name='__main__')"
    )
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert ended.returncode == 1
    assert "needs Python 3.11 or newer" in ended.stderr
    assert "is Python 3.9; run make PYTHON=" in ended.stderr
    assert ended.stderr.count("\n") == 1


def test_bootstrap_has_no_syntax_that_an_old_python_lacks(project_folder: Path) -> None:
    tree = ast.parse((project_folder / "scripts/bootstrap.py").read_text(encoding="utf-8"))
    new = (ast.JoinedStr, ast.AnnAssign, ast.NamedExpr, ast.AsyncFunctionDef, ast.Starred, ast.Nonlocal)
    assert [node for node in ast.walk(tree) if isinstance(node, new)] == []
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    assert all(function.returns is None for function in functions)
