"""Values of signals along a motion, from its exact flow, compiled."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.compilation import compiled, kept, sources
from trimmer.hybrid.linear_combination import combine, copy, evaluate_polynomial
from trimmer.hybrid.taylor import DEGREE
from trimmer.motion.tables import Log, Tables

BLOCK = 512
"""Samples that are evaluated together."""


class _Room(NamedTuple):
    """Room for two states, the polynomials of the functionals over a step, and fractions of it."""

    state: Reals
    following: Reals
    coefficients: Reals
    fractions: Reals


def _entry(sources: bytes) -> Callable[..., None]:
    def entry(
        tables: Tables,
        log: Log,
        place: Integers,
        functionals: Reals,
        times: Reals,
        room: _Room,
        values: Reals,
    ) -> None:
        sources  # noqa: B018
        _sample(tables, log, place, functionals, times, room, values)

    return kept(entry)


@compiled
def _sample(
    tables: Tables, log: Log, place: Integers, functionals: Reals, times: Reals, room: _Room, values: Reals
) -> None:
    state, following, done = room.state, room.following, 0
    for segment in range(log.start.size):
        limit = log.start[segment + 1] if segment + 1 < log.start.size else np.inf
        mode, begin = log.mode[segment], log.start[segment]
        step = tables.step[mode]
        copy(log.state[segment], state.size, state)
        steps = 0
        while done < times.size and times[done] < limit:
            if (times[done] - begin) / step - steps > 1.0:
                combine(state, tables.whole[mode], state.size, following)
                copy(following, state.size, state)
                steps += 1
            else:
                done = _within_step(
                    functionals[place[mode]], room, begin, step, steps, limit, times, values, done
                )


@compiled
def _within_step(  # noqa: PLR0913
    functionals: Reals,
    room: _Room,
    begin: float,
    step: float,
    steps: int,
    limit: float,
    times: Reals,
    values: Reals,
    done: int,
) -> int:
    """Evaluate all times from the index ``done`` on that lie within one step, and return the next index."""
    count, coefficients, fractions = DEGREE + 1, room.coefficients, room.fractions
    combine(room.state, functionals, coefficients.size, coefficients)
    while True:
        used = 0
        while used < BLOCK and done + used < times.size and times[done + used] < limit:
            fraction = (times[done + used] - begin) / step - steps
            if fraction > 1.0:
                break
            fractions[used] = fraction
            used += 1
        if used == 0:
            return done
        for output in range(values.shape[0]):
            evaluate_polynomial(
                coefficients[output * count : (output + 1) * count],
                fractions[:used],
                values[output, done : done + used],
            )
        done += used


_compiled_entry = _entry(sources("motion"))


def sample(
    tables: Tables, log: Log, place: Integers, functionals: Reals, times: Reals, values: Reals
) -> None:
    """Evaluate functionals of the state at times that do not decrease; at an event, just after it.

    Args:
        tables: The modes.
        log: The segments of the motion.
        place: For each mode the first index into ``functionals``.
        functionals: Polynomials over a step, transposed and side by side: (visited modes, n, p (K + 1)).
        times: Instants, s, none after the end of the motion.
        values: Where the result goes: (p, number of times).
    """
    size, coefficients = log.state.shape[1], len(values) * (DEGREE + 1)
    room = _Room(np.empty(size), np.empty(size), np.empty(coefficients), np.empty(BLOCK))
    _compiled_entry(tables, log, place, functionals, times, room, values)
