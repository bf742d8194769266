"""Claims of section 2.2.1: pin, energies and motion (2.1 to 2.9, figures 2.1 and 2.2)."""

import math

import sympy

from derivations import assumed
from derivations.equations_of_motion import euler_lagrange
from derivations.symbols import A, accelerations, coordinates, f, masses, t, u, u_dot, velocities
from report.chapters.chapter_2.claims import trimmer_printed
from report.chapters.chapter_2.claims.trimmer_printed import c1, c2, c3, c4, k1, k2, k3, k4, k5
from report.judging.claim import ClaimPart
from report.judging.comparisons.printed import product, total
from report.judging.parts import digits, equal, expression, made_here, matrix, same
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent import symbolic
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA
from trimmer import response_at

RATE = 2 * sympy.pi * f
PIN_MOTION = A * sympy.sin(RATE * t)
TURNING_POINT = A * sympy.exp(RATE * sympy.I * t)
AMPLITUDE_LOST = "the amplitude A is lost in the derivative"
VELOCITY_ITEM = "2πf cos(2πft), velocity of the pin"
MOTOR_ITEM = "q̈₁, equation of motion of the motor"  # Printed things that several claims judge


def matrix_of(function: sympy.Expr, variables: tuple[sympy.Expr, ...]) -> sympy.ImmutableMatrix:
    """Return the matrix of a quadratic form."""
    return sympy.ImmutableMatrix(sympy.hessian(function, variables))


def by_newton(known: Evidence, variables: tuple[sympy.Expr, ...]) -> sympy.ImmutableMatrix:
    """Return minus the forces on the bodies for a unit of each variable."""
    slopes = sympy.Matrix(known.derivation.newton).jacobian(variables)
    return sympy.ImmutableMatrix(-sympy.diag(*masses) * slopes).expand()


@claim("fig-2.1")
def free_body_diagram(known: Evidence) -> Record:
    derivation = known.derivation
    free = matrix_of(derivation.kinetic_energy, velocities).rank()
    stiffness = matrix_of(derivation.potential_energy, coordinates)
    damping = matrix_of(derivation.rayleigh_function, velocities)
    pin = sympy.ImmutableMatrix([derivation.potential_energy.diff(u, q) for q in coordinates]).expand()
    moved_together = sympy.ImmutableMatrix((stiffness * sympy.ones(4, 1)).expand())
    springs = [[k1 + k2, -k2, 0, 0], [-k2, k2 + k5, -k5, 0], [0, -k5, k3 + k4 + k5, -k4], [0, 0, -k4, k4]]
    dampers = [[c1 + c2, -c2, 0, 0], [-c2, c2, 0, 0], [0, 0, c3 + c4, -c4], [0, 0, -c4, c4]]
    second = equal("a count of the bodies", len(derivation.mechanism.bodies), free)
    yield digits("number of masses", "4", free, second=second)
    for label, printed, derived, variables in (
        ("springs", springs, stiffness, coordinates),
        ("dampers", dampers, damping, velocities),
        ("where the pin's displacement acts", [k2, -k2, 0, 0], pin, (u,)),
    ):
        forces = same("the forces on each body", by_newton(known, variables), derived)
        yield matrix(label, sympy.ImmutableMatrix(printed), derived, second=forces)
    yield matrix("springs with a fixed end", sympy.ImmutableMatrix([k1, 0, k3, 0]), moved_together)
    yield text("""
        Read with the names in the text (motor, driving bridge, housing, guard, coil spring), the diagram's
        four masses, five springs and four dampers give the printed matrices, by energies as by forces. Moved
        together, the masses load the two springs with a fixed end alone.
    """)


@claim("fig-2.2")
def eccentric_pin(_: Evidence) -> Record:
    angle = assumed.real("theta")
    turn = sympy.Matrix([[sympy.cos(angle), sympy.sin(angle)], [-sympy.sin(angle), sympy.cos(angle)]])
    across = (turn * sympy.Matrix([0, A]))[0]
    stroke = sympy.maximum(across, angle) - sympy.minimum(across, angle)
    turned = across.subs(angle, RATE * t)
    second = same("its acceleration towards the axis", symbolic.pin_from_acceleration(), PIN_MOTION)
    yield expression("displacement of the pin", PIN_MOTION, turned, sympy.Symbol("x_i"), second=second)
    yield expression("half of the stroke is the eccentricity", product(A), stroke / 2)
    yield text("""
        A point at distance $A$ from the axis, turned $f$ times a second, is displaced as printed along the
        motion, and $A$ is the amplitude as the caption says. With flat edges across the motion the pin's own
        radius drops out, and the bridge gets the same sine. The displacement is relative to the motor, as in
        the energies.
    """)


