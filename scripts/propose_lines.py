"""Propose places in a text copy of the thesis for the claims on what carries a number.

``propose_lines.py COPY`` prints id, first and last line, and paragraph of each such claim;
``propose_lines.py COPY --paragraphs`` the section, number, lines and beginning of each paragraph;
``propose_lines.py COPY --missing`` the ids of the claims that give no lines, one a line.
"""

import argparse
import csv
import sys
from collections.abc import Iterator
from pathlib import Path

from report.copy.places import Places
from report.copy.reading import split
from report.data.statements import read_inventory

UNNUMBERED = {
    **{f"eq-A.1.{index}": ("A.1", index) for index in range(1, 5)},
    **{"eq-D.1": ("D", 2), "eq-D.2": ("D", 4), "eq-D.3": ("D", 4), "eq-D.4": ("D", 4)},
    **{"eq-D.5": ("D", 5), "eq-D.6": ("D", 6)},
}
"""Equations without a number in the thesis: section, and which of its displayed formulas it is."""


def main() -> int:
    """Print the table that is asked for; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("copy", type=Path)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--paragraphs", action="store_true")
    what.add_argument("--missing", action="store_true")
    arguments = parser.parse_args()
    places = Places(split(arguments.copy.read_text(encoding="utf-8")))
    if arguments.missing:
        rows = _missing()
    else:
        rows = _paragraphs(places) if arguments.paragraphs else _claims(places)
    csv.writer(sys.stdout, lineterminator="\n").writerows(rows)
    return 0


def _claims(places: Places) -> Iterator[tuple[object, ...]]:
    yield "id", "first", "last", "paragraph"
    for claim, statement in read_inventory().items():
        if claim in places.numbered:
            first, last = places.numbered[claim]
        elif claim in UNNUMBERED:
            section, index = UNNUMBERED[claim]
            first, last = places.unnumbered_formulas(section)[index - 1]
        else:
            if statement.kind.value != "statement":
                print(f"{claim}: not found", file=sys.stderr)
            continue
        paragraph = places.paragraph_at(first)
        yield claim, first, last, paragraph.number if paragraph else ""


def _paragraphs(places: Places) -> Iterator[tuple[object, ...]]:
    yield "section", "paragraph", "first", "last", "begins"
    for paragraph in places.paragraphs:
        yield paragraph.section, paragraph.number, paragraph.first, paragraph.last, paragraph.begins


def _missing() -> Iterator[tuple[object, ...]]:
    yield from ((claim,) for claim, entry in read_inventory().items() if entry.lines is None)


if __name__ == "__main__":
    sys.exit(main())
