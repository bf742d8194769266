"""A mechanism as the core asks for it: its modes, what follows its events, and what frictions at rest do."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.contact.machine.machine import Machine
from trimmer.contact.machine.statuses import ACTIONS, IMPACT, IMPULSES, KIND_COUNT
from trimmer.contact.modes.assembly import Assembler, flow_without_stick
from trimmer.contact.modes.impulses import impulse_of
from trimmer.contact.modes.joint import after_event
from trimmer.contact.modes.transitions import transition
from trimmer.contact.modes.walls import strike
from trimmer.contact.state.layout import MechanismLayout
from trimmer.hybrid.system import (
    STRUCK,
    Clockwork,
    Decision,
    EventFunction,
    JointEvent,
    ModeEquations,
    Transition,
)
from trimmer.kept_property import cached_property


@dataclass(frozen=True, eq=False)
class MechanismSystem:
    """The exact motion of a mechanism; its parts are its contacts, then its frictions, curves and walls."""

    machine: Machine  # Its arrays
    layout: MechanismLayout  # Names and places of its extended state
    clockwork: Clockwork | None = None  # What samples it; None for nothing

    @property
    def part_count(self) -> int:
        """Number of contacts, frictions, curves and walls."""
        return self.machine.first_wall + len(self.machine.restitution)

    @property
    def kind_count(self) -> int:
        """Number of kinds of events, and of what counts as none."""
        return KIND_COUNT

    @property
    def action_count(self) -> int:
        """Number of actions of event functions."""
        return ACTIONS

    @property
    def decaying_states(self) -> Integers:
        """Places of the springs behind slots, which may relax, ``NO_STATE`` for none, (m,)."""
        return self.machine.relaxing_state

    @cached_property
    def assembler(self) -> Assembler:
        """What makes its modes."""
        return Assembler(self.machine, self.layout.period or 1.0)

    @cached_property
    def scales(self) -> Reals:
        """Sizes of the gaps, m, (m,)."""
        offsets = self.machine.offsets
        widths: Reals = np.where(np.isfinite(offsets), abs(offsets), 0.0).max(axis=1, initial=0.0)
        return widths

    def mode(self, statuses: tuple[int, ...]) -> ModeEquations:
        """Return the equations of the mode with given statuses: of contacts, frictions, curves, walls."""
        return self.assembler.mode(statuses)

    def terms(self, mode: ModeEquations) -> Reals:
        """Return the moduli of what the flow of a mode is made of, (N, N): stick takes forces away."""
        return abs(flow_without_stick(self.machine, mode.statuses))

    def transition(self, mode: ModeEquations, function: EventFunction, jumped: bool) -> Transition | None:
        """Return what follows an event; None where several frictions at rest decide it together."""
        return transition(self.machine, mode.statuses, function, jumped)

    def reset(self, mode: ModeEquations, function: EventFunction) -> Reals | None:
        """Return what an impact on a wall makes of the state, (N, N); at a contact it goes on."""
        if function.action != STRUCK:
            return None
        wall = function.owner - self.machine.first_wall
        return impulse_of(self.machine, wall, self.machine.restitution[wall])

    def impulse(self, part: int, kind: int) -> tuple[Reals, Reals] | None:
        """Return what an impulse of a wall makes of the state, (N, N), and how far it is from its gap, (N,).

        None where what happened to the part was no impulse.
        """
        if kind not in IMPULSES:
            return None
        wall = part - self.machine.first_wall
        restitution = self.machine.restitution[wall] if kind == IMPACT else 0.0
        return impulse_of(self.machine, wall, restitution), -self.machine.wall_distance[wall]

    def decide(self, mode: ModeEquations, state: Reals, event: JointEvent) -> Decision:
        """Return what frictions and walls at rest do, or what follows an impact.

        See ``trimmer.contact.modes.joint.after_event`` and ``trimmer.contact.modes.walls.strike``.
        """
        if event.function.action == STRUCK:
            wall = event.function.owner - self.machine.first_wall
            # What was held until then has drifted by the rounding of a long way.
            fitted = mode.hold @ state
            return strike(self.machine, mode.statuses, fitted, wall, self.layout.period or 1.0, event.held)
        return Decision(*after_event(self.machine, mode.statuses, state, event), state)
