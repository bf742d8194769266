"""Options of the commands that read a measured signal."""

from __future__ import annotations

import math
import os
from argparse import ArgumentParser, Namespace
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from trimmer.command_line.file_options import add_input
from trimmer.command_line.number_options import add_count, add_positive, finite, positive
from trimmer.command_line.parser import OptionError, refuse_unused
from trimmer.files import STANDARD_INPUT

if TYPE_CHECKING:
    from trimmer.signals import Recording, Signal
    from trimmer.signals.fault import Fault

DELIMITERS = ("comma", "semicolon", "tab")
DECIMAL_SIGNS = ("point", "comma")
MISSING_VALUES = ("refuse", "interpolate", "gap")
GAPS = ("refuse", "split")
QUANTITIES = ("displacement", "velocity", "acceleration")
CLIPPED = ("mark", "refuse")
_OF_TEXT = ("column", "time", "delimiter", "decimal", "missing", "gaps", "rate")


def column(text: str) -> str:
    """Read the name of a column, as the type of an option: in UTF-8, as the files, whatever the locale is."""
    try:
        return os.fsencode(text).decode("utf-8")
    except UnicodeError:
        return text


def add_signal_options(parser: ArgumentParser) -> None:
    """Add the file of the signal, and the options that say how to read it and what to make of it."""
    add_input(
        parser,
        "file",
        "WAV file, or CSV file with the samples, one row each, with a heading or not; - for CSV from "
        "standard input",
    )
    _add_column_option(parser)
    add_record_options(parser)
    _add_conversion_options(parser)


def add_record_options(parser: ArgumentParser) -> None:
    """Add the options that say how to read a record, but not which column, and in which unit it is."""
    _add_reading_options(parser)
    _add_stamp_options(parser)
    _add_unit_options(parser)


def _add_column_option(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--column",
        type=column,
        metavar="NAME|NUMBER",
        help="column of the signal (default: the only one beside the time stamps); the first has number 1",
    )


def _add_reading_options(parser: ArgumentParser) -> None:
    add_positive(
        parser,
        "--rate",
        "Hz",
        "samples per second; not needed if a column of time stamps gives it",
        also="--sample-rate",
    )
    parser.add_argument(
        "--time",
        type=column,
        metavar="NAME|NUMBER",
        help="column of the time stamps, s unless its heading says [ms] or the like "
        "(default: the one named t, time or timestamp, if any)",
    )
    parser.add_argument(
        "--delimiter", choices=DELIMITERS, help="what separates columns (default: found out from the file)"
    )
    parser.add_argument(
        "--decimal", choices=DECIMAL_SIGNS, help="decimal sign (default: found out from the numbers)"
    )
    parser.add_argument(
        "--missing",
        choices=MISSING_VALUES,
        default="refuse",
        help="what to do about missing values: refuse, interpolate linearly, take as gaps (default: refuse)",
    )
    add_count(parser, "--channel", "channel of a WAV file; the first has number 1", metavar="NUMBER")


def _add_stamp_options(parser: ArgumentParser) -> None:
    chosen = parser.add_mutually_exclusive_group()
    chosen.add_argument(
        "--ignore-time",
        action="store_true",
        help="leave time stamps aside; samples lie at equal distances, at the --rate that is given",
    )
    chosen.add_argument(
        "--resample",
        action="store_true",
        help="bring samples to equal distances by a cubic spline, at their mean rate or --rate",
    )
    parser.add_argument(
        "--gaps",
        choices=GAPS,
        default="refuse",
        help="what to do about gaps in the time stamps: refuse, or split into stretches, of which the "
        "longest is used; no gap is bridged (default: refuse)",
    )
    parser.add_argument(
        "--from", dest="begin", type=finite("s"), metavar="S", help="use samples from this time on"
    )
    parser.add_argument("--until", type=finite("s"), metavar="S", help="use samples up to this time")


def _add_unit_options(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--scale",
        type=finite(""),
        metavar="FACTOR",
        help="multiply samples, as by the unit over volts of a sensor; for a WAV file what full scale is",
    )
    parser.add_argument(
        "--unit",
        metavar="UNIT",
        help="unit of the samples, after --scale: m, mm, um, m/s, m/s2, g or another",
    )
    parser.add_argument(
        "--clipped",
        choices=CLIPPED,
        default="mark",
        help="what to do about a record that is clipped, or likely to be: mark it in the result, or refuse "
        "it (default: mark)",
    )


def _add_conversion_options(parser: ArgumentParser) -> None:
    parser.add_argument(
        "--as",
        dest="quantity",
        choices=QUANTITIES,
        help="integrate or differentiate to this quantity, in the band that can be trusted, which the result "
        "names",
    )
    for name, meaning in (("lowest", "lower"), ("highest", "upper")):
        parser.add_argument(
            f"--{name}",
            type=positive("Hz"),
            metavar="HZ",
            help=f"{meaning} end of that band (default: from length, noise and sample rate of the record)",
        )
    add_positive(
        parser,
        "--sensor-corner",
        "Hz",
        "3 dB corner of the sensor's high-pass; the band begins at three times it or above",
    )


@dataclass(frozen=True)
class ChosenRecording:
    """A recording as it is analysed, and what was wrong with it as it was measured."""

    recording: Recording
    faults: tuple[Fault, ...]
    full_scale_is_one: bool

    @property
    def signal(self) -> Signal:
        """The longest stretch."""
        return self.recording.longest


