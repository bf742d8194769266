"""Displacements of the four bodies under sinusoidal forces, from the matrices of figure 2.1: a second way.

The matrices are written down by hand, as springs and dampers stand in the figure; nothing is derived.
"""

from __future__ import annotations

import numpy as np

from trimmer import TrimmerParameters
from trimmer.arrays import Complexes, Reals

BY_THE_PIN = np.array([-1.0, 1.0, 0.0, 0.0])
"""Directions of the forces that a displacement of the pin makes on the bodies, per unit of k2."""
BY_FRICTION = np.array([0.0, 1.0, 0.0, -1.0])
"""Directions of the forces of friction on cutter and guard."""


def displacements(parameters: TrimmerParameters, omega: float, forces: Complexes | Reals) -> Complexes:
    """Solve (K + jωC - ω²M) q = F for the four displacements, m.

    Args:
        parameters: The trimmer.
        omega: rad/s.
        forces: Complex amplitudes of the forces on the bodies, N, shape (4,).
    """
    p = parameters
    stiffness = np.array(
        [
            [p.k1 + p.k2, -p.k2, 0, 0],
            [-p.k2, p.k2 + p.k5, -p.k5, 0],
            [0, -p.k5, p.k3 + p.k4 + p.k5, -p.k4],
            [0, 0, -p.k4, p.k4],
        ]
    )
    damping = np.array(
        [[p.c1 + p.c2, -p.c2, 0, 0], [-p.c2, p.c2, 0, 0], [0, 0, p.c3 + p.c4, -p.c4], [0, 0, -p.c4, p.c4]]
    )
    mass = np.diag([p.m1, p.m2, p.m3, p.m4])
    return np.asarray(np.linalg.solve(stiffness + 1j * omega * damping - omega**2 * mass, forces))
