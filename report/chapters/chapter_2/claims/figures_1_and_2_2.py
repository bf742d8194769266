"""Claims on the drawings of the trimmer: its parts, its free-body diagram, its pin (figures 1.1, 2.1, 2.2).

The drawings are lost; what the text and the names say of them is held against the derived equations.
"""

from __future__ import annotations

import sympy

from derivations.symbols import (
    A,
    c1,
    c2,
    c3,
    c4,
    coordinates,
    f,
    k1,
    k2,
    k3,
    k4,
    k5,
    masses,
    t,
    u,
    velocities,
)
from report.claim import Claim, Confirmation, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression, SameMatrix
from report.comparisons.printed import product
from report.evidence import Evidence

SOURCE = "derivations/mechanism.py"
NEWTON = "the forces on each body"
MOVING_PARTS = ("motor with its shell", "driving bridge", "cutter", "guard", "guard housing")
LOST = "The drawing itself was not at hand; it is drawn again from the text."


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_components(evidence), _free_body_diagram(evidence), _eccentric_pin())


def _matrix_of(function: sympy.Expr, variables: tuple[sympy.Expr, ...]) -> sympy.ImmutableMatrix:
    """Return the matrix of a quadratic form."""
    return sympy.ImmutableMatrix(sympy.hessian(function, variables))


def _by_newton(evidence: Evidence, variables: tuple[sympy.Expr, ...]) -> sympy.ImmutableMatrix:
    """Return minus the forces on the bodies for a unit of each variable."""
    accelerations = sympy.Matrix(evidence.derivation.newton)
    return sympy.ImmutableMatrix(-sympy.diag(*masses) * accelerations.jacobian(variables)).expand()


def _components(evidence: Evidence) -> Claim:
    return Claim(
        id="fig-1.1",
        parts=(_guard_is_carried(evidence), _cutter_and_bridge(evidence), _motor_to_cutter(evidence)),
        explanation=(
            "The connections that the text names are those of the equations. The bridge's stiffness $k_2$ "
            "lies between the pin and the one body that bridge and cutter make; the coil spring, which "
            f"presses the cutter on the guard, ties the cutter to the guard housing along the motion. {LOST}"
        ),
        source=SOURCE,
    )


def _guard_is_carried(evidence: Evidence) -> Part:
    stiffness = _by_newton(evidence, coordinates)
    to_surroundings = stiffness * sympy.ones(len(coordinates), 1)
    return Part(
        "guard to guard housing, guard housing to plastic housing",
        Assertion(
            statement="the guard is carried by the guard housing, and this by the plastic housing",
            derived=stiffness[3, 2] != 0 and to_surroundings[2] != 0 and to_surroundings[3] == 0,
            evidence=(
                f"the guard is tied by ${sympy.latex(-stiffness[3, 2])}$ to its housing and by nothing to "
                f"the surroundings, the housing by ${sympy.latex(to_surroundings[2])}$"
            ),
            method="forces on each body for a unit of each displacement",
        ),
        Confirmation(
            "the second derivatives of the potential energy",
            SameMatrix(_matrix_of(evidence.derivation.potential_energy, coordinates).expand(), stiffness),
        ),
    )


def _count_of_bodies(evidence: Evidence) -> Confirmation:
    bodies = evidence.derivation.mechanism.bodies
    return Confirmation("a count of the bodies", CloseNumbers(len(bodies), len(MOVING_PARTS) - 1))


def _cutter_and_bridge(evidence: Evidence) -> Part:
    degrees_of_freedom = _matrix_of(evidence.derivation.kinetic_energy, velocities).rank()
    return Part(
        "cutter and driving bridge",
        Assertion(
            statement="cutter and driving bridge are one rigid body",
            derived=degrees_of_freedom == len(MOVING_PARTS) - 1,
            evidence=(
                f"of {', '.join(MOVING_PARTS)} only {degrees_of_freedom} move by themselves: cutter and "
                "bridge share a mass and a displacement"
            ),
            method="rank of the mass matrix",
        ),
        _count_of_bodies(evidence),
    )


def _motor_to_cutter(evidence: Evidence) -> Part:
    motor = coordinates[0]
    on_the_cutter = sympy.expand(evidence.derivation.newton[1])
    beyond_pin = sympy.expand(evidence.derivation.potential_energy - k1 * motor**2 / 2)
    return Part(
        "motor to cutter",
        Assertion(
            statement="motor and cutter are linked at the pin alone, where the play is",
            derived=sympy.expand(beyond_pin.diff(motor) - beyond_pin.diff(u)) == 0,
            evidence="beyond its own mount, the motor's displacement enters as $q_1 + u$ alone",
            method="derivatives of the potential energy",
        ),
        Confirmation(
            "the forces on the cutter",
            SameExpression(on_the_cutter.diff(motor), on_the_cutter.diff(u)),
        ),
    )


