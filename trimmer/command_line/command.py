"""The record of a subcommand: name, help, options, action, and examples of its use."""

import shlex
from argparse import ArgumentParser, Namespace
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Example:
    """A use of a subcommand, as it is typed in any shell, and what it answers, as a piece of a sentence."""

    words: str
    purpose: str

    @property
    def arguments(self) -> list[str]:
        """The words after ``trimmer``."""
        return shlex.split(self.words)[1:]


@dataclass(frozen=True)
class Command:
    """A subcommand of ``trimmer``.

    A module that defines one is imported for ``trimmer --help``, so it imports what is slow inside ``run``.
    """

    name: str  # The word that selects it
    help: str  # One line for the list of commands
    # Adds the command's options to its parser. Each command gets ``--quiet`` beside them.
    configure: Callable[[ArgumentParser], None]
    # Does the work and returns the exit code. An error that the user can correct it raises as a
    # ``trimmer.errors.TrimmerError``.
    run: Callable[[Namespace], int]
    examples: tuple[Example, ...] = ()  # Uses that its help shows
