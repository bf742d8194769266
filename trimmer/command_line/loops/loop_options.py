"""Options of the commands that close a loop: which trimmer, and which nonlinear element."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from trimmer.command_line.file_options import add_input
from trimmer.command_line.parser import OptionError, as_option, is_given, require_positive

if TYPE_CHECKING:
    import control

    from trimmer.elements.element import Element
    from trimmer.loops.loops import ClosedLoop
    from trimmer.loops.measured_loop import MeasuredLoop
    from trimmer.parameters import TrimmerParameters

CHANNELS = ("displacement", "both")


@dataclass(frozen=True)
class ElementChoice:
    """What a choice of ``--element`` takes."""

    needed: tuple[str, ...]  # The options that it needs, in the order of the element's arguments
    # The options that it takes besides, which are the arguments that follow, each with the value it has if it
    # is not given
    optional: Mapping[str, float] = field(default_factory=dict)


ELEMENTS = {
    "friction": ElementChoice(("gap",)),
    "inertia": ElementChoice(("gap",)),
    "viscous": ElementChoice(("gap", "time_constant")),
    "coulomb": ElementChoice(("force",)),
    "relay": ElementChoice(("force",), {"hysteresis": 0.0, "dead_zone": 0.0}),
    "saturation": ElementChoice(("threshold",), {"slope": 1.0}),
    "dead-zone": ElementChoice(("threshold",), {"slope": 1.0}),
    "preload": ElementChoice(("force",), {"slope": 1.0}),
}
ELEMENT_OPTIONS = {
    "gap": "m",
    "time_constant": "s",
    "force": "N",
    "threshold": "m",
    "slope": "output over input",
    "hysteresis": "m",
    "dead_zone": "m",
}
"""Options that have a meaning with an element only, each with its unit."""
MAY_BE_ZERO = ("time_constant", "hysteresis", "dead_zone")


def add_loop_options(parser: ArgumentParser, *, output_is_file: bool = False) -> None:
    """Add parameters, displacement, which is ``--output`` too unless that is a file, and channels."""
    add_input(
        parser,
        "--parameters",
        "TOML file with the trimmer's parameters, - for standard input (default: the thesis's trimmer)",
    )
    parser.add_argument(
        "--displacement",
        *([] if output_is_file else ["--output"]),
        metavar="DISPLACEMENT",
        default="q2-q4",
        help="displacement at the output, such as q2 or q2-q4 (default: q2-q4, cutter relative to guard)",
    )
    parser.add_argument(
        "--channels",
        choices=CHANNELS,
        default=CHANNELS[1],
        help="whether the pin acts by its displacement alone, as in the thesis, or by its velocity too "
        "(default: both)",
    )


def add_element_options(parser: ArgumentParser, *, required: bool = True, gap: bool = True) -> None:
    """Add the options that choose the element, which may be left out unless required; ``--gap`` if asked."""
    parser.add_argument(
        "--element",
        choices=list(ELEMENTS),
        required=required,
        help="backlash controlled by friction, inertia or both (viscous); Coulomb friction; relay; "
        "saturation; dead zone; preload, which is a gain and a relay",
    )
    for name, (metavar, meaning) in _MEANINGS.items():
        if name == "gap" and not gap:
            continue
        parser.add_argument(as_option(name), type=float, metavar=metavar, help=meaning)


_MEANINGS = {
    "gap": ("M", "total clearance of the backlash, m"),
    "time_constant": ("S", "M/D of the load, s (viscous)"),
    "force": ("N", "Coulomb friction, or level of the relay or preload, N (coulomb, relay, preload)"),
    "threshold": ("M", "input at the corner, m (saturation, dead-zone)"),
    "slope": ("RATIO", "output over input on the inclined part (saturation, dead-zone, preload; default: 1)"),
    "hysteresis": ("M", "half the width of the loop, m (relay; default: 0)"),
    "dead_zone": ("M", "half the width without output, m (relay; default: 0)"),
}


def add_response_option(parser: ArgumentParser) -> None:
    """Add the option that takes a measured linear part."""
    add_input(
        parser,
        "--response",
        "measured response of the linear part, a table (CSV) of frequency (Hz) or omega (rad/s), and of "
        "real and imaginary, or magnitude or decibels with phase (rad) or degrees; predictions then lie "
        "between its frequencies alone, without a certificate (default: the trimmer)",
    )


def chosen_loop(arguments: Namespace) -> ClosedLoop | MeasuredLoop:
    """Return the loop of the element and of the trimmer or a measured response."""
    if arguments.response is None:
        return closed_loop(arguments)
    from trimmer.linear.measured_response import measured_response
    from trimmer.loops.measured_loop import MeasuredLoop

    for name in ("parameters", "displacement", "channels"):
        if is_given(arguments, name):
            raise OptionError(
                f"{as_option(name)} is of the trimmer, and --response is in its place; leave one out"
            )
    return MeasuredLoop(measured_response(arguments.response), chosen_element(arguments))


def closed_loop(arguments: Namespace) -> ClosedLoop:
    """Return the closed loop of the linear part and the element that the options choose."""
    from trimmer.loops.loops import ClosedLoop

    element = chosen_element(arguments)
    return ClosedLoop(linear_part(arguments), element)


def unusable(arguments: Namespace, error: ValueError) -> OptionError:
    """Return what is wrong with options whose loop cannot be followed, from the error that says so."""
    from trimmer.errors import IllPosedLoopError

    if isinstance(error, IllPosedLoopError) and (arguments.element, arguments.channels) == (
        "coulomb",
        "both",
    ):
        return OptionError("--element coulomb needs two more poles than zeros: add --channels displacement")
    return OptionError.of(error)


def linear_part(arguments: Namespace) -> control.StateSpace:
    """Return the chosen linear part, from the displacement of the pin (m) to the output (m)."""
    from trimmer.displacement import Displacement
    from trimmer.linear.model import InputChannels, pin_model

    output, channels = (
        Displacement.parse(arguments.displacement),
        InputChannels.chosen(arguments.channels, "--channels"),
    )
    return pin_model(chosen_parameters(arguments), output, channels)


def chosen_parameters(arguments: Namespace) -> TrimmerParameters:
    """Return the parameters of the file that was given, or those of the thesis."""
    from trimmer.parameters import TrimmerParameters

    chosen = arguments.parameters
    return TrimmerParameters.thesis() if chosen is None else TrimmerParameters.from_toml(chosen)


def chosen_element(arguments: Namespace) -> Element:
    """Return the element that the options choose."""
    choice = ELEMENTS[arguments.element]
    for option in ELEMENT_OPTIONS:
        given = is_given(arguments, option)
        if option not in choice.optional and given != (option in choice.needed):
            verb = "does not use" if given else "needs"
            raise OptionError(f"--element {arguments.element} {verb} {as_option(option)}")
    values = dict(choice.optional)
    for option in (*choice.needed, *choice.optional):
        if is_given(arguments, option):
            _require_usable(arguments, option)
            values[option] = getattr(arguments, option)
    return _class_of(arguments.element)(*(values[option] for option in (*choice.needed, *choice.optional)))


def _class_of(word: str) -> Callable[..., Element]:
    from trimmer import elements  # which takes its time

    classes: dict[str, Callable[..., Element]] = {
        "friction": elements.FrictionBacklash,
        "inertia": elements.InertiaBacklash,
        "viscous": elements.ViscousBacklash,
        "coulomb": elements.CoulombFriction,
        "relay": elements.Relay,
        "saturation": elements.Saturation,
        "dead-zone": elements.DeadZone,
        "preload": elements.Preload,
    }
    return classes[word]


def _require_usable(arguments: Namespace, option: str) -> None:
    """Check that the value of an option is positive, or not negative where zero has a meaning."""
    value, unit = getattr(arguments, option), ELEMENT_OPTIONS[option]
    if option not in MAY_BE_ZERO:
        require_positive(arguments, option, unit)
    elif not value >= 0:  # As for a time constant, where 0 is friction alone, infinity inertia alone.
        kinds = "zero, positive or inf" if option == "time_constant" else "zero or positive"
        raise OptionError(f"{as_option(option)} {value:g}: must be {kinds} ({unit})")
    elif option != "time_constant" and math.isinf(value):
        raise OptionError(f"{as_option(option)} {value:g}: must be finite ({unit})")
