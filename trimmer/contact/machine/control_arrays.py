"""The arrays of controllers: what they demand and what that does, as functionals of the extended state."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.controllers.laws import Law, laws_of
from trimmer.mechanism.parts import OutputKind

if TYPE_CHECKING:
    from trimmer.contact.state.rows import EndRows
    from trimmer.mechanism import Controller, Mechanism, Output


def control_arrays(mechanism: Mechanism, rows: EndRows, base: Reals) -> dict[str, Any]:
    """Return the arrays of a machine for its controllers; the laws of their states go into a base, (N, N)."""
    laws = laws_of(mechanism)
    size, count, numbers = len(base), len(mechanism.coordinates), len(laws)
    place = rows.layout.first_control
    found: dict[str, Any] = {
        f"control_{name}": np.zeros((numbers, size)) for name in ("demand", "effect", "tracking", "rest")
    }
    found |= {"control_limit": np.full(numbers, np.inf), "control_through": np.ones(numbers)}
    for number, (name, law) in enumerate(laws.items()):
        controller = mechanism.controllers[name]
        states, delayed = _places(place, law)
        place = delayed.stop
        given = np.array(inputs_of(mechanism, controller, rows))
        base[states] += law.demand.given @ given
        base[states, states] += law.demand.state
        demand = law.demand.through @ given
        demand[states] += law.demand.read
        base[delayed, delayed] += law.acting.state
        rest = np.zeros(size)
        rest[delayed] = law.acting.read
        push, through = rows.push(*controller.acts), float(law.acting.through[0])
        base[count : 2 * count] += np.outer(push, rest)
        found["control_demand"][number], found["control_rest"][number] = demand, rest
        found["control_effect"][number, count : 2 * count] = through * push
        found["control_effect"][number, delayed] = law.acting.given[:, 0]
        found["control_tracking"][number, states] = law.tracking
        found["control_through"][number] = through
        if controller.limit is not None:
            found["control_limit"][number] = controller.limit
    for name in rows.layout.held:
        base[count : 2 * count] += np.outer(rows.push(*mechanism.controllers[name].acts), rows.held(name))
    return found


def _places(first: int, law: Law) -> tuple[slice, slice]:
    """Return the places of the states of the law, and of those of its delay."""
    own = first + len(law.demand.names)
    return slice(first, own), slice(own, own + len(law.acting.names))


def inputs_of(mechanism: Mechanism, controller: Controller, rows: EndRows) -> tuple[Reals, Reals, Reals]:
    """Return error, speed and rate of the reference of a controller as functionals, (N,) each."""
    measured = measured_row(mechanism, mechanism.outputs[controller.measure], rows)
    value, rate = rows.reference(controller.reference)
    return value - measured, _speed(mechanism, controller, rows), rate


def _speed(mechanism: Mechanism, controller: Controller, rows: EndRows) -> Reals:
    if controller.speed is not None:
        return measured_row(mechanism, mechanism.outputs[controller.speed], rows)
    output = mechanism.outputs[controller.measure]
    if output.kind is not OutputKind.DISPLACEMENT:
        return np.zeros(rows.layout.size)
    return np.asarray(sum(weight * rows.velocity(of) for of, weight in output.weights.items()))


def measured_row(mechanism: Mechanism, output: Output, rows: EndRows) -> Reals:
    """Return a displacement, a velocity, or the force of a link without a curve as a functional, (N,)."""
    if output.kind is OutputKind.FORCE:
        return rows.tension(mechanism.links[str(output.part)])
    of_end = rows.displacement if output.kind is OutputKind.DISPLACEMENT else rows.velocity
    return np.asarray(sum(weight * of_end(of) for of, weight in output.weights.items()))
