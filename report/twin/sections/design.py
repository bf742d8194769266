"""What a designer should do and should not: each line of advice with what the search of its box found."""

from __future__ import annotations

from functools import partial
from typing import Final

from report.document.advice import Advice
from report.judging.parts import so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.twin.advice import FORCE_OF_BRIDGE, LINES, MOTOR, PERIODS, STARTS, STROKE, Searched, Tried
from report.twin.cell_check import WORDS
from report.twin.figures.design import design_limits
from report.twin.observation import ObservationRecord, Observed, SectionRecord

SOURCE: Final = "report/numbers/twin/advice.py"
MEASURED: Final = {
    MOTOR: (1.0, "m/s² at the motor"),
    STROKE: (1e3, "mm of stroke"),
    PERIODS: (1.0, "drive period"),
    FORCE_OF_BRIDGE: (1.0, "N in the bridge"),
}
"""What a measure is shown in, and what it is."""


def _record(number: int, line: Advice) -> ObservationRecord:
    words = f"{'Do' if line.wanted else 'Do not'}: {line.text[:1].lower()}{line.text[1:].rstrip('.')}."
    return ObservationRecord(f"twin-do-{line.id}", SOURCE, partial(_held, number), words)


def _held(number: int, known: Evidence) -> Observed:
    found = known.twin.advice[number]
    line = found.line
    ranges = ", ".join(_range(place, *ends) for place, ends in line.over.items())
    kinds = ", ".join(f"{count} {kind}" for kind, count in sorted(found.kinds.items()))
    yield text(f"""
        From rest, for {ranges}. {len(found.tried)} points were tried: {kinds}. {_worst(found)}
    """)
    yield so("all points that were searched, and those that this build has tried again, hold it", found.holds)


def _worst(found: Searched) -> str:
    line, other = found.line, f"from {STARTS - 1} other starts"
    if line.measure == PERIODS and found.worst.value == found.worst_of_starts.value == 1.0:
        return f"All repeat after one drive period, and those nearest to the bound do {other} too."
    return (
        f"The worst has {_value(line, found.worst)} with {_point(line, found.worst)}; {other} the worst "
        f"points have {_value(line, found.worst_of_starts)} {_of_starts(found)}."
    )


def _of_starts(found: Searched) -> str:
    worst = found.worst_of_starts
    held = found.line.holds(worst.kind, worst.value)
    return "at worst" if held else "at worst, so that the line holds from rest alone"


def _range(place: str, low: float, high: float) -> str:
    words, factor, unit = WORDS[place]
    return f"{words} {factor * low:g} to {factor * high:g} {unit}"


def _point(line: Advice, tried: Tried) -> str:
    told = (
        f"{words} {factor * value:.5g} {unit}"
        for place, value in zip(line.over, tried.point, strict=True)
        for words, factor, unit in (WORDS[place],)
    )
    return ", ".join(told)


def _value(line: Advice, tried: Tried) -> str:
    if tried.value is None:
        return f"a motion that is {tried.kind} and has no such number"
    factor, unit = MEASURED[line.measure]
    return f"{factor * tried.value:.3g} {unit}"


SECTION = SectionRecord(
    "twin-design", "For the designer", (design_limits, *(_record(n, line) for n, line in enumerate(LINES)))
)
