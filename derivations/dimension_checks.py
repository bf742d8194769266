"""Dimension check of every derived equation of the linear trimmer."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import sympy

from derivations.dimensions import ENERGY, LENGTH, POWER, TIME, Dimension, DimensionError, dimension_of
from derivations.linear_trimmer import LinearTrimmer
from derivations.symbols import DIMENSIONS, t, u

ACCELERATION = LENGTH / TIME**2


@dataclass(frozen=True)
class DimensionCheck:
    """A derived expression and the dimension that it must have."""

    name: str  # What the expression is, for the error message
    expression: sympy.Expr  # The derived expression, a scalar
    expected: Dimension  # Its dimension by mechanics
    # Those of the symbols; by default of the thesis's
    dimensions: Mapping[sympy.Expr, Dimension] = field(default_factory=lambda: DIMENSIONS)

    @property
    def found(self) -> Dimension | None:
        """Dimension of the expression; None for zero, which has any.

        Raises:
            DimensionError: if the expression is not consistent in itself.
        """
        return dimension_of(self.expression, self.dimensions)


def dimension_checks(derivation: LinearTrimmer) -> tuple[DimensionCheck, ...]:
    """Return one check for each derived expression: energies, accelerations, A, B and transfer functions."""
    return (
        DimensionCheck("kinetic energy", derivation.kinetic_energy, ENERGY),
        DimensionCheck("potential energy", derivation.potential_energy, ENERGY),
        DimensionCheck("Lagrangian", derivation.lagrangian, ENERGY),
        DimensionCheck("dissipation function", derivation.rayleigh_function, POWER),
        DimensionCheck("power of the pin", derivation.power.input_power, POWER),
        DimensionCheck("dissipated power", derivation.power.dissipated_power, POWER),
        *(
            DimensionCheck(f"acceleration of q{index}", acceleration, ACCELERATION)
            for index, acceleration in enumerate(derivation.accelerations, start=1)
        ),
        *_state_space_checks(derivation),
        *_transfer_function_checks(derivation),
    )


def require_consistent(checks: tuple[DimensionCheck, ...]) -> None:
    """Check that every expression has its expected dimension; zero, which has any dimension, passes.

    Raises:
        DimensionError: naming the expression, the dimension found and the one expected.
    """
    for check in checks:
        if check.found not in (None, check.expected):
            raise DimensionError(f"{check.name} has dimension {check.found}, expected {check.expected}")


def _state_space_checks(derivation: LinearTrimmer) -> Iterator[DimensionCheck]:
    positions = [body.coordinate for body in derivation.mechanism.bodies]
    state = [*positions, *(position.diff(t) for position in positions)]
    inputs = [u, u.diff(t)]
    for row, rate in enumerate(state):
        expected = DIMENSIONS[positions[row % len(positions)]] / TIME ** (1 if row < len(positions) else 2)
        for column, variable in enumerate(state):
            term = derivation.space.a[row, column] * variable
            yield DimensionCheck(f"A[{row + 1}, {column + 1}] in the rate of {rate}", term, expected)
        for column, variable in enumerate(inputs):
            term = derivation.space.b[row, column] * variable
            yield DimensionCheck(f"B[{row + 1}, {column + 1}] in the rate of {rate}", term, expected)


def _transfer_function_checks(derivation: LinearTrimmer) -> Iterator[DimensionCheck]:
    transfer = derivation.transfer
    order = len(transfer.denominator) - 1
    for drop, coefficient in enumerate(transfer.denominator):
        yield DimensionCheck(f"denominator, s^{order - drop}", coefficient, TIME**-drop)
    # Divided by the denominator a displacement per displacement is a number, per velocity a time.
    for numerators, unit in ((transfer.from_displacement, TIME**-2), (transfer.from_velocity, TIME**-1)):
        for body, numerator in enumerate(numerators, start=1):
            for drop, coefficient in enumerate(numerator):
                name = f"numerator of q{body}, s^{len(numerator) - 1 - drop}"
                yield DimensionCheck(name, coefficient, unit / TIME**drop)
