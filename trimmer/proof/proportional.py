"""1 + N G = 0 where N keeps its direction: the amplitude drops out of the phase, and all is one-dimensional.

With N = c n(u), c fixed, and F = den + c n num: at each omega > 0 at which den and num are not both zero,
F = 0 asks that Im(c num conj(den)) = 0, a polynomial with exact coefficients, and n = -Re(den/(c num)). Its
positive roots are isolated, so nothing is left out from frequency 0 to infinity; then n(u) = k is solved for
all u > 0, in pieces in which n is monotone, and beyond the last corner, where it is linear, at once.
"""

from collections.abc import Iterator
from itertools import pairwise

from flint import acb, arb, fmpq, fmpq_poly

from trimmer.proof.balls import PI, along_axis, in_balls, positive_roots, roots_between
from trimmer.proof.described import Parts, corner
from trimmer.proof.outcome import UndecidedError

Solution = tuple[arb, arb]  # Amplitude and omega, rad/s


def keeps_direction(parts: Parts) -> bool:
    """Return whether N is a real function of the amplitude times a constant."""
    if parts.plays or any(on != off for _, on, off in parts.relays):
        return False
    return parts.square[1] == 0 or not (parts.corners or parts.relays)


def solutions(num: fmpq_poly, den: fmpq_poly, given: fmpq_poly, parts: Parts) -> Iterator[Solution]:
    """Enclose all solutions of den + N num = 0 with N not zero.

    Args:
        num: Numerator.
        den: Denominator with the linear part of the element in it.
        given: The denominator without it.
        parts: The element.
    """
    direction = parts.square if parts.square[1] else (fmpq(1), fmpq(0))
    (a, b), (p, q) = along_axis(num), along_axis(den)
    a, b = direction[0] * a - direction[1] * b, direction[0] * b + direction[1] * a
    phase = b * p - a * q
    if phase.is_zero():
        raise UndecidedError("the phase is right at every frequency, so that solutions are not isolated")
    for pair in (along_axis(num), along_axis(given), *([(p, q)] if _never_zero(parts) else [])):
        phase = _without_roots_of(phase, pair[0].gcd(pair[1]))
    roots = positive_roots(phase)
    if roots is None:
        raise UndecidedError("a root of the phase is too near to zero")
    above, below = in_balls((p, q)), in_balls((a, b))
    for omega, multiplicity in roots:
        if multiplicity > 1:
            raise UndecidedError(f"-1/G touches the direction of N at {float(omega.mid()):.9g} rad/s")
        divisor = below(acb(omega))
        if divisor.contains(0):
            raise UndecidedError(f"G is too small at {float(omega.mid()):.9g} rad/s")
        wanted = (-above(acb(omega)) / divisor).real
        for inverse in _inverse_amplitudes(parts, wanted):
            yield 1 / inverse, omega


def _never_zero(parts: Parts) -> bool:
    return any(parts.square) and not (parts.corners or parts.relays)


def _without_roots_of(polynomial: fmpq_poly, common: fmpq_poly) -> fmpq_poly:
    while (shared := polynomial.gcd(common)).degree() > 0:
        polynomial = polynomial // shared
    return polynomial


def _inverse_amplitudes(parts: Parts, wanted: arb) -> Iterator[arb]:
    """Solve n(u) = wanted for all u > 0."""
    slope = arb(parts.square[0]) * 4 / PI if parts.square[1] == 0 else 4 / PI

    def lacking(u: arb) -> tuple[arb, arb]:
        value, by_u = slope * u - wanted, slope
        for weight, threshold in parts.corners:
            share, steep = corner(u * arb(threshold))
            value, by_u = value + arb(weight) * share, by_u + arb(weight * threshold) * steep
        for level, on, _ in parts.relays:
            x = u * arb(on)
            root = (1 - x * x).nonnegative_part().sqrt()
            silent = x > 1
            value += 0 if silent else arb(level) * 4 / PI * u * root
            by_u += arb(0) if silent else arb(level) * 4 / PI * (1 - 2 * x * x) / root
        return value, by_u

    kinks = sorted({1 / each for _, each in parts.corners} | {1 / on for _, on, _ in parts.relays})
    ends = [arb(0), *(arb(each) for each in kinks)]
    for lower, upper in pairwise(ends):
        yield from roots_between(lacking, lower, upper)
    rest = wanted - sum((arb(weight) for weight, _ in parts.corners), arb(0))
    if slope == 0:
        if rest.contains(0):
            raise UndecidedError("N may be right at every small amplitude")
        return
    beyond = rest / slope
    if beyond > ends[-1]:
        yield beyond
    elif not beyond < ends[-1] and ends[-1] > 0:
        raise UndecidedError("a solution stands at a corner of the element")
    elif beyond.contains(0):
        raise UndecidedError("G is too large or the amplitude too large to tell")
