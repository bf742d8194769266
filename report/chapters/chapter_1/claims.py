"""Claims on the drawing of the trimmer (figure 1.1), of which only the text about it is left."""

import sympy

from derivations.symbols import coordinates, stiffnesses, u, velocities
from report.chapters.chapter_2.claims.section_2_2_1 import by_newton, matrix_of
from report.judging.parts import assertion, equal, same
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence

MOVING_PARTS = ("motor with its shell", "driving bridge", "cutter", "guard", "guard housing")


@claim("fig-1.1")
def components(known: Evidence) -> Record:
    potential, on_the_cutter = known.derivation.potential_energy, sympy.expand(known.derivation.newton[1])
    stiffness, motor = by_newton(known, coordinates), coordinates[0]
    to_surroundings = stiffness * sympy.ones(len(coordinates), 1)
    free = matrix_of(known.derivation.kinetic_energy, velocities).rank()
    beyond_pin = sympy.expand(potential - stiffnesses[0] * motor**2 / 2)
    yield assertion(
        "guard to guard housing, guard housing to plastic housing",
        "the guard is carried by the guard housing, and this by the plastic housing",
        (stiffness[3, 2] != 0, to_surroundings[2] != 0, to_surroundings[3] == 0),
        f"""
        the guard is tied by ${sympy.latex(-stiffness[3, 2])}$ to its housing and by nothing to the
        surroundings, the housing by ${sympy.latex(to_surroundings[2])}$
        """,
        method="forces on each body for a unit of each displacement",
        second=same(
            "the second derivatives of the potential energy",
            matrix_of(potential, coordinates).expand(),
            stiffness,
        ),
    )
    yield assertion(
        "cutter and driving bridge",
        "cutter and driving bridge are one rigid body",
        free == len(MOVING_PARTS) - 1,
        f"""
        of {", ".join(MOVING_PARTS)} only {free} move by themselves: cutter and bridge share a mass and a
        displacement
        """,
        method="rank of the mass matrix",
        second=equal("a count of the bodies", len(known.derivation.mechanism.bodies), free),
    )
    yield assertion(
        "motor to cutter",
        "motor and cutter are linked at the pin alone, where the play is",
        sympy.expand(beyond_pin.diff(motor) - beyond_pin.diff(u)) == 0,
        "beyond its own mount, the motor's displacement enters as $q_1 + u$ alone",
        method="derivatives of the potential energy",
        second=same("the forces on the cutter", on_the_cutter.diff(motor), on_the_cutter.diff(u)),
    )
    yield text("""
        The connections that the text names are those of the equations. The bridge's stiffness $k_2$ lies
        between the pin and the one body that bridge and cutter make. The coil spring, which presses the
        cutter on the guard, ties the cutter to the guard housing along the motion.
    """)
