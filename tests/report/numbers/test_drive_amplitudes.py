"""The open loop for several amplitudes, against describing functions."""

import math

import numpy as np
import pytest

from report.numbers.drive_amplitudes import AMPLITUDES
from report.numbers.thesis import DRIVE_FREQUENCY, LARGE_GAP
from trimmer import response_at
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash


@pytest.fixture(scope="module")
def runs(evidence):
    return evidence.motion.drive_amplitudes


def test_a_pin_within_its_play_moves_nothing(runs):
    assert [run.amplitude for run in runs] == list(AMPLITUDES)
    assert runs[0].amplitude < LARGE_GAP / 2
    assert not runs[0].output.any()
    assert runs[0].ripple == 0


@pytest.mark.parametrize("order", [1, 3, 5, 7])
def test_harmonics_are_describing_function_times_response(order, runs, evidence):
    gain = complex(response_at(evidence.numbers.displacement_only, 2 * math.pi * DRIVE_FREQUENCY * order))
    for run in runs[1:]:
        element = complex(FrictionBacklash(LARGE_GAP).describing_function(run.amplitude, harmonic=order))
        assert run.harmonics[order] == pytest.approx(abs(element * gain) * run.amplitude, rel=2e-3)


def test_far_above_the_gap_the_ripple_is_that_of_a_square_wave_of_half_a_gap(runs, evidence):
    orders = np.arange(3, 200, 2)
    response = response_at(evidence.numbers.displacement_only, 2 * math.pi * DRIVE_FREQUENCY * orders)
    phases = np.linspace(0, 2 * math.pi, 4001)
    # x - gap/2 sign(cos θ) behind the play: harmonics of the square wave, through the response.
    lines = -2 * LARGE_GAP / (math.pi * orders) * np.where(orders % 4 == 1, 1.0, -1.0) * response
    square = (lines * np.exp(1j * np.outer(phases, orders))).sum(axis=1).real
    assert runs[-1].ripple == pytest.approx(np.ptp(square) / 2, rel=2e-3)
