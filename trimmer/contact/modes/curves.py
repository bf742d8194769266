"""What curves of links and frictions do in a mode: their forces, and the events at their knots.

A status is a segment between knots, counted from the lowest one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arrays import Reals
from trimmer.contact.machine.statuses import ABOVE_KNOT, BELOW_KNOT
from trimmer.hybrid.system import NOTHING, EventFunction, Transition

if TYPE_CHECKING:
    from trimmer.contact.machine.machine import Machine


def curve_force(machine: Machine, curve: int, segment: int) -> Reals:
    """Return the force of a curve on a segment, positive where it pulls the ends together, (N,)."""
    force: Reals = machine.curve_slopes[curve, segment] * machine.curve_over[curve]
    force[-1] += machine.curve_heights[curve, segment]
    return force


def add_curves(machine: Machine, statuses: tuple[int, ...], flow: Reals) -> None:
    """Add the forces of all curves to a flow, (N, N)."""
    for curve, segment in enumerate(machine.of_curves(statuses)):
        flow[machine.velocities] += np.outer(machine.curve_push[curve], curve_force(machine, curve, segment))


def add_least_curves(machine: Machine, flow: Reals) -> None:
    """Add each curve to a flow, (N, N), as it is far away, where it is the less stiff."""
    for over, push, knots, slopes in zip(
        machine.curve_over, machine.curve_push, machine.curve_knots, machine.curve_slopes, strict=True
    ):
        least = min(slopes[0], slopes[int(np.isfinite(knots).sum())])
        flow[machine.velocities] += np.outer(push, least * over)


def functions_of_curves(machine: Machine, statuses: tuple[int, ...]) -> Iterator[EventFunction]:
    """Yield how far each curve is from the knots at the ends of its segment."""
    for curve, over in enumerate(machine.curve_over):
        part = machine.first_curve + curve
        segment, knots = statuses[part], machine.curve_knots[curve]
        if segment < len(knots) and np.isfinite(knots[segment]):
            row = -over
            row[-1] += knots[segment]
            yield EventFunction(part, ABOVE_KNOT, row)
        if segment > 0:
            row = over.copy()
            row[-1] -= knots[segment - 1]
            yield EventFunction(part, BELOW_KNOT, row)


def beyond_knot(statuses: tuple[int, ...], function: EventFunction) -> Transition:
    """Return what follows where a knot is reached: the next segment, at whose end the motion is."""
    curve, rises = function.owner, function.action == ABOVE_KNOT
    after = (*statuses[:curve], statuses[curve] + (1 if rises else -1), *statuses[curve + 1 :])
    return Transition(after, NOTHING, ((BELOW_KNOT if rises else ABOVE_KNOT, 1),))


def segments_at(machine: Machine, state: Reals) -> tuple[int, ...]:
    """Return the segment of each curve at an extended state, (N,)."""
    if not len(machine.curve_over):
        return ()
    values = machine.curve_over @ state
    return tuple(
        int(np.searchsorted(knots, value, side="right")) if len(knots) else 0
        for knots, value in zip(machine.curve_knots, values, strict=True)
    )


def mirror_of(machine: Machine, curve: int) -> dict[int, int]:
    """Return the segment in the mirror image of a motion, by the segment."""
    last = int(np.isfinite(machine.curve_knots[curve]).sum())
    return {segment: last - segment for segment in range(last + 1) if segment != last - segment}
