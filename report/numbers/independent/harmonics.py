"""Harmonics of the driven trimmer without simulation.

With friction alone, as long as nothing sticks, friction is a square wave and its harmonics pass the response
to a force; with play alone the harmonics of the backlash pass the response to the pin. The matrices are
written down by hand, as springs and dampers stand in figure 2.1; nothing of them is derived.
"""

import math

import control
import numpy as np

from report.numbers.friction_in_place import force_response
from report.numbers.record import line_amplitudes
from report.numbers.thesis import DRIVE_AMPLITUDE, MEASURED_DRIVE_OMEGA, TURN
from trimmer import FrictionBacklash, TrimmerParameters, response_at
from trimmer.arrays import Complexes, Reals
from trimmer.elements import Element
from trimmer.thesis import TrimmerBody

BY_THE_PIN = np.array([-1.0, 1.0, 0.0, 0.0])
"""Directions of the forces that a displacement of the pin makes on the bodies, per unit of k2."""
BY_FRICTION = np.array([0.0, 1.0, 0.0, -1.0])  # Directions of the forces of friction on cutter and guard
PHASES = 2**13
HIGHEST = 200  # Order below which harmonics are added up for a bound; they fall off with its square
RIPPLE = np.arange(3, 80, 2)  # Orders that make up the ripple of the open loop


def displacements(parameters: TrimmerParameters, omega: float, forces: Complexes | Reals) -> Complexes:
    """Solve (K + jωC - ω²M) q = F for the four displacements, m.

    Forces are complex amplitudes, N, (4,); ω is in rad/s.
    """
    p = parameters
    stiffness = np.array(
        [
            [p.k1 + p.k2, -p.k2, 0, 0],
            [-p.k2, p.k2 + p.k5, -p.k5, 0],
            [0, -p.k5, p.k3 + p.k4 + p.k5, -p.k4],
            [0, 0, -p.k4, p.k4],
        ]
    )
    damping = np.array(
        [[p.c1 + p.c2, -p.c2, 0, 0], [-p.c2, p.c2, 0, 0], [0, 0, p.c3 + p.c4, -p.c4], [0, 0, -p.c4, p.c4]]
    )
    mass = np.diag([p.m1, p.m2, p.m3, p.m4])
    return np.asarray(np.linalg.solve(stiffness + 1j * omega * damping - omega**2 * mass, forces))


def harmonic_of_friction(parameters: TrimmerParameters, force: float, order: int) -> float:
    """Return the amplitude of a harmonic without play, friction (N) being a square wave, m."""
    response = complex(response_at(force_response(parameters), order * MEASURED_DRIVE_OMEGA))
    return 4 * force / (order * math.pi) * abs(response)


def harmonic_behind(
    system: control.lti.LTI, element: Element, amplitude: float, omega: float, order: int
) -> float:
    """Return the amplitude of a harmonic of G behind play, m, for a pin with an amplitude, m, at ω, rad/s."""
    gain = complex(element.describing_function(amplitude, omega, harmonic=order))
    return abs(gain * complex(response_at(system, order * omega))) * amplitude


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
        omega = order * MEASURED_DRIVE_OMEGA
        spring = (parameters.k2 + 1j * omega * parameters.c2) * lines[order]
        by_pin = abs(displacements(parameters, omega, spring * BY_THE_PIN))
        by_friction = abs(displacements(parameters, omega, 4 * force / math.pi * BY_FRICTION))
        guard += float((by_pin + by_friction)[TrimmerBody.GUARD.index])
        own = float(by_pin[TrimmerBody.CUTTER.index])
        cutter += (own if order == 1 else -own) - float(by_friction[TrimmerBody.CUTTER.index])
    return guard / cutter


def ripple_behind_backlash(system: control.StateSpace, gap: float, amplitude: float, omega: float) -> float:
    """Return half of peak to peak of the harmonics ``RIPPLE`` behind friction-controlled backlash, m."""
    waveform = FrictionBacklash(gap).waveform(TURN * np.arange(PHASES) / PHASES, amplitude)
    lines = np.fft.rfft(waveform)
    passed = np.zeros_like(lines)
    passed[RIPPLE] = lines[RIPPLE] * response_at(system, omega * RIPPLE)
    return float(np.ptp(np.fft.irfft(passed))) / 2
