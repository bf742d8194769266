"""Modes of large systems as rows of what is not zero, from which each step is expanded anew: compiled.

Tables of a step grow with the square of the number of states, for each event function too, and most modes of a
large system are met once. Its matrices have few entries that are not zero, and the Taylor terms of one state
cost no more than a look at tables would.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.compilation import compiled, kept, sources
from trimmer.hybrid.linear_combination import combine, combined_moduli, copy, evaluate_terms
from trimmer.hybrid.series import COUNT, STEP, SWEEPS
from trimmer.hybrid.taylor import LONGEST_STEP

if TYPE_CHECKING:
    from collections.abc import Iterable


class Rows(NamedTuple):
    """Rows of one mode: those of its flow, of what it holds, and of its event functions.

    Attributes:
        ends: Where in the entries each row ends, that of the first one begins before, (2 N + functions + 1,).
        columns: Places of the entries in their rows, (entries,).
        values: The entries, (entries,).
    """

    ends: Integers
    columns: Integers
    values: Reals


def rows_of(parts: Iterable[Reals]) -> Rows:
    """Return the rows of some matrices, one after the other."""
    found = [(*np.nonzero(part), part) for part in parts]
    counts = [np.bincount(rows, minlength=len(part)) for rows, _, part in found]
    return Rows(
        np.concatenate([[0], np.cumsum(np.concatenate(counts))]).astype(np.int64),
        np.concatenate([columns for _, columns, _ in found]).astype(np.int64),
        np.concatenate([part[rows, columns] for rows, columns, part in found]),
    )


def step_of(flow: Reals, states: int) -> float:
    """Return the length of a step, s: see ``trimmer.hybrid.series``; here moduli bound the remainder.

    Args:
        flow: The matrix M, (N, N).
        states: How many of its first entries do not force the others.
    """
    forced = float(abs(flow[states:, states:]).sum(axis=0).max(initial=0.0))
    rows, columns = np.nonzero(flow[:states, :states])
    moduli = abs(flow[rows, columns])
    across = rows != columns
    for _ in range(SWEEPS):
        sums = (
            np.bincount(each[across], weights=moduli[across], minlength=states) for each in (columns, rows)
        )
        column, row = sums
        # Half of what balances each alone, since all are scaled at once.
        scale = np.ones(states)
        np.divide(row, column, out=scale, where=(row > 0.0) & (column > 0.0))
        scale **= 0.25
        moduli = moduli * scale[columns] / scale[rows]
    sums = np.bincount(columns, weights=moduli, minlength=states)
    size = float(sums.max(initial=0.0))
    total = np.ones(states)
    for _ in range(COUNT if size > 0.0 else 0):
        total = np.bincount(columns, weights=moduli * total[rows] / size, minlength=states)
    growth = size * float(total.max(initial=0.0)) ** (1.0 / COUNT)
    return STEP / max(growth, forced, 1.0 / LONGEST_STEP)


@compiled
def multiply(rows: Rows, first: int, factor: float, vector: Reals, result: Reals) -> None:
    """Write a factor times some rows times a vector (N,)."""
    for i in range(result.size):
        total = 0.0
        for entry in range(rows.ends[first + i], rows.ends[first + i + 1]):
            total += rows.values[entry] * vector[rows.columns[entry]]
        result[i] = factor * total


@compiled
def value(rows: Rows, row: int, vector: Reals) -> float:
    """Return a row times a vector (N,)."""
    total = 0.0
    for entry in range(rows.ends[row], rows.ends[row + 1]):
        total += rows.values[entry] * vector[rows.columns[entry]]
    return total


@compiled
def entry_of(rows: Rows, row: int, column: int) -> float:
    """Return an entry of a row."""
    found = 0.0
    for entry in range(rows.ends[row], rows.ends[row + 1]):
        if rows.columns[entry] == column:
            found = rows.values[entry]
    return found


@compiled
def write_terms(rows: Rows, step: float, state: Reals, terms: Reals) -> None:
    """Write the Taylor terms (M h)^k Z / k! of a state, side by side, (COUNT N,)."""
    size = state.size
    copy(state, size, terms)
    for k in range(1, COUNT):
        multiply(rows, 0, step / k, terms[(k - 1) * size : k * size], terms[k * size : (k + 1) * size])


@compiled
def expand(  # noqa: PLR0913
    rows: Rows,
    function: int,
    margin: float,
    known: int,
    terms: Reals,
    bernstein_from_taylor: Reals,
    taylor: Reals,
    bernstein: Reals,
) -> bool:
    """Write the coefficients of an event function over a step.

    Returns:
        Whether one of its Bernstein coefficients is at most a margin. They are written only then, or if some
        are known to be zero.
    """
    size = terms.size // COUNT
    moduli = 0.0
    for k in range(COUNT):
        taylor[k] = value(rows, 2 * size + function, terms[k * size : (k + 1) * size])
        moduli += abs(taylor[k])
    below = not taylor[0] - (moduli - abs(taylor[0])) > margin
    if below or known > 0:
        combine(taylor, bernstein_from_taylor[0], COUNT, bernstein)
        below = False
        for i in range(COUNT):
            below |= not bernstein[i] > margin
    return below


@compiled
def modulus(rows: Rows, row: int, step: float, count: int, state: Reals, room: Reals) -> float:
    """Return the sum of the moduli of what the coefficients of s^0, s^1, ... of a row are made of.

    Args:
        rows: The rows of the mode.
        row: The row.
        step: h, s.
        count: How many coefficients.
        state: The state, (N,).
        room: Room for at least two states.
    """
    size, total = state.size, 0.0
    now, following = room[:size], room[size : 2 * size]
    for i in range(size):
        now[i] = abs(state[i])
    for k in range(count):
        for entry in range(rows.ends[row], rows.ends[row + 1]):
            total += abs(rows.values[entry]) * now[rows.columns[entry]]
        if k + 1 < count:
            for i in range(size):
                following[i] = 0.0
                for entry in range(rows.ends[i], rows.ends[i + 1]):
                    following[i] += abs(rows.values[entry]) * now[rows.columns[entry]]
            for i in range(size):
                now[i] = following[i] * step / (k + 1)
    return total


@compiled
def hold(dense: Reals, rows: Rows, state: Reals, room: Reals) -> None:
    """Make a state fit what a mode holds, by its matrix, transposed, or by its rows if that is empty."""
    size = state.size
    if len(dense) == size:
        combine(state, dense, size, room)
    else:
        multiply(rows, size, 1.0, state, room)
    copy(room, size, state)


@compiled
def value_of(taylor: Reals, rows: Rows, function: int, state: Reals) -> float:
    """Return an event function, by its coefficients, (functions, N, K + 1), or by its row if there are none."""
    size, total = state.size, 0.0
    if taylor.shape[1] == size:
        for i in range(size):
            total += taylor[function, i, 0] * state[i]
    else:
        total = value(rows, 2 * size + function, state)
    return total


@compiled
def coefficient(taylor: Reals, rows: Rows, function: int, place: int, size: int) -> float:
    """Return the entry of an event function at a place of the state (size,)."""
    entry = 0.0
    if taylor.shape[1] == size:
        entry = taylor[function, place, 0]
    else:
        entry = entry_of(rows, 2 * size + function, place)
    return entry


@compiled
def modulus_of(  # noqa: PLR0913
    sizes: Reals, rows: Rows, step: float, function: int, k: int, state: Reals, room: Reals
) -> float:
    """Return the sum of the moduli of what the coefficient of s^k of an event function is made of.

    By rows it is that of all coefficients up to that one.
    """
    size, total = state.size, 0.0
    if sizes.shape[2] == size:
        total = combined_moduli(state, sizes[function, k])
    else:
        total = modulus(rows, 2 * size + function, step, k + 1, state, room)
    return total


def _entry(sources: bytes) -> Callable[..., None]:
    def entry(rows: Rows, step: float, duration: float, tangents: Reals, terms: Reals) -> None:
        sources  # noqa: B018
        for column in range(len(tangents)):
            left = duration
            while left > 0.0:
                write_terms(rows, step, tangents[column], terms)
                evaluate_terms(terms, COUNT, min(left / step, 1.0), tangents[column])
                left -= step

    return kept(entry)


_compiled_entry = _entry(sources())


def carry(rows: Rows, step: float, duration: float, tangents: Reals) -> None:
    """Multiply extended states (columns, N), in place, by the flow of a mode over a duration, s."""
    _compiled_entry(rows, step, duration, tangents, np.empty(COUNT * tangents.shape[1]))
