"""Backlash from mechanics: contact, separation, flight, impact, its limits, and Fourier coefficients."""

import control
import numpy as np
import pytest
import sympy
from scipy import integrate

from derivations.elements.backlash import (
    CONTACT,
    GAMMA,
    GAP,
    SEPARATION,
    contact_ratio,
    friction_waveform,
    general_waveform,
    inertia_contact_ratio,
    inertia_waveform,
)
from derivations.elements.friction import FORCE, relay_waveform
from derivations.elements.friction import friction_waveform as coulomb_waveform
from derivations.elements.waveform import THETA, describing_function
from derivations.symbols import A
from tests.quick import quick

CASES = [(0.3, 1.9), (1.0, 1.6), (1.25, 2.25), (4.0, 2.0), (20.0, 1.0)]
"""Pairs of γ and contact angle, all after separation and within half a turn of it."""


def numbers(gamma, contact):
    separation = float(np.arctan(1 / gamma))
    values = {GAMMA: gamma, SEPARATION: separation, CONTACT: contact, A: 1.0}
    return values | {GAP: float(contact_ratio().subs(values))}


def test_waveforms_are_continuous():
    assert friction_waveform().jumps() == (0, 0, 0, 0)
    ratio = A * inertia_contact_ratio()
    assert [sympy.simplify(jump.subs(GAP, ratio)) for jump in inertia_waveform().jumps()] == [0, 0, 0, 0]


@pytest.mark.parametrize(("gamma", "contact"), CASES)
def test_general_waveform_is_continuous_and_stays_in_the_gap(gamma, contact):
    values = numbers(gamma, contact)
    for segment in general_waveform().segments:
        start, end = (float(edge.subs(values)) for edge in (segment.start, segment.end))
        phase = np.linspace(start, end, 50)
        position = sympy.lambdify(THETA, segment.value.subs(values))(phase)
        assert np.all(np.abs(position - np.sin(phase)) <= values[GAP] / 2 + 1e-9)


@pytest.mark.parametrize(("gamma", "contact"), quick(CASES, 1))
def test_general_describing_function_is_that_of_quadrature(gamma, contact):
    values = numbers(gamma, contact)
    closed = complex(describing_function(general_waveform(), A).subs(values))
    sums = []
    for weight in (np.sin, np.cos):
        total = 0.0
        for segment in general_waveform().segments:
            function = sympy.lambdify(THETA, segment.value.subs(values))
            start, end = (float(edge.subs(values)) for edge in (segment.start, segment.end))
            total += integrate.quad(lambda x, f=function, w=weight: f(x) * w(x), start, end, epsabs=1e-13)[0]
        sums.append(total / np.pi)
    assert closed == pytest.approx(complex(sums[0], sums[1]), rel=1e-9)


@pytest.mark.parametrize("ratio", [0.01, 0.3, 1.0, 1.6, 1.95])
def test_friction_agrees_with_python_control(ratio):
    ours = complex(describing_function(friction_waveform(), A).subs({A: 1, GAP: ratio}))
    theirs = control.friction_backlash_nonlinearity(ratio).describing_function(1.0)
    assert ours == pytest.approx(theirs, rel=1e-12)


@pytest.mark.parametrize("harmonic", [2, pytest.param(4, marks=pytest.mark.slow)])
def test_even_harmonics_vanish(harmonic):
    for waveform in (friction_waveform(), relay_waveform(), coulomb_waveform()):
        value = describing_function(waveform, A, harmonic).subs({A: 1.3, GAP: 0.9, FORCE: 0.4})
        assert abs(complex(value)) < 1e-14


def test_friction_and_relay_differ_by_a_quarter_turn():
    assert describing_function(relay_waveform(), A) == 4 * FORCE / (sympy.pi * A)
    ratio = describing_function(coulomb_waveform(), A) / describing_function(relay_waveform(), A)
    assert sympy.simplify(ratio) == sympy.I
