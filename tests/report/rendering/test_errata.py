from __future__ import annotations

from report.claim import Finding, Impact, JudgedPart, Kind, Number, Shown, Verdict, Words
from report.document import Chapter, Document, Provenance
from report.rendering.errata import Erratum, errata
from report.text_copy import TextCopy

LONG = "No: the motion repeats with the drive and nothing else stays in it, whatever the gap is and the load"


def of(*findings: Finding) -> tuple[Erratum, ...]:
    """Return the errata of a report of one chapter."""
    chapter = Chapter("chapter-5", "5", "Results", findings)
    nothing = Provenance("", "", "2026-05-04", ())
    return errata(Document("", None, (chapter,), 253, (), (), (), (), nothing, TextCopy("", 0)))


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
    assert [(erratum.place, erratum.part) for erratum in sheet] == [
        ("Sec. 5.1", "title: first"),
        ("Sec. 5.1", "second"),
    ]


def test_the_no_of_an_answer_is_left_out() -> None:
    (erratum,) = of(finding("eq-5.1", ("", Verdict.ERRATUM, Words("No: it is $2; 3$; not more"))))
    assert erratum.should_be == Words("it is $2; 3$; not more")


def test_a_very_long_answer_gives_its_first_statement() -> None:
    answer = f"{LONG}, with $a; b$ in it; the measure of it is 1e-9. More follows, which the card has"
    (erratum,) = of(finding("eq-5.1", ("", Verdict.ERRATUM, Words(answer))))
    assert erratum.should_be == Words(f"{LONG.removeprefix('No: ')}, with $a; b$ in it")


def test_a_long_correction_is_said_once_and_then_referred_to() -> None:
    wrong = ("", Verdict.ERRATUM, Words(LONG))
    first, second = of(finding("eq-5.1", wrong), finding("eq-5.2", wrong))
    assert first.should_be == Words(LONG.removeprefix("No: "))
    assert second.should_be == Words(r"as at [Eq\. 5\.1](#eq-5.1)")


def test_a_short_correction_is_repeated() -> None:
    wrong = ("", Verdict.ERRATUM, Number("2"))
    assert [erratum.should_be for erratum in of(finding("eq-5.1", wrong), finding("eq-5.2", wrong))] == [
        Number("2"),
        Number("2"),
    ]
