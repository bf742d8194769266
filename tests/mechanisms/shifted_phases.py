"""Random mechanisms whose clock begins later: the same machine, so the same motions, branches and points."""

import math
import re
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tests.mechanisms.random_mechanisms import random_mechanism
from trimmer import FollowedBranch, FollowSettings, Mechanism, follow, forced_orbit, respond
from trimmer.contact.flow import MechanismFlow
from trimmer.response import MechanismOrbit, MotionKind, Response

PERIODS = 300  # Drive periods to wait
CLOSE = 1e-6  # Difference of multipliers, measures and special points, relative to their scale
POINTS = 40  # Orbits of a branch


def shifted(mechanism: Mechanism, share: float) -> Mechanism:
    """Return the mechanism whose clock begins a share of a drive period later."""
    turn, later = 2.0 * math.pi * share, share / mechanism.frequency
    pins = {
        name: replace(pin, phase=pin.phase + pin.order * turn, offset=pin.offset + pin.velocity * later)
        for name, pin in mechanism.pins.items()
    }
    forces = {
        name: replace(force, phase=force.phase + force.order * turn)
        for name, force in mechanism.forces.items()
    }
    return replace(mechanism, pins=pins, forces=forces, start={})


def state_at(mechanism: Mechanism, share: float, state: np.ndarray | None = None) -> np.ndarray:
    """Return the state a share of a drive period after rest, or after a state."""
    flow = MechanismFlow(mechanism)
    begin = flow.rest() if state is None else flow.at(state)
    return flow.timed(begin, share * flow.period).end.state


def differences_of_orbits(ours: MechanismOrbit, theirs: MechanismOrbit) -> Iterator[str]:
    """Yield what differs between the orbits that two clocks tell."""
    if (ours.success, ours.periods, ours.period_count) != (
        theirs.success,
        theirs.periods,
        theirs.period_count,
    ):
        yield f"orbit: {ours.message} / {theirs.message}"
        return
    if not ours.success:
        return
    if (ours.stable, ours.neutral) != (theirs.stable, theirs.neutral):
        yield f"words: {ours.message} / {theirs.message}"
    moduli = [np.sort(abs(each.multipliers))[::-1] for each in (ours, theirs)]
    # Rounding of a small multiplier is that of the largest entry of the matrix, or its root where two meet.
    if abs(moduli[0][0] - moduli[1][0]) > CLOSE * max(1.0, moduli[0][0], ours.growth**0.5):
        yield f"multipliers: {moduli[0][0]:.9g} / {moduli[1][0]:.9g}"
    if ours.events_per_period != theirs.events_per_period:
        yield f"events: {ours.events_per_period} / {theirs.events_per_period}"
    for name, scale in (("peak_to_peak", 1.0), ("rms_acceleration", (2.0 * math.pi / ours.flow.period) ** 2)):
        first, second = (getattr(each.measures, name) for each in (ours, theirs))
        largest = scale * ours.sizes[: len(ours.flow.modes.system.layout.coordinates)].max()
        for key, value in first.items():
            if abs(second[key] - value) > CLOSE * max(abs(value), largest):
                yield f"{name} of {key}: {value:.9g} / {second[key]:.9g}"


def differences_of_responses(ours: Response, theirs: Response) -> Iterator[str]:
    """Yield what differs between what two clocks say a mechanism settles to."""
    first, second = ours.motion, theirs.motion
    if first.kind is not second.kind:
        yield f"kind: {first.message} / {second.message}"
    elif first.orbit is not None and second.orbit is not None:
        yield from differences_of_orbits(first.orbit, second.orbit)
    elif words(first.message) != words(second.message):
        yield f"words: {first.message} / {second.message}"


def words(message: str) -> str:
    """Return a message without its numbers."""
    return re.sub(r"[-+]?\d[\d.e+-]*", "#", message)


def differences_of_branches(ours: FollowedBranch, theirs: FollowedBranch) -> Iterator[str]:
    """Yield what differs between two branches, as far as both were followed."""
    ends = [each.reason for each in (ours, theirs)]
    kinds = [[(each.kind, each.parts, each.note) for each in branch.special] for branch in (ours, theirs)]
    values = [[each.value for each in branch.special] for branch in (ours, theirs)]
    if len(set(ends)) > 1:
        yield f"ends: {ours.message} / {theirs.message}; {values}"
        return
    both = min(len(each) for each in kinds)
    if not ends[0].is_success:
        kinds, values = ([each[:both] for each in given] for given in (kinds, values))
    elif abs(ours.points[-1].value - theirs.points[-1].value) > CLOSE * abs(ours.points[-1].value):
        yield f"ends: {ours.message} / {theirs.message}"
    if kinds[0] != kinds[1]:
        yield f"special points: {ours.special} / {theirs.special}"
    elif not np.allclose(values[0], values[1], rtol=CLOSE, atol=0.0):
        yield f"special values: {values[0]} / {values[1]}"


def differences(seed: int, *, branches: bool = True) -> list[str]:
    """Compare a random mechanism with itself under a later clock, at all doors or without ``follow``.

    Raises:
        TrimmerError: if the mechanism is refused.
    """
    mechanism, random = random_mechanism(seed), np.random.default_rng([seed, 1])
    share = float(random.uniform(0.02, 0.98))
    other = shifted(mechanism, share)
    ours = respond(mechanism, most_periods=PERIODS)
    theirs = respond(other, state=state_at(mechanism, share), most_periods=PERIODS)
    found = [f"respond: {each}" for each in differences_of_responses(ours, theirs)]
    orbit = ours.motion.orbit
    if orbit is None or ours.kind is not MotionKind.PERIODIC or found:
        return found
    begin, count = orbit.instant.state, orbit.periods
    later = state_at(mechanism, share, begin)
    beside = begin * (1.0 + 1e-3 * random.normal(size=len(begin)))
    # Of a continuum of orbits, as where something sticks anywhere, each guess finds the nearest member.
    guesses = (forced_orbit(mechanism, periods=count, guess=beside),)
    guesses += (forced_orbit(other, periods=count, guess=state_at(mechanism, share, beside)),)
    if guesses[0].success and not any(each.neutral for each in guesses):
        found += [f"forced_orbit: {each}" for each in differences_of_orbits(*guesses)]
    if not branches:
        return found
    place = str(random.choice([each for each in mechanism.places if varies(mechanism, each)]))
    value = mechanism.value(place)
    factor = float(random.choice([0.8, 1.25]))
    # The static force may not go below the kinetic one, nor that above it.
    factor = {"static": 1.25, "force": 0.8}.get(place.rsplit(".", 1)[-1], factor)
    stop = value * factor
    settings = FollowSettings(quiet=True, switches=0, most_points=POINTS)
    followed = [
        follow(each, place, value, stop, periods=count, state=state, settings=settings)
        for each, state in ((mechanism, begin), (other, later))
    ]
    found += [f"follow {place} to {stop:.6g}: {each}" for each in differences_of_branches(*followed)]
    return found


def varies(mechanism: Mechanism, place: str) -> bool:
    """Say whether a number can be varied without a change of what a later clock means."""
    section, last = place.split(".")[0], place.rsplit(".", 1)[-1]
    if section == "start" or last in ("phase", "order", "velocity", "offset"):
        return False
    moves_on = any(pin.velocity for pin in mechanism.pins.values())
    return mechanism.value(place) > 0.0 and not (place == "frequency" and moves_on)
