"""``respond``: what a mechanism settles to, from rest, a given state, or several starts."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import takewhile

import numpy as np

from trimmer.arguments import whole_number
from trimmer.deadline import NEVER, Deadline
from trimmer.errors import DivergingMotionError, OrbitNotFoundError
from trimmer.hybrid.stretch import Instant
from trimmer.loops.loops import Loop
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.time_scale import time_scale
from trimmer.response.by_itself.self_excited import LITTLE, self_excited
from trimmer.response.by_itself.slowing_down import slowing_down
from trimmer.response.by_itself.unrepeated import told_of_slowing, unrepeated
from trimmer.response.exact_orbit import diverges_by_pull, require_repeating
from trimmer.response.flows import flow_of, require_subject
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.periodic.pace import pace_of, periods_of
from trimmer.response.periodic.shooting import sizes_of
from trimmer.response.results.response import MotionKind, Response, SettledMotion
from trimmer.response.results.same import largest_states, same_motion, same_orbit, twins
from trimmer.response.settling.settling import Settling
from trimmer.response.settling.solved import at_rest, rest_of, settled_at_last
from trimmer.response.settling.verdict import SeenMotion, cut_short, grown, look_closely, unsettled
from trimmer.response.starts import Start, instant_of
from trimmer.response.without_events.linear_motion import linear_motion
from trimmer.response.without_events.rest import Rest

MOST_PERIODS = 1000  # Drive periods that are waited for a motion to settle, if no number is given
MORE = 10  # By how much longer is waited where all small distances shrink, or that to a stable orbit does
FURTHER = 16  # By how much longer a sampled machine is followed in which little happens, to see it slow down
LONG = 100  # Drive periods of settling beyond which a neighbouring start is tried too
AT_FIRST = 20
"""Drive periods, or periods of the slowest mode, in which an unknown motion shows how far it goes."""
INSTANTS = 64  # Instants in each of these
NEIGHBOUR = 1e-6  # Distance of the neighbouring start, as a share of the sizes of the states


def respond(
    mechanism: Mechanism | Loop,
    *,
    state: Start = None,
    starts: int = 1,
    most_periods: int | None = None,
    box: Mapping[str, tuple[float, ...]] | None = None,
    seed: int = 0,
    deadline: Deadline = NEVER,
) -> Response:
    """Find what a mechanism or a loop settles to.

    The motion is followed from its start. When it seems to come again after 1 to 24 drive periods, Newton's
    method finds the exact orbit; it is what the motion settles to if it is stable and the motion comes closer
    to it as its multipliers say. A motion that has not settled is watched: it is called chaotic if its
    largest Lyapunov exponent is positive by more than three standard errors and a neighbouring motion leaves
    it, a torus if that exponent is zero within narrow bounds and a neighbour stays, and otherwise undecided.

    Args:
        mechanism: The mechanism or loop.
        state: Where the first start begins, at t = 0: displacement, m, and velocity, m/s, by body, or states
            of a loop by name; or all states, (n,); rest, or the start of the mechanism, if not given.
        starts: Number of starts; those after the first one are random.
        most_periods: Drive periods to wait for a motion to settle, 1000 if not given; 16 samples for one,
            where these alone drive. Without a drive periods of the slowest mode, 1700 if not given, and up to
            27 300 where little happens in them.
        box: Largest modulus of displacement, m, and velocity, m/s, of each body, or of each state of a loop,
            in random starts; what they reach in the first motion if not given.
        seed: Of the random starts; the same one gives the same starts.
        deadline: After which no further random start is followed; ``Response.starts`` says how many were.

    Raises:
        WrongTypeError: if an argument is of another type.
        MechanismError, LoopError: if the state does not fit.
        UnsupportedMotionError: if a pin goes on for ever and leaves a stop.
    """
    require_subject(mechanism)
    whole_number("starts", starts, 1)
    if most_periods is not None:
        whole_number("most_periods", most_periods, 1)
    whole_number("seed", seed, 0)
    flow = flow_of(mechanism)
    if diverges_by_pull(mechanism):
        return Response(mechanism, (_pulled(starts),), starts, dict(box or {}), seed)
    require_repeating(flow)
    search = _Starts(flow, most_periods, [])
    begin = instant_of(flow, state)
    first = search.motion(begin)
    reached = dict(box) if box is not None else _reached(flow, first, begin)
    others = takewhile(lambda _: not deadline.passed, _random(flow, reached, starts - 1, seed))
    found = search.grouped(first, others)
    starts = sum(each.starts for each in found)
    shared = tuple(replace(each, share=each.starts / starts) for each in found)
    return Response(mechanism, shared, starts, reached, seed)


@dataclass(frozen=True, eq=False)
class _Starts:
    """The starts of one mechanism, and the stable orbits that they met."""

    flow: Flow
    most_periods: int | None
    known: list[Orbit]

    @property
    def _most_periods(self) -> int:
        return (self.most_periods or MOST_PERIODS) * pace_of(self.flow.subject)

    def motion(self, instant: Instant) -> SettledMotion:
        """Return what a start settles to."""
        if self.flow.period:
            found = self._driven(instant)
            waited = self.flow.period * found.drive_periods
        else:
            found, waited = self._by_itself(instant)
        if found.orbit is not None and found.orbit.edge is not None:
            edge = found.orbit.edge.told
            found = replace(found, message=f"{found.message} {edge[0].upper()}{edge[1:]}.")
        if found.rest is None:
            return found
        return replace(found, rest=self._in_place(found.rest, instant, waited))

    def _in_place(self, rest: Rest, instant: Instant, waited: float) -> Rest:
        """Return a rest where the start leads to: in the frame that was followed, leaders had not moved."""
        if not self.flow.shifts:
            return rest
        ground = self.flow.grounded()
        end = ground.timed(instant, waited).end if waited else instant
        motion = linear_motion(ground, end)
        limit, family = (end, True) if motion is None else (motion.limit, motion.free)
        return replace(rest, flow=ground, instant=limit, family=family)

    def _driven(self, instant: Instant) -> SettledMotion:
        settling, most_periods = Settling(self.flow, instant, self.known), self._most_periods
        longer = most_periods if pace_of(self.flow.subject) > 1 else MORE * most_periods
        orbit, seen = settling.until_settled(most_periods), None
        if orbit is None and settling.can_go_on and settling.approaches:
            orbit = settling.until_settled(longer)
        if orbit is None and settling.can_go_on:
            seen = look_closely(self.flow, settling.instant)
            if seen is not None and seen.grows(settling.periods):
                return grown(seen, settling.periods)
            if seen is not None and seen.contracts and self.flow.modes.system.layout.recurrence:
                orbit = settling.until_settled(longer)
        agrees = self._agrees(instant, orbit, settling.periods) if settling.periods > LONG else None
        if settling.rest is not None:
            return replace(at_rest(settling.rest, settling.periods), neighbour_agrees=None)
        if settling.solved is not None:
            return replace(settled_at_last(settling.solved, settling.periods), neighbour_agrees=agrees)
        slow = None if seen is None or seen.leaves else settling.slowly_approached(seen.window.end)
        if slow is not None:
            return _settled(slow, settling.periods, agrees, _slowly(slow))
        if orbit is None:
            return self._unsettled(settling, seen, instant, agrees)
        within = periods_of(self.flow.subject, settling.periods)
        told = f"It settles within {within} to {orbit.sentence}."
        if agrees is not None:
            other = "the same" if agrees else "something else"
            told += f" A start a little beside this one settles to {other}."
        return _settled(orbit, settling.periods, agrees, told)

    def _unsettled(
        self, settling: Settling, seen: SeenMotion | None, instant: Instant, agrees: bool | None
    ) -> SettledMotion:
        """Return what is known of a motion that was not seen to settle."""
        if seen is None:
            return cut_short(settling, agrees)
        slowing = self._slowing(instant, settling.periods + seen.window.periods)
        return slowing or unsettled(seen, settling.periods, agrees)

    def _slowing(self, instant: Instant, periods: int) -> SettledMotion | None:
        """Return a motion that slows down for ever, as one may that samples alone drive."""
        if pace_of(self.flow.subject) == 1:
            return None
        course = self.flow.course(instant, periods)
        seen = slowing_down([course])
        if seen is None and len(course.events) <= LITTLE:
            seen, periods = slowing_down(self._courses(instant, periods)), FURTHER * periods
        if seen is None:
            return None
        told = told_of_slowing(seen, self.flow.period * periods)
        return replace(_of_kind(MotionKind.UNDECIDED, periods, told), slowing=seen)

    def _courses(self, instant: Instant, periods: int) -> Iterator[Course]:
        for _ in range(FURTHER):
            course = self.flow.course(instant, periods)
            yield course
            instant = course.end

    def _by_itself(self, instant: Instant) -> tuple[SettledMotion, float]:
        """Return what a start settles to without a drive, and how long it was followed, s."""
        try:
            found = self_excited(self.flow, instant, self.most_periods)
        except OrbitNotFoundError as error:
            grows = isinstance(error, DivergingMotionError)
            kind = MotionKind.DIVERGING if grows else MotionKind.UNDECIDED
            return _of_kind(kind, 0, f"{str(error).capitalize()}."), 0.0
        if found.solved is not None:
            return settled_at_last(found.solved, found.waited), found.waited
        if found.rest is not None:
            return at_rest(found.rest, found.waited), found.waited
        if found.orbit is not None:
            told = _slowly(found.orbit) if found.slowly else f"It settles to {found.orbit.sentence}."
            return _settled(found.orbit, 0, None, told), found.waited
        return unrepeated(self.flow, found, self.most_periods), found.waited

    def _agrees(self, instant: Instant, orbit: Orbit | None, periods: int) -> bool:
        """Return whether a neighbouring start settles to the same orbit, or to none as well."""
        moving = self.flow.modes.system.layout.kinds[-1].stop
        state = instant.state.copy()
        state[:moving] += NEIGHBOUR * sizes_of(self.flow.course(instant, 1))[:moving]
        settling = Settling(self.flow, self.flow.at(state, like=instant), self.known)
        other = settling.until_settled(max(periods + LONG, self._most_periods))
        if orbit is None or other is None:
            return orbit is other
        return same_orbit(orbit, other)

    def grouped(self, first: SettledMotion, instants: Iterator[Instant]) -> list[SettledMotion]:
        """Return the different motions that starts settle to, with how many do."""
        found = [first]
        for instant in instants:
            motion = self.motion(instant)
            place = next((i for i, other in enumerate(found) if same_motion(motion, other)), None)
            if place is None:
                found.append(replace(motion, mirrored=any(_twins(motion, other) for other in found)))
            else:
                found[place] = replace(found[place], starts=found[place].starts + 1)
        return found


def _slowly(orbit: Orbit) -> str:
    """Say that a motion settles to an orbit, and how slowly small distances to it die out."""
    largest = float(abs(orbit.nontrivial_multipliers).max())
    halved = math.ceil(max(orbit.periods, 1) * math.log(0.5) / math.log(largest))
    time = periods_of(orbit.subject, halved) if orbit.periods else f"{halved * orbit.period:.3g} s"
    return (
        f"It settles to {orbit.sentence}, but so slowly that its end was not waited for: its distance was "
        f"seen to fall as the multipliers say, by half in {time}."
    )


def _of_kind(kind: MotionKind, periods: int, told: str) -> SettledMotion:
    return SettledMotion(kind, None, None, periods, None, told)


def _pulled(starts: int) -> SettledMotion:
    told = (
        "It diverges: a pin goes on for ever and pulls at a spring that something else holds, so that its "
        "force grows without end."
    )
    return SettledMotion(MotionKind.DIVERGING, None, None, 0, None, told, starts=starts)


def _settled(orbit: Orbit, periods: int, agrees: bool | None, told: str) -> SettledMotion:
    rest = rest_of(orbit)
    if rest is not None:
        return replace(at_rest(rest, periods), neighbour_agrees=agrees)
    return SettledMotion(MotionKind.PERIODIC, orbit, None, periods, agrees, told)


def _twins(motion: SettledMotion, other: SettledMotion) -> bool:
    return motion.orbit is not None and other.orbit is not None and twins(motion.orbit, other.orbit)


def _reached(flow: Flow, motion: SettledMotion, start: Instant) -> dict[str, tuple[float, ...]]:
    """Return the largest modulus of the states that a start gives, by name, in a motion.

    Of one that comes to rest, or of which nothing is known, they are those on its way, at first.
    """
    if motion.orbit is not None:
        # The sizes of an orbit are those at its events, which say little where there are none.
        sizes = motion.orbit.sizes if motion.orbit.course.events else largest_states(motion.orbit)
    elif motion.linear is not None:
        sizes = motion.linear.reach
    elif motion.window is not None:
        sizes = motion.window.sizes
    else:
        course = flow.timed(start, AT_FIRST * (flow.period or time_scale(flow, start)))
        times = np.linspace(0.0, course.duration, AT_FIRST * INSTANTS)
        sizes = abs(course.states(times)[:, : flow.size]).max(axis=0)
    return {name: tuple(sizes[list(places)].tolist()) for name, places in flow.axes.items()}


def _random(flow: Flow, box: Mapping[str, tuple[float, ...]], count: int, seed: int) -> Iterator[Instant]:
    numbers = np.random.default_rng(seed)
    for _ in range(count):
        state = {name: tuple(each * numbers.uniform(-1, 1) for each in reach) for name, reach in box.items()}
        yield flow.near(state)
