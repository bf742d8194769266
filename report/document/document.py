"""Everything the report shows, finished and frozen: templates only loop over it and print it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from report.data.mutation import MutationMeasurement
from report.data.statements import ThesisSection
from report.data.text_copy import TextCopy
from report.document.extras import Explorable, ExtraChapter, FutureWork, Overview, Robustness, TwinChapter
from report.document.subject import Subject
from report.document.thesis import Chapter, Program
from report.judging.finding import Finding
from report.judging.spread import Follows
from report.pages.derivation import DerivationStep, NomenclatureRow, ParameterRow
from report.pages.figure import Figure
from report.pages.provenance import Provenance

NOTHING_SAID: Final = Overview()
EXTRAS: Final = ("overview", "twin", "future_work", "robustness", "explorable")
"""The chapters beside those of the thesis, in the order in which they are shown."""


@dataclass(frozen=True)
class Document:
    """The whole report, or a part of it: ``omitted`` are the chapters that a partial report leaves out.

    ``further_statements`` is how many statements were found by a second reading, ``solution`` the steps from
    the equations to numbers, ``step_of`` the id of the step that each claim rests on.
    """

    subject: Subject
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
    spread: tuple[Follows, ...] = ()
    mutation: MutationMeasurement | None = None
    sections: tuple[ThesisSection, ...] = ()
    omitted: tuple[Chapter, ...] = ()
    further_statements: int = 0
    overview: Overview = NOTHING_SAID
    twin: TwinChapter | None = None
    future_work: FutureWork | None = None
    robustness: Robustness | None = None
    explorable: Explorable | None = None

    @property
    def title(self) -> str:
        """Of the report."""
        return self.subject.title

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
    def extras(self) -> Mapping[str, ExtraChapter]:
        """The chapters beside those of the thesis that it has, by the names of their fields."""
        found = {name: getattr(self, name) for name in EXTRAS}
        return {name: chapter for name, chapter in found.items() if chapter is not None}

    @property
    def drawings(self) -> tuple[Figure, ...]:
        """All figures: those of claims, and those of the extra chapters."""
        return (*self.figures, *(figure for each in self.extras.values() for figure in each.figures))
