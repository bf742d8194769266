"""Fourier sums over a motion, exact to rounding for any frequency.

Within a step the motion is a polynomial. Its product with a wave that turns little is integrated by the nodes
as they are; for faster waves the wave is replaced by its Legendre series up to the degree of the motion,
which has the same integral: exp(-i a x) = Σ (2 l + 1) (-i)^l j_l(a) P_l(x).
"""

from functools import cache

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.hybrid.nodes import NODES
from trimmer.motion.course import Course

FAST = 3.0
"""Half the angle by which a wave turns over a step, rad, up to which the nodes integrate it as they are."""
MANY = 1_000_000  # About so many values of waves are held at once


def fourier(course: Course, signals: Reals, omega: float, count: int) -> Complexes:
    """Return c_n, (count, signals), of signals that are sums of Re c_n exp(i n omega t).

    They are given at the nodes of a motion that spans whole periods of omega, (nodes, signals).
    """
    times, weights = course.nodes.times, course.nodes.weights
    weighted = 2.0 / course.duration * weights[:, None] * signals
    found, together = np.empty((count, signals.shape[1]), dtype=complex), max(1, MANY // max(1, len(times)))
    powers = _powers(np.exp(-1j * omega * times), min(count, together))
    for first in reversed(range(0, count, together)):  # The powers last: they are refined where they are.
        waves = powers[: count - first] * np.exp(-1j * (omega * first) * times) if first else powers
        omegas = omega * np.arange(first + 1.0, first + 1.0 + len(waves))
        found[first : first + together] = _refined(waves, times, weights, omegas) @ weighted
    return found


def _powers(values: Complexes, count: int) -> Complexes:
    """Return the powers 1 .. count of numbers, (count, numbers), each a product of two that are known."""
    found = np.empty((count, len(values)), dtype=complex)
    found[:1], known = values, 1
    while known < count:
        more = min(known, count - known)
        np.multiply(found[:more], found[known - 1], out=found[known : known + more])
        known += more
    return found


def _refined(waves: Complexes, times: Reals, weights: Reals, omegas: Reals) -> Complexes:
    """Return what stands for exp(-i omega t) at the nodes, (omegas, nodes): itself, where it turns little."""
    lengths = weights.reshape(-1, NODES).sum(axis=1)
    angles = 0.5 * omegas[:, None] * lengths
    omega, step = np.nonzero(angles > FAST)
    if len(step):
        middles = 0.5 * (times[::NODES] + times[NODES - 1 :: NODES])
        middle = np.exp(-1j * omegas[omega] * middles[step])
        waves.reshape(len(omegas), -1, NODES)[omega, step] = middle[:, None] * _projected(angles[omega, step])
    return waves


def _projected(angles: Reals) -> Complexes:
    """Return the Legendre series of exp(-i a x) at the nodes, (angles, NODES)."""
    from scipy.special import spherical_jn

    orders, polynomials = _legendre()
    factors = (2 * orders + 1) * (-1j) ** orders * spherical_jn(orders, angles[:, None])
    series: Complexes = factors @ polynomials
    return series


@cache
def _legendre() -> tuple[Reals, Reals]:
    points, _ = np.polynomial.legendre.leggauss(NODES)
    polynomials: Reals = np.polynomial.legendre.legvander(points, NODES - 1).T.astype(np.float64)
    return np.arange(NODES, dtype=np.float64), polynomials
