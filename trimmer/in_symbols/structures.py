"""Structures of a mechanism of numbers as parts of one of symbols.

Matrices keep theirs, with a symbol for each entry. A mode is a body of mass one, held by a spring ω² and a
damper 2 ζ ω, and what the modes move is a point whose weights are their shapes.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import sympy

from derivations import parts
from derivations.symbols import t
from trimmer.in_symbols.printed_symbols import Place, PrintedSymbol
from trimmer.in_symbols.structure_symbols import (
    COORDINATE,
    DAMPING_RATIO,
    FREQUENCY,
    MATRICES,
    entry_of,
    shape_of,
)
from trimmer.mechanism import Mechanism, Structure
from trimmer.mechanism.kinds import Kind


@dataclass(frozen=True)
class StructuresInSymbols:
    """The structures of a mechanism in symbols."""

    data: Mechanism
    printed: Mapping[Place, PrintedSymbol]

    @cached_property
    def bodies(self) -> dict[str, parts.RigidBody]:
        """The coordinates by their names, in their order."""
        return {
            f"{name}.{own}": self._body(name, structure, own, place)
            for name, structure in self.data.structures.items()
            for place, own in enumerate(structure.names)
        }

    def _body(self, name: str, structure: Structure, own: str, place: int) -> parts.RigidBody:
        mass = sympy.S.One if structure.modes else self._symbol(name, entry_of("mass", place, place))
        turns = self.data.kinds[f"{name}.{own}"] is Kind.ROTATION
        return parts.RigidBody(f"{name}.{own}", mass, self._function(name, f"{COORDINATE} {own}"), turns)

    @cached_property
    def points(self) -> dict[str, parts.Point]:
        """The points of modes by their names."""
        return {
            f"{name}.{point}": parts.Point(
                self._function(name, f"point {point}"),
                tuple(
                    (self.bodies[f"{name}.{own}"], self._symbol(name, shape_of(point, mode)))
                    for mode, own in enumerate(structure.names)
                    if shape[mode] != 0.0
                ),
            )
            for name, structure in self._modal
            for point, shape in structure.points.items()
        }

    @property
    def springs(self) -> tuple[parts.Spring, ...]:
        """What holds each mode that is not rigid."""
        return tuple(
            parts.Spring(omega**2, parts.Ground(), body) for omega, _, body in self._modes if omega != 0
        )

    @property
    def dampers(self) -> tuple[parts.Damper, ...]:
        """What damps each mode that is damped."""
        return tuple(
            parts.Damper(2 * ratio * omega, parts.Ground(), body)
            for omega, ratio, body in self._modes
            if ratio * omega != 0
        )

    @property
    def structures(self) -> tuple[parts.Structure, ...]:
        """Those that are given by matrices."""
        return tuple(
            parts.Structure(
                name,
                tuple(self.bodies[f"{name}.{own}"] for own in structure.names),
                *(self._matrix(name, kind, len(structure.names)) for kind in MATRICES),
            )
            for name, structure in self.data.structures.items()
            if structure.modes is None
        )

    @property
    def _modal(self) -> list[tuple[str, Structure]]:
        return [(name, each) for name, each in self.data.structures.items() if each.modes is not None]

    @property
    def _modes(self) -> Iterator[tuple[sympy.Expr, sympy.Expr, parts.RigidBody]]:
        """Yield natural frequency, damping ratio and coordinate of each mode."""
        for name, structure in self._modal:
            assert structure.modes is not None
            numbers = zip(
                structure.modes.frequency, structure.modes.damping_ratio, structure.names, strict=True
            )
            for mode, (frequency, ratio, own) in enumerate(numbers, 1):
                omega, zeta = (
                    self._symbol(name, f"{kind} {mode}") if value else sympy.S.Zero
                    for kind, value in ((FREQUENCY, frequency), (DAMPING_RATIO, ratio))
                )
                yield omega, zeta, self.bodies[f"{name}.{own}"]

    def _matrix(self, name: str, kind: str, count: int) -> sympy.ImmutableMatrix:
        return sympy.ImmutableMatrix(
            count, count, lambda row, column: self._symbol(name, entry_of(kind, row, column))
        )

    def _symbol(self, name: str, of: str) -> sympy.Expr:
        """Return the symbol of a number, or zero for an entry that has none."""
        if (printed := self.printed.get(("structures", name, of))) is None:
            return sympy.S.Zero
        positive = of.startswith((FREQUENCY, DAMPING_RATIO))
        return sympy.Symbol(printed.symbol, **({"positive": True} if positive else {"real": True}))

    def _function(self, name: str, of: str) -> sympy.Expr:
        return sympy.Function(self.printed["structures", name, of].symbol, real=True)(t)
