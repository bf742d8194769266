"""Identity of expressions and of matrices."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Any, Final, Self, final

import sympy

from derivations.algebra.identity import IdentityProof, prove_equal, prove_equal_matrices
from derivations.latex import latex
from report.judging.claim import Agreement
from report.judging.shown import Mathematics
from report.judging.verdict import Certainty

VALUE = re.compile(r"(?<![\w$])([A-Za-z]\w*'*) = (-?\d+(?:/\d+)?)")
PROVEN: Final = "both sides are the same, proven by algebra"


@dataclass(frozen=True)
class _TwoSides:
    """A printed and a derived side; ``left`` is what both are said to equal, shown before them."""

    printed: Any
    derived: Any
    left: sympy.Basic | str | None = None

    def with_derived(self, derived: Any) -> Self:
        """Hold the same printed side against another derived one."""
        return replace(self, derived=derived)

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


@final
@dataclass(frozen=True)
class SameMatrix(_TwoSides):
    """Whether two matrices have the same shape and equal entries."""

    def compare(self) -> Agreement:
        """Prove or disprove equality entry by entry."""
        return _outcome(prove_equal_matrices(self.printed, self.derived))


def _outcome(proof: IdentityProof) -> Agreement:
    if proof.sampled:
        return Agreement(proof.holds, f"not proven: {proof.method}", Certainty.COMPUTED)
    return Agreement(proof.holds, PROVEN if proof.holds else _typeset(proof.method), Certainty.PROVEN)


def _typeset(counterexample: str) -> str:
    """Write the values of symbols, such as ``gamma = 47/55``, as mathematics."""
    return VALUE.sub(lambda found: f"${latex(sympy.Symbol(found[1]))} = {found[2]}$", counterexample)
