"""A load in the play of backlash: blocks run sample by sample, and flight between the walls."""

from __future__ import annotations

import math
from collections.abc import Callable

import control
import numpy as np
import sympy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from trimmer.arrays import Reals


def stepped(block: Callable[[float, float, float], float], pins: Reals, gap: float) -> Reals:
    """Return the loads (m) that a block leaves from rest, called with pin, gap and its last load (m)."""
    load, loads = 0.0, []
    for pin in pins:
        load = block(float(pin), gap, load)
        loads.append(load)
    return np.array(loads)


def stepped_by_library(pins: Reals, gap: float) -> Reals:
    """Return the output of python-control's backlash from rest for each position of the pin (m), m."""
    block = control.friction_backlash_nonlinearity(gap)
    return np.array([block(float(pin)) for pin in pins])


def free_speed(mass: sympy.Symbol, damping: sympy.Symbol) -> sympy.Expr:
    """Return v/v0 of a free load, the solution of M v' + D v = 0."""
    time, speed = sympy.Symbol("t", positive=True), sympy.Function("v")
    flight = sympy.Eq(mass * speed(time).diff(time) + damping * speed(time), 0)
    return sympy.dsolve(flight, speed(time), ics={speed(0): 1}).rhs


def speed_left(ratio: float, time: float) -> float:
    """Return v/v0 of a free load after a time (s) for M/D (s), by numeric integration."""
    run = solve_ivp(lambda _, speed: -speed / ratio, (0, time), [1.0], rtol=1e-12, atol=1e-14)
    return float(run.y[0, -1])


def phase_of_flight(gap: float) -> float:
    """Return the phase (rad) over which a load without friction flies, for a gap over the amplitude."""
    return float(brentq(lambda angle: angle - math.sin(angle) - gap, 0.0, 1.0))
