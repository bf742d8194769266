"""What a designer should do and should not: each line of advice with what the search of its box found."""

from functools import partial
from typing import Final

from report.document.advice import Advice, Bound
from report.judging.parts import so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.twin.advice import (
    FORCE_OF_BRIDGE,
    HOUSING,
    IMPACT,
    LINES,
    MOTOR,
    PERIODS,
    STARTS,
    STROKE,
    Searched,
    holds,
    nearest,
)
from report.twin.cell_check import WORDS
from report.twin.figures.design import design_limits
from report.twin.observation import ObservationRecord, Observed, SectionRecord

SOURCE: Final = "report/numbers/twin/advice.py"
SHOWN: Final = {
    MOTOR: (1.0, "m/s²"),
    HOUSING: (1.0, "m/s²"),
    STROKE: (1e3, "mm"),
    PERIODS: (1.0, "drive period"),
    FORCE_OF_BRIDGE: (1.0, "N"),
    IMPACT: (1.0, "m/s"),
}
"""Factor and unit of what is shown of a measure."""


def _record(number: int, line: Advice) -> ObservationRecord:
    words = f"{'Do' if line.wanted else 'Do not'}: {line.text[:1].lower()}{line.text[1:]}"
    return ObservationRecord(f"twin-do-{line.id}", SOURCE, partial(_held, number), words)


def _held(number: int, known: Evidence) -> Observed:
    found = known.twin.advice[number]
    line = found.line
    ranges = ", ".join(_range(place, *ends) for place, ends in line.over.items())
    kinds = ", ".join(f"{count} {kind}" for kind, count in sorted(found.kinds.items()))
    worst = "; ".join(_worst(found, at, bound) for at, bound in enumerate(line.bounds))
    alone = "" if all(holds(line, each) for each in found.starts) else " So it holds from rest alone."
    yield text(f"""
        From rest, for {ranges}. {sum(found.kinds.values())} points were tried: {kinds}. The worst found:
        {worst}.{alone}
    """)
    yield so(
        "it holds at all points that were searched, and at those that this build tried again", found.holds
    )


def _worst(found: Searched, at: int, bound: Bound) -> str:
    worst, of_starts = (nearest(found.line, at, each)[0] for each in (found.worst, found.starts))
    told, again = (_value(bound, each.values[at]) for each in (worst, of_starts))
    if bound.measure == PERIODS and worst.values[at] == of_starts.values[at] == 1.0:
        return f"all repeat after one drive period, from {STARTS - 1} other starts too"
    point = ", ".join(
        f"{factor * value:.5g} {unit}"
        for place, value in zip(found.line.over, worst.point, strict=True)
        for _, factor, unit in (WORDS[place],)
    )
    others = "" if again == told else f", {again} from {STARTS - 1} other starts"
    return f"{told} for “{bound.says}” (at {point}{others})"


def _range(place: str, low: float, high: float) -> str:
    words, factor, unit = WORDS[place]
    return f"{words} {factor * low:g} to {factor * high:g} {unit}"


def _value(bound: Bound, value: float | None) -> str:
    if value is None:
        return "a motion without such a number"
    factor, unit = SHOWN[bound.measure]
    return f"{factor * value:.3g} {unit}"


SECTION = SectionRecord(
    "twin-design", "For the designer", (*(_record(n, line) for n, line in enumerate(LINES)), design_limits)
)
