"""The arrays that the compiled integration reads and writes: tables of modes, log, work space."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from trimmer.arrays import Flags, Integers, Reals

TOGETHER = -2
"""In place of the number of an event function: relays and frictions were decided together."""


class Tables(NamedTuple):
    """All that the integration needs of the modes; the first axis is the mode, the second the event function.

    Attributes:
        known: Whether the mode has been tabulated: (modes,).
        step: Length h of a step, s: (modes,).
        whole: exp(M h), transposed: (modes, n, n).
        series: (M h)^k / k!, transposed and side by side: (modes, n, (K + 1) n).
        terms: How many terms of the series do for fractions up to 4^-level of a step: (modes, LEVELS).
        bernstein: Bernstein coefficients of the event functions over a step: (modes, functions, n, K + 1).
        taylor: Their coefficients of s^k: (modes, event functions, n, K + 1).
        sizes: Sums of the moduli of what these are made of, in the same shape.
        event_rows: Event functions as functionals: (modes, event functions, n).
        event_count: Number of event functions in use: (modes,).
        component: Component that owns the event function, the first one if several are coupled:
            (modes, event functions).
        number: Number of the event function among those of its owner: (modes, event functions).
        relay: Component whose switching function it is, if that is a relay or friction, else -1:
            (modes, event functions).
        held: Whether a component is a relay or friction that is held: (modes, components).
        target: Mode after reaching zero, and after being negative at once: (modes, event functions, 2).
        zeros: Known zeros of the owner's event functions in these target modes, by their numbers, -1 where
            none are told: (modes, event functions, 2, numbers).
        continuous: How many of these no jump of another component's output takes away: (modes, functions).
        reset: The state afterwards, transposed, in either case: (modes, event functions, n, n).
        bernstein_from_taylor: Matrices of ``trimmer.hybrid.taylor.bernstein_from_taylor``.
    """

    known: Flags
    step: Reals
    whole: Reals
    series: Reals
    terms: Integers
    bernstein: Reals
    taylor: Reals
    sizes: Reals
    event_rows: Reals
    event_count: Integers
    component: Integers
    number: Integers
    relay: Integers
    held: Flags
    target: Integers
    zeros: Integers
    continuous: Integers
    reset: Reals
    bernstein_from_taylor: Reals


class Log(NamedTuple):
    """One row per segment of motion between events; all arrays have as many rows.

    Attributes:
        start: Time of its start, s.
        mode: Number of its mode.
        state: Extended state at its start: (rows, n).
        event_function: That of the mode before that began it, -1 for the start of the motion, or TOGETHER.
        jumped: Whether that event function was negative at once.
        touches: How many times an event function came to zero during it without crossing, to rounding.
    """

    start: Reals
    mode: Integers
    state: Reals
    event_function: Integers
    jumped: Flags
    touches: Integers


class Pause(NamedTuple):
    """How far an integration has come; all are arrays, since compiled code writes them.

    Attributes:
        valid: Whether it goes on from here, and not from the start of a segment, shape (1,).
        segment: Number of its last segment, shape (1,).
        steps: Whole steps since the start of that segment, shape (1,).
        late: By how much the exact start of the segment is later than in the log, s, shape (1,).
        reached: Time reached, s, shape (1,).
        state: Extended state there, shape (n,).
    """

    valid: Flags
    segment: Integers
    steps: Integers
    late: Reals
    reached: Reals
    state: Reals


def new_pause(tables: Tables) -> Pause:
    """Return the pause of an integration that is to begin at the start of a segment."""
    return Pause(
        valid=np.zeros(1, dtype=np.bool_),
        segment=np.zeros(1, dtype=np.int64),
        steps=np.zeros(1, dtype=np.int64),
        late=np.zeros(1),
        reached=np.zeros(1),
        state=np.zeros(tables.whole.shape[1]),
    )


class Limits(NamedTuple):
    """Where an integration stops before its end.

    Attributes:
        segments: Largest number of segments in the log.
        steps: Largest number of steps.
        cascade: Largest number of events at one instant.
    """

    segments: int
    steps: int
    cascade: int


class Work(NamedTuple):
    """Work space of the integration, allocated once.

    Attributes:
        state: Extended state at the start of a step.
        following: Where the next one is put together.
        terms: Taylor terms of the state over the step: (K + 1) n.
        bernstein: Bernstein coefficients of one event function over the step.
        taylor: Its coefficients of s^k.
        sizes: Sums of the moduli of the terms of these.
        pieces: Coefficients of parts of the step, for the search of a zero.
        known_zeros: For each event function, how many derivatives vanish at the start of the segment.
        touch: For each event function, the fraction of the step at which it touches zero without crossing.
    """

    state: Reals
    following: Reals
    terms: Reals
    bernstein: Reals
    taylor: Reals
    sizes: Reals
    pieces: Reals
    known_zeros: Integers
    touch: Reals
