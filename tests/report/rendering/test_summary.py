from dataclasses import replace

from report.building.thesis import THESIS
from report.document.document import Document
from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.items import items
from report.judging.shown import Number
from report.judging.verdict import Certainty, Grade, Impact, Verdict, grade
from report.rendering import summary


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
    named = {
        summary.reference(finding(id, kind))
        for id, kind in (
            ("eq-2.8", Kind.EQUATION),
            ("lst-A.1", Kind.LISTING),
            ("txt-5.1.2-order", Kind.STATEMENT),
        )
    }
    assert named == {"Equation 2.8", "Listing A.1", "Statement in section 5.1.2"}


def test_a_method_that_all_parts_share_is_said_once() -> None:
    assert summary.methods((part("a", "by hand"), part("b", "by hand"))) == (("", "by hand"),)


def test_methods_that_differ_name_their_parts() -> None:
    parts = (part("a", "by hand"), part("b", "by proof"), part("c", "by hand"))
    assert summary.methods(parts) == (("a, c", "by hand"), ("b", "by proof"))


def test_many_parts_are_counted_instead_of_named() -> None:
    parts = (*(part(label, "by hand") for label in "abcd"), part("e", "by proof"))
    assert summary.methods(parts) == (("4 parts", "by hand"), ("e", "by proof"))


def test_parts_without_a_slip_are_not_named() -> None:
    assert summary.slips((part("a", ""), part("b", "", "a sign is lost"))) == (("b", "a sign is lost"),)


def test_a_sentence_ends_with_one_full_stop() -> None:
    assert (
        summary.sentence("b is half the gap")
        == summary.sentence("b is half the gap.")
        == "b is half the gap."
    )


def test_what_the_copy_may_have_lost_is_no_slip_and_says_what_decides() -> None:
    lost = replace(part("a", "", "a minus is lost"), decided_by="the page decides")
    assert summary.slips((lost,)) == ()
    assert summary.copy_faults((lost, part("b", ""))) == (("a", "a minus is lost; the page decides"),)
