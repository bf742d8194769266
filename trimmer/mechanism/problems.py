"""What is wrong with a mechanism: the place of it, the value there, and what to do."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Any

from trimmer.mechanism.place_text import place_text
from trimmer.messages import in_lines, near_match, shown_value, there_is

LONGEST_NAME = 300  # Characters of a name; each is repeated in every table and message
_SHOWN = 40


class _Nothing(Enum):
    NOTHING = "nothing"


NOTHING = _Nothing.NOTHING
"""Stands for no value: a whole part or section is meant, or something that is not there."""


@dataclass(frozen=True)
class Problem:
    """Something that is wrong with a mechanism."""

    place: tuple[str, ...]  # Names that lead there, such as ``("plays", "bridge", "gap")``
    reason: str  # What is wrong and what to do
    value: object = NOTHING  # What was given; ``NOTHING`` if there is nothing to show

    def sentence(self, written: object = NOTHING) -> str:
        """Return place, value, as it stands in a file if it was converted since, and reason."""
        value = self.value if self.value is NOTHING or written is NOTHING else written
        shown = "" if value is NOTHING else f" = {shown_value(value)}"
        return f"{place_text(self.place)}{shown}: {self.reason}" if self.place else self.reason


def problems_of_name(section: tuple[str, ...], name: object) -> Iterator[Problem]:
    """Find what is wrong with the name of a part."""
    if not isinstance(name, str):
        yield Problem(section, f"a name must be text, not {name!r}")
    elif not name or not name.isprintable() or name != name.strip():
        yield Problem((*section, name), "a name must be text on one line, without spaces around it")
    elif len(name) > LONGEST_NAME:
        place = (*section, f"{name[:_SHOWN]}...")
        yield Problem(place, f"a name of {len(name)} characters is too long; use at most {LONGEST_NAME}")


def as_message(problems: Sequence[Problem], name: str = "the mechanism") -> str:
    """Return one message of all problems of a mechanism that no file stands behind."""
    return in_one([problem.sentence() for problem in problems], name)


def as_message_of_file(
    name: str, problems: Sequence[Problem], content: Mapping[str, Any], lines: Mapping[tuple[str, ...], int]
) -> str:
    """Return one message of all problems of a file, with the line of each key, from 1 on."""
    ordered = sorted(problems, key=lambda problem: line_of(problem.place, lines))
    sentences = [
        f"line {line_of(problem.place, lines)}: {problem.sentence(_written(problem.place, content))}"
        if line_of(problem.place, lines)
        else problem.sentence()
        for problem in ordered
    ]
    return in_one(sentences, name)


def no_such(kind: str, name: str, known: Iterable[str]) -> str:
    """Return the reason against a name that nothing of a kind has, with what is there."""
    known = list(known)
    return f"there is no {kind} {name!r}; {near_match(name, known) or there_is(map(repr, known))}"


def in_one(sentences: Sequence[str], name: str) -> str:
    """Return one sentence as it is, and several as a list below a headline."""
    if len(sentences) == 1:
        return f"{name}: {sentences[0]}"
    return f"{name}: {len(sentences)} problems:{in_lines(sentences)}"


def line_of(place: tuple[str, ...], lines: Mapping[tuple[str, ...], int]) -> int:
    """Return the line of a place, or of what should hold it; 0 if nothing of it is there."""
    return next((lines[place[:length]] for length in range(len(place), 0, -1) if place[:length] in lines), 0)


def _written(place: tuple[str, ...], content: Mapping[str, Any]) -> object:
    value: Any = content
    for name in place:
        if not isinstance(value, Mapping) or name not in value:
            return NOTHING
        value = value[name]
    return value
