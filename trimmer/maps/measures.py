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


COARSE = 128
"""Samples per drive period of a motion that does not repeat."""


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
    """

    times: Reals
    weights: Reals
    rows: Integers
    states: Reals


def measured(mechanism: Mechanism, course: Course, periods: int, *, closes: bool = True) -> Measures:
    """Return the measures of a motion.

    Args:
        mechanism: The mechanism.
        course: Its motion.
        periods: Drive periods that the motion lasts.
        closes: Whether the motion is an orbit, of which swings are given to some 1e-11 and means to
            rounding. Otherwise ``COARSE`` samples a period are enough beside what the window leaves open.
    """
    samples = _with_events(course, _nodes(course) if closes else _even(course, periods))
    outputs = np.array([_output_row(mechanism, course, name) for name in mechanism.outputs])
    outputs = outputs.reshape(-1, course.modes.layout.size)
    accelerations, rates = _rates(course, samples, outputs)
    values = product(samples.states, outputs)
    swings = [_swing(samples.times, values[:, i], rates[:, i]) for i in range(len(outputs))]
    counts = np.bincount(course.log.kind, minlength=KINDS)
    squares = (samples.weights[:, None] * accelerations**2).sum(axis=0) / course.duration
    return Measures(
        dict(zip(mechanism.outputs, swings, strict=True)),
        dict(zip(mechanism.bodies, np.sqrt(squares).tolist(), strict=True)),
        _wear_powers(mechanism, course, samples),
        float((len(course.log.kind) - counts[NOTHING]) / periods),
        float(counts[CONTACT_MADE] / periods),
        _impact_speed(course),
    )


def product(states: Reals, functionals: Reals) -> Reals:
    """Return functionals (m, N) of states (samples, N), as (samples, m).

    The linear algebra of NumPy would start threads for it, which cost more than the product in a process
    beside others.
    """
    return np.asarray(np.einsum("ij,kj->ik", states, functionals, optimize=False))


def _nodes(course: Course) -> _Samples:
    return _Samples(*course.nodes)


def _even(course: Course, periods: int) -> _Samples:
    count = periods * COARSE
    times = course.duration * (np.arange(count) + 0.5) / count
    rows = np.searchsorted(course.log.start, times, side="right") - 1
    return _Samples(times, np.full(count, course.duration / count), rows, course.states(times))


def _with_events(course: Course, samples: _Samples) -> _Samples:
    log, end, layout = course.log, course.end, course.modes.layout
    last = np.concatenate([end.state, layout.forcing_at(end.phase, end.periods * layout.period)])
    count = len(log.start)
    times = np.concatenate([log.start, samples.times, [course.duration]])
    order = np.argsort(times, kind="stable")
    return _Samples(
        times[order],
        np.concatenate([np.zeros(count), samples.weights, [0.0]])[order],
        np.concatenate([np.arange(count), samples.rows, [count - 1]])[order],
        np.concatenate([log.state, samples.states, last[None]])[order],
    )


def _rates(course: Course, samples: _Samples, outputs: Reals) -> tuple[Reals, Reals]:
    """Return accelerations of the bodies, (samples, bodies), and rates of outputs, (samples, outputs)."""
    bodies = len(course.modes.layout.bodies)
    numbers = course.log.mode[samples.rows]
    rates = np.empty((len(numbers), bodies + len(outputs)))
    for number in set(numbers.tolist()):
        flow, here = course.modes[number].flow, numbers == number
        rates[here] = product(samples.states[here], np.vstack([flow[bodies : 2 * bodies], outputs @ flow]))
    return rates[:, :bodies], rates[:, bodies:]


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


def _swing(times: Reals, values: Reals, rates: Reals) -> float:
    """Return the difference of the highest and the lowest value."""
    return _highest(times, values, rates) + _highest(times, -values, -rates)


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


def _wear_powers(mechanism: Mechanism, course: Course, samples: _Samples) -> dict[str, float]:
    machine, layout = course.modes.machine, course.modes.layout
    statuses = course.modes.tables.statuses[course.log.mode[samples.rows], len(machine.stiffness) :]
    speeds = np.where(statuses == STICK, 0.0, abs(product(samples.states, machine.friction_rate)))
    powers = machine.kinetic * (samples.weights[:, None] * speeds).sum(axis=0) / course.duration
    found = dict(zip(layout.frictions, powers.tolist(), strict=True))
    return {name: found.get(name, 0.0) for name in mechanism.frictions}


def _impact_speed(course: Course) -> float:
    """Return the largest relative speed at which a contact is made."""
    made = np.flatnonzero(course.log.kind == CONTACT_MADE)
    rates = course.modes.machine.contact_rate[course.log.part[made]]
    return float(abs((rates * course.log.state[made]).sum(axis=1)).max(initial=0.0))
