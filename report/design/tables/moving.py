"""Rows of the tables on what moves: modes, motions, contacts, frictions, lines, exposure."""

import math

from report.design.pictures import important
from report.design.quantities import percent, quantity_words, shown, written
from report.design.tables.judged import DASH, Rows
from report.design.words.phrases import capital, count, counted_in, kind_words, measure_words
from trimmer.design.analysis.linear import LinearState
from trimmer.design.analysis.spectrum import LineKind, OutputLine, OutputSpectrum
from trimmer.design.design import Design
from trimmer.design.specification.targets import Measure, unit_of_measure
from trimmer.mechanism.parts import COUPLINGS
from trimmer.response.periodic.pace import DRIVE_PERIOD

ROUNDING = 1e-9  # Damping ratio that rounding can give an undamped mode
ACTION_VALUE = 2.5  # Daily exposure action value, m/s²


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
        frequency = shown(mode.frequency, "Hz", 4)
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
                value = shown(abs(each.at_drive), each.per_unit, 4)
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
        swing = DASH if motion.switched is not None else shown(each.rms, unit, 4)
        rows.append([what, shown(each.peak_to_peak, unit, 4), swing])
    for name, rms in motion.rms_acceleration.items():
        unit = unit_of_measure(mechanism, Measure.RMS_ACCELERATION, name)
        rows.append([f"{name}, acceleration", DASH, shown(rms, unit, 4)])
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
            cells.append(shown(value, unit_of_measure(design.file.mechanism, each.measure, each.part)))
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
            force = shown(each.largest_force, "N" if speed == "m/s" else "N m")
            rows.append(
                [
                    name,
                    written(each.impacts, 3),
                    shown(each.impact_speed, speed),
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
            force = shown(abs(each.force), "N" if unit == "m/s" else "N m")
            cells = [shown(each.closing_time, "s", 4), str(each.touches), shown(each.bounce_time, "s", 4)]
            end = f"closed, with {force}" if each.closed else "open"
            rows.append([name, *cells, shown(each.impact_speed, unit), end])
    return rows


def rest_rows(design: Design) -> Rows:
    """Return the forces at which a machine that switches rests at last."""
    rows, mechanism = [["Part", "Force at rest"]], design.file.mechanism
    if design.motion is not None and design.motion.switched is not None:
        sections = {name: section for section in COUPLINGS for name in getattr(mechanism, section)}
        for name, force in design.motion.switched.forces.items():
            unit = mechanism.kind_of(sections[name], name).unit("N")
            rows.append([name, shown(force, unit)])
    return rows


def friction_rows(design: Design) -> Rows:
    """Return what dry frictions do."""
    rows = [["Friction", "Wear power", "Heat per period", "Time in stick"]]
    if design.motion is not None:
        for name, each in design.motion.frictions.items():
            rows.append([name, shown(each.power, "W"), shown(each.work, "J"), percent(each.stick)])
    return rows


def line_rows(spectrum: OutputSpectrum) -> Rows:
    """Return the lines of an output, each with what it is."""
    largest = max(line.amplitude for line in spectrum.lines)
    return [["Frequency", "Amplitude", "Of the largest", "What it is"]] + [
        [
            shown(line.frequency, "Hz", 4),
            shown(line.amplitude, spectrum.unit),
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
                    shown(each.rms, "m/s²"),
                    shown(each.weighted, "m/s²"),
                    "more than 24" if hours > 24 else f"{written(hours, 2)} h",
                ]
            )
    return rows
