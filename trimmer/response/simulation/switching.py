"""A machine that switches: followed from its start until all of it rests, through what its profiles do."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from trimmer.contact.flow import MechanismFlow
from trimmer.errors import UnsupportedMotionError
from trimmer.hybrid.stretch import Ending
from trimmer.mechanism.mechanism import Mechanism
from trimmer.motion.time_scale import time_scale
from trimmer.response.settling.solved import rest_after
from trimmer.response.simulation.closings import Closing
from trimmer.response.simulation.motion import MechanismMotion
from trimmer.response.without_events.rest import Rest

STRETCHES = (5, 20, 80, 320)
"""How long is waited for rest after the last time of a profile, in periods of the slowest mode."""
DRIVEN = 20  # Drive periods that are followed after it, where a drive leaves nothing at rest
MOST_STEPS = 2_000_000  # Steps of one motion


@dataclass(frozen=True, eq=False)
class Switching:
    """What a machine does from its start on."""

    motion: MechanismMotion  # The motion, with all of its events
    closings: Mapping[str, Closing]  # How its contacts close, by name
    last: float  # Time of its last event, s; that at which the last profile ends, if that is later
    # Where it rests at last; None if a drive keeps it moving, or it was not seen to rest
    rest: Rest | None = None


def switching(mechanism: Mechanism) -> Switching:
    """Follow a machine from its start until no event can come any more and nothing moves.

    What a drive keeps moving is followed for some of its periods after the last time of a profile.

    Raises:
        UnsupportedMotionError: if it cannot be followed so long.
    """
    flow = MechanismFlow(mechanism)
    begin = flow.rest()
    profiles = (force.profile for force in mechanism.forces.values() if force.profile)
    switched = max((profile[-1][0] for profile in profiles), default=0.0)
    unit = time_scale(flow, begin)
    waits = [DRIVEN * flow.period] if mechanism.frequency is not None else [each * unit for each in STRETCHES]
    for wait in waits:
        course = flow.timed(begin, switched + wait, MOST_STEPS)
        if course.ending is not Ending.REACHED_END:
            raise UnsupportedMotionError(f"the motion could not be followed: {course.ending.value}")
        rest = rest_after(flow, course, math.inf)
        if rest is not None:
            break
    motion = MechanismMotion(flow, course)
    last = max([switched, *(event.time for event in motion.events[-1:])])
    return Switching(motion, motion.closings, last, rest)
