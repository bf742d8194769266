"""Every claim: its reviewed verdict, and that it can fail.

For each part of each claim the printed side is changed in the ways a slip of the pen would change it, and the
outcome has to change too.
"""

import csv
from itertools import groupby
from pathlib import Path

from report.data.statements import PATH
from report.judging.claim import Uncheckable
from report.judging.comparisons.expression import SameExpression, SameMatrix
from report.judging.verdict import Impact, Verdict

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


def test_verdicts_are_the_reviewed_ones(findings):
    found = {claim_id: finding.verdict.value for claim_id, finding in findings.items()}
    assert found == {claim_id: row["verdict"] for claim_id, row in ROWS.items()}


def test_severity_and_certainty_are_the_reviewed_ones(findings):
    found = {
        claim_id: (finding.severity.value, finding.certainty.value if finding.certainty else "")
        for claim_id, finding in findings.items()
    }
    assert found == {claim_id: (row["severity"], row["certainty"]) for claim_id, row in ROWS.items()}


def test_each_part_has_its_reviewed_verdict(findings):
    """The verdict of a claim is the worst of its parts and says nothing of the others."""
    verdicts = {name: [part.verdict.value for part in each.parts] for name, each in findings.items()}
    counted = {
        claim_id: "; ".join(f"{len(list(group))} {verdict}" for verdict, group in groupby(listed))
        for claim_id, listed in verdicts.items()
    }
    assert counted == {
        claim_id: row["parts"] or f"{len(verdicts[claim_id])} {row['verdict']}"
        for claim_id, row in ROWS.items()
    }


def test_a_slip_that_is_named_gives_what_is_printed(claims, findings):
    """One that gives something else would be left out without a word."""
    assert [
        (claim_id, part.label)
        for claim_id, claim in claims.items()
        for part, found in zip(claim.parts, findings[claim_id].parts, strict=True)
        if found.verdict is Verdict.ERRATUM and part.slip and not found.slip
    ] == []


def test_every_part_names_two_ways_or_the_text_that_was_read(claims):
    """An identity that holds is proven and evaluated; all else is confirmed, or is text held against text."""
    assert [
        (claim_id, part.label)
        for claim_id, claim in claims.items()
        for part in checkable(claim)
        if not (part.confirmation or is_proven(part) or is_read(part))
    ] == []


def is_proven(part):
    return isinstance(part.comparison, SameExpression | SameMatrix) and part.comparison.compare().agrees


def is_read(part):
    return part.comparison.compare().method.startswith(READ)


def test_every_claim_says_where_it_stands(inventory):
    assert [claim_id for claim_id, entry in inventory.items() if entry.lines is None] == []


def test_what_is_wrong_says_what_it_changes(findings):
    wrong = {claim_id: finding for claim_id, finding in findings.items() if finding.verdict.is_wrong}
    assert len(wrong) > 50
    assert [claim_id for claim_id, each in wrong.items() if each.impact is Impact.NONE] == []
    assert [claim_id for claim_id, each in wrong.items() if not each.consequence] == []
    assert [
        claim_id
        for claim_id, each in findings.items()
        if claim_id not in wrong and each.impact is not Impact.NONE
    ] == []


def test_each_slip_of_a_wrong_part_gives_what_is_printed(claims, findings):
    """Else the part would be as wrong, and nothing would say why; one that is lost in the copy needs none."""
    pairs = [
        (claim_id, part, judged)
        for claim_id, claim in claims.items()
        for part, judged in zip(claim.parts, findings[claim_id].parts, strict=True)
        if judged.verdict.is_wrong and not isinstance(part, Uncheckable) and part.slip is not None
    ]
    assert len(pairs) > 50
    assert [(claim_id, part.label) for claim_id, part, judged in pairs if judged.slip != part.slip.name] == []


def test_what_cannot_be_checked_names_what_is_missing(claims):
    missing = [
        (claim_id, part.missing)
        for claim_id, claim in claims.items()
        for part in claim.parts
        if isinstance(part, Uncheckable)
    ]
    assert missing
    assert [each for each in missing if len(each[1]) <= 20] == []


def test_explanations_are_short_plain_sentences(claims):
    explanations = {claim_id: claim.explanation for claim_id, claim in claims.items()}
    assert [each for each, text in explanations.items() if text.count(". ") + 1 > 5] == []
    assert [each for each, text in explanations.items() if text.count("$") % 2] == []


def test_the_source_that_a_claim_names_takes_part_in_it(records, inventory, source_tree):
    for module, group in records.claims.items():
        assert {inventory[record.id].source for record in group} <= source_tree.closure(module), module
