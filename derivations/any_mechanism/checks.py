"""Dimension check of every derived expression of a mechanism."""

from collections.abc import Iterator, Mapping

import sympy

from derivations.any_mechanism.derivation import MechanismDerivation
from derivations.dimension_checks import DimensionCheck
from derivations.dimensions import ENERGY, LENGTH, POWER, TIME, Dimension, dimension_of
from derivations.linear_motion import SymbolicMotion
from derivations.mechanism import Mechanism, position
from derivations.symbols import Quantity, t

Dimensions = Mapping[sympy.Expr, Dimension]
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
            *_of_motion(derivation.motion, dimensions),
            *_of_motion(derivation.closed, dimensions),
            *_of_driving(derivation.mechanism, dimensions),
            *_of_laws(derivation, dimensions),
        )
    )


def _force(displacement: sympy.Expr, dimensions: Dimensions) -> Dimension:
    """Return the dimension of what does work along a displacement: a force, or a moment."""
    return ENERGY / (dimension_of(displacement, dimensions) or LENGTH)


def _of_motion(motion: SymbolicMotion, dimensions: Dimensions) -> Expected:
    yield "kinetic energy", motion.kinetic_energy, ENERGY
    yield "potential energy", motion.potential_energy, ENERGY
    yield "dissipation function", motion.rayleigh_function, POWER
    yield "power of pins and forces", motion.power.input_power, POWER
    yield "power of contacts and frictions", motion.power.contact_power, POWER
    for body, force in zip(motion.mechanism.bodies, motion.resultant_forces, strict=True):
        yield f"resultant force on {body.name}", force, _force(body.coordinate, dimensions)


def _of_driving(mechanism: Mechanism, dimensions: Dimensions) -> Expected:
    for pin in mechanism.pins:
        if pin.law is not None:
            yield f"motion of the pin {pin.displacement}", pin.law, dimensions[pin.displacement]
    for given in mechanism.forces:
        if given.law is not None:
            yield f"given force {given.value}", given.law, _force(position(given.on), dimensions)


def _of_laws(derivation: MechanismDerivation, dimensions: Dimensions) -> Expected:
    for contact in derivation.contacts:
        name, length = contact.contact.name, dimensions[contact.contact.distance]
        for expression, expected in (
            (contact.tension, ENERGY / length),
            (contact.stretch, length),
            (contact.stretch_rate, length / TIME),
        ):
            for case in _cases(expression):
                yield f"law of contact of {name}", case, expected
    for wall in derivation.walls:
        force = ENERGY / dimensions[wall.wall.distance]
        yield f"impulse of {wall.wall.name}", wall.impulse, force * TIME
        yield f"force of {wall.wall.name} at rest", wall.held, force
    for friction in derivation.frictions:
        force = POWER / dimensions[friction.friction.rate]
        yield f"kinetic force of {friction.friction.name}", friction.friction.kinetic, force
        yield f"static force of {friction.friction.name}", friction.friction.static, force
        if friction.held is not None:
            yield f"force in stick of {friction.friction.name}", friction.held, force


def _cases(expression: sympy.Expr | None) -> Iterator[sympy.Expr]:
    """Yield the values of a piecewise function, and what the greater or smaller is chosen of."""
    if expression is None:
        return
    pieces = expression.args if isinstance(expression, sympy.Piecewise) else ((expression, sympy.true),)
    for value, _ in pieces:
        yield from value.args if isinstance(value, sympy.Max | sympy.Min) else (value,)
