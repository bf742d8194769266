"""A load with inertia and friction that leaves the wall of a gap: separation, flight and contact, in numbers.

The pin moves as sin θ. ``load`` is M ω / D, ``play`` the gap over the pin's amplitude.
"""

from __future__ import annotations

import math

import sympy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from derivations.elements.backlash import CONTACT, GAMMA, SEPARATION, contact_force, contact_ratio
from derivations.elements.waveform import THETA
from derivations.symbols import A


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

    meets.terminal = True  # type: ignore[attr-defined]
    flight = solve_ivp(
        lambda _, state: [state[1], -state[1] / load],
        (separation, separation + math.pi),
        [math.sin(separation) - play / 2, math.cos(separation)],
        events=meets,
        rtol=1e-12,
        atol=1e-13,
    )
    return float(flight.t_events[0][0])
