"""Antiresonances of the trimmer: from zeros of a transfer function, and from mass and stiffness alone."""

from __future__ import annotations

import control
import numpy as np

from trimmer import TrimmerParameters, linear_model
from trimmer.arrays import Reals


def antiresonances(system: control.TransferFunction) -> Reals:
    """Return the imaginary parts of the zeros, rising, rad/s."""
    zeros = np.roots(system.num[0][0])
    return np.sort(zeros.imag[zeros.imag > 0])


def antiresonances_without_damping(parameters: TrimmerParameters, weights: Reals) -> Reals:
    """Return where an output of the undamped system stays zero, rad/s; ``weights`` are those of q1 to q4.

    There (K - ω² M) q = F p with w·q = 0: a bordered matrix without inverse.
    """
    model = linear_model(parameters)
    flow, force = np.asarray(model.A)[4:, :4], np.asarray(model.B)[4:, :1]
    omegas = np.linspace(100.0, 9000.0, 20_000)
    bordered = np.zeros((omegas.size, 5, 5))
    bordered[:, :4, :4] = -flow - omegas[:, None, None] ** 2 * np.eye(4)
    bordered[:, :4, 4:], bordered[:, 4, :4] = force, weights
    values = np.linalg.det(bordered)
    places = np.flatnonzero(np.diff(np.sign(values)))
    share = values[places] / (values[places] - values[places + 1])
    return omegas[places] + share * (omegas[places + 1] - omegas[places])
