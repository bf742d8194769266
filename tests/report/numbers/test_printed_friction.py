"""Friction with the sign of equation 3.2 keeps the trimmer going, as a relay with positive feedback does."""

import math

import control
import numpy as np
import pytest
from scipy.optimize import brentq

from report.numbers.driven_motion import FORCES
from trimmer import linear_model
from trimmer.displacement import CUTTER_RELATIVE_TO_GUARD, TrimmerBody

BRACKET = (2 * math.pi * 530, 2 * math.pi * 570)


@pytest.fixture(scope="module")
def runs(evidence):
    return evidence.motion.printed_friction


def test_energy_rises_with_the_printed_sign_and_falls_with_the_other(runs):
    for run in runs.as_printed:
        assert run.energy[-1] > 4 * run.energy[0]
    assert runs.opposite.energy[-1] < 1e-4 * runs.opposite.energy[0]
    assert (np.diff(runs.opposite.energy) <= 1e-12 * runs.opposite.energy[0]).all()


def test_the_amplitude_is_proportional_to_the_force(runs):
    ratios = [run.amplitude / run.force for run in runs.as_printed]
    assert [run.force for run in runs.as_printed] == list(FORCES)
    np.testing.assert_allclose(ratios, ratios[0], rtol=1e-6)


def test_amplitude_and_frequency_are_those_of_harmonic_balance(runs, evidence):
    """F along w gives w = 4F/π times the mobility, which therefore has to be real."""
    parameters = evidence.numbers.parameters
    model = linear_model(parameters)
    column = np.zeros((8, 1))
    column[4 + TrimmerBody.CUTTER.index] = 1 / parameters.m2
    column[4 + TrimmerBody.MOTOR.index] = -1 / parameters.m1
    sliding = np.array([[0, 0, 0, 0, -1.0, 1.0, 0, 0]])
    mobility = control.ss(model.A, column, sliding, 0)
    omega = brentq(lambda value: mobility(1j * value).imag, *BRACKET)
    output = control.ss(model.A, column, np.array([(*CUTTER_RELATIVE_TO_GUARD.row, 0, 0, 0, 0)]), 0)
    assert mobility(1j * omega).real > 0
    for run in runs.as_printed:
        assert run.frequency == pytest.approx(omega / (2 * math.pi), abs=5)
        assert run.amplitude == pytest.approx(4 * run.force / math.pi * abs(output(1j * omega)), rel=0.02)
