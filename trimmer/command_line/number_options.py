"""Types of options whose values are numbers."""

from __future__ import annotations

import math
from argparse import ArgumentTypeError
from collections.abc import Callable

from trimmer.command_line.parser import MOST, of_usual_size
from trimmer.messages import shown_value

_DIGITS = len(str(MOST)) + 1


def positive(unit: str) -> Callable[[str], float]:
    """Make the type of an option whose values are positive finite numbers, in a unit."""

    def number(text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not 0 < value < math.inf:
            raise ArgumentTypeError(f"{shown_value(text)} is not a positive number ({unit})")
        return of_usual_size(value, text)

    return number


def finite(unit: str) -> Callable[[str], float]:
    """Make the type of an option whose values are finite numbers, in a unit."""

    def number(text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise ArgumentTypeError(f"{text!r} is not a finite number{f' ({unit})' if unit else ''}")
        return of_usual_size(value, text)

    return number


def number_in(text: str, unit: str) -> float:
    """Return the number that a text states, in an SI unit if it names none.

    Raises:
        UnitError: if it states none; the message is the end of a sentence.
    """
    from trimmer.mechanism.units import UnitError, quantity

    try:
        return quantity(text, "1")
    except UnitError:
        return quantity(text, unit or "1")


def positive_whole(text: str) -> int:
    """Return the positive whole number that a text states, as the type of an option.

    Raises:
        ArgumentTypeError: if it states none.
    """
    if not (text.isascii() and text.isdecimal()) or not 1 <= int(text[:_DIGITS]) <= MOST:
        raise ArgumentTypeError(f"{shown_value(text)} is not a positive whole number up to {MOST}")
    return int(text)
