"""Floquet multipliers of a return, and by how much rounding may have moved each."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np
import scipy.linalg

from trimmer.response.shooting import CLOSED

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.response.shooting import Shot

FAR = 0.5
"""Modulus of a multiplier below which it is far inside the unit circle, whatever its rounding."""
ROUNDING = 64 * float(np.finfo(float).eps)
"""Rounding of the derivative of a return in each of its segments, as a share of its norm."""


def multipliers_of(shot: Shot) -> tuple[Complexes, Reals]:
    """Return the eigenvalues of the derivative of a return, by falling modulus, and their rounding."""
    matrix = shot.monodromy * shot.sizes / shot.sizes[:, None]
    if not np.isfinite(matrix).all():
        raise np.linalg.LinAlgError("the derivative of the return is not finite")
    values = np.linalg.eigvals(matrix).astype(complex)
    values = values[np.argsort(-abs(values), kind="stable")]
    rounding = ROUNDING * (1 + len(shot.course.events)) + min(shot.miss, CLOSED)
    margins = np.zeros(len(values))
    for each, condition in zip(*_conditions(matrix), strict=True):
        nearest = np.argmin(abs(values - each) + (margins > 0) * abs(values).max())
        margins[nearest] = rounding * condition
    return values, margins


def _conditions(matrix: Reals) -> tuple[Complexes, Reals]:
    """Return the eigenvalues that may be near the unit circle, and their conditions times the norm.

    Those far inside, of which stick and contact make many at zero that cannot be told apart, are split off by
    a projection first (Golub and Van Loan, Matrix Computations, 2013, section 7.2). The units are such that
    rows and columns are of one size: sizes at events say little where there are few.
    """
    with np.errstate(all="ignore"):  # SciPy takes scales for places.
        balanced = scipy.linalg.matrix_balance(matrix, permute=False)[0]
    schur, count = _sorted_schur(balanced)
    large, rest, beside = schur[:count, :count], schur[count:, count:], schur[:count, count:]
    lean = 0.0
    if 0 < count < len(matrix):
        lean = float(np.linalg.norm(scipy.linalg.solve_sylvester(large, -rest, beside)))
    values, vectors = np.linalg.eig(large)
    try:
        left = np.linalg.inv(vectors)
    except np.linalg.LinAlgError:
        return values, np.full(count, np.inf)
    conditions = np.linalg.norm(left, axis=1) * np.linalg.norm(vectors, axis=0)
    return values, conditions * np.hypot(1.0, lean) * np.linalg.norm(balanced)


def _sorted_schur(matrix: Reals) -> tuple[Complexes, int]:
    """Return a complex Schur form with the large eigenvalues first, and their number."""
    for far in (FAR, 0.8 * FAR, 1.2 * FAR):  # One that lies just there cannot be sorted.
        with suppress(np.linalg.LinAlgError):
            schur, _, count = scipy.linalg.schur(
                matrix, output="complex", sort=lambda value, far=far: abs(value) >= far
            )
            return schur, count
    return scipy.linalg.schur(matrix, output="complex")[0], len(matrix)
