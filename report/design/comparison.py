"""The report on two designs side by side, finished and frozen."""

from dataclasses import dataclass
from functools import partial
from typing import final

import numpy as np

from report.design.figures.over_time import line_spectrum
from report.design.quantities import percent, place_words, shown
from report.design.report import Report
from report.design.words.phrases import capital, count, kind_words, measure_value, measure_words, number_words
from report.design.words.verdict import OUTCOMES
from report.pages.drawing.drawn import drawn
from report.pages.escaping import Markdown, code, markdown
from report.pages.figure import Figure
from trimmer.design import Design, MeasureOfPart
from trimmer.design.comparison import DesignComparison, measures_of
from trimmer.design.specification.targets import Measure, unit_of_measure

NEITHER = "—"


@final
@dataclass(frozen=True)
class ComparisonReport(Report):
    """The report on two designs: what was computed, and what their two files are called."""

    comparison: DesignComparison
    names: tuple[str, str]


def spectra_overlaid(comparison: DesignComparison, names: tuple[str, str]) -> dict[str, Figure]:
    """Draw the lines of each output that both designs have, one over the other."""
    found = {}
    both = [name for name in comparison.before.spectra if name in comparison.after.spectra]
    for number, name in enumerate(both, start=1):
        pair = [(names[0], comparison.before.spectra[name]), (names[1], comparison.after.spectra[name])]
        if all(each.lines for _, each in pair):
            found[f"spectrum-{number}"] = drawn(
                f"spectrum-{number}",
                f"Lines of {name}, before and after",
                f"Lines of {name}: solid with full marks in {names[0]}, dashed with open marks in "
                f"{names[1]}.",
                f"Upright lines over frequency for {names[0]} and {names[1]}.",
                partial(line_spectrum, pair),
            )
    return found


def verdict_rows(comparison: DesignComparison) -> list[list[str]]:
    """Return verdict and motion of both."""
    pair = (comparison.before, comparison.after)
    return [
        ["", "Before", "After"],
        ["File", *(code(each.file.name) for each in pair)],
        ["Verdict", *(OUTCOMES[each.verdict.outcome] for each in pair)],
        ["Settles to", *(_kind(each) for each in pair)],
        ["Motions found", *(str(len(each.motions.found)) for each in pair)],
    ]


def _kind(design: Design) -> str:
    return kind_words(design.motion) if design.motion is not None else "nothing that could be measured"


def change_rows(comparison: DesignComparison) -> list[list[str]]:
    """Return the numbers of the file that differ."""
    rows = [["Number", "Before", "After", "Change"]]
    for each in comparison.changes:
        relative = NEITHER
        if each.before and each.after is not None:
            relative = _signed(each.after / each.before - 1)
        rows.append(
            [
                capital(place_words(each.place)),
                *(_number(v, each.unit) for v in (each.before, each.after)),
                relative,
            ]
        )
    return rows


def _number(value: float | None, unit: str) -> str:
    return NEITHER if value is None else shown(value, unit, 6)


def _unit(comparison: DesignComparison, asked: MeasureOfPart) -> str:
    after = asked in measures_of(comparison.after)
    design = comparison.after if after else comparison.before
    return unit_of_measure(design.file.mechanism, asked.measure, asked.part)


def difference_rows(comparison: DesignComparison) -> list[list[str]]:
    """Return the measures side by side."""
    rows = [["Measure", "Before", "After", "Change"]]
    for each in comparison.differences:
        unit = _unit(comparison, each.asked)
        cells = [
            NEITHER if value is None else measure_value(each.asked.measure, value, unit)
            for value in (each.before, each.after)
        ]
        shows = each.change is not None and each.asked.measure is not Measure.PERIOD
        change = _signed(each.change or 0.0) if shows else NEITHER
        rows.append([capital(measure_words(each.asked.measure, each.asked.part)), *cells, change])
    return rows


def _signed(share: float) -> str:
    return "no change" if abs(share) < 5e-7 else f"{'+' if share > 0 else '−'}{percent(abs(share), 3)}"


def comparison_sentence(comparison: DesignComparison, names: tuple[str, str]) -> Markdown:
    """Return what the change did to the verdict, in one sentence."""
    pair = (comparison.before, comparison.after)
    if not any(each.file.targets for each in pair):
        return Markdown(
            "**Neither file names targets**, so nothing is judged; the measures stand side by side below."
        )
    counts = [sum(judged.met for judged in each.verdict.judged) for each in pair]
    if set(pair[0].file.targets) != set(pair[1].file.targets):
        word = "The files want different things"
    else:
        word = ("As many targets are met", "Better", "Worse")[int(np.sign(counts[1] - counts[0]))]
    told = [f"in {name} {_met(each)}" for name, each in zip(names, pair, strict=True)]
    return markdown("**{}**: {}, {}.", word, *told)


def _met(design: Design) -> str:
    judged = design.verdict.judged
    if not judged:
        return "there is no motion to judge" if design.file.targets else "there are no targets"
    met = sum(each.met for each in judged)
    if len(judged) == 1:
        return f"the target is {'met' if met else 'missed'}"
    share = number_words(met) if met else "none"
    return f"{share} of {count(len(judged), 'target')} {'is' if met < 2 else 'are'} met"
