"""On which line each key of a TOML text stands; ``tomllib`` does not say.

The text is known to be TOML, so only its outline is read: headings, keys, and where each value ends.
"""

import re
import tomllib
from collections.abc import Iterator
from typing import Any

Place = tuple[str, ...]  # Keys that lead to a value; entries of arrays are counted from 0, as text

_BLANK = re.compile(r"(?:[ \t\r\n]|\#[^\n]*)*")
_STRING = re.compile(
    r'"""(?:\\.|[^\\])*?"""(?:"{0,2})|'  # up to two more quotation marks belong to the text
    r"'''.*?'''(?:'{0,2})|"
    r'"(?:\\.|[^"\\])*"|'
    r"'[^']*'",
    flags=re.DOTALL,
)
_KEY = re.compile(r"""(?:"(?:\\.|[^"\\])*"|'[^']*'|[A-Za-z0-9_-]+|[ \t]*\.[ \t]*)+""")
_PLAIN = re.compile(r"[^,\]}#\r\n]*")
_HEADING = re.compile(r"\[\[?[ \t]*")
_EQUALS = re.compile(r"[ \t]*=[ \t]*")


def lines_of_keys(text: str) -> dict[Place, int]:
    """Return the line, from 1 on, where each key, table and entry of an array of TOML first appears."""
    text = text.replace("\r\n", "\n")
    return _Outline(text).lines()


class _Outline:
    """The outline of a valid TOML text with newlines alone as line ends."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._end: int
        self._lines: dict[Place, int] = {}
        self._counts: dict[Place, int] = {}

    def lines(self) -> dict[Place, int]:
        """Read the whole text."""
        table: Place = ()
        at = self._blank(0)
        while at < len(self._text):
            if self._text[at] == "[":
                table, at = self._heading(at)
            else:
                at = self._assignment(table, at)
            at = self._blank(at)
        return self._lines

    def _heading(self, at: int) -> tuple[Place, int]:
        opening = self._match(_HEADING, at)
        key, end = self._key(opening.end())
        of_array = opening[0].startswith("[[")
        place: Place = ()
        for name in key[:-1]:
            place = self._last((*place, name), at)
        place = (*place, key[-1])
        self._note(place, at)
        if of_array:
            self._counts[place] = self._counts.get(place, -1) + 1
            place = self._last(place, at)
        return place, self._text.index("]", end) + (2 if of_array else 1)

    def _last(self, place: Place, at: int) -> Place:
        """Note a table, and return its place, or that of the last entry if it is an array of tables."""
        self._note(place, at)
        if place not in self._counts:
            return place
        entry = (*place, str(self._counts[place]))
        self._note(entry, at)
        return entry

    def _assignment(self, table: Place, at: int) -> int:
        key, end = self._key(at)
        for length in range(1, len(key) + 1):
            self._note((*table, *key[:length]), at)
        return self._value((*table, *key), self._match(_EQUALS, end).end())

    def _value(self, place: Place, at: int) -> int:
        match self._text[at]:
            case "[":
                return self._array(place, at)
            case "{":
                return self._inline_table(place, at)
            case '"' | "'":
                return self._match(_STRING, at).end()
            case _:
                return self._match(_PLAIN, at).end()

    def _array(self, place: Place, at: int) -> int:
        for count, start in enumerate(self._entries(at, "]")):
            entry = (*place, str(count))
            self._note(entry, start)
            self._end = self._value(entry, start)
        return self._end

    def _inline_table(self, place: Place, at: int) -> int:
        for start in self._entries(at, "}"):
            self._end = self._assignment(place, start)
        return self._end

    def _entries(self, at: int, closing: str) -> Iterator[int]:
        """Go through the entries between brackets; the reader leaves in ``_end`` where each ends."""
        at = self._blank(at + 1)
        while self._text[at] != closing:
            yield at
            at = self._blank(self._end)
            if self._text[at] == ",":
                at = self._blank(at + 1)
        self._end = at + 1

    def _key(self, at: int) -> tuple[Place, int]:
        found = self._match(_KEY, at)
        return _names(found[0].strip()), found.end()

    def _note(self, place: Place, at: int) -> None:
        if place not in self._lines:
            self._lines[place] = self._text.count("\n", 0, at) + 1

    def _blank(self, at: int) -> int:
        return self._match(_BLANK, at).end()

    def _match(self, pattern: re.Pattern[str], at: int) -> re.Match[str]:
        found = pattern.match(self._text, at)
        if found is None:
            raise ValueError(f"no valid TOML at {at}")
        return found


def _names(key: str) -> Place:
    """Return the names of a dotted key, which ``tomllib`` knows how to unquote."""
    names: list[str] = []
    table: Any = tomllib.loads(f"{key} = 0")
    while isinstance(table, dict):
        ((name, table),) = table.items()
        names.append(name)
    return tuple(names)
