"""Options of the commands that read a measured signal."""

from __future__ import annotations

import os
from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.file_options import file_to_read
from trimmer.command_line.number_options import positive

if TYPE_CHECKING:
    from trimmer.signals.signal import Signal

DELIMITERS = ("comma", "semicolon", "tab")
DECIMAL_SIGNS = ("point", "comma")
MISSING_VALUES = ("refuse", "interpolate", "gap")


def column(text: str) -> str:
    """Read the name of a column, as the type of an option: in UTF-8, as the files, whatever the locale is."""
    try:
        return os.fsencode(text).decode("utf-8")
    except UnicodeError:
        return text


def add_signal_options(parser: ArgumentParser) -> None:
    """Add the file of the signal, and the options that say how to read it."""
    parser.add_argument(
        "file",
        type=file_to_read,
        metavar="FILE",
        help="CSV file with the samples, one row each, with a heading or not; - for standard input",
    )
    parser.add_argument(
        "--rate",
        type=positive("Hz"),
        metavar="HZ",
        help="samples per second; not needed if a column of time stamps gives it",
    )
    parser.add_argument(
        "--column",
        type=column,
        metavar="NAME|NUMBER",
        help="column of the signal (default: the only one beside the time stamps); the first has number 1",
    )
    parser.add_argument(
        "--time",
        type=column,
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
    from trimmer.signals.csv_layout import CsvLayout
    from trimmer.signals.read import read_signal

    return read_signal(
        arguments.file,
        column=arguments.column,
        time_column=arguments.time,
        sample_rate=arguments.rate,
        layout=CsvLayout(arguments.delimiter, arguments.decimal),
        missing=arguments.missing,
    )
