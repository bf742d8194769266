"""A load in the play of backlash: pushed, let go, in flight and in contact, in numbers."""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
import sympy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from derivations import assumed
from derivations.elements.backlash import CONTACT, GAMMA, SEPARATION, contact_force, contact_ratio
from derivations.elements.waveform import THETA
from derivations.symbols import A
from trimmer.arrays import Reals

STEP = 1e-6  # Of the sampled pin that lets a load go, s
STEPS = 20_000  # Steps of a period of the pin that is traced through its play


def free_speed(mass: sympy.Symbol, damping: sympy.Symbol) -> sympy.Expr:
    """Return v/v0 of a free load, the solution of M v' + D v = 0."""
    time, speed = assumed.positive("t"), sympy.Function("v")
    flight = sympy.Eq(mass * speed(time).diff(time) + damping * speed(time), 0)
    return sympy.dsolve(flight, speed(time), ics={speed(0): 1}).rhs


def speed_left(ratio: float, time: float) -> float:
    """Return v/v0 of a free load after a time (s) for M/D (s), by numeric integration."""
    run = solve_ivp(lambda _, speed: -speed / ratio, (0, time), [1.0], rtol=1e-12, atol=1e-14)
    return float(run.y[0, -1])


def contact_angle_by_bisection(gap_over_amplitude: float) -> float:
    """Return the phase over which a load without friction flies, rad: b/A = phi - sin(phi)."""
    low, high = 0.0, math.pi
    for _ in range(60):
        middle = (low + high) / 2
        ratio = middle - math.sin(middle)
        low, high = (middle, high) if ratio < gap_over_amplitude else (low, middle)
    return low


def zero_of_force(load: float) -> float:
    """Return the phase (rad) at which the pushing force of the rising contact reaches zero."""
    force = sympy.lambdify(THETA, contact_force(-1).subs({GAMMA: load, A: 1}), "math")
    return float(brentq(force, 0.0, math.pi / 2, xtol=1e-15))


def contact_by_equation(load: float, play: float, separation: float) -> float:
    """Return the phase of contact as the root of the derived contact equation; phases in rad."""
    ratio = contact_ratio().subs({SEPARATION: separation, GAMMA: load}) - play
    return float(brentq(sympy.lambdify(CONTACT, ratio, "math"), separation, separation + math.pi, xtol=1e-15))


def contact_after_flight(load: float, play: float, separation: float) -> float:
    """Integrate the flight from the pin's state at separation to where it meets the other side; in rad."""

    def meets(phase: float, state: list[float]) -> float:
        return state[0] - math.sin(phase) - play / 2

    flight = solve_ivp(
        lambda _, state: [state[1], -state[1] / load],
        (separation, separation + math.pi),
        [math.sin(separation) - play / 2, math.cos(separation)],
        events=meets,
        rtol=1e-12,
        atol=1e-13,
    )
    return float(flight.t_events[0][0])


@dataclass(frozen=True)
class LetGoLoad:
    """A load that a pin A sin ωt pushes; a constant friction force brings it to rest when it is let go."""

    amplitude: float  # A, m
    omega: float  # ω, rad/s
    deceleration: float  # By friction, m/s²

    @property
    def phase(self) -> float:
        """Phase of the pin when it lets the load go, rad: it begins to slow down faster than friction can."""
        return math.asin(self.deceleration / (self.amplitude * self.omega**2))

    @property
    def velocity(self) -> float:
        """Velocity with which it is let go, m/s."""
        return self.amplitude * self.omega * math.cos(self.phase)

    @property
    def seconds(self) -> float:
        """Time until it is at rest, s."""
        return self.velocity / self.deceleration

    def ahead(self) -> float:
        """Return how far ahead of the pin it comes to rest, m."""
        pin = self.amplitude * (math.sin(self.phase + self.omega * self.seconds) - math.sin(self.phase))
        return self.velocity**2 / (2 * self.deceleration) - pin

    def ahead_by_integration(self) -> float:
        """Return the same by integrating both motions, m."""
        speed = self.amplitude * self.omega
        flight = solve_ivp(
            lambda t, state: [state[1] - speed * math.cos(self.phase + self.omega * t), -self.deceleration],
            (0, self.seconds),
            [0.0, self.velocity],
            rtol=1e-10,
            atol=1e-14,
        )
        return float(flight.y[0, -1])

    def largest_acceleration(self) -> float:
        """Return the pin's largest acceleration by second differences over a period, m/s²."""
        times = np.arange(0, 2 * math.pi / self.omega, STEP)
        return float(np.abs(np.diff(self.amplitude * np.sin(self.omega * times), 2)).max()) / STEP**2


@cache
def traced(half_gap: float) -> tuple[Reals, Reals]:
    """Return phases (rad) of a period from the peak of a sine of amplitude one, and the outputs of play.

    The input starts in the middle of the gap, a quarter period before. The output stays unless the input is
    half a gap away and pushes it.
    """
    phases = 2 * np.pi / STEPS * np.arange(1.25 * STEPS)
    output, outputs = 0.0, []
    for position in np.sin(phases).tolist():
        output = min(max(output, position - half_gap), position + half_gap)
        outputs.append(output)
    start = STEPS // 4
    return phases[start:], np.array(outputs[start:])


def boundaries(half_gap: float) -> Reals:
    """Return the phases (rad) at which the output comes to rest or starts to move, in one period."""
    phases, outputs = traced(half_gap)
    moving = np.diff(outputs) != 0
    return np.append(phases[0], phases[1:-1][moving[1:] != moving[:-1]])


def outputs_at(half_gap: float, position: float) -> Reals:
    """Return the outputs of one period at those times at which the input passes a position."""
    phases, outputs = traced(half_gap)
    return outputs[np.flatnonzero(np.diff(np.sign(np.sin(phases) - position)))]
