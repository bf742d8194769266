"""Which maps and branches of the twin are kept, and from what they are made."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Final

import numpy as np

from report.numbers.twin.mechanism import CUTTER, DAMPING, FORCE, GAP, SPEED, STIFFNESS, STROKE, twin
from trimmer import Mechanism, TrimmerLoop
from trimmer.maps.inputs import MapInputs, Settings, checked_inputs

WAITED: Final = 300  # Drive periods to wait at most in a cell
ASIDE: Final = 1e-9
"""Displacement of the cutter at the start of the second motion of a cell, m. No measurement could tell it
from rest, so what it changes is not known of rest either."""


@dataclass(frozen=True)
class Grid:
    """A map that is kept."""

    name: str  # Of its file
    mechanism: Mechanism  # What is varied
    # First, last and number of values, in SI units, by their places
    values: Mapping[str, tuple[float, float, int]]
    starts: int = 1  # Starts of each cell; those after rest are random
    # How long each cell is looked at
    settings: Settings = field(default_factory=lambda: Settings(most_periods=WAITED))

    @cached_property
    def inputs(self) -> MapInputs:
        """All that its cells depend on."""
        spaced = {place: np.linspace(*spacing) for place, spacing in self.values.items()}
        return checked_inputs(self.mechanism, spaced, replace(self.settings, starts=self.starts))

    @cached_property
    def beside(self) -> MapInputs:
        """The same from one start next to rest, for what depends on rounding."""
        return displaced(replace(self.inputs, settings=self.settings), ASIDE)


def displaced(inputs: MapInputs, distance: float) -> MapInputs:
    """Return the inputs with the cutter beside rest at the start, m."""
    mechanism = replace(inputs.mechanism, start={CUTTER: (distance, 0.0)})
    return replace(inputs, subject=mechanism)


GAPS: Final = (0.0, 500e-6, 51)
FRICTION_MAP: Final = Grid("gap-friction", twin(), {GAP: GAPS, FORCE: (0.0, 4.0, 41)})
SPEED_MAP: Final = Grid("gap-speed", twin(), {GAP: GAPS, SPEED: (60.0, 200.0, 71)})
FEW_GAPS: Final = (0.0, 500e-6, 21)
STIFFNESS_MAP: Final = Grid("gap-stiffness", twin(), {GAP: FEW_GAPS, STIFFNESS: (2.5e3, 60e3, 24)})
DAMPING_MAP: Final = Grid("gap-damping", twin(), {GAP: FEW_GAPS, DAMPING: (0.2, 4.0, 20)})
STARTS_MAP: Final = Grid("starts", twin(), {GAP: FEW_GAPS, FORCE: (0.0, 4.0, 17)}, starts=8)
GRIDS: Final = (FRICTION_MAP, SPEED_MAP, STIFFNESS_MAP, DAMPING_MAP, STARTS_MAP)


@dataclass(frozen=True)
class KeptCourse:
    """A branch that is kept: by itself from what the twin settles to from rest at its start."""

    name: str  # Of the branch
    subject: Mechanism | TrimmerLoop  # What is varied
    place: str  # The number that is varied
    start: float  # First value, SI units
    stop: float  # The end of the interval towards which it goes
    bounds: tuple[float, float]  # The interval
    output: str = STROKE  # The output whose stroke is kept
    largest_step: float = 0.01  # See ``FollowSettings``


BRANCH_FORCE: Final = 2.0  # Friction of the branches, N
WIDEST: Final = 300e-6
NARROWEST: Final = 20e-6  # Ends of the interval of the branches, m
BRANCH_GAP: Final = 200e-6
"""Gap at which the motion of three drive periods is known, m: that of the experiment."""
_rubbing = twin(force=BRANCH_FORCE)
COURSES: Final = (
    KeptCourse("drive period", _rubbing, GAP, NARROWEST, WIDEST, (NARROWEST, WIDEST)),
    KeptCourse("three periods", _rubbing, GAP, BRANCH_GAP, WIDEST, (NARROWEST, WIDEST)),
)
