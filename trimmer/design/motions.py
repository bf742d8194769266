"""The motions that a mechanism can take: from several starts, and from the motions of its neighbours."""

import math
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.deadline import NEVER, Deadline
from trimmer.design.analysis.found_motion import FoundMotion, of_orbit, of_settled, of_steps, of_switching
from trimmer.design.analysis.found_step import step_responses
from trimmer.design.settings import DesignSettings
from trimmer.design.specification.targets import followers, has_profile
from trimmer.design.varied_places import VariedNumber
from trimmer.errors import TrimmerError, UnsupportedMotionError
from trimmer.maps.cell_motion import CellMotion
from trimmer.maps.coexistence import coexisting_motions
from trimmer.maps.motion_map import motion_map
from trimmer.mechanism.mechanism import Mechanism
from trimmer.response.exact_orbit import diverges_by_pull, exact_orbit
from trimmer.response.flows import flow_of
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.respond import respond
from trimmer.response.results.response import MotionKind
from trimmer.response.results.same import same_orbit
from trimmer.runners.runner import Runner

PACE = 24  # Drive periods over which the pace is measured
FEWEST = 60  # Drive periods that are followed whatever time there is
REACH = 0.3  # How far neighbours lie around the working point at most, relative, along each of two numbers


@dataclass(frozen=True)
class Neighbours:
    """The neighbours of the working point whose motions were tried.

    Attributes:
        places: The two numbers that were varied.
        cells: How many neighbours there were, the working point included.
        reach: How far the farthest one lies, relative.
        tried: How many of their orbits were tried as starts.
        rounds: How often orbits were handed on.
        complete: Whether the last round found nothing new.
        found: How many motions of the working point came from there alone.
    """

    places: tuple[str, str]
    cells: int
    reach: float
    tried: int
    rounds: int
    complete: bool
    found: int


@dataclass(frozen=True)
class Motions:
    """The motions to which a mechanism was found to settle.

    Attributes:
        found: The first is that from rest, or from the file's own start, if it could be measured.
        starts: Number of starts.
        seed: Of the random ones.
        lost: How many motions could not be followed or measured.
        message: What the first start settles to, in a sentence.
        first_failed: Whether that of the first start is among the lost ones.
        neighbours: What was tried around; None if nothing was.
    """

    found: tuple[FoundMotion, ...]
    starts: int
    seed: int
    lost: int
    message: str
    first_failed: bool
    neighbours: Neighbours | None = None

    @property
    def first(self) -> FoundMotion | None:
        """The motion of the first start; None if it could not be measured."""
        return None if self.first_failed or not self.found else self.found[0]


def periods_within(mechanism: Mechanism, most: int, seconds: float) -> int:
    """Return for how many drive periods some seconds suffice at the pace of the first ones, ``most`` at most.

    A few are followed whatever time there is, then twice as many and so on, so that a run again, whose pace
    is not quite the same, finds what was kept; without a drive there are none to count.
    """
    by_itself = mechanism.frequency is None or has_profile(mechanism)
    if seconds == np.inf or by_itself or diverges_by_pull(mechanism):
        return most
    flow = flow_of(mechanism)
    if flow.modes.system.layout.ramp:
        return most
    flow.strobe(flow.rest(), 1)  # the kernels are loaded at the first call
    begun = time.perf_counter()
    flow.strobe(flow.rest(), PACE)
    pace = (time.perf_counter() - begun) / PACE
    doublings = int(math.log2(max(seconds / pace / FEWEST, 1.0)))
    return min(most, FEWEST << doublings)


