"""A step of a derivation whose equations are proven before it is shown."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy

from derivations.algebra.identity import IdentityProof, require_equal
from derivations.algebra.unevaluated import total
from derivations.elements.harmonics import antiderivative, evaluated, harmonic_integral
from derivations.elements.waveform import THETA, Segment
from derivations.latex import latex
from derivations.step import Formula, NarrativeStep

Substitutions = tuple[tuple[sympy.Expr, sympy.Expr], ...]


@dataclass(frozen=True)
class Equality:
    """A closed form and what it has to equal."""

    name: str  # LaTeX of the left side
    closed: sympy.Expr  # The closed form, the right side as it is shown
    derived: sympy.Expr  # The expression that it has to equal, as it follows from the waveform
    thesis: str = ""  # Number of the equation in the thesis, empty where it has none
    # What symbols stand for; substituted on both sides, in order, before they are compared
    given: Substitutions = ()
    words: str = ""  # Prose before it; empty where it follows the line above

    def prove(self) -> IdentityProof:
        """Prove that the closed form is what was derived, after all integrals are evaluated.

        Raises:
            UnprovenError: naming the left side, if both differ or only points speak for it; or if an
                antiderivative is not proven.
            ValueError: if an integrand is not such as ``harmonics.antiderivative`` takes.
        """
        sides = (sympy.expand_power_exp(evaluated(side)) for side in (self.closed, self.derived))
        closed, derived = (side.subs(self.given) for side in sides)
        return require_equal(self.name, closed, derived)

    @property
    def formula(self) -> Formula:
        """The equation as it is shown."""
        return Formula(f"{self.name} = {latex(self.closed)}", self.thesis, self.words)


def integral_over(
    segment: Segment, harmonic: sympy.Expr, closed: sympy.Expr, given: Substitutions = ()
) -> Equality:
    """Return the equality of ∫ y exp(-jnθ) dθ over a segment and its value in closed form.

    Args:
        segment: A part of the output y.
        harmonic: n, a number or a symbol.
        closed: The value.
        given: What symbols stand for, see ``Equality``.
    """
    limits = rf"\int_{{{latex(segment.start)}}}^{{{latex(segment.end)}}}"
    name = rf"{limits} y\, {latex(sympy.exp(-sympy.I * harmonic * THETA))}\, d\theta"
    return Equality(name, closed, harmonic_integral(segment, harmonic), given=given)


def antiderivative_on(segment: Segment, harmonic: sympy.Expr, closed: sympy.Expr, words: str) -> Equality:
    """Return the equality of ∫ y exp(-jnθ) dθ without limits and an antiderivative in closed form.

    Args:
        segment: A part of the output y.
        harmonic: n, a number or a symbol.
        closed: The antiderivative, made of powers and exponentials of θ without a constant.
        words: Which part of the output it is, as prose.
    """
    weight = sympy.exp(-sympy.I * harmonic * THETA)
    name = rf"\int y\, {latex(weight)}\, d\theta"
    return Equality(name, closed, antiderivative(segment.value * weight, THETA), words=words)


def cases(name: str, segments: tuple[Segment, ...], thesis: str = "") -> Formula:
    """Return the definition of a function of θ by segments.

    Args:
        name: LaTeX of the function.
        segments: Its parts, in the order in which they are shown.
        thesis: Number of the equation in the thesis, empty where it has none.
    """
    rows = (
        rf"{latex(total(*segment.value.as_ordered_terms()))} & "
        rf"\text{{for }} {latex(segment.start)} \leq \theta < {latex(segment.end)}"
        for segment in segments
    )
    body = r" \\ ".join(rows)
    return Formula(rf"{name} = \begin{{cases}} {body} \end{{cases}}", thesis)


@dataclass(frozen=True)
class ProvenStep:
    """A step with its results still to be proven."""

    id: str  # Identifier, unique among all steps
    title: str  # Heading
    text: str  # Prose, paragraphs separated by an empty line
    # Definitions as formulas and results as equalities, in the order in which they are shown
    lines: tuple[Formula | Equality, ...]
    code: tuple[Callable[..., Any], ...] = ()  # The functions that do what the step says

    @property
    def equalities(self) -> tuple[Equality, ...]:
        """The lines that are to be proven."""
        return tuple(line for line in self.lines if isinstance(line, Equality))

    def proven(self) -> NarrativeStep:
        """Prove every equality and return the step, with the methods of its proofs in the text.

        Raises:
            UnprovenError: if an equality is not proven.
            ValueError: if an integrand is not such as ``harmonics.antiderivative`` takes.
        """
        means = Counter(equality.prove().method for equality in self.equalities)
        ways = (
            method.removeprefix("difference ") + (f" ({count})" if len(means) > 1 else "")
            for method, count in means.items()
        )
        proofs = " or ".join(ways).replace(" or is zero", " or")
        text = f"{self.text}\n\nProven equations: {means.total()}. The difference of both sides {proofs}."
        formulas = (line.formula if isinstance(line, Equality) else line for line in self.lines)
        return NarrativeStep(self.id, self.title, text, tuple(formulas), self.code)
