"""``trimmer simulate``: the exact motion of a mechanism, or of a loop with backlash and friction."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, add_overwrite_option, check_targets, show
from trimmer.command_line.loops.loop_options import unusable
from trimmer.command_line.loops.motion_options import start_of_loop
from trimmer.command_line.mechanisms.simulation import check_periods, draw, mechanism_motion
from trimmer.command_line.number_options import add_positive, positive
from trimmer.command_line.output_options import add_file_option, add_plot_option
from trimmer.command_line.parser import (
    ENDED_EARLY,
    INTERRUPTED,
    OptionError,
    is_given,
    note,
    refuse_unused,
    tell,
)
from trimmer.command_line.patience import patience
from trimmer.command_line.system_options import (
    SOURCES,
    add_start_options,
    add_system_options,
    chosen_start,
    chosen_system,
)
from trimmer.errors import TrimmerError
from trimmer.files import CSV, WAV
from trimmer.messages import near_or_all

if TYPE_CHECKING:
    from trimmer.loops.motion import LoopMotion
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.response.simulation.motion import MechanismMotion
    from trimmer.signals.signal import Signal

LEAST, PERIODS = 0.5, 10  # Length of a motion that is not given, s and in periods of the drive: the longer
MOST_SAMPLES = 50_000_000  # Samples of a signal that still fit into memory with room to spare


def _configure(parser: ArgumentParser) -> None:
    add_system_options(parser)
    add_start_options(parser)
    add_plot_option(parser, "the motion with contact and stick, and of a mechanism its phase plane,")
    add_positive(
        parser,
        "--duration",
        "s",
        f"length of the motion, s (default: {LEAST:g}, or {PERIODS} periods of a slow drive, or without a "
        "drive of the slowest mode that swings)",
    )
    parser.add_argument(
        "--sample-rate",
        "--rate",
        type=positive("Hz"),
        default=20_000.0,
        metavar="HZ",
        help="samples per second in --csv and --wav (default: 20000); the simulation itself needs none",
    )
    add_file_option(
        parser, "--csv", "write time and outputs, or of a loop its output and input and output of the play"
    )
    add_file_option(parser, "--wav", "write the output as sound, into a .wav file")
    add_overwrite_option(parser)
    parser.add_argument("--json", action="store_true", help="print JSON, with every event")


def _run(arguments: Namespace) -> int:
    if arguments.duration is not None:
        check_periods(arguments.duration, None)
    if arguments.csv is None and arguments.wav is None:
        refuse_unused(arguments, ["sample_rate"], "--csv or --wav")
    check_targets(arguments, {"csv": {"": CSV}, "wav": {".wav": WAV}, "plot": PICTURES}, SOURCES)
    motion, text = _moved(arguments)
    targets = [path for path in (arguments.csv, arguments.wav, arguments.plot) if path is not None]
    try:
        _write(arguments, motion)
    except TrimmerError:
        show(text, *targets)
        raise
    show("\n".join([text, *(f"wrote {path}" for path in targets if not arguments.json)]), *targets)
    if motion.success:
        return 0
    from trimmer.loops.motion import Outcome

    tell(f"only {motion.duration:.6g} s of {arguments.duration:.6g} s: {motion.message}")
    return INTERRUPTED if getattr(motion, "outcome", None) is Outcome.INTERRUPTED else ENDED_EARLY


def _moved(arguments: Namespace) -> tuple[LoopMotion | MechanismMotion, str]:
    """Return the motion, and what is told of it."""
    system = chosen_system(arguments, ("displacement",))
    if arguments.duration is None:
        arguments.duration = _usual_duration(arguments, system)
    _check_samples(arguments)
    from trimmer.command_line.loops import motion_text as of_loop
    from trimmer.command_line.mechanisms import motion_text as of_mechanism
    from trimmer.loops.simulation import SimulationInterrupted, simulate_loop
    from trimmer.mechanism.mechanism import Mechanism

    if isinstance(system, Mechanism):
        _check_output(arguments, system)
        moved = mechanism_motion(arguments, system)
        return moved, (of_mechanism.as_json if arguments.json else of_mechanism.as_text)(moved)
    start = list(start_of_loop(arguments, system).values())
    check_periods(arguments.duration, system.frequency)
    try:
        with patience():
            motion = simulate_loop(system, arguments.duration, initial_state=start)
    except SimulationInterrupted as interrupt:
        motion = interrupt.motion
    except ValueError as error:
        raise unusable(arguments, error) from error
    return motion, (of_loop.as_json if arguments.json else of_loop.as_text)(motion)


def _usual_duration(arguments: Namespace, system: Mechanism | TrimmerLoop) -> float:
    """Return the length of a motion that is not given, s; say so where a mode sets it."""
    if system.frequency:
        return max(LEAST, PERIODS / system.frequency)
    from trimmer.contact.flow import MechanismFlow
    from trimmer.loops.flow import LoopFlow
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.motion.time_scale import slowest_met
    from trimmer.response.starts import instant_of

    flow = MechanismFlow(system) if isinstance(system, Mechanism) else LoopFlow(system)
    flow.timed(instant_of(flow, chosen_start(arguments, system)), LEAST)
    duration = PERIODS * slowest_met(flow, decaying=False)
    if duration <= LEAST:
        return LEAST
    note(f"{duration:.4g} s are followed, {PERIODS} periods of the slowest mode that swings (see --duration)")
    return duration


def _check_output(arguments: Namespace, mechanism: Mechanism) -> None:
    """Check the output of a mechanism that is written first, and as sound."""
    if not is_given(arguments, "displacement"):
        return
    if arguments.csv is None and arguments.wav is None:
        raise OptionError("--output has no effect without --csv or --wav: add that, or leave it out")
    name, known = arguments.displacement, mechanism.outputs or mechanism.bodies
    if name not in known:
        raise OptionError(f"--output {name}: there is no such output; {near_or_all(name, known)}")


def _check_samples(arguments: Namespace) -> None:
    """Check the length of signals that are written."""
    duration, rate = arguments.duration, arguments.sample_rate
    written = arguments.csv is not None or arguments.wav is not None
    if written and not 2 <= duration * rate <= MOST_SAMPLES:
        raise OptionError(
            f"--duration {duration:g} s at --sample-rate {rate:g} Hz are {duration * rate:.3g} samples; "
            f"give 2 to {MOST_SAMPLES:g}"
        )


def _write(arguments: Namespace, motion: LoopMotion | MechanismMotion) -> None:
    """Write the files that are wanted."""
    from trimmer.signals.wav import write_wav
    from trimmer.signals.write import write_signal

    if arguments.plot is not None:
        draw(arguments, motion)
    if arguments.csv is None and arguments.wav is None:
        return
    _note_aliasing(motion, arguments)
    signals = _signals(motion, arguments.sample_rate)
    chosen = arguments.displacement if is_given(arguments, "displacement") else signals[0].name
    output, *others = sorted(signals, key=lambda each: each.name != chosen)
    if arguments.csv is not None:
        write_signal(arguments.csv, output, *others, overwrite=arguments.overwrite)
    if arguments.wav is not None:
        write_wav(arguments.wav, output.values, output.sample_rate, overwrite=arguments.overwrite)


def _note_aliasing(motion: LoopMotion | MechanismMotion, arguments: Namespace) -> None:
    """Note on standard error a drive that the files cannot show."""
    from trimmer.loops.motion import LoopMotion
    from trimmer.spectra.doubts import aliasing_doubt

    drive = motion.loop.frequency if isinstance(motion, LoopMotion) else motion.mechanism.frequency
    doubt = aliasing_doubt(drive, arguments.sample_rate) if drive else None
    if doubt is not None:
        note(f"note: {doubt}")


def _signals(motion: LoopMotion | MechanismMotion, sample_rate: float) -> list[Signal]:
    """Sample the outputs; of a loop, its output, and input and output of the backlash, m."""
    import numpy as np

    from trimmer.command_line.loops import motion_text as of_loop
    from trimmer.loops.motion import LoopMotion
    from trimmer.signals.signal import Signal

    times = np.arange(int(motion.duration * sample_rate)) / sample_rate
    if isinstance(motion, LoopMotion):
        sampled = of_loop.displacements(motion, times)
        return [Signal(values, sample_rate, name, "m") for name, values in sampled.items()]
    units = motion.signals
    return [Signal(motion.signal(name, times), sample_rate, name, unit) for name, unit in units.items()]


COMMAND = Command(
    "simulate",
    "exact motion with play and friction, as text, CSV or sound",
    _configure,
    _run,
    examples=uses("""
    trimmer simulate examples/thesis-play.toml --set frictions.blade.force=1 --duration 0.6 --csv
    motion.csv --plot motion.svg
        how bridge and pin meet if the blade rubs with 1 N, as samples and as a picture
    trimmer simulate --gap 4e-5 --element friction --drive 110 --amplitude 1.5e-3 --csv vibration.csv
        how the thesis's trimmer with play moves when it is driven at 110 Hz, as samples
    trimmer simulate --gap 2e-4 --element friction --drive 110 --amplitude 1.5e-3 --friction q2-q4=0.5
        the same with a wide play and dry friction between cutter and guard
    """),
)
