"""Tests go through the doors that users have: no private name, no way past a room, nothing replaced inside.

``python -m scripts.doors`` prints what does and is not in tests/insides.csv; then it ends with 1.
A listed file has a reason; one that touches nothing any more has to leave the list.
"""

import argparse
import ast
import csv
import sys
from collections.abc import Iterator
from collections.abc import Set as AbstractSet
from pathlib import Path

import trimmer

PROJECT = Path(__file__).resolve().parents[1]
LISTED = "tests/insides.csv"
PACKAGES = frozenset({"derivations", "trimmer", "report", "scripts", "benchmarks"})
OF_NAMED_TUPLES = frozenset({"_replace", "_asdict", "_fields", "_make"})
REPLACING = frozenset({"setattr", "delattr", "patch"})
"""Functions of Python, pytest's monkeypatch and unittest.mock that replace something."""
REPLACING_METHODS = REPLACING | {"object", "dict", "setitem", "delitem"}
"""The same, and what replaces only as a method: ``dict(...)`` by itself makes one."""
ROOMS = {f"trimmer.{room}": frozenset(getattr(trimmer, room).__all__) for room in trimmer.ROOMS} | {
    "trimmer": frozenset(trimmer.__all__)
}
"""The public names of each room, whatever file below it they are written in."""


def main() -> int:
    """Print what is wrong; return the exit code."""
    argparse.ArgumentParser(prog="python -m scripts.doors", description=__doc__).parse_args()
    faults = list(wrong(PROJECT))
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


def wrong(root: Path) -> Iterator[str]:
    """Yield a sentence for each test file that touches insides unlisted, or is listed and does not."""
    with (root / LISTED).open(encoding="utf-8", newline="") as file:
        listed = {row["file"]: row["reason"] for row in csv.DictReader(file)}
    for path in sorted((root / "tests").rglob("*.py")):
        name = path.relative_to(root).as_posix()
        touched = sorted(set(insides(path.read_text("utf-8"))))
        reason = listed.pop(name, None)
        if reason is None:
            yield from (f"{name}:{line}: {what}; ask through a public name" for line, what in touched)
        elif not touched:
            yield f"{LISTED}: {name} touches no insides any more; take it off the list"
        elif not reason.strip():
            yield f"{LISTED}: {name} has no reason"
    yield from (f"{LISTED}: {name} is not there" for name in listed)


def insides(source: str) -> Iterator[tuple[int, str]]:
    """Yield line and words for each private name that a test takes, each thing of ours that it replaces."""
    tree = ast.parse(source)
    ours = set(_imported_names(tree, of_ours=True))
    own = {"self", "cls", *_imported_names(tree, of_ours=False)}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom | ast.Import):
            yield from _imported(node)
            yield from _passed_by(node)
        elif isinstance(node, ast.Attribute) and _is_private(node.attr) and not _is_named(node.value, own):
            yield node.lineno, f"takes the private {node.attr}"
        elif isinstance(node, ast.Call) and _replaces(node, ours):
            yield node.lineno, f"replaces {ast.unparse(node.args[0])} inside the packages"


def _imported(node: ast.ImportFrom | ast.Import) -> Iterator[tuple[int, str]]:
    of_ours = isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in PACKAGES
    modules = [node.module or ""] if isinstance(node, ast.ImportFrom) else [each.name for each in node.names]
    names = [part for module in modules if module.split(".")[0] in PACKAGES for part in module.split(".")]
    names += [each.name for each in node.names] if of_ours else []
    yield from ((node.lineno, f"imports the private {name}") for name in names if _is_private(name))


def _passed_by(node: ast.ImportFrom | ast.Import) -> Iterator[tuple[int, str]]:
    """Yield the public names that are imported from below the room where they stand."""
    module = (node.module or "") if isinstance(node, ast.ImportFrom) else ""
    for room, public in ROOMS.items():
        if module.startswith(f"{room}.") and module not in ROOMS:
            names = [each.name for each in node.names if each.name in public]
            yield from ((node.lineno, f"imports {name} from below {room}") for name in names)


def _imported_names(tree: ast.AST, *, of_ours: bool) -> Iterator[str]:
    """Yield the names by which a test knows what it imports from our packages, or from all others."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and ((node.module or "").split(".")[0] in PACKAGES) == of_ours:
            yield from (each.asname or each.name for each in node.names)
        elif isinstance(node, ast.Import):
            known = [each for each in node.names if (each.name.split(".")[0] in PACKAGES) == of_ours]
            yield from (each.asname or each.name.split(".")[0] for each in known)


def _is_private(name: str) -> bool:
    return name.startswith("_") and not name.startswith("__") and name not in OF_NAMED_TUPLES


def _is_named(node: ast.AST, names: AbstractSet[str]) -> bool:
    return isinstance(node, ast.Name) and node.id in names


def _replaces(node: ast.Call, ours: set[str]) -> bool:
    if isinstance(node.func, ast.Attribute):
        replaces = node.func.attr in REPLACING_METHODS
    else:
        replaces = _is_named(node.func, REPLACING)
    if not replaces or not node.args:
        return False
    first = node.args[0]
    if isinstance(first, ast.Constant):
        return isinstance(first.value, str) and first.value.split(".")[0] in PACKAGES and "." in first.value
    while isinstance(first, ast.Attribute):
        first = first.value
    return _is_named(first, ours)


if __name__ == "__main__":
    sys.exit(main())
