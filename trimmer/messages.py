"""What messages about input have in common: values that stay short, and near matches."""

import difflib
import unicodedata
from collections.abc import Iterable, Sequence
from pathlib import Path

MOST_LINES = 18  # Lines of one message below its headline, so that a screen holds it
_SHOWN_LENGTH = 40
_LEAST_RATIO = 0.7
"""Share of letters in common from which on a word is near: frction is near friction, foo not near follow."""
_LONGEST_WORD = 100  # Longer words are no misspelled names, and comparing them would take long
_SHORTEST_BEGINNING = 3
_ACTING = ("Cc", "Cf", "Zl", "Zp")
"""Categories of Unicode: controls, marks of format such as that of direction, ends of lines."""


def shown_value(value: object) -> str:
    """Give a value as text that stays short; an integer may have more digits than Python will print."""
    try:
        text = repr(value)
    except ValueError:
        return "an integer of thousands of digits"
    return text if len(text) <= _SHOWN_LENGTH else f"{text[: _SHOWN_LENGTH - 3]}..."


def printable(text: str) -> str:
    """Return text with escapes for what a terminal would act on or hide, but for line ends.

    Those are control characters, marks that turn the direction of others, and characters without width; names
    of files may hold them. What is only no ASCII stays, and so do spaces of other scripts.
    """
    return "".join(map(_shown, text)) if not text.isprintable() else text


def _shown(sign: str) -> str:
    if sign == "\n" or unicodedata.category(sign) not in _ACTING:
        return sign
    return sign.encode("unicode_escape").decode()


def near_match(word: str, known: Iterable[str]) -> str:
    """Ask whether the nearest of the known words was meant; empty if none is near."""
    return did_you_mean(near_words(word, known))


def near_or_all(word: str, known: Iterable[str]) -> str:
    """Ask whether the nearest of the known words was meant; name all of them if none is near."""
    known = tuple(known)
    return near_match(word, known) or there_is(known)


def there_is(known: Iterable[str]) -> str:
    """Tell which words are known."""
    known = tuple(known)
    return f"there {'is' if len(known) == 1 else 'are'} {listed(known)}" if known else "there is none"


def did_you_mean(words: Iterable[str]) -> str:
    """Ask whether one of some words was meant; empty if there is none."""
    words = tuple(words)
    return f"did you mean {listed(words, 'or')}?" if words else ""


def near_words(word: str, known: Iterable[str]) -> tuple[str, ...]:
    """Return the known words that may have been meant: the nearest, and what differs from it in capitals.

    Near is, in this order: what differs in capitals, spaces and punctuation alone; in the order of its
    letters; in a few letters (Ratcliff's and Obershelp's similarity, as in ``difflib``); and the one word
    that goes on after what was written.
    """
    if len(word) > _LONGEST_WORD:
        return ()
    folded = word.casefold()
    by_folded: dict[str, list[str]] = {}
    for each in dict.fromkeys(known):
        by_folded.setdefault(each.casefold(), []).append(each)
    found = (
        [each for each in by_folded if _letters(each) == _letters(folded) != ""]
        or [each for each in by_folded if sorted(each) == sorted(folded)]
        or difflib.get_close_matches(folded, by_folded, cutoff=_LEAST_RATIO)
        or _continued(folded, by_folded)
    )
    return tuple(by_folded[found[0]]) if found else ()


def near_file(path: Path) -> str:
    """Ask whether the file of the same folder with the nearest name was meant; empty if none is near."""
    try:
        names = [each.name for each in path.parent.iterdir() if each.is_file()]
    except OSError:
        return ""
    return did_you_mean(str(path.with_name(name)) for name in near_words(path.name, names))


def listed(words: Iterable[str], conjunction: str = "and") -> str:
    """Join words as a sentence does: ``a, b and c``."""
    *others, last = words
    return f"{', '.join(others)} {conjunction} {last}" if others else last


def in_lines(sentences: Sequence[str]) -> str:
    """Return sentences as indented lines, the first ones of many and how many more there are."""
    shown = sentences if len(sentences) <= MOST_LINES else sentences[: MOST_LINES - 1]
    left = len(sentences) - len(shown)
    more = (f"... and {left} more: put these right first",) if left else ()
    return "".join(f"\n  {each}" for each in (*shown, *more))


def _letters(word: str) -> str:
    return "".join(filter(str.isalnum, word))


def _continued(word: str, known: Iterable[str]) -> list[str]:
    """Return the only word that begins with another one, if that is long enough to mean it."""
    found = [each for each in known if len(word) >= _SHORTEST_BEGINNING and each.startswith(word)]
    return found if len(found) == 1 else []
