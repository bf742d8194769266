"""Backlash at the pin with friction between cutter and guard: responses, solutions, and completeness."""

import math

import numpy as np
import pytest

from report.numbers.friction_in_place import force_response, friction_branch
from trimmer import FrictionBacklash, TrimmerParameters, limit_cycles, pin_model, response_at
from trimmer.linear import InputChannels

OMEGA = 2 * math.pi * np.array([37.0, 222.0, 355.0, 551.0, 734.0, 2000.0])


@pytest.fixture(scope="module", params=list(InputChannels), ids=lambda channels: channels.value)
def loop(request):
    parameters = TrimmerParameters.thesis()
    system = pin_model(parameters, channels=request.param)
    ends = limit_cycles(system, FrictionBacklash(1.0))
    return parameters, system, ends, friction_branch(parameters, request.param, *ends)


def by_newtons_laws(parameters, omega):
    """Response of q2 - q4 to opposite unit forces on bodies 2 and 4, from force balances written by hand."""
    p, s = parameters, 1j * omega
    k12, k34 = p.k2 + p.c2 * s, p.k4 + p.c4 * s
    stiffness = np.array(
        [
            [p.m1 * s**2 + p.k1 + p.c1 * s + k12, -k12, 0, 0],
            [-k12, p.m2 * s**2 + k12 + p.k5, -p.k5, 0],
            [0, -p.k5, p.m3 * s**2 + p.k3 + p.c3 * s + p.k5 + k34, -k34],
            [0, 0, -k34, p.m4 * s**2 + k34],
        ]
    )
    moved = np.linalg.solve(stiffness, [0, 1, 0, -1])
    return moved[1] - moved[3]


def closed(parameters, system, amplitude, omega, force):
    """1 + N_r G + N_f H for a gap of one metre, with the force response by hand."""
    backlash = complex(FrictionBacklash(1.0).describing_function(amplitude))
    friction = 4j * force / (math.pi * amplitude)
    pin = complex(response_at(system, omega))
    return 1 + backlash * pin + friction * by_newtons_laws(parameters, omega)


def test_the_force_moves_cutter_and_guard_as_newtons_laws_say():
    parameters = TrimmerParameters.thesis()
    ours = response_at(force_response(parameters), OMEGA)
    np.testing.assert_allclose(ours, [by_newtons_laws(parameters, omega) for omega in OMEGA], rtol=1e-10)


def test_friction_between_cutter_and_guard_can_only_take_energy():
    response = response_at(force_response(TrimmerParameters.thesis()), np.geomspace(10, 1e5, 4000))
    assert (response.imag < 0).all()


def test_every_point_closes_the_loop(loop):
    parameters, system, _, branch = loop
    for side in (branch.stable, branch.unstable):
        rows = zip(side.amplitude, side.omega, side.force_per_gap, strict=True)
        assert max(abs(closed(parameters, system, *row)) for row in rows) < 1e-7


def test_no_other_force_closes_the_loop(loop):
    """Over all amplitudes of the domain and all frequencies the closing force is real on the branch alone."""
    parameters, system, (unstable, stable), branch = loop
    omegas = 2 * math.pi * np.linspace(20, 4000, 8000)
    pin = response_at(system, omegas)
    friction = response_at(force_response(parameters), omegas)
    for ratio in np.linspace(0.002, 1.998, 160):
        backlash = complex(FrictionBacklash(1.0).describing_function(1 / ratio))
        force = -(1 + backlash * pin) / (4j / math.pi * ratio * friction)
        changes = np.sign(force.imag[1:]) != np.sign(force.imag[:-1])
        positive = changes & (force.real[1:] > 0) & (np.abs(force.imag[1:] - force.imag[:-1]) < 1e4)
        inside = 1 / stable.amplitude < ratio < 1 / unstable.amplitude
        assert positive.sum() == inside, ratio
        assert force.real[1:][positive].max(initial=0) <= branch.merger.force_per_gap * 1.001
