"""Identity of expressions and of matrices."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, Self, final

import sympy

from derivations.identity import Proof, prove_equal, prove_equal_matrices
from derivations.latex import latex
from report.claim import Agreement, Mathematics
from report.comparisons.mutation import mutated_expressions


@dataclass(frozen=True)
class _TwoSides:
    """A printed and a derived side; ``left`` is what both are said to equal, shown before them."""

    printed: Any
    derived: Any
    left: sympy.Basic | str | None = None

    def with_derived(self, derived: Any) -> Self:
        """Hold the same printed side against another derived one."""
        return replace(self, derived=derived)

    def corrected(self) -> Self:
        """Put the derived side in the place of the printed one."""
        return replace(self, printed=self.derived)

    @property
    def printed_shown(self) -> Mathematics:
        """The printed side as an equation, if there is a left side."""
        return self._equation(self.printed)

    @property
    def derived_shown(self) -> Mathematics:
        """The derived side in the same way."""
        return self._equation(self.derived)

    def _equation(self, right: sympy.Basic) -> Mathematics:
        if self.left is None:
            return Mathematics(latex(right))
        shown = self.left if isinstance(self.left, str) else latex(self.left)
        return Mathematics(f"{shown} = {latex(right)}")


@final
@dataclass(frozen=True)
class SameExpression(_TwoSides):
    """Whether two expressions are equal for all values of their symbols; ``assume`` limits these."""

    assume: sympy.Basic = sympy.true

    def compare(self) -> Agreement:
        """Prove or disprove that printed minus derived is zero."""
        return _outcome(prove_equal(self.printed, self.derived, self.assume))

    def mutations(self) -> Iterator[tuple[str, Self]]:
        """Change signs, factors and symbols of the printed expression."""
        for description, changed in mutated_expressions(self.printed):
            yield description, replace(self, printed=changed)


@final
@dataclass(frozen=True)
class SameMatrix(_TwoSides):
    """Whether two matrices have the same shape and equal entries."""

    def compare(self) -> Agreement:
        """Prove or disprove equality entry by entry."""
        return _outcome(prove_equal_matrices(self.printed, self.derived))

    def mutations(self) -> Iterator[tuple[str, Self]]:
        """Change the sign and the size of an entry, and swap it with a neighbour that differs."""
        cells = [cell for cell in sympy.utilities.iterables.cartes(*map(range, self.printed.shape))]
        for row, column in (cell for cell in cells if self.printed[cell] != 0):
            place = f"entry ({row + 1}, {column + 1})"
            entry = self.printed[row, column]
            yield f"sign of {place}", self._with_entries({(row, column): -entry})
            yield f"factor 2 in {place}", self._with_entries({(row, column): 2 * entry})
            other = next((cell for cell in cells if self.printed[cell] != entry), None)
            if other is not None:
                swapped = {(row, column): self.printed[other], other: entry}
                yield f"{place} swapped with {other}", self._with_entries(swapped)

    def _with_entries(self, entries: dict[tuple[int, int], sympy.Expr]) -> Self:
        changed = self.printed.as_mutable()
        for cell, entry in entries.items():
            changed[cell] = entry
        return replace(self, printed=sympy.ImmutableMatrix(changed))


def _outcome(proof: Proof) -> Agreement:
    return Agreement(proof.holds, proof.method)
