"""The chapter on what the thesis left open, finished and frozen."""

from __future__ import annotations

from dataclasses import dataclass
from typing import final

from report.document.extras import ExtraChapter, Observation, TwinSection
from report.pages.figure import Figure


@final
@dataclass(frozen=True)
class FutureWork(ExtraChapter):
    """An answer to each question of section 6.4, in their order: a section with its figure and its limits."""

    title: str
    sections: tuple[TwinSection, ...]

    @property
    def observations(self) -> tuple[Observation, ...]:
        """All observations in their order."""
        items = (item for section in self.sections for item in section.items)
        return tuple(item for item in items if isinstance(item, Observation))

    @property
    def figures(self) -> tuple[Figure, ...]:
        """All figures in their order."""
        items = (item for section in self.sections for item in section.items)
        return tuple(item for item in items if isinstance(item, Figure))
