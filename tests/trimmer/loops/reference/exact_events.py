"""Events of the trimmer with play and friction in 30 digits, with nothing of trimmer.loops.

They are seen on a fine grid and found by Newton's method. Which of the frictions stick after an event is
decided by trying all possibilities.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import replace

import mpmath
import numpy as np
from mpmath import mpf

from tests.trimmer.loops.reference.exact_flight import (
    Flight,
    Moment,
    Trimmer,
    contact_force,
    event_functions,
    flight,
    moved,
    sliding_rate,
)
from tests.trimmer.loops.reference.exact_signals import DIGITS, ZERO, Signal

GRID = 2e-6
"""Distance of the points at which signs are looked at, s; the fastest mode has a period of 9e-4 s."""
LONGEST_FLIGHT = mpf(0.1)
"""Time after which no event is waited for, s."""
POINTS = 200
"""Points that are looked at together."""
NO_RATE = 1e-18
"""Sliding velocity that is zero to rounding, m/s."""
FIRST_POINTS = [mpf(GRID) / 10**k for k in (4, 3, 2, 1, 0)]
"""Points right after an event, where 30 digits are needed to see a sign."""


def first_event(found: dict[tuple[str, int], Signal], end: mpf) -> tuple[mpf, tuple[str, int]] | None:
    """Return the earliest fall through zero, at most ``end`` after the start, and whose it is."""
    early = {key: [signal.at(point) for point in FIRST_POINTS] for key, signal in found.items()}
    begin, points = 0.0, np.array([float(point) for point in FIRST_POINTS])
    while begin <= end:
        falls = []
        for key, signal in found.items():
            values = signal.sampled(points) if begin else np.array(early[key], dtype=float)
            below = np.flatnonzero(values < -(1e-13 if begin else 1e-25) * signal.size)
            if below.size:
                low = points[below[0] - 1] if below[0] else begin
                falls.append((signal.falls_through_zero(mpf(low), mpf(points[below[0]])), key))
        if falls:
            earliest = min(falls)
            return earliest if earliest[0] <= end else None
        begin = points[-1]
        points = begin + GRID * np.arange(1, POINTS + 1)
    return None


def settled(trimmer: Trimmer, now: Moment, at_zero: set[int], slipping: int | None) -> Moment:
    """Choose which of the frictions without sliding velocity stick, so that all laws hold."""
    choices = [
        (0, 1, -1) if k in at_zero and k != slipping else (sign,) for k, sign in enumerate(now.sliding)
    ]
    for sliding in itertools.product(*choices):
        trial = replace(now, sliding=sliding)
        motion = flight(trimmer, trial)
        stuck = [friction for friction, sign in zip(trimmer.frictions, sliding, strict=True) if sign == 0]
        holds = all(abs(f.at(ZERO)) <= each.force for f, each in zip(motion.holding, stuck, strict=True))
        slides = all(
            sliding[k] == 0
            or k == slipping
            or sliding[k] * sliding_rate(trimmer.frictions[k], motion).derivative().at(ZERO) > 0
            for k in at_zero
        )
        if holds and slides:
            return trial
    raise AssertionError("no consistent state")


def first_instants(trimmer: Trimmer, start: Moment, count: int) -> list[tuple[str, mpf]]:
    """Return what happens first and when, in 30 digits; of what happens at one instant, the cause."""
    with mpmath.workdps(DIGITS):
        return list(itertools.islice(_instants(trimmer, start), count))


def _instants(trimmer: Trimmer, start: Moment) -> Iterator[tuple[str, mpf]]:
    rates = [mpmath.fdot(friction.row, start.rate) for friction in trimmer.frictions]
    sliding = tuple(int(mpmath.sign(rate)) for rate in rates)
    at_zero = {k for k, sign in enumerate(sliding) if sign == 0}
    now = settled(trimmer, replace(start, sliding=sliding), at_zero, None)
    while True:
        motion = flight(trimmer, now)
        event = first_event(event_functions(trimmer, now, motion), LONGEST_FLIGHT)
        if event is None:
            return
        (kind, index), now = event[1], _after(trimmer, now, motion, *event)
        if kind == "stop":
            kind = "switch" if now.sliding[index] else "stick"
        yield kind.split()[0], now.time


def _after(trimmer: Trimmer, before: Moment, motion: Flight, elapsed: mpf, event: tuple[str, int]) -> Moment:
    """Return the moment right after an event; frictions that stop at the same instant are settled with it."""
    kind, index = event
    now = moved(before, motion, elapsed)
    rates = [mpmath.fdot(friction.row, now.rate) for friction in trimmer.frictions]
    at_zero = {k for k, sign in enumerate(now.sliding) if sign == 0 or abs(rates[k]) < NO_RATE}
    if kind == "impact":
        return _pushed(trimmer, replace(now, side=index), at_zero)
    force = contact_force(trimmer, now, motion)
    if kind == "separation" or (now.side and abs(force.at(elapsed)) < NO_RATE):
        return _released(trimmer, now, at_zero)
    if kind == "stop":
        return settled(trimmer, now, at_zero | {index}, None)
    sliding = list(now.sliding)
    sliding[index] = 1 if kind == "slip forwards" else -1
    return settled(trimmer, replace(now, sliding=tuple(sliding)), at_zero, index)


def _pushed(trimmer: Trimmer, now: Moment, at_zero: set[int]) -> Moment:
    """Return the contact, or the flight at the pin's velocity if the contact would have to pull at once."""
    contact = settled(trimmer, now, at_zero, None)
    motion = flight(trimmer, contact)
    if contact_force(trimmer, contact, motion).at(ZERO) > 0:
        return contact
    return _released(trimmer, moved(contact, motion, ZERO), at_zero)


def _released(trimmer: Trimmer, now: Moment, at_zero: set[int]) -> Moment:
    load_rate = ZERO if trimmer.time_constant == 0 else now.load_rate
    return settled(trimmer, replace(now, side=0, load_rate=load_rate), at_zero, None)
