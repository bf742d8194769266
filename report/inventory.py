"""The list of every statement of the thesis that is to be judged: ids, kinds, sections and subjects."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from pathlib import Path

from report.claim import Entry, Kind

PATH = Path(__file__).parent / "data" / "inventory.csv"


class InventoryError(ValueError):
    """The inventory holds an id twice, or a kind that is not known."""


def read_inventory(path: Path = PATH) -> Mapping[str, Entry]:
    """Read the inventory, by id, in its own order.

    Raises:
        InventoryError: naming file, line and value, if an id stands twice or a kind is unknown.
    """
    entries: dict[str, Entry] = {}
    with path.open(encoding="utf-8", newline="") as file:
        for line, row in enumerate(csv.DictReader(file), start=2):
            if row["id"] in entries:
                raise InventoryError(f"{path.name}, line {line}: the id {row['id']} stands there twice")
            if row["kind"] not in {kind.value for kind in Kind}:
                raise InventoryError(f"{path.name}, line {line}: unknown kind {row['kind']!r}")
            entries[row["id"]] = Entry(row["id"], Kind(row["kind"]), row["section"], row["subject"])
    return entries
