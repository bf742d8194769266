"""Cells of the kept maps, drawn at random and computed again in each build."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from report.numbers.twin.grids import ASIDE, displaced
from report.numbers.twin.kept_files import REMEDY
from report.numbers.twin.kept_map import LETTERS, KeptCell, KeptMap, kept_cell
from report.numbers.twin.mechanism import DAMPING, FORCE, GAP, SPEED, STIFFNESS
from trimmer import MotionKind, TrimmerError
from trimmer.maps.cells import Cell, CellWork
from trimmer.maps.inputs import MapInputs

DRAWN: Final = 30
SEED_DIGITS: Final = 8
STARTS_ASIDE: Final = 8
"""Starts beside rest that are tried where a cell differs: on another processor rounding may choose for it."""
MOST_OTHER: Final = 2
"""Cells of a draw that may come out differently from all starts, as long as they do not repeat, or did not.

Of all 6993 cells some 20 do so where rounding alone is another: long transients, and borders of chaos. Three
among 30 drawn ones then come once in 10 000 draws.
"""
WORDS: Final[Mapping[str, tuple[str, float, str]]] = {
    GAP: ("a gap of", 1e6, "µm"),
    FORCE: ("a friction of", 1.0, "N"),
    SPEED: ("a drive of", 1.0, "Hz"),
    STIFFNESS: ("a bridge of", 1e-3, "kN/m"),
    DAMPING: ("a bridge's damping of", 1.0, "N s/m"),
}


class CellDifferenceError(TrimmerError, ValueError):
    """A cell of a kept map comes out differently now; the message names the cell.

    Attributes:
        both_repeat: Whether the motion that is kept and the one that is computed now repeat.
    """

    def __init__(self, message: str, both_repeat: bool) -> None:
        super().__init__(message)
        self.both_repeat = both_repeat


@dataclass(frozen=True)
class CellCheck:
    """What was computed again."""

    seed: int  # Of the draw
    drawn: int  # Number of cells
    total: int  # Number of cells that they were drawn from
    by_rounding: int  # How many of them agreed only from a start next to rest
    cells: tuple[str, ...]  # Their names
    # The names of those that came out as something else from all starts; they do not repeat, or did not
    others: tuple[str, ...]


def seed_of(digest: str) -> int:
    """Return the seed that belongs to a digest in hexadecimal digits."""
    return int(digest[:SEED_DIGITS], 16)


def check_cells(maps: Sequence[KeptMap], seed: int, count: int = DRAWN) -> CellCheck:
    """Draw cells from all maps together, and compute them again.

    Raises:
        CellDifferenceError: naming a cell that repeats in another way than it did, or one more than
            ``MOST_OTHER`` that comes out differently.
    """
    places = [(kept, number) for kept in maps for number in range(len(kept.cells))]
    chosen = np.random.default_rng(seed).choice(len(places), count, replace=False)
    cells = [places[at] for at in sorted(chosen.tolist())]
    by_rounding, others = 0, list[str]()
    for kept, number in cells:
        try:
            by_rounding += not check_cell(kept, number)
        except CellDifferenceError as error:
            if error.both_repeat or len(others) == MOST_OTHER:
                raise
            others.append(name_of(kept, number))
    names = tuple(name_of(kept, number) for kept, number in cells)
    return CellCheck(seed, count, len(places), by_rounding, names, tuple(others))


def check_cell(kept: KeptMap, number: int) -> bool:
    """Compute a cell again; return whether rest led to what is kept.

    Where it did not, starts next to it are tried, since a long transient may depend on rounding.

    Raises:
        CellDifferenceError: if no start led to it.
    """
    then, now = kept.cells[number], None
    for start, inputs in enumerate(_starts(kept.grid.beside)):
        found = _computed(inputs, number)
        if found.agrees(then):
            return start == 0
        now = now or found
    assert now is not None
    raise CellDifferenceError(
        f"{name_of(kept, number)}: kept is {_described(then)}, but computed now is {_described(now)}; if the "
        f"program or the trimmer was changed on purpose, {REMEDY}",
        both_repeat=then.kind == now.kind == LETTERS[MotionKind.PERIODIC],
    )


def name_of(kept: KeptMap, number: int) -> str:
    """Return which cell it is, in words."""
    values = zip(kept.grid.inputs.places, kept.grid.inputs.cell_values(number), strict=True)
    told = (
        f"{words} {value * factor:g} {unit}"
        for place, value in values
        for words, factor, unit in (WORDS[place],)
    )
    return f"map {kept.grid.name}, {' and '.join(told)}"


def _starts(inputs: MapInputs) -> Iterator[MapInputs]:
    yield displaced(inputs, 0.0)
    yield from (displaced(inputs, ASIDE * number) for number in range(1, STARTS_ASIDE + 1))


def _computed(inputs: MapInputs, number: int) -> KeptCell:
    work = CellWork(inputs.mechanism, inputs.places, inputs.settings)
    return kept_cell(inputs, work(Cell(number, inputs.cell_values(number))))


def _described(cell: KeptCell) -> str:
    stroke = cell.measures[0]
    return f"{cell.words}, " + ("not measured" if stroke is None else f"stroke {stroke * 1e3:.9g} mm")
