"""A small report that holds everything which is hard to show."""

from __future__ import annotations

import functools

import sympy

from report.document import (
    Chapter,
    DerivationStep,
    Document,
    Equation,
    Figure,
    Highlight,
    NomenclatureRow,
    ParameterRow,
    Provenance,
)
from report.figures.block_diagrams import feedback_system, linear_system
from report.figures.svg import to_svg
from tests.report.rendering.sample_findings import chapter_five, chapter_two
from tests.report.rendering.sample_formulas import (
    CASES,
    DOTS,
    INTEGRAL,
    KINETIC_ENERGY,
    NESTED,
    SPECIAL,
    long_coefficient,
    state_matrix,
)


@functools.cache
def figures() -> tuple[Figure, ...]:
    """Return the two block diagrams as figures of the report."""
    linear = "A block G of s; u of t enters from the left and y of t leaves to the right."
    feedback = "A summing junction takes u and subtracts what N of s feeds back from the output of G of s."
    return (
        Figure(
            "fig-2.3",
            "Linear system",
            r"The block $G(s)$ maps $u(t)$ to $y(t)$.",
            linear,
            to_svg(linear_system(), "fig-2.3", "Linear system", linear),
        ),
        Figure(
            "eq-2.37",
            "Feedback system",
            r"The loop has $M = \frac{G}{1 + G N}$ from $U$ to $Y$.",
            feedback,
            to_svg(feedback_system(), "eq-2.37", "Feedback system", feedback),
        ),
    )


def derivation() -> tuple[DerivationStep, ...]:
    """Return steps with equations that are long, tall and dotted."""
    return (
        DerivationStep(
            "kinetic",
            "Kinetic energy",
            "Four masses move along one line, so *T* is a sum of squares.\n\nA second paragraph, with $q_i$.",
            (
                Equation(KINETIC_ENERGY, "2.4"),
                Equation(DOTS, "2.9"),
            ),
            ("eq-2.9", "eq-2.8"),
        ),
        DerivationStep(
            "state",
            "State space",
            "The states are the displacements and then the velocities.",
            (Equation(f"A = {sympy.latex(state_matrix())}", "2.12"), Equation(long_coefficient())),
            ("eq-2.12",),
        ),
        DerivationStep(
            "waveform",
            "Waveform",
            "The bridge follows the pin while they touch.",
            (Equation(CASES, "2.36"), Equation(INTEGRAL, "2.30"), Equation(NESTED)),
        ),
    )


def sample() -> Document:
    """Return the report."""
    return Document(
        title="The linear trimmer & its claims: 100 % of A_1 <checked>",
        highlights=(
            Highlight(
                "eq-2.9",
                r"The first equation of motion has a wrong sign at $k_1 (q_1 - q_2)$.",
                r"$3\,\%$ of the pole",
            ),
            Highlight("txt-5.1.2-roll-off", "The roll-off is 40 dB per decade, not 60.", "20 dB per decade"),
        ),
        chapters=(
            Chapter("chapter-2", "2", "Modelling & method", chapter_two()),
            Chapter("chapter-5", "5", "Results", chapter_five()),
        ),
        statements_in_thesis=253,
        derivation=derivation(),
        figures=figures(),
        nomenclature=(
            NomenclatureRow("k_{1}", "stiffness between masses 1 and 2", "N/m"),
            NomenclatureRow(r"\dot{q}_{1}", f"velocity {SPECIAL}", "m/s"),
            NomenclatureRow("N", "describing function", ""),
        ),
        parameters=(
            ParameterRow("m_{1}", "mass of the pin", "3.1e-3", "kg"),
            ParameterRow("k_{5}", "stiffness of the flexure", "-1200", "N/m"),
        ),
        provenance=Provenance(
            "0.1.0", "0123abc", "2026-05-04T10:11:12+02:00", (("sympy", "1.14.0"), ("typst", "0.15.0"))
        ),
    )
