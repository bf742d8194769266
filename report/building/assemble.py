"""Putting the report together from what was derived, solved, judged and drawn."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from derivations.latex import latex
from derivations.symbols import PARAMETERS
from report.building.thesis import THESIS
from report.data.mutation import read_mutation
from report.data.statements import FURTHER, read_follows, read_sections
from report.data.text_copy import read_build_time, read_text_copy
from report.derivation.code_lines import StepWithLines
from report.derivation.nomenclature import nomenclature
from report.derivation.places_of_claims import places, shown_in
from report.document.document import Document
from report.document.subject import Subject
from report.document.thesis import Chapter, Program
from report.judging.claim import Statement
from report.judging.finding import Finding
from report.judging.inventory import read_statements
from report.pages.derivation import DerivationStep, ParameterRow
from report.pages.figure import Equation, Figure
from report.pages.provenance import provenance
from trimmer import TrimmerParameters


@dataclass(frozen=True)
class Parts:
    """What a report is put together from, beside the inventory."""

    findings: tuple[Finding, ...]  # One for each claim, in the order of the inventory
    figures: tuple[Figure, ...]  # The redrawn figures, in the order of the thesis
    trimmer_steps: tuple[StepWithLines, ...]  # The derivation of the linear trimmer
    element_steps: tuple[StepWithLines, ...]  # The derivation of the describing functions
    number_steps: tuple[StepWithLines, ...]  # From the equations to numbers
    pictures: Mapping[str, Figure]  # Of the waveforms, by the ids of their steps
    programs: tuple[Program, ...]  # The corrected listings
    extras: Mapping[str, Any]  # The chapters beside those of the thesis, by the names of their fields


def assemble(parts: Parts, parameters: TrimmerParameters, inventory: Mapping[str, Statement]) -> Document:
    """Return the finished document."""
    every = parts.trimmer_steps + parts.element_steps + parts.number_steps
    steps = tuple(each.step for each in every)
    step_of = places(parts.findings, steps)
    told = {each.step.id: _told(each, step_of, parts) for each in every}
    return Document(
        subject=THESIS,
        chapters=chapters_of(THESIS, parts.findings, inventory),
        statements_in_thesis=len(inventory),
        derivation=tuple(told[each.step.id] for each in parts.trimmer_steps),
        figures=parts.figures,
        nomenclature=nomenclature(steps, parts.findings),
        parameters=tuple(
            ParameterRow(latex(quantity.symbol), quantity.meaning, f"{value:g}", quantity.unit.text)
            for quantity, value in zip(PARAMETERS, parameters.values(), strict=True)
        ),
        provenance=provenance(read_build_time()),
        text_copy=read_text_copy(),
        programs=parts.programs,
        describing_functions=tuple(told[each.step.id] for each in parts.element_steps),
        solution=tuple(told[each.step.id] for each in parts.number_steps),
        step_of=step_of,
        spread=read_follows(inventory),
        mutation=read_mutation(),
        sections=read_sections(),
        further_statements=len(read_statements(FURTHER)),
        **parts.extras,
    )


def chapters_of(
    subject: Subject, findings: tuple[Finding, ...], inventory: Mapping[str, Statement]
) -> tuple[Chapter, ...]:
    """Return the chapters of a text that have findings, with these in its order."""
    chapters = (
        Chapter(f"chapter-{number}", number, title, _in_order(findings, inventory, number))
        for number, title in subject.chapters.items()
    )
    return tuple(chapter for chapter in chapters if chapter.findings)


def _in_order(
    findings: tuple[Finding, ...], inventory: Mapping[str, Statement], chapter: str
) -> tuple[Finding, ...]:
    own = (finding for finding in findings if inventory[finding.id].chapter == chapter)
    return tuple(sorted(own, key=lambda finding: finding.section.split(".")))


def _told(of: StepWithLines, step_of: Mapping[str, str], parts: Parts) -> DerivationStep:
    step = of.step
    judged = {finding.id for finding in parts.findings}
    shown = tuple(claim for claim in shown_in((step,)) if claim in judged)
    others = (claim for claim, place in step_of.items() if place == step.id and claim not in shown)
    return DerivationStep(
        id=step.id,
        title=step.title,
        text=step.text,
        equations=tuple(Equation(each.latex, each.thesis, each.words) for each in step.formulas),
        claims=shown,
        others=tuple(others),
        code=of.lines,
        picture=parts.pictures.get(step.id),
        folded=step.long,
    )
