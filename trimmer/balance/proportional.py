"""Limit cycles where N is proportional to 1/A: relay, Coulomb friction, and sums of such elements.

With N = c u the amplitude drops out: limit cycles are where f = 1/(c G) is real and negative, and u = -f. All
such places are found by bounds of the phase of f on intervals of the frequency axis.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from scipy.optimize import brentq

from trimmer.balance.cells import Cells
from trimmer.balance.search import Searched, SearchResult
from trimmer.errors import LinearElementError, UnsupportedElementError

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Flags, Reals
    from trimmer.balance.element_curve import ElementCurve
    from trimmer.balance.inverse_response import InverseResponse


_FIRST_INTERVALS = 64
"""Intervals of x to begin with."""

_SMALLEST_HALF = 1e-9
"""Half width in x below which an interval is given up."""

_MOST_INTERVALS = 4096
"""Number of intervals at one level above which all of them are given up."""

_HALVINGS = 60
"""How far from the roots of G a bound is looked for, in octaves."""

_METHOD = "exclusion, and test of uniqueness, on intervals of frequency; the amplitude is eliminated"

FALLBACK_REACH = 1e6
"""How far beyond the roots of G is searched where no bound is found."""


def solve_proportional(
    response: InverseResponse, curve: ElementCurve, omega_range: tuple[float, float] | None
) -> Searched:
    """Find all solutions where N is proportional to u.

    Args:
        response: 1/G.
        curve: N.
        omega_range: Lowest and highest angular frequency, rad/s; None for all.

    Raises:
        LinearElementError: if N does not depend on the amplitude.
        UnsupportedElementError: if N is unbounded and not proportional to u.
    """
    coefficient = _coefficient(curve)
    lowest, highest, proven = proportional_range(response, coefficient)
    if omega_range is not None:
        lowest, highest = omega_range
    result = _real_and_negative(response, coefficient, (math.log(lowest), math.log(highest)))
    return Searched(_METHOD, result, (lowest, highest), omega_range is None and proven, 0.0)


def _coefficient(curve: ElementCurve) -> complex:
    """Return c = N/u, which must be the same at all amplitudes."""
    u = np.array([1.0, 0.25, 3.0])
    x = np.zeros_like(u)
    if not np.any(curve.expansion(u, x).by_u):
        raise LinearElementError(
            f"{curve.element!r} is linear: its describing function does not depend on the amplitude, so "
            "nothing sets the amplitude of a limit cycle"
        )
    first, *others = curve.value(u, x) / u
    if curve.depends_on_x or not np.allclose(others, first, rtol=1e-12, atol=0.0):
        raise UnsupportedElementError(
            f"{curve.element!r}: its describing function is unbounded and not proportional to 1/amplitude"
        )
    return complex(first)


def _real_and_negative(
    response: InverseResponse, coefficient: complex, x_range: tuple[float, float]
) -> SearchResult:
    """Find all (u, x) with 1/G(x) + coefficient u = 0 and u > 0."""
    breaks = np.linspace(*x_range, _FIRST_INTERVALS + 1)
    lower, upper = breaks[:-1], breaks[1:]
    roots: list[float] = []
    undecided: list[tuple[Reals, Reals]] = []
    examined = 0
    while lower.size:
        examined += lower.size
        turning = response.turning(lower, upper)
        heading = np.angle(-turning.centre / coefficient)
        possible = np.abs(heading) <= turning.spread
        at_most_one = turning.one_way & (turning.spread < 0.5 * math.pi)
        for left, right in zip(lower[possible & at_most_one], upper[possible & at_most_one], strict=True):
            roots.extend(_crossing(response, coefficient, float(left), float(right)))
        lower, upper = lower[possible & ~at_most_one], upper[possible & ~at_most_one]
        tiny = upper - lower <= 2 * _SMALLEST_HALF
        given_up = tiny | (lower.size > _MOST_INTERVALS)
        # A wide interval may hold solutions beside the root.
        odd = given_up & ~(tiny & _beside_root_on_axis(response, 0.5 * (lower + upper)))
        undecided.append((lower[odd], upper[odd]))
        lower, upper = lower[~given_up], upper[~given_up]
        middle = 0.5 * (lower + upper)
        lower, upper = np.concatenate([lower, middle]), np.concatenate([middle, upper])
    x = np.array(sorted(roots))
    u = -(response.value(x) / coefficient).real
    return SearchResult(u, x, _boxes(response, coefficient, undecided), examined)


def proportional_range(response: InverseResponse, coefficient: complex) -> tuple[float, float, bool]:
    """Find a range of omega, rad/s, outside of which f is nowhere real and negative.

    Args:
        response: 1/G.
        coefficient: c = N/u, in the unit of N.

    Returns:
        Lowest and highest omega, and whether both are proven.
    """
    away = response.roots != 0
    roots, exponents = response.roots[away], response.exponents[away]
    static = response.gain * np.prod((-roots) ** exponents)
    low = _quiet_end(1.0 / roots, exponents, static * 1j**response.order_at_zero / coefficient)
    high = _quiet_end(roots, exponents, response.gain * 1j**response.relative_degree / coefficient)
    sizes = np.abs(roots)
    lowest = low if low is not None else sizes.min(initial=1.0) / FALLBACK_REACH
    highest = 1.0 / high if high is not None else sizes.max(initial=1.0) * FALLBACK_REACH
    proven = low is not None and high is not None
    return float(lowest * response.reference), float(highest * response.reference), proven


def _quiet_end(scales: Complexes, exponents: Reals, direction: complex) -> float | None:
    """Largest t found such that direction * prod(1 + z)**exponent, |z| = |scale| t, is not real and negative.

    The phase of the product is t sum(exponent Re scale), up to a sign, plus at most sum |z|**2 / (2 - 2 |z|).
    Where the direction itself is not real and negative, it is enough that the product is near 1.
    """
    sizes = np.abs(scales)
    heading = direction / abs(direction)
    trend = abs(float((exponents * scales.real).sum()))
    away = max(heading.real, 0.0) or abs(heading.imag)
    t = 0.5 / sizes.max(initial=1.0)
    for _ in range(_HALVINGS):
        z = sizes * t
        growth = math.expm1(-np.log1p(-z).sum())
        if away > 1e-12:
            quiet = growth < away
        else:
            quiet = (
                trend * t > float((z**2 / (2.0 - 2.0 * z)).sum()) * (1.0 + 1e-12)
                and trend > 1e-12 * sizes.sum()
            )
        if quiet:
            return float(t)
        t /= 2.0
    return None


def _crossing(response: InverseResponse, coefficient: complex, lower: float, upper: float) -> list[float]:
    """Return the x between two others where f is real and negative, if any; its phase is monotonic."""

    def phase(x: float) -> float:
        return float(np.angle(-response.value(np.array([x])) / coefficient)[0])

    if (phase(lower) >= 0) == (phase(upper) >= 0):
        return []
    return [float(brentq(phase, lower, upper, xtol=1e-15, rtol=4 * np.finfo(float).eps))]


def _beside_root_on_axis(response: InverseResponse, x: Reals) -> Flags:
    """Return which x are beside a pole or zero j omega of G; f is infinite or zero there."""
    on_axis = response.roots[(response.roots.real == 0) & (response.roots.imag > 0)].imag * response.reference
    distances = np.abs(x - np.log(on_axis)[:, None])
    return np.asarray((distances <= 5 * _SMALLEST_HALF).any(axis=0))


def _boxes(response: InverseResponse, coefficient: complex, intervals: list[tuple[Reals, Reals]]) -> Cells:
    lower, upper = (np.concatenate(side) for side in zip(*intervals, strict=True))
    ends = [np.abs(response.value(x) / coefficient) for x in (lower, upper)]
    return Cells(np.minimum(*ends), np.maximum(*ends), lower, upper)
