"""All solutions of linear equations whose rank is to be found, as those for shifts that change no force.

The free unknowns are the first that can be free, so that of bodies that move alike the first one leads. What
rounding cannot tell from zero is zero: with each entry goes the sum of the moduli of what it is made of.
"""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Integers, Reals

ROUNDING = 1e-12  # A sum below this share of the moduli of its terms is zero

_RIGHT = -1
_Row = dict[int, tuple[float, float]]
"""What is not zero of an equation: factors by unknown, and the right side, each with its sum of moduli."""


@dataclass(frozen=True, eq=False)
class Solutions:
    """The solutions x = particular + directions a of E x = b, for n unknowns and any a, (s,)."""

    free: Integers  # Numbers of the unknowns that are a, (s,)
    # Null vectors of E, (n, s): of the free unknowns, each has one at 1 and the others at 0
    directions: Reals
    particular: Reals  # That solution with the free unknowns at 0, (n,)
    consistent: bool  # Whether there is a solution; else the particular one counts for nothing


def solutions(equations: Reals, right: Reals) -> Solutions:
    """Solve E x = b, (m, n) and (m,), by elimination (Gauss and Jordan), the last unknowns first."""
    count = equations.shape[1]
    pivots: dict[int, _Row] = {}
    left = [_row_of(*each) for each in zip(equations.tolist(), right.tolist(), strict=True)]
    for unknown in reversed(range(count)):
        candidates = [row for row in left if unknown in row]
        if candidates:
            chosen = max(candidates, key=lambda row: abs(row[unknown][0]))
            left.remove(chosen)
            size = chosen[unknown][0]
            pivot = {place: (value / size, moduli / abs(size)) for place, (value, moduli) in chosen.items()}
            for row in (*left, *pivots.values()):
                _clear(row, unknown, pivot)
            pivots[unknown] = pivot
    free = [unknown for unknown in range(count) if unknown not in pivots]
    directions, particular = np.zeros((count, len(free))), np.zeros(count)
    directions[free, range(len(free))] = 1.0
    nothing = (0.0, 0.0)
    for unknown, row in pivots.items():
        directions[unknown] = [0.0 - row.get(other, nothing)[0] for other in free]
        particular[unknown] = row.get(_RIGHT, nothing)[0]
    return Solutions(np.array(free, dtype=np.int64), directions, particular, not any(left))


def _row_of(equation: list[float], right: float) -> _Row:
    """Return an equation, scaled so that its largest factor is 1."""
    largest = max(map(abs, equation), default=0.0) or 1.0
    scaled = {place: value / largest for place, value in enumerate(equation)} | {_RIGHT: right / largest}
    return {place: (value, abs(value)) for place, value in scaled.items() if value}


def _clear(row: _Row, unknown: int, pivot: _Row) -> None:
    """Take as much of a pivot's equation, in which an unknown has the factor 1, as frees a row of that."""
    factor = row.pop(unknown, (0.0, 0.0))[0]
    if not factor:
        return
    for place, (value, moduli) in pivot.items():
        if place != unknown:
            old, of_old = row.get(place, (0.0, 0.0))
            new, of_new = old - factor * value, of_old + abs(factor) * moduli
            if abs(new) > ROUNDING * of_new:
                row[place] = new, of_new
            else:
                row.pop(place, None)
