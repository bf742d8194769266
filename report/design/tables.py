"""Rows of the report's tables; the first row is the head. Cells are plain text, or Markdown by their type."""

import math
from collections.abc import Iterable

from report.design.origin import Origin
from report.design.pictures import important
from report.design.quantities import percent, place_words, quantity_words, shown, written
from report.design.report import Equations
from report.design.words import (
    SPECIAL,
    bound_words,
    capital,
    change_words,
    changes_words,
    count,
    counted_in,
    kind_words,
    measure_value,
    measure_words,
    without_margin,
)
from report.pages.escaping import Markdown, code, inline_mathematics
from trimmer.design.analysis.linear import LinearState
from trimmer.design.analysis.spectrum import LineKind, OutputLine, OutputSpectrum
from trimmer.design.design import Design
from trimmer.design.parameter_studies.paths import NumberPath, PathSide
from trimmer.design.specification.targets import Measure, unit_of_measure
from trimmer.design.trials.remedies import Remedy
from trimmer.design.trials.surroundings import SPEEDS, Beside
from trimmer.design.trials.trial import all_measures
from trimmer.mechanism.parts import COUPLINGS
from trimmer.messages import listed
from trimmer.response.periodic.pace import DRIVE_PERIOD

Rows = list[list[str]]
DASH = "—"
ROUNDING = 1e-9  # Damping ratio that rounding can give an undamped mode
ACTION_VALUE = 2.5  # Daily exposure action value, m/s²


def _value(number: float, unit: str = "", digits: int = 3) -> str:
    return shown(number, unit, digits)


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
            rows.append([code(place), f"{_value(found.lowest, unit)} to {_value(found.highest, unit)}"])
        elif value and not (place.endswith(".order") and value == 1):
            rows.append([code(place), _value(value, unit, 6)])
    return rows


def symbol_rows(equations: Equations) -> Rows:
    """Return what the letters mean."""
    return [["Symbol", "Meaning", "Value or unit"]] + [
        [inline_mathematics(each.symbol), each.meaning, each.value] for each in equations.symbols
    ]


def mode_rows(state: LinearState, design: Design) -> Rows:
    """Return the modes of one state of the contacts."""
    head = ["Mode", "Frequency", "Damping ratio", "What moves, relative to the largest"]
    rows = [head]
    for number, mode in enumerate(state.modes, start=1):
        moving = [
            f"{name} {written(_signed(size), 2)}"
            for name, size in zip(state.bodies, mode.shape, strict=True)
            if abs(size) >= 0.05
        ]
        frequency = _value(mode.frequency, "Hz", 4)
        drive = design.file.mechanism.frequency
        if drive:
            frequency += f" ({written(mode.frequency / drive, 3)} × drive)"
        rows.append(
            [
                str(number),
                frequency,
                percent(mode.damping_ratio if mode.damping_ratio > ROUNDING else 0.0, 3),
                ", ".join(moving),
            ]
        )
    return rows


def _signed(size: complex) -> float:
    """Return the modulus with the sign of the real part: light damping leaves shapes nearly real."""
    return math.copysign(abs(size), size.real)


def transfer_rows(design: Design) -> Rows:
    """Return what each output does at the frequency of the drive, by drive and state of the contacts."""
    head = ["From, to", *(f"Contacts {state.contacts.value}" for state in design.linear)]
    rows: dict[tuple[str, str], list[str]] = {}
    for state in design.linear:
        for each in state.transfer:
            if each.at_drive is not None:
                value = _value(abs(each.at_drive), each.per_unit, 4)
                degrees = math.degrees(math.atan2(each.at_drive.imag, each.at_drive.real))
                angle = f"{written(degrees, 3)}°"
                rows.setdefault((each.drive, each.output), []).append(f"{value} at {angle}")
    if len(design.linear) == 1:
        head = ["From, to", "Response"]
    return [head] + [[f"{drive}, {output}", *cells] for (drive, output), cells in rows.items()]


def measure_rows(design: Design) -> Rows:
    """Return outputs and bodies of the first motion."""
    motion = design.motion
    rows, mechanism = [["What", "Peak to peak", "rms"]], design.file.mechanism
    if motion is None:
        return rows
    for name, each in motion.outputs.items():
        unit = mechanism.output_units[name]
        what = f"{name}, {quantity_words(unit)}"
        swing = DASH if motion.switched is not None else _value(each.rms, unit, 4)
        rows.append([what, _value(each.peak_to_peak, unit, 4), swing])
    for name, rms in motion.rms_acceleration.items():
        unit = unit_of_measure(mechanism, Measure.RMS_ACCELERATION, name)
        rows.append([f"{name}, acceleration", DASH, _value(rms, unit, 4)])
    return rows


def motion_rows(design: Design) -> Rows:
    """Return the motions that were found."""
    asked = [each for each in important(design) if each.measure in (Measure.STROKE, Measure.IMPACT_SPEED)][:2]
    rows = [["Motion", *(capital(measure_words(each.measure, each.part)) for each in asked), "Found from"]]
    rows[0].extend([""] * (4 - len(rows[0])))
    for motion in design.motions.found:
        cells = [capital(kind_words(motion)) + (" (a mirror image)" if motion.mirrored else "")]
        for each in asked:
            value = motion.measure(each.measure, each.part)
            cells.append(_value(value, unit_of_measure(design.file.mechanism, each.measure, each.part)))
        origin = count(motion.starts, "start") if motion.starts else "the motion of a similar machine"
        cells.append(f"{origin} of {design.motions.starts}" if motion.starts else origin)
        rows.append(cells + [""] * (4 - len(cells)))
    return rows


