"""One mode of an interconnection: its flow Z' = M Z, its components' signals, and its event functions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.errors import IllPosedLoopError
from trimmer.motion.interconnection import Layout, acts, effect
from trimmer.motion.switched_component import Constrained, EventFunction, Explicit, RateProportional, Signals

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.motion.interconnection import Interconnection


DEPENDENT = 1e-10
"""Conditions on outputs that differ by less, relative to their sizes, are one."""


@dataclass(frozen=True)
class ComponentEventFunction:
    """An event function with its owner.

    Attributes:
        component: Number of the component that it belongs to.
        number: Its number among the event functions of that component.
        event_function: The event function.
    """

    component: int
    number: int
    event_function: EventFunction


@dataclass(frozen=True)
class SwitchedMode:
    """A mode, with rows and matrices over the extended state Z of n entries.

    Attributes:
        component_modes: The mode of each component.
        matrix: M of the flow Z' = M Z, n x n, 1/s.
        signals: The rows of each component.
        event_functions: The event functions of all components, one component after the other.
    """

    component_modes: tuple[int, ...]
    matrix: Reals
    signals: tuple[Signals, ...]
    event_functions: tuple[ComponentEventFunction, ...]


@dataclass(frozen=True)
class _Open:
    """The mode before its implicit outputs v are known.

    Z' = flow Z + push v, inputs = inputs Z + inputs_through v, outputs = outputs Z + outputs_through v.
    """

    flow: Reals
    push: Reals
    inputs: Reals
    inputs_through: Reals
    outputs: Reals
    outputs_through: Reals
    implicit: tuple[int, ...]


def assemble(system: Interconnection, component_modes: tuple[int, ...]) -> SwitchedMode:
    """Return the mode of an interconnection in which each component is in a given mode.

    Args:
        system: The interconnection.
        component_modes: Number of the mode of each component.

    Raises:
        IllPosedLoopError: if the outputs are not determined by the state, because too few integrators lie
            between the output of a component and its input.
    """
    layout = Layout.of(system)
    opened = _open(system, layout, component_modes)
    implicit_rows = _implicit_outputs(system, layout, component_modes, opened)
    matrix = opened.flow + opened.push @ implicit_rows
    outputs = opened.outputs + opened.outputs_through @ implicit_rows
    inputs = opened.inputs + opened.inputs_through @ implicit_rows
    signals = tuple(
        _signals(layout, matrix, inputs[k], outputs[k], k, component.state_count)
        for k, component in enumerate(system.components)
    )
    event_functions = tuple(
        ComponentEventFunction(k, number, event_function)
        for k, component in enumerate(system.components)
        for number, event_function in enumerate(
            component.event_functions(component_modes[k], signals[k], _attracting(system, signals[k], k))
        )
    )
    return SwitchedMode(component_modes, matrix, signals, event_functions)


def _open(system: Interconnection, layout: Layout, component_modes: tuple[int, ...]) -> _Open:
    """Resolve the outputs that are explicit functions of inputs and states, and put the flow together."""
    count = len(system.components)
    gains, own = np.zeros(count), np.zeros((count, layout.size))
    implicit = []
    for k, (component, mode) in enumerate(zip(system.components, component_modes, strict=True)):
        law = component.output_law(mode)
        if isinstance(law, Explicit):
            first = layout.first_states[k]
            gains[k] = law.input_gain
            own[k, first : first + len(law.state_gains)] = law.state_gains
            own[k, -1] += law.constant
        else:
            implicit.append(k)
    selection = np.eye(count)[:, implicit]
    inputs, through = _inputs(system, layout, gains, own, selection)
    outputs = gains[:, None] * inputs + own
    outputs_through = gains[:, None] * through + selection
    flow = _own_flow(system, layout, component_modes)
    flow[: layout.order] += system.B @ outputs
    push = np.zeros((layout.size, len(implicit)))
    push[: layout.order] = system.B @ outputs_through
    return _Open(flow, push, inputs, through, outputs, outputs_through, tuple(implicit))


def _inputs(
    system: Interconnection, layout: Layout, gains: Reals, own: Reals, selection: Reals
) -> tuple[Reals, Reals]:
    """Solve for the inputs, which act on each other through the direct feedthrough D of the system."""
    count = len(gains)
    undisturbed = np.zeros((count, layout.size))
    undisturbed[:, : layout.order] = system.C
    if system.drive is not None:
        undisturbed[:, layout.sine] = system.drive_gain * system.drive.amplitude
    if not system.D.any():
        return undisturbed, np.zeros((count, selection.shape[1]))
    loop = np.eye(count) - system.D * gains
    if np.linalg.matrix_rank(loop) < count:
        raise IllPosedLoopError("the direct feedthrough of the system cancels a component that is in contact")
    known = np.hstack([undisturbed + system.D @ own, system.D @ selection])
    solved = np.asarray(np.linalg.solve(loop, known), dtype=np.float64)
    return solved[:, : layout.size], solved[:, layout.size :]


def _own_flow(system: Interconnection, layout: Layout, component_modes: tuple[int, ...]) -> Reals:
    """Return the flow of plant, components and drive without their effect on each other."""
    flow = np.zeros((layout.size, layout.size))
    flow[: layout.order, : layout.order] = system.A
    for k, (component, mode) in enumerate(zip(system.components, component_modes, strict=True)):
        first, end = layout.first_states[k], layout.first_states[k] + component.state_count
        flow[first:end, first:end] = component.state_rates(mode)
    if system.drive is not None:
        flow[layout.sine, layout.sine + 1] = system.drive.omega
        flow[layout.sine + 1, layout.sine] = -system.drive.omega
    return flow


def _implicit_outputs(
    system: Interconnection, layout: Layout, component_modes: tuple[int, ...], opened: _Open
) -> Reals:
    """Solve for the outputs that follow from a condition on the rates, one row each."""
    if not opened.implicit:
        return np.zeros((0, layout.size))
    left, right = [], []
    for column, k in enumerate(opened.implicit):
        if opened.inputs_through[k].any():
            raise IllPosedLoopError(f"{system.labels[k]}: its input depends at once on its own output")
        component = system.components[k]
        law = component.output_law(component_modes[k])
        if isinstance(law, RateProportional):
            row = law.coefficient * opened.inputs[k]
            condition = -row @ opened.push
            condition[column] += 1.0
            left.append(condition)
            right.append(row @ opened.flow)
        else:
            assert isinstance(law, Constrained)
            row = component.switching_function(
                _signals(layout, opened.flow, opened.inputs[k], opened.outputs[k], k, component.state_count)
            )
            row = _differentiated(row, opened, column, system.labels[k])
            left.append(row @ opened.push)
            right.append(-row @ opened.flow)
    names = ", ".join(system.labels[k] for k in opened.implicit)
    return least_outputs(np.array(left), np.array(right), names)


def least_outputs(left: Reals, right: Reals, names: str) -> Reals:
    """Solve left @ outputs = right; where conditions repeat each other, take the smallest outputs.

    So it is where frictions between three bodies all stick, or where two act between the same bodies: the
    motion is determined, and how they share the force is not.

    Args:
        left: Factors of the m outputs in the conditions, m x m.
        right: Right sides as rows over the extended state, m x n.
        names: The components, for the error message.

    Returns:
        The outputs as rows over the extended state, m x n.

    Raises:
        IllPosedLoopError: if the conditions contradict each other.
    """
    rows = abs(left).max(axis=1, keepdims=True)
    columns = (abs(left) / rows).max(axis=0)
    scaled, wanted = left / rows / columns, right / rows
    inverse = np.linalg.pinv(scaled, rcond=DEPENDENT)
    solution = inverse @ wanted
    solution = solution + inverse @ (wanted - scaled @ solution)  # Where sizes differ widely, that counts.
    missed = abs(scaled @ solution - wanted).max(axis=1)
    if (missed > DEPENDENT * (abs(scaled) @ abs(solution) + abs(wanted)).max(axis=1)).any():
        raise IllPosedLoopError(f"the outputs of {names} are not determined by the motion")
    outputs: Reals = np.asarray(solution / columns[:, None])
    return outputs


def _differentiated(row: Reals, opened: _Open, column: int, label: str) -> Reals:
    """Differentiate a row along the flow until the output of that column acts on its rate."""
    for _ in range(opened.flow.shape[0]):
        if acts(row, opened.push[:, column]):
            return row
        row = row @ opened.flow
    raise IllPosedLoopError(f"{label}: its input stays at zero, and its output is not determined")


def _signals(layout: Layout, matrix: Reals, given: Reals, output: Reals, k: int, count: int) -> Signals:
    rate = given @ matrix
    first = layout.first_states[k]
    states = tuple(layout.unit(first + each) for each in range(count))
    return Signals(given, rate, rate @ matrix, output, states, layout.one)


def _attracting(system: Interconnection, signals: Signals, k: int) -> bool:
    """Return whether the output of a component works against the rate of its own switching function."""
    row = system.components[k].switching_function(signals)[: system.order]
    return effect(row, system.B[:, k]) < 0.0
