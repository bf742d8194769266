"""``trimmer follow``: a branch of exact periodic motions of a mechanism or a loop over any of its numbers."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, check_targets, show
from trimmer.command_line.mechanisms.map_options import (
    add_interval_options,
    add_measure_option,
    chosen_interval,
    chosen_measures,
)
from trimmer.command_line.number_options import add_count
from trimmer.command_line.output_options import add_output_options, wanted_picture, write_picture
from trimmer.command_line.parser import OptionError, exit_code, refuse_unused
from trimmer.command_line.patience import patience
from trimmer.command_line.system_options import SOURCES, add_system_options, chosen_system

if TYPE_CHECKING:
    from trimmer.branches.followed import FollowedBranch
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.mechanism.mechanism import Mechanism

MOST_HARMONICS = 1000  # Harmonics whose equations are solved in seconds; an orbit with stick needs hundreds


def _configure(parser: ArgumentParser) -> None:
    add_system_options(parser)
    add_interval_options(
        parser,
        "the number to vary, such as frequency, plays.bridge.gap, or of a loop element.gap",
        "first value, where it settles from rest, in SI units (Hz for a frequency) or with a unit; a "
        "loop without a drive begins with its largest stable limit cycle there",
        "the other end of the interval",
    )
    add_count(
        parser,
        "--periods",
        "drive periods after which the motion repeats (default: those after which it does)",
        metavar="K",
    )
    add_count(parser, "--points", "most motions on each branch", 2000, least=2)
    add_count(parser, "--wait", "drive periods to wait at A until it has settled", 2000)
    parser.add_argument(
        "--switches",
        type=int,
        choices=range(5),
        default=1,
        help="how many times in succession to change to a branch that splits off (default: 1)",
    )
    add_count(
        parser,
        "--harmonics",
        "also run multi-harmonic balance with this many harmonics, and say how far off it is",
    )
    add_measure_option(parser)
    add_output_options(parser, "the branch")


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.mechanisms.follow_text import as_json, as_text

    check_targets(arguments, {"plot": PICTURES}, SOURCES)
    if arguments.harmonics is not None and arguments.harmonics > MOST_HARMONICS:
        raise OptionError(f"--harmonics {arguments.harmonics}: give at most {MOST_HARMONICS}")
    system, of_loop = chosen_system(arguments), arguments.file is None
    if of_loop:
        refuse_unused(arguments, ["harmonics"], "the file of a mechanism")
    if system.frequency is None:
        drive = "--drive" if of_loop else "a frequency in the file"
        refuse_unused(arguments, ["periods", "harmonics", "wait"], drive)
    measures = chosen_measures(system, arguments.measure)
    with patience():
        branch = _branch(arguments, system)
    picture = wanted_picture(arguments, "" if branch.points else "there is no motion on the branch")
    if picture is not None:
        from trimmer.drawing.mechanisms.branch import branch_figure

        measure, target = next(iter(measures.items()), (None, None))
        write_picture(arguments, branch_figure(branch, measure, target))
    text = (as_json if arguments.json else as_text)(branch, arguments.harmonics, tuple(measures))
    show(text, picture)
    return exit_code(branch.success, branch.message)


def _branch(arguments: Namespace, system: Mechanism | TrimmerLoop) -> FollowedBranch:
    from trimmer.branches.follow import follow
    from trimmer.branches.settings import FollowSettings

    interval = chosen_interval(arguments)
    try:
        settings = FollowSettings(
            most_points=arguments.points, switches=arguments.switches, most_periods=arguments.wait
        )
        return follow(system, *interval, periods=arguments.periods, settings=settings)
    except ValueError as error:
        raise OptionError.of(error) from error


COMMAND = Command(
    "follow",
    "exact periodic motions of a mechanism or a loop over any of its numbers",
    _configure,
    _run,
    examples=uses("""
    trimmer follow examples/thesis-play.toml --vary frictions.blade.force --from 1 --to 0.9
        how the stroke changes as the friction of the blade falls from 1 N to 0.9 N
    trimmer follow examples/oscillator-stop.toml --vary frequency --from 0.85 --to 1.45
        between which frequencies an oscillator with a stop has two stable motions: between the folds
    trimmer follow --element friction --gap 4e-5 --vary element.gap --from 40um --to 38um
        how the limit cycle of the thesis's loop shrinks with its gap
    """),
)
