"""``trimmer respond``: what a mechanism or a loop settles to."""

from argparse import ArgumentParser, Namespace

from trimmer.command_line.command import Command, uses
from trimmer.command_line.file_options import PICTURES, check_targets, show
from trimmer.command_line.mechanism_options import add_seed_option
from trimmer.command_line.number_options import add_count
from trimmer.command_line.output_options import add_output_options, wanted_picture, write_picture
from trimmer.command_line.parser import refuse_unused
from trimmer.command_line.patience import patience
from trimmer.command_line.system_options import (
    SOURCES,
    add_start_options,
    add_system_options,
    chosen_start,
    chosen_system,
)


def _configure(parser: ArgumentParser) -> None:
    add_system_options(parser)
    add_start_options(parser)
    add_count(parser, "--starts", "number of starts; those after the first one are random", 1)
    add_seed_option(parser)
    add_count(
        parser,
        "--periods",
        "drive periods to wait for a motion to settle (default: 1000); without a drive periods of its "
        "slowest mode (default: 1700, and more where little happens)",
        also="--wait",
    )
    add_output_options(parser, "the motion with contact and stick, phase plane and Poincaré section")


def _run(arguments: Namespace) -> int:
    from trimmer.command_line.mechanisms.respond_text import as_json, as_text
    from trimmer.response.respond import respond

    if arguments.starts == 1:
        refuse_unused(arguments, ["seed"], "--starts")
    check_targets(arguments, {"plot": PICTURES}, SOURCES)
    system = chosen_system(arguments)
    state = chosen_start(arguments, system)
    with patience():
        response = respond(
            system, state=state, starts=arguments.starts, most_periods=arguments.periods, seed=arguments.seed
        )
    motion = response.motion
    drawn = any(each is not None for each in (motion.orbit, motion.window, motion.rest, motion.linear))
    picture = wanted_picture(arguments, "" if drawn else "nothing was found that could be drawn")
    if picture is not None:
        from trimmer.drawing.mechanisms.response import response_figure

        write_picture(arguments, response_figure(response))
    show(as_json(response) if arguments.json else as_text(response), picture)
    return 0


COMMAND = Command(
    "respond",
    "what a mechanism or a loop settles to: repeating, at rest, on a torus or chaotic",
    _configure,
    _run,
    examples=uses("""
    trimmer respond examples/thesis-play.toml --set frictions.blade.force=1
        what the trimmer with play settles to from rest if the friction of the blade is 1 N
    trimmer respond examples/gear-pair.toml --starts 5 --plot motion.svg
        whether a pair of gears settles to other motions from other starts; and a picture of one
    trimmer respond --element friction --gap 4e-5 --impulse 1e-6
        which vibration of its own the thesis's loop settles to after an impulse
    """),
)
