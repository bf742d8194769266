"""The list of every statement of the thesis that is to be judged: ids, kinds, sections and subjects."""

from __future__ import annotations

import csv
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from report.claim import Kind, Statement
from trimmer.errors import TrimmerError

PATH = Path(__file__).parent / "data" / "inventory.csv"
"""The statements that were handed over with the thesis."""
FURTHER = PATH.with_name("further_statements.csv")
"""Statements that the inventory lacks, found by reading the thesis again; same columns."""


TITLES = PATH.with_name("titles.csv")
"""Titles with mathematics between dollar signs, of statements whose subjects write it in plain letters."""


class InventoryError(TrimmerError, ValueError):
    """The inventory holds an id twice, or a kind that is not known."""


def read_inventory(*paths: Path) -> Mapping[str, Statement]:
    """Read the statements, by id, in their own order: those handed over, then the further ones, with titles.

    Args:
        paths: Files to read instead of these two.

    Raises:
        InventoryError: naming file, line and value, if an id stands twice or a kind is unknown, or if a title
            belongs to no statement.
    """
    entries: dict[str, Statement] = {}
    for path in paths or (PATH, FURTHER):
        for line, entry in _entries(path):
            if entry.id in entries:
                raise InventoryError(f"{path.name}, line {line}: the id {entry.id} stands there twice")
            entries[entry.id] = entry
    return entries if paths else {**entries, **_titled(entries)}


def _titled(entries: Mapping[str, Statement]) -> dict[str, Statement]:
    with TITLES.open(encoding="utf-8", newline="") as file:
        titles = {row["id"]: row["title"] for row in csv.DictReader(file)}
    if unknown := ", ".join(titles.keys() - entries.keys()):
        raise InventoryError(f"{TITLES.name}: no statement has the id {unknown}")
    return {claim_id: replace(entries[claim_id], title=title) for claim_id, title in titles.items()}


def _entries(path: Path) -> Iterator[tuple[int, Statement]]:
    with path.open(encoding="utf-8", newline="") as file:
        for line, row in enumerate(csv.DictReader(file), start=2):
            if None in row or None in row.values():
                raise InventoryError(f"{path.name}, line {line}: not four columns; quote a comma")
            if row["kind"] not in {kind.value for kind in Kind}:
                raise InventoryError(f"{path.name}, line {line}: unknown kind {row['kind']!r}")
            yield line, Statement(row["id"], Kind(row["kind"]), row["section"], row["subject"])
