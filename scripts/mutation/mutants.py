"""The places of a source file that can be changed, and the changed text."""

import ast
import hashlib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate, islice
from pathlib import Path
from random import Random

from scripts.mutation.exclusions import is_left_out, live_nodes
from scripts.mutation.operators import Kind, changes

PACKAGES = ("derivations", "trimmer", "report")
HEADED = (ast.If, ast.While, ast.For, ast.With, ast.FunctionDef, ast.ClassDef, ast.Try, ast.Match)


@dataclass(frozen=True)
class Mutant:
    """One change of one place."""

    path: str  # Of the source from the project's folder, with slashes
    function: str  # Qualified name of the function or class that the place is in, empty at a module's level
    kind: Kind  # What is changed
    before: str  # The source of the place
    after: str  # What stands there instead
    line: int  # First line of the place, from 1
    context: str  # That line
    lines: tuple[int, int]  # First and last line of the statement, or of its head
    span: tuple[int, int]  # First and last character of the place in the source, as UTF-8
    source: str  # Digest of the source

    @cached_property
    def key(self) -> str:
        """Names the mutant for as long as its source stays as it is."""
        parts = (self.path, self.source, *map(str, self.span), self.after)
        return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:12]

    def text(self, source: bytes) -> bytes:
        """Return the changed source."""
        return source[: self.span[0]] + self.after.encode() + source[self.span[1] :]

    def __str__(self) -> str:
        return f"{self.path}:{self.line} {self.function}: {self.before} -> {self.after}"


def sources(root: Path, only: str = "") -> list[Path]:
    """Return the sources that may be changed, in order; only those of a folder or file if one is given."""
    found = (path for package in PACKAGES for path in (root / package).rglob("*.py"))
    names = ((path.relative_to(root).as_posix(), path) for path in found)
    return [path for name, path in sorted(names) if name.startswith(only) and not is_left_out(name)]


def drawn(root: Path, seed: int, count: int, only: str = "") -> list[Mutant]:
    """Return mutants at random places, each place with the same chance, and one of its changes.

    A larger count continues the list. No two mutants are of one place.
    """
    places = [place for path in sources(root, only) for place in places_of(root, path)]
    chance = Random(seed)
    chance.shuffle(places)
    found = (choices for choices in (mutants_of(place) for place in places) if choices)
    return [chance.choice(choices) for choices in islice(found, count)]


@dataclass(frozen=True, eq=False)
class Source:
    """A source file: its path from the project's folder, and its content, UTF-8."""

    path: str
    content: bytes

    @cached_property
    def digest(self) -> str:
        """Changes with the content."""
        return hashlib.sha256(self.content).hexdigest()

    @cached_property
    def starts(self) -> list[int]:
        """The place of the first character of each line, and the end."""
        return [0, *accumulate(map(len, self.content.splitlines(keepends=True)))]


@dataclass(frozen=True, eq=False)
class Place:
    """A node of a source that can be changed, with the nodes that it stands in."""

    source: Source
    node: ast.AST
    outer: tuple[ast.AST, ...]


def places_of(root: Path, path: Path) -> list[Place]:
    """Return the places of a source that can be changed, from top to bottom."""
    source = Source(path.relative_to(root).as_posix(), path.read_bytes())
    nodes = live_nodes(ast.parse(source.content))
    return [Place(source, node, outer) for node, outer in nodes if next(changes(node, outer), None)]


def mutants_of(place: Place) -> list[Mutant]:
    """Return the changes of a place that compile."""
    return [mutant for mutant in _mutants(place) if _compiles(mutant.text(place.source.content))]


def _mutants(place: Place) -> Iterator[Mutant]:
    source, node = place.source, place.node
    span = (
        source.starts[node.lineno - 1] + node.col_offset,
        source.starts[node.end_lineno - 1] + node.end_col_offset,
    )
    for kind, changed in changes(node, place.outer):
        yield Mutant(
            path=source.path,
            function=".".join(
                each.name for each in place.outer if isinstance(each, ast.FunctionDef | ast.ClassDef)
            ),
            kind=kind,
            before=source.content[slice(*span)].decode(),
            after=_text(changed),
            line=node.lineno,
            context=source.content.splitlines()[node.lineno - 1].decode().strip(),
            lines=_lines(node, place.outer),
            span=span,
            source=source.digest,
        )


def _text(node: ast.AST) -> str:
    text = ast.unparse(ast.fix_missing_locations(node))
    return (
        f"({text})" if isinstance(node, ast.expr) and not isinstance(node, ast.Name | ast.Attribute) else text
    )


def _lines(node: ast.AST, outer: tuple[ast.AST, ...]) -> tuple[int, int]:
    """Return the lines of the innermost statement; of one with a body only those of the node."""
    statement = next((each for each in reversed((*outer, node)) if isinstance(each, ast.stmt)), node)
    shown = node if isinstance(statement, HEADED) else statement
    return shown.lineno, shown.end_lineno or shown.lineno


def _compiles(source: bytes) -> bool:
    try:
        compile(source, "mutant", "exec")
    except (SyntaxError, ValueError):
        return False
    return True
