"""A step of a derivation whose equations are proven when it is told."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import sympy

from derivations.elements.harmonics import evaluated, harmonic_integral
from derivations.elements.waveform import THETA, Segment
from derivations.identity import Proof, require_equal
from derivations.latex import latex
from derivations.narrative import Formula, Step
from derivations.unevaluated import total

Substitutions = tuple[tuple[sympy.Expr, sympy.Expr], ...]


@dataclass(frozen=True)
class Equality:
    """A closed form and what it has to equal.

    Attributes:
        name: LaTeX of the left side.
        closed: The closed form, as it is shown.
        derived: What was derived.
        thesis: Number of the equation in the thesis, empty where it has none.
        given: What symbols stand for; substituted on both sides, in order, before they are compared.
    """

    name: str
    closed: sympy.Expr
    derived: sympy.Expr
    thesis: str = ""
    given: Substitutions = ()

    def prove(self) -> Proof:
        """Prove it.

        Raises:
            UnprovenError: naming the left side, if both differ or only points speak for it.
        """
        sides = (sympy.expand_power_exp(evaluated(side)) for side in (self.closed, self.derived))
        closed, derived = (side.subs(self.given) for side in sides)
        return require_equal(self.name, closed, derived)

    @property
    def formula(self) -> Formula:
        """The equation as it is shown."""
        return Formula(f"{self.name} = {latex(self.closed)}", self.thesis)


def integral_over(
    segment: Segment, harmonic: sympy.Expr, closed: sympy.Expr, given: Substitutions = ()
) -> Equality:
    """Return the equality of ∫ y exp(-jnθ) dθ over a segment and its value in closed form."""
    limits = rf"\int_{{{latex(segment.start)}}}^{{{latex(segment.end)}}}"
    name = rf"{limits} y\, {latex(sympy.exp(-sympy.I * harmonic * THETA))}\, d\theta"
    return Equality(name, closed, harmonic_integral(segment, harmonic), given=given)


def cases(name: str, segments: tuple[Segment, ...], thesis: str = "") -> Formula:
    """Return the definition of a function by segments."""
    rows = (
        rf"{latex(total(*segment.value.as_ordered_terms()))} & "
        rf"\text{{for }} {latex(segment.start)} \leq \theta < {latex(segment.end)}"
        for segment in segments
    )
    body = r" \\ ".join(rows)
    return Formula(rf"{name} = \begin{{cases}} {body} \end{{cases}}", thesis)


@dataclass(frozen=True)
class ProvenStep:
    """A step as it is derived: definitions as formulas, results as equalities, in the order of telling."""

    id: str
    title: str
    text: str
    lines: tuple[Formula | Equality, ...]

    @property
    def equalities(self) -> tuple[Equality, ...]:
        """The lines that are to be proven."""
        return tuple(line for line in self.lines if isinstance(line, Equality))

    def tell(self) -> Step:
        """Prove every equality and return the step, with the means of its proofs in the text.

        Raises:
            UnprovenError: if an equality is not proven.
        """
        means = Counter(equality.prove().method for equality in self.equalities)
        proofs = ", ".join(
            f"{method.removeprefix('difference ')} ({count})" for method, count in means.items()
        )
        text = f"{self.text}\n\nProven equations: {means.total()}. The difference of both sides {proofs}."
        formulas = (line.formula if isinstance(line, Equality) else line for line in self.lines)
        return Step(self.id, self.title, text, tuple(formulas))
