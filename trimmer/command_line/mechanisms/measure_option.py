"""``--measure``: a measure of one's choice, such as ``rattle``, or one with its target."""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeAlias

from trimmer.command_line.number_options import number_in
from trimmer.command_line.parser import OptionError

if TYPE_CHECKING:
    from trimmer.motion.subject import Subject

Targets: TypeAlias = dict[str, float | None]  # Targets, SI units, or None, by the keys of the measures


def add_measure_option(parser: ArgumentParser) -> None:
    """Add the option."""
    parser.add_argument(
        "--measure",
        action="append",
        default=[],
        metavar="KEY[=TARGET]",
        help="measure this too: a key of the JSON of trimmer respond, such as outputs.stroke.rms, or "
        "contacts.NAME.impact_speed, outputs.NAME.lines.1/2, rattle (1 or 0); may be repeated; the picture "
        "shows the first one, with its target, such as =0.3m/s",
    )


def chosen_measures(subject: Subject, texts: Sequence[str]) -> Targets:
    """Return the targets, SI units, or None, by the keys of the measures."""
    from trimmer.mechanism.units import UnitError
    from trimmer.motion.chosen import chosen_measure
    from trimmer.response.flows import flow_of

    found: Targets = {}
    for text in texts:
        key, equals, target = map(str.strip, text.partition("="))
        measure = chosen_measure(flow_of(subject), key)
        try:
            found[measure.key] = number_in(target, measure.unit) if equals else None
        except UnitError as error:
            raise OptionError(f"--measure {text}: {target!r} {error}") from error
    return found
