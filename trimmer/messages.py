"""What messages about input have in common: values that stay short, and near matches."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

_SHOWN_LENGTH = 40


def shown_value(value: object) -> str:
    """Give a value as text that stays short; an integer may have more digits than Python will print."""
    try:
        text = repr(value)
    except ValueError:
        return "an integer of thousands of digits"
    return text if len(text) <= _SHOWN_LENGTH else f"{text[: _SHOWN_LENGTH - 3]}..."


def near_match(word: str, known: Iterable[str]) -> str:
    """Ask whether the nearest of the known words was meant; empty if none is near."""
    by_lower_case = {each.lower(): each for each in known}
    nearest = difflib.get_close_matches(word.lower(), by_lower_case, n=1, cutoff=0.5)
    return f"did you mean {by_lower_case[nearest[0]]}?" if nearest else ""


def listed(words: Iterable[str], conjunction: str = "and") -> str:
    """Join words as a sentence does: ``a, b and c``."""
    *others, last = words
    return f"{', '.join(others)} {conjunction} {last}" if others else last
