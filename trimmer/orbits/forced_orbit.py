"""``forced_orbit`` for what is driven, and when what it finds of a loop is no orbit."""

from typing import cast, overload

import numpy as np

from trimmer.errors import OrbitNotFoundError
from trimmer.loops.feedback import Feedback
from trimmer.loops.loops import Loop, require_loop
from trimmer.mechanism.mechanism import Mechanism
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.orbits.realization import restated
from trimmer.response.exact_orbit import SETTLING, exact_orbit
from trimmer.response.periodic.orbit import Orbit
from trimmer.response.periodic.shooting import SETTLED, SINGULAR, sizes_of
from trimmer.response.starts import Start

RESONANT = 1e-7
"""Distance of a pole from a multiple of the drive's frequency, as a share: a double one is known to that."""
NEARLY = 1e-6  # Miss, as a share of the sizes of the orbit itself, that is more than what rounding leaves
TOLD_APART = 1e-10 / float(np.finfo(float).eps)
"""State over its size beyond which its rounding alone is more than the miss of a closed return."""


@overload
def forced_orbit(
    loop: Loop, settling: int | None = None, *, periods: int = 1, guess: Start = None
) -> PeriodicOrbit: ...
@overload
def forced_orbit(
    loop: Mechanism, settling: int | None = None, *, periods: int = 1, guess: Start = None
) -> Orbit: ...
def forced_orbit(
    loop: Loop | Mechanism, settling: int | None = None, *, periods: int = 1, guess: Start = None
) -> PeriodicOrbit | Orbit:
    """Find a motion that repeats with the drive.

    It is an exact motion, stable or not, that returns after a number of drive periods; of a mechanism without
    a drive, one that returns after a period of its own. Newton's method begins at the guess; without one, at
    the motion from rest after 8, 64 and 512 drive periods, or after ``settling``.

    Args:
        loop: A loop with a drive, or a mechanism.
        settling: Periods of the drive to follow before Newton's method.
        periods: Number of drive periods after which the motion returns.
        guess: Where the motion begins, near the one that is sought, at the start of a drive period:
            displacement, m, and velocity, m/s, by body, or states of a loop by name; or all states, (n,).

    Returns:
        The orbit. That of a mechanism says itself whether it was found (``success``, ``message``), and
        whether it returns already after fewer periods (``period_count``).

    Raises:
        ValueError: if a loop has no drive, or a number is out of range.
        OrbitNotFoundError: if Newton's method finds none for a loop; if the motion of a mechanism cannot be
            followed, or comes to rest or repeats nowhere without a drive.
        MechanismError, LoopError: if the guess does not fit.
        UnsupportedMotionError: if a mechanism never repeats, because a pin goes on for ever and pulls.
    """
    if isinstance(loop, Mechanism):
        return exact_orbit(loop, periods, guess, settling)
    require_loop(loop)
    return _of_loop(loop, settling, periods, guess)


def _of_loop(loop: Loop, settling: int | None, periods: int, guess: Start) -> PeriodicOrbit:
    if not loop.driving and isinstance(loop, Feedback):
        return cast("PeriodicOrbit", exact_orbit(loop, periods, guess, settling))
    if not loop.driving:
        raise ValueError("the loop has no drive; periodic_orbits finds the motions of a closed loop")
    known = restated(loop)
    orbit = cast("PeriodicOrbit", exact_orbit(known.loop, periods, guess, settling))
    if orbit.success and _returns(orbit) and not _gone_away(orbit):
        return known.told(orbit)
    followed = SETTLING[-1] if settling is None else settling
    time, lasting = f"{periods} periods" if periods > 1 else "the period", periods * orbit.flow.period
    raise OrbitNotFoundError(
        f"no motion with {time} of the drive, {lasting:.6g} s, was found after {followed} "
        f"periods; {_reason(loop)}"
    )


def _returns(orbit: PeriodicOrbit) -> bool:
    """Say whether it returns beside its own sizes too, and not only those of a start that had grown."""
    course = orbit.course
    missed, sizes = abs(course.end.state - course.begin.state), sizes_of(course)
    # What the symmetry of a machine keeps at rest moves by the rounding of what does move.
    return bool((missed <= NEARLY * sizes + SETTLED * sizes.max(initial=0.0)).all())


def _gone_away(orbit: PeriodicOrbit) -> bool:
    """Say whether the state is so large that it returns to rounding, whatever moves it on in each period.

    So Newton's method answers at the resonance of an undamped mode, where there is no orbit.
    """
    if (abs(orbit.instant.state) <= TOLD_APART * orbit.sizes).all():
        return False
    values = np.linalg.svd(orbit.monodromy - np.eye(len(orbit.sizes)), compute_uv=False)
    return bool(values.min() <= SINGULAR * max(1.0, values.max()))


def _reason(loop: Loop) -> str:
    """Return why there may be no motion with the period of the drive, in words."""
    poles = np.linalg.eigvals(loop.modes.system.interconnection.A)
    omega = loop.modes.system.layout.omega
    harmonics = np.rint(poles.imag / omega)
    away = abs(poles - 1j * harmonics * omega)
    near = (harmonics >= 1.0) & (away <= RESONANT * abs(poles))
    if not near.any():
        return "the motion may repeat only after several periods, or not at all"
    told = " and ".join(f"{n:.0f} times" if n > 1 else "once" for n in np.unique(harmonics[near]))
    return (
        f"the linear system has an undamped pole at {told} the frequency of the drive; an input that "
        "contains that moves it farther in each period, and nothing bounds it"
    )
