"""Friction that is compensated: the limit cycles of the thesis's loop, and the motion of the twin.

A compensation of a share s of the friction F leaves (1 - s) F between cutter and guard. In the loop nothing
drives, so only the measured velocity can tell the sign of the force; more than all of the friction is then a
relay that pushes along. In the twin a feed-forward knows the pin: a force s F with the sign of the pin's
velocity acts on cutter and guard, here with its odd harmonics up to ``HIGHEST``.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any, Final

import control
import numpy as np

from report.numbers.friction_in_place import force_response
from report.numbers.future_work.kept import KeptAnswer
from report.numbers.independent.loop_with_friction import cycles_at
from report.numbers.twin.mechanism import MOTOR, STROKE, twin
from trimmer import (
    Feedback,
    Force,
    FrictionBacklash,
    Mechanism,
    Relay,
    TrimmerParameters,
    periodic_orbits,
    pin_model,
    respond,
    simulate,
)
from trimmer.arrays import Reals
from trimmer.linear import InputChannels
from trimmer.response.results.response_json import response_json

GAP, FRICTION = 100e-6, 1.0
"""The gap that section 6.4 names, m, and the bound of friction of chapter 5, N."""
FREQUENCIES: Final = (549.6, 736.0, 180)
"""Frequencies at which the limit cycles are computed, Hz: first, last, how many."""
TOO_MUCH: Final = (1.05, 1.1, 1.25)
"""Shares with which the loop is solved beyond full compensation."""
PUSHES: Final = (1e-3, 1.0)
"""Velocity of the cutter with which motions begin there, m/s."""
DURATION, LAST = 2.0, 0.05
"""How long these are followed, and the end of it that is measured, s."""
SHARES: Final = (0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0, 1.125, 1.25)
"""Shares in the twin."""
HIGHEST: Final = 39


def loop_with_too_much(share: float) -> Feedback:
    """Return the thesis's loop with more compensation than friction, as a relay on the velocity."""
    parameters = TrimmerParameters.thesis()
    pin = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    plant = control.ss(
        pin.A,
        np.hstack([-pin.B, force_response(parameters).B]),
        np.vstack([pin.C, pin.C @ pin.A]),
        0,
        inputs=["play", "relay"],
        outputs=["play", "relay"],
        states=pin.state_labels,
    )
    return Feedback(plant, {"play": FrictionBacklash(GAP), "relay": Relay((share - 1) * FRICTION)})


def fed_forward(share: float) -> Mechanism:
    """Return the twin with a share of its friction fed forward with the sign of the pin's velocity."""
    machine = twin(GAP, FRICTION)

    def waves(sign: float) -> tuple[tuple[float, float, float], ...]:
        size = sign * share * FRICTION * 4 / math.pi
        return tuple(
            (float(order), size / order * (-1) ** (order // 2), math.pi / 2)
            for order in range(1, HIGHEST + 1, 2)
        )

    forces = {"to the cutter": ("cutter", 1.0), "to the guard": ("guard", -1.0)}
    added = {name: Force(on, harmonics=waves(sign)) for name, (on, sign) in forces.items()}
    return replace(machine, forces=added) if share else machine


def compensated(share: float) -> Mechanism:
    """Return the twin with what an exact compensation leaves of its friction, for shares up to 1."""
    return twin(GAP, (1 - share) * FRICTION)


def motion_row(machine: Mechanism, share: float, way: str) -> list[Any]:
    """Return share, way, kind of motion, drive periods, stroke (m) and acceleration of the motor (m/s²)."""
    found = response_json(respond(machine))
    return [
        share,
        way,
        found["kind"],
        found["period_count"],
        found["outputs"][STROKE]["peak_to_peak"],
        found["bodies"][MOTOR]["rms_acceleration"],
    ]


def orbit_rows(share: float) -> Iterator[list[Any]]:
    """Yield share, frequency (Hz), amplitude in gaps, stability of each exact orbit with too much."""
    for orbit in periodic_orbits(loop_with_too_much(share)):
        yield [share, orbit.frequency, orbit.stroke_of("play") / 2 / GAP, orbit.stable]


def released_row(share: float, push: float) -> list[float]:
    """Return share, push (m/s), and frequency (Hz) and amplitude in gaps of the motion that it ends in."""
    loop = replace(loop_with_too_much(share), start={"q2_dot": push})
    motion = simulate(loop, DURATION)
    times = np.linspace(DURATION - LAST, DURATION, 40_001)
    output: Reals = np.asarray(motion.signal("play", times))
    rising = np.flatnonzero((output[:-1] < output.mean()) & (output[1:] >= output.mean()))
    period = (times[rising[-1]] - times[rising[0]]) / (len(rising) - 1)
    return [share, push, float(1 / period), float(np.ptp(output)) / 2 / GAP]


def _computed() -> dict[str, Any]:
    first, last, count = FREQUENCIES
    cycles = cycles_at(TrimmerParameters.thesis(), np.linspace(first, last, count).tolist())
    return {
        "cycles": [[each.frequency, each.amplitude, each.force_per_gap] for each in cycles],
        "too much": [row for share in TOO_MUCH for row in orbit_rows(share)],
        "released": [released_row(share, push) for share in TOO_MUCH for push in PUSHES],
        "twin": [
            *(motion_row(compensated(share), share, "exact") for share in SHARES if share <= 1),
            *(motion_row(fed_forward(share), share, "pin") for share in SHARES),
        ],
    }


COMPENSATION: Final = KeptAnswer(
    "compensation",
    [GAP, FRICTION, FREQUENCIES, TOO_MUCH, PUSHES, DURATION, LAST, SHARES, HIGHEST, twin().to_toml()],
    _computed,
)
