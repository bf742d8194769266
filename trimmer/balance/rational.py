"""G as a quotient of polynomials: a range of frequency beyond which its phase turns no more.

It is a second way to the ends of the frequency axis, beside that from poles and zeros on which the search
rests. N + 1/G = 0 with N = c u is only where c G is real and negative. With num and den the polynomials of G
that is where Im(c num(j omega) conj(den(j omega))) = 0, a real polynomial in omega, whose positive roots lie
between bounds of Cauchy's kind. These follow from its coefficients; what rounding may change in them is
counted in. Where it may change the sign of the first or last one, there is no bound.

What a transfer function was given by, its coefficients, are taken as they are; each may be off by its last
digit. Those of a state-space system are multiplied out of its poles and zeros.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import control
import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.linear_part import LinearGain

_EPSILON = float(np.finfo(float).eps)
_ROUNDED_UP = 1.0 + 1e-12


@dataclass(frozen=True)
class BoundedPolynomial:
    """A polynomial in a real variable, with how far off its complex coefficients may be."""

    values: Complexes  # Coefficients of rising powers, shape (order + 1,)
    bounds: Complexes  # Bounds of the errors of their real and imaginary parts, as real and imaginary parts

    def __add__(self, other: BoundedPolynomial) -> BoundedPolynomial:
        order = max(self.values.size, other.values.size)
        first, second = (_filled(each.values, order) for each in (self, other))
        bounds = _filled(self.bounds, order) + _filled(other.bounds, order)
        return BoundedPolynomial(first + second, bounds + _EPSILON * (_parts(first) + _parts(second)))

    def __mul__(self, other: BoundedPolynomial) -> BoundedPolynomial:
        sizes, others = _parts(self.values), _parts(other.values)
        bounds = _products(sizes + self.bounds, other.bounds) + _products(self.bounds, others)
        bounds += (2.0 + min(sizes.size, others.size)) * _EPSILON * _products(sizes, others)
        return BoundedPolynomial(np.convolve(self.values, other.values), bounds)

    def conjugate(self) -> BoundedPolynomial:
        """Return the conjugate polynomial."""
        return BoundedPolynomial(self.values.conj(), self.bounds)

    def real_part(self) -> BoundedPolynomial:
        """Return the real part, as where the imaginary one is known to be rounding."""
        return BoundedPolynomial(self.values.real.astype(complex), self.bounds.real.astype(complex))


def _filled(values: Complexes, size: int) -> Complexes:
    return np.concatenate([values, np.zeros(size - values.size)])


def _parts(values: Complexes) -> Complexes:
    return np.asarray(np.abs(values.real) + 1j * np.abs(values.imag))


def _products(sizes: Complexes, others: Complexes) -> Complexes:
    """Bound the parts of a product by those of its factors: a product in which nothing cancels."""
    real = np.convolve(sizes.real, others.real) + np.convolve(sizes.imag, others.imag)
    return np.asarray(
        real + 1j * (np.convolve(sizes.real, others.imag) + np.convolve(sizes.imag, others.real))
    )


def turning_range(
    system: control.lti.LTI, response: InverseResponse, linear: LinearGain, coefficient: complex | None
) -> tuple[float, float] | None:
    """Find a range of omega, rad/s, outside of which the phase of 1/G + linear stays on its side of an axis.

    With a coefficient c it is that outside of which c/(1/G + linear) does not become real, or if it is
    real everywhere, does not change its sign. Without one, that outside of which both parts of 1/G +
    linear keep their signs, or the one that rounding of coefficients tells of. None where that rounding
    does not tell them.
    """
    with np.errstate(all="ignore"):
        numerator, denominator, scale = _polynomials(system, response)
        product = numerator * denominator.conjugate()
        if linear.constant or linear.damping:
            added = np.array([linear.constant, 1j * linear.damping * scale])
            squared = (numerator * numerator.conjugate()).real_part()
            product = product + BoundedPolynomial(added, _EPSILON * _parts(added)).conjugate() * squared
        if coefficient is not None:
            unit = np.array([coefficient / abs(coefficient)])
            product = product * BoundedPolynomial(unit, _EPSILON * _parts(unit))
        real = product.values.real, product.bounds.real
        imaginary = product.values.imag, product.bounds.imag
        if coefficient is not None:
            ends = [root_bounds(*(imaginary if np.any(imaginary) else real))]
        else:
            ends = [root_bounds(*real), root_bounds(*imaginary)]
    lowest, highest = zip(*(each or (math.inf, 0.0) for each in ends), strict=True)
    return (min(lowest) * scale, max(highest) * scale) if any(ends) else None


def root_bounds(coefficients: Reals, errors: Reals) -> tuple[float, float] | None:
    """Bound the moduli of the roots, other than 0, of a real polynomial whose coefficients may be off.

    They are those of rising powers, (order + 1,), with bounds of their errors; one that is 0 and cannot
    be off is none. The bounds are 2 max |a_k/a_n|**(1/(n - k)) (Fujiwara, Tôhoku Math. J. 10, 1916:
    Cauchy's bound in the best unit but for the factor). None if the first or last coefficient may have
    either sign.
    """
    largest = np.abs(coefficients) + errors
    there = np.flatnonzero(largest)
    if not there.size or not np.isfinite(largest).all():
        return None
    first, last = int(there[0]), int(there[-1])
    least = np.abs(coefficients) - errors
    if least[first] <= 0.0 or least[last] <= 0.0:
        return None
    above, below = there[there > first], there[there < last]
    highest = (largest[below] / least[last]) ** (1.0 / (last - below))
    lowest = (largest[above] / least[first]) ** (1.0 / (above - first))
    if not above.size:
        return 1.0, 1.0
    return 1.0 / (2.0 * _ROUNDED_UP * float(lowest.max())), 2.0 * _ROUNDED_UP * float(highest.max())


def _polynomials(
    system: control.lti.LTI, response: InverseResponse
) -> tuple[BoundedPolynomial, BoundedPolynomial, float]:
    """Return numerator and denominator at s = j omega as polynomials in omega over a unit, and the unit."""
    if not isinstance(system, control.TransferFunction):
        zeros, poles = (_multiplied_out(roots) for roots in (response.zeros, response.poles))
        gain = np.array([complex(response.gain)])
        return zeros, poles * BoundedPolynomial(gain, _EPSILON * _parts(gain)), response.reference
    octave = int(np.frexp(response.reference)[1])
    sides = [np.trim_zeros(side[0][0], "f")[::-1].astype(float) for side in (system.num, system.den)]
    mantissas, octaves = zip(*map(np.frexp, sides), strict=True)
    exponents = [each + octave * np.arange(each.size) for each in octaves]
    shift = int(max(exponents[1][mantissas[1] != 0]))
    # A power of two in the unit, and on both sides, costs no digit.
    numerator, denominator = (
        np.ldexp(mantissa, exponent - shift) for mantissa, exponent in zip(mantissas, exponents, strict=True)
    )
    return _at_j_omega(numerator), _at_j_omega(denominator), math.ldexp(1.0, octave)


def _powers_of_j(count: int) -> Complexes:
    return np.array([1j ** (power % 4) for power in range(count)])


def _at_j_omega(coefficients: Reals) -> BoundedPolynomial:
    values = coefficients * _powers_of_j(coefficients.size)
    return BoundedPolynomial(values, _EPSILON * _parts(values))


def _multiplied_out(roots: Complexes) -> BoundedPolynomial:
    """Return the product of (s - root) at s = j omega, with bounds of its rounding."""
    powers = _powers_of_j(roots.size + 1)
    coefficients = np.atleast_1d(np.poly(roots))[::-1]
    sizes = (2.0 + roots.size) * _EPSILON * np.atleast_1d(np.poly(-np.abs(roots)))[::-1]
    bounds = _parts(sizes * powers) if np.isrealobj(coefficients) else (1.0 + 1.0j) * sizes
    return BoundedPolynomial(
        np.asarray(coefficients * powers, dtype=complex), np.asarray(bounds, dtype=complex)
    )
