"""``--state``: where a mechanism or a loop begins, as ``motor=1mm,0`` or ``q2=1mm``."""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Sequence
from typing import TYPE_CHECKING

from trimmer.command_line.number_options import number_in
from trimmer.command_line.parser import OptionError
from trimmer.messages import near_or_all

if TYPE_CHECKING:
    from trimmer.loops.loops import Loop
    from trimmer.mechanism.mechanism import Mechanism

OF_MECHANISM = "body", "write BODY=DISPLACEMENT,VELOCITY, as in motor=1mm,0"
"""What has a state, and how that is written."""
OF_LOOP = "state of the loop", "write STATE=VALUE, as in q2=1mm"  # The same of a loop


def add_state_option(parser: ArgumentParser) -> None:
    """Add the option that says where bodies begin."""
    parser.add_argument(
        "--state",
        action="append",
        default=[],
        metavar="BODY=M,M/S",
        help="displacement and velocity of a body at the start, such as motor=1mm,0, or a state of a loop, "
        "such as q2=1mm; may be repeated (default: that of the file, or rest)",
    )


def chosen_state(texts: Sequence[str], system: Mechanism | Loop) -> dict[str, tuple[float, ...]] | None:
    """Return displacement, m, and velocity, m/s, of the bodies that are given; None if none is.

    Of a loop it is each state that is given, alone, in its unit.
    """
    if not texts:
        return None
    from trimmer.contact.flow import MechanismFlow
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.response.flows import flow_of

    what, example = OF_MECHANISM if isinstance(system, Mechanism) else OF_LOOP
    units = (MechanismFlow(system) if isinstance(system, Mechanism) else flow_of(system)).axis_units
    found: dict[str, tuple[float, ...]] = {}
    for text in texts:
        name, equals, written = text.rpartition("=")
        numbers, name = written.split(","), name.strip().strip("\"'")
        if not equals or len(numbers) != len(units.get(name, numbers)):
            raise OptionError(f"--state {text}: {example}")
        if name not in units:
            raise OptionError(f"--state {text}: {name!r} is no {what}; {near_or_all(name, units)}")
        if name in found:
            raise OptionError(f"--state {text}: {name} was given before; give each {what} once")
        found[name] = tuple(
            _number(text, each, unit, example) for each, unit in zip(numbers, units[name], strict=True)
        )
    return found


def _number(option: str, text: str, unit: str, example: str) -> float:
    from trimmer.mechanism.units import UnitError

    try:
        return number_in(text.strip(), unit)
    except UnitError as error:
        raise OptionError(f"--state {option}: {text.strip()!r} {error}; {example}") from error
