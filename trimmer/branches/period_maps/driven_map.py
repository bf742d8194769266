"""The map of a period of a mechanism or a loop over one of its numbers."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import cast

from trimmer.arrays import Reals
from trimmer.branches.period_maps.driven_passage import DrivenPassage
from trimmer.branches.period_maps.flows import Flows
from trimmer.errors import TrimmerError, UnsupportedMotionError
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.kept_property import cached_property
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.part import mirrored
from trimmer.motion.subject import Subject
from trimmer.response.flows import known_flow_of

DIFFERENCE = 1e-7  # Relative difference of the value from which the derivative by it is taken
MOST_STEPS = 200_000  # Steps of a passage, after which it counts as one that cannot be followed


@dataclass(frozen=True, eq=False)
class DrivenMap:
    """The map of some drive periods, or of half of them with the mirror image of the end."""

    subject: Subject  # What moves; it has a frequency
    place: str  # Dotted place of the number that is varied
    scale: float  # Magnitude of the number, in its unit, for differences
    periods: int = 1  # Drive periods after which the motion repeats; odd, if mirrored
    mirrored: bool = False  # Whether half a period is followed and the end taken with changed signs
    single: DrivenMap | None = None  # The map of which this is two passages; None if it was not doubled
    # Time after the start of a drive period at which a passage begins, in drive periods; None where it begins
    # with a drive period because nothing else was chosen yet
    share: float | None = None
    flows: Flows = field(default=cast("Flows", None), repr=False)  # What moves, over the number

    def __post_init__(self) -> None:
        flows = self.flows
        if flows is None or flows.subject is not self.subject or flows.place != self.place:
            object.__setattr__(self, "flows", Flows(self.subject, self.place))

    @property
    def doublings(self) -> int:
        """How often the passage was doubled."""
        return 0 if self.single is None else self.single.doublings + 1

    def doubled(self) -> DrivenMap:
        """Return the map of two passages; that of a mirrored map is a whole period without mirror."""
        periods = self.periods if self.mirrored else 2 * self.periods
        return replace(self, periods=periods, mirrored=False, single=self)

    @property
    def length(self) -> float:
        """Length of a passage in drive periods."""
        return 0.5 * self.periods if self.mirrored else float(self.periods)

    def begun_at(self, share: float) -> DrivenMap:
        """Return the map of passages that begin a share of a drive period after its start."""
        single = None if self.single is None else self.single.begun_at(share)
        return replace(self, share=share, single=single)

    @cached_property
    def size(self) -> int:
        """Number of states."""
        return known_flow_of(self.subject).size

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism, if it is one that moves."""
        return cast("Mechanism", self.subject)

    @cached_property
    def is_mirror_symmetric(self) -> bool:
        """Whether the mirror image of a motion is a motion, half a period of the drive later."""
        return known_flow_of(self.subject).is_mirror_symmetric

    def flow(self, value: float) -> Flow:
        """Return the motion with a value of the number.

        Raises:
            MechanismError, LoopError: if the number cannot have that value.
        """
        return self.flows.at(value)

    def passage(self, value: float, state: Reals) -> DrivenPassage:
        """Follow the motion from a state over the periods.

        What is in contact or sticks at the end does so at the beginning too: a state that is not known to
        the last digit does not say it by itself.

        Raises:
            UnsupportedMotionError: if the motion cannot be followed.
            MechanismError, LoopError: if the number cannot have that value.
        """
        flow = self.flow(value)
        return DrivenPassage(self, value, flow, *self.followed(flow, state))

    def followed(self, flow: Flow, state: Reals, duration: float = 0.0) -> tuple[Instant, Course]:
        """Return the motion from a state, for a duration, s, if that is given, and the instant it begins at.

        Raises:
            UnsupportedMotionError: if the motion cannot be followed.
        """
        # Where in a direction along which no force changes an orbit lies does not matter: leaders are at 0.
        state = flow.reduced(state)
        near = self.flows.near.get(self._kind(flow))
        found = None if near is None else self._repeated(flow, state, near, duration)
        if found is not None:
            return found
        begin = flow.at(state, self._phase(flow))
        course = self.course(flow, begin, duration)
        if self.statuses_returned(flow, course.end) == begin.statuses:
            return begin, course
        return self._repeated(flow, state, self.returned(flow, course.end), duration) or (begin, course)

    def _kind(self, flow: Flow) -> tuple[float | None, float, int]:
        """Return what passages of one kind share; a part may appear or vanish with the number."""
        return self.share, self.length, len(flow.parts)

    def begin_near(self, flow: Flow, course: Course) -> None:
        """Let passages begin with the statuses of an orbit, if they end with them too."""
        self.flows.near[self._kind(flow)] = self.returned(flow, course.end)

    def _repeated(
        self, flow: Flow, state: Reals, final: Instant, duration: float
    ) -> tuple[Instant, Course] | None:
        """Return the motion that begins with the statuses of an end, if it ends with them again."""
        begin = flow.at(state, self._phase(flow), like=final)
        try:
            course = self.course(flow, begin, duration)
        except UnsupportedMotionError:
            return None
        return (begin, course) if self.statuses_returned(flow, course.end) == final.statuses else None

    def _phase(self, flow: Flow) -> float:
        """Return the time after the start of a drive period at which a passage begins, s."""
        return (self.share or 0.0) % 1.0 * flow.period

    def phases(self, value: float, state: Reals) -> list[Reals]:
        """Return the states at which a passage begins, of the orbit with a state at the start of a period."""
        if not self.share:
            return [state]
        flow = self.flow(value)
        return [flow.timed(flow.at(state), self.share * flow.period, MOST_STEPS).end.state]

    def neighbour(self, value: float) -> tuple[float, Subject]:
        """Return a value a little off, and the subject with that value.

        Raises:
            MechanismError, LoopError: if the number can have neither of the neighbouring values.
        """
        step = DIFFERENCE * self.scale
        try:
            return value + step, self.subject.with_value(self.place, value + step)
        except TrimmerError:
            return value - step, self.subject.with_value(self.place, value - step)

    def course(self, flow: Flow, begin: Instant, duration: float = 0.0) -> Course:
        """Follow the motion from an instant over the periods, or for a duration, s, where one is given.

        Raises:
            UnsupportedMotionError: if the motion cannot be followed.
        """
        if duration:
            course = flow.timed(begin, duration, MOST_STEPS)
        elif self.mirrored:
            course = flow.timed(begin, 0.5 * self.periods * flow.period, MOST_STEPS)
        else:
            course = flow.course(begin, self.periods, MOST_STEPS)
        if course.ending is not Ending.REACHED_END:
            raise UnsupportedMotionError(
                f"the motion ends after {course.duration:.6g} s: {course.ending.value}"
            )
        return course

    def returned(self, flow: Flow, end: Instant) -> Instant:
        """Return an end as the beginning of the next passage."""
        if not self.mirrored:
            return end
        statuses = self.statuses_returned(flow, end)
        return replace(end, state=flow.mirrored_states * end.state, statuses=statuses)

    def statuses_returned(self, flow: Flow, end: Instant) -> tuple[int, ...]:
        """Return the statuses at an end as those at the beginning of the next passage."""
        return mirrored(flow.parts, end.statuses) if self.mirrored else end.statuses
