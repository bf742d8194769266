"""The trimmer with two-way contact by a Runge-Kutta method from event to event, written from the definition.

It shares no line with the exact engine of ``trimmer.contact``: forces are added up body by body, SciPy's
DOP853 integrates them, and its event location ends each phase.
"""

import math
from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Final

import numpy as np
from scipy.integrate import solve_ivp

from trimmer import TrimmerParameters
from trimmer.arrays import Reals

TOLERANCE: Final = 1e-11
MOST_PHASES: Final = 2000
NEAR: Final = 1e-9  # Share of the gap within which the sides of the slot touch at the start
SLOW: Final = 1e-9  # Speed below which cutter and guard are at rest to each other where a phase begins, m/s


class PinContact(IntEnum):
    """Where the pin is in its slot; the value is the sign of the force that pulls pin and cutter together."""

    LOWER, FREE, UPPER = -1, 0, 1


@dataclass(frozen=True)
class PlayedTrimmer:
    """The trimmer, with play at the bridge and friction between cutter and guard."""

    parameters: TrimmerParameters  # Masses, stiffnesses and dampings
    gap: float  # Total clearance, m
    force: float  # Friction, N
    amplitude: float  # Of the pin relative to the motor, m
    omega: float  # Of the pin, rad/s


@dataclass(frozen=True)
class PlayPhase:
    """A piece of motion between two events: where the pin is, and how the blade slides (0 is stick)."""

    contact: PinContact
    sliding: int


def integrated(trimmer: PlayedTrimmer, state: Reals, times: Reals) -> Reals:
    """Return states, (9, n), at rising times, s, (n,), from the state, (9,), at the first of them.

    It holds displacements of motor, cutter, housing and guard, m, their velocities, m/s, and the stretch of
    the bridge's spring, m.

    Raises:
        ArithmeticError: if the integration fails, or has more than ``MOST_PHASES`` phases.
    """
    found, now, y = np.empty((9, len(times))), float(times[0]), np.array(state, dtype=np.float64)
    phase = _first(trimmer, now, y)
    done = 0
    for _ in range(MOST_PHASES):
        piece = solve_ivp(
            lambda t, y, phase=phase: _rates(trimmer, phase, t, y),
            (now, float(times[-1])),
            y,
            method="DOP853",
            events=_events(trimmer, phase),
            dense_output=True,
            rtol=TOLERANCE,
            atol=TOLERANCE * 1e-3,
        )
        if not piece.success:
            raise ArithmeticError(f"the integration failed: {piece.message}")
        until = int(np.searchsorted(times, piece.t[-1], side="right"))
        if until > done:  # the dense output refuses to be asked for nothing
            found[:, done:until], done = piece.sol(times[done:until]), until
        if piece.status == 0:
            return found
        now, y = float(piece.t[-1]), piece.y[:, -1].copy()
        fired = next(number for number, each in enumerate(piece.t_events) if len(each))
        phase, y = _next(trimmer, phase, fired, now, y)
    raise ArithmeticError(f"the motion has more than {MOST_PHASES} phases")


def _pin(trimmer: PlayedTrimmer, t: float, y: Reals) -> tuple[float, float]:
    """Return displacement and velocity of the pin relative to the cutter."""
    turn = trimmer.omega * t
    pin = trimmer.amplitude * math.sin(turn), trimmer.amplitude * trimmer.omega * math.cos(turn)
    return y[0] + pin[0] - y[1], y[4] + pin[1] - y[5]


def _slip(y: Reals) -> float:
    return float(y[5] - y[7])


def _stretch_rate(trimmer: PlayedTrimmer, phase: PlayPhase, t: float, y: Reals) -> float:
    if phase.contact is PinContact.FREE:
        return -trimmer.parameters.k2 / trimmer.parameters.c2 * float(y[8])
    return _pin(trimmer, t, y)[1]


def _tension(trimmer: PlayedTrimmer, phase: PlayPhase, t: float, y: Reals) -> float:
    """Return the force that pulls cutter and pin together, N."""
    if phase.contact is PinContact.FREE:
        return 0.0
    return trimmer.parameters.k2 * float(y[8]) + trimmer.parameters.c2 * _stretch_rate(trimmer, phase, t, y)


