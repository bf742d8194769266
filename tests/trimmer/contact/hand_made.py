"""Tables, work space and a log of two modes whose event functions are given polynomials."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from trimmer.contact.statuses import NOTHING
from trimmer.contact.tables import Tables
from trimmer.contact.work import Log, Work, work_for
from trimmer.motion.taylor import DEGREE, LEVELS, bernstein_from_taylor

COUNT = DEGREE + 1
SIZE = 3
"""Entries of the state: two, and one."""
STEP = 0.25


def tables_of(
    polynomials: Sequence[Sequence[float]], owners: Sequence[int], actions: Sequence[int], contacts: int = 2
) -> Tables:
    """Return tables of two modes with the same event functions, which only the constant entry is part of.

    Args:
        polynomials: Coefficients of s^k of each event function.
        owners: Their parts.
        actions: Their meanings.
        contacts: Number of contacts; there are two frictions after them.
    """
    functions, parts = len(polynomials), contacts + 2
    taylor = np.zeros((2, functions, SIZE, COUNT))
    for number, coefficients in enumerate(polynomials):
        taylor[:, number, -1, : len(coefficients)] = coefficients
    bernstein = taylor @ bernstein_from_taylor()[0]
    screen = np.zeros((2, SIZE, SIZE + functions * COUNT))
    screen[:, :, :SIZE] = np.eye(SIZE)
    screen[:, :, SIZE:] = np.moveaxis(bernstein, 1, 2).reshape(2, SIZE, -1)
    series = np.zeros((2, SIZE, COUNT * SIZE))
    series[:, :, :SIZE] = np.eye(SIZE)
    one, events = np.ones(2, dtype=np.int64), np.ones((2, functions, 2), dtype=np.int64)
    return Tables(
        statuses=np.zeros((2, parts), dtype=np.int64),
        settled=np.arange(2),
        step=np.full(2, STEP),
        screen=screen,
        series=series,
        terms=np.full((2, LEVELS), COUNT),
        taylor=taylor,
        sizes=np.moveaxis(abs(taylor), 2, 3).copy(),
        hold=np.stack([np.eye(SIZE)] * 2),
        function_count=functions * one,
        owner=np.array([owners, owners]),
        action=np.array([actions, actions]),
        target=events.copy(),
        kind=0 * events,
        known_action=-1 * events,
        known_zeros=0 * events,
        relaxing_state=np.full(contacts, -1),
        relaxation=np.zeros((2, contacts)),
        gap=np.linspace(4e-5, 7e-5, contacts),
        bernstein_from_taylor=bernstein_from_taylor(),
    )


def work_at(tables: Tables, *state: float) -> Work:
    """Return work space at a state."""
    work = work_for(tables)
    work.state[:] = state
    return work


def log_of(rows: int) -> Log:
    """Return a log whose rows are not written yet."""
    log = Log.empty(rows, SIZE)
    log.part[:], log.kind[:], log.function[:] = -1, NOTHING, -1
    return log
