"""The places of all claims, looked up in the text that was judged; it is named by TRIMMER_THESIS.

The repository holds no sentence of it, so that these tests are skipped where nobody has it.
"""

import os
from pathlib import Path

import pytest

from report.copy.places import Places
from report.copy.reading import read_reader_copy
from report.data.statements import read_sections
from report.data.text_copy import read_text_copy
from report.judging.claim import Kind, Statement
from tests.report.copy.made_up import LINES, line_of
from tests.report.copy.resolving import faults

NAME = "TRIMMER_THESIS"
MADE_UP = Places(LINES)
WITHOUT_NUMBER = {*(f"eq-A.1.{index}" for index in range(1, 5)), *(f"eq-D.{index}" for index in range(1, 7))}
"""Equations that the inventory numbers, and the thesis does not."""


@pytest.fixture(scope="module")
def copy():
    if NAME not in os.environ:
        pytest.skip(f"{NAME} names no text copy of the thesis")
    return read_reader_copy(Path(os.environ[NAME]), read_text_copy().sha256)


@pytest.fixture(scope="module")
def places(copy):
    return Places(copy.lines)


def test_the_copy_is_what_the_certificate_says(copy):
    known, text = read_text_copy(), "\n".join(copy.lines)
    assert len(copy.lines) == known.lines
    assert known.title in copy.lines[:5]
    assert known.kind.upper() in copy.lines[0]
    assert known.institution in text


def test_what_the_certificate_misses_is_not_there(copy, places):
    text = "\n".join(copy.lines).lower()
    assert not [word for word in ("university", "supervis", "written by", "bibliography") if word in text]
    assert "C" not in places.sections
    assert "Appendix C" in "\n".join(copy.lines)


def test_every_numbered_thing_of_the_inventory_is_found(places, inventory):
    numbered = {claim for claim, statement in inventory.items() if statement.kind is not Kind.STATEMENT}
    assert numbered - places.numbered.keys() == WITHOUT_NUMBER
    assert {statement.section for statement in inventory.values()} <= places.sections.keys()


def test_every_claim_stands_where_it_says(places, inventory):
    drawn = {figure: section.number for section in read_sections() for figure in section.figures}
    found = [
        fault
        for claim, entry in inventory.items()
        if entry.lines is not None
        for fault in faults(entry, entry.lines, entry.paragraph, places, drawn.get(claim, ""))
    ]
    assert not found, "\n".join(found)


EQUATION, NEXT = line_of("(1.1)"), line_of("z = 4x")


@pytest.mark.parametrize(
    ("id", "kind", "lines", "paragraph", "fault"),
    [
        ("eq-1.1", Kind.EQUATION, (EQUATION, EQUATION), None, ""),
        ("eq-1.1", Kind.EQUATION, (EQUATION, EQUATION), 1, ""),
        ("eq-1.1", Kind.EQUATION, (EQUATION, EQUATION), 2, "not in paragraph 2"),
        ("eq-1.1", Kind.EQUATION, (NEXT, NEXT), None, "do not hold its number"),
        ("eq-1.2", Kind.EQUATION, (line_of("y &="), line_of("1.2}")), None, ""),
        ("eq-1.9", Kind.EQUATION, (NEXT, NEXT), None, ""),
        ("eq-1.9", Kind.EQUATION, (line_of("to and fro"), line_of("to and fro")), None, "its number"),
        ("fig-1.2", Kind.FIGURE, (line_of("Figure 1.2"), line_of("Figure 1.2")), None, ""),
        ("fig-1", Kind.FIGURE, (line_of("Figure 1.2"), line_of("Figure 1.2")), None, "its number"),
        ("tab-1.1", Kind.TABLE, (line_of("4\t4.0"), line_of("4\t4.0")), None, "its number"),
        ("lst-A.1", Kind.LISTING, (line_of("Listing A.1"), len(LINES)), None, ""),
        ("txt-1.1-swing", Kind.STATEMENT, (line_of("to and fro"), line_of("to and fro")), 1, ""),
        ("txt-1.1-swing", Kind.STATEMENT, (line_of("They swing"),) * 2, None, "section 1.1"),
        ("txt-1.1-swing", Kind.STATEMENT, (NEXT + 1, NEXT + 1), None, "nothing stands"),
        ("txt-1.1-swing", Kind.STATEMENT, (0, 3), None, "has no lines 0 to 3"),
        ("txt-1.1-swing", Kind.STATEMENT, (NEXT, NEXT - 1), None, "has no lines"),
        ("txt-1.1-swing", Kind.STATEMENT, (NEXT, len(LINES) + 1), None, "has no lines"),
    ],
)
def test_a_wrong_place_is_told(id, kind, lines, paragraph, fault):
    found = list(faults(Statement(id, kind, "1.1", ""), lines, paragraph, MADE_UP))
    assert len(found) == bool(fault)
    assert fault in "".join(found)