@claim("eq-2.1")
def pin_motion(_: Evidence) -> Record:
    yield expression("", PIN_MOTION, sympy.im(TURNING_POINT), sympy.Symbol("x_i"))
    yield text("""
        A pin at distance $A$ from the axis of a shaft that turns $f$ times a second, seen along one
        direction, moves as printed. Its unit is the metre, as it must be.
    """)


@claim("eq-2.2")
def lagrangian(known: Evidence) -> Record:
    kinetic, potential = sympy.symbols("T U")
    derived = kinetic + symbolic.sign_of_potential_energy(known.derivation) * potential
    yield expression("", total(kinetic, -potential), derived, sympy.Symbol("L"))
    yield text(r"""
        With $L = T + \sigma U$ the Euler-Lagrange equation of the motor equals Newton's second law only for
        $\sigma = -1$, so the printed difference is the right one.
    """)


@claim("eq-2.3")
def kinetic_energy_in_general(_: Evidence) -> Record:
    index = sympy.Symbol("i", integer=True)
    mass, velocity = sympy.IndexedBase("m"), sympy.IndexedBase("v")
    values = {mass[i]: m for i, m in enumerate(masses, 1)}
    values |= {velocity[i]: v for i, v in enumerate(velocities, 1)}
    printed = sympy.Sum(mass[index] * velocity[index] ** 2 / 2, (index, 1, len(masses))).doit().subs(values)
    yield expression(
        "the sum for $n = 4$",
        printed,
        symbolic.work_from_rest(),
        sympy.Symbol("T"),
        printed_form=r"T(\dot q_i) = \sum_{i=1}^n \frac{1}{2} m_i \dot q_i^2",
    )
    yield text("""
        The work that brings each mass from rest to its velocity adds up to the printed sum. The velocities
        are absolute. The sentence before the equation calls them relative; relative motion matters for the
        springs, not for the masses.
    """)


@claim("eq-2.4")
def kinetic_energy(known: Evidence) -> Record:
    derived, work = known.derivation.kinetic_energy, symbolic.work_from_rest()
    second = same("the work done on each mass", work, derived)
    yield expression("", trimmer_printed.kinetic_energy(), derived, sympy.Symbol("T"), second=second)
    yield text("The list of four masses gives the printed sum.")


@claim("eq-2.5")
def potential_energy(known: Evidence) -> Record:
    derived, newton = known.derivation.potential_energy, known.derivation.newton
    at_rest = {velocity: 0 for velocity in (*velocities, u_dot)}
    forces = sympy.ImmutableMatrix([m * each.subs(at_rest) for m, each in zip(masses, newton, strict=True)])
    slopes = sympy.ImmutableMatrix([-derived.diff(q) for q in coordinates])
    second = same("the spring forces on each body at rest", forces, slopes)
    yield expression("", trimmer_printed.potential_energy(), derived, sympy.Symbol("U"), second=second)
    yield text("""
        The pin rides on the motor, so the driving bridge's spring is stretched by $q_2 - q_1 - u$. With that,
        the five springs give the printed sum.
    """)


@claim("eq-2.6")
def euler_lagrange_equation(known: Evidence) -> Record:
    derivation = known.derivation
    balances = [euler_lagrange(derivation.lagrangian, derivation.rayleigh_function, q) for q in coordinates]
    each_body = zip(masses, accelerations, derivation.newton, strict=True)
    newton = [mass * (acceleration - force) for mass, acceleration, force in each_body]
    inertia = r"\frac{d}{dt}\left(\frac{\partial L}{\partial \dot q_i}\right)"
    forces = r"\frac{\partial L}{\partial q_i} + \frac{\partial R}{\partial \dot q_i} = Q_i"
    printed, derived = sympy.ImmutableMatrix(balances), sympy.ImmutableMatrix(newton)
    yield matrix("the four bodies, $Q_i = 0$", printed, derived, form=f"{inertia} - {forces}")
    yield text("""
        For each of the four bodies the printed left side equals mass times acceleration less the forces of
        Newton's law. The text says that $Q_i$ carries the input. In this derivation the pin acts through $U$
        and $R$, and every $Q_i$ is zero.
    """)


