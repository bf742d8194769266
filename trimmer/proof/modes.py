"""An orbit as data of a proof: modes, segments and start, as the assembler and the solver have them."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from trimmer.contact.machine.statuses import IMPACT
from trimmer.hybrid.calm import amid_longest
from trimmer.hybrid.clock import ABOVE, BELOW, TICKED, WITHIN, Clock, carried
from trimmer.hybrid.stretch import Ending
from trimmer.hybrid.system import NOTHING, EventFunction, ModeEquations, System
from trimmer.hybrid.variation import end_of_instant
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.proof.outcome import UndecidedError
from trimmer.proof.statement import MOST_ZEROS
from trimmer.response.periodic.orbit import Orbit

LEAST = 1e-6
"""Size of a state as a share of the largest of its kind that it has at least: below that it hardly moves."""
INSTANTS = 256  # Of a motion, at which its size is taken
BESIDE = 1e-6  # Share of a motion within which an event is too near to where it begins
DECAYED = 40.0  # How many times over a motion without events what is not held falls to a share e
EVENLY = ", in a frame that moves evenly"
BUT_FOR_SHIFTS = ", but for shifts along which no force changes"
NOTHING_FELL, ROUNDING = -1, 1e-12
"""In the log in place of an event function; share of a time within which it is another one."""
SMALL = 1e-10  # Share of its terms below which a derivative of an event function is taken for zero by law


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
        """Return the number of what fell to zero at the beginning of a row; None where nothing did."""
        function = int(self.log.function[row])
        return None if function < 0 else function

    def breaks(self, row: int) -> bool:
        """Say whether what forces the states changes its course at the beginning of a row."""
        time, breaks = self.log.start[row], np.array(self.system.layout.breaks)
        own = row > 0 and self.log.function[row] == NOTHING_FELL and self.log.kind[row] == NOTHING
        return bool(own and (abs(breaks - time) <= ROUNDING * time).any())

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


@dataclass(frozen=True)
class Coordinates:
    """Those of a proof: states less the shift of their leader, where a motion may be shifted so."""

    onto: Any  # Z in them by Z, (N', N)
    back: Any  # Z by Z in them, the leaders at 0, (N, N')

    @classmethod
    def of(cls, flow: Flow) -> Self:
        """Return those in which nothing is left along which a motion may be shifted."""
        layout = flow.modes.system.layout
        whole = np.eye(layout.size)
        if not flow.shifts:
            return cls(whole, whole)
        back = np.delete(whole, layout.frame.leading, axis=1)
        return cls(back.T @ layout.frame.reduced(whole).T, back)

    def functional(self, row: Any, called: str = "an event function") -> list[float]:
        """Return a functional of Z in them, if it is one."""
        along = np.eye(len(self.back)) - self.back @ self.onto
        if (abs(row @ along) > ROUNDING * (abs(row) @ abs(along))).any():
            raise UndecidedError(f"{called} changes with a shift along which no force changes")
        return [float(each) for each in row @ self.back]


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
    course = begun_amid(orbit.course)
    motion, equations = motion_data(course, flow, orbit.periods), equations_data(course, flow)
    if orbit.advances and flow.modes.system.layout.frame.velocities.any():
        motion["about"] += EVENLY
    told_once(motion, equations)
    return {"motion": motion, "equations": equations, "stable": stable}


def stated_motion(course: Course, flow: Flow) -> dict[str, Any]:
    """Return a motion from its initial state, with equations in which what forces states is a state too."""
    if course.ending is not Ending.REACHED_END:
        raise UndecidedError("it ends early")
    system, rows = flow.modes.system, motion_rows(course, flow)
    seen, count = Seen(course.log, course.modes, flow.modes), system.layout.size - 1
    whole = Coordinates(np.eye(count + 1), np.eye(count + 1))
    motion = {**_told(course, flow, rows, whole), "turning": [], "periods": 0.0, "clock": []}
    motion["state"] = (seen.mode(rows[0][1]).hold @ course.log.state[rows[0][1]])[:count].tolist()
    motion["segments"][-1]["at"] = float(course.duration)
    if system.layout.travels and system.layout.frame.velocities.any():
        motion["about"] += EVENLY
    equations = _rates(seen, rows, whole, count)
    told_once(motion, equations)
    return {"motion": motion, "equations": {**equations, "forcing": [1.0], "period": None}, "stable": None}


def motion_rows(course: Course, flow: Flow) -> list[tuple[int, int]]:
    """Return first and last row of what begins each segment of a motion from its initial state."""
    rows = list(instants(Seen(course.log, course.modes, flow.modes), True))
    while len(rows) > 1 and course.log.start[rows[1][0]] == 0 and course.log.function[rows[1][0]] > TICKED:
        rows[:2] = [(0, rows[1][1])]
    return rows


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
    seen, n = Seen(course.log, course.modes, flow.modes), system.layout.state_count
    _require_covered(course, system)
    if system.clockwork is not None and course.begin.phase:
        raise UndecidedError("a sampled motion that begins amid a period is not covered")
    coordinates = Coordinates.of(flow)
    onto, states = coordinates.onto, len(coordinates.onto) - system.layout.size + n
    motion = _told(course, flow, list(instants(seen)), coordinates)
    sizes = np.array(motion["sizes"])[:n]
    if flow.shifts:
        motion["about"] += BUT_FOR_SHIFTS
        within = course.states(np.linspace(0.0, course.duration, INSTANTS))[:, :n]
        sizes = abs(within @ onto[:states, :n].T).max(axis=0)
        sizes = np.maximum(sizes, LEAST * sizes.max())
    motion.update(sizes=sizes.tolist(), state=(onto @ course.log.state[0])[:states].tolist())
    turns = np.rint(seen.mode(0).flow[n:, n:] / (system.layout.omega or 1.0)).astype(int)
    turning = [[int(i), int(k), int(turns[i, k])] for i, k in np.argwhere(np.triu(turns))]
    samplers = () if system.clockwork is None else system.clockwork.samplers
    clock = [[each.sample, each.delay] for each in samplers]
    return {**motion, "turning": turning, "periods": float(periods), "clock": clock}


def _told(
    course: Course, flow: Flow, rows: list[tuple[int, int]], coordinates: Coordinates
) -> dict[str, Any]:
    """Return the segments of a motion that begin with these rows of its log, and the sizes of Z but for 1."""
    log, layout, seen = course.log, flow.modes.system.layout, Seen(course.log, course.modes, flow.modes)
    n = layout.state_count
    segments: list[dict[str, Any]] = []
    largest = abs(log.state).max(axis=0)
    within = course.states(np.linspace(0.0, course.duration, INSTANTS))[:, :n]
    largest[:n] = np.maximum(largest[:n], abs(within).max(axis=0))
    for kind in layout.kinds:
        largest[kind] = np.maximum(largest[kind], LEAST * largest[kind].max(initial=0.0))
    largest[:n] = np.where(largest[:n] > 0.0, largest[:n], LEAST * (largest[:n].max(initial=0.0) or 1.0))
    ends = [*(float(log.start[first]) for first, _ in rows[1:]), float(course.duration)]
    used = modes_used(log, rows)
    for place, ((first, last), end) in enumerate(zip(rows, ends, strict=True)):
        mode, following = seen.mode(last), None if place + 1 == len(rows) else rows[place + 1][0]
        fired = None if following is None else seen.fires(following)
        owners = _owners(seen, first, last) if place else {each.owner for each in mode.functions}
        segments.append(
            {
                "reset": None,
                "mode": used.index(int(log.mode[last])),
                "duration": end - float(log.start[first]),
                "fired": fired,
                "together": []
                if fired is None or following is None
                else _together(mode, fired, course.before(following), largest),
                "zeros": _zeros(mode, log.state[last], largest, owners),
                "at": None if following is None or fired is not None else float(log.start[following]),
                "strict": []
                if following is None
                else [coordinates.functional(each) for each in _demands(seen, following)],
            }
        )
    return {
        "about": flow.subject.title or type(flow.subject).__name__,
        "segments": segments,
        "sizes": np.where(largest > 0.0, largest, LEAST)[:-1].tolist(),
        "signs": [],
    }


def equations_data(course: Course, flow: Flow) -> dict[str, Any]:
    """Return the numbers of the modes and events of a motion, those that a flow gives them."""
    own, system = course.modes.system.layout, flow.modes.system
    _require_covered(course, system)
    seen = Seen(course.log, course.modes, flow.modes)
    scale = system.layout.period / own.period if own.period else 1.0
    rows, n = list(instants(seen)), system.layout.state_count
    coordinates = Coordinates.of(flow)
    found = _rates(seen, rows, coordinates, n)
    if len(rows) == 1:
        # What is held holds by the equations then: what is off it comes to it.
        off = coordinates.onto @ (np.eye(system.layout.size) - seen.mode(rows[0][1]).hold) @ coordinates.back
        flow_of_all = np.array(found["modes"][0]["flow"])
        decay = off[: len(flow_of_all)] * (DECAYED / course.duration)
        found["modes"][0]["flow"] = (flow_of_all - decay).tolist()
    return {
        **found,
        "forcing": system.layout.forcing_at(course.begin.phase * scale).tolist(),
        "period": float(system.layout.period) if own.period else None,
    }


def _rates(seen: Seen, rows: list[tuple[int, int]], coordinates: Coordinates, n: int) -> dict[str, Any]:
    """Return the modes, n states each, and what becomes of Z at each instant but the first."""
    onto, back = coordinates.onto, coordinates.back
    states = len(onto) - len(back) + n
    modes = [seen.system.mode(seen.known[number].statuses) for number in modes_used(seen.log, rows)]
    return {
        "modes": [
            {
                "flow": (onto @ mode.flow @ back)[:states].tolist(),
                "functions": [coordinates.functional(each.row) for each in mode.functions],
            }
            for mode in modes
        ],
        "resets": [(onto @ _reset(seen, *row) @ back).tolist() for row in rows[1:]],
    }


def told_once(motion: dict[str, Any], *equations: dict[str, Any]) -> None:
    """Let each reset stand once, by its number."""
    named = [repr([each["resets"][k] for each in equations]) for k in range(len(motion["segments"]) - 1)]
    distinct = list(dict.fromkeys(named))
    for segment, name in zip(motion["segments"][1:], named, strict=True):
        segment["reset"] = distinct.index(name)
    for each in equations:
        each["resets"] = [each["resets"][named.index(name)] for name in distinct]


def modes_used(log: Any, rows: list[tuple[int, int]]) -> list[int]:
    """Return the numbers of the modes in which a motion is for some time."""
    return sorted({int(log.mode[last]) for _, last in rows})


def _require_covered(course: Course, system: System) -> None:
    own, layout = course.modes.system.layout, system.layout
    if (own.size, own.state_count, own.period > 0) != (layout.size, layout.state_count, layout.period > 0):
        raise UndecidedError("the orbit is one of another system")
    if layout.ramp or layout.drifts or len(layout.breaks):
        raise UndecidedError("forces that do not repeat with the drive are not covered")


def instants(seen: Seen, with_breaks: bool = False) -> Iterator[tuple[int, int]]:
    """Yield the first and the last row of each instant at which something happens."""
    row, log = 0, seen.log
    while row < len(log.start):
        following = end_of_instant(log, row) if row else 1
        last = following - 1
        goes_on = row > 0 and TICKED < log.function[row] < 0 and not (with_breaks and seen.breaks(row))
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
    log, impulses, n = seen.log, 0, seen.system.layout.state_count
    total = np.eye(log.state.shape[1])
    if seen.breaks(first):
        total[n:] = 0.0
        total[n:, -1] = log.state[first, n:]
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


def _demands(seen: Seen, row: int) -> list[Any]:
    """Return what is positive where a clock samples: how far each demand is from its limits."""
    if seen.fires(row) is not None or seen.breaks(row):
        return []
    (clock, number), rows = seen.clock(row), []
    sampled = seen.code(row) >> len(clock.limit)
    for c in reversed(range(len(clock.limit))):
        where, sampled = sampled % 4 - 1, sampled // 4
        demand, limit = clock.demand[number, c], np.zeros(seen.log.state.shape[1])
        limit[-1] = clock.limit[c]
        if where < 0 or not np.isfinite(limit[-1]):
            continue
        signs = {WITHIN: ((1, -1), (1, 1)), ABOVE: ((-1, 1),), BELOW: ((-1, -1),)}[where]
        rows += [of_limit * limit + of_demand * demand for of_limit, of_demand in signs]
    return rows


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
