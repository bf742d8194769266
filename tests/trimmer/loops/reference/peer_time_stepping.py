"""Motions of the trimmer with any frictions by time stepping (Moreau and Jean), by SciPy's least squares.

Velocities are implicit: M (v+ - v) = h (force at the midpoint) - Dᵀ p with p in h F Sign(D v+), which is a
convex problem with a unique v+. No events are sought, and the method is of first order where frictions stick
or slip.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import lsq_linear

from tests.trimmer.loops.reference.peer_trimmer import PUSH, PeerTrimmer
from trimmer.arrays import Reals


def time_stepping(trimmer: PeerTrimmer, steps: int, duration: float) -> Reals:
    """Return the displacements after each step from rest, (4, steps); the pin is rigid and driven."""
    assert trimmer.drive is not None and trimmer.gap is None and not trimmer.velocity_too
    amplitude, omega = trimmer.drive
    masses, C, K = trimmer.matrices()
    D = np.array([each.row for each in trimmer.frictions])
    h = duration / steps
    limits = h * np.array([each.force for each in trimmer.frictions])
    implicit = np.diag(masses) + 0.5 * h * C + 0.25 * h**2 * K
    explicit = np.diag(masses) - 0.5 * h * C - 0.25 * h**2 * K
    root = np.linalg.inv(np.linalg.cholesky(implicit))
    q, v, course = np.zeros(4), np.zeros(4), np.empty((4, steps))
    for step in range(steps):
        push = trimmer.parameters.k2 * amplitude * math.sin(omega * h * (step + 0.5)) * PUSH
        impulse = explicit @ v - h * K @ q + h * push
        held = lsq_linear(root @ D.T, root @ impulse, (-limits, limits), method="bvls").x
        following = root.T @ (root @ (impulse - D.T @ held))
        q, v = q + 0.5 * h * (v + following), following
        course[:, step] = q
    return course
