"""Judging: verdicts, slips, confirmations, with a comparison of plain numbers; what counts once."""

from dataclasses import replace

import pytest

from report.judging.claim import Claim, ClaimPart, Confirmation, CopyFault, Kind, Slip, Statement, Uncheckable
from report.judging.comparisons.assertion import Assertion
from report.judging.comparisons.digits import PrintedDigits
from report.judging.finding import Finding, JudgedPart
from report.judging.items import items
from report.judging.judge import ContradictionError, UngradedError, judge
from report.judging.shown import Number, Words
from report.judging.verdict import Certainty, Impact, Severity, Verdict

ENTRY = Statement("eq-9.9", Kind.EQUATION, "9.9", "a subject", severity=Severity.RESULT)
RIGHT = ClaimPart("right", PrintedDigits("1.25", 1.2501))
WRONG = ClaimPart("wrong", PrintedDigits("1.25", 2.5))
REPEATED = replace(WRONG, label="repeated", slip=Slip("a factor of two", 1.25, Verdict.EXPLAINED))
MISSING = Uncheckable("missing", Words("0.3 mm"), "the raw data of the experiment")


def claim(*parts):
    return Claim("eq-9.9", parts, "It is so.")


@pytest.mark.parametrize(
    ("parts", "verdict"),
    [
        ((RIGHT,), Verdict.REPRODUCED),
        ((RIGHT, REPEATED), Verdict.EXPLAINED),
        ((RIGHT, REPEATED, MISSING), Verdict.NOT_CHECKABLE),
        ((MISSING, WRONG, RIGHT), Verdict.ERRATUM),
    ],
)
def test_worst_part_decides(parts, verdict):
    finding = judge(claim(*parts), ENTRY)
    assert finding.verdict is verdict
    assert (finding.kind, finding.section, finding.title) == (Kind.EQUATION, "9.9", "a subject")


def test_slip_is_named_only_where_it_gives_the_print():
    (judged,) = judge(claim(REPEATED), ENTRY).parts
    assert judged.slip == "a factor of two"
    other = replace(REPEATED, slip=Slip("a factor of three", 0.83, Verdict.EXPLAINED))
    (judged,) = judge(claim(other), ENTRY).parts
    assert (judged.verdict, judged.slip) == (Verdict.ERRATUM, "")


def test_a_slip_never_turns_right_into_wrong():
    right = replace(RIGHT, slip=Slip("none", 7.0, Verdict.ERRATUM))
    assert judge(claim(right), ENTRY).verdict is Verdict.REPRODUCED


def test_forms_and_missing_data_replace_what_is_shown():
    judged, missing = judge(claim(replace(RIGHT, printed_form=Words("as printed")), MISSING), ENTRY).parts
    assert (str(judged.printed), str(judged.derived)) == ("as printed", "1.25010")
    assert str(missing.derived) == "the raw data of the experiment"


CONTRADICTED = replace(RIGHT, confirmation=Confirmation("another way", PrintedDigits("3.0", 1.25)))


@pytest.mark.parametrize(
    ("parts", "error", "told"),
    [
        ([CONTRADICTED], ContradictionError, r"eq-9\.9, right: .* another way"),
        ([RIGHT, WRONG], UngradedError, r"eq-9\.9, wrong: it is wrong, and has no severity"),
        ([], ValueError, "no part"),
    ],
)
def test_what_cannot_be_judged_is_named(parts, error, told):
    with pytest.raises(error, match=told):
        judge(claim(*parts), replace(ENTRY, severity=None))


def test_assertion_and_its_denial():
    said = Assertion("it holds", derived=True, evidence="seen", method="looked at")
    assert said.compare().agrees
    assert not replace(said, asserted=False).compare().agrees
    assert str(replace(said, asserted=False).printed_shown) == "Not so: it holds"
    assert not replace(said, derived=False).compare().agrees


