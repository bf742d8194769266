"""The file of a design: a mechanism, its targets, the body that is held, and unknown numbers."""

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

from trimmer.arguments import file_path
from trimmer.arrays import Reals
from trimmer.design.specification.assumed_range import assumed_range
from trimmer.design.specification.targets import OF_STEP, Target, followers, is_switched, targets_of
from trimmer.errors import MechanismError
from trimmer.mechanism.checks import LONGEST_TITLE
from trimmer.mechanism.coordinates import shaken_ends
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.open_values import OpenValue, open_values
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.mechanism.places import with_values
from trimmer.mechanism.problems import Problem, as_message_of_file, line_of
from trimmer.mechanism.reading import bytes_of_file, content_of_text, mechanism_of_text
from trimmer.mechanism.toml_lines import lines_of_keys
from trimmer.mechanism.units import UnitError
from trimmer.messages import listed, near_match
from trimmer.toml_files import decoded


class Scattering(Protocol):
    """How numbers scatter: ``Uncertainty`` of ``trimmer.uncertainty``, which knows this room."""

    @property
    def places(self) -> tuple[str, ...]:
        """Dotted places of the numbers."""
        ...

    def values(self, shares: Reals) -> Reals:
        """Turn points of the unit cube, (n, numbers), into values, SI units."""
        ...


@dataclass(frozen=True)
class OpenRange:
    """An unknown number, with the range in which it may be.

    Attributes:
        place: Its dotted place.
        unit: The SI unit.
        lowest, highest: Ends of the range that is looked at, in that unit.
        assumed: Whether the file gives no range, so that this one was assumed.
    """

    place: str
    unit: str
    lowest: float
    highest: float
    assumed: bool

    @property
    def middle(self) -> float:
        """The number that stands for the range where one is needed."""
        return 0.5 * (self.lowest + self.highest)


@dataclass(frozen=True)
class DesignFile:
    """A mechanism with its targets and unknown numbers, as a file gives them.

    Attributes:
        name: What messages call it, with the numbers that were set.
        mechanism: The mechanism, with the middle of each range.
        targets: What is wanted of it.
        held: The body that a hand holds; None if the file does not say.
        ranges: What nobody knows.
        lines: The line of each key, from 1 on, by the names that lead there.
        author: Who wrote it; empty if it does not say.
        digest: SHA-256 of its bytes, hexadecimal.
        scatter: What stands in ``[uncertainty]``, unread.
        uncertainty: How its numbers scatter from machine to machine: ``with_uncertainty`` of
            ``trimmer.uncertainty`` reads that; else None.
    """

    name: str
    mechanism: Mechanism
    targets: tuple[Target, ...]
    held: str | None
    ranges: tuple[OpenRange, ...]
    lines: Mapping[tuple[str, ...], int]
    author: str = ""
    digest: str = ""
    scatter: Mapping[str, Any] = field(default_factory=dict)
    uncertainty: Scattering | None = None

    @property
    def switched(self) -> bool:
        """Whether its motion is looked at from the start until all rests, and not once it has settled."""
        return is_switched(self.mechanism, (each.measure for each in self.targets))

    @property
    def stepped(self) -> bool:
        """Whether it is looked at from the start through the steps that its controllers follow."""
        others = any(each.measure not in OF_STEP for each in self.targets)
        return bool(followers(self.mechanism)) and not (self.switched or others)

    def line(self, place: tuple[str, ...]) -> int:
        """Return the line of a place, or of what should hold it; 0 if nothing of it is there."""
        return line_of(place, self.lines)


Changes = Sequence[tuple[str, float | str]]
"""Places, and the numbers that stand there in place of those of the file."""


def read_design_file(path: Path | str, changes: Changes = ()) -> DesignFile:
    """Read the file of a design, or standard input if the path is ``-``.

    Args:
        path: The file.
        changes: Places, and the numbers that stand there in place of those of the file.

    Raises:
        MechanismError: if it cannot be read, or holds what cannot be used. Every problem is named, with file,
            line, key and value, and what to do.
    """
    path = file_path("path", path)
    return _design_file(bytes_of_file(path), str(path), path.parent, changes)


def read_with_targets(path: Path | str, changes: Changes) -> tuple[Mechanism, tuple[Target, ...]]:
    """Read a mechanism as ``read_mechanism`` does, with other numbers, and the targets in its file."""
    path = file_path("path", path)
    text, name = decoded(bytes_of_file(path)), str(path)
    content = content_of_text(text, name)
    mechanism = _changed(text, name, path.parent, {}, changes)
    problems: list[Problem] = []
    targets = targets_of(content.get("targets", {}), mechanism, problems)
    _stop_at(problems, name, content, lines_of_keys(text))
    return mechanism, targets


