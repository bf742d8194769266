"""Following the exact periodic motions of a mechanism over any of its numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arguments import real_array, require_instance, whole_number
from trimmer.arrays import Complexes, Reals
from trimmer.branches.branch import Branch, BranchEnd, BranchPoint
from trimmer.branches.continuation import continuation
from trimmer.branches.mechanism_map import MechanismMap, MechanismPassage
from trimmer.branches.mirror import is_mirror_symmetric
from trimmer.branches.outputs import OutputMeasure, body_coefficients, output_measures
from trimmer.branches.self_excited_map import SelfExcitedMap, with_trivial
from trimmer.branches.settings import DEFAULT, FollowSettings
from trimmer.branches.special import SpecialPoint
from trimmer.contact.flow import ExactFlow
from trimmer.errors import MechanismError, OrbitNotFoundError, UnsupportedMotionError
from trimmer.harmonics.balance import harmonic_balance_of
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.messages import listed
from trimmer.response.forced_orbit import mechanism_orbit, require_repeating
from trimmer.response.orbit import NEUTRAL, MechanismOrbit
from trimmer.response.self_excited import self_excited_orbit
from trimmer.response.settling import orbit_from_rest

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

SYMMETRIC = 1e-6
"""Difference of half a period and its mirror image, relative to the sizes, within which they are the same."""


@dataclass(frozen=True, eq=False)
class BalancedOrbit:
    """The same orbit by multi-harmonic balance.

    Attributes:
        distance: Root mean square of the difference from the exact displacements, relative to those, of the
            body where it is largest; a number.
        converged: Whether the forces balance.
    """

    distance: float
    converged: bool


@dataclass(frozen=True, eq=False)
class FollowedOrbit:
    """An exact periodic motion on a branch.

    Attributes:
        point: The orbit on the branch: value, state, multipliers, stability.
        map: The map of its whole period.
    """

    point: BranchPoint
    map: MechanismMap

    @property
    def value(self) -> float:
        """Value of the number that is varied, in its unit."""
        return self.point.value

    @property
    def state(self) -> Reals:
        """State at the start of a drive period, (n,); without a drive any, and the period last, (n + 1,).

        The period is that before it doubled, if it did.
        """
        return self.point.state

    @property
    def stable(self) -> bool:
        """Whether neighbouring motions approach it."""
        return self.point.stable

    @property
    def multipliers(self) -> Complexes:
        """Floquet multipliers by falling modulus, (n,).

        Without a drive one of them is 1, since the motion may be shifted in time; ``stable`` leaves it out.
        """
        multipliers = self.point.multipliers
        return with_trivial(multipliers) if isinstance(self.map, SelfExcitedMap) else multipliers

    @property
    def periods(self) -> int:
        """Drive periods after which it repeats; without a drive 1, and 2, 4, … where periods have doubled."""
        return self.map.periods

    @property
    def period(self) -> float:
        """Time after which it repeats, s."""
        if isinstance(self.map, SelfExcitedMap):
            return self.periods * float(self.point.state[-1])
        return self.periods * self.map.flow(self.value).period

    @property
    def events_per_period(self) -> float:
        """Events in a drive period, the mean over the orbit; without a drive over its period."""
        return self.point.events / (1 if isinstance(self.map, SelfExcitedMap) else self.periods)

    @cached_property
    def passage(self) -> MechanismPassage:
        """The motion over its period."""
        return self.map.passage(self.point.value, self.point.state)

    @cached_property
    def outputs(self) -> Mapping[str, OutputMeasure]:
        """Peak to peak and harmonics of each output."""
        return output_measures(self.map.mechanism, self.passage.course)

    def balanced(self, harmonics: int) -> BalancedOrbit:
        """Balance the forces harmonic by harmonic from the orbit on, and say how far the result is from it.

        Args:
            harmonics: Harmonics of the drive up to which the forces balance.

        Raises:
            UnsupportedMotionError: if a spring leans on a pin that moves on, or there is no drive.
        """
        if isinstance(self.map, SelfExcitedMap):
            raise UnsupportedMotionError(
                "harmonic balance runs beside driven motions only, and the mechanism has no frequency; leave it out"
            )
        course = self.passage.course
        exact = body_coefficients(course, self.periods, self.periods * harmonics)
        balance = harmonic_balance_of(self.passage.flow.mechanism, exact, self.periods)
        moved = course.nodes.states[:, : len(exact)] - exact[:, 0].real
        power = course.nodes.weights @ moved**2 / course.duration
        # What the exact motion has beyond the last harmonic is a part of the difference.
        beyond = np.maximum(power - _power(exact), 0.0)
        apart = _power(balance.coefficients - exact) + beyond
        distance = float(np.sqrt((apart / np.where(power > 0.0, power, 1.0)).max()))
        return BalancedOrbit(distance, balance.converged)


def _power(harmonics: Complexes) -> Reals:
    """Return the mean square of displacements without their mean, (bodies,)."""
    power: Reals = 0.5 * (abs(harmonics[:, 1:]) ** 2).sum(axis=1)
    return power


@dataclass(frozen=True, eq=False)
class FollowedBranch:
    """A branch of exact periodic motions of a mechanism over one of its numbers.

    Attributes:
        map: The map of the whole period of its motions, with the mechanism and the place of the number.
        points: The motions, in the order in which they were followed.
        special: The special points, in the same order.
        reason: Why the branch ends.
        message: The same as a sentence.
        branches: Branches that part from this one at period doubling and symmetry breaking, and those that
            it joins there.
        parted: The special point at which this one parts from another; None if it was begun by itself.
    """

    map: MechanismMap
    points: tuple[FollowedOrbit, ...]
    special: tuple[SpecialPoint, ...]
    reason: BranchEnd
    message: str
    branches: tuple[FollowedBranch, ...] = ()
    parted: SpecialPoint | None = None

    @property
    def periods(self) -> int:
        """Drive periods after which the motions repeat."""
        return self.map.periods

    @property
    def unit(self) -> str:
        """SI unit of the number that is varied; Hz for a frequency."""
        return self.map.mechanism.places[place_text(parse_place(self.map.place))]

    def outputs_at(self, special: SpecialPoint) -> Mapping[str, OutputMeasure]:
        """Return peak to peak and harmonics of each output at a special point of the branch."""
        course = self.map.passage(special.value, special.state).course
        return output_measures(self.map.mechanism, course)

    @property
    def success(self) -> bool:
        """Whether it was followed to an end of the interval, around, or to one that it joins."""
        return self.reason.is_success


def follow(
    mechanism: Mechanism,
    place: str,
    start: float | str,
    stop: float | str,
    *,
    periods: int | None = None,
    state: ArrayLike | None = None,
    settings: FollowSettings = DEFAULT,
) -> FollowedBranch:
    """Follow a branch of exact periodic motions of a mechanism over one of its numbers.

    It begins with what the mechanism settles to from rest at ``start``, goes towards ``stop``, and ends on
    leaving the interval at either end. A motion that is its own mirror image half a period later is followed
    as such; of the two asymmetric branches that part from it, which are mirror images, one is followed. Where
    a branch of asymmetric motions joins the symmetric one, it goes on along that towards ``stop``, and the
    other side of the symmetric one is followed as a branch that parts.

    A mechanism without a frequency moves by itself. Then the period is an unknown of each orbit; the
    multiplier that is 1, since the motion may be shifted in time, has no say in stability and special points.

    Args:
        mechanism: The mechanism.
        place: Dotted place of the number, such as ``frequency`` or ``plays.bridge.gap``.
        start: First value in SI units (Hz for a frequency), or text with its unit.
        stop: The other end of the interval.
        periods: Drive periods after which the motion repeats; by default those after which it does.
        state: State at the start of a drive period from which to begin instead, shape (n,); see
            ``trimmer.contact.flow.ExactFlow.names`` for its entries. Without a drive a state anywhere on the
            motion and its period, s, shape (n + 1,), as ``FollowedOrbit.state``.
        settings: How to follow it.

    Returns:
        The branch. If the mechanism does not settle, it has no points and a message that says so.

    Raises:
        MechanismError: if there is no such number, or it cannot have these values.
        UnsupportedMotionError: if the mechanism never repeats, because a pin goes on for ever and pulls.
        WrongTypeError: if an argument has another type.
        ValueError: if start and stop are equal, a number is out of its range, or ``periods`` is given without
            a drive.

    Sources:
        Allgower and Georg, Introduction to Numerical Continuation Methods, 2003; Leine and Nijmeijer,
        Dynamics and Bifurcations of Non-Smooth Mechanical Systems, 2004.
    """
    require_instance("mechanism", mechanism, Mechanism, "a trimmer.Mechanism")
    if periods is not None:
        whole_number("periods", periods, 1)
    begin, end = (mechanism.with_value(place, each).value(place) for each in (start, stop))
    if begin == end:
        raise MechanismError(f"{place}: the interval has no length, from {begin:.10g} to {begin:.10g}")
    if place.endswith(".order"):
        raise MechanismError(f"{place}: orders are whole numbers, so that nothing lies between two of them")
    at_start = mechanism.with_value(place, begin)
    for each in (at_start, mechanism.with_value(place, end)):
        require_repeating(ExactFlow(each))
    scale = max(abs(begin), abs(end))
    if at_start.frequency is None:
        if periods is not None:
            raise ValueError(f"periods is {periods}, but the mechanism has no drive whose periods could count")
        return _self_excited(SelfExcitedMap(at_start, place, scale), begin, end, state, settings)
    map = MechanismMap(at_start, place, scale, periods or 1)
    if state is None:
        orbit = _orbit_at_start(at_start, settings.most_periods, periods)
        if orbit is None:
            message = _unsettled(begin, settings.most_periods)
            return FollowedBranch(map, (), (), BranchEnd.NO_START, message)
        map, first = replace(map, periods=periods or orbit.periods), orbit.instant.state
    else:
        first = real_array("state", state)
    map = _fitting(map, begin, first)
    branch = continuation(map, first, begin, end, settings)
    if branch.reason is BranchEnd.NO_START and state is None:
        branch = replace(branch, message=_unsettled(begin, settings.most_periods))
    base = map
    while base.single is not None:
        base = base.single
    return _followed(branch, base)


def _self_excited(
    map: SelfExcitedMap, begin: float, end: float, state: ArrayLike | None, settings: FollowSettings
) -> FollowedBranch:
    """Follow a mechanism that moves by itself, from what it settles to, or from a state and period."""
    flow = map.flow(begin)
    if state is None:
        try:
            orbit = self_excited_orbit(flow, flow.rest())
        except OrbitNotFoundError as error:
            message = f"at {begin:.10g} there is no motion to begin with: {error}"
            return FollowedBranch(map, (), (), BranchEnd.NO_START, message)
        first = np.append(orbit.instant.state, orbit.period)
    else:
        first = real_array("state", state)
        if first.shape != (map.size,):
            raise MechanismError(
                f"the start has the shape {first.shape}, but without a drive it is {map.size - 1} states "
                f"and the period: {listed((*flow.names, 'period'))}"
            )
    passage = map.passage(begin, first)
    if abs(np.linalg.eigvals(passage.monodromy) - 1.0).min() <= NEUTRAL:
        reason = BranchEnd.NOT_ISOLATED
        return FollowedBranch(map, (), (), reason, f"{reason.value}, at {begin:.10g}")
    doubled = map
    for _ in range(passage.halvings):
        doubled, first = doubled.doubled(), np.append(first[:-1], 0.5 * first[-1])
    return _followed(continuation(doubled, first, begin, end, settings), map)


def _orbit_at_start(mechanism: Mechanism, most_periods: int, periods: int | None) -> MechanismOrbit | None:
    """Return what a mechanism settles to, or an orbit of a given number of periods, stable or not."""
    if periods is None:
        return orbit_from_rest(mechanism, most_periods)
    try:
        orbit = mechanism_orbit(mechanism, periods)
    except OrbitNotFoundError:
        return None
    return orbit if orbit.success else None


def _unsettled(begin: float, most_periods: int) -> str:
    return (
        f"from rest at {begin:.10g} the motion has not settled within {most_periods} drive periods; begin at "
        "another value, give the number of periods after which it shall repeat, or wait longer"
    )


def _fitting(map: MechanismMap, value: float, state: Reals) -> MechanismMap:
    """Return the map whose orbits a motion can join and leave, doubled so often that the motion is its orbit.

    A motion that is its own mirror image is an orbit of half a period already. Where the number of periods
    was given, and the motion repeats after half of it, nothing is doubled.
    """
    if map.periods % 2 == 0:
        half = replace(map, periods=map.periods // 2)
        return map if _repeats(half, map, value, state) else _asymmetric(half).doubled()
    if not is_mirror_symmetric(map.mechanism):
        return map
    mirrored = replace(map, mirrored=True)
    return mirrored if _repeats(mirrored, map, value, state) else mirrored.doubled()


def is_symmetric(map: MechanismMap, value: float, state: Reals) -> bool:
    """Say whether a motion is its own mirror image half a period later, as far as it is known."""
    if map.periods % 2 == 0 or not is_mirror_symmetric(map.mechanism):
        return False
    return _repeats(replace(map, mirrored=True), map, value, state)


def _asymmetric(map: MechanismMap) -> MechanismMap:
    """Return the map of an asymmetric motion, doubled from that of the simplest motion there can be."""
    if map.periods % 2 == 0:
        return _asymmetric(replace(map, periods=map.periods // 2)).doubled()
    return replace(map, mirrored=True).doubled() if is_mirror_symmetric(map.mechanism) else map


def _repeats(half: MechanismMap, map: MechanismMap, value: float, state: Reals) -> bool:
    """Say whether a motion, as far as it is known, is an orbit of half of the map already."""
    passage, whole = half.passage(value, state), map.passage(value, state)
    sizes = np.where(passage.sizes > 0.0, passage.sizes, 1.0)
    unsettled = float(abs((whole.end - state) / sizes).max())
    return float(abs((passage.end - state) / sizes).max()) <= SYMMETRIC + 10.0 * unsettled


def _followed(branch: Branch, base: MechanismMap) -> FollowedBranch:
    """Return a branch of a mechanism, with the map of which all others are doubled."""
    map = base
    for _ in range(branch.doublings):
        map = map.doubled()
    whole = replace(map, mirrored=False)
    return FollowedBranch(
        map=whole,
        points=tuple(FollowedOrbit(point, whole) for point in branch.points),
        special=branch.special,
        reason=branch.reason,
        message=branch.message,
        branches=tuple(_followed(each, base) for each in branch.branches),
        parted=branch.parted,
    )
