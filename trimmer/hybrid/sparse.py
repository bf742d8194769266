"""Modes of large systems as rows of what is not zero, from which each step is expanded anew: compiled.

Tables of a step grow with the square of the number of states, for each event function too, and most modes
of a large system are met once. Its matrices have few entries that are not zero, and the Taylor terms of one
state cost no more than a look at tables would. Where there are no rows, which the compiler sees, the tables
serve.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.hybrid.compilation import compiled, kept, sources
from trimmer.hybrid.linear_combination import combine, combined_moduli, copy, evaluate_terms
from trimmer.hybrid.series import COUNT, STEP, SWEEPS
from trimmer.hybrid.taylor import LONGEST_STEP


class Rows(NamedTuple):
    """Rows of modes: of each those of its flow, of what it holds, and of its event functions.

    Attributes:
        ends: Where in the entries each row ends, behind where the first one of a mode begins,
            (modes, 2 N + functions + 1).
        columns: Places of the entries in their rows, (entries,).
        values: The entries, (entries,).
    """

    ends: Integers
    columns: Integers
    values: Reals


def with_rows(rows: Rows, mode: int, parts: Iterable[Reals]) -> Rows:
    """Return rows with those of some matrices, one after the other, as those of a mode."""
    found = [(*np.nonzero(part), part) for part in parts]
    counts = [np.bincount(lines, minlength=len(part)) for lines, _, part in found]
    begin = int(rows.ends[:mode].max(initial=0))
    ends = begin + np.concatenate([[0], np.cumsum(np.concatenate(counts))])
    rows.ends[mode, : len(ends)] = ends
    more = max(ends[-1], 2 * len(rows.values)) - len(rows.values) if ends[-1] > len(rows.values) else 0
    longer = Rows(
        rows.ends,
        np.concatenate([rows.columns, np.zeros(more, dtype=np.int64)]) if more else rows.columns,
        np.concatenate([rows.values, np.zeros(more)]) if more else rows.values,
    )
    longer.columns[begin : ends[-1]] = np.concatenate([columns for _, columns, _ in found])
    longer.values[begin : ends[-1]] = np.concatenate([part[lines, columns] for lines, columns, part in found])
    return longer


def moduli_times(rows: Rows, mode: int, first: int, count: int, vector: Reals) -> Reals:
    """Return the moduli of some rows of a mode times a vector (N,)."""
    ends = rows.ends[mode, first : first + count + 1]
    entries, lines = slice(ends[0], ends[-1]), np.repeat(np.arange(count), np.diff(ends))
    products = abs(rows.values[entries]) * vector[rows.columns[entries]]
    return _sums(lines, products, count)


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
        column = _sums(columns[across], moduli[across], states)
        row = _sums(rows[across], moduli[across], states)
        # Half of what balances each alone, since all are scaled at once.
        scale = np.ones(states)
        np.divide(row, column, out=scale, where=(row > 0.0) & (column > 0.0))
        scale **= 0.25
        moduli = moduli * scale[columns] / scale[rows]
    size = float(_sums(columns, moduli, states).max(initial=0.0))
    total = np.ones(states)
    for _ in range(COUNT if size > 0.0 else 0):
        total = _sums(columns, moduli * total[rows] / size, states)
    growth = size * float(total.max(initial=0.0)) ** (1.0 / COUNT)
    return float(STEP / max(growth, forced, 1.0 / LONGEST_STEP))


def _sums(places: Integers, values: Reals, count: int) -> Reals:
    """Return the sums of the values at each of some places, (count,)."""
    return np.asarray(np.bincount(places, weights=values, minlength=count), dtype=np.float64)


@compiled
def multiply(rows: Rows, mode: int, first: int, factor: float, vector: Reals, result: Reals) -> None:
    """Write a factor times some rows of a mode times a vector (N,)."""
    ends, columns, values = rows.ends[mode], rows.columns, rows.values
    for i in range(result.size):
        total = 0.0
        for entry in range(ends[first + i], ends[first + i + 1]):
            total += values[entry] * vector[columns[entry]]
        result[i] = factor * total


@compiled
def _function(rows: Rows, mode: int, function: int, terms: Reals, first: int, size: int) -> float:
    """Return an event function of the state (size,) that begins at a place of an array."""
    ends, total = rows.ends[mode], 0.0
    for entry in range(ends[2 * size + function], ends[2 * size + function + 1]):
        total += rows.values[entry] * terms[first + rows.columns[entry]]
    return total


@compiled
def write_terms(rows: Rows, mode: int, step: float, state: Reals, terms: Reals) -> None:
    """Write the Taylor terms (M h)^k Z / k! of a state, side by side, (COUNT N,)."""
    size = state.size
    copy(state, size, terms)
    for k in range(1, COUNT):
        multiply(rows, mode, 0, step / k, terms[(k - 1) * size : k * size], terms[k * size : (k + 1) * size])


@compiled
def expand(  # noqa: PLR0913
    rows: Rows,
    mode: int,
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
    size, rest = terms.size // COUNT, 0.0
    for k in range(COUNT):
        taylor[k] = _function(rows, mode, function, terms, k * size, size)
        rest += abs(taylor[k]) if k > 0 else 0.0
    below = not taylor[0] - rest > margin
    if below or known > 0:
        combine(taylor, bernstein_from_taylor[0], COUNT, bernstein)
        below = False
        for i in range(COUNT):
            below |= not bernstein[i] > margin
    return below


@compiled
def _modulus(
    rows: Rows, mode: int, step: float, function: int, count: int, state: Reals, room: Reals
) -> float:
    """Return the sum of the moduli of what the first coefficients of an event function are made of."""
    ends, columns, values = rows.ends[mode], rows.columns, rows.values
    size, total, row = state.size, 0.0, 2 * state.size + function
    for i in range(size):
        room[i] = abs(state[i])
    for k in range(count):
        for entry in range(ends[row], ends[row + 1]):
            total += abs(values[entry]) * room[columns[entry]]
        for i in range(size if k + 1 < count else 0):
            room[size + i] = 0.0
            for entry in range(ends[i], ends[i + 1]):
                room[size + i] += abs(values[entry]) * room[columns[entry]]
        for i in range(size if k + 1 < count else 0):
            room[i] = room[size + i] * step / (k + 1)
    return total


@compiled
def hold(dense: Reals, rows: Rows | None, mode: int, state: Reals, room: Reals) -> None:
    """Make a state fit what a mode holds, by its matrix, transposed, or by its rows."""
    size = state.size
    if rows is None:
        combine(state, dense, size, room)
    else:
        multiply(rows, mode, size, 1.0, state, room)
    copy(room, size, state)


@compiled
def value_of(taylor: Reals, rows: Rows | None, mode: int, function: int, state: Reals) -> float:
    """Return an event function, by its coefficients, (functions, N, K + 1), or by its row."""
    size, total = state.size, 0.0
    if rows is None:
        for i in range(size):
            total += taylor[function, i, 0] * state[i]
    else:
        total = _function(rows, mode, function, state, 0, size)
    return total


@compiled
def coefficient(taylor: Reals, rows: Rows | None, mode: int, function: int, place: int, size: int) -> float:
    """Return the entry of an event function at a place of the state (size,)."""
    found = 0.0
    if rows is None:
        found = taylor[function, place, 0]
    else:
        ends = rows.ends[mode]
        for entry in range(ends[2 * size + function], ends[2 * size + function + 1]):
            if rows.columns[entry] == place:
                found = rows.values[entry]
    return found


@compiled
def modulus_of(  # noqa: PLR0913
    sizes: Reals, rows: Rows | None, mode: int, step: float, function: int, k: int, state: Reals, room: Reals
) -> float:
    """Return the sum of the moduli of what the coefficient of s^k of an event function is made of.

    By rows it is that of all coefficients up to that one.
    """
    total = 0.0
    if rows is None:
        total = combined_moduli(state, sizes[function, k])
    else:
        total = _modulus(rows, mode, step, function, k + 1, state, room)
    return total


def _entry(sources: bytes) -> Callable[..., None]:
    def entry(rows: Rows, mode: int, step: float, duration: float, tangents: Reals, terms: Reals) -> None:
        sources  # noqa: B018
        for column in range(len(tangents)):
            left = duration
            while left > 0.0:
                write_terms(rows, mode, step, tangents[column], terms)
                evaluate_terms(terms, COUNT, min(left / step, 1.0), tangents[column])
                left -= step

    return kept(entry)


_compiled_entry = _entry(sources())


def carry(rows: Rows, mode: int, step: float, duration: float, tangents: Reals) -> None:
    """Multiply extended states (columns, N), in place, by the flow of a mode over a duration, s."""
    _compiled_entry(rows, mode, step, duration, tangents, np.empty(COUNT * tangents.shape[1]))
