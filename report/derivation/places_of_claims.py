"""The step of the derivation that each claim rests on.

A claim on an equation that a step shows rests on that step. Every other one rests on the step that
``report/data/steps.csv`` names for it, or else for the file that its record names as its source.
"""

import csv
from collections.abc import Iterable, Mapping
from pathlib import Path

from derivations.step import NarrativeStep
from report.judging.finding import Finding
from trimmer.errors import TrimmerError

PATH = Path(__file__).parent.parent / "data" / "steps.csv"


class UnknownStepError(TrimmerError, ValueError):
    """A claim or a source is said to rest on a step that the derivation does not have."""


def named_steps() -> Mapping[str, str]:
    """Return the steps that are named for claims and for source files, by id and by path."""
    with PATH.open(encoding="utf-8", newline="") as file:
        return {row["of"]: row["step"] for row in csv.DictReader(file)}


def shown_in(steps: Iterable[NarrativeStep]) -> dict[str, str]:
    """Return the first step that shows each equation of the thesis, by the id of the equation's claim."""
    shown: dict[str, str] = {}
    for step in steps:
        for formula in step.formulas:
            if formula.thesis:
                shown.setdefault(f"eq-{formula.thesis}", step.id)
    return shown


def places(
    findings: Iterable[Finding], steps: tuple[NarrativeStep, ...], named: Mapping[str, str] | None = None
) -> dict[str, str]:
    """Return the step of each claim by its id, as named, by default in ``named_steps``; others are left out.

    Raises:
        UnknownStepError: naming what is said to rest on a step that is not there.
    """
    by_name = named_steps() if named is None else named
    known = {step.id for step in steps}
    if lost := sorted(of for of, step in by_name.items() if step not in known):
        raise UnknownStepError(f"{', '.join(lost)}: the derivation has no such step; correct {PATH.name}")
    shown = shown_in(steps)
    found = {
        finding.id: by_name.get(finding.id) or shown.get(finding.id) or by_name.get(finding.source, "")
        for finding in findings
    }
    return {claim: step for claim, step in found.items() if step}
