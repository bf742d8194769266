"""What is called right follows as printed, and what is called wrong does not."""

from report.judging.verdict import Verdict
from report.overview.balance import balance


def test_each_side_rests_on_cards_of_its_kind(evidence, findings) -> None:
    matters = balance(evidence)
    kept = {claim: findings[claim].verdict for matter in matters for claim in matter.kept}
    slips = {claim: findings[claim].verdict for matter in matters for claim in matter.slips}
    assert set(kept.values()) == {Verdict.REPRODUCED}, kept
    assert all(verdict.is_wrong for verdict in slips.values()), slips


def test_the_roll_off_has_the_numbers_of_its_card(evidence, findings) -> None:
    (matter,) = (each for each in balance(evidence) if "txt-5.1.2-roll-off" in each.slips)
    slope = findings["txt-5.1.2-roll-off"].parts[0]
    printed, derived = (str(side).lstrip("-").split()[0] for side in (slope.printed, slope.derived))
    assert f"falls by {derived} dB per decade, not by {printed}." in matter.wrong
