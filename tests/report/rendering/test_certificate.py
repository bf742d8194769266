"""The page on what was read counts and names what the data say."""

import dataclasses

import pytest

from report.document.document import Document
from report.rendering import summary
from report.rendering.markdown import to_markdown
from report.rendering.outline import Group, place
from report.rendering.selection import select


def certificate(document: Document) -> str:
    return " ".join(to_markdown(document)["certificate"].replace("\\", "").split())


def test_figures_are_counted_from_the_findings(document: Document) -> None:
    assert summary.figures_judged(document) == 3
    assert "the 3 figures are judged by what the text says of them" in certificate(document)
    said = " ".join("".join(to_markdown(document).values()).split())
    assert said.count("The thesis's drawings were not seen") == 2  # in the certificate, and before the cards


@pytest.mark.parametrize(
    ("chapters", "says"),
    [
        ("ch2", "the one figure judged here is judged by what the text says of it"),
        ("appA", "drawings were not seen. :::"),
    ],
)
def test_a_part_counts_its_own(document: Document, chapters: str, says: str) -> None:
    assert says in certificate(select(document, [chapters]))


def test_the_command_makes_the_same_part_again(document: Document) -> None:
    assert summary.command(document) == "trimmer report"
    assert summary.command(select(document, ["appA", "CH2"])) == "trimmer report --only ch2 appA"


def test_the_time_is_the_measured_one_or_left_out(document: Document) -> None:
    assert "62 s of processor time from nothing, measured with version 0.1.0" in certificate(document)
    unknown = dataclasses.replace(document.provenance, build_time=None)
    assert "from nothing" not in certificate(dataclasses.replace(document, provenance=unknown))


def test_what_was_read_is_named(document: Document) -> None:
    text = certificate(document)
    assert all(
        word in text
        for word in (
            "0" * 64,
            "1200 lines",
            "<b>play</b>",
            "author; appendix_C",
            "sympy 1.14.0, typst 0.15.0",
        )
    )


@pytest.mark.parametrize(
    ("lines", "paragraph", "heading", "expected"),
    [
        (None, None, "", r"chapter\ 2"),
        (None, 3, "2.1 Title", r"section\ 2, paragraph\ 3"),
        ((7, 7), None, "2.1 Title", r"section\ 2, line\ 7 of the copy"),
        ((7, 9), 0, "2.1 Title", r"section\ 2, paragraph\ 0, lines\ 7–9 of the copy"),
    ],
)
def test_a_place_is_said_as_far_as_it_is_known(
    document: Document, lines: tuple[int, int] | None, paragraph: int | None, heading: str, expected: str
) -> None:
    finding = dataclasses.replace(document.findings[0], lines=lines, paragraph=paragraph)
    assert place(finding, Group("2", heading, (finding,))) == expected