def contact_rows(design: Design) -> Rows:
    """Return what plays and stops do."""
    rows = [["Contact", "Impacts per period", "Largest speed", "Largest force", "Time in contact"]]
    mechanism = design.file.mechanism
    if design.motion is not None:
        for name, each in design.motion.contacts.items():
            speed = unit_of_measure(mechanism, Measure.IMPACT_SPEED, name)
            assert each.largest_force is not None, "contacts of mechanisms have forces"
            force = _value(each.largest_force, "N" if speed == "m/s" else "N m")
            rows.append(
                [
                    name,
                    written(each.impacts, 3),
                    _value(each.impact_speed, speed),
                    "an impulse" if name in mechanism.walls and each.impacts else force,
                    percent(each.share),
                ]
            )
    return rows


def closing_rows(design: Design) -> Rows:
    """Return how the contacts of a machine that switches close."""
    rows = [["Contact", "Closes after", "Touches", "Bounces for", "Largest speed", "At the end"]]
    if design.motion is not None and design.motion.switched is not None:
        for name, each in design.motion.switched.closings.items():
            unit = unit_of_measure(design.file.mechanism, Measure.IMPACT_SPEED, name)
            force = _value(abs(each.force), "N" if unit == "m/s" else "N m")
            cells = [_value(each.closing_time, "s", 4), str(each.touches), _value(each.bounce_time, "s", 4)]
            end = f"closed, with {force}" if each.closed else "open"
            rows.append([name, *cells, _value(each.impact_speed, unit), end])
    return rows


def rest_rows(design: Design) -> Rows:
    """Return the forces at which a machine that switches rests at last."""
    rows, mechanism = [["Part", "Force at rest"]], design.file.mechanism
    if design.motion is not None and design.motion.switched is not None:
        sections = {name: section for section in COUPLINGS for name in getattr(mechanism, section)}
        for name, force in design.motion.switched.forces.items():
            unit = mechanism.kind_of(sections[name], name).unit("N")
            rows.append([name, _value(force, unit)])
    return rows


def friction_rows(design: Design) -> Rows:
    """Return what dry frictions do."""
    rows = [["Friction", "Wear power", "Heat per period", "Time in stick"]]
    if design.motion is not None:
        for name, each in design.motion.frictions.items():
            rows.append([name, _value(each.power, "W"), _value(each.work, "J"), percent(each.stick)])
    return rows


def line_rows(spectrum: OutputSpectrum) -> Rows:
    """Return the lines of an output, each with what it is."""
    largest = max(line.amplitude for line in spectrum.lines)
    return [["Frequency", "Amplitude", "Of the largest", "What it is"]] + [
        [
            _value(line.frequency, "Hz", 4),
            _value(line.amplitude, spectrum.unit),
            percent(line.amplitude / largest),
            _explained(line, spectrum.period_word),
        ]
        for line in spectrum.lines
    ]


def _explained(line: OutputLine, period_word: str) -> str:
    ratio = f"{line.numerator}/{line.denominator}"
    parity, repeats = "odd" if line.numerator % 2 else "even", counted_in(period_word, line.denominator)
    drive = "the drive" if period_word == DRIVE_PERIOD else "the sampling"
    what = {
        LineKind.DRIVE: drive,
        LineKind.HARMONIC: f"harmonic {line.numerator} of {drive} ({parity})",
        LineKind.FRACTION: f"{ratio} of {drive}: the motion repeats after {repeats}",
        LineKind.OWN: f"harmonic {line.numerator} of the motion’s own frequency"
        if line.numerator > 1
        else "the motion’s own frequency",
    }[line.kind]
    if line.mode is None or line.contacts is None:
        return what
    return (
        f"{what}; near the mode of {shown(line.mode.frequency, 'Hz', 4)} with contacts "
        f"{line.contacts.value}, which may amplify it"
    )


def margin_rows(design: Design) -> Rows:
    """Return how far gap, speed and friction may move."""
    rows = [["Number", "Down to", "In the file", "Up to"]]
    for path in design.paths:
        unit = path.varied.unit
        rows.append(
            [
                capital(place_words(path.varied.place)),
                _reach(path.down, unit),
                _value(path.varied.value, unit),
                _reach(path.up, unit),
            ]
        )
    return rows


def _reach(side: PathSide | None, unit: str) -> str:
    if side is None:
        return "not looked at"
    if side.reaches is None and side.cut:
        return f"{_value(float(side.values[-1]), unit, 4)} at least"
    if side.reaches is None:
        return f"beyond {_value(side.end, unit)}" if side.end else "zero"
    return _value(side.reaches, unit, 4)


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
                _value(each.value, path.varied.unit, 5),
                SPECIAL[each.kind] + parts,
                *(_value(each.stroke[name], units[name]) for name in outputs),
            ]
        )
    return rows


def exposure_rows(design: Design) -> Rows:
    """Return the vibration of the held body, or of all."""
    rows = [["Body", "rms acceleration", "Weighted", "Hours to 2.5 m/s² a day"]]
    if design.motion is None:
        return rows
    held = design.file.held
    for name, each in design.motion.hand_arm.items():
        if held is None or name == held:
            hours = each.hours_to(ACTION_VALUE)
            rows.append(
                [
                    name,
                    _value(each.rms, "m/s²"),
                    _value(each.weighted, "m/s²"),
                    "more than 24" if hours > 24 else f"{written(hours, 2)} h",
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
