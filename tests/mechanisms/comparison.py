"""Two lists of events side by side, and how far a motion by brute force may be trusted."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tests.mechanisms.brute_force import BruteForce, BruteMotion, Event
from trimmer import Mechanism

LOOSE, TIGHT = 3e-11, 3e-13


@dataclass(frozen=True)
class Difference:
    """Where two lists of events part."""

    time: float  # When they do; infinite if they never do
    first: tuple[Event, ...]  # What the one has from there on, a few events
    second: tuple[Event, ...]  # The same for the other
    error: float  # Largest difference of the times of events before that


def difference(first: Sequence[Event], second: Sequence[Event], apart: float) -> Difference:
    """Compare events one by one; those closer together than ``apart`` may come in any order."""
    left, right = list(first), list(second)
    error = 0.0
    while left and right:
        event = left[0]
        match = next(
            (
                place
                for place, other in enumerate(right)
                if (other.part, other.kind) == (event.part, event.kind)
                and abs(other.time - event.time) <= apart
                and other.time - right[0].time <= apart
            ),
            None,
        )
        if match is None:
            break
        error = max(error, abs(right.pop(match).time - left.pop(0).time))
    times = [events[0].time for events in (left, right) if events]
    return Difference(min(times, default=np.inf), tuple(left[:4]), tuple(right[:4]), error)


@dataclass(frozen=True)
class Trusted:
    """A motion by brute force at the tight tolerance."""

    motion: BruteMotion  # It
    horizon: float  # Up to here the loose tolerance gives the same events and states
    error: float  # Largest relative difference of the two until there


def trusted(mechanism: Mechanism, duration: float, enough: float = 1e-8) -> Trusted:
    """Integrate with two tolerances; trust ends where they differ by more than ``enough``."""
    loose, tight = (BruteForce(tolerance).from_rest(mechanism, duration) for tolerance in (LOOSE, TIGHT))
    period = 1 / mechanism.frequency
    parted = difference(loose.events, tight.events, enough * period)
    horizon = min([duration, parted.time - 1e-3 * period, *tight.ambiguous])
    times = np.linspace(0, max(horizon, 0.0), 101)
    usual = tight.system.usual[: tight.system.rows.state_size]
    apart = np.max(np.abs(loose.states(times) - tight.states(times)) / usual, axis=1)
    close = apart <= enough
    if not np.all(close):
        horizon = float(times[np.argmin(close)])
    return Trusted(tight, horizon, float(max(np.max(apart[close], initial=0.0), parted.error / period)))
