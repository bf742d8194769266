"""The ``trimmer`` command put together: its own subcommands, then those of installed packages."""

from __future__ import annotations

import os
import sys
from argparse import ArgumentParser
from collections.abc import Sequence
from importlib.metadata import EntryPoint, entry_points

import trimmer
from trimmer.command_line import (
    derive,
    identify,
    limit_cycles,
    linear,
    orbits,
    parameters,
    simulate,
    spectrum,
)
from trimmer.command_line.command import Command
from trimmer.errors import TrimmerError

ENTRY_POINT_GROUP = "trimmer.commands"
"""Entry points of this group are ``Command`` objects; that is how another package adds a subcommand."""

WRONG_USE = 2
INTERRUPTED = 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code.

    Args:
        arguments: Words after the program's name; those of the process if not given.

    Returns:
        The exit code of the subcommand, 2 for an error that the user can correct, or 130 if interrupted.
    """
    parsed = _parser(_commands()).parse_args(arguments)
    try:
        code: int = parsed.run(parsed)
        sys.stdout.flush()
        return code
    except TrimmerError as error:
        print(f"trimmer: {error}", file=sys.stderr)
        return WRONG_USE
    except BrokenPipeError:
        # The reader has seen enough, as in `trimmer linear | head`.
        _drop_output()
        return 0
    except OSError as error:
        # Errors of reading and writing files come as a TrimmerError, so this one is of printing.
        name = error.filename or "standard output"
        print(f"trimmer: {name}: {error.strerror}; send the output elsewhere", file=sys.stderr)
        _drop_output()
        return WRONG_USE
    except KeyboardInterrupt:
        return INTERRUPTED


def _drop_output() -> None:
    """Discard what is left to print; Python would report an error on closing standard output."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _commands() -> list[Command]:
    own = [
        *(linear.COMMAND, limit_cycles.COMMAND, identify.COMMAND),
        *(orbits.COMMAND, simulate.COMMAND, spectrum.COMMAND),
        *(parameters.COMMAND, derive.COMMAND),
    ]
    others = (_loaded(entry) for entry in entry_points(group=ENTRY_POINT_GROUP))
    return own + [command for command in others if command is not None]


def _loaded(entry: EntryPoint) -> Command | None:
    """Load a command of another package; None for one that is broken, which must not stop the others."""
    try:
        command = entry.load()
    except Exception as error:
        print(f"trimmer: command {entry.name!r} ({entry.value}) does not load: {error}", file=sys.stderr)
        return None
    if isinstance(command, Command):
        return command
    print(f"trimmer: command {entry.name!r} ({entry.value}) is not a Command", file=sys.stderr)
    return None


def _parser(commands: Sequence[Command]) -> ArgumentParser:
    parser = ArgumentParser(prog="trimmer", description="Vibration of a hair trimmer with play and friction.")
    parser.add_argument("--version", action="version", version=f"trimmer {trimmer.__version__}")
    subparsers = parser.add_subparsers(metavar="COMMAND", title="commands", required=True)
    for command in commands:
        subparser = subparsers.add_parser(command.name, help=command.help, description=command.help)
        command.configure(subparser)
        subparser.set_defaults(run=command.run)
    return parser
