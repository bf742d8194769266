"""A figure to draw, with the words that go with it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from types import FunctionType
from typing import TYPE_CHECKING

from report.document import Figure
from report.drawing.svg import to_svg
from report.evidence import Evidence

if TYPE_CHECKING:
    import matplotlib.figure


@dataclass(frozen=True)
class Drawing:
    """A figure to draw: the claim's id, title, caption (Markdown), alternative text, and how it is drawn."""

    id: str
    title: str
    caption: str
    alternative_text: str
    draw: Callable[[Evidence], matplotlib.figure.Figure]

    @property
    def modules(self) -> frozenset[str]:
        """Modules that draw it: that of ``draw``, or those of the functions that a lambda calls."""
        if not self._is_lambda:
            return frozenset({self.draw.__module__})
        called = (self.draw.__globals__.get(name) for name in self.draw.__code__.co_names)
        return frozenset(each.__module__ for each in called if isinstance(each, FunctionType))

    @property
    def words(self) -> tuple[object, ...]:
        """All that the figure depends on besides its modules: its words, and what a lambda does."""
        code = self.draw.__code__
        call = (code.co_names, code.co_consts, code.co_code) if self._is_lambda else ()
        return (self.id, self.title, self.caption, self.alternative_text, call)

    @property
    def _is_lambda(self) -> bool:
        return self.draw.__name__ == "<lambda>"

    def finished(self, evidence: Evidence) -> Figure:
        """Draw it."""
        svg = to_svg(self.draw(evidence), self.id, self.title, self.alternative_text)
        return Figure(self.id, self.title, self.caption, self.alternative_text, svg)
