"""The sections of the thesis and the figures in each; the inventory gives figures by chapter only."""

from __future__ import annotations

import csv
from pathlib import Path

from report.document.thesis import Section

PATH = Path(__file__).parent / "data" / "sections.csv"


def read_sections(path: Path = PATH) -> tuple[Section, ...]:
    """Read the sections in thesis order; a figure stands with the section that discusses it."""
    with path.open(encoding="utf-8", newline="") as file:
        return tuple(
            Section(row["number"], row["title"], tuple(row["figures"].split()))
            for row in csv.DictReader(file)
        )
