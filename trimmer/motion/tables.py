"""What the compiled march reads and writes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]


class Tables(NamedTuple):
    """Everything the march needs of all modes; the first axis is the mode, the second the guard.

    Attributes:
        known: Whether the mode has been tabulated.
        step: h, s.
        whole: exp(M h), transposed: (modes, n, n).
        series: (M h)^k / k!, transposed and side by side: (modes, n, (K + 1) n).
        terms: How many terms of the series do for fractions up to 4^-level of a step: (modes, LEVELS).
        bernstein: Bernstein coefficients of the guards over a step: (modes, guards, n, K + 1).
        taylor: Their coefficients of s^k: (modes, guards, n, K + 1).
        sizes: Sums of the moduli of what these are made of, in the same shape.
        guard_rows: Guards as functionals: (modes, guards, n).
        guard_count: Guards in use.
        component: Component that owns the guard.
        number: Number of the guard among those of its owner.
        target: Mode after reaching zero, and after being negative at once: (modes, guards, 2).
        zeros: Known zeros of the owner's guards in these target modes: (modes, guards, 2, 3).
        continuous: How many of these no jump of another component's output takes away: (modes, guards).
        reset: The state afterwards, transposed, in either case: (modes, guards, n, n).
        bernstein_from_taylor: Matrices of ``trimmer.motion.taylor.bernstein_from_taylor``.
    """

    known: Flags
    step: Reals
    whole: Reals
    series: Reals
    terms: Integers
    bernstein: Reals
    taylor: Reals
    sizes: Reals
    guard_rows: Reals
    guard_count: Integers
    component: Integers
    number: Integers
    target: Integers
    zeros: Integers
    continuous: Integers
    reset: Reals
    bernstein_from_taylor: Reals


class Log(NamedTuple):
    """One row per stretch of motion between events.

    Attributes:
        start: Time of its start, s.
        mode: Its mode.
        state: Extended state at its start.
        guard: Guard of the mode before that began it, -1 for the start of the motion.
        jumped: Whether that guard was negative at once.
        touches: How many times a guard came to zero during it without crossing, to rounding.
    """

    start: Reals
    mode: Integers
    state: Reals
    guard: Integers
    jumped: Flags
    touches: Integers


class Work(NamedTuple):
    """Arrays that the march uses again and again.

    Attributes:
        state: Extended state at the start of a step.
        following: Where the next one is put together.
        terms: Taylor terms of the state over the step: (K + 1) n.
        bernstein: Bernstein coefficients of one guard over the step.
        taylor: Its coefficients of s^k.
        sizes: Sums of the moduli of the terms of these.
        pieces: Coefficients of parts of the step, for the search of a zero.
        known_zeros: For each guard, how many derivatives vanish at the start of the stretch.
        touch: For each guard, the fraction of the step at which it touches zero without crossing.
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
