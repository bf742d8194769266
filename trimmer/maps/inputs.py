"""What a map is made from: a mechanism, the places that are varied, their values, and how long to look."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import finite_number, require_instance, shown
from trimmer.errors import MapError, TrimmerError, WrongTypeError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.mechanism.places import with_values
from trimmer.motion.subject import Subject
from trimmer.response.flows import is_silent, require_subject
from trimmer.response.periodic.pace import is_driven, period_word, waited

_Subject = TypeVar("_Subject", bound="Subject")
FORMAT = 1  # Version of the format of files
MOST_CELLS = 4_000_000  # Cells whose results still fit into memory: a kilobyte or two each


@dataclass(frozen=True)
class Settings:
    """How long each cell is looked at, and from where."""

    most_periods: int = 300  # Drive periods to wait at most; without a drive periods of the slowest mode
    starts: int = 1  # Starts of each cell: rest, or the mechanism's own start, and then random ones
    seed: int = 0  # Seed of the random starts; each cell has its own numbers
    # Keys of measures beside those that all maps have; see ``trimmer.motion.chosen``
    measures: tuple[str, ...] = ()


@dataclass(frozen=True)
class MapInputs:
    """All that the cells of a map depend on."""

    subject: Subject  # The mechanism or loop that is varied
    places: tuple[str, ...]  # One place or two
    values: tuple[tuple[float, ...], ...]  # Values of each place
    settings: Settings  # How long each cell is looked at, and from where

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism, if it is one that is varied."""
        return cast("Mechanism", self.subject)

    @property
    def driven(self) -> bool:
        """Whether periods of a drive are counted, of which the clock of a sampled controller is one."""
        return is_driven(self.subject)

    @property
    def counted(self) -> str:
        """What impacts are counted by: a period of the drive, a sample, or a period of the motion itself."""
        return period_word(self.subject) if self.driven else "period"

    @property
    def waited(self) -> str:
        """How long a motion is waited for at most, in words."""
        if is_silent(self.subject):
            return "the search for orbits"
        return waited(self.subject, self.settings.most_periods)

    @property
    def over(self) -> str:
        """The same where it may have been less, since chaos without a drive is told as soon as it is sure."""
        return self.waited if self.driven or is_silent(self.subject) else f"up to {self.waited}"

    @property
    def count(self) -> int:
        """Number of cells."""
        return len(self.values[0]) * (len(self.values[1]) if len(self.values) > 1 else 1)

    def cell_values(self, number: int) -> tuple[float, ...]:
        """Return the values of a cell; the first place runs within a row."""
        columns = len(self.values[0])
        places = (number % columns, number // columns)
        return tuple(values[at] for values, at in zip(self.values, places, strict=False))

    @property
    def _settings(self) -> dict[str, Any]:
        """The settings, without measures where none are asked for, so that older files are gone on with."""
        settings = asdict(self.settings)
        measures = settings.pop("measures")
        return settings | ({"measures": list(measures)} if measures else {})

    @property
    def header(self) -> dict[str, Any]:
        """The header of the file."""
        from trimmer import __version__

        content = {
            "mechanism": described(self.subject),
            "places": list(self.places),
            "values": [list(values) for values in self.values],
            "settings": self._settings,
        }
        digest = hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()
        return {"trimmer map": FORMAT, "program": __version__, **content, "inputs": digest}


def described(subject: Subject) -> Any:
    """Return a mechanism as its file, or a loop as data that tell it from any other one."""
    if isinstance(subject, Mechanism):
        return subject.to_toml()
    from trimmer.loops.description import loop_as_data

    return loop_as_data(subject)


def varied(mechanism: _Subject, places: tuple[str, ...], values: tuple[float, ...]) -> _Subject:
    """Return the mechanism or loop with other numbers at some places, in whatever order they can be set.

    Raises:
        MechanismError: if the numbers cannot stand there together.
    """
    return with_values(mechanism, zip(places, values, strict=True))


def checked_inputs(mechanism: Subject, values: Mapping[str, ArrayLike], settings: Settings) -> MapInputs:
    """Return the inputs of a map after all was checked that can be without a motion.

    Raises:
        MechanismError, MapError, WrongTypeError: as ``motion_map`` does.
    """
    require_subject(mechanism)
    require_instance("values", values, Mapping, "a mapping of dotted places to values")
    for place in values:
        require_instance("place", place, str, "a dotted place such as plays.bridge.gap")
    if is_silent(mechanism) and settings.starts > 1:
        raise MapError("starts: the orbits of a loop without a drive are searched for; leave it at 1")
    if not 1 <= len(values) <= 2:
        raise MapError(f"a map is over one place or two, not {len(values)}")
    places = tuple(place_text(parse_place(place)) for place in values)
    if len(set(places)) < len(places):
        raise MapError(f"both places are {places[0]}: vary two different numbers, or one")
    for place in places:
        mechanism.value(place)
    lists = tuple(_numbers(place, each) for place, each in zip(places, values.values(), strict=True))
    inputs = MapInputs(mechanism, places, lists, settings)
    if inputs.count > MOST_CELLS:
        raise MapError(f"these are {inputs.count} cells: give values for at most {MOST_CELLS}")
    for axis in range(len(places)):
        others = lists[1 - axis] if len(lists) > 1 else ()
        for value in lists[axis]:
            _check_value(mechanism, places, axis, value, others)
    return inputs


def _numbers(place: str, values: ArrayLike) -> tuple[float, ...]:
    if isinstance(values, str | bytes) or not np.iterable(values):
        raise WrongTypeError(f"values of {place} must be a sequence of numbers, not {shown(values)}")
    numbers = tuple(finite_number(f"{place}[{at}]", value) for at, value in enumerate(values))
    if not numbers:
        raise MapError(f"there is no value of {place}: give at least one")
    if len(set(numbers)) < len(numbers):
        raise MapError(f"a value of {place} is there twice: give each once")
    return numbers


def _check_value(
    mechanism: Subject, places: tuple[str, ...], axis: int, value: float, others: tuple[float, ...]
) -> None:
    """Check that a value can stand at its place with at least one of the other place's values."""
    first = None
    for other in others or (None,):
        pair = (value,) if other is None else (value, other) if axis == 0 else (other, value)
        try:
            varied(mechanism, places, pair)
        except TrimmerError as error:
            first = first or error
        else:
            return
    if first is not None:
        raise first
