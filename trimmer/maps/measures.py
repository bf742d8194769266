"""What a motion does, measured: strokes, impacts, accelerations, wear."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.statuses import CONTACT_MADE, KINDS, NOTHING, STICK

if TYPE_CHECKING:
    from trimmer.arrays import Integers, Reals
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


@dataclass(frozen=True, eq=False)
class _Samples:
    """A motion at the nodes of quadrature, at its events and at its end, in order.

    Attributes:
        times: s, (samples,).
        weights: s, zero at events and at the end, (samples,).
        rows: Rows of the log, (samples,).
        states: Extended states, (samples, N).
        rates: Their rates, (samples, N).
    """

    times: Reals
    weights: Reals
    rows: Integers
    states: Reals
    rates: Reals


def measured(mechanism: Mechanism, course: Course, periods: int) -> Measures:
    """Return the measures of a motion.

    Swings are exact to some 1e-11, means to rounding.

    Args:
        mechanism: The mechanism.
        course: Its motion.
        periods: Drive periods that the motion lasts.
    """
    samples = _sampled(course)
    counts = np.bincount(course.log.kind, minlength=KINDS)
    outputs = mechanism.outputs
    return Measures(
        {name: _swing(samples, _output_row(mechanism, course, name)) for name in outputs},
        _rms_accelerations(course, samples),
        _wear_powers(mechanism, course, samples),
        float((len(course.log.kind) - counts[NOTHING]) / periods),
        float(counts[CONTACT_MADE] / periods),
        _impact_speed(course),
    )


def _sampled(course: Course) -> _Samples:
    times, weights, rows, states = course.nodes
    log, end, layout = course.log, course.end, course.modes.layout
    last = np.concatenate([end.state, layout.forcing_at(end.phase, end.periods * layout.period)])
    count = len(log.start)
    order = np.argsort(np.concatenate([log.start, times, [course.duration]]), kind="stable")
    times = np.concatenate([log.start, times, [course.duration]])[order]
    weights = np.concatenate([np.zeros(count), weights, [0.0]])[order]
    rows = np.concatenate([np.arange(count), rows, [count - 1]])[order]
    states = np.concatenate([log.state, states, last[None]])[order]
    numbers, rates = log.mode[rows], np.empty_like(states)
    for number in np.unique(numbers):
        here = numbers == number
        rates[here] = states[here] @ course.modes[int(number)].flow.T
    return _Samples(times, weights, rows, states, rates)


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


def _swing(samples: _Samples, row: Reals) -> float:
    """Return the difference of the highest and the lowest value of a functional."""
    values, rates = samples.states @ row, samples.rates @ row
    return _highest(samples.times, values, rates) + _highest(samples.times, -values, -rates)


def _highest(times: Reals, values: Reals, rates: Reals) -> float:
    """Return the largest value on the cubics through values and rates beside the highest sample."""
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


def _rms_accelerations(course: Course, samples: _Samples) -> dict[str, float]:
    bodies = course.modes.layout.bodies
    accelerations = samples.rates[:, len(bodies) : 2 * len(bodies)]
    squares = samples.weights @ accelerations**2 / course.duration
    return dict(zip(bodies, np.sqrt(squares).tolist(), strict=True))


def _wear_powers(mechanism: Mechanism, course: Course, samples: _Samples) -> dict[str, float]:
    machine, layout = course.modes.machine, course.modes.layout
    statuses = course.modes.tables.statuses[course.log.mode[samples.rows], len(machine.stiffness) :]
    speeds = np.where(statuses == STICK, 0.0, abs(samples.states @ machine.friction_rate.T))
    powers = machine.kinetic * (samples.weights @ speeds) / course.duration
    found = dict(zip(layout.frictions, powers.tolist(), strict=True))
    return {name: found.get(name, 0.0) for name in mechanism.frictions}


def _impact_speed(course: Course) -> float:
    """Return the largest relative speed at which a contact is made."""
    made = np.flatnonzero(course.log.kind == CONTACT_MADE)
    rates = course.modes.machine.contact_rate[course.log.part[made]]
    return float(abs((rates * course.log.state[made]).sum(axis=1)).max(initial=0.0))
