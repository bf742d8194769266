"""The rest that a branch of limit cycles comes ever nearer to where their period grows without bound.

Such a rest is a saddle: all small distances from it die out but one, which grows as exp(λ t). A cycle that
passes it at a distance δ stays near it for ln(1/δ)/λ, and δ falls in proportion to p₀ - p. So its period is
T = a - ln|p₀ - p|/λ (Guckenheimer and Holmes 1983, section 6.1). The λ of the saddle is put to the periods:
where these follow that law, p₀ is known to far more digits than the last orbit shows.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.response.without_events.rest import Rest

NEAR = 1e-2  # Share of the swing of a state within which the last orbit passes the saddle
STANDS = 1e-9  # Share of the rates of an orbit that is none
GROWN = 2.0  # Factor by which the period has grown along the branch, at least
LATE = 0.6  # Share of the longest period from which periods are held against the law
LEAST = 5  # Orbits that are
RESOLVED = 1e-10  # Share of a value by which it differs from the last one where that is no rounding
AS_TOLD = 0.02  # Share of the distance to the limit by which values may differ from the law


@dataclass(frozen=True, eq=False)
class Saddle:
    """A rest that a limit cycle passes, and cannot stay in.

    Attributes:
        positions: Displacement of each body, m or rad; of a loop what is read of it.
        rate: λ, at which a small distance from it grows, 1/s.
    """

    positions: Mapping[str, float]
    rate: float


def saddle_passed(flow: Flow, course: Course) -> Saddle | None:
    """Return the saddle that an orbit without a drive passes closely; None if it passes none.

    Args:
        flow: What moves.
        course: A period of it.
    """
    _, rows, states = course.points
    size, numbers = flow.size, course.log.mode[rows]
    swings = np.ptp(states[:, :size], axis=0)
    matrices = {int(each): course.modes[int(each)].flow[:size] for each in np.unique(numbers)}
    rates = np.array([matrices[int(each)] @ state for each, state in zip(numbers, states, strict=True)])
    fastest = np.where(abs(rates).max(axis=0) > 0, abs(rates).max(axis=0), 1.0)
    slowest = int(np.argmin((abs(rates) / fastest).max(axis=1)))
    matrix, state = matrices[int(numbers[slowest])], states[slowest]
    at_rest = state[:size] - np.linalg.pinv(matrix[:, :size]) @ rates[slowest]
    left = matrix @ np.append(at_rest, state[size:])
    if (abs(left) > STANDS * fastest).any() or (abs(at_rest - state[:size]) > NEAR * swings).any():
        return None
    values = np.linalg.eigvals(matrix[:, :size])
    growing = values[values.real > 0]
    if len(growing) != 1 or growing[0].imag:
        return None
    like = course.instant(float(course.points[0][slowest]))
    rest = Rest(flow, flow.at(at_rest, like=like), family=False)
    return Saddle(rest.positions, float(growing[0].real))


def limit_of(values: Reals, periods: Reals, rate: float) -> tuple[float, float] | None:
    """Return the value at which periods grow without bound, and how sure it is; None if they do not follow.

    Args:
        values: Of the number that is varied, in the order of the branch, (points,).
        periods: Of the orbits, s, (points,).
        rate: λ of the saddle, 1/s.
    """
    longest, last = float(periods[-1]), float(values[-1])
    asked = (periods >= LATE * longest) & (abs(values - last) > RESOLVED * abs(last))
    if asked.sum() < LEAST or longest < GROWN * periods.min():
        return None
    ahead, shrunk = values[asked] - last, np.exp(-rate * (periods[asked] - longest))
    table = np.column_stack([1.0 / shrunk, np.ones_like(shrunk)])
    limit, share = np.linalg.lstsq(table, ahead / shrunk, rcond=None)[0]
    off = float(abs((ahead - limit) / (share * shrunk) - 1.0).max()) if share else np.inf
    return (last + float(limit), off * abs(float(share)) + np.spacing(abs(last))) if off <= AS_TOLD else None
