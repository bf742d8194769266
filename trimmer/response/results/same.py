"""Whether two motions are one: orbits shifted in time, mirrored twins, rests, and what does not repeat."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.one_orbit import SAME, ClosedCurve, are_one, inaccuracy

if TYPE_CHECKING:
    from collections.abc import Iterator

    from trimmer.arrays import Reals
    from trimmer.response.periodic.orbit import Orbit
    from trimmer.response.results.response import SettledMotion
    from trimmer.response.statistics.estimate import Estimate
    from trimmer.response.without_events.rest import Rest

POINTS = 32  # Points of a period at which two orbits are compared
ERRORS = 4.0
"""Standard errors by which two motions that do not repeat differ at most in each measure, if they are one."""
FLOOR = 1e-3  # Share of a measure over a window that its error does not tell


def same_motion(motion: SettledMotion, other: SettledMotion) -> bool:
    """Return whether two motions are one, as far as that can be told.

    Those that do not repeat count as one if their measures agree within their errors; those of which nothing
    is measured, if they are of one kind.
    """
    if motion.kind is not other.kind:
        return False
    if motion.orbit is not None and other.orbit is not None:
        return same_orbit(motion.orbit, other.orbit)
    if motion.rest is not None and other.rest is not None:
        return same_rest(motion.rest, other.rest)
    pairs = list(zip(_measured(motion), _measured(other), strict=False))
    return all(_agree(*pair) for pair in pairs)


def _measured(motion: SettledMotion) -> Iterator[Estimate]:
    yield from motion.rms.values()
    yield from motion.rms_acceleration.values()
    if motion.window is not None and motion.linear is None:
        yield from (*motion.window.exponents, *motion.window.output_means.values())


def _agree(one: Estimate, other: Estimate) -> bool:
    size = max(abs(one.value), abs(other.value))
    error = float(np.hypot(one.uncertainty, other.uncertainty))
    return abs(one.value - other.value) <= (ERRORS * error + FLOOR * size if error else SAME * size)


def same_rest(rest: Rest, other: Rest) -> bool:
    """Return whether two rests are one: in one place, or both of one family, with the same parts holding."""
    if rest.family == other.family and rest.instant.statuses == other.instant.statuses:
        return True
    ours, theirs = (np.array([*each.positions.values()]) for each in (rest, other))
    scale = max(abs(ours).max(initial=0.0), abs(theirs).max(initial=0.0))
    return not rest.family and not other.family and bool((abs(ours - theirs) <= SAME * scale).all())


def same_orbit(orbit: Orbit, other: Orbit) -> bool:
    """Return whether one orbit is the other, shifted in time: by whole drive periods where there is a drive.

    Of neutral ones, as where friction holds a body wherever it stopped, there is one beside the other without
    end. They count as one if they have the same size and shape, wherever they lie.
    """
    anywhere = orbit.neutral and other.neutral
    return orbit.periods == other.periods and are_one(curve_of(orbit, anywhere), curve_of(other, anywhere))


def curve_of(orbit: Orbit, about_its_mean: bool = False) -> ClosedCurve:
    """Return an orbit as the closed curve by which it is compared; the mean taken off, if so."""
    parts, autonomous = max(orbit.periods, 1), not orbit.periods
    states = _at_even_times(orbit, POINTS * parts, about_its_mean)
    return ClosedCurve(
        period=orbit.period,
        states=states.reshape(parts, POINTS, -1),
        sizes=np.maximum(orbit.sizes, abs(states).max(axis=0)),
        inaccuracy=inaccuracy(orbit.residual, orbit.nontrivial_multipliers),
        path=(lambda times: _states(orbit, times, about_its_mean)) if autonomous else None,
    )


def largest_states(orbit: Orbit) -> Reals:
    """Return the largest modulus of each state over an orbit, at even times, (n,)."""
    count = POINTS * max(orbit.periods, 1)
    largest: Reals = abs(_at_even_times(orbit, count, about_its_mean=False)).max(axis=0)
    return largest


def _at_even_times(orbit: Orbit, count: int, about_its_mean: bool) -> Reals:
    """Return states at so many even times over an orbit, (count, n); the mean taken off, if so."""
    return _states(orbit, orbit.period * np.arange(count) / count, about_its_mean)


def _states(orbit: Orbit, times: Reals, about_its_mean: bool) -> Reals:
    order = np.argsort(times, kind="stable")
    states = np.empty((len(times), orbit.flow.size))
    states[order] = orbit.course.states(np.ascontiguousarray(times[order]))[:, : orbit.flow.size]
    if about_its_mean:
        nodes = orbit.course.nodes
        states -= (nodes.weights @ nodes.states)[: orbit.flow.size] / orbit.period
    return orbit.flow.reduced(states)


def twins(orbit: Orbit, other: Orbit) -> bool:
    """Return whether an orbit is the mirror image of another one, half a drive period later."""
    if orbit.periods != other.periods or not orbit.flow.is_mirror_symmetric:
        return False
    curve = curve_of(orbit)
    return are_one(
        replace(curve, states=orbit.strobed[:, None]), replace(curve, states=mirrored(other)[:, None])
    )


def mirrored(orbit: Orbit) -> Reals:
    """Return the strobed states of the mirror image of an orbit, (periods, n)."""
    times = orbit.flow.period * (0.5 + np.arange(orbit.periods, dtype=np.float64))
    states = orbit.course.states(times)[:, : orbit.flow.size]
    return orbit.flow.reduced(states) * orbit.flow.mirrored_states
