"""Options of the commands that read a measured signal."""

from __future__ import annotations

import math
from argparse import ArgumentParser, ArgumentTypeError, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trimmer.signals.signal import Signal

DELIMITERS = ("comma", "semicolon", "tab")
DECIMAL_SIGNS = ("point", "comma")
MISSING_VALUES = ("refuse", "interpolate")


def positive(text: str) -> float:
    """Return the positive finite number that a text states, as the type of an option.

    Raises:
        ArgumentTypeError: if it states none.
    """
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not 0 < number < math.inf:
        raise ArgumentTypeError(f"{text!r} is not a positive number")
    return number


def positive_whole(text: str) -> int:
    """Return the positive whole number that a text states, as the type of an option.

    Raises:
        ArgumentTypeError: if it states none.
    """
    if not text.isdecimal() or int(text) == 0:
        raise ArgumentTypeError(f"{text!r} is not a positive whole number")
    return int(text)


def add_signal_options(parser: ArgumentParser) -> None:
    """Add the file of the signal, and the options that say how to read it."""
    parser.add_argument(
        "file",
        type=Path,
        metavar="FILE",
        help="CSV file with the samples, one row each, with a heading or not",
    )
    parser.add_argument(
        "--rate",
        type=positive,
        metavar="HZ",
        help="samples per second; not needed if a column of time stamps gives it",
    )
    parser.add_argument(
        "--column",
        metavar="NAME|NUMBER",
        help="column of the signal (default: the only one beside the time stamps); the first has number 1",
    )
    parser.add_argument(
        "--time",
        metavar="NAME|NUMBER",
        help="column of the time stamps, s unless its heading says [ms] or the like "
        "(default: the one named t, time or timestamp, if any)",
    )
    parser.add_argument(
        "--delimiter", choices=DELIMITERS, help="what separates columns (default: found out from the file)"
    )
    parser.add_argument(
        "--decimal", choices=DECIMAL_SIGNS, help="decimal sign (default: found out from the numbers)"
    )
    parser.add_argument(
        "--missing",
        choices=MISSING_VALUES,
        default="refuse",
        help="what to do about missing values: refuse, or interpolate linearly (default: refuse)",
    )


def chosen_signal(arguments: Namespace) -> Signal:
    """Read the signal that the options choose.

    Raises:
        TrimmerError: if the file cannot be used.
    """
    from trimmer.signals.csv_layout import CsvLayout, DecimalSign, Delimiter
    from trimmer.signals.missing import MissingValues
    from trimmer.signals.read import read_signal

    delimiter, decimal = arguments.delimiter, arguments.decimal
    return read_signal(
        arguments.file,
        column=arguments.column,
        time_column=arguments.time,
        sample_rate=arguments.rate,
        layout=CsvLayout(
            Delimiter[delimiter.upper()] if delimiter else None,
            DecimalSign[decimal.upper()] if decimal else None,
        ),
        missing=MissingValues(arguments.missing),
    )
