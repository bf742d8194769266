"""The exact orbit of a mechanism or a loop for values of its unknown numbers, as lines of its outputs."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.errors import TrimmerError
from trimmer.fitting.unknowns import Unknown, values_at
from trimmer.hybrid.stretch import Instant
from trimmer.motion.flow import Flow
from trimmer.motion.fourier import fourier
from trimmer.motion.signals import read
from trimmer.motion.subject import Subject
from trimmer.response.by_itself.orbit_by_itself import orbit_by_itself
from trimmer.response.flows import flow_of
from trimmer.response.periodic.orbit import Orbit, orbit_of
from trimmer.response.periodic.shooting import Patience, Return, solve
from trimmer.response.settling.settling import Settling

SETTLED_WITHIN = 400  # Drive periods in which a motion has to settle from its start
GOES_ON = 48  # Drive periods in which it has to settle again where it has lost its stability, or has vanished
PATIENCE = Patience(iterations=12, halvings=4, followed=2)
"""With which an orbit is continued from a neighbouring one."""


@dataclass(frozen=True, eq=False)
class ModelMotion:
    """A stable periodic motion of a model at its coordinates, (unknowns,), with lines, (m, outputs)."""

    coordinates: Reals
    orbit: Orbit
    lines: Complexes


@dataclass(frozen=True, eq=False)
class Model:
    """The motion of a mechanism or a loop over its unknown numbers."""

    subject: Subject  # The mechanism or loop, driven at the measured frequency, or without a drive
    unknowns: Sequence[Unknown]  # The numbers
    outputs: tuple[str, ...]  # Names of the outputs that are measured
    derivatives: tuple[int, ...]  # How often each of them is differentiated
    period_count: int  # Drive periods k after which the motion is to repeat
    count: int  # Number m of lines

    def subject_at(self, coordinates: Reals) -> Subject:
        """Return the mechanism or loop with the numbers of coordinates, (unknowns,)."""
        subject = self.subject
        for unknown, value in zip(self.unknowns, values_at(self.unknowns, coordinates), strict=True):
            subject = subject.with_value(unknown.place, value)
        return subject

    @property
    def by_itself(self) -> bool:
        """Whether it has no drive, so that the period is one of its own numbers."""
        return self.subject.frequency is None

    def settled(self, coordinates: Reals) -> ModelMotion | None:
        """Return what it settles to from its start; None if that repeats otherwise, or never.

        Of a loop without a drive it is an orbit that was searched for.
        """
        flow = self._flow(coordinates)
        if flow is not None and self.by_itself:
            return self._found(flow, coordinates)
        return None if flow is None else self._settled(flow, coordinates, flow.rest(), SETTLED_WITHIN)

    def continued(self, coordinates: Reals, near: ModelMotion, settling: int = GOES_ON) -> ModelMotion | None:
        """Return the stable motion that goes on from that of neighbouring numbers; None if there is none.

        Where the motion has lost its stability or vanished, it is followed from there to what it settles to,
        for at most so many drive periods.
        """
        flow = self._flow(coordinates)
        if flow is None:
            return None
        instant = flow.at(near.orbit.instant.state, like=near.orbit.instant)
        found = self._solved(flow, coordinates, instant, near.orbit.period)
        if found is not None or not settling:
            return found
        if self.by_itself:
            return self._found(flow, coordinates)
        return self._settled(flow, coordinates, instant, settling)

    def _found(self, flow: Flow, coordinates: Reals) -> ModelMotion | None:
        try:
            orbit = orbit_by_itself(flow)
        except TrimmerError:
            return None
        return self._solved(flow, coordinates, orbit.instant, orbit.period)

    def _flow(self, coordinates: Reals) -> Flow | None:
        try:
            return flow_of(self.subject_at(coordinates))
        except TrimmerError:
            return None

    def _settled(self, flow: Flow, coordinates: Reals, instant: Instant, within: int) -> ModelMotion | None:
        orbit = Settling(flow, instant).until_settled(within)
        if orbit is None or self.period_count % orbit.period_count:
            return None
        return self._solved(flow, coordinates, orbit.instant)

    def _solved(
        self, flow: Flow, coordinates: Reals, instant: Instant, period: float = 0.0
    ) -> ModelMotion | None:
        periods = 0 if self.by_itself else self.period_count
        shot = solve(Return(flow, periods), instant, period, PATIENCE)
        if shot is None:
            return None
        orbit = orbit_of(flow, shot, periods)
        if not (orbit.stable or orbit.neutral):
            return None
        return ModelMotion(coordinates, orbit, self._lines(orbit))

    def _lines(self, orbit: Orbit) -> Complexes:
        course = orbit.course
        nodes = course.nodes
        signals = read(course, [orbit.flow.outputs[each] for each in self.outputs], nodes.rows, nodes.states)
        omega = 2 * np.pi / course.duration
        orders = np.arange(1, self.count + 1)[:, None]
        lines = fourier(course, signals - signals.mean(axis=0), omega, self.count)
        return np.asarray(lines * (1j * omega * orders) ** np.array(self.derivatives))
