"""Short symbolic derivations: energies and forces of the bodies, motion of the pin, roots and transforms."""

import mpmath
import sympy

from derivations import assumed
from derivations.equations_of_motion import euler_lagrange
from derivations.linear_trimmer import LinearTrimmer
from derivations.symbols import A, accelerations, coordinates, f, masses, t, velocities


def work_from_rest() -> sympy.Expr:
    """Return the work that brings each mass from rest to its velocity, added up, J."""
    speed = sympy.Dummy("v", real=True)
    works = (sympy.integrate(m * speed, (speed, 0, v)) for m, v in zip(masses, velocities, strict=True))
    return sympy.Add(*works)


def sign_of_potential_energy(derivation: LinearTrimmer) -> sympy.Expr:
    """Return σ with which L = T + σ U gives Newton's second law for the motor."""
    sign = sympy.Symbol("sigma")
    energy = derivation.kinetic_energy + sign * derivation.potential_energy
    balance = euler_lagrange(energy, derivation.rayleigh_function, coordinates[0])
    newton = masses[0] * (accelerations[0] - derivation.newton[0])
    (solved,) = sympy.solve(sympy.expand(balance - newton), sign)
    return solved


def pin_from_acceleration() -> sympy.Expr:
    """Return the displacement (m) whose acceleration is (2 π f)² times it, towards the axis."""
    displaced, rate = sympy.Function("x"), 2 * sympy.pi * f
    start = {displaced(0): 0, displaced(t).diff(t).subs(t, 0): A * rate}
    equation = sympy.Eq(displaced(t).diff(t, 2), -(rate**2) * displaced(t))
    return sympy.dsolve(equation, displaced(t), ics=start).rhs


def first_root(expression: sympy.Expr, unknown: sympy.Symbol) -> sympy.Expr:
    """Return the root of an expression in a symbol; the first one, if there are several."""
    return sympy.solve(expression, unknown)[0]


def zeros_in_turn(expression: sympy.Expr, phase: sympy.Symbol) -> set[sympy.Expr]:
    """Return the phases in [0, 2π) at which an expression is zero, rad."""
    return set(sympy.solveset(expression, phase, sympy.Interval.Ropen(0, 2 * sympy.pi)))


def least_amplitude_with_contact() -> float:
    """Return the amplitude over the gap from which there is a phase of contact, where 1 - b/A is a sine."""
    amplitude = assumed.positive("a")
    return float(sympy.solve(sympy.Eq(1 - 1 / amplitude, -1), amplitude)[0])


def laplace_integral(function: sympy.Expr, place: float) -> float:
    """Return the integral of a function of t times exp(−s t) over t from 0 at s = ``place`` (1/s)."""
    integrand = sympy.lambdify(t, function * sympy.exp(-place * t), "mpmath")
    return float(mpmath.quad(integrand, [0, mpmath.inf]))
