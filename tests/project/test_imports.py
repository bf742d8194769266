"""What importing may and may not pull in."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
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


FOLDERS = ("benchmarks", "derivations", "report", "scripts", "tests", "trimmer")


@dataclass(frozen=True)
class Names:
    """What the statements of a source bind at any depth, and what it imports from the project's folders."""

    bound: set[str]
    imported: list[tuple[str, str]]

    @classmethod
    def of(cls, source: str) -> Names:
        """Read a source, types that only a checker sees among it."""
        names = cls({"__doc__"}, [])
        for node in statements(ast.parse(source)):
            match node:
                case ast.Assign() | ast.AnnAssign():
                    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                    inside = [each for target in targets for each in ast.walk(target)]
                    names.bound.update(each.id for each in inside if isinstance(each, ast.Name))
                case ast.ClassDef(name=name) | ast.FunctionDef(name=name):
                    names.bound.add(name)
                case ast.Import(names=aliases) | ast.ImportFrom(names=aliases):
                    names.bound.update(alias.asname or alias.name for alias in aliases)
            if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in FOLDERS:
                names.imported.extend((node.module or "", alias.name) for alias in node.names)
        return names


def statements(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield the statements of a source at any depth; the expressions in them are most of it."""
    todo: list[ast.AST] = [tree]
    while todo:
        yield (node := todo.pop())
        for part in ("body", "orelse", "finalbody", "handlers", "cases"):
            todo += getattr(node, part, ())


@cache
def names_in(path: Path) -> Names:
    """Return the names of a file, which is read once."""
    return Names.of(path.read_text("utf-8"))


def missing_names(folder: Path, names: Names) -> Iterator[str]:
    """Yield what a source imports from the project's folders, also within functions, that is not there."""
    for module, name in names.imported:
        place = folder.joinpath(*module.split("."))
        paths = place / "__init__.pyi", place / "__init__.py", place.with_suffix(".py")
        there = next(filter(Path.exists, paths), None)
        beside = place.joinpath(name)
        if (
            (there is None or name not in names_in(there).bound)
            and not beside.is_dir()
            and not beside.with_suffix(".py").exists()
        ):
            yield f"{module}.{name}"


@pytest.mark.slow  # it reads all sources; of the packages mypy says the same
def test_all_that_is_imported_is_there(project_folder: Path) -> None:
    """A function's imports run late, and a test or script that nobody ran keeps an old place for long."""
    missing = {
        f"{path.relative_to(project_folder)}: {name}"
        for folder in FOLDERS
        for path in (project_folder / folder).rglob("*.py")
        for name in missing_names(project_folder, names_in(path))
    }
    assert not missing


def test_what_is_not_there_would_be_noticed(project_folder: Path) -> None:
    late = "def f():\n    from trimmer.elements import relay, no_such_element"
    assert list(missing_names(project_folder, Names.of(late))) == ["trimmer.elements.no_such_element"]
