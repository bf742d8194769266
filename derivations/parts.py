"""The parts of a mechanism that moves along one line, in symbols.

Units are those of translations; a rotation has rad in place of m, N m of N, kg m² of kg, and so on.
"""

from dataclasses import dataclass, field
from enum import Enum

import sympy


@dataclass(frozen=True)
class Ground:
    """The fixed surroundings, whose displacement is zero."""


@dataclass(frozen=True)
class RigidBody:
    """A rigid body that moves along one line, or turns."""

    name: str  # What it is, in words
    mass: sympy.Expr  # Mass, kg, or moment of inertia, kg m²
    coordinate: sympy.Expr  # Displacement in the fixed frame, m, or angle, rad, a function of time
    turns: bool = False  # Whether it is an angle


@dataclass(frozen=True)
class Structure:
    """A linear part given by matrices, whose coordinates stand among the bodies, one after the other.

    Attributes:
        name: What it is, in words.
        bodies: Its n coordinates; the mass of each is that on the diagonal.
        mass, damping, stiffness: M, C and K, n × n.
        mobility: M⁻¹, n × n, whose entries are symbols of their own.
    """

    name: str
    bodies: tuple[RigidBody, ...]
    mass: sympy.ImmutableMatrix
    damping: sympy.ImmutableMatrix
    stiffness: sympy.ImmutableMatrix
    mobility: sympy.ImmutableMatrix

    @property
    def coordinates(self) -> sympy.ImmutableMatrix:
        """The displacements, n × 1."""
        return sympy.ImmutableMatrix([body.coordinate for body in self.bodies])


@dataclass(frozen=True)
class Point:
    """A massless point whose displacement is a weighted sum of coordinates, as on a lever or behind a gear.

    Attributes:
        displacement: m, or rad, a function of time.
        weights: Each body with its factor: a ratio, or the arm, m, of one that turns.
    """

    displacement: sympy.Expr
    weights: tuple[tuple[RigidBody, sympy.Expr], ...]


@dataclass(frozen=True)
class Pin:
    """A massless point whose displacement relative to a body, a point or the ground is given.

    Attributes:
        carrier: The body or point, or the ground for a moved base.
        displacement: Displacement relative to it, m, a function of time.
        law: The same written out over time; None where it is left open.
    """

    carrier: RigidBody | Point | Ground
    displacement: sympy.Expr
    law: sympy.Expr | None = None


End = Ground | RigidBody | Point | Pin


@dataclass(frozen=True)
class Spring:
    """A linear spring."""

    stiffness: sympy.Expr  # Stiffness, N/m
    start: End  # One end
    end: End  # The other end; the elongation is its displacement less that of ``start`` and less ``rest``
    rest: sympy.Expr = sympy.S.Zero  # Distance of the ends at which it carries nothing, m


@dataclass(frozen=True)
class Damper:
    """A linear damper."""

    damping: sympy.Expr  # Coefficient, N s/m
    start: End  # One end
    end: End  # The other end, as for a spring


class ContactLaw(Enum):
    """What a contact does when its force would have to pull.

    A relaxing contact ends there, and its spring relaxes by itself (Nordin, Galić and Gutman, Int. J. Adapt.
    Control Signal Process. 11, 1997); a truncated one ends there too, but has no memory; a pulling one lasts
    until the gap is reached again (Kelvin-Voigt).
    """

    RELAXING = 1
    TRUNCATED = 2
    PULLING = 3


@dataclass(frozen=True)
class Contact:
    """A spring and a damper side by side behind a slot; ``Play`` and ``Stop`` are the two kinds."""

    name: str  # What it is, in words
    stiffness: sympy.Expr  # k, N/m
    damping: sympy.Expr  # c, N s/m
    gap: sympy.Expr  # g, m
    start: End  # One end
    end: End  # The other end
    distance: sympy.Expr  # s, displacement of ``end`` less that of ``start``, m, a function of time
    stretch: sympy.Expr  # z, stretch of the spring, m, a function of time
    tension: sympy.Expr  # T = k z + c ż, N, a function of time; positive it pulls the ends together
    law: ContactLaw  # What it does when its force would have to pull

    @property
    def offset(self) -> sympy.Expr:
        """Distance of the ends at which the closed contact carries nothing, m."""
        raise NotImplementedError


