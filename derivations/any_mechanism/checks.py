"""Dimension check of every derived expression of a mechanism."""

from __future__ import annotations

from collections.abc import Iterator

import sympy

from derivations.any_mechanism.derivation import MechanismDerivation
from derivations.dimension_checks import DimensionCheck
from derivations.dimensions import ENERGY, FORCE, LENGTH, POWER, TIME, Dimension
from derivations.linear_motion import SymbolicMotion
from derivations.mechanism import Mechanism
from derivations.symbols import Quantity, t

Expected = Iterator[tuple[str, sympy.Expr, Dimension]]


def mechanism_checks(
    derivation: MechanismDerivation, quantities: tuple[Quantity, ...]
) -> tuple[DimensionCheck, ...]:
    """Return one check for each energy, power, force, law of contact and friction, and motion of a pin.

    Args:
        derivation: The derivation.
        quantities: All its symbols and functions of time, apart from time itself.
    """
    dimensions = {t: TIME} | {each.symbol: each.unit.dimension for each in quantities}
    return tuple(
        DimensionCheck(name, expression, expected, dimensions)
        for name, expression, expected in (
            *_of_motion(derivation.motion),
            *_of_motion(derivation.closed),
            *_of_driving(derivation.mechanism),
            *_of_laws(derivation),
        )
    )


def _of_motion(motion: SymbolicMotion) -> Expected:
    yield "kinetic energy", motion.kinetic_energy, ENERGY
    yield "potential energy", motion.potential_energy, ENERGY
    yield "dissipation function", motion.rayleigh_function, POWER
    yield "power of pins and forces", motion.power.input_power, POWER
    yield "power of contacts and frictions", motion.power.contact_power, POWER
    for body, force in zip(motion.mechanism.bodies, motion.resultant_forces, strict=True):
        yield f"resultant force on {body.name}", force, FORCE


def _of_driving(mechanism: Mechanism) -> Expected:
    for pin in mechanism.pins:
        if pin.law is not None:
            yield f"motion of the pin {pin.displacement}", pin.law, LENGTH
    for given in mechanism.forces:
        if given.law is not None:
            yield f"given force on {given.body.name}", given.law, FORCE


def _of_laws(derivation: MechanismDerivation) -> Expected:
    for contact in derivation.contacts:
        name = contact.contact.name
        for expression, expected in (
            (contact.tension, FORCE),
            (contact.stretch, LENGTH),
            (contact.stretch_rate, LENGTH / TIME),
        ):
            for case in _cases(expression):
                yield f"law of contact of {name}", case, expected
    for friction in derivation.frictions:
        yield f"kinetic force of {friction.friction.name}", friction.friction.kinetic, FORCE
        yield f"static force of {friction.friction.name}", friction.friction.static, FORCE
        if friction.held is not None:
            yield f"force in stick of {friction.friction.name}", friction.held, FORCE


def _cases(expression: sympy.Expr | None) -> Iterator[sympy.Expr]:
    """Yield the values of a piecewise function, and what the greater or smaller is chosen of."""
    if expression is None:
        return
    pieces = expression.args if isinstance(expression, sympy.Piecewise) else ((expression, sympy.true),)
    for value, _ in pieces:
        yield from value.args if isinstance(value, sympy.Max | sympy.Min) else (value,)
