"""Finding the first guard that turns negative within one step of an integrator."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

SAMPLES = 13
# Just after an event a guard that was zero may grow and return within the first step.
EARLY = 24


@dataclass(frozen=True)
class Step:
    """One step of the integrator."""

    begin: float  # Its first time
    end: float  # Its last time
    interpolated: Callable[[np.ndarray], np.ndarray]  # y at times, as columns, by dense output
    exactly: Callable[[float], np.ndarray]  # y at one time by a step of its own from the begin


@dataclass(frozen=True)
class Watch:
    """Guards and their rates, with what counts as having been positive (one number per guard)."""

    guards: np.ndarray
    rates: np.ndarray
    positive: np.ndarray


@dataclass(frozen=True)
class Watched:
    """What one step showed: which guards were positive by its end, and when the first turned negative."""

    armed: np.ndarray
    crossing: float | None


def watch(step: Step, guards: Watch, armed: np.ndarray) -> Watched:
    """Look for the first time at which an armed guard turns negative.

    A guard is armed once it was clearly positive. Dips between samples are found by the guard's rate.
    """
    times = np.linspace(step.begin, step.end, SAMPLES)
    if not np.all(armed):
        early = step.begin + np.geomspace(1e-7, 0.5, EARLY) * (times[1] - times[0])
        times = np.r_[times[0], early, times[1:]]
    y = step.interpolated(times)
    values, rates = guards.guards @ y, guards.rates @ y
    reached = np.maximum.accumulate(values > guards.positive[:, None], axis=1) | armed[:, None]
    dips = (values[:, :-1] > 0) & (rates[:, :-1] < 0) & (rates[:, 1:] > 0)
    may_end = reached[:, :-1] & ((values[:, 1:] < 0) | dips)
    lost = ~reached[:, 1:] & (values[:, 1:] < -1e3 * guards.positive[:, None])
    for place in np.flatnonzero(np.any(may_end | lost, axis=0)):
        ended = [_end(step, guards, row, times[place:][:2]) for row in np.flatnonzero(may_end[:, place])]
        known = [time for time in ended if time is not None]
        if known:
            return Watched(reached[:, place], min(known))
        if np.any(lost[:, place]):
            return Watched(reached[:, place], float(times[place]))
    return Watched(reached[:, -1], None)


def _end(step: Step, guards: Watch, row: int, times: np.ndarray) -> float | None:
    """Return when a guard turns negative between two samples, None if it only dips."""
    before, after = times

    def value(time: float) -> float:
        return float(guards.guards[row] @ step.interpolated(np.array([time]))[:, 0])

    def rate(time: float) -> float:
        return float(guards.rates[row] @ step.interpolated(np.array([time]))[:, 0])

    if value(after) >= 0:
        if not rate(before) < 0 < rate(after):
            return None
        after = brentq(rate, before, after, xtol=1e-300, rtol=1e-14)
        if value(after) >= 0:
            return None
    if value(before) <= 0:
        return float(before)
    rough = brentq(value, before, after, xtol=1e-300, rtol=1e-15)
    return _polished(step, guards, row, float(rough))


def _polished(step: Step, guards: Watch, row: int, time: float) -> float:
    """Newton's method on the integrator itself instead of its dense output."""
    width = step.end - step.begin
    for _ in range(3):
        y = step.exactly(time)
        rate = float(guards.rates[row] @ y)
        if rate == 0:
            return time
        change = -float(guards.guards[row] @ y) / rate
        if abs(change) > 1e-4 * width:
            return time
        time = min(max(time + change, step.begin), step.end)
        if abs(change) < 1e-15 * max(abs(time), width):
            break
    return time
