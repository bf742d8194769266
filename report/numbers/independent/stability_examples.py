"""Examples of stability in numbers: a double integrator, and a loop whose plant is unstable."""

from __future__ import annotations

from dataclasses import dataclass

import control
import numpy as np
import sympy
from scipy.linalg import expm

from trimmer import encirclements


def growth_of_double_integrator(time: float) -> float:
    """Return the Frobenius norm of exp(A t) after a time (s)."""
    return float(np.linalg.norm(expm(time * np.array([[0.0, 1.0], [0.0, 0.0]]))))


def critical_point() -> int:
    """Return where the locus of G N is when 1 + G N = 0."""
    loop = sympy.Symbol("L")
    (point,) = sympy.solve(1 + loop, loop)
    return int(point)


@dataclass(frozen=True)
class UnstablePlant:
    """G = 2/(s − 1) with unit feedback; ``turns`` of its locus round a real point are counter-clockwise."""

    turns: dict[int, int]
    unstable_poles: int
    stable_in_loop: bool

    def points_that_agree(self) -> list[int]:
        """Return the points at which the Nyquist criterion says of the closed loop what is true."""
        counts = self.turns.items()
        return [point for point, count in counts if (count == self.unstable_poles) == self.stable_in_loop]


def unstable_plant() -> UnstablePlant:
    """Count the turns about −1 and about +1, and find the poles of plant and closed loop."""
    plant = control.tf([2], [1, -1])
    return UnstablePlant(
        turns={point: -encirclements(plant, point) for point in (-1, 1)},
        unstable_poles=sum(pole.real > 0 for pole in plant.poles()),
        stable_in_loop=all(pole.real < 0 for pole in control.feedback(plant, 1).poles()),
    )
