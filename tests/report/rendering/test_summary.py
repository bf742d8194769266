"""What a report counts and names of its claims, on the certificate too."""

import dataclasses
from collections.abc import Sequence
from dataclasses import replace

import pytest

from report.building.thesis import THESIS
from report.document.document import Document
from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.items import items
from report.judging.shown import Number
from report.judging.verdict import Certainty, Grade, Impact, Verdict, grade
from report.rendering import summary
from report.rendering.markdown import to_markdown
from report.rendering.outline import Group, place
from report.rendering.selection import select


def part(label: str, method: str, slip: str = "") -> JudgedPart:
    return JudgedPart(label, Verdict.REPRODUCED, Number("1"), Number("1"), method, slip)


def finding(id: str, kind: Kind) -> Finding:
    return Finding(id, kind, "5.1.2", "", Verdict.REPRODUCED, "", "", Impact.NONE, "", (part("", ""),))


def test_printed_things_are_counted_by_chapter_and_by_grade(document: Document) -> None:
    *chapters, total = summary.count_table(document)
    judged = items(document.findings)
    assert sum(row.total for row in chapters) == total.total == len(judged)
    assert total.total < sum(len(finding.parts) for finding in document.findings)  # one thing is judged twice
    for index, each in enumerate(Grade):
        numbers = [row.counts[index].number for row in chapters]
        assert sum(numbers) == total.counts[index].number == sum(grade(item) is each for item in judged)
    assert total.reproduced == sum(grade(item) is Grade.REPRODUCED for item in judged) > 0


def test_every_grade_and_certainty_has_its_words() -> None:
    assert set(summary.SYMBOLS) == set(THESIS.meanings) == set(summary.GRADES) == set(Grade)
    assert len(set(summary.SYMBOLS.values())) == len(Grade)
    assert set(summary.CERTAINTIES) == set(Certainty)


def test_a_claim_is_named_as_a_reader_would() -> None:
    for id, kind, name in (
        ("eq-2.8", Kind.EQUATION, "Equation 2.8"),
        ("lst-A.1", Kind.LISTING, "Listing A.1"),
        ("txt-5.1.2-order", Kind.STATEMENT, "Statement in section 5.1.2"),
    ):
        assert summary.reference(finding(id, kind)) == name


@pytest.mark.parametrize(
    ("parts", "told"),
    [
        ((part("a", "by hand"), part("b", "by hand")), [("", "by hand")]),
        (
            [part(a, b) for a, b in zip("abc", ("by hand", "by proof", "by hand"), strict=True)],
            [("a, c", "by hand"), ("b", "by proof")],
        ),
        (
            [*(part(a, "by hand") for a in "abcd"), part("e", "by proof")],
            [("4 parts", "by hand"), ("e", "by proof")],
        ),
    ],
    ids=["one said once", "two name their parts", "many parts are counted"],
)
def test_methods_are_named_with_their_parts(parts: Sequence[JudgedPart], told: list[tuple[str, str]]) -> None:
    assert summary.methods(tuple(parts)) == tuple(told)


def test_a_sentence_ends_with_one_full_stop() -> None:
    for told in ("b is half the gap", "b is half the gap."):
        assert summary.sentence(told) == "b is half the gap."


def test_what_the_copy_may_have_lost_is_no_slip_and_says_what_decides() -> None:
    assert summary.slips((part("a", ""), part("b", "", "a sign is lost"))) == (("b", "a sign is lost"),)
    lost = replace(part("a", "", "a minus is lost"), decided_by="the page decides")
    assert summary.slips((lost,)) == ()
    assert summary.copy_faults((lost, part("b", ""))) == (("a", "a minus is lost; the page decides"),)


def certificate(document: Document) -> str:
    return " ".join(to_markdown(document)["certificate"].replace("\\", "").split())


def test_figures_are_counted_from_the_findings(document: Document) -> None:
    assert summary.figures_judged(document) == 3
    assert "the 3 figures are judged by what the text says of them" in certificate(document)


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


def test_a_time_that_was_not_measured_is_left_out(document: Document) -> None:
    unknown = dataclasses.replace(document.provenance, build_time=None)
    assert "from nothing" not in certificate(dataclasses.replace(document, provenance=unknown))


@pytest.mark.parametrize(
    ("lines", "paragraph", "heading", "expected"),
    [
        (None, None, "", r"chapter\ 2"),
        (None, 3, "2.1 Title", r"section\ 2, paragraph\ 3"),
        ((7, 7), None, "2.1 Title", r"section\ 2, line\ 7 of the copy"),
        ((7, 9), 0, "2.1 Title", r"section\ 2, paragraph\ 0, lines\ 7–9 of the copy"),
    ],
)
def test_a_place_is_said_as_far_as_it_is_known(document, lines, paragraph, heading, expected) -> None:
    finding = dataclasses.replace(document.findings[0], lines=lines, paragraph=paragraph)
    assert place(finding, Group("2", heading, (finding,))) == expected
