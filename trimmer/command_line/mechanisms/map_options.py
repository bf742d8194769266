"""Options that vary numbers, ``--vary PLACE=A:B:N`` or ``--from`` and ``--to``; nothing is evaluated."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from typing import TypeAlias

from trimmer.command_line.number_options import number_in
from trimmer.command_line.parser import OptionError
from trimmer.errors import TrimmerError
from trimmer.motion.subject import Subject

FORM = "PLACE=A:B:N"
EXAMPLE = "plays.bridge.gap=0um:500um:50"
MOST_VALUES = 100_000
_DIGITS = 9  # As many digits as are looked at: a number of thousands of them is too large at once


def add_interval_options(parser: ArgumentParser, vary: str, start: str, stop: str) -> None:
    """Add ``--vary``, ``--from`` and ``--to``, with what the help says of each."""
    parser.add_argument("--vary", required=True, metavar="PLACE", help=vary)
    parser.add_argument("--from", required=True, dest="start", metavar="A", help=start)
    parser.add_argument("--to", required=True, dest="stop", metavar="B", help=stop)


def chosen_interval(arguments: Namespace) -> tuple[str, float | str, float | str]:
    """Return the place of the number, its first and its last value."""
    from trimmer.mechanism.place_text import parse_place
    from trimmer.mechanism.places import assignment

    parse_place(arguments.vary)
    (place, start), (_, stop) = (
        assignment(f"{arguments.vary}={each}") for each in (arguments.start, arguments.stop)
    )
    return place, start, stop


def varied_values(subject: Subject, texts: Sequence[str]) -> dict[str, list[float]]:
    """Return evenly spaced values, SI, by places, of texts such as ``plays.bridge.gap=0um:500um:50``."""
    if not 1 <= len(texts) <= 2:
        given = "is missing" if not texts else f"was given {len(texts)} times"
        raise OptionError(
            f"--vary {given}: give it once for a line or twice for a map, as in --vary {EXAMPLE}"
        )
    found: dict[str, list[float]] = {}
    for text in texts:
        place, values = _varied(subject, text)
        if place in found:
            raise OptionError(f"--vary {place} was given twice: vary two different numbers, or one")
        found[place] = values
    return found


def _varied(subject: Subject, text: str) -> tuple[str, list[float]]:
    from trimmer.mechanism.place_text import parse_place, place_text, split_assignment

    written, values = split_assignment(text)
    place = place_text(parse_place(written))
    subject.value(place)
    parts = [part.strip() for part in values.split(":")]
    if len(parts) != 3:
        raise OptionError(f"--vary {text}: write {FORM}, from A to B in N values, as in {EXAMPLE}")
    first, last = (_number(subject, place, part) for part in parts[:2])
    if first == last:
        raise OptionError(f"--vary {text}: goes from {parts[0]} to the same; set a single value with --set")
    return place, _spaced(first, last, _count(text, parts[2]))


def _count(text: str, part: str) -> int:
    if not (part.isascii() and part.isdecimal()) or not 2 <= int(part[:_DIGITS]) <= MOST_VALUES:
        raise OptionError(
            f"--vary {text}: {part or 'nothing'} is no number of values; give a whole number from 2 to "
            f"{MOST_VALUES}, or set a single value with --set"
        )
    return int(part)


def _spaced(first: float, last: float, count: int) -> list[float]:
    import numpy as np

    values: list[float] = np.linspace(first, last, count).tolist()
    return values


def _number(subject: Subject, place: str, text: str) -> float:
    """Read a number in SI units, or one with its unit."""
    from trimmer.mechanism.units import UnitError

    try:
        return number_in(text, subject.places[place])
    except UnitError as error:
        raise OptionError(f"--vary {place}: {text!r}: {error}") from None


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
        try:
            measure = chosen_measure(flow_of(subject), key)
            found[measure.key] = number_in(target, measure.unit) if equals else None
        except UnitError as error:
            raise OptionError(f"--measure {text}: {target!r} {error}") from error
        except TrimmerError as error:
            raise OptionError(f"--measure {text}: {error}") from error
    return found
