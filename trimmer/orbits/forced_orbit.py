"""The exact periodic motion of a driven loop."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.arguments import whole_number
from trimmer.errors import OrbitNotFoundError
from trimmer.loops.initial import initial_segment
from trimmer.loops.loops import require_loop
from trimmer.orbits.describe import orbit_of
from trimmer.orbits.realization import restated
from trimmer.orbits.return_map import arcs, flow, follow
from trimmer.orbits.shooting import Return, solve

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.loops.loops import Drive, Loop
    from trimmer.orbits.periodic_orbit import PeriodicOrbit
    from trimmer.orbits.return_map import Arc


SETTLING = (8, 64, 512)
"""Periods after which Newton's method is tried, one after the other, if no number is given."""
RESONANT = 1e-7
"""Distance of a pole from a multiple of the drive's frequency, as a share: a double one is known to that."""


def loop_orbit(loop: Loop, settling: int | None = None) -> PeriodicOrbit:
    """Find the motion that repeats with the drive, starting from rest.

    The loop is followed until its transients have decayed somewhat; from there Newton's method finds the
    state that returns after one period of the drive.

    Args:
        loop: A loop with a drive.
        settling: Periods of the drive to follow before Newton's method; 8, 64 and 512 if not given.

    Returns:
        The orbit, with the period of the drive. Its multipliers have no trivial one; a load at rest in its
        gap, which could rest elsewhere as well, gives one that is 1.

    Raises:
        ValueError: if the loop has no drive, or ``settling`` is negative.
        OrbitNotFoundError: if Newton's method finds no motion with the period of the drive, as at the
            resonance of an undamped mode, or if events accumulate.
    """
    require_loop(loop)
    drive = loop.modes.system.interconnection.drive
    if drive is None:
        raise ValueError("the loop has no drive; periodic_orbits finds the motions of a closed loop")
    if settling is not None:
        whole_number("settling", settling, 0)
    known = restated(loop)
    loop = known.loop
    mode, state = initial_segment(loop, loop.modes, None, 0.0, 0.0)
    followed = 0
    for periods in SETTLING if settling is None else (settling,):
        mode, state = _later(loop, mode, state, (periods - followed) * drive.period)
        followed = periods
        problem = Return(loop.modes, mirrored=False, driven=True, sizes=_sizes(loop, mode, state))
        shot = solve(problem, mode, state, drive.period)
        if shot is not None:
            return known.told(orbit_of(loop, problem, shot, None))
        # Where an event comes with the period it may be found just before its end or after it.
        elapsed, middle = _amid(loop, mode, state, drive.period)
        shot = solve(problem, *middle, drive.period)
        if shot is not None:
            begin = _later(loop, shot.mode, shot.state, drive.period - elapsed)
            return known.told(orbit_of(loop, problem, shot, None, begin))
    raise OrbitNotFoundError(
        f"no motion with the period of the drive, {drive.period:.6g} s, was found after {followed} periods; "
        f"{_reason(loop, drive)}"
    )


def _reason(loop: Loop, drive: Drive) -> str:
    """Return why there may be no motion with the period of the drive, in words."""
    poles = np.linalg.eigvals(loop.modes.system.interconnection.A)
    harmonics = np.rint(poles.imag / drive.omega)
    away = abs(poles - 1j * harmonics * drive.omega)
    near = (harmonics >= 1.0) & (away <= RESONANT * abs(poles))
    if not near.any():
        return "the motion may repeat only after several periods, or not at all"
    told = " and ".join(f"{n:.0f} times" if n > 1 else "once" for n in np.unique(harmonics[near]))
    return (
        f"the linear system has an undamped pole at {told} the frequency of the drive; an input that "
        "contains that moves it farther in each period, and nothing bounds it"
    )


def _later(loop: Loop, mode: int, state: Reals, duration: float) -> tuple[int, Reals]:
    """Return mode and extended state after a time, s, that ends where a period of the drive begins."""
    if duration == 0.0:
        return mode, state
    last = _arcs(loop, mode, state, duration)[-1]
    later = flow(loop.modes, last.mode, last.duration) @ last.state
    # The drive begins its period anew, without the rounding of the integration.
    layout = loop.modes.system.layout
    later[layout.sine :] = layout.forcing_at(0.0)
    return last.mode, later


def _amid(loop: Loop, mode: int, state: Reals, period: float) -> tuple[float, tuple[int, Reals]]:
    """Return the middle of the longest segment of a period, s, and mode and extended state there."""
    chain = _arcs(loop, mode, state, period)
    durations = np.array([arc.duration for arc in chain])
    longest = int(durations.argmax())
    arc, half = chain[longest], 0.5 * float(durations[longest])
    middle = flow(loop.modes, arc.mode, half) @ arc.state
    return float(durations[:longest].sum()) + half, (arc.mode, middle)


def _arcs(loop: Loop, mode: int, state: Reals, duration: float) -> list[Arc]:
    log = follow(loop.modes, mode, state, duration)
    if log is None:
        raise OrbitNotFoundError("events accumulate; simulate() tells where")
    return arcs(loop.modes, log, duration)


def _sizes(loop: Loop, mode: int, state: Reals) -> Reals:
    """Return the largest modulus of each entry of the state within a period, 1 in place of 0."""
    drive = loop.modes.system.interconnection.drive
    assert drive is not None
    log = follow(loop.modes, mode, state, drive.period)
    sizes: Reals = abs(state if log is None else np.vstack([log.state, state])).max(axis=0)
    sizes[sizes == 0.0] = 1.0
    return sizes
