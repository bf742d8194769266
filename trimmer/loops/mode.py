"""One mode of an interconnection: its flow Z' = M Z, its components' signals, event functions and hold."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.system import ARRIVED, AT_LIMIT, JOINTLY, OWN_ACTIONS, EventFunction, ModeEquations
from trimmer.loops.components.relay_component import HELD, RelayComponent
from trimmer.loops.components.switched_component import Constrained, Explicit, ModeChange, Signals
from trimmer.loops.frictions.coupled_relays import CoupledRelays, attracting
from trimmer.loops.frictions.stick import projection
from trimmer.loops.implicit_outputs import OpenMode, component_signals, implicit_outputs, without_rounding
from trimmer.loops.interconnection import NEGLIGIBLE, Interconnection, StateLayout, effect

FUNCTIONS_OF_COMPONENT = 3  # No component by itself has more event functions in a mode


@dataclass(frozen=True)
class ComponentChange:
    """A component, and what it does at an event."""

    component: int
    transition: ModeChange


@dataclass(frozen=True, eq=False)
class LoopFunction(EventFunction):
    """An event function: all that changes when it falls to zero, or when it is negative at once."""

    reached: tuple[ComponentChange, ...] = ()
    jumped: tuple[ComponentChange, ...] = ()


@dataclass(frozen=True, eq=False)
class LoopMode(ModeEquations):
    """A mode: event functions of all components, then of the coupled ones together, and their signals."""

    functions: tuple[LoopFunction, ...]
    signals: tuple[Signals, ...]

    def actions(self, component: int) -> tuple[int, ...]:
        """Return what it means that the event functions of a component fall to zero, in their order."""
        return tuple(function.action for function in self.functions if function.owner == component)


def assemble(system: Interconnection, component_modes: tuple[int, ...], coupled: CoupledRelays) -> LoopMode:
    """Return the mode of an interconnection in which each component is in a given mode.

    An ``IllPosedLoopError`` says that too few integrators lie between the output of a component and its
    input.
    """
    layout = StateLayout.of(system)
    opened = _open(system, layout, component_modes)
    implicit_rows = implicit_outputs(system, layout, component_modes, opened)
    matrix, sizes = opened.flow + opened.push @ implicit_rows, np.zeros_like(opened.flow)
    if opened.holds:
        sizes = abs(opened.flow) + abs(opened.push) @ abs(implicit_rows)
        matrix = without_rounding(matrix, sizes)
    outputs = opened.outputs + opened.selection @ implicit_rows
    signals = tuple(
        component_signals(layout, (matrix, sizes), opened.inputs[k], outputs[k], k, component.state_count)
        for k, component in enumerate(system.components)
    )
    if opened.holds:
        signals = _with_those_at_rest(system, component_modes, signals)
    held = tuple(k for k, mode in enumerate(component_modes) if attracting(system, k) and mode == HELD)
    mode = LoopMode(
        component_modes,
        matrix,
        (),
        _at_rest(system, signals, held),
        held,
        settled=component_modes,
        decay=np.zeros(0),
        decayed=(),
        signals=signals,
    )
    functions = (*_of_components(system, mode, coupled), *_of_coupled(system, mode, coupled, layout))
    return replace(mode, functions=functions)


def _at_rest(system: Interconnection, signals: tuple[Signals, ...], held: tuple[int, ...]) -> Reals:
    """Return the matrix, n x n, that makes exactly zero what is held."""
    size = len(signals[0].one)
    if not held:
        return np.eye(size)
    rows = [system.components[k].switching_function(signals[k]) for k in held]
    pushes = np.zeros((size, len(held)))
    pushes[: system.order] = system.B[:, held]
    return projection(np.array(rows), pushes)


def _with_those_at_rest(
    system: Interconnection, component_modes: tuple[int, ...], signals: tuple[Signals, ...]
) -> tuple[Signals, ...]:
    """Make the rates zero that follow from switching functions held at zero, which are rounding otherwise."""
    each = zip(system.components, component_modes, signals, strict=True)
    held = np.array(
        [c.switching_function(s) for c, mode, s in each if isinstance(c.output_law(mode), Constrained)]
    )
    onto = np.linalg.pinv(held) @ held
    nothing = np.zeros_like(signals[0].one)
    return tuple(
        replace(s, input_rate=nothing, input_curvature=nothing)
        if not isinstance(c.output_law(mode), Constrained)
        and (abs(s.input_rate - s.input_rate @ onto) <= NEGLIGIBLE * abs(s.input_rate).max()).all()
        else s
        for c, mode, s in zip(system.components, component_modes, signals, strict=True)
    )


def _of_components(system: Interconnection, mode: LoopMode, coupled: CoupledRelays) -> Iterator[LoopFunction]:
    """Yield the event functions that belong to one component."""
    for k, component in enumerate(system.components):
        held = k in mode.held
        if held and k in coupled.members:
            continue
        signals = mode.signals[k]
        switching = component.switching_function(signals)[: system.order]
        works_against = effect(switching, system.B[:, k]) < 0.0
        found = component.event_functions(mode.statuses[k], signals, works_against)
        can_be_held = attracting(system, k)
        for number, each in enumerate(found):
            reached, jumped = (
                _with_those_that_follow(mode.statuses, k, transition, coupled)
                for transition in (each.reached, each.jumped)
            )
            action = (AT_LIMIT if held else ARRIVED) if can_be_held else OWN_ACTIONS + number
            signs = (1 - 2 * number,) if held else ()
            yield LoopFunction(k, action, each.row, signs, each.continuous, reached, jumped)


def _with_those_that_follow(
    component_modes: tuple[int, ...], k: int, transition: ModeChange, coupled: CoupledRelays
) -> tuple[ComponentChange, ...]:
    """Return the change of a component, with those that are held from then on because it is."""
    changes = [ComponentChange(k, transition)]
    if k in coupled.members and transition.target == HELD:
        before = [HELD if each == k else mode for each, mode in enumerate(component_modes)]
        after = coupled.closed(tuple(before))
        changes += [ComponentChange(j, transition) for j in coupled.members if after[j] != before[j]]
    return tuple(changes)


def _of_coupled(
    system: Interconnection, mode: LoopMode, coupled: CoupledRelays, layout: StateLayout
) -> Iterator[LoopFunction]:
    """Yield the distances of what coupled relays hold from what they can hold at most."""
    outputs = np.array([mode.signals[k].output for k in coupled.members])
    for vector, bound in coupled.facets(mode.statuses):
        sliding = [(coupled.members[each], vector[each]) for each in np.flatnonzero(vector)]
        slips = [(k, _slip(system, k, float(sign))) for k, sign in sliding]
        reached, jumped = (
            tuple(ComponentChange(k, slip[flavour]) for k, slip in slips) for flavour in (0, 1)
        )
        row = without_rounding(
            bound * layout.one - vector @ outputs, bound * layout.one + abs(vector) @ abs(outputs)
        )
        signs = tuple(np.sign(vector).astype(int).tolist())
        yield LoopFunction(JOINTLY, AT_LIMIT, row, signs, 0, reached, jumped)


def _slip(system: Interconnection, k: int, sign: float) -> tuple[ModeChange, ModeChange]:
    component = system.components[k]
    assert isinstance(component, RelayComponent)
    return component.slip(sign > 0)


def _open(system: Interconnection, layout: StateLayout, component_modes: tuple[int, ...]) -> OpenMode:
    """Resolve the outputs that are explicit functions of inputs and states, and put the flow together."""
    count = len(system.components)
    gains, own = np.zeros(count), np.zeros((count, layout.size))
    implicit, holds = [], False
    for k, (component, mode) in enumerate(zip(system.components, component_modes, strict=True)):
        law = component.output_law(mode)
        if isinstance(law, Explicit):
            first = layout.first_states[k]
            gains[k] = law.input_gain
            own[k, first : first + len(law.state_gains)] = law.state_gains
            own[k, -1] += law.constant
        else:
            implicit.append(k)
            holds = holds or isinstance(law, Constrained)
    selection = np.eye(count)[:, implicit]
    inputs = _inputs(system, layout)
    outputs = gains[:, None] * inputs + own
    flow = _own_flow(system, layout, component_modes)
    flow[: layout.order] += system.B @ outputs
    push = np.zeros((layout.size, len(implicit)))
    push[: layout.order] = system.B @ selection
    return OpenMode(flow, push, inputs, outputs, selection, tuple(implicit), holds)


def _inputs(system: Interconnection, layout: StateLayout) -> Reals:
    """Return the inputs, on which no output acts at once."""
    inputs = np.zeros((len(system.components), layout.size))
    inputs[:, : layout.order] = system.C
    for number, drive in enumerate(system.drives):
        inputs[:, layout.sine + 2 * number] = system.drive_gain[:, number] * drive.amplitude
    return inputs


def _own_flow(system: Interconnection, layout: StateLayout, component_modes: tuple[int, ...]) -> Reals:
    """Return the flow of plant, components and drive without the elements."""
    flow = np.zeros((layout.size, layout.size))
    flow[: layout.order, : layout.order] = system.A
    for k, (component, mode) in enumerate(zip(system.components, component_modes, strict=True)):
        first, end = layout.first_states[k], layout.first_states[k] + component.state_count
        flow[first:end, first:end] = component.state_rates(mode)
    for number, (drive, omega) in enumerate(zip(system.drives, layout.omegas, strict=True)):
        sine = layout.sine + 2 * number
        flow[: layout.order, sine] = system.drive_push[:, number] * drive.amplitude
        flow[sine, sine + 1], flow[sine + 1, sine] = omega, -omega
    return flow
