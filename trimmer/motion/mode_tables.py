"""Tables of the modes of an interconnection, filled as the motion visits them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.errors import UnsupportedMotionError
from trimmer.motion.interconnection import Layout
from trimmer.motion.mode import ComponentEventFunction, SwitchedMode, assemble
from trimmer.motion.tables import Tables
from trimmer.motion.taylor import (
    DEGREE,
    LEVELS,
    StepSeries,
    along,
    bernstein_from_taylor,
    step_series,
    sufficient_terms,
)

if TYPE_CHECKING:
    from trimmer.motion.interconnection import Interconnection


EVENTS_OF_COMPONENT = 3
"""No component has more event functions in a mode."""
MOST_MODES = 4 * 3**6
"""Largest number of modes of a loop: those of a backlash and six frictions."""
FORCING = 3
"""Entries that end the extended state and that no other forces: sine and cosine of the drive, and one."""


@dataclass(frozen=True, eq=False)
class ModeTables:
    """The modes of an interconnection by number, and their tables for the kernel.

    The tables are a cache: they are filled mode by mode as the motion asks for them.

    Attributes:
        system: The interconnection.

    Raises:
        UnsupportedMotionError: if there are more than ``MOST_MODES`` modes.
    """

    system: Interconnection
    _modes: dict[int, SwitchedMode] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        if np.prod(self.shape, dtype=float) > MOST_MODES:
            raise UnsupportedMotionError(
                f"{len(self.system.components)} components have more than {MOST_MODES} modes together"
            )

    @cached_property
    def layout(self) -> Layout:
        """Positions of plant, components and drive in the extended state."""
        return Layout.of(self.system)

    @cached_property
    def shape(self) -> tuple[int, ...]:
        """Number of modes of each component."""
        return tuple(len(component.mode_names) for component in self.system.components)

    def number(self, component_modes: tuple[int, ...]) -> int:
        """Return the number of the mode in which each component is in a given mode."""
        return int(np.ravel_multi_index(component_modes, self.shape))

    def component_modes(self, number: int) -> tuple[int, ...]:
        """Return the mode of each component in the mode of a given number."""
        return tuple(int(mode) for mode in np.unravel_index(number, self.shape))

    def mode(self, number: int) -> SwitchedMode:
        """Return the mode of a given number, assembled on first use.

        Raises:
            IllPosedLoopError: see ``assemble``.
        """
        if number not in self._modes:
            self._modes[number] = assemble(self.system, self.component_modes(number))
        return self._modes[number]

    @cached_property
    def tables(self) -> Tables:
        """Tables of all modes, which ``tabulate`` fills mode by mode."""
        modes, size = int(np.prod(self.shape)), self.layout.size
        event_functions = EVENTS_OF_COMPONENT * len(self.system.components)
        return Tables(
            known=np.zeros(modes, dtype=np.bool_),
            step=np.zeros(modes),
            whole=np.empty((modes, size, size)),
            series=np.empty((modes, size, (DEGREE + 1) * size)),
            terms=np.zeros((modes, LEVELS), dtype=np.int64),
            bernstein=np.zeros((modes, event_functions, size, DEGREE + 1)),
            taylor=np.zeros((modes, event_functions, size, DEGREE + 1)),
            sizes=np.zeros((modes, event_functions, size, DEGREE + 1)),
            event_rows=np.zeros((modes, event_functions, size)),
            event_count=np.zeros(modes, dtype=np.int64),
            component=np.zeros((modes, event_functions), dtype=np.int64),
            target=np.zeros((modes, event_functions, 2), dtype=np.int64),
            reset=np.zeros((modes, event_functions, size, size)),
            zeros=np.zeros((modes, event_functions, 2, EVENTS_OF_COMPONENT), dtype=np.int64),
            continuous=np.zeros((modes, event_functions), dtype=np.int64),
            number=np.zeros((modes, event_functions), dtype=np.int64),
            bernstein_from_taylor=bernstein_from_taylor(),
        )

    def tabulate(self, number: int) -> None:
        """Fill the tables of the mode of a given number.

        Raises:
            IllPosedLoopError: see ``assemble``.
        """
        mode, tables, size = self.mode(number), self.tables, self.layout.size
        series = step_series(mode.matrix, FORCING)
        tables.step[number] = series.step
        tables.whole[number] = series.whole.T
        tables.series[number] = series.terms.transpose(2, 0, 1).reshape(size, -1)
        moduli = StepSeries(series.step, abs(series.terms))
        tables.terms[number] = sufficient_terms(series)
        tables.event_count[number] = len(mode.event_functions)
        for place, entry in enumerate(mode.event_functions):
            tables.event_rows[number, place] = entry.event_function.row
            tables.taylor[number, place] = along(entry.event_function.row, series)
            tables.bernstein[number, place] = tables.taylor[number, place] @ bernstein_from_taylor()[0]
            tables.sizes[number, place] = along(abs(entry.event_function.row), moduli)
            self._tabulate_guard(number, place, mode, entry)
        tables.known[number] = True

    def _tabulate_guard(
        self, number: int, place: int, mode: SwitchedMode, entry: ComponentEventFunction
    ) -> None:
        tables = self.tables
        tables.component[number, place] = entry.component
        tables.number[number, place] = entry.number
        tables.continuous[number, place] = entry.event_function.continuous
        reset = np.eye(self.layout.size)
        first = self.layout.first_states[entry.component]
        for each, row in enumerate(entry.event_function.reached.resets):
            reset[first + each] = row
        tables.reset[number, place] = reset.T
        for flavour, transition in enumerate((entry.event_function.reached, entry.event_function.jumped)):
            after = list(mode.component_modes)
            after[entry.component] = transition.target
            tables.target[number, place, flavour] = self.number(tuple(after))
            tables.zeros[number, place, flavour, : len(transition.zeros)] = transition.zeros
