"""Values of signals along a motion, from its exact flow, compiled."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.motion.compilation import compiled, kept, sources
from trimmer.motion.linear_combination import combine, evaluate_polynomial
from trimmer.motion.tables import Log, Tables
from trimmer.motion.taylor import DEGREE

BLOCK = 512
"""Samples that are evaluated together."""


def _entry(sources: bytes) -> Callable[[Tables, Log, Integers, Reals, Reals, Reals], None]:
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
        sources  # noqa: B018
        _sample(tables, log, place, functionals, times, values)

    return kept(sample)


@compiled
def _sample(
    tables: Tables, log: Log, place: Integers, functionals: Reals, times: Reals, values: Reals
) -> None:
    state, following = np.empty(log.state.shape[1]), np.empty(log.state.shape[1])
    done = 0
    for segment in range(log.start.size):
        limit = log.start[segment + 1] if segment + 1 < log.start.size else np.inf
        mode, begin = log.mode[segment], log.start[segment]
        step = tables.step[mode]
        state[:] = log.state[segment]
        steps = 0
        while done < times.size and times[done] < limit:
            if (times[done] - begin) / step - steps > 1.0:
                combine(state, tables.whole[mode], state.size, following)
                state[:] = following
                steps += 1
            else:
                done = _within_step(
                    tables, functionals[place[mode]], state, begin, step, steps, limit, times, values, done
                )


@compiled
def _within_step(  # noqa: PLR0913
    tables: Tables,
    functionals: Reals,
    state: Reals,
    begin: float,
    step: float,
    steps: int,
    limit: float,
    times: Reals,
    values: Reals,
    done: int,
) -> int:
    """Evaluate all times from the index ``done`` on that lie within one step, and return the next index."""
    count = DEGREE + 1
    coefficients = np.empty(values.shape[0] * count)
    combine(state, functionals, coefficients.size, coefficients)
    fractions = np.empty(BLOCK)
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


sample = _entry(sources())