def motions_from_starts(
    mechanism: Mechanism, settings: DesignSettings, deadline: Deadline = NEVER, *, switched: bool = False
) -> Motions:
    """Return what several starts settle to; after the deadline no further one is followed.

    Of a machine that switches it is what it does from its start until it rests; so it is without a drive, if
    contacts of it close before it rests, or it is not seen to settle.
    """
    if switched or has_profile(mechanism):
        return _switched(mechanism, settings)
    steps = followers(mechanism)  # which begin as the file says
    starts = settings.starts if mechanism.frequency is not None and not steps else 1
    response = respond(
        mechanism, starts=starts, seed=settings.seed, most_periods=settings.most_periods, deadline=deadline
    )
    starts = response.starts
    if steps:
        first = of_steps(step_responses(mechanism, response), response.motion)
        there = () if first is None else (first,)
        return Motions(there, 1, settings.seed, 1 - len(there), response.motion.message, first is None)
    found = [of_settled(each) for each in response.motions]
    measured = tuple(each for each in found if each is not None)
    lost = len(found) - len(measured)
    closing = mechanism.plays or mechanism.stops or mechanism.walls
    ended = found[0] is None or found[0].kind is MotionKind.REST
    if mechanism.frequency is None and closing and ended and response.motion.kind is not MotionKind.DIVERGING:
        return _switched(mechanism, settings)
    return Motions(measured, starts, settings.seed, lost, response.motion.message, found[0] is None)


def _switched(mechanism: Mechanism, settings: DesignSettings) -> Motions:
    try:
        motion = of_switching(mechanism)
    except UnsupportedMotionError as error:
        return Motions((), 1, settings.seed, 1, f"{str(error).capitalize()}.", first_failed=True)
    return Motions((motion,), 1, settings.seed, 0, "", first_failed=False)


def with_neighbours(
    mechanism: Mechanism,
    motions: Motions,
    varied: tuple[VariedNumber, ...],
    settings: DesignSettings,
    runner: Runner,
) -> Motions:
    """Return the motions with those that orbits of neighbouring mechanisms, in two numbers, lead to."""
    if len(varied) < 2 or any(each.value == 0 for each in varied[:2]):
        return motions
    values = {each.place: _around(each, settings.neighbours) for each in varied[:2]}
    result = motion_map(mechanism, values, most_periods=settings.cell_periods, runner=runner, quiet=True)
    coexistence = coexisting_motions(result, most_rounds=40, runner=runner, quiet=True)
    columns, rows = (list(each) for each in values.values())
    column, row = (near.index(each.value) for near, each in zip((columns, rows), varied, strict=False))
    centre = coexistence.result.cells[row * len(columns) + column]
    new = tuple(_new(mechanism, centre.motions, motions))
    first, second = values
    neighbours = Neighbours(
        places=(first, second),
        cells=len(result.cells),
        reach=REACH,
        tried=coexistence.tried,
        rounds=coexistence.rounds,
        complete=coexistence.complete,
        found=len(new),
    )
    return replace(motions, found=(*motions.found, *new), neighbours=neighbours)


def _around(varied: VariedNumber, count: int) -> tuple[float, ...]:
    """Return an odd number of values around that of the file, which is the middle one.

    Those out of range are drawn in. In the middle the share is nothing beside 1, so that the value is exact.
    """
    shares = np.linspace(-REACH, REACH, count) if count > 1 else np.zeros(1)
    if varied.bounded:
        room = varied.highest / varied.value - 1
        shares = np.where(shares > 0, shares / REACH * min(room, REACH), shares)
    return tuple(dict.fromkeys((varied.value * (1 + shares)).tolist()))


def _new(mechanism: Mechanism, motions: tuple[CellMotion, ...], known: Motions) -> Iterator[FoundMotion]:
    """Yield the periodic motions of a cell that are not known yet, as exact orbits."""
    again = (_orbit(mechanism, each.period_count or 1, each.state) for each in known.found if each.repeats)
    seen = [orbit for orbit in again if orbit is not None]
    for motion in motions:
        if motion.kind is not MotionKind.PERIODIC:
            continue
        orbit = _orbit(mechanism, motion.period_count, np.array(motion.states[0]))
        if orbit is None or not (orbit.stable or orbit.neutral):
            continue
        if not any(same_orbit(orbit, other) for other in seen):
            seen.append(orbit)
            yield of_orbit(orbit)


def _orbit(mechanism: Mechanism, periods: int, state: Reals) -> Orbit | None:
    """Return the orbit at a state, (n,), over so many drive periods; None if there is none."""
    try:
        orbit = exact_orbit(mechanism, periods, state)
    except TrimmerError:
        return None
    return orbit if orbit.success else None
