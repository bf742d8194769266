"""The work of one cell: a mechanism with its values, what it settles to from its starts, and the measures."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from trimmer.arrays import Reals
from trimmer.errors import TrimmerError
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.maps.by_itself import CameTo, begins_alike, came_to, came_to_in_loop, measured
from trimmer.maps.cell_motion import CellMotion, same_motion
from trimmer.maps.inputs import Settings, varied
from trimmer.maps.measures import chosen, of_lines, of_orbit, of_window
from trimmer.maps.settle import Settled, on_orbit, settle
from trimmer.mechanism.coordinates import radius_of
from trimmer.mechanism.kinds import Kind
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.waves import reach_of
from trimmer.motion.flow import Flow
from trimmer.motion.subject import Subject
from trimmer.motion.time_scale import time_scale
from trimmer.response.flows import flow_of, is_silent
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.periodic.shooting import sizes_of
from trimmer.response.results.response import MotionKind
from trimmer.response.settling.settling import orbit_near
from trimmer.response.without_events.linear_lines import LinearLines
from trimmer.response.without_events.linear_motion import LinearMotion

FIRST_SCALE = 2.0
"""How far random starts of a loop go, in what its states reach from rest."""
WINDOW = 20
"""Drive periods over which a motion is measured that does not repeat."""


@dataclass(frozen=True)
class Cell:
    """One pair of values, and where its motions begin.

    Attributes:
        number: Its place in the map, row by row.
        values: Its values, in the order of the places.
        orbits: Orbits of other cells to begin with: states at the start of each drive period, (k, n) as
            tuples. If there are none, the starts of the settings are taken.
    """

    number: int
    values: tuple[float, ...]
    orbits: tuple[tuple[tuple[float, ...], ...], ...] = ()


@dataclass(frozen=True)
class CellResult:
    """The motions of a cell; the first one is that of the first start.

    Attributes:
        number: Place of the cell in the map, row by row.
        motions: The distinct motions, in the order in which they were met.
    """

    number: int
    motions: tuple[CellMotion, ...]


@dataclass(frozen=True)
class CellWork:
    """What is done with each cell of a map.

    Attributes:
        subject: The mechanism or loop that is varied.
        places: Places of the values.
        settings: How long each cell is looked at, and from where.
    """

    subject: Subject
    places: tuple[str, ...]
    settings: Settings

    def __call__(self, cell: Cell) -> CellResult:
        """Return the motions of a cell; what fails is told by the motion, and stops no other cell."""
        try:
            flow = flow_of(varied(self.subject, self.places, cell.values))
            starts = _starts(flow, cell, self.settings)
            if is_silent(flow.subject):
                return CellResult(cell.number, _searched(flow, self.settings))
        except (TrimmerError, ArithmeticError, np.linalg.LinAlgError) as error:
            return CellResult(cell.number, (_failed(error),))
        motions: list[CellMotion] = []
        keys = self.settings.measures
        for states in cell.orbits:
            _add(motions, _motion(flow, partial(_near, flow, np.array(states), self.settings), keys))
        for start in starts:
            if not flow.period:
                _add(motions, _by_itself(flow, start, self.settings))
                continue
            _add(motions, _motion(flow, partial(_settled, flow, start, self.settings), keys))
        return CellResult(cell.number, tuple(motions))


def _searched(flow: Flow, settings: Settings) -> tuple[CellMotion, ...]:
    """Return the stable motions of a loop that rests where it begins."""
    motions: list[CellMotion] = []
    for each in came_to_in_loop(flow):
        _add(motions, _told(flow, each, settings))
    return tuple(motions)


def _by_itself(flow: Flow, start: Instant, settings: Settings) -> CellMotion:
    try:
        return _told(flow, came_to(flow, start, settings.most_periods), settings)
    except (TrimmerError, ArithmeticError, np.linalg.LinAlgError) as error:
        return _failed(error)


def _told(flow: Flow, found: CameTo, settings: Settings) -> CellMotion:
    orbit, course = found.orbit, found.course
    if course is None:
        return CellMotion(found.kind)
    largest = None if orbit is None else float(abs(orbit.nontrivial_multipliers).max(initial=0.0))
    return CellMotion(
        found.kind,
        0 if orbit is None else 1,
        largest_multiplier=largest,
        lyapunov=found.lyapunov,
        states=_tuples((course.begin.state if orbit is None else begins_alike(flow, course))[None]),
        measures=measured(flow, found, settings.measures),
        neutral=found.neutral,
        holding=course.begin.statuses if found.kind is MotionKind.REST else (),
    )


def _settled(flow: Flow, start: Instant, settings: Settings) -> Settled:
    return settle(flow, start, settings.most_periods)


def _near(flow: Flow, states: Reals, settings: Settings) -> Settled:
    """Return the stable orbit near that of another cell, or what a start on that leads to."""
    start = flow.at(states[0])
    orbit = orbit_near(flow, start.state, start, len(states))
    if orbit is not None and orbit.stable:
        return on_orbit(orbit, 0)
    return _settled(flow, start, settings)


def _failed(error: Exception) -> CellMotion:
    return CellMotion(MotionKind.UNDECIDED, failure=str(error) or type(error).__name__)


def _starts(flow: Flow, cell: Cell, settings: Settings) -> list[Instant]:
    if cell.orbits:
        return []
    starts = [flow.rest()]
    if settings.starts > 1:
        random = np.random.default_rng(np.random.SeedSequence((settings.seed, cell.number)))
        scales = start_scales(flow)
        others = [scales * random.uniform(-1.0, 1.0, flow.size) for _ in range(settings.starts - 1)]
        starts += [flow.at(state, stretched=False) for state in others]
    return starts


def start_scales(flow: Flow) -> Reals:
    """Return how far random starts go: the largest amplitude or gap, and the speed of a drive with that.

    In a loop it is twice what its states reach from rest.
    """
    if not isinstance(flow.subject, Mechanism):
        # In the first periods of the drive from rest states become about as large as they will be.
        return np.asarray(FIRST_SCALE * sizes_of(flow.course(flow.rest(), WINDOW)))
    mechanism, layout, radius = flow.subject, flow.modes.system.layout, radius_of(flow.subject)
    amounts = {
        **{("pins", name): reach_of(pin) for name, pin in mechanism.pins.items()},
        **{("plays", name): play.gap for name, play in mechanism.plays.items()},
        **{("stops", name): stop.gap for name, stop in mechanism.stops.items()},
        **{("walls", name): wall.gap for name, wall in mechanism.walls.items()},
    }
    lengths = [
        abs(amount) * (radius if mechanism.kind_of(*part) is Kind.ROTATION else 1.0)
        for part, amount in amounts.items()
    ]
    scales = (max(lengths, default=0.0) or 1e-3) / layout.lengths
    bodies = len(mechanism.coordinates)
    scales[bodies : 2 * bodies] *= layout.omega or 2 * np.pi / time_scale(flow, flow.rest())
    return np.asarray(scales)


def _motion(flow: Flow, found: Callable[[], Settled], keys: tuple[str, ...]) -> CellMotion:
    try:
        settled = found()
        motion = _described(flow, settled)
        return motion if not keys or motion.measures is None else _measured(flow, settled, motion, keys)
    except (TrimmerError, ArithmeticError, np.linalg.LinAlgError) as error:
        return _failed(error)


def _measured(flow: Flow, settled: Settled, motion: CellMotion, keys: tuple[str, ...]) -> CellMotion:
    """Return a motion with further measures, over its period or over ``WINDOW`` drive periods."""
    assert motion.measures is not None
    orbit = settled.orbit
    if orbit is not None:
        rests = motion.kind is MotionKind.REST
        found = chosen(flow, orbit.course, orbit.periods, orbit.periods, keys, rests=rests)
    else:
        found = chosen(*flow.travelling(flow.course(settled.end, WINDOW)), 1, WINDOW, keys)
    return replace(motion, measures=replace(motion.measures, chosen=found))


def _described(flow: Flow, settled: Settled) -> CellMotion:
    if settled.kind is MotionKind.DIVERGING:
        return CellMotion(settled.kind, periods=settled.periods)
    if settled.ending is not Ending.REACHED_END:
        return CellMotion(settled.kind, periods=settled.periods, failure=settled.ending.value)
    if settled.orbit is not None:
        return _repeating(flow, settled.kind, settled.orbit, settled.periods)
    if settled.linear is not None:
        return _linear(settled, settled.linear)
    course = flow.course(settled.end, WINDOW)
    if course.ending is not Ending.REACHED_END:
        return CellMotion(settled.kind, periods=settled.periods, failure=course.ending.value)
    flow, course = flow.travelling(course)
    return CellMotion(
        settled.kind,
        periods=settled.periods,
        lyapunov=settled.lyapunov,
        states=_tuples(settled.end.state[None]),
        measures=of_window(flow, course, WINDOW),
    )


def _repeating(flow: Flow, kind: MotionKind, orbit: Orbit, periods: int) -> CellMotion:
    rests = kind is MotionKind.REST
    return CellMotion(
        kind,
        0 if rests else orbit.period_count,
        periods,
        float(abs(orbit.nontrivial_multipliers).max(initial=0.0)),
        states=_tuples(orbit.strobed[: orbit.period_count]),
        measures=of_orbit(flow, orbit.course, orbit.periods, rests=rests),
        neutral=orbit.neutral,
        holding=orbit.instant.statuses if rests else (),
    )


def _linear(settled: Settled, motion: LinearMotion) -> CellMotion:
    """Return a linear motion on a torus, with exact measures."""
    lines = LinearLines(motion)
    return CellMotion(
        settled.kind,
        periods=settled.periods,
        lyapunov=settled.lyapunov,
        states=_tuples(settled.end.state[None]),
        measures=of_lines(lines, motion),
        neutral=True,
    )


def _tuples(states: Reals) -> tuple[tuple[float, ...], ...]:
    return tuple(map(tuple, states.tolist()))


def _add(motions: list[CellMotion], motion: CellMotion) -> None:
    """Count a motion that is there already, or append it."""
    for place, other in enumerate(motions):
        if same_motion(motion, other):
            motions[place] = replace(other, starts=other.starts + motion.starts)
            return
    motions.append(motion)
