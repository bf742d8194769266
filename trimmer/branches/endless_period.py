"""Where the period of a limit cycle grows without bound, extrapolated from a branch that cannot go on.

Newton's method loses such a branch to rounding before its end. Where stick is torn out ever later, the period
may grow like the inverse of the distance to it, T = a + c / (p - p₀); near an equilibrium that the cycle
meets, like its logarithm, p = p₀ + A exp(-λ T) (Guckenheimer and Holmes 1983, section 6.1).
"""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.saddle import Saddle, limit_of
from trimmer.messages import listed

GROWN = 4.0  # Factor by which the period has grown along the branch, at least
SPACING = 0.85  # Factor between the periods at which the law is asked
SHARES = np.arange(1.0, 5.0) / 4.0
"""Shares of the longest period at which it is asked whether the law is the logarithm's: of an inverse one the
steps between them would be as 6 : 2 : 1."""
LATE = np.array([0.7, 0.8, 0.9, 1.0])
"""Shares of the longest period from which its limit is extrapolated then."""
EVEN = 0.1
"""Share by which ratios of steps differ at most from one to the next where the law is the logarithm's."""
NEAR = 0.1  # Share of the branch within which its end is extrapolated
SURE = 0.1  # Largest uncertainty, as a share of the distance over which is extrapolated


@dataclass(frozen=True)
class EndlessPeriod:
    """Where a period grows without bound.

    Attributes:
        value: Value of the number that is varied.
        uncertainty: By how much extrapolations from different orbits differ.
        logarithmic: Whether the period grows like a logarithm, not like an inverse.
        period: The longest that was found, s.
        saddle: The rest that the cycle comes ever nearer to, if that was seen.
    """

    value: float
    uncertainty: float
    logarithmic: bool
    period: float
    saddle: Saddle | None = None

    @property
    def told(self) -> str:
        """It in words."""
        law = "the logarithm of" if self.logarithmic else "one over"
        if self.saddle is not None:
            places = listed([f"{name} {value:.6g}" for name, value in self.saddle.positions.items()])
            return (
                "its period grows without bound: the motion comes ever nearer to a rest in which it cannot "
                f"stay (a saddle: {places}), from which a small distance grows by e in "
                f"{1 / self.saddle.rate:.4g} s. Periods up to {self.period:.6g} s grow like the "
                f"logarithm of the distance to {self.value:.9g} +- {self.uncertainty:.1g}, as that "
                "rate demands"
            )
        return (
            f"its period grows without bound, like {law} the distance to {self.value:.9g} +- "
            f"{self.uncertainty:.1g}, to which periods up to {self.period:.6g} s were extrapolated"
        )


def endless_period(values: Reals, periods: Reals) -> EndlessPeriod | None:
    """Return where the periods of a branch grow without bound; None if they do not, or not surely.

    Args:
        values: Of the number that is varied, in the order of the branch, (points,).
        periods: Of the orbits, s, (points,).
    """
    first = len(periods) - 1
    while first > 0 and periods[first - 1] < periods[first]:
        first -= 1
    values, periods = values[first:], periods[first:]
    steps = np.diff(values)
    if len(values) < 5 or periods[-1] < GROWN * periods[0] or not ((steps > 0).all() or (steps < 0).all()):
        return None
    longest = float(periods[-1])
    evenly = np.interp(longest * SHARES, periods, values)
    ratios = np.diff(evenly)[1:] / np.diff(evenly)[:-1]
    alike = abs(ratios[1] - ratios[0]) <= EVEN * (1.0 - ratios.max())
    logarithmic = bool(ratios.max() < 1.0 and alike)
    found = (
        _of_logarithm(np.interp(longest * LATE, periods, values))
        if logarithmic
        else _of_inverse(values, periods)
    )
    ahead, span = found[0] - values[-1], values[-1] - values[0]
    spread = float(np.ptp(found))
    sure = 0 < ahead * np.sign(span) <= NEAR * abs(span) and spread <= SURE * abs(ahead)
    return EndlessPeriod(float(found[0]), spread, logarithmic, longest) if sure else None


def at_saddle(values: Reals, periods: Reals, saddle: Saddle) -> EndlessPeriod | None:
    """Return where periods grow without bound as near a saddle; None if they do not follow its law.

    Args:
        values: Of the number that is varied, in the order of the branch, (points,).
        periods: Of the orbits, s, (points,).
        saddle: The rest that the last of them passes.
    """
    found = limit_of(values, periods, saddle.rate)
    return None if found is None else EndlessPeriod(*found, True, float(periods[-1]), saddle)


def _of_logarithm(values: Reals) -> Reals:
    """Return limits of values at even periods by Aitken's process, from the last three and those before."""
    limits = []
    for last in (4, 3):
        first, second, third = values[last - 3 : last]
        limits.append(third - (third - second) ** 2 / (third - 2 * second + first))
    return np.array(limits)


def _of_inverse(values: Reals, periods: Reals) -> Reals:
    """Return limits of values over 1/T, (3,): by a cubic, and by parabolas through some of the orbits."""
    wanted = periods[-1] * SPACING ** np.arange(4.0)
    chosen = np.unique([int(np.argmin(abs(periods - each))) for each in wanted])
    inverse, there = 1.0 / periods[chosen], values[chosen]
    return np.array(
        [at_zero(inverse, there), at_zero(inverse[1:], there[1:]), at_zero(inverse[:-1], there[:-1])]
    )


def at_zero(places: Reals, values: Reals) -> float:
    """Return the polynomial through some values at zero, by Lagrange's form."""
    others = [np.delete(places, each) for each in range(len(places))]
    weights = [np.prod(-other / (place - other)) for place, other in zip(places, others, strict=True)]
    return float(np.array(weights) @ values)
