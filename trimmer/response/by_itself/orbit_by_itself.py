"""The orbit of what moves without a drive: from a start, or from the search of a loop."""

from dataclasses import replace
from typing import Any

import numpy as np

from trimmer.arrays import Reals
from trimmer.errors import OrbitNotFoundError
from trimmer.hybrid.stretch import Instant
from trimmer.motion.flow import Flow
from trimmer.response.by_itself.recurrences import once, recurring
from trimmer.response.by_itself.self_excited import self_excited
from trimmer.response.flows import is_silent
from trimmer.response.periodic.orbit import Orbit, orbit_of
from trimmer.response.periodic.shooting import Return, returned


def self_excited_orbit(flow: Flow, instant: Instant) -> Orbit:
    """Find a periodic motion without a drive, from what a start settles to.

    An unstable one that the motion passes will do where it settles to none.

    Args:
        flow: The motion of the mechanism.
        instant: The start.

    Raises:
        OrbitNotFoundError: if nothing repeats in the time that was waited; the message says what was seen.
    """
    found = self_excited(flow, instant)
    orbit = found.orbit or found.passed
    if orbit is None and found.returns is not None and found.returns.chaotic:
        orbit = next(iter(recurring(flow, found.returns.course)), None)
    if orbit is not None:
        return orbit
    if found.rest is not None:
        within = found.waited + (found.solved.decay if found.solved else 0.0)
        raise OrbitNotFoundError(f"it comes to rest within {within:.6g} s, and nothing sets it in motion")
    if found.solved is not None:
        raise OrbitNotFoundError("it runs on a torus for ever; another start may repeat")
    raise OrbitNotFoundError(f"nothing repeats within {found.waited:.6g} s; another start may settle")


def orbit_by_itself(flow: Flow) -> Orbit:
    """Find a periodic motion without a drive, of what moves from rest; of a loop one that was searched for.

    At rest nothing happens in a closed loop. So it is the stable orbit of largest amplitude there that
    ``periodic_orbits`` finds, or the largest unstable one if there is no other. Of a trimmer with frictions
    between its bodies it is what that orbit without them leads to.

    Raises:
        OrbitNotFoundError: if there is none.
    """
    if not is_silent(flow.subject):
        return self_excited_orbit(flow, flow.rest())
    found = orbits_of_loop(flow.subject)
    if not found:
        raise OrbitNotFoundError(f"the loop has no orbit to begin with: {found.message}")
    return as_orbit(flow, next((orbit for orbit in found if orbit.stable), found[0]))


def orbits_of_loop(loop: Any) -> Any:
    """Return what ``periodic_orbits`` finds of a loop in which nothing happens at rest, without frictions."""
    from trimmer.loops.trimmer_loop import TrimmerLoop
    from trimmer.orbits.periodic_orbits import periodic_orbits

    bare = replace(loop, frictions=()) if isinstance(loop, TrimmerLoop) else loop
    return periodic_orbits(bare)


def state_on(flow: Flow, found: Any) -> Reals:
    """Return a state of an orbit that ``periodic_orbits`` found, (n,)."""
    return np.ascontiguousarray(found.motion.log.state[0][: flow.size])


def as_orbit(flow: Flow, found: Any) -> Orbit:
    """Return what ``periodic_orbits`` found as an orbit of the loop's flow; with frictions what it leads to.

    Raises:
        OrbitNotFoundError: if it cannot be followed.
    """
    state = state_on(flow, found)
    if getattr(flow.subject, "frictions", ()):
        return self_excited_orbit(flow, flow.at(state))
    statuses = found.motion.loop.modes[int(found.motion.log.mode[0])].statuses
    begin = replace(flow.at(state), statuses=statuses)
    shot = returned(Return(flow, 0), flow.at(state, like=begin), found.period)
    if shot is None:
        raise OrbitNotFoundError("the orbit of the loop cannot be followed")
    return orbit_of(flow, once(flow, shot), 0)
