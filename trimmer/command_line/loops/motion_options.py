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
)
from trimmer.command_line.parser import OptionError, refuse_unused, require_positive
from trimmer.sizes import reason_against_size

if TYPE_CHECKING:
    from trimmer.loops.loops import Drive
    from trimmer.loops.trimmer_loop import BodyFriction, TrimmerLoop


def add_motion_options(parser: ArgumentParser) -> None:
    """Add the options that choose the loop, its element and frictions, and its drive or impulse."""
    add_element_options(parser, required=False)
    add_loop_options(parser)
    parser.add_argument(
        "--friction",
        action="append",
        default=[],
        metavar="DISPLACEMENT=N",
        help="Coulomb friction between two bodies, such as q2-q4=0.5; may be given several times",
    )
    parser.add_argument(
        "--drive",
        "--drive-frequency",
        type=float,
        metavar="HZ",
        help="drive the pin at a frequency, Hz (open loop)",
    )
    parser.add_argument("--amplitude", type=float, metavar="M", help="amplitude of the drive, m")
    parser.add_argument(
        "--impulse", type=float, metavar="M*S", help="impulse that sets the closed loop in motion, m s"
    )


def chosen_loop(arguments: Namespace) -> TrimmerLoop:
    """Return the loop that the options choose.

    Raises:
        TrimmerError: if options contradict each other or cannot be used.
    """
    from trimmer.loops.trimmer_loop import TrimmerLoop

    if arguments.element is None:
        refuse_unused(arguments, ELEMENT_OPTIONS, "--element")
    drive = _drive(arguments)
    if drive is None and arguments.element is None:
        raise OptionError(
            "without --element and --drive nothing happens: give the play, the drive (--drive HZ "
            "--amplitude M), or both"
        )
    return TrimmerLoop(
        parameters=chosen_parameters(arguments),
        element=None if arguments.element is None else chosen_element(arguments),
        drive=drive,
        output=arguments.output,
        channels=arguments.channels,
        frictions=tuple(_friction(text) for text in arguments.friction),
    )


def impulse_of(arguments: Namespace) -> float:
    """Return the impulse, m s; a driven loop needs none.

    Raises:
        OptionError: if a loop without drive has none, since it would stay at rest.
    """
    if arguments.impulse is not None:
        if not math.isfinite(arguments.impulse):
            raise OptionError(f"--impulse {arguments.impulse:g}: must be finite (m s)")
        return float(arguments.impulse)
    if arguments.drive is None:
        raise OptionError("the closed loop stays at rest: give --impulse (m s), or --drive for the open loop")
    return 0.0


def _drive(arguments: Namespace) -> Drive | None:
    from trimmer.loops.loops import Drive

    if (arguments.drive is None) != (arguments.amplitude is None):
        missing = "--amplitude (m)" if arguments.amplitude is None else "--drive (Hz)"
        raise OptionError(f"a drive has a frequency and an amplitude: {missing} is missing")
    if arguments.drive is None:
        return None
    require_positive(arguments, "drive", "Hz")
    if not 0 <= arguments.amplitude < math.inf:
        raise OptionError(f"--amplitude {arguments.amplitude:g}: must be finite and not negative (m)")
    try:
        return Drive(arguments.amplitude, frequency=arguments.drive)
    except ValueError as error:
        raise OptionError(f"--drive {arguments.drive:g}: {error}") from error


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
