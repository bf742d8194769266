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


def uses(text: str) -> tuple[Example, ...]:
    """Return the uses that an indented text lists: of each its words, and farther in what it answers."""
    found: list[tuple[list[str], list[str]]] = []
    for line in filter(str.strip, text.splitlines()):
        answer = line.startswith(8 * " ")
        if not answer and (not found or found[-1][1]):
            found.append(([], []))
        found[-1][answer].append(line.strip())
    return tuple(Example(" ".join(words), " ".join(purpose)) for words, purpose in found)


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
