"""``trimmer simulate FILE``: the exact motion of a mechanism."""

from __future__ import annotations

from argparse import Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.output_options import write_picture
from trimmer.command_line.parser import OptionError
from trimmer.command_line.patience import patience
from trimmer.command_line.state_option import chosen_state

if TYPE_CHECKING:
    from trimmer.loops.motion import LoopMotion
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.response.simulation.motion import MechanismMotion

MOST_PERIODS = 1e9
"""Periods of a drive, or seconds without one, of the longest motion: an hour's work and more."""


def mechanism_motion(arguments: Namespace, mechanism: Mechanism) -> MechanismMotion:
    """Return the motion of a mechanism."""
    from trimmer.response.simulation.simulate import simulate

    check_periods(arguments.duration, mechanism.frequency)
    state = chosen_state(arguments.state, mechanism)
    with patience():
        return simulate(mechanism, arguments.duration, state=state)


def check_periods(duration: float, frequency: float | None) -> None:
    """Refuse a duration, s, of more drive periods, or without a drive seconds, than anybody waits for."""
    if duration * (frequency or 1.0) > MOST_PERIODS:
        told = f"{duration * frequency:.3g} drive periods" if frequency else "too long without a drive"
        raise OptionError(
            f"--duration {duration:g} s is {told}; give at most {MOST_PERIODS / (frequency or 1.0):.3g} s"
        )


def draw(arguments: Namespace, motion: LoopMotion | MechanismMotion) -> None:
    """Draw the picture that is wanted."""
    from trimmer.drawing.content import figure_of
    from trimmer.drawing.mechanisms.response import motion_figure
    from trimmer.loops.motion import LoopMotion

    figure = figure_of(motion.plot) if isinstance(motion, LoopMotion) else motion_figure(motion)
    write_picture(arguments, figure)
