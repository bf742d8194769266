"""Tables of loops made by hand: a body moves to and fro between two walls by one unit a step."""

from __future__ import annotations

import numpy as np

from trimmer.motion.tables import Log, Tables
from trimmer.motion.taylor import DEGREE, LEVELS, bernstein_from_taylor

COUNT = DEGREE + 1
STEP = 0.25
WALL = 0.4


def tables_of(*rows: np.ndarray) -> Tables:
    """Return tables of two modes at rest with event functions, (n, coefficients of s^k) each, n = 2."""
    functions = len(rows)
    taylor = np.zeros((2, functions, 2, COUNT))
    for number, row in enumerate(rows):
        taylor[:, number, :, : np.shape(row)[1]] = row
    series = np.zeros((2, 2, COUNT * 2))
    series[:, :, :2] = np.eye(2)
    one = np.ones((2, functions), dtype=np.int64)
    return Tables(
        known=np.ones(2, dtype=np.bool_),
        step=np.full(2, STEP),
        whole=np.stack([np.eye(2)] * 2),
        series=series,
        terms=np.full((2, LEVELS), COUNT),
        bernstein=taylor @ bernstein_from_taylor()[0],
        taylor=taylor,
        sizes=abs(taylor),
        event_rows=taylor[..., 0],
        event_count=functions * np.ones(2, dtype=np.int64),
        component=np.tile(np.arange(functions), (2, 1)),
        number=0 * one,
        relay=-1 * one,
        held=np.zeros((2, functions), dtype=np.bool_),
        target=np.zeros((2, functions, 2), dtype=np.int64),
        zeros=-np.ones((2, functions, 2, 2), dtype=np.int64),
        continuous=9 * one,
        reset=np.tile(np.eye(2), (2, functions, 1, 1)),
        bernstein_from_taylor=bernstein_from_taylor(),
    )


def constant(*polynomials: tuple[float, ...]) -> Tables:
    """Return tables whose event functions do not depend on the state, whose second entry is one."""
    return tables_of(*(np.array([np.zeros(len(each)), each]) for each in polynomials))


def between_walls() -> Tables:
    tables = constant((WALL, -1.0))
    tables.target[0], tables.target[1] = 1, 0
    for mode, sign in enumerate((1.0, -1.0)):
        tables.whole[mode, 1, 0] = tables.series[mode, 1, 2] = sign
        tables.taylor[mode, 0, 0, 0] = -sign
        tables.sizes[mode, 0, 0, 0] = 1.0
        tables.bernstein[mode] = tables.taylor[mode] @ bernstein_from_taylor()[0]
    return tables


def log_of(rows: int, *state: float) -> Log:
    log = Log(
        np.zeros(rows),
        np.zeros(rows, dtype=np.int64),
        np.zeros((rows, 2)),
        np.full(rows, -1),
        np.zeros(rows, dtype=np.bool_),
        np.zeros(rows, dtype=np.int64),
    )
    log.state[0] = state or (0.0, 1.0)
    return log
