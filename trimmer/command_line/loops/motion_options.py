"""Options of the commands that set a trimmer in motion: drive, impulse, friction between bodies."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.loops.loop_options import (
    ELEMENT_OPTIONS,
    add_element_options,
    add_loop_options,
    chosen_element,
    chosen_parameters,
    unusable,
)
from trimmer.command_line.number_options import add_positive
from trimmer.command_line.parser import OptionError, refuse_unused
from trimmer.command_line.state_option import chosen_state
from trimmer.sizes import reason_against_size

if TYPE_CHECKING:
    from trimmer.loops import BodyFriction, Drive, TrimmerLoop
DRIVE_HELP = "drive the pin at a frequency, Hz (open loop)"


def add_motion_options(
    parser: ArgumentParser, *, output_is_file: bool = False, drive_help: str = DRIVE_HELP
) -> None:
    """Add the options that choose the loop, its element and frictions, and its drive."""
    add_element_options(parser, required=False)
    add_loop_options(parser, output_is_file=output_is_file)
    parser.add_argument(
        "--friction",
        action="append",
        default=[],
        metavar="DISPLACEMENT=N",
        help="Coulomb friction between two bodies, such as q2-q4=0.5; may be given several times",
    )
    add_positive(parser, "--drive", "Hz", drive_help, also="--drive-frequency")
    parser.add_argument("--amplitude", type=float, metavar="M", help="amplitude of the drive, m")


def add_impulse_option(parser: ArgumentParser) -> None:
    """Add the impulse that sets a loop in motion."""
    parser.add_argument(
        "--impulse", type=float, metavar="M*S", help="impulse that sets the closed loop in motion, m s"
    )


def chosen_loop(arguments: Namespace) -> TrimmerLoop:
    """Return the loop that the options choose, with the numbers that are set."""
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.mechanism.places import assignment, with_values

    if arguments.element is None:
        refuse_unused(arguments, ELEMENT_OPTIONS, "--element")
    drive = _drive(arguments)
    if drive is None and arguments.element is None:
        raise OptionError(
            "without --element and --drive nothing happens: name the file of a mechanism, or give the play, "
            "the drive (--drive HZ --amplitude M), or both"
        )
    loop = TrimmerLoop(
        parameters=chosen_parameters(arguments),
        element=None if arguments.element is None else chosen_element(arguments),
        drive=drive,
        output=arguments.displacement,
        channels=arguments.channels,
        frictions=tuple(_friction(text) for text in arguments.friction),
    )
    loop = with_values(loop, map(assignment, arguments.set))
    try:
        loop.interconnection()
    except ValueError as error:
        raise unusable(arguments, error) from error
    return loop


def start_of_loop(arguments: Namespace, loop: TrimmerLoop) -> dict[str, float]:
    """Return the states, by name, with which a loop begins: as they are given, after the impulse."""
    given, impulse = chosen_state(arguments.state, loop) or {}, arguments.impulse or 0.0
    if not math.isfinite(impulse):
        raise OptionError(f"--impulse {impulse:g}: must be finite (m s)")
    if loop.drive is None and not given and arguments.impulse is None:
        raise OptionError(
            "the closed loop stays at rest: give --impulse (m s) or --state, or --drive for the open loop"
        )
    pushed = (loop.model.B[:, 0] * impulse).tolist()
    labels = loop.model.state_labels
    return {name: sum(given.get(name, ())) + push for name, push in zip(labels, pushed, strict=True)}


def _drive(arguments: Namespace) -> Drive | None:
    from trimmer.loops.drive import Drive

    if (arguments.drive is None) != (arguments.amplitude is None):
        missing = "--amplitude (m)" if arguments.amplitude is None else "--drive (Hz)"
        raise OptionError(f"a drive has a frequency and an amplitude: {missing} is missing")
    if arguments.drive is None:
        return None
    if not 0 <= arguments.amplitude < math.inf:
        raise OptionError(f"--amplitude {arguments.amplitude:g}: must be finite and not negative (m)")
    return Drive(arguments.amplitude, frequency=arguments.drive)


def _friction(text: str) -> BodyFriction:
    from trimmer.displacement import Displacement
    from trimmer.elements.coulomb_friction import CoulombFriction
    from trimmer.loops.trimmer_loop import BodyFriction

    between, equals, force = text.partition("=")
    if not equals:
        raise OptionError(f"--friction {text}: write the displacement and the force, such as q2-q4=0.5")
    try:
        magnitude = float(force)
    except ValueError:
        raise OptionError(f"--friction {text}: {force!r} is not a number (N)") from None
    if reason := reason_against_size(magnitude):
        raise OptionError(f"--friction {text}: {reason}")
    try:
        return BodyFriction(Displacement.parse(between), CoulombFriction(magnitude))
    except ValueError as error:
        raise OptionError(f"--friction {text}: {error}") from error
