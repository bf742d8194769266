"""Proof that a driven trimmer with Coulomb friction forgets how it was started.

Two motions with the same pin differ by d. The pin's terms cancel, and the energy E of the difference obeys
dE/dt = -2 R(d') - sum of (f_a - f_b)(w_a - w_b) over the pairs of bodies with friction, f at the relative
velocity w in either motion. Both terms take energy: R is positive definite, and f does not fall as w rises.
So d' tends to zero: all motions have the same velocities in the end (incremental dissipation; Desoer and
Vidyasagar, Feedback Systems, 1975). From this follows, for a pin that moves periodically:

- Motions are bounded, so one of them has the pin's period (Brouwer's fixed point); it is where all end.
- For a pin with x(t + T/2) = -x(t) the motion turned over and shifted by half a period is a motion too, so
  it is the same one: its velocity has odd harmonics only.

Backlash between pin and bridge makes no difference if the bridge is displaced, as in the thesis: behind the
backlash the pin's motion is another periodic one, which depends on nothing that happens after it.
"""

from dataclasses import dataclass
from functools import cache
from itertools import product

import sympy

from derivations import assumed
from derivations.linear_trimmer import LinearTrimmer
from derivations.symbols import t


@dataclass(frozen=True)
class IncrementalDissipation:
    """What the proof rests on."""

    residual: sympy.Expr  # dE/dt plus the two losses, W; zero along any two motions with the same pin
    # Leading principal minors of the matrices of mass (kg), damping (N s/m) and stiffness (N/m), expanded;
    # those of order k in the k-th power of the unit
    leading_minors: tuple[sympy.Expr, ...]
    # (f_a - f_b)(w_a - w_b) over the force F_c, m/s, for every pair of directions of sliding and for
    # sticking; their symbols are positive
    friction_losses: tuple[sympy.Expr, ...]

    @property
    def holds(self) -> bool:
        """Whether the balance closes, the matrices are positive definite, and friction never gives energy."""
        return (
            self.residual == 0
            and all(_has_positive_terms(minor) for minor in self.leading_minors)
            and all(loss.is_nonnegative is True for loss in self.friction_losses)
        )


@cache
def incremental_dissipation(trimmer: LinearTrimmer) -> IncrementalDissipation:
    """Derive how the difference of two motions with the same pin loses energy.

    Friction may act between any number of pairs: the residual is derived for a friction force on each body,
    of which pairs of equal and opposite forces are special cases.
    """
    matrices = trimmer.matrices
    return IncrementalDissipation(
        residual=_residual(trimmer),
        leading_minors=tuple(
            sympy.expand(matrix[:size, :size].det(method="berkowitz"))
            for matrix in (matrices.mass, matrices.damping, matrices.stiffness)
            for size in range(1, matrix.rows + 1)
        ),
        friction_losses=_friction_losses(),
    )


def _residual(trimmer: LinearTrimmer) -> sympy.Expr:
    """Return dE/dt of the difference of two motions, plus the power that dampers and friction take, W."""
    bodies, pins = trimmer.mechanism.bodies, trimmer.mechanism.pins
    differences = [_values(f"d{index}") for index, _ in enumerate(bodies)]
    seconds = [_values(f"q{index}") for index, _ in enumerate(bodies)]
    firsts = [(a + d, b + e) for (a, b), (d, e) in zip(seconds, differences, strict=True)]
    coordinates = [body.coordinate for body in bodies]
    forces = assumed.real(f"f_0:{len(bodies)}")
    relative_accelerations = [
        _at(acceleration, coordinates, firsts) - _at(acceleration, coordinates, seconds) - force / body.mass
        for acceleration, force, body in zip(trimmer.accelerations, forces, bodies, strict=True)
    ]
    moves = [pin.displacement for pin in pins]  # the two motions have the same pins
    still = dict.fromkeys((*(move.diff(t) for move in moves), *moves), 0)
    kinetic, potential, dissipation = (
        _at(expression.xreplace(still), coordinates, differences)
        for expression in (trimmer.kinetic_energy, trimmer.potential_energy, trimmer.rayleigh_function)
    )
    energy_rate = sympy.Add(
        *(
            kinetic.diff(rate) * acceleration + potential.diff(place) * rate
            for (place, rate), acceleration in zip(differences, relative_accelerations, strict=True)
        )
    )
    friction = sympy.Add(*(force * rate for force, (_, rate) in zip(forces, differences, strict=True)))
    return sympy.expand(energy_rate + 2 * dissipation + friction)


def _values(name: str) -> tuple[sympy.Symbol, sympy.Symbol]:
    """Return symbols for a displacement and its rate, the latter marked by a prime."""
    return assumed.real(name), assumed.real(f"{name}'")


def _at(
    expression: sympy.Expr, coordinates: list[sympy.Expr], values: list[tuple[sympy.Expr, sympy.Expr]]
) -> sympy.Expr:
    """Substitute a pair of value and rate for each coordinate and its time derivative."""
    rates = {q.diff(t): rate for q, (_, rate) in zip(coordinates, values, strict=True)}
    places = {q: place for q, (place, _) in zip(coordinates, values, strict=True)}
    return expression.xreplace(rates).xreplace(places)


def _friction_losses() -> tuple[sympy.Expr, ...]:
    """Return (s_a - s_b)(w_a - w_b) with s = sign(w), and any s between -1 and 1 where w is zero."""
    states = []
    for name in "ab":
        speed, share = assumed.positive(f"w_{name} p_{name}")
        stuck = (1 - share) / (1 + share)  # takes every value between -1 and 1
        states.append(((1, speed), (-1, -speed), (stuck, sympy.Integer(0))))
    return tuple(
        sympy.factor((sign_a - sign_b) * (rate_a - rate_b))
        for (sign_a, rate_a), (sign_b, rate_b) in product(*states)
    )


def _has_positive_terms(polynomial: sympy.Expr) -> bool:
    """Return whether a polynomial in positive parameters has positive coefficients only, and at least one."""
    return all(coefficient > 0 for coefficient in polynomial.as_coefficients_dict().values())