@dataclass(frozen=True)
class Play(Contact):
    """A contact on both sides of a slot, whose gap is the total clearance.

    Attributes:
        side: σ, 1 where ``end`` is ahead of ``start``, -1 on the other side of the slot.
    """

    side: sympy.Expr

    @property
    def offset(self) -> sympy.Expr:
        """Half of the gap, on the side of the contact, m."""
        return self.side * self.gap / 2


@dataclass(frozen=True)
class Stop(Contact):
    """A contact on one side, while ``end`` is farther from ``start`` than the gap."""

    @property
    def offset(self) -> sympy.Expr:
        """The gap, m."""
        return self.gap


@dataclass(frozen=True)
class Wall:
    """A rigid wall: end less start is never more than the gap, and rebounds there.

    Attributes:
        name: What it is, in words.
        start: One end.
        end: The other end.
        restitution: e, speed after an impact over that before it.
        gap: g, m.
        distance: s, displacement of ``end`` less that of ``start``, m, a function of time.
        tension: T, N, a function of time: what holds the ends together while they rest at the gap.
    """

    name: str
    start: End
    end: End
    restitution: sympy.Expr
    gap: sympy.Expr
    distance: sympy.Expr
    tension: sympy.Expr


Points = tuple[tuple[sympy.Expr, sympy.Expr], ...]
"""Points of a curve: an elongation, m, or a speed, m/s, and the force there, N."""


@dataclass(frozen=True)
class CurvedSpring:
    """A spring whose force is straight between points, and beyond the outer ones."""

    name: str  # What it is, in words
    start: End  # One end
    end: End  # The other end
    distance: sympy.Expr  # s, displacement of ``end`` less that of ``start``, m, a function of time
    tension: sympy.Expr  # T, N, a function of time; positive it pulls the ends together
    points: Points  # The points of the curve


@dataclass(frozen=True)
class Friction:
    """Dry friction with stick, and viscous friction beside it.

    Attributes:
        name: What it is, in words.
        kinetic: Force in sliding, N.
        static: Largest force in stick, N.
        viscous: Coefficient, N s/m.
        start: One end.
        end: The other end.
        rate: v, velocity of ``end`` less that of ``start``, m/s, a function of time.
        force: Dry share of the force, N, a function of time; positive it holds ``end`` back.
        points: The force in sliding over the speed, where it changes with it.
    """

    name: str
    kinetic: sympy.Expr
    static: sympy.Expr
    viscous: sympy.Expr
    start: End
    end: End
    rate: sympy.Expr
    force: sympy.Expr
    points: Points = ()


@dataclass(frozen=True)
class Force:
    """A given force on a body or a point.

    Attributes:
        on: The body or point.
        value: The force, N, a function of time.
        law: The same written out over time; None where it is left open.
        against: What the opposite of the force acts on; the ground takes it without moving.
    """

    on: RigidBody | Point | Ground
    value: sympy.Expr
    law: sympy.Expr | None = None
    against: RigidBody | Point | Ground = field(default_factory=Ground)


@dataclass(frozen=True)
class Control:
    """What a controller gives: a force that stands among the given ones."""

    name: str  # What it is, in words
    value: sympy.Expr  # The force, N, a function of time
    told: str  # What it measures and follows, in a sentence
    lines: tuple[str, ...]  # Its law in formulas, LaTeX, with numbers in SI units


@dataclass(frozen=True)
class Output:
    """What is asked for: a weighted sum of motions of bodies, points and pins, or a force.

    Attributes:
        value: A function of time.
        weights: Each body, point or pin with its factor; none of a force.
        order: How often displacements are differentiated.
        force: The force, N; None of a motion.
    """

    value: sympy.Expr
    weights: tuple[tuple[RigidBody | Point | Pin, sympy.Expr], ...]
    order: int = 0
    force: sympy.Expr | None = None


Tensioned = Contact | CurvedSpring | Wall  # What acts by a tension of its own law
Joint = Spring | Damper | Tensioned | Friction
