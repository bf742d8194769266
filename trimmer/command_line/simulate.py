"""``trimmer simulate``: the exact motion of a trimmer with backlash and friction."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command
from trimmer.command_line.motion_options import add_motion_options, chosen_loop, impulse_of

if TYPE_CHECKING:
    from trimmer.motion.motion import Motion
    from trimmer.signals.signal import Signal

MOST_SAMPLES = 50_000_000
"""Largest number of samples of a signal in a file; they fit into memory with room to spare."""


def _configure(parser: ArgumentParser) -> None:
    add_motion_options(parser)
    parser.add_argument(
        "--duration", type=float, default=0.5, metavar="S", help="length of the motion, s (default: 0.5)"
    )
    parser.add_argument(
        "--sample-rate",
        type=float,
        default=20_000.0,
        metavar="HZ",
        help="samples per second in the files (default: 20000); the simulation itself needs none",
    )
    parser.add_argument(
        "--csv", type=Path, metavar="FILE", help="write time, output, and input and output of the play"
    )
    parser.add_argument("--wav", type=Path, metavar="FILE", help="write the output as sound")
    parser.add_argument("--json", action="store_true", help="print JSON, with every event")


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.loop_options import OptionError
    from trimmer.command_line.motion_text import as_json, as_text
    from trimmer.motion.simulation import simulate
    from trimmer.signals.wav import write_wav
    from trimmer.signals.write import write_signal

    loop, impulse = chosen_loop(arguments), impulse_of(arguments)
    if not arguments.duration > 0:
        raise OptionError(f"--duration {arguments.duration:g}: must be positive (s)")
    if not 2 <= arguments.duration * arguments.sample_rate <= MOST_SAMPLES:
        raise OptionError(
            f"--duration {arguments.duration:g} s at --sample-rate {arguments.sample_rate:g} Hz are "
            f"{arguments.duration * arguments.sample_rate:.3g} samples; give 2 to {MOST_SAMPLES:g}"
        )
    try:
        motion = simulate(loop, arguments.duration, impulse=impulse)
    except ValueError as error:
        raise OptionError(str(error)) from error
    if arguments.csv is not None or arguments.wav is not None:
        output, *others = _signals(motion, arguments.sample_rate)
        if arguments.csv is not None:
            write_signal(arguments.csv, output, *others)
        if arguments.wav is not None:
            write_wav(arguments.wav, output.values, output.sample_rate)
    if arguments.json:
        print(as_json(motion))
    else:
        print(as_text(motion))
        for path in (arguments.csv, arguments.wav):
            if path is not None:
                print(f"wrote {path}")
    return 0


def _signals(motion: Motion, sample_rate: float) -> list[Signal]:
    """Sample the output, and input and output of the backlash, m."""
    import numpy as np

    from trimmer.signals.signal import Signal

    times = np.arange(int(motion.duration * sample_rate)) / sample_rate
    named = (
        (motion.loop.model.output_labels[0], motion.output(times)),
        ("pin", motion.element_input(times)),
        ("bridge", motion.element_output(times)),
    )
    return [Signal(values, sample_rate, name, "m") for name, values in named]


COMMAND = Command("simulate", "exact motion with play and friction, as text, CSV or sound", _configure, _run)
"""The subcommand ``trimmer simulate``."""
