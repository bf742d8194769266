"""What changes a conclusion stands below exactly one root, and is counted once."""

from collections import Counter

from report.judging.verdict import Severity
from report.overview.roots import ROOTS
from report.rendering.summary import partly


def test_each_card_that_changes_a_conclusion_has_one_root(findings):
    stands = Counter(claim for root in ROOTS for claim in root.claims)
    grave = {name for name, finding in findings.items() if finding.severity is Severity.CONCLUSION}
    assert set(stands) == grave
    assert set(stands.values()) == {1}


def test_three_trees_and_last_those_that_stand_alone():
    *trees, alone = ROOTS
    assert [tree.size > 1 and tree.words != "" for tree in trees] == [True] * 3
    assert alone.words == ""


def test_partly_is_what_has_parts_that_are_right(findings):
    assert partly(findings["lst-A.7"])
    assert not partly(findings["eq-D.3"])
    assert not partly(findings["eq-2.1"])
    assert sum(map(partly, findings.values())) > 70
