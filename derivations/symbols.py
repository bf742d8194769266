"""Every symbol of the derivations, declared once with its meaning and its SI unit."""

from dataclasses import dataclass

import sympy

from derivations import assumed
from derivations.dimensions import FORCE, LENGTH, MASS, NUMBER, TIME, Dimension


@dataclass(frozen=True)
class Unit:
    """An SI unit."""

    text: str  # How it is written
    dimension: Dimension  # Its dimension


KILOGRAM = Unit("kg", MASS)
NEWTON_PER_METRE = Unit("N/m", FORCE / LENGTH)
NEWTON_SECOND_PER_METRE = Unit("N s/m", FORCE * TIME / LENGTH)
KILOGRAM_METRE = Unit("kg m", MASS * LENGTH)
KILOGRAM_SQUARE_METRE = Unit("kg m²", MASS * LENGTH**2)
NEWTON_METRE = Unit("N m", FORCE * LENGTH)
NEWTON_METRE_PER_RADIAN = Unit("N m/rad", FORCE * LENGTH)
NEWTON_METRE_SECOND_PER_RADIAN = Unit("N m s/rad", FORCE * LENGTH * TIME)
NEWTON_SECOND = Unit("N s", FORCE * TIME)
PER_KILOGRAM = Unit("1/kg", MASS**-1)
PER_KILOGRAM_METRE = Unit("1/(kg m)", (MASS * LENGTH) ** -1)
PER_KILOGRAM_SQUARE_METRE = Unit("1/(kg m²)", (MASS * LENGTH**2) ** -1)
MODAL_METRE = Unit("m kg^1/2", LENGTH * MASS ** sympy.Rational(1, 2))
PER_ROOT_OF_KILOGRAM = Unit("kg^-1/2", MASS ** sympy.Rational(-1, 2))
METRE = Unit("m", LENGTH)
SECOND = Unit("s", TIME)
METRE_PER_SECOND = Unit("m/s", LENGTH / TIME)
METRE_PER_SECOND_SQUARED = Unit("m/s²", LENGTH / TIME**2)
RADIAN_PER_SECOND_SQUARED = Unit("rad/s²", TIME**-2)
HERTZ = Unit("Hz", TIME**-1)
RADIAN_PER_SECOND = Unit("rad/s", TIME**-1)
PER_SECOND = Unit("1/s", TIME**-1)
NEWTON = Unit("N", FORCE)
RADIAN = Unit("rad", NUMBER)
ONE = Unit("1", NUMBER)


@dataclass(frozen=True)
class Quantity:
    """A symbol of the derivations, or a function of time."""

    symbol: sympy.Expr  # The symbol or function
    meaning: str  # What it stands for, in words
    unit: Unit  # Its SI unit


def _coordinate(name: str) -> sympy.Expr:
    return sympy.Function(name, real=True)(t)


t = assumed.real("t")
s = sympy.Symbol("s")
omega = assumed.positive("omega")
f = assumed.positive("f")
A = assumed.positive("A")

m1, m2, m3, m4 = masses = assumed.positive("m_1:5")
k1, k2, k3, k4, k5 = stiffnesses = assumed.nonnegative("k_1:6")
c1, c2, c3, c4 = dampings = assumed.nonnegative("c_1:5")
q1, q2, q3, q4 = coordinates = tuple(_coordinate(f"q_{index}") for index in range(1, 5))
u = _coordinate("u")

velocities = tuple(coordinate.diff(t) for coordinate in coordinates)
accelerations = tuple(coordinate.diff(t, 2) for coordinate in coordinates)
u_dot = u.diff(t)

PARAMETERS = (
    Quantity(m1, "mass of the motor", KILOGRAM),
    Quantity(m2, "mass of the cutter with the driving bridge", KILOGRAM),
    Quantity(m3, "mass of the guard housing", KILOGRAM),
    Quantity(m4, "mass of the guard", KILOGRAM),
    Quantity(k1, "stiffness of the motor mount", NEWTON_PER_METRE),
    Quantity(k2, "stiffness of the driving bridge", NEWTON_PER_METRE),
    Quantity(k3, "stiffness of the housing mount", NEWTON_PER_METRE),
    Quantity(k4, "stiffness between guard and housing", NEWTON_PER_METRE),
    Quantity(k5, "stiffness of the coil spring between cutter and housing", NEWTON_PER_METRE),
    Quantity(c1, "damping of the motor mount", NEWTON_SECOND_PER_METRE),
    Quantity(c2, "damping of the driving bridge", NEWTON_SECOND_PER_METRE),
    Quantity(c3, "damping of the housing mount", NEWTON_SECOND_PER_METRE),
    Quantity(c4, "damping between guard and housing", NEWTON_SECOND_PER_METRE),
)

VARIABLES = (
    Quantity(t, "time", SECOND),
    Quantity(q1, "displacement of the motor", METRE),
    Quantity(q2, "displacement of the cutter", METRE),
    Quantity(q3, "displacement of the guard housing", METRE),
    Quantity(q4, "displacement of the guard", METRE),
    Quantity(u, "displacement of the pin relative to the motor", METRE),
    Quantity(A, "amplitude, half of peak to peak", METRE),
    Quantity(f, "frequency", HERTZ),
    Quantity(omega, "angular frequency", RADIAN_PER_SECOND),
    Quantity(s, "Laplace variable", PER_SECOND),
)

QUANTITIES = PARAMETERS + VARIABLES
DIMENSIONS = {quantity.symbol: quantity.unit.dimension for quantity in QUANTITIES}
