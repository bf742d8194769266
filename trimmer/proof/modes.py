"""An orbit as data of a proof: modes, segments and start, as the assembler and the solver have them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from trimmer.contact.statuses import IMPACT
from trimmer.hybrid.calm import amid_longest
from trimmer.hybrid.clock import ABOVE, BELOW, TICKED, WITHIN, Clock, carried
from trimmer.hybrid.system import EventFunction, ModeEquations, System
from trimmer.hybrid.variation import end_of_instant
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.proof.outcome import UndecidedError
from trimmer.proof.statement import MOST_ZEROS
from trimmer.response.orbit import Orbit

LEAST = 1e-6
"""Size of a state as a share of the largest of its kind that it has at least: below that it hardly moves."""
INSTANTS = 256
"""Of a motion, at which its size is taken."""
BESIDE = 1e-6
"""Share of a motion within which an event is too near to where it begins."""
SMALL = 1e-10
"""Share of its terms below which a derivative of an event function is taken for zero by law."""


@dataclass(frozen=True)
class Seen:
    """The segments of an orbit, with the modes of the system that it is said to be of."""

    log: Any
    known: Any
    modes: Any

    @property
    def system(self) -> System:
        """What it is said to be a motion of."""
        system: System = self.modes.system
        return system

    def mode(self, row: int) -> ModeEquations:
        """Return the mode of a row of the log."""
        return self.system.mode(self.known[int(self.log.mode[row])].statuses)

    def fires(self, row: int) -> int | None:
        """Return the number of what fell to zero at the beginning of a row; None at an instant of a clock."""
        function = int(self.log.function[row])
        return None if function <= TICKED else function

    def code(self, row: int) -> int:
        """Return what a clock does at the beginning of a row."""
        return TICKED - int(self.log.function[row])

    def clock(self, row: int) -> tuple[Clock, int]:
        """Return the clock, and the number of the mode before a row there."""
        number = int(self.modes.number(self.known[int(self.log.mode[row - 1])].statuses))
        return self.modes.samplings.clock, number

    def fired(self, row: int) -> EventFunction:
        """Return what fell to zero at the beginning of a row."""
        return self.mode(row - 1).functions[int(self.log.function[row])]


def orbit_data(orbit: Orbit, flow: Flow) -> dict[str, Any]:
    """Return modes and segments of an orbit.

    Args:
        orbit: The orbit.
        flow: What it is said to be a motion of; modes and resets are taken from this alone.
    """
    if not orbit.success:
        raise UndecidedError("it does not return")
    stable = True if orbit.stable else None if orbit.neutral else False
    if orbit.advances and flow is not orbit.flow:
        raise UndecidedError("the orbit is one of another system, in another frame")
    frame = flow.modes.system.layout.frame.velocities.tolist() if orbit.advances else []
    course = begun_amid(orbit.course)
    motion = motion_data(course, flow, orbit.periods)
    return {"motion": {**motion, "frame": frame}, "equations": equations_data(course, flow), "stable": stable}


def begun_amid(course: Course) -> Course:
    """Return a motion that repeats, begun where nothing happens if something does where it begins."""
    system, times = course.modes.system, np.unique(course.log.start[course.log.function >= 0])
    if system.clockwork is not None or not len(times):
        return course
    if times[0] > BESIDE * course.duration and times[-1] < (1.0 - BESIDE) * course.duration:
        return course
    later, period = amid_longest(times, course.duration), system.layout.period
    phase = course.begin.phase + later
    return course.turned(later, phase % period if period else phase)


def motion_data(course: Course, flow: Flow, periods: float) -> dict[str, Any]:
    """Return the segments of a motion of some periods of the drive, 0 without one."""
    system = flow.modes.system
    layout, log = system.layout, course.log
    seen = Seen(log, course.modes, flow.modes)
    _require_covered(course, system)
    rows = list(instants(log))
    n = layout.state_count
    segments: list[dict[str, Any]] = []
    largest = abs(log.state).max(axis=0)
    within = course.states(np.linspace(0.0, course.duration, INSTANTS))[:, :n]
    largest[:n] = np.maximum(largest[:n], abs(within).max(axis=0))
    for kind in layout.kinds:
        largest[kind] = np.maximum(largest[kind], LEAST * largest[kind].max(initial=0.0))
    largest[:n] = np.where(largest[:n] > 0.0, largest[:n], LEAST * (largest[:n].max(initial=0.0) or 1.0))
    ends = [*(float(log.start[first]) for first, _ in rows[1:]), float(course.duration)]
    used = modes_used(log)
    for place, ((first, last), end) in enumerate(zip(rows, ends, strict=True)):
        mode, following = seen.mode(last), None if place + 1 == len(rows) else rows[place + 1][0]
        fired = None if following is None else seen.fires(following)
        owners = _owners(seen, first, last)
        segments.append(
            {
                "mode": used.index(int(log.mode[last])),
                "duration": end - float(log.start[first]),
                "fired": fired,
                "together": []
                if fired is None or following is None
                else _together(mode, fired, course.before(following), largest),
                "zeros": _zeros(mode, log.state[last], largest, owners) if place else [],
                **({"at": None, "strict": []} if following is None else _tick(seen, following)),
            }
        )
    if system.clockwork is not None and course.begin.phase:
        raise UndecidedError("a sampled motion that begins amid a period is not covered")
    samplers = () if system.clockwork is None else system.clockwork.samplers
    return {
        "about": flow.subject.title or type(flow.subject).__name__,
        "segments": segments,
        "sizes": largest[:n].tolist(),
        "state": log.state[0, :n].tolist(),
        "rotation": np.rint(seen.mode(0).flow[n:, n:] / (layout.omega or 1.0)).astype(int).tolist(),
        "periods": float(periods),
        "signs": [],
        "shifts": _shifts(layout) if flow.shifts else [],
        "frame": [],
        "clock": [[each.sample, each.delay] for each in samplers],
    }


def _shifts(layout: Any) -> list[list[list[float]]]:
    """Return directions along which nothing changes, each with what is to stay: its leader, (n,)."""
    rest, leading = np.zeros(layout.state_count - len(layout.frame.directions)), layout.frame.leading
    identity = np.eye(layout.state_count)
    pairs = zip(layout.frame.directions.T, leading, strict=True)
    return [[[*way, *rest], identity[leader].tolist()] for way, leader in pairs]


def equations_data(course: Course, flow: Flow) -> dict[str, Any]:
    """Return the numbers of the modes and events of a motion, those that a flow gives them."""
    own, system = course.modes.system.layout, flow.modes.system
    _require_covered(course, system)
    seen = Seen(course.log, course.modes, flow.modes)
    scale = system.layout.period / own.period if own.period else 1.0
    return {
        "modes": _modes(seen),
        "resets": [_reset(seen, first, last).tolist() for first, last in instants(course.log)],
        "forcing": system.layout.forcing_at(course.begin.phase * scale).tolist(),
        "period": float(system.layout.period) if own.period else None,
    }


def modes_used(log: Any) -> list[int]:
    """Return the numbers of the modes in which an orbit is for some time."""
    return sorted({int(log.mode[last]) for _, last in instants(log)})


def _modes(seen: Seen) -> list[dict[str, Any]]:
    n = seen.system.layout.state_count
    modes = (seen.system.mode(seen.known[number].statuses) for number in modes_used(seen.log))
    return [
        {
            "flow": mode.flow[:n].tolist(),
            "functions": [each.row.tolist() for each in mode.functions],
        }
        for mode in modes
    ]


def _require_covered(course: Course, system: System) -> None:
    own, layout = course.modes.system.layout, system.layout
    if (own.size, own.state_count, own.period > 0) != (layout.size, layout.state_count, layout.period > 0):
        raise UndecidedError("the orbit is one of another system")
    if layout.ramp or layout.drifts or len(layout.breaks):
        raise UndecidedError("forces that do not repeat with the drive are not covered")
    n = layout.state_count
    block = system.mode(course.modes[0].statuses).flow[n:, n:] / (layout.omega or 1.0)
    if abs(block - np.rint(block)).max(initial=0.0) > 1e-9:
        raise UndecidedError("forces that are no multiples of the drive are not covered")


def instants(log: Any) -> Iterator[tuple[int, int]]:
    """Yield the first and the last row of each instant at which something happens."""
    row = 0
    while row < len(log.start):
        following = end_of_instant(log, row) if row else 1
        last = following - 1
        goes_on = row > 0 and TICKED < log.function[row] < 0
        if goes_on and (last > row or log.mode[row] != log.mode[row - 1]):
            raise UndecidedError("an event that is told by no event function is not covered")
        if not goes_on:
            yield row, last
        row = following


def _owners(seen: Seen, first: int, last: int) -> set[int]:
    """Return the parts that an instant concerns: what fired, and whose status changed; none at the start."""
    if not first:
        return set()
    before, after = (seen.mode(row).statuses for row in (first - 1, last))
    changed = {part for part, (one, other) in enumerate(zip(before, after, strict=True)) if one != other}
    rows = range(first, last + 1)
    return changed | {seen.fired(row).owner for row in rows if seen.log.function[row] >= 0}


def _reset(seen: Seen, first: int, last: int) -> Any:
    """Return what becomes of the state at an instant: resets of events, then made to fit what is held."""
    log, impulses = seen.log, 0
    total = np.eye(log.state.shape[1])
    for row in range(max(first, 1), last + 1):
        impulse = seen.system.impulse(int(log.part[row]), int(log.kind[row]))
        if impulse is not None:
            impulses += 1
            if impulses > 1 or log.kind[row] != IMPACT:
                raise UndecidedError("several impacts at one instant, or a chatter's end, are not covered")
            total = impulse[0] @ total
        if log.function[row] <= TICKED:
            clock, number = seen.clock(row)
            total = carried(clock, seen.code(row), number, total)
        elif log.function[row] >= 0 and impulse is None:
            found = seen.system.reset(seen.mode(row - 1), seen.fired(row))
            total = total if found is None else found @ total
    return seen.mode(last).hold @ total


def _tick(seen: Seen, row: int) -> dict[str, Any]:
    """Return when a clock samples, and what is positive there: how far each demand is from its limits."""
    if seen.fires(row) is not None:
        return {"at": None, "strict": []}
    (clock, number), rows = seen.clock(row), []
    sampled = seen.code(row) >> len(clock.limit)
    for c in reversed(range(len(clock.limit))):
        where, sampled = sampled % 4 - 1, sampled // 4
        demand, limit = clock.demand[number, c], np.zeros(seen.log.state.shape[1])
        limit[-1] = clock.limit[c]
        if where < 0 or not np.isfinite(limit[-1]):
            continue
        signs = {WITHIN: ((1, -1), (1, 1)), ABOVE: ((-1, 1),), BELOW: ((-1, -1),)}[where]
        rows += [(of_limit * limit + of_demand * demand).tolist() for of_limit, of_demand in signs]
    return {"at": float(seen.log.start[row]), "strict": rows}


def _together(mode: ModeEquations, fired: int, state: Any, largest: Any) -> list[int]:
    """Return the other event functions that are zero where one falls to zero."""
    return [
        place
        for place, function in enumerate(mode.functions)
        if place != fired and abs(function.row @ state) <= SMALL * (abs(function.row) @ largest)
    ]


def _zeros(mode: ModeEquations, state: Any, largest: Any, owners: set[int]) -> list[list[int]]:
    """Return how many derivatives of event functions of the parts concerned vanish after an event."""
    found = []
    for place, function in enumerate(mode.functions):
        if function.owner not in owners:
            continue
        row, moduli, count, z = function.row, abs(function.row), 0, np.array(state)
        sizes = largest
        while count < MOST_ZEROS and abs(row @ z) <= SMALL * (moduli @ sizes):
            count, sizes, z = count + 1, abs(mode.flow) @ sizes, mode.flow @ z
        if count:
            found.append([place, count])
    return found