def design_file_of_text(text: str, name: str, folder: Path = Path()) -> DesignFile:
    """Read the text of a design's file, which names files in a folder; see ``read_design_file``."""
    return _design_file(text.encode(), name, folder)


def _changed(
    text: str, name: str, folder: Path, values: Mapping[str, float | str], changes: Changes
) -> Mechanism:
    """Return the mechanism of a text with values for what it leaves open, and other numbers at places."""
    set_values = {place_text(parse_place(place)): value for place, value in changes}
    return with_values(mechanism_of_text(text, name, {**values, **set_values}, folder), changes)


def _design_file(raw: bytes, name: str, folder: Path, changes: Changes = ()) -> DesignFile:
    set_places = {place_text(parse_place(place)) for place, _ in changes}
    text = decoded(raw)
    content = content_of_text(text, name)
    lines = lines_of_keys(text)
    problems: list[Problem] = []
    left_open = tuple(each for each in open_values(content) if place_text(each.place) not in set_places)
    ends = dict(_given(left_open, problems))
    _stop_at(problems, name, content, lines)
    values: dict[str, float | str] = {place_text(each.place): _first(each, ends) for each in left_open}
    mechanism = _changed(text, name, folder, values, changes)
    ranges = tuple(_ranges(left_open, ends, mechanism, problems))
    targets = targets_of(content.get("targets", {}), mechanism, problems)
    held = _held(content.get("held"), mechanism, problems)
    author = _author(content.get("author", ""), problems)
    _stop_at(problems, name, content, lines)
    for each in ranges:
        mechanism = mechanism.with_value(each.place, each.middle)
    told = "".join(f", {place}={value}" for place, value in changes)
    scatter = content.get("uncertainty", {})
    digest = hashlib.sha256(raw).hexdigest()
    return DesignFile(name + told, mechanism, targets, held, ranges, lines, author, digest, scatter)


def _stop_at(
    problems: list[Problem], name: str, content: Mapping[str, Any], lines: Mapping[tuple[str, ...], int]
) -> None:
    if problems:
        raise MechanismError(as_message_of_file(name, problems, content, lines))


def _given(
    left_open: tuple[OpenValue, ...], problems: list[Problem]
) -> Iterator[tuple[OpenValue, tuple[float, float]]]:
    for each in left_open:
        if not each.is_unknown:
            try:
                yield each, each.ends()
            except UnitError as error:
                problems.append(Problem(each.place, str(error), each.text))


def _first(value: OpenValue, ends: Mapping[OpenValue, tuple[float, float]]) -> float:
    """Return a number with which the mechanism can be read: the middle, or 1 until a range is assumed."""
    return sum(ends[value]) / 2 if value in ends else 1.0


def _ranges(
    left_open: tuple[OpenValue, ...],
    ends: Mapping[OpenValue, tuple[float, float]],
    mechanism: Mechanism,
    problems: list[Problem],
) -> Iterator[OpenRange]:
    for each in left_open:
        found = ends.get(each) or assumed_range(mechanism, each.place)
        if found is None:
            reason = 'nothing in the file says how large it may be; give a range, as in "20 um..60 um"'
            problems.append(Problem(each.place, reason, each.text))
        else:
            yield OpenRange(place_text(each.place), each.quantity.unit, *found, each.is_unknown)


def _author(value: object, problems: list[Problem]) -> str:
    if isinstance(value, str) and value.isprintable() and len(value) <= LONGEST_TITLE:
        return value
    reason = f"names who wrote the file: text on one line, of at most {LONGEST_TITLE} characters"
    problems.append(Problem(("author",), reason, value))
    return ""


def _held(value: object, mechanism: Mechanism, problems: list[Problem]) -> str | None:
    ends, kinds = shaken_ends(mechanism), mechanism.kinds
    bodies = [name for name in ends if kinds[name] is Kind.TRANSLATION]
    if value is None or (isinstance(value, str) and value in bodies):
        return value
    if value in ends:
        advice = "this one turns, and what a hand feels is known of what moves along a line alone"
    else:
        advice = near_match(str(value), bodies) or f"the bodies are {listed(bodies)}"
    problems.append(Problem(("held",), f"names the body that a hand holds; {advice}", value))
    return None
