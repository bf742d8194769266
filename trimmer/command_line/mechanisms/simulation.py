"""``trimmer simulate FILE``: the exact motion of a mechanism."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.file_options import file_to_read
from trimmer.command_line.mechanisms.mechanism_options import add_set_option, chosen_mechanism
from trimmer.command_line.mechanisms.state_option import add_state_option, chosen_state
from trimmer.command_line.output_options import add_plot_option, write_picture
from trimmer.command_line.parser import OptionError, as_option, is_given
from trimmer.command_line.patience import patience

if TYPE_CHECKING:
    from trimmer.loops.motion import Motion
    from trimmer.response.motion import MechanismMotion

MOST_PERIODS = 1e9
"""Periods of a drive, or seconds without one, of the longest motion: an hour's work and more."""
OF_LOOPS: tuple[str, ...] = ("element", "gap", "time_constant", "force", "parameters", "output", "channels")
OF_LOOPS += ("drive", "amplitude", "impulse")
"""Options that say what a loop is; a mechanism says it in its file."""


def add_mechanism(parser: ArgumentParser) -> None:
    """Add the file of a mechanism, which may be left out, and what is set in it."""
    parser.add_argument(
        "file",
        type=file_to_read,
        nargs="?",
        metavar="FILE",
        help="mechanism, a TOML file, - for standard input; without one, a loop of the thesis moves",
    )
    add_set_option(parser)
    add_state_option(parser)
    add_plot_option(parser, "the motion with contact and stick, and of a mechanism its phase plane,")


def refuse_options_of_the_other(arguments: Namespace) -> None:
    """Refuse options of loops with a mechanism, and options of mechanisms without one.

    Raises:
        OptionError: if there is one.
    """
    if arguments.file is None:
        for name in ("set", "state"):
            if getattr(arguments, name):
                raise OptionError(
                    f"{as_option(name)} has no effect without the file of a mechanism: add that"
                )
        return
    given = [name for name in OF_LOOPS if is_given(arguments, name)]
    given += ["friction"] if arguments.friction else []
    if given:
        raise OptionError(
            f"{as_option(given[0])} is for the loops of the thesis; a mechanism says it in its file: set the "
            "number there, or with --set"
        )


def mechanism_motion(arguments: Namespace) -> MechanismMotion:
    """Return the motion of the mechanism that the options choose."""
    from trimmer.response.simulate import simulate

    mechanism = chosen_mechanism(arguments)
    check_periods(arguments.duration, mechanism.frequency)
    state = chosen_state(arguments.state, mechanism)
    with patience():
        return simulate(mechanism, arguments.duration, state=state)


def check_periods(duration: float, frequency: float | None) -> None:
    """Refuse a duration, s, of more drive periods than anybody waits for, or without a drive of more seconds.

    Raises:
        OptionError: if it is so long.
    """
    if duration * (frequency or 1.0) > MOST_PERIODS:
        told = f"{duration * frequency:.3g} drive periods" if frequency else "too long without a drive"
        raise OptionError(
            f"--duration {duration:g} s is {told}; give at most {MOST_PERIODS / (frequency or 1.0):.3g} s"
        )


def draw(arguments: Namespace, motion: Motion | MechanismMotion) -> None:
    """Draw the picture that is wanted."""
    from trimmer.drawing.content import figure_of
    from trimmer.drawing.mechanisms.response import motion_figure
    from trimmer.loops.motion import Motion

    figure = figure_of(motion.plot) if isinstance(motion, Motion) else motion_figure(motion)
    write_picture(arguments, figure)
