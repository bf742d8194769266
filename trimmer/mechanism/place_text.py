"""Dotted places such as ``links."motor mount".damping``, written and read as the keys of TOML."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Mapping

from trimmer.errors import MechanismError

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_SEGMENT = re.compile(r"""\s*(?:("(?:[^"\\\n]|\\.)*"|'[^'\n]*')|([^."'=]*?))\s*(\.|$)""")


def place_text(place: tuple[str, ...]) -> str:
    """Write a place: names that are no bare keys of TOML are quoted."""
    return ".".join(map(key_text, place))


def key_text(name: str) -> str:
    """Write a key of TOML, quoted where it must be."""
    return name if _BARE.fullmatch(name) else quoted(name)


def quoted(text: str) -> str:
    """Write text as a basic string of TOML."""
    return json.dumps(text, ensure_ascii=False)


def parse_place(text: str) -> tuple[str, ...]:
    """Read a place; a name with spaces needs no quotation marks as long as it holds no dot.

    Raises:
        MechanismError: if it is none.
    """
    names, at = [], 0
    while True:
        found = _SEGMENT.match(text, at)
        if found is None or not (name := _name(found)):
            raise MechanismError(
                f"{text!r} is no place: write names with dots between them, as in plays.bridge.gap "
                'or links."motor mount".damping'
            )
        names.append(name)
        if not found[3]:
            return tuple(names)
        at = found.end()


def split_assignment(text: str) -> tuple[str, str]:
    """Split ``PLACE=VALUE`` at the first equals sign that stands in no quotation marks.

    Raises:
        MechanismError: if there is none.
    """
    found = re.match(r"""((?:"(?:[^"\\\n]|\\.)*"|'[^'\n]*'|[^"'=])*)=(.*)""", text, flags=re.DOTALL)
    if found is None:
        raise MechanismError(f"{text!r} sets nothing: write PLACE=VALUE, as in plays.bridge.gap=40um")
    return found[1].strip(), found[2].strip()


def _name(found: re.Match[str]) -> str:
    if found[1] is None:
        return found[2]
    try:
        (name,) = tomllib.loads(f"{found[1]} = 0")
    except tomllib.TOMLDecodeError:
        return ""
    return str(name)


def unit_of(units: Mapping[str, str], place: str) -> str:
    """Return the unit of a place, empty for a number without one, from the units of all places."""
    unit = units.get(place_text(parse_place(place)), "")
    return "" if unit == "1" else unit
