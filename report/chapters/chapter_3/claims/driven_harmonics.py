"""Harmonics of the driven trimmer without simulation: the second way for claims of chapter 3.

With friction alone, as long as nothing sticks, friction is a square wave and its harmonics pass the response
to a force; with play alone the harmonics of the backlash pass the response to the pin.
"""

from __future__ import annotations

import math

import control

from report.claim import Confirmation
from report.comparisons.digits import CloseNumbers
from report.evidence import Evidence
from report.numbers.driven_motion import FORCES
from report.numbers.friction_in_place import force_response
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, MEASURED_DRIVE_FREQUENCY
from trimmer import frequency_response
from trimmer.elements.friction_backlash import FrictionBacklash

THIRD, FIFTH = 3, 5
RELATIVE = 1e-4


def confirm_friction(evidence: Evidence) -> Confirmation:
    """Confirm third and fifth harmonic of the run without play and with the least friction."""
    least = FORCES[0]
    response = force_response(evidence.numbers.parameters)
    third, fifth = (4 * least / (order * math.pi) * _gain(response, order) for order in (THIRD, FIFTH))
    return Confirmation(
        f"friction of {least} N as a square wave, its harmonics times the response to a force",
        _both(third, fifth, evidence, 0.0, least),
    )


def confirm_play(evidence: Evidence, gap: float) -> Confirmation:
    """Confirm third and fifth harmonic of the run with a gap (m) and without friction."""
    element, system = FrictionBacklash(gap), evidence.numbers.both_channels
    third, fifth = (
        abs(complex(element.describing_function(DRIVE_AMPLITUDE, harmonic=order)))
        * DRIVE_AMPLITUDE
        * _gain(system, order)
        for order in (THIRD, FIFTH)
    )
    return Confirmation(
        "the harmonics of backlash times the response to the pin, without friction",
        _both(third, fifth, evidence, gap, 0.0),
    )


def _gain(system: control.StateSpace | control.TransferFunction, order: int) -> float:
    return float(abs(complex(frequency_response(system, 2 * math.pi * order * MEASURED_DRIVE_FREQUENCY))))


def _both(third: float, fifth: float, evidence: Evidence, gap: float, force: float) -> CloseNumbers:
    run = evidence.motion.driven.run(gap, force)
    simulated = complex(run.harmonics[THIRD], run.harmonics[FIFTH])
    return CloseNumbers(complex(third, fifth), simulated, RELATIVE)
