"""Dotted places such as ``links."motor mount".damping``, written and read as the keys of TOML."""

import json
import re
import tomllib
from collections.abc import Collection, Mapping

from trimmer.errors import MechanismError
from trimmer.messages import did_you_mean, listed, near_words

Place = tuple[str, ...]
MOST_MEANT = 3  # Places that a message asks for at once
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
    """Read a place; a name with spaces needs no quotation marks as long as it holds no dot."""
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
    """Split ``PLACE=VALUE`` at the first equals sign that stands in no quotation marks."""
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


def advice(names: Place, known: Mapping[Place, object]) -> str:
    """Say what follows if more is needed, else what place looks like this one, else what may be there."""
    if (near := _near(names, known)) and not any(_goes_on(each, names) for each in known):
        return did_you_mean(map(place_text, near))
    right = next(
        names[:length]
        for length in range(len(names), -1, -1)
        if any(_goes_on(each, names[:length]) for each in known)
    )
    following = dict.fromkeys(key_text(each[len(right)]) for each in known if _goes_on(each, right))
    return (
        f"{f'after {place_text(right)} comes' if right else 'a place begins with'} {listed(following, 'or')}"
    )


def _near(names: Place, known: Collection[Place]) -> list[Place]:
    """Return the place that was meant: name by name the nearest, else as a text; else those that end so."""
    meant: Place = ()
    for name in names:
        following = [each[len(meant)] for each in known if _goes_on(each, meant)]
        nearest = (name,) if name in following else near_words(name, following)[:1]
        if not nearest:
            break
        meant += nearest
    if meant in known:
        return [meant]
    by_text = {place_text(each): each for each in known if len(each) != len(names)}
    nearest = near_words(place_text(names), by_text)
    return [by_text[each] for each in nearest] or _ending(names, known)


def _ending(names: Place, known: Collection[Place]) -> list[Place]:
    """Return the places that end with some names, if they are few."""
    found = [each for each in known if each[-len(names) :] == names]
    return found if len(found) <= MOST_MEANT else []


def _goes_on(place: Place, names: Place) -> bool:
    return place[: len(names)] == names and len(place) > len(names)
