"""``trimmer fit``: numbers of a mechanism or a loop from a measured steady motion."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, add_input, check_targets, file_to_read, show
from trimmer.command_line.loops.motion_options import add_motion_options, chosen_loop
from trimmer.command_line.mechanism_options import add_seed_option, add_set_option, chosen_mechanism
from trimmer.command_line.number_options import add_count
from trimmer.command_line.output_options import add_file_option, add_output_options, write_picture
from trimmer.command_line.parser import OptionError, refuse_unused
from trimmer.command_line.patience import patience
from trimmer.command_line.signals.signal_options import (
    ChosenRecording,
    add_record_options,
    chosen_recording,
    column,
)
from trimmer.command_line.system_options import OF_LOOP, SOURCES, refuse_loop_options
from trimmer.files import MECHANISM, STANDARD_INPUT, write_atomically
from trimmer.messages import near_or_all

if TYPE_CHECKING:
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.mechanism.mechanism import Mechanism

DRIVE_HELP = (
    "frequency of the drive: for a mechanism, that of the measurement (default: found within 3 %% of the "
    "mechanism's); for a loop, its own, near which that of the measurement is looked for"
)


def _configure(parser: ArgumentParser) -> None:
    add_input(
        parser, "file", "mechanism, a TOML file, - for standard input; without one, a loop (see --element)"
    )
    add_set_option(parser, OF_LOOP)
    add_motion_options(parser, output_is_file=True, drive_help=DRIVE_HELP)
    # A single word is the measurement.
    parser.add_argument(
        "measured",
        type=file_to_read,
        metavar="MEASURED",
        help="CSV file with the samples, one row each, or WAV file; - for CSV from standard input",
    ).required = False
    parser.add_argument(
        "--free",
        action="append",
        default=[],
        metavar="PLACE",
        help="number to fit, such as plays.bridge.gap; may be repeated (default: gap, stiffness and damping "
        "of each play, and the force of each friction, or of a loop all numbers of element and frictions, "
        "where greater than zero)",
    )
    parser.add_argument(
        "--column",
        dest="columns",
        action="append",
        type=column,
        default=[],
        metavar="[OUTPUT=]COLUMN",
        help="column by name or number, and which output it measures; may be repeated "
        "(default: columns with the names of outputs, or the only column and the only output)",
    )
    add_record_options(parser)
    add_count(
        parser,
        "--starts",
        "number of starts; those after the first one are random, up to twice or half of each number",
        5,
    )
    add_seed_option(parser)
    add_file_option(parser, "--output", "write the mechanism with the fitted numbers")
    add_output_options(parser, "measured over fitted waveform and lines, and what is left,")


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.signals.fit_text import ShownFit, as_json, as_text
    from trimmer.fitting.fit import FitSettings, fit
    from trimmer.response.flows import flow_of
    from trimmer.signals.signal import SignalError

    if arguments.measured is None:
        arguments.file, arguments.measured = None, arguments.file
    _check(arguments)
    system, drive = _system(arguments)
    chosen = _recordings(arguments, list(flow_of(system).outputs))
    try:
        with patience():
            fitted = fit(
                system,
                {name: each.signal for name, each in chosen.items()},
                arguments.free,
                drive_frequency=drive,
                settings=FitSettings(starts=arguments.starts, seed=arguments.seed),
            )
    except SignalError as error:
        raise OptionError(f"{arguments.measured}: {error}") from error
    if arguments.plot is not None:
        from trimmer.drawing.signals.fit import fit_figure

        write_picture(arguments, fit_figure(fitted))
    if arguments.output is not None:
        write_atomically(arguments.output, fitted.mechanism.to_toml(), overwrite=arguments.overwrite)
    shown = ShownFit(arguments.file, arguments.measured, arguments.output, chosen, fitted)
    show((as_json if arguments.json else as_text)(shown), arguments.plot, arguments.output)
    return 0


def _system(arguments: Namespace) -> tuple[Mechanism | TrimmerLoop, float | None]:
    """Return what is fitted, and the drive of the measurement where it is given, Hz.

    The drive of a loop is that near which the measured one is looked for.
    """
    if arguments.file is not None:
        refuse_loop_options(arguments, but=("drive",))
        return chosen_mechanism(arguments), arguments.drive
    if arguments.output is not None:
        raise OptionError("--output writes the file of a mechanism, and a loop has none: leave it out")
    loop = chosen_loop(arguments)
    return loop, None


def _check(arguments: Namespace) -> None:
    if arguments.file == arguments.measured == STANDARD_INPUT:
        raise OptionError("mechanism and measurement cannot both be read from standard input: name a file")
    if arguments.starts == 1:
        refuse_unused(arguments, ["seed"], "--starts")
    sources = {**SOURCES, "measured": "the file of the measurement"}
    check_targets(arguments, {"output": {"": MECHANISM}, "plot": PICTURES}, sources)


def _recordings(arguments: Namespace, outputs: list[str]) -> dict[str, ChosenRecording]:
    """Read what was measured of each output."""
    columns = _columns(arguments, outputs)
    if len(columns) > 1:
        refuse_unused(arguments, ["scale", "unit"], "a single column; with several their headings say units")
        if arguments.measured == STANDARD_INPUT:
            raise OptionError("several columns cannot be read from standard input: name a file")
    found = {name: chosen_recording(_reading(arguments, column)) for name, column in columns.items()}
    times = {(s.start, s.sample_rate, s.values.size) for s in (each.signal for each in found.values())}
    if len(times) > 1:
        raise OptionError(f"{arguments.measured}: the columns have unlike times, because values are missing")
    return found


def _reading(arguments: Namespace, chosen: str | None) -> Namespace:
    """Return the options with which one column is read; it is compared in the quantity that was measured."""
    ours = {"file": arguments.measured, "column": chosen, "quantity": None}
    return Namespace(**(vars(arguments) | ours))


def _columns(arguments: Namespace, outputs: list[str]) -> dict[str, str | None]:
    """Return the column of each output that was measured."""
    if not outputs:
        raise OptionError(
            f"{arguments.file}: the mechanism has no output that could be measured; add [outputs]"
        )
    if arguments.columns:
        return _named(arguments, outputs)
    named = [name for name in outputs if name in _headings(arguments.measured)]
    if named:
        return {name: name for name in named}
    if len(outputs) == 1:
        return {outputs[0]: None}
    raise OptionError(
        f"{arguments.measured}: no column has the name of an output; say which measures which "
        f"(--column {outputs[0]}=COLUMN); outputs are {', '.join(outputs)}"
    )


def _named(arguments: Namespace, outputs: list[str]) -> dict[str, str | None]:
    """Return the columns that the options name."""
    from trimmer.signals.reading_wav import is_wav

    if is_wav(arguments.measured):
        raise OptionError("--column has no effect on a WAV file; choose its channel (--channel)")
    found: dict[str, str | None] = {}
    for text in arguments.columns:
        output, chosen = _paired(text, outputs)
        if output in found:
            raise OptionError(
                f"--column {text}: {output} is measured by another column already; leave one out"
            )
        found[output] = chosen
    return found


def _paired(text: str, outputs: list[str]) -> tuple[str, str]:
    """Return output and column of a text; a column may have an equals sign in its name."""
    for output in outputs:
        if text.startswith(f"{output}=") and len(text) > len(output) + 1:
            return output, text[len(output) + 1 :]
    if "=" not in text and len(outputs) == 1:
        return outputs[0], text
    if "=" not in text:
        told = f"say which output it measures: {' or '.join(f'{output}={text}' for output in outputs)}"
        raise OptionError(f"--column {text}: {told}")
    output = text.partition("=")[0]
    raise OptionError(f"--column {text}: there is no output {output!r}; {near_or_all(output, outputs)}")


def _headings(file: Path) -> list[str]:
    """Return the names of the columns of a file; none of one without headings, or from standard input."""
    from trimmer.signals.csv_layout import CsvLayout
    from trimmer.signals.csv_table import read_table
    from trimmer.signals.reading_wav import is_wav
    from trimmer.signals.signal import split_heading

    if file == STANDARD_INPUT or is_wav(file):
        return []
    return [split_heading(heading)[0] for heading in read_table(file, CsvLayout()).headings or ()]


COMMAND = Command(
    "fit",
    "gap, stiffness, damping and friction of a mechanism or a loop from a measured motion, with intervals",
    _configure,
    _run,
    examples=uses("""
    trimmer fit examples/thesis-play.toml motion.csv --from 0.3 --starts 2 --output fitted.toml
        which gap, stiffness, damping and friction explain motion.csv (see `trimmer simulate --help`);
        and the mechanism with them
    trimmer fit examples/thesis-play.toml motion.csv --from 0.3 --starts 1 --free plays.bridge.gap --free
    frictions.blade.force --plot fit.svg
        gap and friction alone, and a picture of the measured motion over the fitted one
    """),
)
