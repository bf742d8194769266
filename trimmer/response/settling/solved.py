"""What a motion that meets no event any more comes to: solved for, and not waited for."""

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.stretch import Instant
from trimmer.mechanism.drives import RETURNS, told_of_drives
from trimmer.messages import listed
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.response.periodic.orbit import Orbit, orbit_of
from trimmer.response.periodic.pace import periods_of
from trimmer.response.periodic.shooting import Patience, Return, sizes_of, solve
from trimmer.response.results.response import MotionKind, SettledMotion
from trimmer.response.statistics.window import watch
from trimmer.response.without_events.linear_motion import LinearMotion, lasting_motion, linear_motion
from trimmer.response.without_events.rest import Rest
from trimmer.response.without_events.sampled_rest import sampled_rest

PATIENCE = Patience(iterations=4, halvings=1, followed=0)  # For an orbit that is known to rounding
MOST_PERIODS = 64  # Periods after which free vibrations and a drive return together at most
A_TURN = 1e-11  # Share of a turn by which a phase may miss its return
WINDOW = 128  # Drive periods over which a torus is watched
A_SECOND = 1.0  # Over which what only moves on evenly is told, s: any time is a period of it
EVENLY = "it moves on evenly, so that any time is a period"  # What is said of that
GONE = 1e-9  # Share of the sizes of a motion at which what decays is gone
LEFT = 1e-3  # Share of the start at which it is called gone


@dataclass(frozen=True, eq=False)
class Solved:
    """What a motion comes to."""

    kind: MotionKind  # What it is: periodic, at rest, or on a torus
    motion: LinearMotion  # It, with all that decays
    orbit: Orbit | None = None  # Where it repeats, or rests beside a drive
    rest: Rest | None = None  # Where it rests

    @property
    def decay(self) -> float:
        """Time until a thousandth is left of what decays, s; 0 where nothing does."""
        slowest = self.motion.slowest
        return -math.log(LEFT) / slowest if slowest < math.inf else 0.0


def solved(flow: Flow, instant: Instant) -> Solved | None:
    """Return what the motion from an instant comes to; None if an event may come, or it grows or drifts."""
    motion = lasting_motion(flow, instant)
    if motion is None:
        return None
    rests, seen = motion.still, _in_place(motion)
    rest = Rest(seen.flow, seen.limit, seen.free) if rests else None
    if rests and not flow.period:
        return Solved(MotionKind.REST, seen, rest=rest)
    count, duration = _repeats(flow, motion.frequencies)
    if not count:
        return Solved(MotionKind.TORUS, seen)
    shot = solve(Return(flow, count if flow.period else 0), motion.limit, duration, PATIENCE)
    about = "" if flow.period or len(motion.frequencies) else EVENLY
    orbit = None if shot is None else orbit_of(flow, shot, count if flow.period else 0, about)
    if orbit is None or not orbit.success:
        return None
    return Solved(MotionKind.REST if rests else MotionKind.PERIODIC, seen, orbit, rest)


def _in_place(motion: LinearMotion) -> LinearMotion:
    """Return a motion in the frame that moves on evenly with it, in which no body is a leader."""
    flow = motion.flow
    if not flow.shifts:
        return motion
    velocities = flow.modes.system.layout.kinds[1]
    speeds = motion.mean[velocities] * motion.moves_on
    return linear_motion(flow.moving(speeds), motion.instant) or motion


def rest_of(orbit: Orbit) -> Rest | None:
    """Return the rest that an orbit is in which nothing moves; None for others."""
    if orbit.course.events:
        return None
    if orbit.flow.modes.system.clockwork is not None:
        return sampled_rest(orbit.flow, orbit.instant, orbit.sizes)
    motion = linear_motion(orbit.flow, orbit.instant)
    return Rest(orbit.flow, motion.limit, motion.free) if motion is not None and motion.still else None


