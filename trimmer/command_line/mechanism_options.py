"""The file of a mechanism, numbers set in it, and the seed of random starts, as options of a command."""

from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from pathlib import Path

from trimmer.command_line.file_options import add_input
from trimmer.command_line.number_options import add_count
from trimmer.command_line.parser import note
from trimmer.mechanism.mechanism import Mechanism


def add_mechanism_options(parser: ArgumentParser) -> None:
    """Add the file of a mechanism and ``--set``."""
    add_input(parser, "file", "mechanism, a TOML file; - for standard input")
    add_set_option(parser)


def add_set_option(parser: ArgumentParser, or_of_a_loop: str = "") -> None:
    """Add ``--set``; what is added to its example is for commands that take a loop too."""
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="PLACE=VALUE",
        help=f"set a number of the mechanism, such as plays.bridge.gap=40um{or_of_a_loop}; may be repeated",
    )


def add_seed_option(parser: ArgumentParser, of: str = "random starts") -> None:
    """Add ``--seed`` of what is random."""
    add_count(parser, "--seed", f"of the {of}", 0, least=0)


def chosen_mechanism(arguments: Namespace) -> Mechanism:
    """Return the mechanism of the file with the numbers that are set."""
    mechanism = mechanism_with(arguments.file, arguments.set)
    note_controllers(arguments.file, mechanism)
    return mechanism


def note_controllers(file: Path, mechanism: Mechanism) -> None:
    """Say of the controllers of a mechanism which never act, and whether they leave it unstable."""
    if not mechanism.controllers:
        return
    from trimmer.contact.control_loops import instability_told
    from trimmer.mechanism.controls.controllers import idle_controllers

    for told in (*idle_controllers(mechanism.controllers), instability_told(mechanism)):
        if told:
            note(f"{file}: {told}")


def mechanism_with(file: Path, assignments: Sequence[str]) -> Mechanism:
    """Return the mechanism of a file with numbers set, each by a text such as ``plays.bridge.gap=40um``."""
    from trimmer.mechanism.places import assignment, with_values
    from trimmer.mechanism.reading import read_mechanism

    values = [assignment(text) for text in assignments]
    return with_values(read_mechanism(file, dict(values)), values)
