"""What several frictions that stick at once do: their forces, and when no split of these is admissible.

With J the directions of the frictions, a = M^-1 (f + J^T force) and J a + b = 0. In a ring the forces are
determined only up to the null space of J^T. By duality of linear programming some split obeys
|force_i| <= limit_i if and only if ``|w @ force| <= sum(limit |w|)`` for each vector w of smallest support
that is orthogonal to that null space. Without a ring these w are the unit vectors.
"""

import itertools
from dataclasses import dataclass

import numpy as np
from scipy.linalg import null_space
from scipy.optimize import linprog

RANK = 1e-9


@dataclass(frozen=True)
class Sticking:
    """Frictions that stick together."""

    directions: np.ndarray  # J, one row per friction
    null: np.ndarray  # Null space of J^T, one column per dimension
    forces: np.ndarray  # Rows of one split of the forces
    mismatch: np.ndarray  # Rows that are zero if all can stick at once

    def excesses(self) -> np.ndarray:
        """The vectors w, one per row."""
        return smallest_supports(self.null)


def stick_together(
    directions: np.ndarray, mass: np.ndarray, force: np.ndarray, prescribed: np.ndarray
) -> Sticking:
    """Return the forces that keep relative accelerations zero.

    Args:
        directions: J.
        mass: Matrix of all bodies.
        force: Rows of all other forces on the bodies.
        prescribed: Rows b of the prescribed relative accelerations.
    """
    scaled = np.linalg.solve(np.linalg.cholesky(mass), directions.T).T
    length = np.linalg.norm(scaled, axis=1)
    length[length == 0] = 1.0
    unit = scaled / length[:, None]
    wanted = -(prescribed + directions @ np.linalg.solve(mass, force)) / length[:, None]
    forces = np.linalg.pinv(unit @ unit.T, rcond=RANK, hermitian=True) @ wanted / length[:, None]
    null = null_space(unit.T, rcond=RANK) / length[:, None]
    return Sticking(directions, null, forces, null.T @ prescribed)


def smallest_supports(null: np.ndarray) -> np.ndarray:
    """Return the vectors of smallest support that are orthogonal to the columns, each once."""
    count, dimension = null.shape
    if dimension == 0:
        return np.eye(count)
    found: list[np.ndarray] = []
    for zeros in itertools.combinations(range(count), count - dimension - 1):
        w = null_space(np.vstack([null.T, np.eye(count)[list(zeros)]]), rcond=RANK)
        if w.shape[1] == 1:
            vector = np.where(np.abs(w[:, 0]) > RANK, w[:, 0], 0.0)
            vector /= vector[np.argmax(np.abs(vector) > 0)]
            if not any(np.allclose(vector, other) for other in found):
                found.append(vector)
    return np.array(found).reshape(-1, count)


def at_limit_in_every_split(
    forces: np.ndarray, null: np.ndarray, limits: np.ndarray, near: float
) -> list[int]:
    """Return the frictions whose force has the size of its limit in all admissible splits."""
    allowed = np.r_[limits - forces, limits + forces] + near * np.r_[limits, limits]
    found = []
    for place, limit in enumerate(limits):
        if null.shape[1] == 0:
            low = high = forces[place]
        else:
            problem = {"A_ub": np.vstack([null, -null]), "b_ub": allowed, "bounds": (None, None)}
            least = linprog(null[place], **problem, method="highs")
            most = linprog(-null[place], **problem, method="highs")
            if not (least.success and most.success):
                continue
            low, high = forces[place] + least.fun, forces[place] - most.fun
        if low >= limit * (1 - 10 * near) or high <= -limit * (1 - 10 * near):
            found.append(place)
    return found
