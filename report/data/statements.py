"""The statements of the thesis that are judged, their titles and sections, and which follows from which."""

import csv
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from report.judging.claim import Statement
from report.judging.inventory import filed, read_statements
from report.judging.spread import Follows, read_edges

PATH = Path(__file__).parent / "inventory.csv"  # The statements that were handed over with the thesis
FURTHER = PATH.with_name("further_statements.csv")
"""Statements that the inventory lacks, found by reading the thesis again; same columns."""
CLAIMS = PATH.with_name("claims.csv")
"""What derives each statement, where it stands in the text that was read, how much it matters, and what the
report calls it where its subject has abbreviations or ASCII mathematics."""
FOLLOWS_FROM = PATH.with_name("follows_from.csv")
"""Which statement follows from which, where a slip spreads from one to the next."""
SECTIONS = PATH.with_name("sections.csv")
"""The sections and the figures in each; the inventory gives figures by chapter only."""


def read_inventory() -> Mapping[str, Statement]:
    """Read the statements, by id, in their own order: those handed over, then the further ones.

    Raises:
        InventoryError: naming file, line and value, if a file says what cannot be used.
    """
    return filed(read_statements(PATH, FURTHER), CLAIMS)


def read_follows(inventory: Mapping[str, Statement]) -> tuple[Follows, ...]:
    """Read which statement follows from which, in the order of the file.

    Raises:
        SpreadError: naming what is unknown, or the circle.
    """
    return read_edges(inventory, FOLLOWS_FROM)


@dataclass(frozen=True)
class ThesisSection:
    """A section of the thesis: number, title, and the ids of the figures in it."""

    number: str
    title: str
    figures: tuple[str, ...] = ()


def read_sections() -> tuple[ThesisSection, ...]:
    """Read the sections in thesis order; a figure stands with the section that discusses it."""
    with SECTIONS.open(encoding="utf-8", newline="") as file:
        return tuple(
            ThesisSection(row["number"], row["title"], tuple(row["figures"].split()))
            for row in csv.DictReader(file)
        )
