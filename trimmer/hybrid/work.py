"""The arrays that the compiled integration writes: where the motion is, its log, and work space."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.first_root import DEEPEST
from trimmer.hybrid.tables import Tables
from trimmer.hybrid.taylor import DEGREE


class Work(NamedTuple):
    """Where the motion is, and work space."""

    state: Reals  # Extended state, (N,)
    # How many derivatives of the event functions of each part are known to vanish now, by their actions,
    # (parts, actions)
    zeros: Integers
    negligible: Reals  # Moduli of states that decay by themselves which count as zero, (m,)
    margins: Reals  # By how much these could bring an event function of their part to zero earlier, (m,)
    touches: Reals  # Fractions of a step at which event functions come to zero without crossing, (functions,)
    screened: Reals  # What the screen of a mode gives for a state, (N + functions (K + 1),)
    # following, moduli, terms, bernstein, taylor, pieces: Room for states and polynomials
    following: Reals
    moduli: Reals
    terms: Reals
    bernstein: Reals
    taylor: Reals
    pieces: Reals


def work_for(tables: Tables) -> Work:
    """Return work space for the modes of a system."""
    size, decaying, degree = tables.resets.shape[1], len(tables.scale), DEGREE + 1
    parts = tables.statuses.shape[1]
    return Work(
        state=np.zeros(size),
        zeros=np.zeros((parts, tables.zeros.shape[3]), dtype=np.int64),
        negligible=np.zeros(decaying),
        margins=np.zeros(decaying),
        touches=np.empty(tables.owner.shape[1]),
        screened=np.empty(tables.screen.shape[2]),
        following=np.empty(size),
        moduli=np.empty(2 * size),
        terms=np.empty(size * degree),
        bernstein=np.empty(degree),
        taylor=np.empty(degree),
        pieces=np.empty((DEEPEST + 3, degree + 2)),
    )


ROWS = 256  # Rows of a log to begin with


class Log(NamedTuple):
    """One row per segment of motion between events."""

    start: Reals  # Time of its start, s, (rows,)
    mode: Integers  # Number of its mode, (rows,)
    state: Reals  # Extended state at its start, (rows, N)
    part: Integers  # The part whose event began it, -1 for none, (rows,)
    kind: Integers  # What began it, see ``trimmer.hybrid.system``, (rows,)
    function: Integers  # The event function of the mode before that fell to zero, -1 for none, (rows,)
    touches: Integers  # How many times one came to zero during it without crossing, to rounding, (rows,)

    @classmethod
    def empty(cls, rows: int, size: int) -> Log:
        """Return room for segments of motions with an extended state of some size."""
        return cls(
            np.zeros(rows),
            np.zeros(rows, dtype=np.int64),
            np.zeros((rows, size)),
            np.zeros(rows, dtype=np.int64),
            np.zeros(rows, dtype=np.int64),
            np.zeros(rows, dtype=np.int64),
            np.zeros(rows, dtype=np.int64),
        )

    def longer(self, most: int) -> Log:
        """Return the same rows with twice the room, but for so many at most."""
        more = min(max(len(self.start), ROWS), most - len(self.start))
        return Log._make(
            np.concatenate([each, np.zeros((more, *each.shape[1:]), each.dtype)]) for each in self
        )

    def first(self, rows: int) -> Log:
        """Return the first rows."""
        return Log._make(each[:rows].copy() for each in self)
