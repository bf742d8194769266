"""What importing may and may not pull in."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import grimp
import pytest

HEAVY = {"control", "matplotlib", "scipy", "sympy"}


def modules_after(statement: str) -> set[str]:
    """Return the heavy top-level modules that a statement imports in a fresh interpreter."""
    code = f"import sys\n{statement}\nprint(*sys.modules)"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return HEAVY & set(ended.stdout.split())


@pytest.mark.parametrize(
    "statement", ["import trimmer", "import trimmer.command_line.main", "import report.command"]
)
def test_import_is_light(statement: str) -> None:
    assert modules_after(statement) == set()


def test_heavy_modules_would_be_noticed() -> None:
    assert modules_after("import sympy") == {"sympy"}


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