def chosen_recording(arguments: Namespace) -> ChosenRecording:
    """Read the recording that the options choose, and convert it."""
    from trimmer.signals.faults import faults
    from trimmer.signals.reading_wav import is_wav
    from trimmer.signals.recording import Recording
    from trimmer.signals.signal import SignalError

    wav = is_wav(arguments.file)
    _check(arguments, wav)
    try:
        measured = _from_wav(arguments) if wav else _from_text(arguments)
        if arguments.scale is not None or arguments.unit is not None:
            stretches = (_with_unit(arguments, stretch) for stretch in measured.stretches)
            measured = replace(measured, stretches=tuple(stretches))
        found = faults(measured.longest)
        _refuse_clipped(arguments, found)
        recording = measured
        if arguments.quantity is not None:
            recording = Recording(_converted(arguments, measured), measured.gaps)
    except SignalError as error:
        raise (
            error if str(error).startswith(str(arguments.file)) else OptionError(f"{arguments.file}: {error}")
        ) from error
    return ChosenRecording(recording, found, wav and arguments.scale is None)


def _check(arguments: Namespace, wav: bool) -> None:
    if wav:
        refuse_unused(arguments, _OF_TEXT, "a CSV file; this one is a WAV file")
        for name, given in (("--ignore-time", arguments.ignore_time), ("--resample", arguments.resample)):
            if given:
                raise OptionError(f"{name} has no effect on a WAV file, which has no stamps: leave it out")
    elif arguments.file == STANDARD_INPUT or arguments.file.exists():
        refuse_unused(arguments, ["channel"], "a WAV file")
    if arguments.quantity is None:
        refuse_unused(arguments, ["lowest", "highest", "sensor_corner"], "--as, which converts")
    if arguments.ignore_time and arguments.rate is None:
        raise OptionError("--ignore-time needs the sample rate: give it (--rate HZ)")


def _from_wav(arguments: Namespace) -> Recording:
    from trimmer.signals.reading_wav import read_wav
    from trimmer.signals.recording import Recording

    begin = 0.0 if arguments.begin is None else arguments.begin
    end = math.inf if arguments.until is None else arguments.until
    return Recording((read_wav(arguments.file, channel=arguments.channel, begin=begin, end=end),))


def _from_text(arguments: Namespace) -> Recording:
    from trimmer.signals.csv_layout import CsvLayout
    from trimmer.signals.read import read_recording
    from trimmer.signals.sampling import Gaps, Sampling, TimeStamps

    stamps = TimeStamps.EQUAL
    if arguments.ignore_time or arguments.resample:
        stamps = TimeStamps.IGNORE if arguments.ignore_time else TimeStamps.RESAMPLE
    recording = read_recording(
        arguments.file,
        column=arguments.column,
        time_column=arguments.time,
        sample_rate=arguments.rate,
        layout=CsvLayout(arguments.delimiter, arguments.decimal),
        missing=arguments.missing,
        sampling=Sampling(stamps, Gaps.chosen(arguments.gaps, "gaps")),
    )
    if arguments.begin is None and arguments.until is None:
        return recording
    begin = -math.inf if arguments.begin is None else arguments.begin
    return recording.between(begin, math.inf if arguments.until is None else arguments.until)


def _with_unit(arguments: Namespace, signal: Signal) -> Signal:
    """Return the signal with scale and unit of the options; a unit that it has already must be the same."""
    unit = signal.unit if arguments.unit is None else arguments.unit
    if arguments.scale is None and signal.unit not in ("", unit):
        raise OptionError(
            f"{arguments.file}: the heading says that {signal.name} is in {signal.unit}, not in {unit}; to "
            "convert give the factor too (--scale)"
        )
    return signal.scaled(1.0 if arguments.scale is None else arguments.scale, unit)


def _refuse_clipped(arguments: Namespace, found: tuple[Fault, ...]) -> None:
    from trimmer.signals.fault import Clipping, FaultCertainty

    for fault in found:
        clipped = isinstance(fault, Clipping) and fault.certainty is not FaultCertainty.POSSIBLE
        if clipped and arguments.clipped == "refuse":
            raise OptionError(f"{arguments.file}: {fault.sentence}")


def _converted(arguments: Namespace, recording: Recording) -> tuple[Signal, ...]:
    """Convert the longest stretch, and in its band those of the others that are long enough."""
    from trimmer.signals.convert import convert
    from trimmer.signals.signal import SignalError

    longest = max(recording.stretches, key=lambda stretch: stretch.values.size)
    first = convert(
        longest,
        arguments.quantity,
        lowest=arguments.lowest,
        highest=arguments.highest,
        sensor_corner=arguments.sensor_corner,
    ).signal
    band = first.trusted
    highest = band.highest if math.isfinite(band.highest) else None
    converted, short = [], 0
    for stretch in recording.stretches:
        try:
            converted.append(
                first
                if stretch is longest
                else convert(stretch, arguments.quantity, lowest=band.lowest or None, highest=highest).signal
            )
        except SignalError:
            short += 1
    if not short:
        return tuple(converted)
    told = f"stretches that are too short to be converted and are left out: {short}"
    return tuple(replace(signal, notes=(*signal.notes, told)) for signal in converted)
