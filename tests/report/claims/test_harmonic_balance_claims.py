"""Parts of the claims that rest on harmonic balance, one by one, and that they notice a wrong solution."""

from dataclasses import replace

import pytest

from report.chapters.chapter_5.claims import figures_5_5_to_5_18_loci as figures_5_2_heavy_load
from report.chapters.chapter_5.claims import figures_5_21_to_5_24_equivalent as figures_5_2_5
from report.chapters.chapter_5.claims import section_5_2_5
from report.chapters.chapter_5.claims import section_5_2_assumptions as section_5_2
from report.chapters.chapter_7.claims import friction as chapter_7_friction
from report.claim import ContradictionError, Verdict, judge
from report.numbers.equivalent_nonlinearity import listing_element
from report.numbers.friction_in_place import Balances


def verdicts(claim, inventory):
    return [part.verdict for part in judge(claim, inventory[claim.id]).parts]


def found(claims, claim_id):
    (claim,) = (claim for claim in claims if claim.id == claim_id)
    return claim


def with_cycles(evidence, **changes):
    return replace(evidence, cycles=replace(evidence.cycles, **changes))


def test_a_limit_cycle_with_the_right_term_would_be_noticed(evidence, inventory):
    """A wrong number of limit cycles contradicts the other way to it, so nothing is judged."""
    numbers = replace(evidence.cycles.equivalent, over_stiffness=evidence.cycles.equivalent.listing)
    prediction = found(
        section_5_2_5.claims(with_cycles(evidence, equivalent=numbers)), "txt-5.2.5-prediction"
    )
    with pytest.raises(ContradictionError, match="in its own place"):
        judge(prediction, inventory[prediction.id])


def test_friction_that_feeds_the_oscillation_would_be_noticed(evidence, inventory):
    branch = evidence.cycles.equivalent.in_place
    stable = branch.stable
    growing = Balances(stable.amplitude[::-1], stable.omega[::-1], stable.force_per_gap)
    numbers = replace(evidence.cycles.equivalent, in_place=replace(branch, stable=growing))
    changed = with_cycles(evidence, equivalent=numbers)
    claim = found(chapter_7_friction.claims(changed), "txt-7-coulomb")
    assert verdicts(claim, inventory)[0] is Verdict.ERRATUM
    figure = found(figures_5_2_5.claims(changed), "fig-5.24")
    assert verdicts(figure, inventory) == [Verdict.REPRODUCED]


def test_a_harmonic_that_comes_back_would_be_noticed(evidence, inventory, monkeypatch):
    monkeypatch.setattr(section_5_2, "harmonic_leakage", lambda *_: (0.5,))
    (claim,) = section_5_2.claims(evidence)
    assert verdicts(claim, inventory)[3] is Verdict.ERRATUM
    monkeypatch.setattr(figures_5_2_heavy_load, "harmonic_leakage", lambda *_: (0.5,))
    figure = found(figures_5_2_heavy_load.claims(evidence), "fig-5.15")
    assert verdicts(figure, inventory)[0] is Verdict.REPRODUCED


def test_the_second_way_to_the_listings_prediction_does_not_use_the_elements(evidence):
    """Newton's method on the listing's formulas agrees with the solver on the library's elements."""
    (cycle,) = evidence.cycles.equivalent.rounded
    amplitude, omega = section_5_2_5.listing_by_newton(
        cycle, section_5_2_5.FORCE, section_5_2_5.GAP, section_5_2_5.OMEGA
    )
    assert amplitude == pytest.approx(cycle.amplitude, rel=1e-10)
    assert omega == pytest.approx(cycle.omega, rel=1e-12)
    gain = complex(listing_element(section_5_2_5.FORCE).describing_function(amplitude))
    assert section_5_2_5._listing_function(amplitude, section_5_2_5.OMEGA) == pytest.approx(gain, rel=1e-9)
