"""Putting the report together from what was derived, solved, judged and drawn."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from derivations.elements.quantities import ELEMENT_QUANTITIES
from derivations.latex import latex
from derivations.narrative import Step
from derivations.symbols import PARAMETERS, QUANTITIES
from report.claim import Finding, Statement
from report.document import (
    Answer,
    Chapter,
    CorrectedResult,
    DerivationStep,
    Document,
    Equation,
    Figure,
    NomenclatureRow,
    Opening,
    ParameterRow,
    Program,
    Robustness,
    TwinChapter,
)
from report.inventory import FURTHER, read_inventory
from report.provenance import provenance
from report.sections import read_sections
from report.text_copy import read_text_copy
from trimmer import TrimmerParameters

TITLE = "The trimmer’s thesis, derived again"
CHAPTERS = {
    "1": "Introduction",
    "2": "Theory",
    "3": "Experiment and simulation",
    "4": "Nonlinearities in the simulation",
    "5": "Simulation and results",
    "6": "Discussion",
    "7": "Conclusion",
    "A": "Listings",
    "B": "Fourier coefficients",
    "D": "Equations of motion",
    "E": "Further simulations",
}

SETTLED_BY = {
    "df-general-backlash": ("eq-B.3", "eq-B.4"),
    "df-contours": ("txt-5.2.3-contours-bounded",),
}
"""Claims that steps of the derivation settle, beside those on the equations that they give the numbers of."""


@dataclass(frozen=True)
class Parts:
    """What a report is put together from, beside the inventory.

    Attributes:
        findings: One for each claim, in the order of the inventory.
        figures: The redrawn figures, in the order of the thesis.
        trimmer_steps: The derivation of the linear trimmer.
        element_steps: The derivation of the describing functions.
        programs: The corrected listings.
        opening: The first screen.
        answers: Answers to the thesis's questions.
        corrected: Printed and corrected predictions.
        robustness: How far these hold when the parameters change.
        twin: The chapter on the physical twin.
    """

    findings: tuple[Finding, ...]
    figures: tuple[Figure, ...]
    trimmer_steps: tuple[Step, ...]
    element_steps: tuple[Step, ...]
    programs: tuple[Program, ...]
    opening: Opening
    answers: tuple[Answer, ...]
    corrected: tuple[CorrectedResult, ...]
    robustness: Robustness
    twin: TwinChapter


def assemble(parts: Parts, parameters: TrimmerParameters, inventory: Mapping[str, Statement]) -> Document:
    """Return the finished document."""
    return Document(
        title=TITLE,
        opening=parts.opening,
        chapters=_chapters(parts.findings, inventory),
        statements_in_thesis=len(inventory),
        derivation=_derivation(parts.trimmer_steps, parts.findings),
        figures=parts.figures,
        nomenclature=tuple(
            NomenclatureRow(latex(quantity.symbol), quantity.meaning, quantity.unit.text)
            for quantity in QUANTITIES + ELEMENT_QUANTITIES
        ),
        parameters=tuple(
            ParameterRow(latex(quantity.symbol), quantity.meaning, f"{value:g}", quantity.unit.text)
            for quantity, value in zip(PARAMETERS, parameters.values(), strict=True)
        ),
        provenance=provenance(),
        text_copy=read_text_copy(),
        programs=parts.programs,
        describing_functions=_derivation(parts.element_steps, parts.findings),
        answers=parts.answers,
        corrected=parts.corrected,
        robustness=parts.robustness,
        twin=parts.twin,
        sections=read_sections(),
        further_statements=len(read_inventory(FURTHER)),
    )


def _chapters(findings: tuple[Finding, ...], inventory: Mapping[str, Statement]) -> tuple[Chapter, ...]:
    chapters = (
        Chapter(f"chapter-{number}", number, title, _in_thesis_order(findings, inventory, number))
        for number, title in CHAPTERS.items()
    )
    return tuple(chapter for chapter in chapters if chapter.findings)


def _in_thesis_order(
    findings: tuple[Finding, ...], inventory: Mapping[str, Statement], chapter: str
) -> tuple[Finding, ...]:
    own = (finding for finding in findings if inventory[finding.id].chapter == chapter)
    return tuple(sorted(own, key=lambda finding: finding.section.split(".")))


def _derivation(steps: tuple[Step, ...], findings: tuple[Finding, ...]) -> tuple[DerivationStep, ...]:
    judged = {finding.id for finding in findings}
    return tuple(
        DerivationStep(
            id=step.id,
            title=step.title,
            text=step.text,
            equations=tuple(Equation(formula.latex, formula.thesis) for formula in step.formulas),
            claims=tuple(claim for claim in _claims(step) if claim in judged),
        )
        for step in steps
    )


def _claims(step: Step) -> tuple[str, ...]:
    """Return the ids of the claims that a step bears on, each once."""
    equations = (f"eq-{formula.thesis}" for formula in step.formulas if formula.thesis)
    return tuple(dict.fromkeys((*equations, *SETTLED_BY.get(step.id, ()))))