def _free_body_diagram(evidence: Evidence) -> Claim:
    derivation = evidence.derivation
    printed_stiffness = sympy.ImmutableMatrix(
        [[k1 + k2, -k2, 0, 0], [-k2, k2 + k5, -k5, 0], [0, -k5, k3 + k4 + k5, -k4], [0, 0, -k4, k4]]
    )
    printed_damping = sympy.ImmutableMatrix(
        [[c1 + c2, -c2, 0, 0], [-c2, c2, 0, 0], [0, 0, c3 + c4, -c4], [0, 0, -c4, c4]]
    )
    stiffness = _matrix_of(derivation.potential_energy, coordinates)
    damping = _matrix_of(derivation.rayleigh_function, velocities)
    pin = sympy.ImmutableMatrix([derivation.potential_energy.diff(u, q) for q in coordinates]).expand()
    moving_together = (stiffness * sympy.ones(len(coordinates), 1)).expand()
    return Claim(
        id="fig-2.1",
        parts=(
            Part(
                "number of masses",
                PrintedDigits("4", _matrix_of(derivation.kinetic_energy, velocities).rank()),
                _count_of_bodies(evidence),
            ),
            _matrix_part("springs", printed_stiffness, stiffness, _by_newton(evidence, coordinates)),
            _matrix_part("dampers", printed_damping, damping, _by_newton(evidence, velocities)),
            _matrix_part(
                "where the pin's displacement acts",
                sympy.ImmutableMatrix([k2, -k2, 0, 0]),
                pin,
                _by_newton(evidence, (u,)),
            ),
            Part(
                "springs with a fixed end",
                SameMatrix(sympy.ImmutableMatrix([k1, 0, k3, 0]), sympy.ImmutableMatrix(moving_together)),
            ),
        ),
        explanation=(
            "Read with the names in the text (motor, driving bridge, housing, guard, coil spring), the "
            "diagram's four masses, five springs and four dampers give the printed matrices, by energies as "
            f"by forces. Moved together, the masses load the two springs with a fixed end alone. {LOST}"
        ),
        source=SOURCE,
    )


def _matrix_part(
    label: str,
    printed: sympy.ImmutableMatrix,
    derived: sympy.ImmutableMatrix,
    by_newton: sympy.ImmutableMatrix,
) -> Part:
    return Part(label, SameMatrix(printed, derived), Confirmation(NEWTON, SameMatrix(by_newton, derived)))


def _eccentric_pin() -> Claim:
    printed = A * sympy.sin(2 * sympy.pi * f * t)
    angle = sympy.Symbol("theta", real=True)
    turn = sympy.Matrix([[sympy.cos(angle), sympy.sin(angle)], [-sympy.sin(angle), sympy.cos(angle)]])
    across = (turn * sympy.Matrix([0, A]))[0]
    stroke = sympy.maximum(across, angle) - sympy.minimum(across, angle)
    return Claim(
        id="fig-2.2",
        parts=(
            Part(
                "displacement of the pin",
                SameExpression(printed, across.subs(angle, 2 * sympy.pi * f * t), left=sympy.Symbol("x_i")),
                Confirmation(
                    "its acceleration towards the axis", SameExpression(_from_acceleration(), printed)
                ),
            ),
            Part(
                "half of the stroke is the eccentricity",
                SameExpression(product(A), stroke / 2),
            ),
        ),
        explanation=(
            "A point at distance $A$ from the axis, turned $f$ times a second, is displaced as printed along "
            "the motion, and $A$ is the amplitude as the caption says. Since the bridge's edges are flat and "
            "stand across the motion, the pin's own radius drops out and the bridge gets the same sine. The "
            "displacement is relative to the motor, as in the energies."
        ),
        source="derivations/symbols.py",
    )


def _from_acceleration() -> sympy.Expr:
    """Return the displacement whose acceleration is (2 π f)² times it, towards the axis."""
    displaced = sympy.Function("x")
    rate = 2 * sympy.pi * f
    start = {displaced(0): 0, displaced(t).diff(t).subs(t, 0): A * rate}
    equation = sympy.Eq(displaced(t).diff(t, 2), -(rate**2) * displaced(t))
    return sympy.dsolve(equation, displaced(t), ics=start).rhs
