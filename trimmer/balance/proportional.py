"""Limit cycles where N is proportional to 1/A: relay, Coulomb friction, and sums of such elements.

With N = c u the amplitude drops out: limit cycles are where f = 1/(c G) is real and negative, and u = -f. All
such places are found by bounds of the phase of f on intervals of the frequency axis.
"""

import math
import sys

import numpy as np
from scipy.optimize import brentq

from trimmer.arrays import Complexes, Flags, Reals
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.search import SearchedRegion, SearchResult
from trimmer.errors import LinearElementError, UnsupportedElementError

_FIRST_INTERVALS = 64  # Intervals of x to begin with

_SMALLEST_HALF = 1e-9  # Half width in x below which an interval is given up

_MOST_INTERVALS = 4096  # Number of intervals at one level above which all of them are given up

_HALVINGS = 60  # How far from the roots of G a bound is looked for, in octaves

_ROUNDING = 1e-10
"""Relative size of a sum over the roots, or angle, rad, of a product, that may be rounding of the roots."""

_METHOD = "exclusion, and test of uniqueness, on intervals of frequency; the amplitude is eliminated"

FALLBACK_REACH = 1e6  # How far beyond the roots of G is searched where no bound is found


def solve_proportional(
    response: InverseResponse, curve: ElementCurve, omega_range: tuple[float, float] | None
) -> SearchedRegion:
    """Find all solutions where N is proportional to u, in a range of angular frequencies, rad/s, or all."""
    coefficient = _coefficient(curve)
    lowest, highest, proven = proportional_range(response, coefficient)
    if omega_range is not None:
        lowest, highest = omega_range
    result = _real_and_negative(response, coefficient, (math.log(lowest), math.log(highest)))
    return SearchedRegion(_METHOD, result, (lowest, highest), omega_range is None and proven, 0.0)


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
        heading = np.angle(-turning.direction / coefficient)
        # In this form it is true where the direction is no number.
        possible = ~(np.abs(heading) > turning.spread)
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
    u = _u(response, coefficient, x)
    # An amplitude that is no double cannot be told, but is there.
    told = (u >= sys.float_info.min) & (u < math.inf)
    undecided.append((x[~told] - _SMALLEST_HALF, x[~told] + _SMALLEST_HALF))
    return SearchResult(u[told], x[told], _boxes(response, coefficient, undecided), examined)


def _u(response: InverseResponse, coefficient: complex, x: Reals) -> Reals:
    """|1/G| over |c|: u where f is real and negative."""
    with np.errstate(all="ignore"):
        return np.abs(response.value(x)) / abs(coefficient)


def proportional_range(response: InverseResponse, coefficient: complex) -> tuple[float, float, bool]:
    """Find a range of omega, rad/s, outside of which f is nowhere real and negative, and whether proven."""
    away = response.roots != 0
    roots, exponents = response.roots[away], response.exponents[away]
    low_direction, high_direction = _directions(response, coefficient)
    # (j omega - root) is -root (1 - j omega/root), and j omega (1 + j root/omega).
    low = _quiet_end(-1.0 / roots, exponents, low_direction, response.is_real)
    high = _quiet_end(roots, exponents, high_direction, response.is_real)
    sizes = np.abs(roots)
    lowest = low if low is not None else sizes.min(initial=1.0) / FALLBACK_REACH
    highest = 1.0 / high if high is not None else sizes.max(initial=1.0) * FALLBACK_REACH
    proven = low is not None and high is not None
    return float(lowest * response.reference), float(highest * response.reference), proven


def _directions(response: InverseResponse, coefficient: complex) -> tuple[complex, complex]:
    """Directions of f for omega to 0 and to infinity.

    Where 1/G is real in s they are powers of j and signs, of which no product is rounded: whether f ends on
    the negative real axis or a quarter turn off is known, and a direction just beside it is one.
    """
    towards_c = _unit(complex(coefficient).conjugate())
    roots, gain = response.roots, complex(response.gain)
    if response.is_real:
        static = math.copysign(1.0, gain.real) * (-1.0) ** int(((roots.imag == 0) & (roots.real > 0)).sum())
        high = complex(math.copysign(1.0, gain.real))
        low = complex(static)
    else:
        away = roots != 0
        turns = (-roots[away] / np.abs(roots[away])) ** response.exponents[away]
        high = _unit(gain)
        low = high * complex(np.prod(turns))
    return (
        low * 1j ** (response.order_at_zero % 4) * towards_c,
        high * 1j ** (response.relative_degree % 4) * towards_c,
    )


def _unit(number: complex) -> complex:
    """Return a number over its modulus; a power of j exactly where it is one."""
    if number.imag == 0:
        return complex(math.copysign(1.0, number.real))
    if number.real == 0:
        return complex(0.0, math.copysign(1.0, number.imag))
    return number / abs(number)


def _quiet_end(scales: Complexes, exponents: Reals, direction: complex, is_real: bool) -> float | None:
    """Find a t up to which direction * prod(1 + j t scale)**exponent is nowhere real and negative.

    Its phase is off that of the direction by t S, S = sum(exponent Re scale), but for a remainder: less than
    sum |z|**2 / (2 - 2 |z|), z = t scale, or sum |z|**3 / (3 - 3 |z|**2) where scales come in conjugate
    pairs, which leave odd powers alone. A direction beside the negative real axis needs a phase that is off
    by less than the angle between them. One on the axis needs a phase that leaves it, to the side that S
    says, and that does not get there again after a turn. If S vanishes to rounding, nothing is said.
    """
    angle = abs(math.atan2(direction.imag, -direction.real))
    if angle <= _ROUNDING and not (is_real and angle == 0.0):
        return None
    sizes = np.abs(scales)
    rate = abs(float((exponents * scales.real).sum()))
    rounding = _ROUNDING * float(sizes.sum())
    if angle == 0.0 and rate <= rounding:
        return None
    t = 0.5 / sizes.max(initial=1.0)
    for _ in range(_HALVINGS):
        z = sizes * t
        terms = z**3 / (3.0 - 3.0 * z**2) if is_real else z**2 / (2.0 - 2.0 * z)
        remainder = float(terms.sum()) * (1.0 + _ROUNDING) + rounding * t
        farthest = rate * t + remainder
        if farthest < angle or (angle == 0.0 and remainder < rate * t and farthest < 2.0 * math.pi):
            return float(t)
        t /= 2.0
    return None


def _crossing(response: InverseResponse, coefficient: complex, lower: float, upper: float) -> list[float]:
    """Return the x between two others where f is real and negative, if any; its phase is monotonic."""

    def phase(x: float) -> float:
        return float(np.angle(-response.direction(np.array([x])) / coefficient)[0])

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
    ends = [_u(response, coefficient, x) for x in (lower, upper)]
    return Cells(np.minimum(*ends), np.maximum(*ends), lower, upper)
