"""What a motion does, measured: strokes, impacts, accelerations, wear."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.statuses import CONTACT_MADE, KINDS, NOTHING, STICK

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.contact.flow import Course
    from trimmer.mechanism.mechanism import Mechanism


@dataclass(frozen=True)
class Measures:
    """Measures of a motion over some drive periods.

    Attributes:
        peak_to_peak: Of each output, m.
        rms_acceleration: Of each body, m/s².
        wear_power: What each dry friction turns into heat on average, W; its viscous share is left out.
        events: Per drive period, of all kinds.
        impacts: Contacts made per drive period.
        impact_speed: Largest speed at which the sides of a contact meet, m/s; 0 without impacts.
    """

    peak_to_peak: dict[str, float]
    rms_acceleration: dict[str, float]
    wear_power: dict[str, float]
    events: float
    impacts: float
    impact_speed: float


def measured(mechanism: Mechanism, course: Course, periods: int) -> Measures:
    """Return the measures of a motion.

    Args:
        mechanism: The mechanism.
        course: Its motion.
        periods: Drive periods that the motion lasts.
    """
    counts = np.bincount(course.log.kind, minlength=KINDS)
    return Measures(
        {name: _swing(course, _output_row(mechanism, course, name)) for name in mechanism.outputs},
        _rms_accelerations(course),
        _wear_powers(mechanism, course),
        float((len(course.log.kind) - counts[NOTHING]) / periods),
        float(counts[CONTACT_MADE] / periods),
        _impact_speed(course),
    )


def _output_row(mechanism: Mechanism, course: Course, name: str) -> Reals:
    """Return an output as a functional of the extended state, (N,)."""
    layout = course.modes.layout
    row = np.zeros(layout.size)
    for part, weight in mechanism.outputs[name].weights.items():
        if part in layout.bodies:
            row[layout.bodies.index(part)] += weight
        else:
            row += weight * layout.pin_rows[layout.pins.index(part)]
    return row


def _swing(course: Course, row: Reals) -> float:
    """Return the difference of the highest and the lowest value of a functional."""
    times, _, _, states = course.nodes
    values, rates = states @ row, _rates(course) @ row
    return _highest(times, values, rates) + _highest(times, -values, -rates)


def _rates(course: Course) -> Reals:
    """Return the rates of the extended state at the nodes, (nodes, N)."""
    _, _, rows, states = course.nodes
    numbers = course.log.mode[rows]
    rates = np.empty_like(states)
    for number in np.unique(numbers):
        here = numbers == number
        rates[here] = states[here] @ course.modes[int(number)].flow.T
    return rates


def _highest(times: Reals, values: Reals, rates: Reals) -> float:
    """Return the largest value on the cubics through values and rates beside the highest node."""
    top = int(np.argmax(values))
    best = float(values[top])
    for first in (top - 1, top):
        if 0 <= first < len(times) - 1 and rates[first] > 0 > rates[first + 1]:
            best = max(best, _top_of_cubic(times, values, rates, first))
    return best


def _top_of_cubic(times: Reals, values: Reals, rates: Reals, first: int) -> float:
    length = times[first + 1] - times[first]
    rise = values[first + 1] - values[first]
    begin, end = length * rates[first], length * rates[first + 1]
    second, third = 3 * rise - 2 * begin - end, begin + end - 2 * rise
    roots = np.roots([3 * third, 2 * second, begin])
    inside = roots[(abs(roots.imag) == 0) & (roots.real > 0) & (roots.real < 1)].real
    return float(values[first] + max((s * (begin + s * (second + s * third)) for s in inside), default=0.0))


def _rms_accelerations(course: Course) -> dict[str, float]:
    _, weights, _, _ = course.nodes
    bodies = course.modes.layout.bodies
    accelerations = _rates(course)[:, len(bodies) : 2 * len(bodies)]
    squares = weights @ accelerations**2 / course.duration
    return dict(zip(bodies, np.sqrt(squares).tolist(), strict=True))


def _wear_powers(mechanism: Mechanism, course: Course) -> dict[str, float]:
    machine, layout = course.modes.machine, course.modes.layout
    _, weights, rows, states = course.nodes
    statuses = course.modes.tables.statuses[course.log.mode[rows], len(machine.stiffness) :]
    speeds = np.where(statuses == STICK, 0.0, abs(states @ machine.friction_rate.T))
    powers = machine.kinetic * (weights @ speeds) / course.duration
    found = dict(zip(layout.frictions, powers.tolist(), strict=True))
    return {name: found.get(name, 0.0) for name in mechanism.frictions}


def _impact_speed(course: Course) -> float:
    """Return the largest relative speed at which a contact is made."""
    made = np.flatnonzero(course.log.kind == CONTACT_MADE)
    rates = course.modes.machine.contact_rate[course.log.part[made]]
    return float(abs((rates * course.log.state[made]).sum(axis=1)).max(initial=0.0))