def test_what_the_copy_may_have_lost_is_no_erratum_if_it_agrees_when_restored():
    fault = CopyFault("a digit is lost", PrintedDigits("12.5", 12.51), "the page")
    lost = replace(WRONG, comparison=PrintedDigits("1.5", 12.51), copy_fault=fault)
    finding = judge(claim(RIGHT, lost), ENTRY)
    assert (finding.verdict, finding.severity) == (Verdict.COPY, Severity.NONE)
    assert finding.certainty is Certainty.READING
    assert (finding.parts[1].slip, finding.parts[1].decided_by) == ("a digit is lost", "the page")
    other = replace(fault, restored=PrintedDigits("13.5", 12.51))
    judged = judge(claim(replace(lost, copy_fault=other)), ENTRY).parts[0]
    assert (judged.verdict, judged.decided_by) == (Verdict.ERRATUM, "")


def test_severity_is_that_of_the_gravest_part_and_of_what_is_wrong_alone():
    slip = replace(WRONG, label="slip", severity=Severity.SLIP)
    whole, grave = claim(RIGHT, slip, WRONG), replace(ENTRY, severity=Severity.CONCLUSION)
    finding = judge(whole, grave)
    assert [part.severity for part in finding.parts] == [Severity.NONE, Severity.SLIP, Severity.CONCLUSION]
    assert finding.severity is Severity.CONCLUSION
    assert judge(replace(whole, parts=(RIGHT,)), grave).severity is Severity.NONE
    assert judge(replace(whole, parts=(RIGHT, slip)), grave).severity is Severity.SLIP


def test_certainty_is_that_of_the_least_sure_part_and_none_where_nothing_was_checked():
    assert judge(claim(RIGHT, WRONG), ENTRY).certainty is Certainty.COMPUTED
    assert judge(claim(MISSING), ENTRY).certainty is None
    read = claim(RIGHT, replace(WRONG, certainty=Certainty.READING))
    finding = judge(read, replace(ENTRY, certainty=Certainty.PROVEN))
    assert [part.certainty for part in finding.parts] == [Certainty.PROVEN, Certainty.READING]
    assert finding.certainty is Certainty.READING
    sure = judge(claim(RIGHT, replace(WRONG, certainty=Certainty.PROVEN)), ENTRY)
    assert [part.certainty for part in sure.parts] == [Certainty.COMPUTED, Certainty.PROVEN]
    assert sure.certainty is Certainty.PROVEN


def test_a_part_names_what_it_judges_by_itself_unless_it_shares_it():
    (only,) = judge(claim(RIGHT), ENTRY).parts
    assert only.item == "eq-9.9"
    shared = replace(WRONG, item="737.514 Hz")
    parts = judge(claim(RIGHT, shared, replace(shared, label="again"), replace(RIGHT, label="")), ENTRY).parts
    assert [part.item for part in parts] == ["eq-9.9, right", "737.514 Hz", "737.514 Hz", "eq-9.9, part 4"]


def test_a_finding_that_is_not_wrong_as_a_whole_has_no_severity():
    finding = judge(claim(REPEATED, MISSING), ENTRY)
    assert (finding.verdict, finding.severity) == (Verdict.NOT_CHECKABLE, Severity.NONE)


def finding(claim_id: str, section: str, *parts: tuple[str, Verdict, Severity]) -> Finding:
    """Return a finding of parts with item, verdict and severity."""
    number = Number("1")
    judged = tuple(
        JudgedPart("", verdict, number, number, "", item=item, severity=severity)
        for item, verdict, severity in parts
    )
    return Finding(claim_id, Kind.STATEMENT, section, "", Verdict.ERRATUM, "", "", Impact.LOCAL, "", judged)


def test_a_thing_that_several_claims_judge_counts_once_with_the_gravest() -> None:
    slip = ("737.514 Hz", Verdict.EXPLAINED, Severity.SLIP)
    wrong = ("737.514 Hz", Verdict.ERRATUM, Severity.RESULT)
    right = ("1.7", Verdict.REPRODUCED, Severity.NONE)
    first, second = items((finding("a", "5.2.1", slip, right, slip), finding("b", "7", wrong)))
    assert (first.name, first.chapter) == ("737.514 Hz", "5")
    assert (first.verdict, first.severity) == (Verdict.ERRATUM, Severity.RESULT)
    assert (second.name, second.verdict, second.severity) == ("1.7", Verdict.REPRODUCED, Severity.NONE)
