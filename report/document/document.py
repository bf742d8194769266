"""Everything the report shows, finished and frozen: templates only loop over it and print it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from report.data.mutation import MutationMeasurement
from report.data.sections import Section
from report.data.text_copy import TextCopy
from report.document.explorable import Explorable
from report.document.overview import Answer, CorrectedResult, Opening
from report.document.robustness import Robustness
from report.document.thesis import Chapter, Program
from report.document.twin import TwinChapter
from report.judging.finding import Finding
from report.judging.spread import Follows
from report.pages.derivation import DerivationStep, NomenclatureRow, ParameterRow
from report.pages.figure import Figure
from report.pages.provenance import Provenance


@dataclass(frozen=True)
class Document:
    """The whole report, or a part of it: ``omitted`` are the chapters that a partial report leaves out.

    ``further_statements`` is how many statements were found by a second reading, ``solution`` the steps from
    the equations to numbers, ``step_of`` the id of the step that each claim rests on.
    """

    title: str
    opening: Opening | None
    chapters: tuple[Chapter, ...]
    statements_in_thesis: int
    derivation: tuple[DerivationStep, ...]
    figures: tuple[Figure, ...]
    nomenclature: tuple[NomenclatureRow, ...]
    parameters: tuple[ParameterRow, ...]
    provenance: Provenance
    text_copy: TextCopy
    programs: tuple[Program, ...] = ()
    describing_functions: tuple[DerivationStep, ...] = ()
    solution: tuple[DerivationStep, ...] = ()
    step_of: Mapping[str, str] = field(default_factory=dict)
    explorable: Explorable | None = None
    spread: tuple[Follows, ...] = ()
    answers: tuple[Answer, ...] = ()
    corrected: tuple[CorrectedResult, ...] = ()
    robustness: Robustness | None = None
    mutation: MutationMeasurement | None = None
    sections: tuple[Section, ...] = ()
    omitted: tuple[Chapter, ...] = ()
    further_statements: int = 0
    twin: TwinChapter | None = None

    @property
    def subtitle(self) -> str:
        """The line below the title."""
        return self.provenance.line

    @property
    def steps(self) -> tuple[DerivationStep, ...]:
        """All steps of the derivation, in their order."""
        return (*self.derivation, *self.describing_functions, *self.solution)

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings, in thesis order."""
        return tuple(finding for chapter in self.chapters for finding in chapter.findings)

    @property
    def drawings(self) -> tuple[Figure, ...]:
        """All figures: first screen, claims, the twin, how far it holds, and the explorable."""
        first = (self.opening.figure,) if self.opening else ()
        last = (self.robustness.figure,) if self.robustness else ()
        still = (self.explorable.still,) if self.explorable else ()
        return (*first, *self.figures, *(self.twin.figures if self.twin else ()), *last, *still)
