"""Claims on statements that the inventory lacks: that they notice what would make the thesis right."""

from dataclasses import replace

import pytest

from report.chapters.chapter_3.claims import section_3_1
from report.chapters.chapter_3.claims.driven_steady_motion import confirm_friction, confirm_play
from report.judging.judge import judge
from report.judging.verdict import Verdict
from report.numbers.proven import OtherNumbersError
from report.numbers.thesis import EXPERIMENT_GAP
from tests.report.claims.graded import graded
from trimmer import resonance_peaks


def verdicts(claim, inventory):
    return [part.verdict for part in judge(claim, graded(inventory[claim.id])).parts]


def with_orbits(evidence, **changes):
    closed = evidence.motion.closed
    orbits = replace(closed.orbits, **changes)
    return replace(evidence, motion=replace(evidence.motion, closed=replace(closed, orbits=orbits)))


def test_the_turned_output_has_no_limit_cycle_because_the_gain_is_too_large_where_it_leads(evidence):
    low, high = section_3_1.loop_gains_where_phases_match(evidence)
    assert 1 < low < high


def test_a_loop_with_limit_cycles_is_not_what_was_proven_to_have_none(evidence, records):
    """A turned plant makes the output of section 3.1 right: no such loop was proven."""
    numbers = replace(evidence.numbers, displacement_only=-evidence.numbers.displacement_only)
    with pytest.raises(OtherNumbersError, match="thesis-turned-sign"):
        records.by_id["txt-3.1-output-sign"].claim(replace(evidence, numbers=numbers))


def test_a_limit_cycle_that_both_starts_reach_would_be_noticed(evidence, inventory, records):
    stable = evidence.motion.closed.orbits.friction.stable.amplitude
    changed = with_orbits(evidence, left_by=(stable, stable))
    claim = records.by_id["txt-7-play-stability"].claim(changed)
    assert verdicts(claim, inventory) == [Verdict.REPRODUCED, Verdict.ERRATUM, Verdict.REPRODUCED]


def test_two_stable_limit_cycles_would_be_noticed(evidence, inventory, records):
    cycles = evidence.cycles
    twice = replace(cycles.friction, unstable=cycles.friction.stable)
    changed = replace(evidence, cycles=replace(cycles, friction=twice))
    claim = records.by_id["txt-7-only-stable"].claim(changed)
    assert verdicts(claim, inventory) == [Verdict.REPRODUCED]


def test_a_limit_cycle_precisely_at_a_peak_would_be_noticed(evidence, inventory, records):
    cycles, peaks = evidence.cycles, resonance_peaks(evidence.numbers.displacement_only)
    highest = max(peaks, key=lambda peak: peak.magnitude).omega
    # Beside the peak by a millionth, where the gain is less.
    there = replace(cycles.friction, unstable=replace(cycles.friction.unstable, omega=highest * (1 + 1e-6)))
    changed = replace(evidence, cycles=replace(cycles, friction=there))
    claim = records.by_id["txt-7-resonance"].claim(changed)
    assert verdicts(claim, inventory)[0] is Verdict.ERRATUM


def test_a_frequency_that_friction_leaves_would_be_noticed(evidence, inventory, records):
    released = evidence.motion.released
    same = tuple(replace(run, frequency=released.by_force[1].frequency) for run in released.by_force)
    changed = replace(evidence, motion=replace(evidence.motion, released=replace(released, by_force=same)))
    claim = records.by_id["txt-3.3-friction-frequency"].claim(changed)
    assert verdicts(claim, inventory) == [Verdict.REPRODUCED, Verdict.REPRODUCED]


@pytest.mark.parametrize("confirm", [confirm_friction, lambda known: confirm_play(known, EXPERIMENT_GAP)])
def test_a_wrong_harmonic_of_a_run_would_be_noticed(confirm, evidence):
    assert confirm(evidence).comparison.compare().agrees
    driven = evidence.motion.driven
    runs = tuple(replace(run, harmonics=1.001 * run.harmonics) for run in driven.runs)
    changed = replace(evidence, motion=replace(evidence.motion, driven=replace(driven, runs=runs)))
    assert not confirm(changed).comparison.compare().agrees