def _accelerations(trimmer: PlayedTrimmer, phase: PlayPhase, t: float, y: Reals) -> tuple[Reals, float]:
    """Return the accelerations of the bodies, and the friction on the cutter, N."""
    p, (q1, q2, q3, q4), (v1, _, v3, v4) = trimmer.parameters, y[:4], y[4:8]
    tension = _tension(trimmer, phase, t, y)
    coil, joint = p.k5 * (q2 - q3), p.k4 * (q4 - q3) + p.c4 * (v4 - v3)
    on_motor = -p.k1 * q1 - p.c1 * v1 - tension
    on_cutter = tension - coil
    on_housing = coil + joint - p.k3 * q3 - p.c3 * v3
    on_guard = -joint
    friction = -trimmer.force * phase.sliding
    if phase.sliding == 0:  # what keeps the two at one acceleration
        friction = (p.m2 * on_guard - p.m4 * on_cutter) / (p.m2 + p.m4)
    return np.array(
        [on_motor / p.m1, (on_cutter + friction) / p.m2, on_housing / p.m3, (on_guard - friction) / p.m4]
    ), friction


def _rates(trimmer: PlayedTrimmer, phase: PlayPhase, t: float, y: Reals) -> Reals:
    accelerations, _ = _accelerations(trimmer, phase, t, y)
    return np.concatenate([y[4:8], accelerations, [_stretch_rate(trimmer, phase, t, y)]])


def _events(trimmer: PlayedTrimmer, phase: PlayPhase) -> list[object]:
    """Return what ends a phase, by falling through 0: first of the play, then of the friction."""

    def apart(t: float, y: Reals, side: int) -> float:
        return trimmer.gap / 2 - side * (_pin(trimmer, t, y)[0] - float(y[8]))

    def pressed(t: float, y: Reals) -> float:
        return phase.contact * _tension(trimmer, phase, t, y)

    def slides(t: float, y: Reals) -> float:
        return phase.sliding * _slip(y)

    def holds(t: float, y: Reals, side: int) -> float:
        return trimmer.force - side * _accelerations(trimmer, phase, t, y)[1]

    play = [pressed] if phase.contact else [lambda t, y: apart(t, y, 1), lambda t, y: apart(t, y, -1)]
    friction = [slides] if phase.sliding else [lambda t, y: holds(t, y, 1), lambda t, y: holds(t, y, -1)]
    for event in (*play, *friction):
        event.terminal, event.direction = True, -1.0
    return [*play, *friction]


def _next(
    trimmer: PlayedTrimmer, phase: PlayPhase, fired: int, t: float, y: Reals
) -> tuple[PlayPhase, Reals]:
    """Return the phase after an event, and the state with what is now exact."""
    of_play = 1 if phase.contact else 2
    if fired < of_play:
        contact = PinContact.FREE if phase.contact else (PinContact.UPPER, PinContact.LOWER)[fired]
        return replace(phase, contact=contact), y
    if phase.sliding == 0:
        return replace(phase, sliding=(-1, 1)[fired - of_play]), y
    y[5] = y[7]
    return _sliding(trimmer, phase, t, y), y


def _sliding(trimmer: PlayedTrimmer, phase: PlayPhase, t: float, y: Reals) -> PlayPhase:
    """Return the phase in which cutter and guard go on that are at rest to each other."""
    stick = replace(phase, sliding=0)
    needed = _accelerations(trimmer, stick, t, y)[1]
    if abs(needed) <= trimmer.force:
        return stick
    return replace(phase, sliding=-1 if needed > 0 else 1)


def _first(trimmer: PlayedTrimmer, t: float, y: Reals) -> PlayPhase:
    """Return the phase in which a state begins."""
    place = _pin(trimmer, t, y)[0] - float(y[8])
    contact = PinContact.FREE
    if abs(place) >= trimmer.gap / 2 * (1 - NEAR):
        side = PinContact.UPPER if place > 0 else PinContact.LOWER
        if side * _tension(trimmer, PlayPhase(side, 0), t, y) >= 0:
            contact = side
    phase = PlayPhase(contact, int(np.sign(_slip(y))))
    return phase if abs(_slip(y)) > SLOW else _sliding(trimmer, phase, t, y)
