"""Whether a periodic motion of a system that is linear between events exists, alone, with these events.

It is followed in balls from a ball of starts (``following``); Krawczyk's operator says that one of them
returns (``returning``); then all event functions are enclosed over each segment (``pieces``).
"""

from collections.abc import Sequence

from flint import arb, ctx

from trimmer.proof.following import BY_LAW, RADIUS, BallMotion
from trimmer.proof.form import require_form, require_rest_at_start, require_shortest
from trimmer.proof.outcome import RefutedError, UndecidedError
from trimmer.proof.readings import readings
from trimmer.proof.returning import first_guess, first_step, multipliers_of, scales, solve
from trimmer.proof.statement import Functional, Orbit, OrbitReadings

NEAR = 1e-9
"""Distance from the computed motion, as a share of the size of each state, within which it is that."""
TRIES = ((448, RADIUS), (1408, -640))
"""Bits, and the power of two of the radius of the ball of starts; the second where balls grow too far.

They grow by about a factor e with each step of 1/|M|.
"""


def check_readings(data: OrbitReadings) -> str:
    """Hold a periodic motion against the equations of its modes, and enclose what is read of it."""
    return check_orbit(data.orbit, data.functionals)


def check_orbit(data: Orbit, functionals: Sequence[Functional] = ()) -> str:
    """Hold a periodic motion against the equations of its modes; return the theorem."""
    *narrow, last = TRIES
    for bits, radius in narrow:
        try:
            return _checked(data, functionals, bits, radius)
        except UndecidedError:
            with ctx.workprec(bits):
                _require_alone(BallMotion(data.motion, data.equations))
    return _checked(data, functionals, *last)


def _require_alone(motion: BallMotion) -> None:
    """Tell a family: what stays where it is put, although Newton's step from there is long."""
    guess = first_guess(motion)
    back, step, sizes = motion.follow(guess).back, first_step(motion), scales(motion)
    gaps = [abs(end - begin) for end, begin in zip(back, guess, strict=False)]
    stays = all(gap < NEAR * size for gap, size in zip(gaps, sizes, strict=False))
    if stays and any(abs(each) > NEAR * size for each, size in zip(step, sizes, strict=True)):
        raise UndecidedError("1 is a multiplier, to the digits of the motion: it may be one of a family")


def _checked(data: Orbit, functionals: Sequence[Functional], bits: int, radius: int) -> str:
    with ctx.workprec(bits):
        motion = BallMotion(data.motion, data.equations)
        require_form(motion)
        found = solve(motion, radius=radius)
        try:
            require_near(motion, found.unknown, NEAR)
        except RefutedError:
            _require_alone(motion)
            raise
        require_rest_at_start(motion, found.unknown)
        told = readings(motion, found.over, functionals)
        require_shortest(motion, found.over)
        stable, largest = multipliers_of(motion, found.over)
        if data.stable is not None and stable != data.stable:
            words = {True: "stable", False: "unstable", None: "of undecided stability"}
            error = UndecidedError if stable is None else RefutedError
            raise error(f"it is said to be {words[data.stable]}, and is {words[stable]}")
        return _theorem(motion, data, told, stable, largest, radius)


def require_near(motion: BallMotion, unknown: list[arb], near: float) -> None:
    """Hold what returns against what was computed."""
    for i, given in enumerate(motion.start):
        if not abs(unknown[i] - given) < near * motion.sizes[i]:
            told = float((unknown[i] * motion.units[i]).mid())
            raise RefutedError(f"the motion begins elsewhere: state {i} is {told!r}")
    if motion.autonomous and not abs(unknown[motion.n]) < near * motion.period:
        raise RefutedError(f"its period is longer by {float(unknown[motion.n].mid())!r} s")


def unchecked(about: str) -> str:
    """Say what a file calls its equations, which nothing depends on."""
    return f"(of {about!r}, as it says unchecked)"


def taken_as_zero(motion: BallMotion) -> str:
    """Say which zeros the law of an event gives, if there are any."""
    segments = motion.course.segments
    count = sum(len(each.zeros) + len(each.together) for each in segments)
    if not count:
        return ""
    return (
        f" At its events {count} times an event function is zero because the law of an event makes it so, as "
        f"this file says: it is within {BY_LAW:g} of its terms and taken as zero."
    )


def _theorem(
    motion: BallMotion, data: Orbit, told: str, stable: bool | None, largest: str, radius: int
) -> str:
    """Say what is proven."""
    course, events = motion.course, len(motion.segments) - 1
    if motion.autonomous:
        lasts = f"a period within {NEAR:g}, relative, of {float(motion.period.mid()):.12g} s"
    else:
        lasts = f"the period {int(course.periods)} times {data.equations.period!r} s"
    ticks = sum(each.at is not None for each in motion.segments)
    demands = sum(len(each.strict) for each in course.segments)
    sampled = (
        f", {ticks} of them at instants of a clock where its {demands} inequalities hold," if ticks else ""
    )
    law = f", to {BY_LAW:g} of its terms"
    shifted = f", but for a shift along which nothing changes{law}" if motion.shifts else ""
    moving = ", in a frame that moves evenly, as this file says unchecked," if any(course.frame) else ""
    word = {True: "stable", False: "unstable", None: "neither said to be stable nor unstable"}[stable]
    shifts = ["a shift in time"] * motion.autonomous + ["a shift in place"] * bool(motion.shifts)
    beside = f" but for the one of {' and of '.join(shifts)}" if shifts else ""
    across = " on a plane across it" if shifts else ""
    return (
        f"The system that is linear between events, with the modes of this file {unchecked(course.about)} "
        "and what it says of the states after each event, its numbers taken as exact, has a periodic "
        f"motion{shifted}{moving} with {lasts}, with the {events} events of this file{sampled} in its order "
        f"and no other, which begins within {NEAR:g} of the state of this file, as a share of the sizes of "
        f"the states. In a ball of {2.0**radius:.1g} of these sizes about it no other start{across} returns "
        f"with these events.{taken_as_zero(motion)}{told} It is {word}: the largest modulus of its "
        f"multipliers{beside} is {largest}."
    )
