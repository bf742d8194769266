"""Fourier sums over a motion, exact to rounding for any frequency.

Within a step the motion is a polynomial. Its product with a wave that turns little is integrated by the nodes
as they are; for faster waves the wave is replaced by its Legendre series up to the degree of the motion,
which has the same integral: exp(-i a x) = Σ (2 l + 1) (-i)^l j_l(a) P_l(x).
"""

from __future__ import annotations

from functools import cache

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.hybrid.nodes import NODES
from trimmer.motion.course import Course

FAST = 3.0
"""Half the angle by which a wave turns over a step, rad, up to which the nodes integrate it as they are."""


def fourier(course: Course, signals: Reals, omega: float, count: int) -> Complexes:
    """Return c_n, (count, signals), of signals that are sums of Re c_n exp(i n omega t).

    They are given at the nodes of a motion that spans whole periods of omega, (nodes, signals).
    """
    times, weights = course.nodes.times, course.nodes.weights
    scale = 2.0 / course.duration
    weighted = scale * weights[:, None] * signals
    turn = np.exp(-1j * omega * times)
    wave = np.ones_like(turn)
    found = np.empty((count, signals.shape[1]), dtype=complex)
    lengths = weights.reshape(-1, NODES).sum(axis=1)
    middles, longest = 0.5 * (times[::NODES] + times[NODES - 1 :: NODES]), lengths.max(initial=0.0)
    for multiple in range(1, count + 1):
        wave = wave * turn
        used = wave
        if 0.5 * multiple * omega * longest > FAST:
            angles = 0.5 * multiple * omega * lengths
            fast = np.flatnonzero(angles > FAST)
            used = wave.copy().reshape(-1, NODES)
            middle = np.exp(-1j * multiple * omega * middles[fast])
            used[fast] = middle[:, None] * _projected(angles[fast])
            used = used.reshape(-1)
        found[multiple - 1] = used @ weighted
    return found


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
