"""Types of options whose values are numbers."""

import math
from argparse import ArgumentParser, ArgumentTypeError
from collections.abc import Callable

from trimmer.command_line.parser import MOST, of_usual_size
from trimmer.messages import shown_value

_DIGITS = len(str(MOST)) + 1


def positive(unit: str) -> Callable[[str], float]:
    """Make the type of an option whose values are positive finite numbers, SI or with their unit."""
    return _number("positive", unit, lambda value: 0 < value < math.inf)


def finite(unit: str) -> Callable[[str], float]:
    """Make the type of an option whose values are finite numbers, SI or with their unit."""
    return _number("finite", unit, math.isfinite)


def _number(kind: str, unit: str, fits: Callable[[float], bool]) -> Callable[[str], float]:
    def number(text: str) -> float:
        try:
            value = _of_unit(text, unit)
        except ValueError:
            value = math.nan
        if not fits(value):
            raise ArgumentTypeError(
                f"{shown_value(text)} is not a {kind} number{f' ({unit})' if unit else ''}"
            )
        return of_usual_size(value, text)

    return number


def _of_unit(text: str, unit: str) -> float:
    try:
        return float(text)
    except ValueError:
        return number_in(text, unit)


def add_count(
    parser: ArgumentParser,
    name: str,
    meaning: str,
    usual: int | None = None,
    *,
    also: str = "",
    metavar: str = "N",
    least: int = 1,
) -> None:
    """Add an option whose value is a whole number from some least one on; the help ends with its default."""
    meaning = f"{meaning} (default: {usual})" if usual is not None else meaning
    names = (name, also) if also else (name,)
    parser.add_argument(*names, type=_whole_from(least), default=usual, metavar=metavar, help=meaning)


def add_positive(parser: ArgumentParser, name: str, unit: str, meaning: str, *, also: str = "") -> None:
    """Add an option whose value is a positive number in a unit."""
    names = (name, also) if also else (name,)
    parser.add_argument(*names, type=positive(unit), metavar=unit.upper(), help=meaning)


def number_in(text: str, unit: str) -> float:
    """Return the number that a text states, in an SI unit if it names none."""
    from trimmer.mechanism.units import UnitError, quantity

    try:
        return quantity(text, "1")
    except UnitError:
        return quantity(text, unit or "1")


def _whole_from(least: int) -> Callable[[str], int]:
    kind = "positive whole number" if least == 1 else f"whole number from {least}"

    def number(text: str) -> int:
        if not (text.isascii() and text.isdecimal()) or not least <= int(text[:_DIGITS]) <= MOST:
            raise ArgumentTypeError(f"{shown_value(text)} is not a {kind} up to {MOST}")
        return int(text)

    return number
