"""A motion at the nodes of Gauss quadrature on each step, and at given times, from its exact flow."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.contact.compilation import sources
from trimmer.contact.tables import Tables
from trimmer.contact.work import Log
from trimmer.motion.compilation import kept
from trimmer.motion.linear_combination import combine, copy, evaluate_terms
from trimmer.motion.taylor import DEGREE

NODES = 26
"""Nodes on a step: exact for products of two polynomials of the degree of the flow."""


class Nodes(NamedTuple):
    """A motion at the nodes of quadrature.

    Attributes:
        times: s, (count,).
        weights: With which integrals over the motion are sums, s, (count,).
        rows: Rows of the log, (count,).
        states: Extended states, (count, N).
    """

    times: Reals
    weights: Reals
    rows: Integers
    states: Reals


def _entry(sources: bytes) -> Callable[..., int]:
    def entry(tables: Tables, log: Log, end: float, rule: tuple[Reals, Reals], room: Nodes) -> int:
        """Write the nodes of all steps; returns their number, and writes as many as there is room for."""
        sources  # noqa: B018
        (points, weights), (times, shares, rows, states) = rule, room
        size, count = log.state.shape[1], 0
        state, following, terms = np.empty(size), np.empty(size), np.empty((DEGREE + 1) * size)
        for row in range(log.start.size):
            until = log.start[row + 1] if row + 1 < log.start.size else end
            mode = tables.settled[log.mode[row]]
            begin, step = log.start[row], tables.step[mode]
            copy(log.state[row], size, state)
            while begin < until:
                length = min(step, until - begin)
                if count + points.size <= times.size:
                    combine(state, tables.series[mode], terms.size, terms)
                    for i in range(points.size):
                        at = count + i
                        times[at] = begin + points[i] * length
                        shares[at] = weights[i] * length
                        rows[at] = row
                        evaluate_terms(terms, DEGREE + 1, points[i] * length / step, states[at])
                        for contact in range(tables.gap.size):
                            rate = tables.relaxation[log.mode[row], contact]
                            if rate > 0.0:
                                z = tables.relaxing_state[contact]
                                states[at, z] = log.state[row, z] * np.exp(
                                    -rate * (times[at] - log.start[row])
                                )
                count += points.size
                combine(state, tables.screen[mode], size, following)
                copy(following, size, state)
                begin += step
        return count

    return kept(entry)


_compiled_entry = _entry(sources())


def _sample_entry(sources: bytes) -> Callable[..., None]:
    def entry(tables: Tables, log: Log, times: Reals, states: Reals) -> None:
        """Write the extended states at times that do not decrease; at an event, just after it."""
        sources  # noqa: B018
        size, done = log.state.shape[1], 0
        state, following, terms = np.empty(size), np.empty(size), np.empty((DEGREE + 1) * size)
        for row in range(log.start.size):
            until = log.start[row + 1] if row + 1 < log.start.size else np.inf
            mode = tables.settled[log.mode[row]]
            begin, step = log.start[row], tables.step[mode]
            copy(log.state[row], size, state)
            fresh = False
            while done < times.size and times[done] < until:
                if times[done] - begin > step:
                    combine(state, tables.screen[mode], size, following)
                    copy(following, size, state)
                    begin += step
                    fresh = False
                    continue
                if not fresh:
                    combine(state, tables.series[mode], terms.size, terms)
                    fresh = True
                evaluate_terms(terms, DEGREE + 1, (times[done] - begin) / step, states[done])
                for contact in range(tables.gap.size):
                    rate = tables.relaxation[log.mode[row], contact]
                    if rate > 0.0:
                        z = tables.relaxing_state[contact]
                        states[done, z] = log.state[row, z] * np.exp(-rate * (times[done] - log.start[row]))
                done += 1

    return kept(entry)


_compiled_sample = _sample_entry(sources())


@cache
def _gauss() -> tuple[Reals, Reals]:
    points, weights = np.polynomial.legendre.leggauss(NODES)
    return (points + 1) / 2, weights / 2


def nodes(tables: Tables, log: Log, end: float) -> Nodes:
    """Return a motion at the nodes of all its steps.

    Integrals of products of two signals are sums with their weights, exact to rounding.

    Args:
        tables: The modes.
        log: The segments.
        end: Time at which the motion ends, s.
    """
    count = NODES * 64
    while True:
        room = Nodes(
            np.empty(count),
            np.empty(count),
            np.empty(count, dtype=np.int64),
            np.empty((count, log.state.shape[1])),
        )
        needed = _compiled_entry(tables, log, float(end), _gauss(), room)
        if needed <= count:
            return Nodes._make(each[:needed] for each in room)
        count = needed


def sample(tables: Tables, log: Log, times: Reals) -> Reals:
    """Return the extended states at times, s, that do not decrease; at an event, just after it.

    Returns:
        Array (number of times, N).
    """
    states = np.empty((len(times), log.state.shape[1]))
    _compiled_sample(tables, log, np.ascontiguousarray(times, dtype=np.float64), states)
    return states
