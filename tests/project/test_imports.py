"""What importing may and may not pull in."""

from __future__ import annotations

import ast
import pkgutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import grimp
import pytest

HEAVY = {"control", "matplotlib", "numpy", "scipy", "shtab", "sympy", "tqdm"}


def modules_after(statement: str, folder: Path) -> set[str]:
    """Return the heavy top-level modules that a statement imports in a fresh interpreter."""
    code = f"{statement}\nimport sys\nprint(*sys.modules, file=sys.stderr)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=folder)
    return HEAVY & set(run.stderr.split())


@pytest.mark.parametrize(
    ("statement", "heavy"),
    [
        ("import sympy", {"sympy"}),  # or else nothing would be shown
        ("import report.command", set()),
        (
            "import trimmer; dir(trimmer); trimmer.TrimmerError; trimmer.TrimmerParameters.thesis()\n"
            "trimmer.Mechanism.from_toml('examples/thesis.toml').value('frequency')",
            set(),
        ),
        (
            "from trimmer.command_line.main import main\n"
            "for words in (['--help'], ['linear', '-h'], ['linear', '--parameters', 'no such file']):\n"
            "    try: main(words)\n    except SystemExit: pass",
            set(),
        ),
    ],
)
def test_heavy_libraries_wait_until_they_are_needed(statement: str, heavy: set[str], project_folder) -> None:
    assert modules_after(statement, project_folder) == heavy


def test_import_contracts_hold(project_folder: Path) -> None:
    """The contracts of pyproject.toml, with the tool that `make lint` uses."""
    code = "from importlinter.cli import lint_imports; raise SystemExit(lint_imports(cache_dir=None))"
    ended = subprocess.run([sys.executable, "-c", code], cwd=project_folder, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stdout


def test_the_contracts_see_every_module(project_folder: Path) -> None:
    """A folder without __init__.py hides its modules from import-linter."""
    packages = ("derivations", "trimmer", "report")
    seen = grimp.build_graph(*packages, cache_dir=None).modules
    there = {
        ".".join(path.relative_to(project_folder).with_suffix("").parts).removesuffix(".__init__")
        for package in packages
        for path in (project_folder / package).rglob("*.py")
    }
    assert len(there) > 300
    assert there == seen


FOLDERS = ("benchmarks", "derivations", "report", "scripts", "tests", "trimmer")


def missing_names(source: str) -> Iterator[str]:
    """Yield what a source imports from the project's folders, also within functions, that is not there."""
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.ImportFrom) or (node.module or "").split(".")[0] not in FOLDERS:
            continue
        for name in (f"{node.module}.{each.name}" for each in node.names):
            try:
                pkgutil.resolve_name(name)
            except (AttributeError, ImportError):
                yield name


@pytest.mark.slow  # it imports all modules
def test_all_that_is_imported_is_there(project_folder: Path) -> None:
    """A function's imports run late, and a test or script that nobody ran keeps an old place for long."""
    missing = {
        f"{path.relative_to(project_folder)}: {name}"
        for folder in FOLDERS
        for path in (project_folder / folder).rglob("*.py")
        for name in missing_names(path.read_text("utf-8"))
    }
    assert not missing


def test_what_is_not_there_would_be_noticed() -> None:
    late = "def f():\n    from trimmer.elements import relay, no_such_element"
    assert list(missing_names(late)) == ["trimmer.elements.no_such_element"]
