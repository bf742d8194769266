"""What is measured of a motion, as functionals of its extended state in each mode.

A signal is given by a function from the number of a mode to a row (N,); its rate is that row times the flow.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from trimmer.arrays import Flags, Integers, Reals
    from trimmer.hybrid.tables import Modes
    from trimmer.motion.course import Course

Signal: TypeAlias = Callable[[int], "Reals"]


@dataclass(frozen=True, eq=False)
class Steady:
    """A signal that has the same row, (N,), in every mode."""

    row: Reals

    def __call__(self, mode: int) -> Reals:
        """Return the row, (N,)."""
        return self.row


class OwnValues(ABC):
    """A signal whose values are those of its rows in general, but not everywhere."""

    @abstractmethod
    def __call__(self, mode: int) -> Reals:
        """Return the row, (N,)."""

    @abstractmethod
    def along(self, course: Course, rows: Integers, states: Reals) -> Reals:
        """Return the values, as ``along`` does."""


@dataclass(frozen=True, eq=False)
class Readout:
    """A signal under a name, its unit, and how fast it moves on beyond what it says, per second."""

    signal: Signal
    unit: str
    speed: float = 0.0


def read(course: Course, readouts: Iterable[Readout], rows: Integers, states: Reals) -> Reals:
    """Return what is read at states, (count, N), in rows, (count,), of the log: (count, readouts)."""
    signals = [each.signal for each in readouts]
    if all(isinstance(each, Steady) for each in signals):
        steady = [each.row for each in signals if isinstance(each, Steady)]
        return np.asarray(states @ np.array(steady).reshape(-1, states.shape[1]).T)
    return np.column_stack([along(course, each, rows, states) for each in signals])


def rate(modes: Modes[Any], signal: Signal) -> Signal:
    """Return the rate of a signal."""
    return lambda mode: np.asarray(signal(mode) @ modes[mode].flow)


def along(course: Course, signal: Signal, rows: Integers, states: Reals) -> Reals:
    """Return a signal at states, (count, N), that lie in rows, (count,), of the log of a motion."""
    if isinstance(signal, OwnValues):
        return signal.along(course, rows, states)
    return np.asarray(np.einsum("ij,ij->i", states, row_of_each(course, signal)[rows]))


def row_of_each(course: Course, signal: Signal) -> Reals:
    """Return the functional of a signal in each row of the log, (rows, N)."""
    modes, places = course.met
    table = np.array([signal(mode) for mode in modes.tolist()])
    return np.asarray(table[places])


def while_status(course: Course, part: int, statuses: tuple[int, ...]) -> Flags:
    """Say of each row of the log whether a part has one of some statuses, (rows,)."""
    here = course.modes.tables.statuses[course.log.mode, part]
    return np.asarray((here[:, None] == np.array(statuses)).any(axis=1))


def share_of_time(course: Course, counts: Flags) -> float:
    """Return the share of its duration that a motion spends in those rows of the log that count, (rows,)."""
    return float(np.diff(np.append(course.log.start, course.duration))[counts].sum() / course.duration)
