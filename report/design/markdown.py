"""The report on a design as Markdown, in pieces that follow each other."""

import functools
from typing import Any

from jinja2 import Environment

from report.design import axis, comparison, sentences_around, sliders
from report.design.comparison import ComparisonReport
from report.design.quantities import percent, place_words, shown, written
from report.design.report import DesignReport
from report.design.tables import judged, moving
from report.design.words import phrases, sentences, verdict
from report.pages.displayed import formula
from report.pages.environment import MarkdownEnvironment

PIECES = (
    *(
        "verdict",
        "ranges",
        "step",
        "maps",
        "sliders",
        "motions",
        "contacts",
        "spectrum",
        "exposure",
        "branches",
    ),
    *("sensitivity", "mechanism", "linear", "provenance", "equations"),
)

WORDS = axis, comparison, judged, moving, phrases, sentences, sentences_around, sliders, verdict
"""The modules whose public functions templates call."""


def to_markdown(report: DesignReport) -> dict[str, str]:
    """Return the report as pandoc Markdown, piece by piece."""
    mechanism = report.design.file.mechanism
    content: dict[str, Any] = {
        "report": report,
        "design": report.design,
        "contacts": {**mechanism.plays, **mechanism.stops, **mechanism.walls},
    }
    template = environment().get_template
    steps = report.design.motion is not None and report.design.motion.steps
    pieces = [name for name in PIECES if steps or name != "step"]
    return {name: template(f"design/{name}.md.j2").render(content) for name in pieces}


def comparison_to_markdown(report: ComparisonReport) -> dict[str, str]:
    """Return the report on two designs as pandoc Markdown."""
    return {"comparison": environment().get_template("design/comparison.md.j2").render(report=report)}


@functools.cache
def environment() -> Environment:
    """Return the environment of the templates of designs."""
    made = MarkdownEnvironment()
    made.filters.update(
        shown=shown,
        written=written,
        percent=percent,
        place_words=place_words,
        capital=phrases.capital,
        count=phrases.count,
    )
    made.globals.update({name: vars(module)[name] for module in WORDS for name in _own(module)})
    made.globals.update(formula=formula)
    return made


def _own(module: Any) -> list[str]:
    """Return the names of a module's own public functions."""
    return [
        name
        for name, value in vars(module).items()
        if callable(value) and not name.startswith("_") and value.__module__ == module.__name__
    ]
