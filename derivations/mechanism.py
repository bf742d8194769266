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
    """The fixed surroundings, whose displacement is zero."""


@dataclass(frozen=True)
class RigidBody:
    """A rigid body that moves along one line.

    Attributes:
        name: What it is, in words.
        mass: Mass, kg.
        coordinate: Displacement in the fixed frame, m, a function of time.
    """

    name: str
    mass: sympy.Expr
    coordinate: sympy.Expr


@dataclass(frozen=True)
class Pin:
    """A massless point whose displacement relative to a body is given.

    Attributes:
        carrier: The body.
        displacement: Displacement relative to it, m, a function of time.
    """

    carrier: RigidBody
    displacement: sympy.Expr


End = Ground | RigidBody | Pin


@dataclass(frozen=True)
class Spring:
    """A linear spring.

    Attributes:
        stiffness: Stiffness, N/m.
        start: One end.
        end: The other end; the elongation is its displacement less that of ``start``.
    """

    stiffness: sympy.Expr
    start: End
    end: End


@dataclass(frozen=True)
class Damper:
    """A linear damper.

    Attributes:
        damping: Coefficient, N s/m.
        start: One end.
        end: The other end, as for a spring.
    """

    damping: sympy.Expr
    start: End
    end: End


@dataclass(frozen=True)
class Mechanism:
    """A chain of bodies, springs and dampers that a pin drives.

    Attributes:
        bodies: In the order of their coordinates.
        springs: All springs.
        dampers: All dampers.
        pin: The pin.
    """

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
    """Return by how much a spring or damper is longer than at rest, m: end minus start, in that order."""
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
