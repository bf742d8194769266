"""The chapters of the thesis with what was found in them, and what the report was made from."""

from __future__ import annotations

from dataclasses import dataclass

from report.data.text_copy import BuildTime
from report.judging.finding import Finding


@dataclass(frozen=True)
class Chapter:
    """A chapter or appendix of the thesis with the findings in it, in thesis order."""

    id: str
    number: str
    title: str
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class Provenance:
    """What the report was made from; nothing in it depends on the time or the machine of the build.

    ``build_time`` is the processor time it took when that was last measured.
    """

    version: str
    commit: str
    date: str
    libraries: tuple[tuple[str, str], ...]
    build_time: BuildTime | None = None

    @property
    def line(self) -> str:
        """The line below a report's title."""
        return f"trimmer {self.version}, commit {self.commit}, {self.date[:10]}"
