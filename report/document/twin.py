"""The chapter on the physical twin."""

from __future__ import annotations

from dataclasses import dataclass

from report.document.extra import ExtraChapter
from report.pages.figure import Figure


@dataclass(frozen=True)
class Observation:
    """A sentence on the physical twin, or a few: Markdown, with what it rests on and where that is computed.

    ``title`` may be empty; ``evidence`` holds one check each, all of which hold, and is never empty.
    """

    id: str
    title: str
    text: str
    evidence: tuple[str, ...]
    source: str


@dataclass(frozen=True)
class TwinSection:
    """A section of the chapter on the twin: observations and figures in their order."""

    id: str
    title: str
    items: tuple[Observation | Figure, ...]


@dataclass(frozen=True)
class TwinChapter(ExtraChapter):
    """What play does in the real trimmer: beside the thesis's chapters, and not about one of them."""

    title: str
    sections: tuple[TwinSection, ...]

    @property
    def observations(self) -> tuple[Observation, ...]:
        """All observations in their order."""
        return tuple(
            item for section in self.sections for item in section.items if isinstance(item, Observation)
        )

    @property
    def figures(self) -> tuple[Figure, ...]:
        """All figures in their order."""
        return tuple(item for section in self.sections for item in section.items if isinstance(item, Figure))
