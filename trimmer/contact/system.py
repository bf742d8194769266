"""A mechanism as the core asks for it: its modes, what follows its events, and what frictions at rest do."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trimmer.arrays import Integers, Places, Reals
from trimmer.contact.assembly import assemble, flow_without_stick
from trimmer.contact.curves import first_curve
from trimmer.contact.joint import after_event
from trimmer.contact.layout import Layout
from trimmer.contact.machine import Machine
from trimmer.contact.statuses import ACTIONS, CONTACT_BROKEN
from trimmer.contact.transitions import transition
from trimmer.hybrid.system import EventFunction, Mode, Transition


@dataclass(frozen=True, eq=False)
class MechanismSystem:
    """The exact motion of a mechanism; its parts are its contacts, then its frictions, then its curves.

    Attributes:
        machine: Its arrays.
        layout: Names and places of its extended state.
    """

    machine: Machine
    layout: Layout

    @property
    def contact_count(self) -> int:
        """Number m of contacts."""
        return len(self.machine.stiffness)

    @property
    def part_count(self) -> int:
        """Number of contacts, frictions and curves."""
        return first_curve(self.machine) + len(self.machine.curve_over)

    @property
    def kind_count(self) -> int:
        """Number of kinds of events, and of what counts as none."""
        return CONTACT_BROKEN + 1

    @property
    def action_count(self) -> int:
        """Number of actions of event functions."""
        return ACTIONS

    @property
    def decaying_states(self) -> Integers:
        """Places of the springs behind slots, which may relax, ``NO_STATE`` for none, (m,)."""
        return self.machine.relaxing_state

    @cached_property
    def scales(self) -> Reals:
        """Sizes of the gaps, m, (m,)."""
        offsets = self.machine.offsets
        widths: Reals = np.where(np.isfinite(offsets), abs(offsets), 0.0).max(axis=1, initial=0.0)
        return widths

    def mode(self, statuses: tuple[int, ...]) -> Mode:
        """Return the equations of the mode with given statuses: of contacts, frictions, curves."""
        return assemble(self.machine, statuses)

    def terms(self, mode: Mode) -> Reals:
        """Return the moduli of what the flow of a mode is made of, (N, N): stick takes forces away."""
        return abs(flow_without_stick(self.machine, mode.statuses))

    def transition(self, mode: Mode, function: EventFunction, jumped: bool) -> Transition | None:
        """Return what follows an event; None where several frictions at rest decide it together."""
        return transition(self.machine, mode.statuses, function, jumped)

    def reset(self, mode: Mode, function: EventFunction) -> None:
        """Return nothing: contacts have springs, so that the state is continuous."""

    def decide(
        self, mode: Mode, state: Reals, function: EventFunction, jumped: bool, at_rest: Places
    ) -> tuple[tuple[int, ...], int, Reals]:
        """Return what frictions at rest do: see ``trimmer.contact.joint.after_event``."""
        frictions = at_rest - self.contact_count
        return *after_event(self.machine, mode.statuses, state, function, jumped, frictions), state
