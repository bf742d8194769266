"""Which source files a module depends on, read from its import statements without running anything."""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Iterable
from functools import cache
from pathlib import Path

PACKAGES = ("derivations", "trimmer", "report")
ROOT = Path(__file__).parents[2]


def source_closure(module: str) -> tuple[Path, ...]:
    """Return the sources of a module of the three packages and of all that it imports, directly or not.

    Imports inside functions and for type checking count too: they may name too much, never too little.
    """
    seen: set[Path] = set()
    waiting = list(_sources_of(module))
    while waiting:
        path = waiting.pop()
        if path not in seen:
            seen.add(path)
            waiting.extend(_imported(path))
    return tuple(sorted(seen))


def digest(modules: Iterable[str], *others: object) -> str:
    """Return a digest of all the sources that modules depend on, and of other things by their ``repr``."""
    summary = hashlib.sha256(repr(others).encode())
    for path in sorted({path for module in modules for path in source_closure(module)}):
        summary.update(f"{path.relative_to(ROOT).as_posix()}\0".encode())
        summary.update(_content(path))
    return summary.hexdigest()


@cache
def _sources_of(name: str) -> tuple[Path, ...]:
    """Return the file of a module, or of the module that a name is imported from, and its packages' files."""
    parts = name.split(".")
    if parts[0] not in PACKAGES:
        return ()
    stems = (ROOT.joinpath(*parts[:length]) for length in range(1, len(parts) + 1))
    candidates = (path for stem in stems for path in (stem / "__init__.py", stem.with_suffix(".py")))
    return tuple(path for path in candidates if path.is_file())


@cache
def _imported(path: Path) -> frozenset[Path]:
    """Return the sources that a source imports itself."""
    names = []
    for node in ast.walk(ast.parse(_content(path))):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module is not None and node.level == 0:
            # What is imported may be a module itself.
            names += [f"{node.module}.{alias.name}" for alias in node.names]
    return frozenset(source for name in names for source in _sources_of(name))


@cache
def _content(path: Path) -> bytes:
    return path.read_bytes()
