"""A second play: behind the first in the loop, between guard and housing, and in a gear before the bridge."""

from dataclasses import replace
from typing import Any, Final

import control
import numpy as np
from scipy.optimize import fsolve

from report.numbers.future_work.compensation import motion_row
from report.numbers.future_work.kept import KeptAnswer
from report.numbers.future_work.load import response
from report.numbers.twin.mechanism import BRIDGE, CUTTER, twin
from trimmer import (
    Body,
    DeadZone,
    Feedback,
    FrictionBacklash,
    LimitCycle,
    Mechanism,
    Play,
    TrimmerParameters,
    harmonic_balance,
    periodic_orbits,
    pin_model,
    response_at,
)
from trimmer.linear import InputChannels
from trimmer.thesis import TrimmerBody

SEATS: Final = (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.5)
"""Play between guard and housing over that at the pin, in the loop."""
EXACT: Final = (0.1, 0.2, 0.3)  # Those of which the exact orbit is sought too
ORDER: Final = 9
GAP, FORCE = 40e-6, 0.5  # Play of the bridge, m, and friction, N, of the twin with a second play
SPEEDS: Final = (110.0, 150.0)
SEAT_GAPS: Final = (0.0, 10e-6, 20e-6, 40e-6, 60e-6, 80e-6, 100e-6, 150e-6, 200e-6)
SHARES: Final = (0.0, 0.25, 0.5, 0.75)  # Of the play in the gear, when gear and bridge have ``GAP`` together
SLIDER_MASS, STIFFER = 1e-4, 20.0
"""Of the body between gear and bridge: mass, kg; the gear is so many times as stiff as the bridge."""


def loop_with_seat(ratio: float) -> Feedback:
    """Return the thesis's loop with a dead zone in the guard's spring, as wide as ratio times the pin's play.

    The spring's force acts from outside of the linear part; its damper stays inside.
    """
    parameters = TrimmerParameters.thesis()
    pin = pin_model(parameters, channels=InputChannels.DISPLACEMENT_ONLY)
    guard, housing, count = TrimmerBody.GUARD.index, TrimmerBody.HOUSING.index, len(TrimmerBody)
    stretch, force = np.zeros(pin.nstates), np.zeros((pin.nstates, 1))
    stretch[[guard, housing]] = 1.0, -1.0
    force[[count + guard, count + housing], 0] = -1 / parameters.m4, 1 / parameters.m3
    plant = control.ss(
        pin.A - parameters.k4 * force * stretch,
        np.hstack([-pin.B, parameters.k4 * force]),
        np.vstack([pin.C, stretch]),
        0,
        inputs=["play", "seat"],
        outputs=["play", "seat"],
        states=pin.state_labels,
    )
    return Feedback(plant, {"play": FrictionBacklash(1.0), "seat": DeadZone(ratio / 2)})


def seat_rows(ratio: float) -> list[list[Any]]:
    """Return ratio, way, frequency (Hz), amplitudes of pin and seat in gaps, for each motion found."""
    loop = loop_with_seat(ratio)
    balanced = harmonic_balance(loop, order=ORDER).motions
    rows = [
        [ratio, "balance", each.frequency, each.amplitudes["play"], each.amplitudes["seat"]]
        for each in balanced
    ]
    if ratio in EXACT:
        rows += [
            [ratio, "exact", each.frequency, each.stroke_of("play") / 2, each.stroke_of("seat") / 2]
            for each in periodic_orbits(loop)
        ]
    return rows


def multiplied(share: float, near: LimitCycle) -> tuple[float, float]:
    """Return frequency (Hz) and amplitude that the product of two describing functions predicts.

    Both plays have one metre together, the first its share, near the limit cycle of a single play.
    """
    system = response(TrimmerParameters.thesis())
    first, second = FrictionBacklash(share), FrictionBacklash(1 - share)

    def imbalance(unknowns: np.ndarray) -> list[float]:
        amplitude, omega = unknowns * [near.amplitude, near.omega]
        gain = complex(first.describing_function(amplitude))
        both = gain * complex(second.describing_function(abs(gain) * amplitude))
        left = 1 + both * complex(response_at(system, omega))
        return [left.real, left.imag]

    amplitude, omega = fsolve(imbalance, [1.0, 1.0], xtol=1e-12) * [near.amplitude, near.omega]
    return float(omega / (2 * np.pi)), float(amplitude)


def seated(gap: float, speed: float) -> Mechanism:
    """Return the twin with a play, m, between guard and housing, in place of the guard's spring."""
    machine = twin(GAP, FORCE, speed)
    if not gap:
        return machine
    spring = machine.links["guard spring"]
    links = {name: each for name, each in machine.links.items() if name != "guard spring"}
    seat = Play(("housing", "guard"), spring.stiffness, spring.damping, gap)
    return replace(machine, links=links, plays={**machine.plays, "seat": seat})


def geared(share: float, speed: float) -> Mechanism:
    """Return the twin with a share of ``GAP`` in a gear between pin and bridge."""
    machine = twin(GAP, FORCE, speed)
    bridge = machine.plays[BRIDGE]
    if not share:
        return machine
    gear = Play(("slider", "pin"), STIFFER * bridge.stiffness, bridge.damping, share * GAP)
    rest = Play((CUTTER, "slider"), bridge.stiffness, bridge.damping, (1 - share) * GAP)
    bodies = {**machine.bodies, "slider": Body(SLIDER_MASS)}
    return replace(machine, bodies=bodies, plays={BRIDGE: rest, "gear": gear})


def _computed() -> dict[str, Any]:
    return {
        "loop": [row for ratio in SEATS for row in seat_rows(ratio)],
        **{
            f"seat {speed:g} Hz": [motion_row(seated(gap, speed), gap, "seat") for gap in SEAT_GAPS]
            for speed in SPEEDS
        },
        **{
            f"gear {speed:g} Hz": [motion_row(geared(share, speed), share, "gear") for share in SHARES]
            for speed in SPEEDS
        },
    }


SECOND_PLAY: Final = KeptAnswer(
    "second-play",
    [SEATS, EXACT, ORDER, GAP, FORCE, SPEEDS, SEAT_GAPS, SHARES, SLIDER_MASS, STIFFER, twin().to_toml()],
    _computed,
)
