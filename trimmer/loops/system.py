"""A loop as the core asks for it: its modes, what follows its events, and what relays at rest do."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.system import (
    AT_LIMIT,
    HOLD_BEGUN,
    HOLD_ENDED,
    JOINTLY,
    OWN_ACTIONS,
    OWN_KINDS,
    REVERSED,
    Decision,
    EventFunction,
    JointEvent,
    ModeEquations,
    Transition,
)
from trimmer.hybrid.tables import Modes
from trimmer.loops.components.relay_component import HELD
from trimmer.loops.components.switched_component import EventKind
from trimmer.loops.frictions.complementarity import complementary_mode
from trimmer.loops.frictions.coupled_relays import CoupledRelays, attracting
from trimmer.loops.interconnection import Interconnection, StateLayout
from trimmer.loops.mode import FUNCTIONS_OF_COMPONENT, ComponentChange, LoopFunction, LoopMode, assemble

FURTHER = (EventKind.IMPACT, EventKind.SEPARATION, EventKind.CORNER, EventKind.REST)
KINDS: Mapping[EventKind, int] = {
    EventKind.STICK: HOLD_BEGUN,
    EventKind.SLIP: HOLD_ENDED,
    EventKind.SWITCH: REVERSED,
    **{kind: number for number, kind in enumerate(FURTHER, OWN_KINDS)},
}
"""What each kind of event counts as."""


@dataclass(frozen=True, eq=False)
class LoopSystem:
    """The exact motion of a loop; its parts are its components, their modes its statuses."""

    interconnection: Interconnection
    _assembled: dict[tuple[int, ...], LoopMode] = field(default_factory=dict, init=False, repr=False)

    kind_count = OWN_KINDS + len(FURTHER)  # Number of kinds of events, and of what counts as none
    action_count = OWN_ACTIONS + FUNCTIONS_OF_COMPONENT
    """Number of actions that event functions of one component can have."""
    decaying_states = np.zeros(0, dtype=np.int64)  # No state decays by itself
    scales = np.zeros(0)  # Nor has one a size below which it is negligible

    @property
    def clockwork(self) -> None:
        """Nothing samples a loop."""

    @cached_property
    def layout(self) -> StateLayout:
        """Positions of plant, components and drive in the extended state."""
        return StateLayout.of(self.interconnection)

    @cached_property
    def coupled(self) -> CoupledRelays:
        """The relays that depend on each other."""
        return CoupledRelays.of(self.interconnection)

    @property
    def part_count(self) -> int:
        """Number of components."""
        return len(self.interconnection.components)

    def mode(self, statuses: tuple[int, ...]) -> LoopMode:
        """Return the mode in which each component is in a given mode, assembled on first use."""
        if statuses not in self._assembled:
            self._assembled[statuses] = assemble(self.interconnection, statuses, self.coupled)
        return self._assembled[statuses]

    def terms(self, mode: ModeEquations) -> Reals:
        """Return the moduli of the flow of a mode, (N, N)."""
        return abs(mode.flow)

    def transition(self, mode: ModeEquations, function: EventFunction, jumped: bool) -> Transition | None:
        """Return what follows an event; None where several relays begin to slide together."""
        assert isinstance(mode, LoopMode)
        assert isinstance(function, LoopFunction)
        changes = function.jumped if jumped else function.reached
        if function.owner == JOINTLY or (len(mode.held) > 1 and self._dropping(function)):
            return None
        after = _with(mode.statuses, changes)
        first = changes[0].transition
        actions = self.mode(after).actions(function.owner)
        zeros = tuple((action, count) for action, count in zip(actions, first.zeros, strict=False) if count)
        return Transition(after, KINDS[first.kind], zeros, self.reset(mode, function))

    def reset(self, mode: ModeEquations, function: EventFunction) -> Reals | None:
        """Return what an event makes of the state, (N, N), None for nothing; what is held is at rest then."""
        assert isinstance(function, LoopFunction)
        reset = self.of_states(function)
        if mode.held:
            reset = reset @ mode.hold
        return None if (reset == np.eye(len(reset))).all() else reset

    def impulse(self, part: int, kind: int) -> None:
        """Return nothing: no component of a loop has an impulse that is decided."""

    def of_states(self, function: LoopFunction) -> Reals:
        """Return what an event makes of the states of its components, (N, N)."""
        reset = np.eye(self.layout.size)
        for change in function.reached:
            first = self.layout.first_states[change.component]
            for each, row in enumerate(change.transition.resets):
                reset[first + each] = row
        return reset

    def decide(self, mode: ModeEquations, state: Reals, event: JointEvent) -> Decision:
        """Return what relays at rest do, one after the other where their influence is not symmetric."""
        resting = list(mode.statuses)
        for k in event.at_rest.tolist():
            resting[k] = HELD
        closed = self.coupled.closed(tuple(resting))
        relays = tuple(
            k for k, one in enumerate(closed) if one == HELD and attracting(self.interconnection, k)
        )
        state = self.mode(closed).hold @ state
        assert isinstance(event.function, LoopFunction)
        dropping, after = self._dropping(event.function), None
        if event.jumped or not dropping:
            after = complementary_mode(self, mode.statuses, state, relays, event.held)
        if dropping and (not event.jumped or after == mode.statuses):
            after = complementary_mode(self, mode.statuses, state, relays, event.held, dropping)
        if after is None or (dropping and after == mode.statuses):
            # The limit decides where the influence is not symmetric, and where the drop is rounding.
            after = _with(mode.statuses, event.function.jumped if event.jumped else event.function.reached)
        return Decision(after, 1, state)

    def _dropping(self, function: LoopFunction) -> tuple[int, ...]:
        """Return the frictions whose output falls where the limit of what they hold is reached."""
        if function.action != AT_LIMIT:
            return ()
        changed, components = {each.component for each in function.reached}, self.interconnection.components
        return tuple(k for k in sorted(changed) if components[k].drops)


def _with(statuses: tuple[int, ...], changes: tuple[ComponentChange, ...]) -> tuple[int, ...]:
    targets = {change.component: change.transition.target for change in changes}
    return tuple(targets.get(k, before) for k, before in enumerate(statuses))


class LoopModes(Modes[LoopSystem]):
    """The modes of a loop by number; they are few."""

    may_be_sparse = False

    def __getitem__(self, number: int) -> LoopMode:
        mode = super().__getitem__(number)
        assert isinstance(mode, LoopMode)
        return mode
