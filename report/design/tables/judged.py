"""Rows of tables; the first row is the head. Cells are plain text, or Markdown by their type."""

from collections.abc import Iterable

from report.design.origin import Origin
from report.design.quantities import percent, place_words, shown
from report.design.report import Equations
from report.design.words.phrases import (
    SPECIAL,
    bound_words,
    capital,
    change_words,
    changes_words,
    measure_value,
    measure_words,
    without_margin,
)
from report.pages.escaping import Markdown, code, inline_mathematics
from trimmer.design.design import Design
from trimmer.design.parameter_studies.paths import NumberPath, PathSide
from trimmer.design.specification.targets import Measure, unit_of_measure
from trimmer.design.trials.remedies import Remedy
from trimmer.design.trials.surroundings import SPEEDS, Beside
from trimmer.design.trials.trial import all_measures
from trimmer.messages import listed

Rows = list[list[str]]
DASH = "—"


def target_rows(design: Design) -> Rows:
    """Return each target with what was found, and the worst beside it."""
    around = design.around
    kinds = [each for each in (Beside.SPEED, Beside.SCATTER) if around is not None and around.beside(each)]
    heads = {Beside.SPEED: f"At ±{percent(max(SPEEDS))} speed", Beside.SCATTER: "As numbers scatter"}
    rows = [["Target", "Wanted", "Found", "Margin", *(heads[each] for each in kinds), "Verdict"]]
    for each in design.verdict.judged:
        target = each.target
        worst = [around.worst(target, kind) if around is not None else None for kind in kinds]
        rows.append(
            [
                capital(measure_words(target.measure, target.part)),
                bound_words(target),
                measure_value(target.measure, each.value, target.unit),
                DASH if without_margin(target) else percent(each.margin),
                *(
                    DASH if one is None else measure_value(target.measure, one[1], target.unit)
                    for one in worst
                ),
                Markdown("**missed**")
                if not each.met
                else "missed beside it"
                if target in design.verdict.beside
                else "met",
            ]
        )
    return rows


def remedy_rows(remedies: Iterable[Remedy], design: Design) -> Rows:
    """Return changes with the margins that are left, also beside the point and from other starts, if any."""
    starts = design.remedies.starts if design.remedies else 0
    rows = [["Change", "Margin", "Beside it", "Starts"]] + [
        [
            capital(changes_words(each)),
            _value_of_margin(each.around.margin(Beside.POINT)),
            _value_of_margin(each.margin) if each.beside else "not computed",
            DASH if each.meeting is None else f"{each.meeting} of {starts}",
        ]
        for each in remedies
    ]
    if not (design.file.switched or design.file.stepped):
        return rows
    return [row[: 3 if design.file.uncertainty else 2] for row in rows]


def _value_of_margin(margin: float) -> str:
    return "100 % or more" if margin >= 1 else "misses by far" if margin <= -1 else percent(margin)


def mend_rows(design: Design) -> Rows:
    """Return what a single number does for each target that is missed."""
    mends = design.remedies.mends if design.remedies else ()
    rows = [["Target", "With", "Then it is", "And missed is then"]]
    for each in mends:
        which = capital(measure_words(each.target.measure, each.target.part))
        if each.change is None or each.value is None:
            rows.append([which, "no number that was tried", DASH, DASH])
            continue
        others = [measure_words(one.measure, one.part) for one in each.missed]
        value = measure_value(each.target.measure, each.value, each.target.unit)
        rows.append([which, change_words(each.change), value, listed(others) if others else "none"])
    return rows


def number_rows(design: Design) -> Rows:
    """Return every number of the file that is not zero, by its place."""
    mechanism = design.file.mechanism
    open_ranges = {each.place: each for each in design.file.ranges}
    rows = [["Place", "Value"]]
    for place, unit in mechanism.places.items():
        if place == "frequency" and mechanism.frequency is None:
            continue
        value = mechanism.value(place)
        if place in open_ranges:
            found = open_ranges[place]
            rows.append([code(place), f"{shown(found.lowest, unit)} to {shown(found.highest, unit)}"])
        elif value and not (place.endswith(".order") and value == 1):
            rows.append([code(place), shown(value, unit, 6)])
    return rows


def symbol_rows(equations: Equations) -> Rows:
    """Return what the letters mean."""
    return [["Symbol", "Meaning", "Value or unit"]] + [
        [inline_mathematics(each.symbol), each.meaning, each.value] for each in equations.symbols
    ]


def margin_rows(design: Design) -> Rows:
    """Return how far gap, speed and friction may move."""
    rows = [["Number", "Down to", "In the file", "Up to"]]
    for path in design.paths:
        unit = path.varied.unit
        rows.append(
            [
                capital(place_words(path.varied.place)),
                _reach(path.down, unit),
                shown(path.varied.value, unit),
                _reach(path.up, unit),
            ]
        )
    return rows


def _reach(side: PathSide | None, unit: str) -> str:
    if side is None:
        return "not looked at"
    if side.reaches is None and side.cut:
        return f"{shown(float(side.values[-1]), unit, 4)} at least"
    if side.reaches is None:
        return f"beyond {shown(side.end, unit)}" if side.end else "zero"
    return shown(side.reaches, unit, 4)


def special_rows(path: NumberPath, design: Design) -> Rows:
    """Return the special points of a branch up to where it loses its stability, by rising value."""
    units = design.file.mechanism.output_units
    outputs = list(units)[:1]
    found = [each for side in (path.down, path.up) if side is not None for each in side.first_special]
    rows = [["At", "What happens", *(capital(measure_words(Measure.STROKE, name)) for name in outputs)]]
    for each in sorted(found, key=lambda special: special.value):
        parts = f" ({', '.join(each.parts)})" if each.parts else ""
        rows.append(
            [
                shown(each.value, path.varied.unit, 5),
                SPECIAL[each.kind] + parts,
                *(shown(each.stroke[name], units[name]) for name in outputs),
            ]
        )
    return rows


def range_rows(design: Design) -> Rows:
    """Return the least and the most of each measure over the ranges."""
    rows = [["Measure", "Least", "Most"]]
    if design.ranges is not None:
        file = design.file
        for each in all_measures(file.mechanism, switched=file.switched, stepped=file.stepped):
            low, high = design.ranges.extremes(each)
            unit = unit_of_measure(design.file.mechanism, each.measure, each.part)
            rows.append(
                [
                    capital(measure_words(each.measure, each.part)),
                    measure_value(each.measure, low, unit),
                    measure_value(each.measure, high, unit),
                ]
            )
    return rows


def narrowing_rows(design: Design) -> Rows:
    """Return what each measurement would tell."""
    rows = [["Measured", "Of two, judged differently", "Spread of the measures left"]]
    if design.ranges is not None:
        for each in design.ranges.narrowings:
            doubt = percent(each.doubt) if design.file.targets else DASH
            rows.append([capital(place_words(each.range.place)), doubt, percent(each.spread)])
    return rows


def provenance_rows(origin: Origin) -> Rows:
    """Return what a report was made from."""
    made = origin.provenance
    rows = [["Made from", "Version"]]
    for name, author, digest in origin.files:
        by = [f"author: {author}"] if author else []
        rows.append([code(name), "; ".join([*by, f"SHA-256: {digest}"])])
    rows += [["trimmer", made.version], ["commit", f"{made.commit}, of {made.date[:10]}"]]
    return rows + [[name, version] for name, version in made.libraries]
