"""``--state BODY=DISPLACEMENT,VELOCITY``: where a mechanism begins."""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Sequence
from typing import TYPE_CHECKING

from trimmer.command_line.parser import OptionError
from trimmer.messages import near_match

if TYPE_CHECKING:
    from trimmer.mechanism.mechanism import Mechanism

EXAMPLE = "write BODY=DISPLACEMENT,VELOCITY, as in motor=1mm,0"


def add_state_option(parser: ArgumentParser) -> None:
    """Add the option that says where bodies begin."""
    parser.add_argument(
        "--state",
        action="append",
        default=[],
        metavar="BODY=M,M/S",
        help="displacement and velocity of a body at the start, such as motor=1mm,0; may be repeated "
        "(default: that of the file, or rest)",
    )


def chosen_state(texts: Sequence[str], mechanism: Mechanism) -> dict[str, tuple[float, float]] | None:
    """Return displacement, m, and velocity, m/s, of the bodies that are given; None if none is.

    Raises:
        OptionError: if a text cannot be read, or names no body.
    """
    found: dict[str, tuple[float, float]] = {}
    for text in texts:
        name, equals, numbers = text.rpartition("=")
        displacement, comma, velocity = numbers.partition(",")
        name = name.strip().strip("\"'")
        if not equals or not comma:
            raise OptionError(f"--state {text}: {EXAMPLE}")
        if name not in mechanism.bodies:
            there = near_match(name, mechanism.bodies) or f"there are {', '.join(mechanism.bodies)}"
            raise OptionError(f"--state {text}: {name!r} is no body; {there}")
        if name in found:
            raise OptionError(f"--state {text}: {name} was given before; give each body once")
        found[name] = _number(text, displacement, "m"), _number(text, velocity, "m/s")
    return found or None


def _number(option: str, text: str, unit: str) -> float:
    from trimmer.mechanism.units import UnitError, quantity

    for wanted in (unit, "1"):
        try:
            return quantity(text.strip(), wanted)
        except UnitError as error:
            reason = error
    raise OptionError(f"--state {option}: {text.strip()!r} {reason}; {EXAMPLE}")
