"""The runs of the driven trimmer, against SciPy and against describing functions."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from report.numbers.driven_motion import FORCES, difference_energy, transient_peaks
from report.numbers.thesis import (
    DRIVE_AMPLITUDE,
    EXPERIMENT_GAP,
    LARGER_GAP,
    LARGEST_GAP,
    MEASURED_DRIVE_FREQUENCY,
)
from trimmer import linear_model, response_at
from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash

OMEGA = 2 * math.pi * MEASURED_DRIVE_FREQUENCY


@pytest.fixture(scope="module")
def driven(evidence):
    return evidence.motion.driven


@pytest.mark.parametrize("gap", [EXPERIMENT_GAP, LARGER_GAP])
@pytest.mark.parametrize("order", [1, 3, 5, 7, 9])
def test_without_friction_harmonics_are_describing_function_times_response(gap, order, driven, evidence):
    element = FrictionBacklash(gap).describing_function(DRIVE_AMPLITUDE, harmonic=order)
    gain = response_at(evidence.numbers.both_channels, order * OMEGA)
    expected = abs(complex(element) * complex(gain)) * DRIVE_AMPLITUDE
    assert driven.run(gap, 0.0).harmonics[order] == pytest.approx(expected, rel=1e-4)


def test_friction_without_play_agrees_with_scipy(driven, evidence):
    """SciPy integrates the equations of motion with the sign function smoothed over 0.1 mm/s."""
    force = FORCES[1]
    model = linear_model(evidence.numbers.parameters)
    parameters = evidence.numbers.parameters
    masses = np.array([parameters.m1, parameters.m2, parameters.m3, parameters.m4])
    row = np.array(CUTTER_RELATIVE_TO_GUARD.row)
    push = np.concatenate([np.zeros(4), -row / masses])

    def rates(time, state):
        pin = DRIVE_AMPLITUDE * np.array([np.sin(OMEGA * time), OMEGA * np.cos(OMEGA * time)])
        return model.A @ state + model.B @ pin + push * force * np.tanh((row @ state[4:]) / 1e-4)

    run = driven.run(0.0, force)
    times = run.times[run.times < 0.02]
    solved = solve_ivp(
        rates, (0, times[-1]), np.zeros(8), method="LSODA", t_eval=times, rtol=1e-8, atol=1e-11
    )
    np.testing.assert_allclose(row @ solved.y[:4], run.output[: times.size], atol=2e-6)


def test_settled_motions_repeat_and_are_their_own_mirror_image(driven):
    moving = [run for run in driven.runs if run.gap < LARGEST_GAP]
    assert len(moving) == 11
    assert max(run.repeat for run in moving) < 1e-8
    assert max(run.mirror for run in moving) < 1e-7
    assert all(run.harmonics[::2].max() < 1e-7 * run.harmonics[1] for run in moving)


def test_a_pin_within_its_play_moves_nothing(driven):
    for run in driven.with_gap(LARGEST_GAP):
        assert np.abs(run.pin).max() < run.gap / 2
        assert not run.output.any()
        assert not run.harmonics.any()


def test_the_difference_of_two_motions_only_loses_energy(driven):
    assert driven.apart[0] == 1
    assert (np.diff(driven.apart) <= 1e-18).all()
    assert driven.apart[-1] < 1e-20


def test_energy_is_that_of_the_derived_matrices(evidence):
    from report.numbers.linear_numbers import exact_values

    values = exact_values(evidence.numbers.parameters)
    matrices = evidence.derivation.matrices
    mass, stiffness = (
        np.array(matrix.subs(values), dtype=float) for matrix in (matrices.mass, matrices.stiffness)
    )
    state = np.linspace(-1, 2, 8)
    expected = (state[4:] @ mass @ state[4:] + state[:4] @ stiffness @ state[:4]) / 2
    assert float(difference_energy(evidence.numbers.parameters, state)) == pytest.approx(expected)


def test_what_dies_out_has_the_frequencies_of_natural_modes(driven, evidence):
    natural = np.array([mode.frequency for mode in evidence.numbers.modes])
    peaks = transient_peaks(driven.run(LARGER_GAP, FORCES[0]))
    assert len(peaks) >= 2
    for peak in peaks:
        assert np.abs(natural / peak - 1).min() < 0.03
