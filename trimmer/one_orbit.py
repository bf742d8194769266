"""Whether two orbits are one: the closed curves of their states, wherever in their period they begin.

All that asks whether two periodic motions are one asks here: loops, mechanisms, maps, basins, branches and
designs. Each says what the curve of its orbit is, how large its states become, and how well Newton's method
determined them.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals

SAME = 1e-6
"""Distance of states, as a share of their sizes, up to which two orbits are one.

A return is solved to 1e-10, and what that leaves of an error in the states is told by the multipliers
(``inaccuracy``). What it does not tell is that states come from other instants, places and processors: this
is far above their rounding, and far below what two orbits differ by unless they are about to meet in a fold.
There the inaccuracy is large, and two that it cannot tell apart are one.
"""
LEAST_KNOWN = 1e-3  # Inaccuracy at most; orbits that are known worse still have to agree to that
COARSE = 1024  # Points of a period among which that nearest to the start of another orbit is looked for
FINE = 32  # How many parts the time between two points is divided into, to each side, again and again
REFINED = 6  # How often
PASSES = 4  # Parts of an orbit that may pass by the start of the other one


@dataclass(frozen=True, eq=False)
class ClosedCurve:
    """An orbit, as far as it is to be compared."""

    period: float  # Period, s; in drive periods where there is a drive
    # States at even times, by the part of the orbit and the instant in it, (parts, instants, n): one part for
    # each drive period, or one alone
    states: Reals
    sizes: Reals  # Scale of each state, (n,)
    inaccuracy: float = 0.0  # Error of the states that Newton's method may have left, as a share of the sizes
    # Function from times within the period, s, (count,), to states, (count, n), where the orbit may begin at
    # any time; None where it begins with a drive period
    path: Callable[[Reals], Reals] | None = None


def inaccuracy(residual: float, multipliers: Complexes) -> float:
    """Return how well the states of an orbit are determined by its return, as a share of their sizes.

    The multipliers are all but those that are 1 because the orbit may be shifted.
    """
    apart = abs(1 - multipliers)
    # Those that are 1 belong to a continuum, along which the states are not determined at all.
    apart = apart[apart > SAME]
    return float(min(residual / float(apart.min(initial=1.0)), LEAST_KNOWN))


def are_one(curve: ClosedCurve, other: ClosedCurve, within: float = SAME) -> bool:
    """Return whether two orbits are one, shifted in time, within a distance as a share of their sizes."""
    if curve.states.shape != other.states.shape:
        return False
    share = within + curve.inaccuracy + other.inaccuracy
    if abs(curve.period - other.period) > share * curve.period:
        return False
    allowed = share * np.maximum(curve.sizes, other.sizes)
    parts, instants, _ = curve.states.shape
    ours = curve.states.reshape(parts, -1)
    if other.path is None:
        return same_states(ours, other.states.reshape(parts, -1), np.tile(allowed, instants))
    times = other.period * np.arange(instants) / instants
    begins = _passes(other.path, other.period, curve.states[0, 0], allowed)
    shifted = (other.path(np.mod(begin + times, other.period)) for begin in begins)
    return any(bool((abs(states - curve.states[0]) <= allowed).all()) for states in shifted)


def same_states(ours: Reals, theirs: Reals, allowed: Reals) -> bool:
    """Return whether states of two orbits, (k, n), agree, (n,), wherever in their period they begin."""
    if ours.shape != theirs.shape:
        return False
    return any(
        bool((abs(np.roll(ours, turns, axis=0) - theirs) <= allowed).all()) for turns in range(len(ours))
    )


def _passes(path: Callable[[Reals], Reals], period: float, state: Reals, sizes: Reals) -> list[float]:
    """Return the times, s, at which an orbit passes by a state, the nearest ones."""
    scales = np.where(sizes > 0.0, sizes, 1.0)

    def distances(times: Reals) -> Reals:
        return np.asarray(np.linalg.norm((path(np.mod(times, period)) - state) / scales, axis=1))

    step = period / COARSE
    times = np.asarray(step * np.arange(COARSE), dtype=np.float64)
    coarse = distances(times)
    lowest = np.flatnonzero((coarse <= np.roll(coarse, 1)) & (coarse <= np.roll(coarse, -1)))
    found = []
    for place in lowest[np.argsort(coarse[lowest])][:PASSES]:
        time, reach = float(times[place]), step
        for _ in range(REFINED):
            near = time + reach * np.linspace(-1.0, 1.0, 2 * FINE + 1)
            time, reach = float(near[np.argmin(distances(near))]), reach / FINE
        found.append(time)
    return found
