"""Branches of periodic motions as they are kept: over one number, with their special points."""

import hashlib
import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final

import numpy as np

from report.numbers.twin.grids import KeptCourse
from report.numbers.twin.kept_files import FOLDER, read_kept, rounded, write_kept
from trimmer import FollowedBranch, FollowSettings, Mechanism, TrimmerLoop
from trimmer.arrays import Reals

FILE: Final = FOLDER / "branches.json"  # The branches of the twin
STATE_DIGITS: Final = 10
"""Significant digits of values and states: as many as come out alike whenever a branch is followed."""


@dataclass(frozen=True)
class KeptSpecial:
    """A special point: its kind as a word, the value, and what else is said of it."""

    kind: str
    value: float
    note: str


@dataclass(frozen=True, eq=False)
class KeptBranch:
    """A branch, or one that parts from it."""

    course: KeptCourse  # What it was followed along
    parted: str  # Word of the kind of point at which it parts from another; empty if it was begun by itself
    periods: int  # Drive periods after which its motions repeat
    values: Reals  # Of the number that is varied, SI units, (n,)
    strokes: Reals  # Peak to peak, m, (n,)
    stable: np.ndarray[tuple[int], np.dtype[np.bool_]]  # Whether neighbouring motions approach, (n,)
    states: Reals  # At the start of a drive period, (n, size)
    special: tuple[KeptSpecial, ...]  # The special points
    message: str  # Why it ends

    def special_of(self, kind: str) -> tuple[float, ...]:
        """Return the values of the special points of one kind, such as ``torus``, in their order."""
        return tuple(each.value for each in self.special if each.kind == kind)

    @property
    def stable_pieces(self) -> tuple[tuple[float, float], ...]:
        """First and last value of each run of stable motions."""
        edges = np.flatnonzero(np.diff(np.concatenate([[False], self.stable, [False]]).astype(int)))
        runs = zip(edges[::2], edges[1::2] - 1, strict=True)
        return tuple((float(self.values[first]), float(self.values[last])) for first, last in runs)


def write_branches(followed: list[tuple[KeptCourse, FollowedBranch]], path: Path) -> None:
    """Keep branches, and those that part from them."""
    content = {
        course.name: [_as_data(each, course.output) for each in branch.all()] for course, branch in followed
    }
    write_kept(path, inputs_of(tuple(course for course, _ in followed)), content)


def read_branches(courses: tuple[KeptCourse, ...], path: Path) -> tuple[KeptBranch, ...]:
    """Return the branches that are kept, each followed by those that part from it.

    Raises:
        KeptDataError: if the file is not there, was made from something else, or has been changed since.
    """
    content = read_kept(path, inputs_of(courses))
    return tuple(_from_data(course, data) for course in courses for data in content[course.name])


def inputs_of(courses: tuple[KeptCourse, ...]) -> str:
    """Return the SHA-256 of all that the branches depend on, beside the program."""
    described = [
        [each.name, _described(each.subject), each.place, each.start, each.stop, _settings_as_data(each)]
        for each in courses
    ]
    return hashlib.sha256(json.dumps(described, sort_keys=True).encode()).hexdigest()


def settings_of(course: KeptCourse) -> FollowSettings:
    """Return how a branch is followed."""
    return FollowSettings(largest_step=course.largest_step, bounds=course.bounds, switches=1, quiet=True)


def _settings_as_data(course: KeptCourse) -> dict[str, Any]:
    """Return how a branch is followed as data, without the deadline, of which there is none."""
    return {name: each for name, each in asdict(settings_of(course)).items() if name != "deadline"}


def _described(subject: Mechanism | TrimmerLoop) -> str | list[object]:
    """Return what a branch depends on of what is varied, as data."""
    if isinstance(subject, Mechanism):
        return subject.to_toml()
    return [repr(subject), subject.channels.value, {each: subject.value(each) for each in subject.places}]


def _as_data(branch: FollowedBranch, output: str) -> dict[str, Any]:
    special = [[each.kind.word, rounded(each.value, STATE_DIGITS), each.note] for each in branch.special]
    return {
        "parted": "" if branch.parted is None else branch.parted.kind.word,
        "periods": branch.periods,
        "message": branch.message,
        "values": [rounded(point.value, STATE_DIGITS) for point in branch.points],
        "strokes": [rounded(point.outputs[output].peak_to_peak) for point in branch.points],
        "stable": "".join("s" if point.stable else "u" for point in branch.points),
        "states": [[rounded(each, STATE_DIGITS) for each in point.state.tolist()] for point in branch.points],
        "special": special,
    }


def _from_data(course: KeptCourse, data: dict[str, Any]) -> KeptBranch:
    return KeptBranch(
        course=course,
        parted=data["parted"],
        periods=data["periods"],
        values=np.array(data["values"]),
        strokes=np.array(data["strokes"]),
        stable=np.array([each == "s" for each in data["stable"]], dtype=bool),
        states=np.array(data["states"]),
        special=tuple(KeptSpecial(*each) for each in data["special"]),
        message=data["message"],
    )
