"""Whether a motion without a drive has come to an orbit that was found from where it nearly returned.

Newton's method may find another orbit than that which the motion goes to, or another member of a family of
orbits side by side. So the last events of the motion are held against those of the orbit.
"""

import numpy as np

from trimmer.arrays import Flags, Reals
from trimmer.hybrid.system import NOTHING
from trimmer.hybrid.work import Log
from trimmer.motion.course import Course
from trimmer.response.periodic.orbit import Orbit

NEAR = 1e-2  # Distance from a stable orbit as a share of its swing at which a motion has come to it
ON_IT = 1e-6  # Distance from one of many side by side
CYCLES = 4  # Periods at last over which it is seen whether a motion comes nearer as a multiplier says
AS_TOLD = 0.3  # Difference from what a multiplier takes off a distance in a period, as a share of that
ROUNDING = 1e-12  # Share of the sizes of states by which a distance may be rounding


def what_happened(log: Log) -> Flags:
    """Return at which rows of a log something happened by which a motion can be known again, (rows,)."""
    happened = log.kind != NOTHING
    # A limit of a controller, or a knot of a curve, does not count where there is more.
    return np.asarray(happened if happened.any() else log.part >= 0)


def has_arrived(orbit: Orbit, course: Course) -> bool:
    """Return whether a motion has come to a stable orbit, or to one of many side by side.

    Args:
        orbit: The orbit.
        course: The motion, the last stretch of it.
    """
    if not orbit.stable and not orbit.neutral:
        return False
    own, log, size = orbit.course.log, course.log, orbit.flow.size
    theirs = np.flatnonzero(what_happened(own))
    events = np.flatnonzero(what_happened(log))[-max(len(theirs), 1) :]
    if not len(theirs) or not len(events):
        return False
    seen = orbit.flow.reduced(log.state[events][:, :size])
    known = orbit.flow.reduced(own.state[theirs][:, :size])
    alike = (own.part[theirs] == log.part[events][:, None]) & (own.kind[theirs] == log.kind[events][:, None])
    apart = abs(seen[:, None] - known) / _within(orbit, NEAR if orbit.stable else ON_IT)
    return bool((np.where(alike, apart.max(axis=2), np.inf).min(axis=1) <= 1.0).all())


def approaches(orbit: Orbit, course: Course) -> bool:
    """Return whether a motion comes nearer to a stable orbit in each period, as its largest multiplier says.

    Args:
        orbit: The orbit.
        course: The motion, the last stretch of it.
    """
    multipliers = orbit.nontrivial_multipliers
    slowest = complex(multipliers[np.argmax(abs(multipliers))]) if len(multipliers) else 0j
    own, log, size = orbit.course.log, course.log, orbit.flow.size
    theirs, events = np.flatnonzero(what_happened(own)), np.flatnonzero(what_happened(log))
    needed = (CYCLES + 1) * len(theirs)
    if not orbit.stable or slowest.real <= 0.0 or slowest.imag or not 0 < needed <= len(events):
        return False
    rows = events[-needed:].reshape(CYCLES + 1, len(theirs))
    for turn in range(len(theirs)):
        known = np.roll(theirs, turn)
        if (own.part[known] != log.part[rows]).any() or (own.kind[known] != log.kind[rows]).any():
            continue
        apart = orbit.flow.reduced((log.state[rows] - own.state[known])[..., :size].reshape(needed, size))
        apart = apart.reshape(CYCLES + 1, -1) / np.tile(_within(orbit, 1.0), len(theirs))
        before = abs(apart[:-1]).max(axis=1)
        off = abs(apart[1:] - slowest.real * apart[:-1]).max(axis=1)
        if (before < 1.0).all() and (off <= AS_TOLD * (1.0 - slowest.real) * before).all():
            return True
    return False


def _within(orbit: Orbit, share: float) -> Reals:
    """Return how far from an orbit each state counts as on it, (n,): a share of what its kind swings."""
    layout, size = orbit.flow.modes.system.layout, orbit.flow.size
    swings = layout.lengths * np.ptp(orbit.course.nodes.states[:, :size], axis=0)
    for kind in layout.kinds:
        swings[kind] = swings[kind].max(initial=0.0)
    return np.asarray(share * swings / layout.lengths + ROUNDING * orbit.sizes)
