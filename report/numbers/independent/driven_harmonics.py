"""Harmonics of the driven trimmer without simulation.

With friction alone, as long as nothing sticks, friction is a square wave and its harmonics pass the response
to a force; with play alone the harmonics of the backlash pass the response to the pin.
"""

from __future__ import annotations

import math

import control
import numpy as np

from report.numbers.friction_in_place import force_response
from report.numbers.impedance import BY_FRICTION, BY_THE_PIN, displacements
from report.numbers.record import line_amplitudes
from report.thesis import DRIVE_AMPLITUDE, MEASURED_DRIVE_FREQUENCY, TURN
from trimmer import Body, TrimmerParameters, response_at
from trimmer.elements.friction_backlash import FrictionBacklash

PHASES = 2**13
HIGHEST = 200
"""Order below which harmonics are added up for a bound; they fall off with its square."""


def harmonic_of_friction(parameters: TrimmerParameters, force: float, order: int) -> float:
    """Return the amplitude of a harmonic without play, friction (N) being a square wave, m."""
    return 4 * force / (order * math.pi) * _gain(force_response(parameters), order)


def harmonic_of_play(system: control.StateSpace, gap: float, order: int) -> float:
    """Return the amplitude of a harmonic behind play (m) and without friction, m."""
    element = complex(FrictionBacklash(gap).describing_function(DRIVE_AMPLITUDE, harmonic=order))
    return abs(element) * DRIVE_AMPLITUDE * _gain(system, order)


def _gain(system: control.StateSpace | control.TransferFunction, order: int) -> float:
    return float(abs(complex(response_at(system, TURN * order * MEASURED_DRIVE_FREQUENCY))))


def guard_over_cutter(parameters: TrimmerParameters, gap: float, force: float) -> float:
    """Return what guard over cutter is below, whatever friction up to a force (N) does, with a gap (m).

    No harmonic of a force that stays below F is above 4F/π. The harmonics of the guard are added up, and
    those of the cutter taken from the first one that the pin makes.
    """
    phases = TURN * np.arange(PHASES) / PHASES
    pin = FrictionBacklash(gap).waveform(phases, DRIVE_AMPLITUDE) if gap else DRIVE_AMPLITUDE * np.sin(phases)
    lines = line_amplitudes(pin)
    guard = cutter = 0.0
    for order in range(1, HIGHEST, 2):
        omega = TURN * order * MEASURED_DRIVE_FREQUENCY
        spring = (parameters.k2 + 1j * omega * parameters.c2) * lines[order]
        by_pin = abs(displacements(parameters, omega, spring * BY_THE_PIN))
        by_friction = abs(displacements(parameters, omega, 4 * force / math.pi * BY_FRICTION))
        guard += float((by_pin + by_friction)[Body.GUARD.index])
        own = float(by_pin[Body.CUTTER.index])
        cutter += (own if order == 1 else -own) - float(by_friction[Body.CUTTER.index])
    return guard / cutter
