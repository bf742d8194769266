"""A motion at the nodes of Gauss quadrature on each step, and at given times, from its exact flow."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.compilation import inlined, kept, sources
from trimmer.hybrid.linear_combination import combine, copy, evaluate_terms
from trimmer.hybrid.sparse import Rows, write_terms
from trimmer.hybrid.tables import Tables
from trimmer.hybrid.taylor import DEGREE
from trimmer.hybrid.work import Log

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


class _Step(NamedTuple):
    """Room for the state at the start of a step, the next one, and the terms of its series."""

    state: Reals
    following: Reals
    terms: Reals


@inlined
def _decay(tables: Tables, log: Log, row: int, time: float, state: Reals) -> None:
    """Write the states that decay by themselves, which the steps leave out."""
    for part in range(tables.scale.size):
        rate = tables.decay[log.mode[row], part]
        if rate > 0.0:
            z = tables.decaying_state[part]
            state[z] = log.state[row, z] * math.exp(-rate * (time - log.start[row]))


def _entry(sources: bytes) -> Callable[..., None]:
    def entry(tables: Tables, rows: Rows | None, log: Log, times: Reals, work: _Step, states: Reals) -> None:
        """Write the extended states at times that do not decrease; at an event, just after it."""
        sources  # noqa: B018
        state, following, terms = work
        size, done = state.size, 0
        for row in range(log.start.size):
            until = log.start[row + 1] if row + 1 < log.start.size else np.inf
            mode = tables.settled[log.mode[row]]
            begin, step = log.start[row], tables.step[mode]
            copy(log.state[row], size, state)
            fresh = False
            while done < times.size and times[done] < until:
                if rows is not None and not fresh:
                    write_terms(rows, mode, step, state, terms)
                    fresh = True
                if times[done] - begin > step:
                    if rows is not None:
                        evaluate_terms(terms, DEGREE + 1, 1.0, following)
                    else:
                        combine(state, tables.screen[mode], size, following)
                    copy(following, size, state)
                    begin += step
                    fresh = False
                    continue
                if rows is None and not fresh:
                    combine(state, tables.series[mode], terms.size, terms)
                    fresh = True
                evaluate_terms(terms, DEGREE + 1, (times[done] - begin) / step, states[done])
                _decay(tables, log, row, times[done], states[done])
                done += 1

    return kept(entry)


_compiled_entry = _entry(sources())


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
    points, weights = _gauss()
    lasts, lengths = np.append(log.start[1:], end) - log.start, tables.step[tables.settled[log.mode]]
    steps = np.ceil(lasts / lengths).astype(np.int64)
    rows = np.repeat(np.arange(len(steps)), steps)
    begins = (np.arange(len(rows)) - np.repeat(np.cumsum(steps) - steps, steps)) * lengths[rows]
    taken = np.minimum(lengths[rows], lasts[rows] - begins)
    times = (log.start[rows] + begins)[:, None] + taken[:, None] * points
    return Nodes(
        times.ravel(),
        (taken[:, None] * weights).ravel(),
        np.repeat(rows, NODES),
        sample(tables, log, times.ravel()),
    )


def sample(tables: Tables, log: Log, times: Reals) -> Reals:
    """Return the extended states at times, s, that do not decrease; at an event, just after it.

    Returns:
        Array (number of times, N).
    """
    size = log.state.shape[1]
    states = np.empty((len(times), size))
    step = _Step(np.empty(size), np.empty(size), np.empty((DEGREE + 1) * size))
    _compiled_entry(tables, tables.rows, log, np.ascontiguousarray(times, dtype=np.float64), step, states)
    return states
