"""Every claim: its reviewed verdict, and that it can fail.

For each part of each claim the printed side is changed in the ways a slip of the pen would change it, and the
outcome has to change too.
"""

import csv
from itertools import groupby
from pathlib import Path

import pytest

from report.claim import Uncheckable
from report.comparisons.expression import SameExpression, SameMatrix
from report.inventory import PATH
from report.verdict import Impact

REVIEWED = Path(PATH).with_name("reviewed_verdicts.csv")


def reviewed():
    """Return the reviewed verdicts by id; ``parts`` is empty where all parts have the claim's verdict."""
    with REVIEWED.open(encoding="utf-8", newline="") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


ROWS = reviewed()


READ = "read in "
"""How the method of a part begins that compares what is printed in two places, and computes nothing."""
CLAIM_IDS = sorted(ROWS)


def checkable(claim):
    return [part for part in claim.parts if not isinstance(part, Uncheckable)]


def test_every_statement_of_the_thesis_is_judged_and_its_verdict_reviewed(claims, inventory):
    assert set(claims) == set(inventory) == set(CLAIM_IDS)


@pytest.mark.parametrize("claim_id", CLAIM_IDS)
def test_verdict_is_the_reviewed_one(claim_id, findings):
    assert findings[claim_id].verdict.value == ROWS[claim_id]["verdict"]


@pytest.mark.parametrize("claim_id", CLAIM_IDS)
def test_severity_and_certainty_are_the_reviewed_ones(claim_id, findings):
    finding = findings[claim_id]
    certainty = finding.certainty.value if finding.certainty else ""
    assert (finding.severity.value, certainty) == (ROWS[claim_id]["severity"], ROWS[claim_id]["certainty"])


@pytest.mark.parametrize("claim_id", CLAIM_IDS)
def test_each_part_has_its_reviewed_verdict(claim_id, findings):
    """The verdict of a claim is the worst of its parts and says nothing of the others."""
    verdicts = [part.verdict.value for part in findings[claim_id].parts]
    counted = "; ".join(f"{len(list(group))} {verdict}" for verdict, group in groupby(verdicts))
    row = ROWS[claim_id]
    assert counted == (row["parts"] or f"{len(verdicts)} {row['verdict']}")


@pytest.mark.parametrize("claim_id", CLAIM_IDS)
def test_every_part_names_two_ways_or_the_text_that_was_read(claim_id, claims):
    """An identity that holds is proven and evaluated; all else is confirmed, or is text held against text."""
    for part in checkable(claims[claim_id]):
        outcome = part.comparison.compare()
        proven = outcome.agrees and isinstance(part.comparison, SameExpression | SameMatrix)
        assert part.confirmation or proven or outcome.method.startswith(READ), part.label


def test_every_claim_says_where_it_stands(claims):
    assert [claim_id for claim_id, claim in claims.items() if claim.lines is None] == []


@pytest.mark.parametrize("claim_id", CLAIM_IDS)
def test_what_is_wrong_says_what_it_changes(claim_id, findings):
    finding = findings[claim_id]
    if finding.verdict.is_wrong:
        assert finding.impact is not Impact.NONE
        assert finding.consequence
    else:
        assert finding.impact is Impact.NONE


@pytest.mark.parametrize("claim_id", CLAIM_IDS)
def test_what_cannot_be_checked_names_what_is_missing(claim_id, claims):
    for part in claims[claim_id].parts:
        if isinstance(part, Uncheckable):
            assert len(part.missing) > 20


@pytest.mark.parametrize("claim_id", CLAIM_IDS)
def test_explanations_are_short_plain_sentences(claim_id, claims):
    claim = claims[claim_id]
    assert 1 <= claim.explanation.count(". ") + 1 <= 5
    assert claim.explanation.count("$") % 2 == 0


def test_the_source_that_a_claim_names_takes_part_in_it(records, source_tree):
    for module, group in records.claims.items():
        assert {record.source for record in group} <= source_tree.closure(module), module
