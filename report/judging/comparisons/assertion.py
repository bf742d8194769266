"""Whether a thing that is asserted is so."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self, final

from report.judging.claim import Agreement
from report.judging.shown import Words


@final
@dataclass(frozen=True)
class Assertion:
    """Whether a property that the thesis asserts, or denies, holds.

    ``statement`` puts the property in our words; ``asserted`` is False where the thesis denies it;
    ``derived`` is what was found, ``evidence`` says by what, with its numbers, as Markdown.
    """

    statement: str
    derived: bool
    evidence: str
    method: str
    asserted: bool = True

    def compare(self) -> Agreement:
        """Compare what is asserted with what was found."""
        return Agreement(self.asserted == self.derived, self.method)

    def with_derived(self, derived: bool) -> Self:
        """Hold the same assertion against another finding."""
        return replace(self, derived=derived)

    @property
    def printed_shown(self) -> Words:
        """The statement, as the thesis asserts or denies it."""
        return Words(self.statement if self.asserted else f"Not so: {self.statement}")

    @property
    def derived_shown(self) -> Words:
        """Whether the property holds, and what shows it."""
        return Words(f"{'Yes' if self.derived else 'No'}: {self.evidence}")
