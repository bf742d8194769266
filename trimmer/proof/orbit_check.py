"""Whether a periodic motion of a system that is linear between events exists, alone, with these events.

It is followed in balls from a ball of starts (``following``); Krawczyk's operator says that one of them
returns (``returning``); then all event functions are enclosed over each segment (``between_events``).
"""

from __future__ import annotations

from typing import Any

from flint import arb, ctx

from trimmer.proof.between_events import require_positive_between
from trimmer.proof.following import ORBIT_PRECISION, RADIUS, Followed, Motion
from trimmer.proof.outcome import Outcome, Verdict
from trimmer.proof.returning import first_guess, multipliers_of, solve
from trimmer.proof.undecided import RefutedError, UndecidedError

NEAR = 1e-9
"""Distance from the computed motion, as a share of the size of each state, within which it is that."""


def check_orbit(data: dict[str, Any]) -> Outcome:
    """Hold a periodic motion against the equations of its modes.

    Args:
        data: ``modes`` (flow of the states, event functions), ``segments``, ``state`` at the start,
            ``forcing`` there with its ``rotation`` (orders), ``period`` of the drive or None, ``periods``;
            ``shifts`` along which nothing changes, if any, and velocities of the ``frame``.
    """
    with ctx.workprec(ORBIT_PRECISION):
        try:
            return _checked(Motion(data), data)
        except UndecidedError as error:
            return Outcome(Verdict.UNDECIDED, "", str(error))
        except RefutedError as error:
            return Outcome(Verdict.REFUTED, "", str(error))


def _checked(motion: Motion, data: dict[str, Any]) -> Outcome:
    over = require_orbit(motion, data)
    stable, largest = multipliers_of(motion, over)
    if data["stable"] is not None and stable != data["stable"]:
        told = {True: "stable", False: "unstable", None: "of undecided stability"}
        verdict = Verdict.UNDECIDED if stable is None else Verdict.REFUTED
        return Outcome(verdict, "", f"it is said to be {told[data['stable']]}, and is {told[stable]}")
    return Outcome(Verdict.PROVEN, _theorem(motion, data, stable, largest), "")


def require_orbit(motion: Motion, data: dict[str, Any], near: float = NEAR) -> Followed:
    """Prove that there is an orbit with these events; return the motion from a ball around it.

    Args:
        motion: The motion.
        data: What it was made of.
        near: Distance from the computed one within which it must be, as a share of the sizes.

    Raises:
        RefutedError: if it is elsewhere, or has other events.
        UndecidedError: if balls do not tell.
    """
    found = solve(motion)
    require_near(motion, found.unknown, near)
    over = found.over
    for number, segment in enumerate(motion.segments):
        require_positive_between(motion, number, segment, over)
    return over


def require_near(motion: Motion, unknown: list[arb], near: float) -> None:
    """Hold what returns against what was computed.

    Raises:
        RefutedError: if it is elsewhere.
        UndecidedError: if that may be because it stays where it is put.
    """
    for i, given in enumerate(motion.start):
        if not abs(unknown[i] - given) < near * motion.sizes[i]:
            back = motion.follow(first_guess(motion)).back
            pairs = zip(back, motion.start, motion.sizes, strict=False)
            if all(abs(end - begin) < near * size for end, begin, size in pairs):
                raise UndecidedError("it stays where it is put, and the motion that returns is elsewhere")
            told = float((unknown[i] * motion.units[i]).mid())
            raise RefutedError(f"the motion begins elsewhere: state {i} is {told!r}")
    if motion.autonomous and not abs(unknown[motion.n]) < near * motion.period:
        raise RefutedError(f"its period is longer by {float(unknown[motion.n].mid())!r} s")


def _theorem(motion: Motion, data: dict[str, Any], stable: bool | None, largest: str) -> str:
    """Say what is proven."""
    events = len(motion.segments) - 1
    if motion.autonomous:
        lasts = f"a period within {NEAR:g}, relative, of {float(motion.period.mid()):.12g} s"
    else:
        lasts = f"the period {int(data['periods'])} times {data['period']!r} s"
    ticks = sum(each.at is not None for each in motion.segments)
    sampled = f", {ticks} of them instants of a clock," if ticks else ""
    shifted = ", but for a shift along which nothing changes" if motion.shifts else ""
    moving = ", in a frame that moves evenly, as this file says" if any(data.get("frame", [])) else ""
    word = {True: "stable", False: "unstable", None: "neither said to be stable nor unstable"}[stable]
    shifts = ["a shift in time"] * motion.autonomous + ["a shift in place"] * bool(motion.shifts)
    beside = f" but for the one of {' and of '.join(shifts)}" if shifts else ""
    return (
        f"The system that is linear between events, with the modes of this file ({data['about']}), their "
        f"numbers taken as exact, has a periodic motion{shifted}{moving} with {lasts}, with the {events} "
        f"events of this file{sampled} in its order and no other, which begins within {NEAR:g} of the state "
        f"of this file, as a share of the sizes of the states. Within {2.0**RADIUS:.1g} of its start no "
        f"other start returns with these events. It is {word}: the largest modulus of its "
        f"multipliers{beside} is {largest}."
    )
