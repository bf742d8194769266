"""Whether a motion seen once a drive period comes again, and whether it settles to an exact orbit."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.response.periodic.orbit import Orbit

NEAR = 0.1  # Distance of two states, as a share of their sizes, at which a motion may be about to repeat
MUCH_NEARER = 0.2
"""Share of the distance after k periods below which that after another number of periods is tried too."""
LINEAR = 0.1  # Share of its distance by which a motion may differ from what the multipliers say of it
CLOSE = 0.2  # Distance to an orbit, as a share of the sizes, beyond which its multipliers say nothing
ON_EDGE = 1e-7  # Distance to an orbit on an edge up to which a sampled motion may still leave it
ROUNDING = 1e-9  # Distance at which what is left is taken for rounding
LEAST_RETURNS = 24  # Returns from which it is told whether a motion comes nearer to an orbit
ERRORS = 4.0  # Standard errors by which a distance has to fall per return
RETURNED = 1e-10  # Distance of a motion to itself that counts as none


def candidates(states: Reals, sizes: Reals, most: int) -> list[int]:
    """Return numbers of drive periods after which a motion may repeat, the most promising ones first.

    Args:
        states: At the start of each drive period, (count, n).
        sizes: Scale of each state, (n,).
        most: The largest number.
    """
    longest = min(most, (len(states) - 1) // 2)
    last = states[-1]
    apart = abs((states[-2 : -2 - longest : -1] - last) / sizes).max(axis=1)
    near = np.flatnonzero(apart < NEAR)
    if not len(near):
        return []
    first, nearest = int(near[0]), int(np.argmin(apart))
    if nearest != first and apart[nearest] < MUCH_NEARER * apart[first]:
        return [nearest + 1, first + 1]
    return [first + 1]


def has_returned(states: Reals, sizes: Reals, periods: int) -> bool:
    """Return whether a motion has come back to itself, to rounding, three times."""
    if len(states) <= 3 * periods:
        return False
    last = states[-1 : -2 - 3 * periods : -periods]
    return bool((abs((last - last[0]) / sizes) < RETURNED).all())


def settles_to(orbit: Orbit, states: Reals) -> bool:
    """Return whether a motion comes closer to a stable orbit as its multipliers say.

    The last two returns are compared with the derivative of the return. Small distances may grow at first;
    what they differ by from the derivative, which grows with them, has to stay small.

    Args:
        orbit: The orbit, over its smallest number of periods.
        states: At the start of each drive period, (count, n), shifted so that leaders are at 0.
    """
    periods = orbit.periods
    if len(states) <= 3 * periods:
        return False
    start = orbit.flow.reduced(orbit.instant.state)
    apart = (states[-1 - 3 * periods :] - start) / orbit.sizes
    sampled = orbit.flow.modes.system.clockwork is not None
    if sampled and orbit.edge is not None and abs(apart[-1]).max() > ON_EDGE:
        return False  # On its way to an edge, what slides may stick.
    first = int(np.argmin(abs(apart[: periods + 1]).max(axis=1)))
    returns = apart[first::periods][:3]
    distances = abs(returns).max(axis=1)
    if max(distances) <= ROUNDING:
        return True
    missed = abs(returns[1:] - returns[:-1] @ orbit.monodromy.T).max(axis=1)
    farthest = orbit.growth * distances[2]
    if max(distances) > CLOSE or farthest > 1:
        return False
    share = max(missed / distances[:2])
    return bool(
        (missed <= LINEAR * distances[:2] + ROUNDING).all() and share * farthest <= LINEAR * max(distances)
    )


def approach(orbit: Orbit, states: Reals) -> float:
    """Return how fast a motion comes nearer to a stable orbit, though it may still be far from it.

    The distance is measured in the eigenvectors of the return, in which it falls at once close to the orbit.
    A line is laid through its logarithm over all returns that are known.

    Args:
        orbit: The orbit, over its smallest number of periods.
        states: At the start of each drive period, (count, n).

    Returns:
        What the distance loses per return in proportion to what the multipliers say, both as logarithms; 0
        if it does not surely fall, or if there are too few returns.
    """
    vectors = np.linalg.eig(orbit.monodromy)[1]
    scaled = (states - orbit.instant.state) / orbit.sizes
    first = int(np.argmin(abs(scaled[-orbit.periods :]).max(axis=1))) - orbit.periods
    apart = scaled[first :: -orbit.periods][::-1]
    largest = float(abs(orbit.multipliers).max())
    if len(apart) < LEAST_RETURNS or not 0 < largest < 1:
        return 0.0
    distances = np.linalg.norm(np.linalg.lstsq(vectors, apart.T, rcond=None)[0], axis=0)
    numbers = np.arange(len(distances)) - (len(distances) - 1) / 2
    logarithms = np.log(np.maximum(distances, np.finfo(float).tiny))
    slope = float(numbers @ logarithms / (numbers @ numbers))
    error = float(np.std(logarithms - logarithms.mean() - slope * numbers) / np.linalg.norm(numbers))
    return slope / math.log(largest) if slope < -ERRORS * error else 0.0