def rest_after(flow: Flow, course: Course, gone: float = GONE) -> Rest | None:
    """Return the rest in which a motion ends; None if something moves then, or will.

    Args:
        flow: What moves.
        course: Its motion.
        gone: Share of the sizes of the motion at which what decays is gone; infinite to wait for no decay.
    """
    if flow.modes.system.clockwork is not None:
        return sampled_rest(flow, course.end, sizes_of(course), gone)
    motion = lasting_motion(flow, course.end)
    if motion is None or not motion.still:
        return None
    left = abs(motion.parts).sum(axis=0) / sizes_of(course)
    return Rest(flow, motion.limit, motion.free) if left.max(initial=0.0) <= gone else None


def _repeats(flow: Flow, frequencies: Reals) -> tuple[int, float]:
    """Return after how many drive periods, or periods of the first frequency, all return; and that time, s.

    Args:
        flow: The motion of the mechanism.
        frequencies: Of free vibrations that never decay, rad/s.
    """
    base = flow.period or (2 * np.pi / float(frequencies[0]) if len(frequencies) else A_SECOND)
    recurrence = flow.modes.system.layout.recurrence
    for count in range(recurrence, MOST_PERIODS + 1, recurrence) if recurrence else ():
        turns = count * base * frequencies / (2 * np.pi)
        if (abs(turns - np.round(turns)) <= A_TURN).all():
            return count, count * base
    return 0, 0.0


def at_rest(rest: Rest, before: float) -> SettledMotion:
    """Return a motion that has come to rest.

    Args:
        rest: Where it rests.
        before: Time until that was seen: drive periods, or s without a drive.
    """
    period = rest.flow.period
    within = periods_of(rest.flow.subject, before) if period else f"{before:.6g} s"
    told = f"It comes to rest within {within}, and nothing sets it in motion{_of_rest(rest)}."
    if rest.asymptotic:
        seen = f"where that leads to was seen within {within}"
        how = "slides for ever, ever more slowly" if period else "slips for ever, less each time"
        told = f"It {how}; {seen}{_of_rest(rest)}."
    periods = int(before) if period else 0
    return SettledMotion(MotionKind.REST, None, None, periods, None, told, rest)


def settled_at_last(found: Solved, before: float) -> SettledMotion:
    """Return what a motion comes to, in words.

    Args:
        found: It.
        before: What was followed before that: drive periods, or s without a drive.
    """
    if found.rest is not None:
        waits = -(-found.decay // found.motion.flow.period) if found.motion.flow.period else found.decay
        return at_rest(found.rest, before + waits)
    flow = found.motion.flow
    periods = int(before) if flow.period else 0
    on_torus = found.kind is MotionKind.TORUS
    window = None
    if on_torus:
        unit = 0.0 if flow.period else 2 * np.pi / float(found.motion.frequencies[0])
        window = watch(flow, found.motion.limit, WINDOW, unit)
    told = f"{_told(found)}. No event comes any more, so that this was solved for and not waited for."
    return SettledMotion(found.kind, found.orbit, window, periods, None, told, linear=found.motion)


def _of_rest(rest: Rest) -> str:
    return "; where it stays depends on its start" if rest.family else ""


def _told(found: Solved) -> str:
    if found.orbit is not None:
        told = f"It settles to {found.orbit.sentence}"
        if found.motion.alive.any():
            return f"{told}: {_undamped(found)}"
        return f"{told}: {_decay(found)}" if found.decay else told
    if not found.motion.flow.modes.system.layout.recurrence and not found.motion.alive.any():
        return f"It runs on a torus: {told_of_drives(RETURNS)}"
    beside = "the drive" if found.motion.flow.period else "one another"
    return (
        f"It runs on a torus: {_undamped(found)}, and beside {beside} nothing repeats within "
        f"{MOST_PERIODS} periods"
    )


def _undamped(found: Solved) -> str:
    frequencies = found.motion.frequencies / (2 * np.pi)
    many = len(frequencies) > 1
    told = listed([f"{each:.6g}" for each in frequencies])
    return (
        f"nothing damps the free vibration{'s' if many else ''} of {told} Hz, so that the start sets "
        f"{'their sizes' if many else 'its size'} for ever"
    )


def _decay(found: Solved) -> str:
    period = found.motion.flow.period
    if not period:
        return f"what the start adds to it falls to a thousandth in {found.decay:.6g} s"
    time = periods_of(found.motion.flow.subject, math.ceil(found.decay / period))
    return f"what the start adds to it falls to a thousandth in {time}"
