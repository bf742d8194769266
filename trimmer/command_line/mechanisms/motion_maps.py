"""``trimmer map``: which motion a mechanism or a loop settles to, over one of its numbers or over two."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from functools import partial
from typing import TYPE_CHECKING

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, add_overwrite_option, check_targets, show
from trimmer.command_line.mechanism_options import add_seed_option
from trimmer.command_line.mechanisms.map_options import (
    EXAMPLE,
    FORM,
    Targets,
    add_measure_option,
    chosen_measures,
    varied_values,
)
from trimmer.command_line.number_options import add_count
from trimmer.command_line.output_options import (
    add_file_option,
    add_json_option,
    add_plot_option,
    write_picture,
)
from trimmer.command_line.parser import INTERRUPTED, OptionError, refuse_unused, tell
from trimmer.command_line.runner_options import (
    add_runner_options,
    check_resuming,
    check_runner_options,
    chosen_runner,
)
from trimmer.command_line.system_options import SOURCES, add_system_options, chosen_system
from trimmer.files import MAP

if TYPE_CHECKING:
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.maps import MotionMap, SpecialCurves
    from trimmer.mechanism.mechanism import Mechanism

MOST_LINES = 1000  # Values of the second number at which branches are followed, each for seconds or minutes


def _configure(parser: ArgumentParser) -> None:
    add_system_options(parser, output_is_file=True)
    parser.add_argument(
        "--vary",
        action="append",
        default=[],
        metavar=FORM,
        help=f"vary a number from A to B in N values, as in {EXAMPLE}; once for a line, twice for a map",
    )
    _add_search_options(parser)
    add_measure_option(parser)
    add_json_option(parser)
    add_plot_option(parser, "the map")
    add_file_option(parser, "--output", "keep each cell in a file as soon as it is done, to be able to go on")
    parser.add_argument("--resume", action="store_true", help="go on with the file of --output")
    add_overwrite_option(parser)
    add_runner_options(parser)


def _add_search_options(parser: ArgumentParser) -> None:
    add_count(
        parser,
        "--periods",
        "drive periods to wait at most (default: 300); without a drive periods of the slowest mode "
        "(default: 1700)",
        also="--wait",
        least=2,
    )
    add_count(
        parser, "--starts", "starts of each cell: rest, or the start in the file, and then random ones", 1
    )
    add_seed_option(parser)
    parser.add_argument(
        "--coexisting",
        action="store_true",
        help="look for more motions by starting each cell from the orbits of the cells around it",
    )
    add_count(
        parser,
        "--special",
        "follow folds, period doublings, grazings and their like over both numbers, from the branches "
        "over the first at N values of the second; they are drawn over the map",
    )


def _run(arguments: Namespace) -> int:
    from trimmer.branches.follow import require_continuous
    from trimmer.maps.motion_map import MapInterruptedError

    _check(arguments)
    system = chosen_system(arguments)
    values = varied_values(system, arguments.vary)
    measures = chosen_measures(system, arguments.measure)
    if arguments.special is not None:
        for place in values:
            require_continuous(place)
    try:
        result, searched = _map(arguments, system, values, list(measures))
        special = _special(arguments, result)
    except MapInterruptedError as interrupt:
        tell(str(interrupt))
        return INTERRUPTED
    _draw(arguments, result, special, measures)
    show(_told(arguments, result, searched, special, measures), arguments.plot, arguments.output)
    return 0


def _check(arguments: Namespace) -> None:
    """Refuse what cannot be meant, before any work is done."""
    check_resuming(arguments)
    if arguments.special is not None and len(arguments.vary) < 2:
        raise OptionError("--special follows points over two numbers: give --vary twice")
    if arguments.special is not None and arguments.special > MOST_LINES:
        raise OptionError(f"--special {arguments.special}: give at most {MOST_LINES} values")
    if arguments.starts == 1:
        refuse_unused(arguments, ["seed"], "--starts, the first of which is not random")
    check_runner_options(arguments)
    targets = {"plot": PICTURES, "output": {"": MAP}}
    check_targets(arguments, targets, SOURCES)


def _map(
    arguments: Namespace, system: Mechanism | TrimmerLoop, values: dict[str, list[float]], measures: list[str]
) -> tuple[MotionMap, str]:
    """Return the map, and what was searched, in a sentence."""
    from trimmer.maps.coexistence import coexisting_motions
    from trimmer.maps.motion_map import motion_map

    runner = chosen_runner(arguments)
    result = motion_map(
        system,
        values,
        most_periods=arguments.periods,
        starts=arguments.starts,
        seed=arguments.seed,
        measures=measures,
        runner=runner,
        file=arguments.output,
        resume=arguments.resume,
        overwrite=arguments.overwrite and arguments.output is not None,
        quiet=arguments.quiet,
    )
    if not arguments.coexisting:
        return result, result.searched
    found = coexisting_motions(result, runner=runner, quiet=arguments.quiet)
    return found.result, found.searched


def _special(arguments: Namespace, result: MotionMap) -> SpecialCurves | None:
    """Return the curves over the map, if they were asked for."""
    if arguments.special is None:
        return None
    from trimmer.maps.motion_map import MapInterruptedError
    from trimmer.maps.special_curves import special_curves
    from trimmer.runners.processes import ProcessRunner

    runner = chosen_runner(arguments, chunk=1) or ProcessRunner(chunk=1)
    try:
        return special_curves(result, lines=arguments.special, runner=runner, quiet=arguments.quiet)
    except KeyboardInterrupt:
        kept = (
            "is lost; name a file (--output) to keep it"
            if arguments.output is None
            else (f"is in {arguments.output}; the same call with --resume goes on with the special points")
        )
        raise MapInterruptedError(f"interrupted while special points were followed; the map {kept}") from None


def _draw(arguments: Namespace, result: MotionMap, special: SpecialCurves | None, measures: Targets) -> None:
    if arguments.plot is not None:
        from trimmer.drawing.content import figure_of

        curves = () if special is None else special.drawn
        measure, target = next(iter(measures.items()), (None, None))
        plot = partial(result.plot, curves=curves, measure=measure, target=target)
        drawn = figure_of(plot, result.inputs.subject.title)
        write_picture(arguments, drawn)


def _told(
    arguments: Namespace, result: MotionMap, searched: str, special: SpecialCurves | None, measures: Targets
) -> str:
    from trimmer.command_line.mechanisms.map_text import as_json, as_text

    if arguments.json:
        return as_json(result, searched, special)
    written = [path for path in (arguments.output, arguments.plot) if path is not None]
    return "\n".join([as_text(result, searched, special, measures), *(f"wrote {path}" for path in written)])


COMMAND = Command(
    "map",
    "which motion a mechanism or a loop settles to, over one or two of its numbers",
    _configure,
    _run,
    examples=uses("""
    trimmer map examples/thesis-play.toml --vary plays.bridge.gap=0um:200um:3 --plot map.svg
        which motion there is at three gaps, and a picture
    trimmer map examples/thesis-play.toml --vary plays.bridge.gap=0um:200um:3 --vary
    frictions.blade.force=1:2:2 --output cells.map
        the same over gap and friction; keeps each cell as soon as it is done, so that the same call
        with --resume goes on after an interrupt
    trimmer map --element friction --gap 4e-5 --friction q2-q4=1 --drive 110 --amplitude 1.5e-3 --vary
    element.gap=40um:200um:3 --vary frictions.q2-q4.force=1:5:2
        which motion the thesis's loop has when it is driven, over gap and friction
    """),
)
