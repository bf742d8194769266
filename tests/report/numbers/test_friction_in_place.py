"""Backlash at the pin with friction between cutter and guard: responses, solutions, and completeness."""

import math

import numpy as np
import pytest

from report.numbers.friction_in_place import force_response, friction_branch
from report.numbers.independent.harmonics import BY_FRICTION, displacements
from trimmer import FrictionBacklash, TrimmerParameters, limit_cycles, pin_model, response_at
from trimmer.linear import InputChannels
from trimmer.thesis import TrimmerBody

CUTTER, GUARD = TrimmerBody.CUTTER.index, TrimmerBody.GUARD.index


@pytest.fixture(scope="module", params=list(InputChannels), ids=lambda channels: channels.value)
def loop(request):
    parameters = TrimmerParameters.thesis()
    system = pin_model(parameters, channels=request.param)
    ends = limit_cycles(system, FrictionBacklash(1.0))
    return parameters, system, ends, friction_branch(parameters, request.param, *ends)


def closed(parameters, system, amplitude, omega, force):
    """1 + N_r G + N_f H for a gap of one metre, with the force response by hand."""
    backlash = complex(FrictionBacklash(1.0).describing_function(amplitude))
    friction = 4j * force / (math.pi * amplitude)
    pin, moved = complex(response_at(system, omega)), displacements(parameters, omega, BY_FRICTION)
    return 1 + backlash * pin + friction * (moved[CUTTER] - moved[GUARD])


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
