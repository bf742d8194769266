"""A chapter beside those of the thesis: what the rest of the report has to know of it."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Self

from report.pages.figure import Figure


@dataclass(frozen=True)
class ExtraChapter:
    """What is finished of an extra chapter; each has a template of its own."""

    @property
    def figures(self) -> tuple[Figure, ...]:
        """Its figures."""
        return ()

    @property
    def named(self) -> Mapping[str, str]:
        """Ids of the claims that it names, and where it does, in words."""
        return MappingProxyType({})

    def part(self, kept: Collection[str]) -> Self | None:
        """Return what stays of it in a report with some claims only, by their ids; None if nothing does."""
        return None
