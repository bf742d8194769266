"""Textbook examples in numbers: a cubic spring, Van der Pol's oscillator, and examples of stability."""

from dataclasses import dataclass

import control
import mpmath
import numpy as np
import sympy
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from trimmer.arrays import Reals
from trimmer.linear import encirclements

CUBIC_SAMPLES, VAN_DER_POL_SAMPLES = 4096, 512
"""Samples of a period of the cubic spring's input, and of Van der Pol's limit cycle."""


def cubic_gain() -> float:
    """Return the describing function of y = x³ for an amplitude of one, sampled."""
    phases = 2 * np.pi * np.arange(CUBIC_SAMPLES) / CUBIC_SAMPLES
    return float(2 * np.mean(np.sin(phases) ** 4))


def cubic_frequency() -> float:
    """Return the exact frequency of a unit mass on the spring y = x³ with amplitude one, rad/s.

    A quarter period is an integral over the position.
    """
    return float(mpmath.pi / (2 * mpmath.quad(lambda x: 1 / mpmath.sqrt((1 - x**4) / 2), [0, 1])))


def van_der_pol_third_harmonic(damping: float) -> float:
    """Return the third harmonic of the limit cycle of x'' + α (x² − 1) x' + x = 0, over the first.

    It is that of the position, integrated over time, for α = ``damping``.
    """

    def flow(_: float, state: Reals) -> list[float]:
        position, velocity = state
        return [velocity, -damping * (position**2 - 1) * velocity - position]

    def upwards(_: float, state: Reals) -> float:
        return float(state[0])

    upwards.direction = 1  # type: ignore[attr-defined]
    settled = solve_ivp(flow, (0, 60), [2.0, 0.0], events=upwards, dense_output=True, rtol=1e-8, atol=1e-10)
    start, end = settled.t_events[0][-2:]
    period = settled.sol(np.linspace(start, end, VAN_DER_POL_SAMPLES, endpoint=False))[0]
    lines = np.abs(np.fft.rfft(period))
    return float(lines[3] / lines[1])


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
