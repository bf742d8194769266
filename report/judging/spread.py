"""Which statement follows from which, where a slip spreads from one to the next.

The edges are facts of what is judged, so they are data. Whether a slip has reached a statement is the finding
on it.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from report.judging.claim import Statement
from trimmer.errors import TrimmerError


@dataclass(frozen=True)
class Follows:
    """A claim (its id) that follows from another in the thesis, and how, in a few words of plain text."""

    claim: str
    source: str
    how: str


class SpreadError(TrimmerError, ValueError):
    """An edge names an unknown statement, or statements follow from each other in a circle."""


def read_edges(inventory: Mapping[str, Statement], path: Path) -> tuple[Follows, ...]:
    """Read the edges, in the order of the file.

    Raises:
        SpreadError: naming what is unknown, or the circle.
    """
    with path.open(encoding="utf-8", newline="") as file:
        edges = tuple(Follows(row["id"], row["follows_from"], row["how"]) for row in csv.DictReader(file))
    named = {claim for edge in edges for claim in (edge.claim, edge.source)}
    if unknown := sorted(named - set(inventory)):
        raise SpreadError(f"{path.name}: {', '.join(unknown)} is not in the inventory")
    in_order(edges, path.name)
    return edges


def in_order(edges: Iterable[Follows], name: str = "the edges") -> tuple[str, ...]:
    """Return the ids of all statements, each after those that it follows from; ``name`` is for the error.

    Raises:
        SpreadError: if they follow from each other in a circle.
    """
    sources: dict[str, list[str]] = {}
    for edge in edges:
        sources.setdefault(edge.claim, []).append(edge.source)
    try:
        return tuple(TopologicalSorter(sources).static_order())
    except CycleError as error:
        raise SpreadError(f"{name}: statements follow from each other: {error.args[1]}") from error
