"""The direction that a matrix maps to nothing, with a sign that does not turn on rounding."""

from __future__ import annotations

import numpy as np
from scipy.linalg import lapack

from trimmer.arrays import Reals


def null_vector(matrix: Reals) -> Reals:
    """Return the unit vector, shape (n,), that a matrix (m, n) makes smallest.

    Either sign would do, and LAPACK's differs between processors. Here the first entry of at least half the
    largest modulus is positive, so that a branch is followed in the same way everywhere.
    """
    return _signed(np.asarray(np.linalg.svd(matrix)[2][-1]))


def normal_to(matrix: Reals) -> tuple[Reals, float]:
    """Return the unit vector across all rows of a matrix (n, n + 1), and the determinant of these and it.

    Householder's reflections give both at once (Golub and Van Loan, Matrix Computations, 2013, section 5.2).
    What is not finite gives a determinant that is not either.
    """
    factors, scales, _, _ = lapack.dgeqrf(matrix.T)
    last = np.zeros((len(factors), 1))
    last[-1] = 1.0
    vector = lapack.dormqr("L", "N", factors, scales, last, 1)[0][:, 0]
    turn = (-1.0) ** int(np.count_nonzero(scales)) * float(np.prod(factors.diagonal()))
    signed = _signed(vector)
    return signed, turn * float(np.sign(signed @ vector))


def _signed(vector: Reals) -> Reals:
    """Return a vector or its opposite, of which the first large entry is positive."""
    moduli = abs(vector)
    leading = vector[np.argmax(moduli >= 0.5 * moduli.max())]
    return np.asarray(vector * np.copysign(1.0, leading))
