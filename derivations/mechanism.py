"""The trimmer as a declared list of bodies, springs and dampers with their two ends.

Source: thesis, section 2.2.1 and figure 2.1b. The eccentric pin sits on the motor's shaft, so its position
is the motor's displacement plus the eccentric one.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy

from derivations import symbols
from derivations.symbols import t


@dataclass(frozen=True)
class Ground:
    """The fixed surroundings."""


@dataclass(frozen=True)
class RigidBody:
    """A rigid body that moves along one line: its mass (kg) and its displacement (m, function of time)."""

    name: str
    mass: sympy.Expr
    coordinate: sympy.Expr


@dataclass(frozen=True)
class Pin:
    """A massless point that is driven by a known displacement (m) relative to the body that carries it."""

    carrier: RigidBody
    displacement: sympy.Expr


End = Ground | RigidBody | Pin


@dataclass(frozen=True)
class Spring:
    """A linear spring of given stiffness (N/m) between two ends."""

    stiffness: sympy.Expr
    start: End
    end: End


@dataclass(frozen=True)
class Damper:
    """A linear damper of given coefficient (N s/m) between two ends."""

    damping: sympy.Expr
    start: End
    end: End


@dataclass(frozen=True)
class Mechanism:
    """Bodies, springs and dampers, and the pin that drives them."""

    bodies: tuple[RigidBody, ...]
    springs: tuple[Spring, ...]
    dampers: tuple[Damper, ...]
    pin: Pin


def position(end: End) -> sympy.Expr:
    """Return the displacement of an end in the fixed frame, m."""
    match end:
        case Ground():
            return sympy.Integer(0)
        case RigidBody():
            return end.coordinate
        case Pin():
            return end.carrier.coordinate + end.displacement


def elongation(element: Spring | Damper) -> sympy.Expr:
    """Return by how much an element is longer than at rest, m, as end minus start in that order."""
    start, end = position(element.start), position(element.end)
    terms = (end, *(-term for term in sympy.Add.make_args(start) if term != 0))
    return sympy.Add(*terms, evaluate=False) if len(terms) > 1 else end


def elongation_rate(element: Spring | Damper) -> sympy.Expr:
    """Return the time derivative of the elongation, m/s, its terms in the same order."""
    terms = [term.diff(t) for term in sympy.Add.make_args(elongation(element))]
    return sympy.Add(*terms, evaluate=False) if len(terms) > 1 else terms[0]


def trimmer() -> Mechanism:
    """Return the trimmer of the thesis: four bodies, five springs, four dampers, driven by the pin."""
    motor = RigidBody("motor", symbols.m1, symbols.q1)
    cutter = RigidBody("cutter", symbols.m2, symbols.q2)
    housing = RigidBody("guard housing", symbols.m3, symbols.q3)
    guard = RigidBody("guard", symbols.m4, symbols.q4)
    pin = Pin(motor, symbols.u)
    ground = Ground()
    return Mechanism(
        bodies=(motor, cutter, housing, guard),
        springs=(
            Spring(symbols.k1, ground, motor),
            Spring(symbols.k2, pin, cutter),
            Spring(symbols.k3, ground, housing),
            Spring(symbols.k4, housing, guard),
            Spring(symbols.k5, housing, cutter),
        ),
        dampers=(
            Damper(symbols.c1, ground, motor),
            Damper(symbols.c2, pin, cutter),
            Damper(symbols.c3, ground, housing),
            Damper(symbols.c4, housing, guard),
        ),
        pin=pin,
    )
