import csv
import io
from dataclasses import replace

from report.building.thesis import THESIS
from report.data.text_copy import TextCopy
from report.document.document import Document
from report.document.thesis import Chapter
from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.shown import Number, Shown, Words
from report.judging.verdict import Impact, Severity, Verdict
from report.pages.provenance import Provenance
from report.rendering.errata import COLUMNS, Erratum, by_severity, errata, to_csv

LONG = "No: the motion repeats with the drive and nothing else stays in it, whatever the gap is and the load"


TWO = Number("2")


def report(*findings: Finding) -> Document:
    """Return a report of one chapter."""
    chapter = Chapter("chapter-5", "5", "Results", findings)
    nothing = Provenance("", "", "2026-05-04", ())
    return Document(THESIS, (chapter,), 253, (), (), (), (), nothing, TextCopy("", 0))


def of(*findings: Finding) -> tuple[Erratum, ...]:
    """Return the errata of a report of one chapter."""
    return errata(report(*findings))


def finding(id: str, *parts: tuple[str, Verdict, Shown], kind: Kind = Kind.EQUATION) -> Finding:
    """Return a finding whose parts are labels, verdicts and derived sides."""
    judged = tuple(JudgedPart(label, verdict, Number("1"), derived, "") for label, verdict, derived in parts)
    return Finding(id, kind, "5.1", "title", judged[0].verdict, "", "", Impact.LOCAL, "", judged)


def test_only_wrong_parts_are_errata_and_each_is_one() -> None:
    parts = (
        ("first", Verdict.ERRATUM, Number("2")),
        ("second", Verdict.REPRODUCED, Number("1")),
        ("third", Verdict.EXPLAINED, Number("3")),
        ("fourth", Verdict.ERRATUM, Number("4")),
    )
    assert [erratum.part for erratum in of(finding("eq-5.1", *parts))] == ["first", "fourth"]


def test_a_statement_has_its_title_once() -> None:
    parts = (("first", Verdict.ERRATUM, Number("2")), ("second", Verdict.ERRATUM, Number("3")))
    sheet = of(finding("txt-5.1-it", *parts, kind=Kind.STATEMENT))
    assert [erratum.place for erratum in sheet] == ["Sec. 5.1"] * 2
    assert [erratum.part for erratum in sheet] == ["title: first", "second"]


def test_an_answer_is_said_without_its_no_and_if_it_is_very_long_by_its_first_statement() -> None:
    rest = ", with $a; b$ in it"
    for answer, said in (
        ("No: it is $2; 3$; not more", "it is $2; 3$; not more"),
        (f"{LONG}{rest}; the measure of it is 1e-9. More follows", f"{LONG.removeprefix('No: ')}{rest}"),
    ):
        (erratum,) = of(finding("eq-5.1", ("", Verdict.ERRATUM, Words(answer))))
        assert erratum.should_be == Words(said)


def test_a_long_correction_is_said_once_and_then_referred_to_and_a_short_one_repeated() -> None:
    wrong = ("", Verdict.ERRATUM, Words(LONG))
    first, second = of(finding("eq-5.1", wrong), finding("eq-5.2", wrong))
    assert first.should_be == Words(LONG.removeprefix("No: "))
    assert second.should_be == Words(r"as at [Eq\. 5\.1](#eq-5.1)")
    short = ("", Verdict.ERRATUM, TWO)
    assert [each.should_be for each in of(finding("eq-5.1", short), finding("eq-5.2", short))] == [TWO, TWO]


def graded(id: str, severity: Severity, item: str = "", derived: Shown = TWO) -> Finding:
    """Return a finding with one erratum of a severity."""
    part = JudgedPart("", Verdict.ERRATUM, Number("1"), derived, "", item=item or id, severity=severity)
    return replace(finding(id, ("", Verdict.ERRATUM, derived)), parts=(part,), lines=(7, 9))


def test_the_grave_stand_first_and_else_the_order_is_the_thesis_s() -> None:
    severities = (Severity.SLIP, Severity.RESULT, Severity.CONCLUSION, Severity.RESULT)
    sheet = of(*(graded(f"eq-5.{number}", each) for number, each in enumerate(severities, start=1)))
    assert [erratum.claim for erratum in sheet] == ["eq-5.3", "eq-5.2", "eq-5.4", "eq-5.1"]
    groups = {group.severity: len(group.errata) for group in by_severity(sheet)}
    assert [*groups.items()] == [(Severity.CONCLUSION, 1), (Severity.RESULT, 2), (Severity.SLIP, 1)]


def test_a_printed_thing_stands_there_once_with_the_gravest_that_was_found() -> None:
    sheet = of(
        graded("eq-5.1", Severity.SLIP, "737.514 Hz"),
        graded("eq-5.2", Severity.RESULT, "737.514 Hz"),
        graded("eq-5.3", Severity.RESULT),
    )
    assert [erratum.claim for erratum in sheet] == ["eq-5.2", "eq-5.3"]


def test_the_csv_has_a_row_for_each_and_keeps_commas_and_quotes() -> None:
    words = Words('No: "it", and more')
    text = to_csv(report(graded("eq-5.1", Severity.SLIP), graded("eq-5.2", Severity.RESULT, derived=words)))
    first, second = csv.DictReader(io.StringIO(text))
    assert tuple(first) == COLUMNS
    assert (first["severity"], first["claim"], first["should_be"]) == ("result", "eq-5.2", '"it", and more')
    assert (second["severity"], second["first_line"], second["last_line"]) == ("slip", "7", "9")
