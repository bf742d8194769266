"""The runs of the closed loop, against Newton's method and against the laws of scale."""

import math

import numpy as np
import pytest

from report.numbers.released_motion import FORCES_OF_FIGURE, INSIDE, OUTSIDE, SCALE, released_peak
from report.numbers.thesis import EXPERIMENT_GAP, LARGEST_GAP
from trimmer import pin_model
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.linear import InputChannels
from trimmer.orbits.periodic_orbits import periodic_orbits


@pytest.fixture(scope="module")
def released(evidence):
    return evidence.motion.released


@pytest.mark.parametrize(
    ("channels", "runs", "guess"),
    [
        (InputChannels.DISPLACEMENT_ONLY, "appendix", 8.3),
        (InputChannels.DISPLACEMENT_AND_VELOCITY, "by_force", 4.4),
    ],
)
def test_without_friction_the_end_is_the_orbit_that_newton_finds(channels, runs, guess, released, evidence):
    model = pin_model(evidence.numbers.parameters, channels=channels)
    (orbit,) = periodic_orbits(model, FrictionBacklash(1.0), guesses=[(guess, 2 * math.pi * 730)])
    run = getattr(released, runs)[0]
    assert run.force == 0
    assert run.amplitude / run.gap == pytest.approx(orbit.amplitude, rel=1e-6)
    assert run.frequency == pytest.approx(orbit.frequency, rel=1e-7)


def test_gap_force_and_start_times_a_factor_give_the_same_motion_times_it(released):
    np.testing.assert_allclose(
        released.scaled.output, SCALE * released.by_force[1].output, rtol=0, atol=1e-9 * released.scaled.gap
    )


def test_friction_weakens_the_limit_cycle_until_it_ends(released, evidence):
    amplitudes = [run.amplitude for run in released.by_force]
    assert (np.diff(amplitudes) < 0).all()
    assert [run.goes_on for run in released.by_force] == [True] * 6 + [False]
    # Harmonic balance puts the end between the last two forces.
    merger = evidence.cycles.equivalent.in_place_both_channels.merger.force_per_gap * EXPERIMENT_GAP
    assert released.by_force[-2].force < merger < released.by_force[-1].force


@pytest.mark.parametrize("gap", [EXPERIMENT_GAP, LARGEST_GAP])
def test_inside_of_the_play_the_second_mode_dies_out(gap, released, evidence):
    run = released.released(gap, FORCES_OF_FIGURE[0], INSIDE)
    mode = evidence.numbers.modes[1]
    assert not run.goes_on
    assert np.abs(run.output).max() < gap / 2  # the play is never crossed
    assert released_peak(run) == pytest.approx(mode.frequency, rel=5e-3)
    assert released.released(gap, FORCES_OF_FIGURE[0], OUTSIDE).goes_on
