"""Arguments with a few possible values, each of which has a word."""

import reprlib
from enum import Enum
from numbers import Integral
from typing import Self

from trimmer.errors import TrimmerError
from trimmer.messages import listed, near_match

__all__ = ["Choice", "ChoiceError"]


class ChoiceError(TrimmerError, ValueError):
    """A value that is none of the possible ones; the message names a near one, or lists their words."""


class Choice(Enum):
    """An enumeration whose members are also chosen by a word, which is that of the command line."""

    @property
    def word(self) -> str:
        """The word: by default the member's name, as in ``flat-top``."""
        return self.name.lower().replace("_", "-")

    @classmethod
    def chosen(cls, value: Self | str | int, argument: str) -> Self:
        """Return the member that is meant by itself or by its word, as a whole number if of digits."""
        if isinstance(value, cls):
            return value
        words = [member.word for member in cls]
        if isinstance(value, str | Integral):
            for member in cls:
                if str(value) == member.word:
                    return member
        advice = near_match(value, words) if isinstance(value, str) else ""
        advice = advice or f"choose {listed(words, 'or')}"
        raise ChoiceError(f"{argument} is {reprlib.repr(value)}: {advice}")
