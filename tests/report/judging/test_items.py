"""Printed things count once, however many ways they were tried."""

from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.items import items
from report.judging.shown import Number
from report.judging.verdict import Impact, Severity, Verdict


def finding(claim_id: str, section: str, *parts: tuple[str, Verdict, Severity]) -> Finding:
    """Return a finding of parts with item, verdict and severity."""
    number = Number("1")
    judged = tuple(
        JudgedPart("", verdict, number, number, "", item=item, severity=severity)
        for item, verdict, severity in parts
    )
    return Finding(claim_id, Kind.STATEMENT, section, "", Verdict.ERRATUM, "", "", Impact.LOCAL, "", judged)


def test_a_thing_that_several_claims_judge_counts_once_with_the_gravest() -> None:
    slip, wrong = (
        ("737.514 Hz", Verdict.EXPLAINED, Severity.SLIP),
        ("737.514 Hz", Verdict.ERRATUM, Severity.RESULT),
    )
    right = ("1.7", Verdict.REPRODUCED, Severity.NONE)
    first, second = items((finding("a", "5.2.1", slip, right, slip), finding("b", "7", wrong)))
    assert (first.name, first.chapter) == ("737.514 Hz", "5")
    assert (first.verdict, first.severity) == (Verdict.ERRATUM, Severity.RESULT)
    assert (second.name, second.verdict, second.severity) == ("1.7", Verdict.REPRODUCED, Severity.NONE)
