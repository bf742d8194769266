"""A mechanism as a declared list of bodies, and of what holds, pushes and rubs them, with their two ends.

All motion is along one line. ``trimmer`` is that of the thesis (section 2.2.1 and figure 2.1b): the eccentric
pin sits on the motor's shaft, so its position is the motor's displacement plus the eccentric one.
"""

from dataclasses import dataclass, replace

import sympy

from derivations import symbols
from derivations.parts import (
    Contact,
    Control,
    Damper,
    End,
    Force,
    Friction,
    Ground,
    Joint,
    Output,
    Pin,
    Point,
    RigidBody,
    Spring,
    Structure,
    Tensioned,
)
from derivations.symbols import t


@dataclass(frozen=True)
class Mechanism:
    """Bodies on one line, or turning, and what holds, pushes and rubs them.

    Attributes:
        bodies: In the order of their coordinates.
        springs: All springs.
        dampers: All dampers.
        pins: All pins.
        contacts: All plays and stops, springs with a curve, and walls.
        frictions: All frictions.
        forces: All given forces.
        outputs: What is asked for.
        points: All points on levers and behind gears.
        structures: All linear parts given by matrices.
        controls: What controllers give, each of which is among the forces.
    """

    bodies: tuple[RigidBody, ...]
    springs: tuple[Spring, ...]
    dampers: tuple[Damper, ...]
    pins: tuple[Pin, ...] = ()
    contacts: tuple[Tensioned, ...] = ()
    frictions: tuple[Friction, ...] = ()
    forces: tuple[Force, ...] = ()
    outputs: tuple[Output, ...] = ()
    points: tuple[Point, ...] = ()
    structures: tuple[Structure, ...] = ()
    controls: tuple[Control, ...] = ()

    @property
    def resistances(self) -> tuple[Damper, ...]:
        """All that resists in proportion to a rate: the dampers, and viscous friction."""
        rubbing = (
            Damper(friction.viscous, friction.start, friction.end)
            for friction in self.frictions
            if friction.viscous != 0
        )
        return (*self.dampers, *rubbing)

    @property
    def is_linear(self) -> bool:
        """Whether springs, dampers, pins and given forces are all there is."""
        return not self.contacts and not self.frictions


def position(end: End) -> sympy.Expr:
    """Return the displacement of an end in the fixed frame, m."""
    match end:
        case Ground():
            return sympy.S.Zero
        case RigidBody():
            return end.coordinate
        case Point():
            return sympy.Add(*(weight * body.coordinate for body, weight in end.weights))
        case Pin():
            return position(end.carrier) + end.displacement


def displacement(force: Force) -> sympy.Expr:
    """Return the displacement along which a given force does work, m."""
    return position(force.on) - position(force.against)


def elongation(joint: Joint) -> sympy.Expr:
    """Return by how much a joint is longer than at rest, m: end minus start, in that order."""
    rest = joint.rest if isinstance(joint, Spring) else sympy.S.Zero
    ahead, behind = (sympy.Add.make_args(position(end)) for end in (joint.end, joint.start))
    terms = [term for term in (*ahead, *(-term for term in behind), -rest) if term != 0]
    return sympy.Add(*terms, evaluate=False) if len(terms) > 1 else sympy.Add(*terms)


def elongation_rate(joint: Joint) -> sympy.Expr:
    """Return the time derivative of the elongation, m/s, its terms in the same order."""
    rates = (term.diff(t) for term in sympy.Add.make_args(elongation(joint)))
    terms = [rate for rate in rates if rate != 0]
    return sympy.Add(*terms, evaluate=False) if len(terms) > 1 else sympy.Add(*terms)


def closed(mechanism: Mechanism) -> Mechanism:
    """Return the mechanism with every contact closed: springs and dampers stand in the places of contacts."""
    slots = [each for each in mechanism.contacts if isinstance(each, Contact)]
    springs = (
        Spring(each.stiffness, each.start, each.end, each.offset) for each in slots if each.stiffness != 0
    )
    dampers = (Damper(each.damping, each.start, each.end) for each in slots if each.damping != 0)
    return replace(
        mechanism,
        springs=(*mechanism.springs, *springs),
        dampers=(*mechanism.dampers, *dampers),
        contacts=tuple(each for each in mechanism.contacts if not isinstance(each, Contact)),
    )


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
        pins=(pin,),
    )
