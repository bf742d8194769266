"""Parts of the claims that rest on harmonic balance, one by one, and that they notice a wrong solution."""

from dataclasses import replace

import pytest

from report.judging.judge import ContradictionError, judge
from report.judging.verdict import Verdict
from report.numbers.equivalent_nonlinearity import FORCE, listing_element
from report.numbers.friction_in_place import Balances
from report.numbers.independent.limit_cycles import equivalent_as_listed
from report.numbers.listed_functions import equivalent_listing
from report.numbers.thesis import DRIVE_OMEGA, SMALL_GAP
from tests.report.claims.graded import graded


def verdicts(claim, inventory):
    return [part.verdict for part in judge(claim, graded(inventory[claim.id])).parts]


def with_cycles(evidence, **changes):
    return replace(evidence, cycles=replace(evidence.cycles, **changes))


def test_a_limit_cycle_with_the_right_term_would_be_noticed(evidence, inventory, records):
    """A wrong number of limit cycles contradicts the other way to it, so nothing is judged."""
    numbers = replace(evidence.cycles.equivalent, over_stiffness=evidence.cycles.equivalent.listing)
    changed = with_cycles(evidence, equivalent=numbers)
    prediction = records.by_id["txt-5.2.5-prediction"].claim(changed)
    with pytest.raises(ContradictionError, match="in its own place"):
        judge(prediction, inventory[prediction.id])


def test_friction_that_feeds_the_oscillation_would_be_noticed(evidence, inventory, records):
    branch = evidence.cycles.equivalent.in_place
    stable = branch.stable
    growing = Balances(stable.amplitude[::-1], stable.omega[::-1], stable.force_per_gap)
    numbers = replace(evidence.cycles.equivalent, in_place=replace(branch, stable=growing))
    changed = with_cycles(evidence, equivalent=numbers)
    claim = records.by_id["txt-7-coulomb"].claim(changed)
    assert verdicts(claim, inventory)[0] is Verdict.ERRATUM
    figure = records.by_id["fig-5.24"].claim(changed)
    assert verdicts(figure, inventory) == [Verdict.REPRODUCED]


def test_the_second_way_to_the_listings_prediction_does_not_use_the_elements(evidence):
    """Newton's method on the listing's formulas agrees with the solver on the library's elements."""
    (cycle,) = evidence.cycles.equivalent.rounded
    amplitude, omega = equivalent_as_listed(cycle, FORCE, SMALL_GAP, DRIVE_OMEGA)
    assert amplitude == pytest.approx(cycle.amplitude, rel=1e-10)
    assert omega == pytest.approx(cycle.omega, rel=1e-12)
    gain = complex(listing_element(FORCE).describing_function(amplitude))
    assert equivalent_listing(amplitude, FORCE, SMALL_GAP, DRIVE_OMEGA) == pytest.approx(gain, rel=1e-9)
