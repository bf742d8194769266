"""A parser that tells an error in one sentence, and keeps in mind which options were given."""

import io
import math
import os
import re
import sys
from argparse import Action, ArgumentError, ArgumentParser, ArgumentTypeError, Namespace, _SubParsersAction
from collections.abc import Iterable, Sequence
from contextlib import suppress
from typing import Any, NoReturn, Self, TextIO

from trimmer.errors import TrimmerError
from trimmer.messages import listed, near_match, printable, shown_value
from trimmer.progress import is_silenced
from trimmer.sizes import reason_against_size

WRONG_USE = 2  # Exit code for what the user can put right
ENDED_EARLY = 3  # Exit code of a motion or a branch that did not come to the end that was asked for
INTERRUPTED = 130  # Exit code after an interrupt, as a shell gives it

MOST = 1_000_000_000  # Largest whole number of an option: none counts more

_GIVEN = "given"
_NEGATIVE_NUMBER = re.compile(
    r"-(?:(?:[0-9][0-9_]*\.?[0-9]*|\.[0-9]+)(?:e[+-]?[0-9]+)?(?:\s*[^\W\d_].*)?|inf(?:inity)?|nan)$",
    flags=re.IGNORECASE,
)


class OptionError(TrimmerError, ValueError):
    """An option that is missing, not used, or has a value that cannot be used."""

    @classmethod
    def of(cls, error: ValueError) -> Self:
        """Return what a call says of values that came from options."""
        return cls(str(error), place=getattr(error, "place", ()))


class Parser(ArgumentParser):
    """A parser of options.

    A single value that is given twice is an error, since one of them would be ignored. Negative numbers are
    values in every notation, such as ``-1e-3`` and ``-inf``, and so they are with a unit. Options, commands
    and choices that do not exist are told before what is missing, with the one that was meant. The beginning
    of an option is none: a message would name an option that was not written.
    """

    def __init__(self, *arguments: Any, **settings: Any) -> None:
        super().__init__(*arguments, **{"allow_abbrev": False, **settings})
        self._negative_number_matcher = (
            _NEGATIVE_NUMBER  # argparse's own knows no exponent before Python 3.14
        )
        for name in (None, "store"):
            self.register("action", name, _Once)
        self.register("type", float, _number)
        self.register("type", int, _whole)

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Parse words; those that look like options must be some."""
        words = sys.argv[1:] if args is None else list(args)
        for word in words:
            if word == "--" or (self._subparsers is not None and not word.startswith("-")):
                break
            self._check_option(word)
        return super().parse_known_args(words, namespace)

    def _check_option(self, word: str) -> None:
        name = word.partition("=")[0]
        if not name.startswith("-") or name == "-" or " " in name or _NEGATIVE_NUMBER.match(word):
            return
        known = self._option_string_actions
        if name in known:
            return
        meant = near_match(name, [each for each in known if each.startswith("--")])
        self.error(f"there is no option {name}{f'; {meant}' if meant else ''}")

    def _check_value(self, action: Action, value: Any) -> None:
        """Check that a value is one of the choices (called by argparse)."""
        if action.choices is None or value in action.choices:
            return
        words = [str(each) for each in action.choices]
        told = shown_value(value) if isinstance(value, str) else str(value)
        advice = near_match(str(value), words) or f"choose {listed(words, 'or')}"
        if isinstance(action, _SubParsersAction):
            raise ArgumentError(None, f"there is no command {told}; {advice}")
        raise ArgumentError(action, f"there is no {told}; {advice}")

    def error(self, message: str) -> NoReturn:
        """Tell in one sentence what is wrong, and where the options are explained, and exit."""
        tell(f"{message}{' See' if message.endswith('?') else '; see'} {self.prog} --help")
        raise SystemExit(WRONG_USE)


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise ArgumentTypeError(f"{shown_value(text)} is no number") from None
    return of_usual_size(value, text)


def of_usual_size(value: float, text: str) -> float:
    """Return the number that a text states."""
    reason = reason_against_size(value)
    if reason:
        raise ArgumentTypeError(f"{shown_value(text)} {reason}")
    return value


def _whole(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        raise ArgumentTypeError(f"{shown_value(text)} is no whole number") from None
    if abs(value) > MOST:
        raise ArgumentTypeError(f"{shown_value(text)} is more than {MOST}, the largest that can be used")
    return value


class _Once(Action):
    """Keeps a single value, and that it was given."""

    def __call__(
        self,
        parser: ArgumentParser,
        namespace: Namespace,
        values: str | Sequence[Any] | None,
        option_string: str | None = None,
    ) -> None:
        if is_given(namespace, self.dest):
            raise ArgumentError(self, "given twice, but only one value can be used")
        setattr(namespace, _GIVEN, getattr(namespace, _GIVEN, frozenset()) | {self.dest})
        setattr(namespace, self.dest, values)


def is_given(arguments: Namespace, name: str) -> bool:
    """Say whether an option with a single value was given, and is not at its default."""
    return name in getattr(arguments, _GIVEN, frozenset())


def refuse_unused(arguments: Namespace, names: Iterable[str], use: str) -> None:
    """Refuse options that would have no effect without others, which the message names."""
    for name in names:
        if is_given(arguments, name):
            raise OptionError(f"{as_option(name)} has no effect without {use}: add that, or leave it out")


def require_positive(arguments: Namespace, name: str, unit: str) -> None:
    """Check that the value of an option is positive and finite."""
    value = getattr(arguments, name)
    if not 0 < value < math.inf:
        quantity = name.replace("_", " ")
        raise OptionError(f"{as_option(name)} {value:g}: {quantity} must be positive and finite ({unit})")


def as_option(name: str) -> str:
    """Write the name of an option as on the command line."""
    return f"--{name.replace('_', '-')}"


def tell(message: str) -> None:
    """Print a message for the user on standard error, if anybody reads that."""
    try:
        print(f"trimmer: {printable(message)}", file=sys.stderr, flush=True)
    except OSError:
        drop(sys.stderr)


def exit_code(success: bool, message: str) -> int:
    """Return 0 for what came to its end, or else tell why it did not, and return ``ENDED_EARLY``."""
    if not success:
        tell(message)
    return 0 if success else ENDED_EARLY


def note(message: str) -> None:
    """Print on standard error what is good to know and no error; nothing with ``--quiet``."""
    if not is_silenced():
        tell(message)


def drop(stream: TextIO) -> None:
    """Send to nowhere what a stream has left to write; Python would complain at its end."""
    with suppress(io.UnsupportedOperation), open(os.devnull, "wb") as nowhere:
        os.dup2(nowhere.fileno(), stream.fileno())