@claim("eq-2.7")
def rayleigh_function(known: Evidence) -> Record:
    derived, lost = known.derivation.rayleigh_function, known.derivation.power.dissipated_power
    second = same("the power balance", lost / 2, derived)
    yield expression("", trimmer_printed.rayleigh_function(), derived, sympy.Symbol("R"), second=second)
    yield text("""
        The four dampers give the printed sum, and twice that sum is the power that is lost in every motion.
    """)


def velocity_part() -> ClaimPart:
    """Return the part on the printed velocity of the pin."""
    derived = PIN_MOTION.diff(t)
    return expression(
        "velocity of the pin",
        product(RATE, sympy.cos(RATE * t)),
        derived,
        u_dot,
        second=same("the velocity of a point on a circle", sympy.re(RATE * TURNING_POINT), derived),
        slip=made_here(AMPLITUDE_LOST, derived / A),
        item=VELOCITY_ITEM,
    )


def output_with_the_slip(known: Evidence) -> float:
    """Return the output's amplitude (m) at the drive, with the printed velocity as second input."""
    gain = abs(complex(response_at(known.numbers.displacement_only, DRIVE_OMEGA)))
    damper_over_spring = known.numbers.parameters.c2 / known.numbers.parameters.k2
    return gain * math.hypot(DRIVE_AMPLITUDE, damper_over_spring * DRIVE_OMEGA)


@claim("eq-2.8")
def pin_velocity(known: Evidence) -> Record:
    yield velocity_part()
    yield text(rf"""
        The derivative of $A\sin(2\pi f t)$ keeps the amplitude $A$; the printed line has lost it. The units
        show it too: the printed right side is in 1/s, a velocity is in m/s.

        Chapter 5 shows no sign of this slip. Its loop drops the velocity (Listing A.1, line 58), and [figure
        5.1](#fig-5.1) would have an amplitude of {1e3 * output_with_the_slip(known):.1f} mm in place of the
        printed {1e3 * DRIVE_AMPLITUDE} mm.
    """)


@claim("txt-2.2.1-single-input-velocity")
def pin_velocity_in_words(_: Evidence) -> Record:
    amplitude = A * RATE
    squared = sympy.trigsimp(PIN_MOTION.diff(t) ** 2 + (PIN_MOTION.diff(t, 2) / RATE) ** 2)
    second = same("velocity and acceleration at any time", squared, amplitude**2)
    yield velocity_part()
    slip = made_here(AMPLITUDE_LOST, RATE)
    yield expression("its amplitude", RATE, amplitude, second=second, slip=slip, item=VELOCITY_ITEM)
    yield text(rf"""
        This is the slip of [equation 2.8](#eq-2.8). The amplitude of the printed velocity is $2\pi f$,
        {DRIVE_OMEGA:.1f}/s at {DRIVE_FREQUENCY:.0f} Hz. For an eccentricity of {1e3 * DRIVE_AMPLITUDE} mm it
        should be $2\pi f A = {DRIVE_AMPLITUDE * DRIVE_OMEGA:.4f}$ m/s.

        None that can be seen. Equation 3.2 takes the velocity as an input, but the models behind chapter 3
        are not given.
    """)


@claim("eq-2.9")
def equations_of_motion(known: Evidence) -> Record:
    derivation, printed = known.derivation, trimmer_printed.accelerations()
    lines = zip(printed, derivation.accelerations, derivation.newton, accelerations, strict=True)
    for index, (line, derived, newton, left) in enumerate(lines, start=1):
        second = same("Newton's second law for each body", newton, derived)
        item = MOTOR_ITEM if index == 1 else ""
        yield expression(rf"$\ddot q_{index}$", line, derived, left, second=second, item=item)
    yield text("""
        All four lines follow from the energies, and again from the forces alone. Signs and indices of every
        term are right.
    """)
