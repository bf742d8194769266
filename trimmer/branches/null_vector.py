"""The direction that a matrix maps to nothing, with a sign that does not turn on rounding."""

from __future__ import annotations

import numpy as np

from trimmer.arrays import Reals


def null_vector(matrix: Reals) -> Reals:
    """Return the unit vector, shape (n,), that a matrix (m, n) makes smallest.

    Either sign would do, and LAPACK's differs between processors. Here the first entry of at least half the
    largest modulus is positive, so that a branch is followed in the same way everywhere.
    """
    vector = np.asarray(np.linalg.svd(matrix)[2][-1])
    moduli = abs(vector)
    leading = vector[np.argmax(moduli >= 0.5 * moduli.max())]
    return np.asarray(vector * np.copysign(1.0, leading))
