"""What moves, as options of a command: the file of a mechanism, or in its place a loop of the thesis."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from trimmer.command_line.file_options import add_input
from trimmer.command_line.loops.loop_options import ELEMENT_OPTIONS
from trimmer.command_line.loops.motion_options import (
    add_impulse_option,
    add_motion_options,
    chosen_loop,
    start_of_loop,
)
from trimmer.command_line.mechanism_options import add_set_option, chosen_mechanism
from trimmer.command_line.parser import OptionError, as_option, is_given
from trimmer.command_line.state_option import add_state_option, chosen_state

if TYPE_CHECKING:
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.mechanism.mechanism import Mechanism

FILE_HELP = "mechanism, a TOML file, - for standard input; without one, a loop of the thesis (see --element)"
OF_LOOPS = ("element", *ELEMENT_OPTIONS, "parameters", "displacement", "channels", "drive", "amplitude")
OF_LOOPS += ("impulse",)
"""Options that say what a loop is and does; a mechanism says it in its file."""
OF_LOOP = ", or of the loop, such as element.gap=40um"  # What the help of ``--set`` says of a loop
SOURCES = {"parameters": "the file of the parameters", "file": "the file of the mechanism"}
"""What the files are that are read, by the name of the option."""


def add_system_options(
    parser: ArgumentParser, *, output_is_file: bool = False, file_help: str = FILE_HELP
) -> None:
    """Add the file of a mechanism, which may be left out, the options of a loop, and ``--set``."""
    add_input(parser, "file", file_help, optional=True)
    add_set_option(parser, OF_LOOP)
    add_motion_options(parser, output_is_file=output_is_file)


def add_start_options(parser: ArgumentParser) -> None:
    """Add what says where a motion begins."""
    add_impulse_option(parser)
    add_state_option(parser)


def chosen_start(arguments: Namespace, system: Mechanism | TrimmerLoop) -> Mapping[str, Any] | None:
    """Return what is given of the start, by the names of bodies or states; None for that of the mechanism."""
    from trimmer.mechanism.mechanism import Mechanism

    if isinstance(system, Mechanism):
        return chosen_state(arguments.state, system)
    return start_of_loop(arguments, system)


def chosen_system(arguments: Namespace, but: tuple[str, ...] = ()) -> Mechanism | TrimmerLoop:
    """Return the mechanism or loop that the options choose, with the numbers that are set.

    Options of loops are refused beside the file of a mechanism, but those that mean something for it too.
    """
    if arguments.file is None:
        return chosen_loop(arguments)
    refuse_loop_options(arguments, but)
    return chosen_mechanism(arguments)


def refuse_loop_options(arguments: Namespace, but: tuple[str, ...] = ()) -> None:
    """Refuse options of loops beside the file of a mechanism, but those that mean something for it too."""
    given = [name for name in OF_LOOPS if is_given(arguments, name) and name not in but]
    given += ["friction"] if getattr(arguments, "friction", []) else []
    if given:
        raise OptionError(
            f"{as_option(given[0])} is for the loops of the thesis; a mechanism says it in its file: set the "
            "number there, or with --set"
        )
