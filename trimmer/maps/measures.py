"""What the motion of a cell does, as numbers: strokes, impacts, accelerations, wear.

Those of an orbit are exact. A window of a motion that does not repeat leaves more open than even samples do,
and these take a fraction of the time.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from trimmer.arrays import Integers, Reals
from trimmer.contact.flow import MechanismFlow
from trimmer.contact.machine.statuses import STICK
from trimmer.contact.readouts.curve_forces import curve_forces
from trimmer.hybrid.system import NOTHING
from trimmer.mechanism.parts import OutputKind
from trimmer.motion.chosen import chosen_measure
from trimmer.motion.course import Course
from trimmer.motion.extremes import extremes
from trimmer.motion.flow import Flow
from trimmer.motion.measures import Measures
from trimmer.motion.signals import Steady
from trimmer.response.without_events.linear_lines import LinearLines
from trimmer.response.without_events.linear_motion import LinearMotion
from trimmer.response.without_events.rest import stands

SAMPLES = 128  # Samples per drive period of a window, beside its events


@dataclass(frozen=True)
class CellMeasures:
    """Measures of a motion over some drive periods.

    Attributes:
        peak_to_peak: Of each output, in its unit.
        rms_acceleration: Of each body, m/s².
        wear_power: What each dry friction turns into heat on average, W; its viscous share is left out.
        events: Per drive period, of all kinds.
        impacts: Contacts made per drive period.
        impact_speed: Largest speed at which the sides of a contact meet, m/s; 0 without impacts.
        chosen: Those that were asked for, by their keys, SI units.
    """

    peak_to_peak: dict[str, float]
    rms_acceleration: dict[str, float]
    wear_power: dict[str, float]
    events: float
    impacts: float
    impact_speed: float
    chosen: dict[str, float] = field(default_factory=dict)


def chosen(
    flow: Flow, course: Course, period_count: int, periods: int, keys: Sequence[str], *, rests: bool = False
) -> dict[str, float]:
    """Return measures of a motion by their keys, exact to rounding; arguments as of ``motion.Measures``."""
    found = Measures(course, flow, period_count, periods, still=rests and stands(flow))
    return {key: chosen_measure(flow, key).of(found) for key in keys}


def of_orbit(flow: Flow, course: Course, period_count: int, *, rests: bool = False) -> CellMeasures:
    """Return the measures of an orbit, exact to rounding.

    Args:
        flow: What moves.
        course: The motion over its period.
        period_count: Drive periods that it lasts.
        rests: Whether all states rest in it.
    """
    found = Measures(course, flow, period_count, period_count, still=rests and stands(flow))
    frictions = {name: each.power for name, each in found.frictions.items()}
    return CellMeasures(
        dict(found.peak_to_peak),
        dict(found.rms_acceleration),
        {name: frictions.get(name, 0.0) for name in flow.rubbing},
        *_of_events(flow, course, period_count),
    )


def of_window(flow: Flow, course: Course, periods: int) -> CellMeasures:
    """Return the measures of a motion that does not repeat, from even samples.

    Args:
        flow: What moves.
        course: A window of the motion.
        periods: Drive periods that it lasts.
    """
    if not isinstance(flow, MechanismFlow):
        return of_orbit(flow, course, periods)
    mechanism, log, machine = flow.mechanism, course.log, flow.modes.system.machine
    count, bodies = periods * SAMPLES, len(mechanism.coordinates)
    times = course.duration * (np.arange(count) + 0.5) / count
    rows, states = course.at(times)
    layout = flow.modes.system.layout
    weights = np.array([layout.weights(name) for name in layout.shaken])
    accelerations = product(_accelerations(course, rows, states, bodies), weights)
    speeds = abs(product(states, machine.friction_rate))
    first = len(machine.stiffness)
    statuses = flow.modes.tables.statuses[log.mode[rows], first : first + len(machine.kinetic)]
    speeds[statuses == STICK] = 0.0
    means = machine.kinetic * speeds.mean(axis=0)
    names = layout.frictions
    for number, name in enumerate(names):
        forces = curve_forces(course, "frictions", name, rows, states)
        means[number] += (forces * product(states, machine.friction_rate[number : number + 1])[:, 0]).mean()
    powers = dict(zip(names, means, strict=True))
    return CellMeasures(
        _swings(flow, course, times, states),
        dict(zip(layout.shaken, np.sqrt((accelerations**2).mean(axis=0)).tolist(), strict=True)),
        {name: float(powers.get(name, 0.0)) for name in mechanism.frictions},
        *_of_events(flow, course, periods),
    )


def _of_events(flow: Flow, course: Course, periods: int) -> tuple[float, float, float]:
    """Return events and impacts per drive period, and the largest speed of an impact."""
    speeds = flow.impact_speeds(course)
    events = int((course.log.kind != NOTHING).sum())
    return events / periods, len(speeds) / periods, float(speeds.max(initial=0.0))


def product(states: Reals, functionals: Reals) -> Reals:
    """Return functionals (m, N) of states (samples, N), as (samples, m).

    The linear algebra of NumPy would start threads for it, which cost more than the product in a process
    beside others.
    """
    return np.asarray(np.einsum("ij,kj->ik", states, functionals, optimize=False))


def _accelerations(course: Course, rows: Integers, states: Reals, bodies: int) -> Reals:
    numbers = course.log.mode[rows]
    accelerations = np.empty((len(rows), bodies))
    for number in set(numbers.tolist()):
        here = numbers == number
        accelerations[here] = product(states[here], course.modes[number].flow[bodies : 2 * bodies])
    return accelerations


def _swings(flow: MechanismFlow, course: Course, times: Reals, states: Reals) -> dict[str, float]:
    """Return peak to peak of the outputs: of displacements from cubics through values and rates."""
    times = np.concatenate([course.log.start, times])
    order = np.argsort(times, kind="stable")
    states = np.concatenate([course.log.state, states])[order]
    kinds = {name: each.kind for name, each in flow.mechanism.outputs.items()}
    others = [name for name, kind in kinds.items() if kind is not OutputKind.DISPLACEMENT]
    ranges = {name: extremes(course, flow.outputs[name].signal) for name in others}
    found = {name: largest - smallest for name, (smallest, largest) in ranges.items()}
    signals = {name: each.signal for name, each in flow.outputs.items() if name not in found}
    rows = {name: each.row for name, each in signals.items() if isinstance(each, Steady)}
    if not rows:
        return found
    functionals = np.array(list(rows.values()))
    # The rates of displacements are the same in every mode, but those of the drive must be among them.
    values, rates = product(states, functionals), product(states, functionals @ flow.modes[0].flow)
    return found | {
        name: _highest(times[order], values[:, i], rates[:, i])
        + _highest(times[order], -values[:, i], -rates[:, i])
        for i, name in enumerate(rows)
    }


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


def of_lines(lines: LinearLines, motion: LinearMotion) -> CellMeasures:
    """Return the measures of a linear motion on a torus, exact to rounding; no event comes in it.

    Args:
        lines: Its lines.
        motion: It.
    """
    flow = motion.flow
    if not isinstance(flow, MechanismFlow):  # Friction in a loop has an event in each period.
        nothing = dict.fromkeys(flow.rubbing, 0.0)
        return CellMeasures(dict(lines.peak_to_peak), {}, nothing, 0.0, 0.0, 0.0)
    sliding = np.array(flow.modes.system.machine.of_frictions(motion.instant.statuses)) != STICK
    speeds = [abs(motion.seen_by(row)[0]) for row in flow.modes.system.machine.friction_rate]
    powers = flow.modes.system.machine.kinetic * np.array(speeds) * sliding
    of_each = dict(zip(flow.modes.system.layout.frictions, powers.tolist(), strict=True))
    wear = {name: float(of_each.get(name, 0.0)) for name in flow.mechanism.frictions}
    return CellMeasures(dict(lines.peak_to_peak), dict(lines.rms_acceleration), wear, 0.0, 0.0, 0.0)
