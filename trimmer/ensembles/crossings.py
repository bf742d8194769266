"""Where -1/G of many trimmers meets N: enclosed between two frequencies, or doubtful.

Where the lag of -1/G is one that N can have, the amplitude is known, and what is left is a function h of
omega, whose changes of sign are looked for.
"""

from typing import NamedTuple

import numpy as np

from trimmer.arrays import Flags, Places, Reals
from trimmer.ensembles.gain_by_phase import gain_by_lag
from trimmer.ensembles.grid import FrequencyGrid, grid_at, merged
from trimmer.ensembles.responses import Responses

STEEP = 0.6  # Turn of the phase between two frequencies, rad, from which a step is too coarse to be trusted
NEAR = 0.02  # Distance of h from 0 at an extremum below which two solutions may hide there, or be none
MARGIN = 1e-3
"""Lag, rad, within which it is doubtful whether a solution lies beyond the largest or smallest amplitude."""
ENDS = 0.005
"""Ln |1/G| above which no limit cycle is taken to lie beyond the lowest and the highest frequency."""
HALVINGS = 6
REFINEMENTS = 3
WORST = 4  # Steps of each trimmer that are refined each time, by as many frequencies as ``INSERTED``
INSERTED = 5


class Crossings(NamedTuple):
    """Enclosures of solutions."""

    rows: Places  # The trimmer of each, shape (m,)
    lower: Reals  # Frequency below it, in units of the reference, shape (m,)
    upper: Reals  # Frequency above it
    u: Reals  # gap / amplitude near it
    doubtful: Flags  # Trimmers for which an enclosure may be missing, or be none, shape (n,)


def crossings(responses: Responses, omegas: Reals) -> Crossings:
    """Find the crossings of N with -1/G at rising frequencies in units of the references, (n, points)."""
    grid = grid_at(responses, omegas)
    doubtful = _open_ends(grid)
    rows, parts = np.arange(len(omegas)), []
    for refinement in range(REFINEMENTS + 1):
        urgency = _urgency(grid)
        left = urgency.max(axis=1) > 0
        done = ~left if refinement < REFINEMENTS else np.full_like(left, True)
        parts.append(_enclosures(responses, rows[done], FrequencyGrid(*(each[done] for each in grid))))
        if refinement == REFINEMENTS or not left.any():
            doubtful[rows[left]] = True
            break
        rows, grid = rows[left], FrequencyGrid(*(each[left] for each in grid))
        grid = merged(grid, grid_at(responses[rows], _inserted(grid.omega, urgency[left])))
    for part in parts:
        doubtful[part.rows[~part.certain]] = True
    found = Enclosures(*(np.concatenate(each) for each in zip(*parts, strict=True)))
    real = found.exists
    return Crossings(found.rows[real], found.lower[real], found.upper[real], found.u[real], doubtful)


class Enclosures(NamedTuple):
    """Changes of the sign of h, as in ``Crossings``; whether N has the lag there, and whether certainly."""

    rows: Places
    lower: Reals
    upper: Reals
    u: Reals
    exists: Flags
    certain: Flags


def _enclosures(responses: Responses, rows: Places, grid: FrequencyGrid) -> Enclosures:
    """Find the changes of sign of some trimmers, and halve them."""
    positive, inside = grid.h > 0, grid.inside
    changes = (positive[:, 1:] != positive[:, :-1]) & (inside[:, 1:] | inside[:, :-1])
    places, columns = np.nonzero(changes)
    lower, upper = grid.omega[places, columns], grid.omega[places, columns + 1]
    low_is_positive = positive[places, columns]
    here = responses[rows[places]]
    middle = grid_at(here, 0.5 * (lower + upper)[:, None])
    for _ in range(HALVINGS):
        same = (middle.h[:, 0] > 0) == low_is_positive
        lower = np.where(same, middle.omega[:, 0], lower)
        upper = np.where(same, upper, middle.omega[:, 0])
        middle = grid_at(here, 0.5 * (lower + upper)[:, None])
    lag = middle.lag[:, 0]
    certain = (np.abs(lag) > MARGIN) & (np.abs(lag - 0.5 * np.pi) > MARGIN)
    return Enclosures(rows[places], lower, upper, gain_by_lag().u_at(lag), middle.inside[:, 0], certain)


def _urgency(grid: FrequencyGrid) -> Reals:
    """Return how much each step needs a closer look, shape (n, points - 1); 0 if it does not."""
    turns = np.abs(np.diff(grid.lag))
    turns = np.minimum(turns, 2.0 * np.pi - turns)
    # Where only one end is loud the other has no lag, but 1/G is large there.
    urgency = np.where(grid.loud[:, 1:] & grid.loud[:, :-1] & (turns > STEEP), turns, 0.0)
    near = np.pi * (_touches(grid.h, grid.inside) & grid.loud[:, 1:-1])
    urgency[:, 1:] += near
    urgency[:, :-1] += near
    return urgency


def _inserted(omega: Reals, urgency: Reals) -> Reals:
    """Return frequencies within the steps that need it most."""
    columns = np.argpartition(-urgency, WORST, axis=1)[:, :WORST]
    lower = np.take_along_axis(omega, columns, axis=1)[:, :, None]
    upper = np.take_along_axis(omega, columns + 1, axis=1)[:, :, None]
    shares = np.arange(1, INSERTED + 1) / (INSERTED + 1)
    return np.asarray((lower + (upper - lower) * shares).reshape(len(omega), -1))


def _touches(h: Reals, inside: Flags) -> Flags:
    """Return where h comes near 0 and may hide two solutions between points of a sign, (n, points - 2)."""
    sizes = np.abs(h)
    before, here, after = sizes[:, :-2], sizes[:, 1:-1], sizes[:, 2:]
    positive = h > 0
    found = (here <= before) & (here <= after)
    found &= (positive[:, :-2] == positive[:, 1:-1]) & (positive[:, 1:-1] == positive[:, 2:])
    found &= inside[:, :-2] | inside[:, 1:-1] | inside[:, 2:]
    # The vertex of the parabola through the three lies nearer by less than what the others are farther off.
    found &= here < np.maximum(before, after) - here + NEAR
    return np.asarray(found)


def _open_ends(grid: FrequencyGrid) -> Flags:
    """Return where |N G| may be 1 at the lowest or the highest frequency, so that more may lie beyond."""
    return np.asarray((grid.loud & (grid.h > -ENDS))[:, [0, -1]].any(axis=1))
