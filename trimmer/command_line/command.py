"""The record of a subcommand: name, help, options and action."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Command:
    """A subcommand of ``trimmer``.

    A module that defines one is imported for ``trimmer --help``, so it imports what is slow inside ``run``.

    Attributes:
        name: The word that selects it.
        help: One line for the list of commands.
        configure: Adds the command's options to its parser.
        run: Does the work and returns the exit code. An error that the user can correct it raises as a
            ``trimmer.errors.TrimmerError``.
    """

    name: str
    help: str
    configure: Callable[[ArgumentParser], None]
    run: Callable[[Namespace], int]
