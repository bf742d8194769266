"""Options of the commands that close a loop: which trimmer, and which nonlinear element."""

from __future__ import annotations

import math
from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from trimmer.command_line.file_options import add_input
from trimmer.command_line.parser import OptionError, as_option, is_given, require_positive

if TYPE_CHECKING:
    import control

    from trimmer.elements.element import Element
    from trimmer.loops.loops import ClosedLoop
    from trimmer.parameters import TrimmerParameters

CHANNELS = ("displacement", "both")


@dataclass(frozen=True)
class ElementChoice:
    """A choice of the option ``--element``.

    Attributes:
        name: The word that selects the element.
        options: The options it needs, in the order in which ``make`` takes their values.
        make: Returns the element for the values of these options, in SI units.
        optional: The options that it takes besides, each with the value it has if it is not given; ``make``
            takes them after the others.
    """

    name: str
    options: tuple[str, ...]
    make: Callable[..., Element]
    optional: tuple[tuple[str, float], ...] = ()


def _friction(gap: float) -> Element:
    from trimmer.elements.backlashes.friction_backlash import FrictionBacklash

    return FrictionBacklash(gap)


def _inertia(gap: float) -> Element:
    from trimmer.elements.backlashes.inertia_backlash import InertiaBacklash

    return InertiaBacklash(gap)


def _viscous(gap: float, time_constant: float) -> Element:
    from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash

    return ViscousBacklash(gap, time_constant)


def _coulomb(force: float) -> Element:
    from trimmer.elements.coulomb_friction import CoulombFriction

    return CoulombFriction(force)


def _relay(force: float, hysteresis: float, dead_zone: float) -> Element:
    from trimmer.elements.relay import Relay

    return Relay(force, hysteresis, dead_zone)


def _saturation(threshold: float, slope: float) -> Element:
    from trimmer.elements.saturation import Saturation

    return Saturation(threshold, slope)


def _dead_zone(threshold: float, slope: float) -> Element:
    from trimmer.elements.dead_zone import DeadZone

    return DeadZone(threshold, slope)


def _preload(force: float, slope: float) -> Element:
    from trimmer.elements.preload import Preload

    return Preload(force, slope)


ELEMENTS = (
    ElementChoice("friction", ("gap",), _friction),
    ElementChoice("inertia", ("gap",), _inertia),
    ElementChoice("viscous", ("gap", "time_constant"), _viscous),
    ElementChoice("coulomb", ("force",), _coulomb),
    ElementChoice("relay", ("force",), _relay, (("hysteresis", 0.0), ("dead_zone", 0.0))),
    ElementChoice("saturation", ("threshold",), _saturation, (("slope", 1.0),)),
    ElementChoice("dead-zone", ("threshold",), _dead_zone, (("slope", 1.0),)),
    ElementChoice("preload", ("force",), _preload, (("slope", 1.0),)),
)


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


def add_element_options(parser: ArgumentParser, *, required: bool = True) -> None:
    """Add the options that choose the element, which may be left out unless required."""
    parser.add_argument(
        "--element",
        choices=[choice.name for choice in ELEMENTS],
        required=required,
        help="backlash controlled by friction, inertia or both (viscous); Coulomb friction; relay; "
        "saturation; dead zone; preload, which is a gain and a relay",
    )
    for name, (metavar, meaning) in _MEANINGS.items():
        parser.add_argument(as_option(name), type=float, metavar=metavar, help=meaning)


_MEANINGS = {
    "gap": ("M", "total clearance of the backlash, m"),
    "time_constant": ("S", "M/D of the load, s (viscous)"),
    "force": ("N", "Coulomb friction, or level of the relay or preload, N (coulomb, relay, preload)"),
    "threshold": ("M", "input at the corner, m (saturation, dead-zone)"),
    "slope": (
        "RATIO",
        "output over input on the inclined part (saturation, dead-zone, preload; default: 1)",
    ),
    "hysteresis": ("M", "half the width of the loop, m (relay; default: 0)"),
    "dead_zone": ("M", "half the width without output, m (relay; default: 0)"),
}


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
    return OptionError(str(error))


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
    choice = next(choice for choice in ELEMENTS if choice.name == arguments.element)
    optional = dict(choice.optional)
    for option in ELEMENT_OPTIONS:
        given = is_given(arguments, option)
        if option not in optional and given != (option in choice.options):
            verb = "does not use" if given else "needs"
            raise OptionError(f"--element {choice.name} {verb} {as_option(option)}")
    for option in (*choice.options, *optional):
        if is_given(arguments, option):
            _require_usable(arguments, option)
    values = [getattr(arguments, option) for option in choice.options]
    values += [
        getattr(arguments, option) if is_given(arguments, option) else default
        for option, default in choice.optional
    ]
    return choice.make(*values)


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
