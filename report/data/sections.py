"""The sections of the thesis and the figures in each; the inventory gives figures by chapter only."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

PATH = Path(__file__).parent / "sections.csv"


@dataclass(frozen=True)
class Section:
    """A section of the thesis: number, title, and the ids of the figures in it."""

    number: str
    title: str
    figures: tuple[str, ...] = ()


def read_sections(path: Path = PATH) -> tuple[Section, ...]:
    """Read the sections in thesis order; a figure stands with the section that discusses it."""
    with path.open(encoding="utf-8", newline="") as file:
        return tuple(
            Section(row["number"], row["title"], tuple(row["figures"].split()))
            for row in csv.DictReader(file)
        )
