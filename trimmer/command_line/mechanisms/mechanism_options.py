"""The file of a mechanism, numbers set in it, and the seed of random starts, as options of a command."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from typing import TYPE_CHECKING

from trimmer.command_line.file_options import file_to_read

if TYPE_CHECKING:
    from trimmer.mechanism.mechanism import Mechanism


def add_mechanism_options(parser: ArgumentParser) -> None:
    """Add the file of a mechanism and ``--set``."""
    parser.add_argument(
        "file", type=file_to_read, metavar="FILE", help="mechanism, a TOML file; - for standard input"
    )
    add_set_option(parser)


def add_set_option(parser: ArgumentParser) -> None:
    """Add ``--set``."""
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="PLACE=VALUE",
        help="set a number of the mechanism, such as plays.bridge.gap=40um; may be repeated",
    )


def add_seed_option(parser: ArgumentParser) -> None:
    """Add ``--seed``."""
    parser.add_argument("--seed", type=int, default=0, metavar="N", help="of the random starts (default: 0)")


def chosen_mechanism(arguments: Namespace) -> Mechanism:
    """Return the mechanism of the file with the numbers that are set.

    Raises:
        MechanismError: if the file or a number cannot be used.
    """
    from trimmer.mechanism.places import assignment
    from trimmer.mechanism.reading import read_mechanism

    assignments = [assignment(text) for text in arguments.set]
    mechanism = read_mechanism(arguments.file, dict(assignments))
    for place, value in assignments:
        mechanism = mechanism.with_value(place, value)
    return mechanism
