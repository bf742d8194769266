"""``trimmer overlay``: a measured motion beside that of a mechanism or a loop."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, add_input, check_targets, show
from trimmer.command_line.loops.motion_options import add_motion_options, chosen_loop
from trimmer.command_line.mechanism_options import add_set_option, mechanism_with
from trimmer.command_line.output_options import add_output_options, write_picture
from trimmer.command_line.parser import OptionError
from trimmer.command_line.patience import patience
from trimmer.command_line.signals.signal_options import add_signal_options, chosen_recording
from trimmer.command_line.system_options import OF_LOOP, SOURCES, refuse_loop_options
from trimmer.files import STANDARD_INPUT
from trimmer.messages import near_or_all

if TYPE_CHECKING:
    from pathlib import Path

    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.signals.signal import Signal
    from trimmer.spectra.comparison import MotionComparison, SimulatedLines


def _configure(parser: ArgumentParser) -> None:
    add_signal_options(parser)
    add_input(
        parser,
        "--against",
        "the mechanism, a TOML file; without one, a loop of the thesis that the options choose",
    )
    add_set_option(parser, OF_LOOP)
    parser.add_argument(
        "--output",
        metavar="NAME",
        help="output of the mechanism or loop that was measured (default: that of the column's name, the "
        "only one, output of a loop)",
    )
    add_motion_options(
        parser,
        output_is_file=True,
        drive_help="frequency of the drive in the measurement (default: found within 3 %% of the "
        "mechanism's); of a loop, that at which it is driven",
    )
    add_output_options(parser, "spectra over each other, and waveforms aligned in time,")


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.signals.overlay_text import Compared, as_json, as_text
    from trimmer.drawing.signals.comparison import comparison_figure

    if arguments.file == arguments.against == STANDARD_INPUT:
        raise OptionError("signal and --against cannot both be read from standard input: name a file")
    sources = {**SOURCES, "file": "the file of the signal", "against": "the file of the mechanism"}
    check_targets(arguments, {"plot": PICTURES}, sources)
    subject: Mechanism | TrimmerLoop
    if arguments.against is None and arguments.element is None and arguments.drive is None:
        raise OptionError("name the mechanism (--against FILE), or choose a loop (--element, --drive)")
    if arguments.against is None:
        subject = chosen_loop(arguments)
        chosen, output = chosen_recording(arguments), _output_of_loop(subject, arguments.output)
    else:
        refuse_loop_options(arguments, but=("drive",))
        subject = mechanism_with(arguments.against, arguments.set)
        chosen = chosen_recording(arguments)
        output = chosen_output(arguments.against, subject, chosen.signal, arguments.output)
    comparison, told = compared_motion(arguments, chosen.signal, subject, output)
    if arguments.plot is not None:
        write_picture(arguments, comparison_figure(comparison))
    driven = subject.frequency is not None
    compared = Compared(arguments.file, arguments.against, output, told, chosen, comparison, driven)
    show((as_json if arguments.json else as_text)(compared), arguments.plot)
    return 0


def chosen_output(against: Path, mechanism: Mechanism, signal: Signal, output: str | None) -> str:
    """Choose the output that is compared: the one that is named, as the signal is, or the only one."""
    names = list(mechanism.outputs)
    if output is None and len(names) == 1:
        return names[0]
    if output is None and signal.name in names:
        return signal.name
    if output is None:
        listed = ", ".join(names) or "none"
        raise OptionError(f"{against}: choose the output that was measured (--output): {listed}")
    if output not in names:
        raise OptionError(f"{against}: there is no output {output!r}; {near_or_all(output, names)}")
    return output


def _output_of_loop(loop: TrimmerLoop, output: str | None) -> str:
    from trimmer.response.flows import flow_of

    names = flow_of(loop).outputs
    if output is not None and output not in names:
        raise OptionError(f"--output {output}: the loop has no such output; {near_or_all(output, names)}")
    return output or next(iter(names))


def compared_motion(
    arguments: Namespace, signal: Signal, mechanism: Mechanism | TrimmerLoop, output: str
) -> tuple[MotionComparison, str]:
    """Return a signal beside what the mechanism settles to from its start, and what that is, in words."""
    from trimmer.signals.signal import SignalError
    from trimmer.spectra.comparison import compare_motions

    with patience():
        lines, told = _simulated_lines(mechanism, output)
    drive = None if arguments.against is None else arguments.drive
    try:
        return compare_motions(signal, lines, drive), told
    except SignalError as error:
        raise OptionError(f"{arguments.file}: {error}") from error


def _simulated_lines(subject: Mechanism | TrimmerLoop, output: str) -> tuple[SimulatedLines, str]:
    """Return the lines of what moves from its start on, and what that is, in words.

    A loop without a drive stays at rest there: it has an orbit that is searched for.
    """
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.response.by_itself.orbit_by_itself import orbit_by_itself
    from trimmer.response.flows import flow_of
    from trimmer.response.respond import respond
    from trimmer.spectra.comparison import SimulatedLines

    if subject.frequency is None and not isinstance(subject, Mechanism):
        orbit = orbit_by_itself(flow_of(subject))
        told = orbit.message
    else:
        motion = respond(subject).motion
        if motion.orbit is None:
            raise OptionError(
                f"the simulated motion does not repeat, so it has no lines to compare: {motion.message} "
                "Average the measured spectrum (trimmer spectrum --average), and see trimmer respond for the "
                "mechanism"
            )
        orbit, told = motion.orbit, motion.message
    frequency = subject.frequency or 1.0 / orbit.period
    lines, unit = orbit.measures.outputs[output].amplitudes, orbit.flow.outputs[output].unit
    by_itself = subject.frequency is None
    return SimulatedLines(lines, frequency, orbit.period_count, unit, by_itself), told


COMMAND = Command(
    "overlay",
    "a measured motion beside what a mechanism settles to",
    _configure,
    _run,
    examples=uses("""
    trimmer overlay vibration.csv --column q2-q4 --against examples/thesis-play.toml
        which harmonics of vibration.csv (see `trimmer simulate --help`) the mechanism has too, in dB
    trimmer overlay vibration.csv --column q2-q4 --against examples/thesis-play.toml --set
    plays.bridge.gap=60um --plot compared.svg
        the same with a wider play, and a picture of both spectra and of both waveforms
    """),
)
