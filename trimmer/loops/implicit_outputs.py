"""The implicit outputs of a mode, such as forces that hold: they follow from conditions on the rates."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.errors import IllPosedLoopError
from trimmer.loops.components.switched_component import Constrained, RateProportional, Signals
from trimmer.loops.interconnection import NEGLIGIBLE, Interconnection, StateLayout, acts

DEPENDENT = 1e-10  # Conditions on outputs that differ by less, relative to their sizes, are one


@dataclass(frozen=True)
class OpenMode:
    """The mode before its implicit outputs v are known.

    Z' = flow Z + push v, inputs = inputs Z, outputs = outputs Z + selection v; implicit: which
    components v belongs to, holds: whether a constraint is among them.
    """

    flow: Reals
    push: Reals
    inputs: Reals
    outputs: Reals
    selection: Reals
    implicit: tuple[int, ...]
    holds: bool


def implicit_outputs(
    system: Interconnection, layout: StateLayout, component_modes: tuple[int, ...], opened: OpenMode
) -> Reals:
    """Solve for the outputs that follow from a condition on the rates, one row each."""
    if not opened.implicit:
        return np.zeros((0, layout.size))
    left, right, sizes = [], [], []
    flow = opened.flow, np.zeros_like(opened.flow)
    for column, k in enumerate(opened.implicit):
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
                component_signals(layout, flow, opened.inputs[k], opened.outputs[k], k, component.state_count)
            )
            row = _differentiated(row, opened, column, system.labels[k])
            left.append(row @ opened.push)
            right.append(-row @ opened.flow)
        sizes.append(abs(row) @ abs(opened.flow) if opened.holds else np.zeros(layout.size))
    names = ", ".join(system.labels[k] for k in opened.implicit)
    return least_outputs(np.array(left), np.array(right), names, np.array(sizes))


def least_outputs(left: Reals, right: Reals, names: str, sizes: Reals | None = None) -> Reals:
    """Solve left @ outputs = right, m x m and m x n; where conditions repeat, take the smallest outputs.

    So it is where frictions between three bodies all stick, or two act between the same bodies: the
    motion is determined, how they share the force is not, and the smallest may exceed a limit although
    others do not (``trimmer.loops.frictions.coupled_relays``). What is less than the rounding of
    ``sizes`` is zero.
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
    if sizes is not None:
        solution = without_rounding(solution, abs(inverse) @ (sizes / rows))
    outputs: Reals = np.asarray(solution / columns[:, None])
    return outputs


def without_rounding(values: Reals, sizes: Reals) -> Reals:
    """Return values with zeros where they are rounding of terms of these sizes."""
    return np.where(abs(values) > NEGLIGIBLE * sizes, values, 0.0)


def _differentiated(row: Reals, opened: OpenMode, column: int, label: str) -> Reals:
    """Differentiate a row along the flow until the output of that column acts on its rate."""
    for _ in range(len(opened.flow)):
        if acts(row, opened.push[:, column]):
            return row
        row = row @ opened.flow
    raise IllPosedLoopError(f"{label}: its input stays at zero, and its output is not determined")


def component_signals(
    layout: StateLayout, flow: tuple[Reals, Reals], given: Reals, output: Reals, k: int, count: int
) -> Signals:
    """Return the rows of a component; ``flow``: matrix, and sizes of the terms of its entries."""
    matrix, sizes = flow
    rate = without_rounding(given @ matrix, abs(given) @ sizes)
    first = layout.first_states[k]
    states = tuple(layout.unit(first + each) for each in range(count))
    curvature = without_rounding(rate @ matrix, abs(rate) @ sizes)
    return Signals(given, rate, curvature, output, states, layout.one)
