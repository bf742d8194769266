"""A sentence of the chapter on the twin as one record: its text with numbers, and what it rests on.

    @observation("twin-chaos", source="report/numbers/twin/cases.py")
    def chaos(known: Evidence) -> Observed:
        yield text(f"The exponent is {exponent:.2f}.")
        yield so("it exceeds three standard errors", exponent > 3 * error)

Each confirmation is a check of ``report.judging.parts`` that must hold, or the build stops.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import final

from report.document.extras import Observation, TwinSection
from report.judging.claim import Confirmation
from report.judging.figure import FigureRecord
from report.judging.record import Text, said
from report.judging.text import RecordError, one_line
from report.numbers.evidence import Evidence

Observed = Iterator[Text | Confirmation]
"""What the function of an observation yields: one text, and at least one check."""


class UnsupportedObservationError(RecordError):
    """A check that an observation rests on does not hold; the message names both."""


@final
@dataclass(frozen=True)
class ObservationRecord:
    """An observation before its numbers are known."""

    id: str  # Its place in the report
    source: str  # Path of the file of this project that computes its numbers
    items: Callable[[Evidence], Observed]  # Yields its text and its checks
    title: str = ""  # What it is about, or the question that it answers; empty if it needs none

    def finished(self, known: Evidence) -> Observation:
        """Return the observation with its numbers.

        Raises:
            UnsupportedObservationError: if a check does not hold.
            RecordError: naming the observation, if it has not one text, or no check.
        """
        paragraphs, checks = said(f"observation {self.id}", self.items, known)
        if not checks:
            raise RecordError(f"observation {self.id} has no check; it needs at least one")
        return Observation(
            id=self.id,
            title=one_line(self.title),
            text="\n\n".join(paragraphs),
            evidence=tuple(self._held(check) for check in checks),
            source=self.source,
        )

    def _held(self, check: Confirmation) -> str:
        outcome = check.comparison.compare()
        if not outcome.agrees:
            raise UnsupportedObservationError(
                f"observation {self.id}: what it rests on does not hold: {check.means} ({outcome.method}); "
                "correct the sentence, or what computes its numbers"
            )
        return check.means


def observation(
    observation_id: str, *, source: str, title: str = ""
) -> Callable[[Callable[[Evidence], Observed]], ObservationRecord]:
    """Make an observation of a function that yields its text and its checks."""
    return lambda items: ObservationRecord(observation_id, source, items, title)


@final
@dataclass(frozen=True)
class SectionRecord:
    """A section of the chapter: its place in the report, its title, and what stands in it, in order."""

    id: str
    title: str
    items: tuple[ObservationRecord | FigureRecord, ...]

    def finished(self, known: Evidence) -> TwinSection:
        """Return the section with its numbers."""
        return TwinSection(self.id, self.title, tuple(item.finished(known) for item in self.items))
