"""Tables of the modes of an interconnection, filled as the motion visits them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.errors import UnsupportedMotionError
from trimmer.hybrid.taylor import (
    DEGREE,
    LEVELS,
    StepSeries,
    along,
    bernstein_from_taylor,
    step_series,
    sufficient_terms,
)
from trimmer.motion.frictions.coupled_relays import CoupledRelays, attracting
from trimmer.motion.frictions.stick import projection
from trimmer.motion.interconnection import Layout
from trimmer.motion.mode import Change, ModeEventFunction, SwitchedMode, assemble
from trimmer.motion.relay_component import HELD, RelayComponent
from trimmer.motion.tables import Tables

if TYPE_CHECKING:
    from trimmer.arrays import Integers, Reals
    from trimmer.motion.interconnection import Interconnection


EVENTS_OF_COMPONENT = 3
"""No component by itself has more event functions in a mode."""
MOST_MODES = 4 * 3**6
"""Largest number of modes of a loop: those of a backlash and six frictions."""
FORCING = 3
"""Entries that end the extended state and that no other forces: sine and cosine of the drive, and one."""
UNKNOWN = -1
"""In place of a number of known zeros: a change tells nothing about this event function."""


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

    @cached_property
    def coupled(self) -> CoupledRelays:
        """The relays that depend on each other."""
        return CoupledRelays.of(self.system)

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
            self._modes[number] = assemble(self.system, self.component_modes(number), self.coupled)
        return self._modes[number]

    @cached_property
    def tables(self) -> Tables:
        """Tables of all modes, which ``tabulate`` fills mode by mode."""
        modes, size = int(np.prod(self.shape)), self.layout.size
        coupled = self.coupled
        alone = len(self.system.components) - len(coupled.members)
        event_functions = EVENTS_OF_COMPONENT * alone + coupled.most_event_functions
        of_one = max(EVENTS_OF_COMPONENT, len(coupled.members) + 1)
        return Tables(
            known=np.zeros(modes, dtype=np.bool_),
            step=np.empty(modes),
            whole=np.empty((modes, size, size)),
            series=np.empty((modes, size, (DEGREE + 1) * size)),
            terms=np.empty((modes, LEVELS), dtype=np.int64),
            bernstein=np.empty((modes, event_functions, size, DEGREE + 1)),
            taylor=np.empty((modes, event_functions, size, DEGREE + 1)),
            sizes=np.empty((modes, event_functions, size, DEGREE + 1)),
            event_rows=np.empty((modes, event_functions, size)),
            event_count=np.empty(modes, dtype=np.int64),
            component=np.empty((modes, event_functions), dtype=np.int64),
            target=np.empty((modes, event_functions, 2), dtype=np.int64),
            reset=np.empty((modes, event_functions, size, size)),
            zeros=np.empty((modes, event_functions, 2, of_one), dtype=np.int64),
            continuous=np.empty((modes, event_functions), dtype=np.int64),
            number=np.empty((modes, event_functions), dtype=np.int64),
            relay=np.full((modes, event_functions), -1, dtype=np.int64),
            held=np.empty((modes, len(self.system.components)), dtype=np.bool_),
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
            tables.event_rows[number, place] = entry.row
            tables.taylor[number, place] = along(entry.row, series)
            tables.bernstein[number, place] = tables.taylor[number, place] @ bernstein_from_taylor()[0]
            tables.sizes[number, place] = along(abs(entry.row), moduli)
            self._tabulate_guard(number, place, mode, entry)
        tables.held[number] = [
            self._is_relay(k) and one == HELD for k, one in enumerate(mode.component_modes)
        ]
        tables.known[number] = True

    def _tabulate_guard(self, number: int, place: int, mode: SwitchedMode, entry: ModeEventFunction) -> None:
        tables = self.tables
        tables.component[number, place] = entry.owner
        tables.number[number, place] = entry.number
        tables.continuous[number, place] = entry.continuous
        first_changed = entry.reached[0].component
        if self._is_relay(first_changed) and mode.component_modes[first_changed] != HELD:
            tables.relay[number, place] = first_changed
        reset = np.eye(self.layout.size)
        for change in entry.reached:
            first = self.layout.first_states[change.component]
            for each, row in enumerate(change.transition.resets):
                reset[first + each] = row
        targets = {change.component: change.transition.target for change in entry.reached}
        later = tuple(targets.get(k, before) for k, before in enumerate(mode.component_modes))
        tables.reset[number, place] = (reset @ self.at_rest(mode, later)).T
        for flavour, changes in enumerate((entry.reached, entry.jumped)):
            after = list(mode.component_modes)
            for change in changes:
                after[change.component] = change.transition.target
            tables.target[number, place, flavour] = self.number(tuple(after))
            tables.zeros[number, place, flavour] = self._known_zeros(changes)

    def at_rest(self, mode: SwitchedMode, after: tuple[int, ...]) -> Reals:
        """Return the matrix, n x n, that makes exactly zero what is held in a mode, or after it.

        Args:
            mode: The mode.
            after: The modes of the components afterwards.
        """
        held = [
            k
            for k, both in enumerate(zip(mode.component_modes, after, strict=True))
            if self._is_relay(k) and HELD in both and attracting(self.system, k)
        ]
        size = self.layout.size
        if not held:
            return np.eye(size)
        rows = [self.system.components[k].switching_function(mode.signals[k]) for k in held]
        pushes = np.zeros((size, len(held)))
        pushes[: self.layout.order] = self.system.B[:, held]
        return projection(np.array(rows), pushes)

    def _is_relay(self, k: int) -> bool:
        return isinstance(self.system.components[k], RelayComponent)

    def _known_zeros(self, changes: tuple[Change, ...]) -> Integers:
        """Return the known zeros of the event functions of an owner after a change, by their numbers."""
        known = np.zeros(self.tables.zeros.shape[-1], dtype=np.int64)
        members = self.coupled.members
        if changes[0].component not in members:
            zeros = changes[0].transition.zeros
            known[: len(zeros)] = zeros
            return known
        known[:] = UNKNOWN
        for change in changes:
            if change.transition.target != HELD:
                (known[members.index(change.component)],) = change.transition.zeros
        return known
