"""How closely a design is looked at."""

from __future__ import annotations

from dataclasses import dataclass, replace

from trimmer.arguments import whole_number


@dataclass(frozen=True)
class DesignSettings:
    """How closely a design is looked at.

    Attributes:
        starts: Starts from which the motions are looked for; the first is rest, or the file's own start.
        seed: Of the random ones.
        most_periods: Drive periods to wait for each to settle.
        cells: Cells along each side of a map.
        cell_periods: Drive periods to wait in each cell.
        neighbours: How many neighbours there are along each of two numbers, the working point included; odd,
            or a ValueError is raised.
        trials: Values of a number that are tried to each side, to meet a target that is missed.
        machines: Machines of a series that are looked at, if numbers scatter.
        remedy_starts: Starts from which a change is tried that meets the targets.
        most_points: Orbits of each branch, at most.
        grid: Steps of each number that sliders move.
        range_points: Points at which a range is looked at, if there is one; for several see ``ranges``.
    """

    starts: int = 12
    seed: int = 0
    most_periods: int = 1000
    cells: int = 24
    cell_periods: int = 300
    neighbours: int = 7
    trials: int = 8
    machines: int = 64
    remedy_starts: int = 4
    most_points: int = 300
    grid: int = 8
    range_points: int = 17

    def __post_init__(self) -> None:
        if whole_number("neighbours", self.neighbours, least=1) % 2 == 0:
            reason = "must be odd, as the file's own value is the middle one, not"
            raise ValueError(f"neighbours {reason} {self.neighbours}; {self.neighbours + 1} would do")

    @property
    def without_cells(self) -> DesignSettings:
        """The same whatever the maps' cells are, as what is no map stays as it is if maps are refined."""
        return replace(self, cells=0)


USUAL = DesignSettings()
FULL_CELLS = 96  # Cells along each side of a refined map
