"""Modes of the trimmer, damped and undamped."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.linalg import eig, eigh

from trimmer.arrays import Complexes
from trimmer.displacement import TrimmerBody
from trimmer.generated import linear_trimmer
from trimmer.parameters import TrimmerParameters, require_parameters
from trimmer.showing.shown import ShownFields


@dataclass(frozen=True)
class Mode(ShownFields):
    """A damped mode: a pair of conjugate eigenvalues, or one real eigenvalue.

    Attributes:
        eigenvalue: Eigenvalue of the state matrix, 1/s; of a pair, the one with positive imaginary part.
        shape: Displacements q1 to q4 relative to the largest of them, which is 1; complex, since damping
            makes the bodies move out of phase.
    """

    eigenvalue: complex
    shape: tuple[complex, ...]

    @property
    def omega_natural(self) -> float:
        """Natural angular frequency, rad/s: magnitude of the eigenvalue."""
        return abs(self.eigenvalue)

    @property
    def omega_damped(self) -> float:
        """Angular frequency at which the mode oscillates, rad/s; 0 for an overdamped one."""
        return self.eigenvalue.imag

    @property
    def frequency(self) -> float:
        """Frequency at which the mode oscillates, Hz; 0 for an overdamped one."""
        return self.omega_damped / (2 * math.pi)

    @property
    def damping_ratio(self) -> float:
        """Damping ratio, as in ``control.damp``: 1 for a real negative eigenvalue.

        It is 0 for an eigenvalue of 0, a drift that neither decays nor grows.
        """
        return -self.eigenvalue.real / self.omega_natural if self.eigenvalue else 0.0


@dataclass(frozen=True)
class UndampedMode(ShownFields):
    """A mode of the trimmer without its dampers.

    Attributes:
        omega: Natural angular frequency, rad/s.
        shape: Displacements q1 to q4 relative to the largest of them, which is 1.
    """

    omega: float
    shape: tuple[float, ...]


def modes(parameters: TrimmerParameters) -> tuple[Mode, ...]:
    """Find the modes (the eigenvalue problem of equation 2.22 of the thesis), by rising natural frequency.

    A pair of complex eigenvalues is one mode. Every real eigenvalue is a mode of its own, so an overdamped
    oscillator shows as two.

    Args:
        parameters: The trimmer, SI units.

    Returns:
        Four modes, or up to eight if some are overdamped.
    """
    require_parameters(parameters)
    A = np.array(linear_trimmer.state_matrix(*parameters.values()))
    # Time is scaled so that displacements and velocities are of one size; else real parts lose digits.
    n = len(TrimmerBody)
    scale = math.sqrt(np.abs(np.diag(A[n:, :n])).max()) or 1.0
    states = np.repeat([1.0, scale], n)
    eigenvalues, vectors = eig(A * states / states[:, None] / scale)
    found = (
        Mode(complex(value) * scale, tuple(_relative_to_largest(vector[:n]).tolist()))
        for value, vector in zip(eigenvalues, vectors.T, strict=True)
        if value.imag >= 0
    )
    return tuple(sorted(found, key=lambda mode: (mode.omega_natural, mode.omega_damped)))


def undamped_modes(parameters: TrimmerParameters) -> tuple[UndampedMode, ...]:
    """Find the four modes without damping (K v = omega^2 M v), by rising natural frequency.

    Args:
        parameters: The trimmer, SI units; its dampers do not count.
    """
    require_parameters(parameters)
    values = parameters.values()
    M = np.array(linear_trimmer.mass_matrix(*values))
    K = np.array(linear_trimmer.stiffness_matrix(*values))
    squares, vectors = eigh(K, M)
    return tuple(
        UndampedMode(math.sqrt(max(square, 0.0)), tuple(_relative_to_largest(vector).real.tolist()))
        for square, vector in zip(squares, vectors.T, strict=True)
    )


def _relative_to_largest(vector: Complexes) -> Complexes:
    largest = np.argmax(np.abs(vector))
    relative = vector / vector[largest]
    relative[largest] = 1.0  # exactly, where the division rounds
    return np.asarray(relative)
