"""``trimmer sweep``: run-up and coast-down of a mechanism or a loop, as on a test bench."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, check_targets, show
from trimmer.command_line.mechanisms.map_options import add_interval_options, chosen_interval
from trimmer.command_line.number_options import add_count
from trimmer.command_line.output_options import add_output_options, write_picture
from trimmer.command_line.parser import OptionError, exit_code
from trimmer.command_line.patience import patience
from trimmer.command_line.system_options import (
    SOURCES,
    add_start_options,
    add_system_options,
    chosen_start,
    chosen_system,
)

if TYPE_CHECKING:
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.maps.swept import Sweep
    from trimmer.mechanism.mechanism import Mechanism


def _configure(parser: ArgumentParser) -> None:
    add_system_options(parser)
    add_start_options(parser)
    add_interval_options(
        parser,
        "the number to vary, such as frequency",
        "first value, in SI units (Hz for a frequency) or with a unit",
        "last value",
    )
    parser.add_argument(
        "--back",
        action="store_true",
        help="go back to A too, and say where the two ways differ and where each jumps",
    )
    add_count(parser, "--steps", "equal steps from A to B, both of which are among the N + 1 values", 100)
    add_count(
        parser,
        "--periods",
        "drive periods at each value, of which the second half is measured, 200 by default; without a drive "
        "periods of the slowest mode in which it must rest or repeat, as many as trimmer respond waits",
        None,
        least=2,
    )
    parser.add_argument(
        "--branch",
        action="store_true",
        help="also follow the exact periodic motions from A to B, stable or not, as trimmer follow does",
    )
    add_output_options(
        parser,
        "peak to peak both ways, with waterfalls over orders of the drive or the frequency of its own,",
    )


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.mechanisms.sweep_text import as_json, as_text

    check_targets(arguments, {"plot": PICTURES}, SOURCES)
    system = chosen_system(arguments)
    with patience():
        swept = _swept(arguments, system)
    _draw(arguments, swept)
    show((as_json if arguments.json else as_text)(swept), arguments.plot)
    return exit_code(swept.success, swept.message)


def _swept(arguments: Namespace, system: Mechanism | TrimmerLoop) -> Sweep:
    from trimmer.maps.run_up import sweep

    try:
        return sweep(
            system,
            *chosen_interval(arguments),
            steps=arguments.steps,
            periods=arguments.periods,
            back=arguments.back,
            state=chosen_start(arguments, system),
            branch=arguments.branch,
        )
    except ValueError as error:
        raise OptionError.of(error) from error


def _draw(arguments: Namespace, swept: Sweep) -> None:
    if arguments.plot is not None:
        from trimmer.drawing.mechanisms.sweep import sweep_figure

        write_picture(arguments, sweep_figure(swept))


COMMAND = Command(
    "sweep",
    "run-up and coast-down over any number: jumps, hysteresis, waterfall over orders",
    _configure,
    _run,
    examples=uses("""
    trimmer sweep examples/oscillator-stop.toml --vary frequency --from 1 --to 1.4 --steps 8 --back
        where an oscillator with a stop jumps as its drive runs up from 1 Hz to 1.4 Hz, and down again
    trimmer sweep examples/thesis-play.toml --vary frequency --from 100 --to 110 --steps 4 --periods 100
    --plot waterfall.svg
        the trimmer with play from 100 Hz to 110 Hz; and its orders as a picture
    """),
)
