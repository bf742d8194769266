"""Whether a system that is linear between events moves so, with these events and no other.

It is followed in balls (``following``), from a state, or from a ball of starts, of which Krawczyk's operator
says that one returns (``returning``); all event functions are enclosed over each segment (``pieces``).
"""

from flint import arb, ctx

from trimmer.proof.following import BY_LAW, PRECISION, RADIUS, BallMotion
from trimmer.proof.form import require_events, require_form, require_shortest
from trimmer.proof.outcome import RefutedError, UndecidedError
from trimmer.proof.readings import bounds, readings
from trimmer.proof.returning import NEAR, multipliers_of, require_alone, solve
from trimmer.proof.statement import Course, StatedMotion


def check_motion(data: StatedMotion) -> str:
    """Hold a motion from a state against the equations of its modes; return the theorem."""
    course, equations = data.motion, data.equations
    if equations.period is not None or equations.forcing != (1.0,) or course.signs or course.clock:
        raise ValueError("a motion from a state has neither period, signs nor clock")
    end = course.segments[-1].at
    if end is None:
        raise RefutedError("it does not end at a time")
    require_events(course)
    with ctx.workprec(PRECISION):
        motion = BallMotion(course, equations)
        over = motion.follow([*motion.start, arb(0)])
        told, passed, events = readings(motion, over, data.functionals, data.levels), arb(0), list[str]()
        for number, (segment, late) in enumerate(zip(motion.segments, over.lates, strict=True), 1):
            passed += segment.duration + late
            if segment.told.fired is not None:
                events.append(f"event {number} {bounds(passed)} s")
    known = len(course.segments) - 1 - len(events)
    strict = sum(len(each.strict) for each in course.segments)
    changes = (
        f" At {known} times the states become what it says, where its {strict} inequalities hold."
        if known
        else ""
    )
    when = f" Counted with all else that happens, they come at: {'; '.join(events)}." if events else ""
    return (
        f"The system that is linear between events, with the modes of this file {unchecked(course.about)} "
        "and what it says of modes and states after each event, its numbers taken as exact, moves from the "
        f"state of this file for {end!r} s with the {len(events)} events of this file in its order and no "
        f"other.{when}{changes}{taken_as_zero(course)}{told}"
    )


def check_orbit(data: StatedMotion) -> str:
    """Hold a periodic motion against the equations of its modes; return the theorem."""
    course, equations = data.motion, data.equations
    if course.signs or not course.periods.is_integer():
        raise ValueError("a part of a motion is no orbit")
    with ctx.workprec(PRECISION):
        motion = BallMotion(course, equations)
        require_form(motion)
        found = solve(motion, known=require_alone(motion))
        require_near(motion, found.unknown, NEAR)
        told = readings(motion, found.over, data.functionals, data.levels)
        require_shortest(motion, found.over)
        stable, largest = multipliers_of(motion, found.over)
        period = f"{float(motion.period.mid()):.12g}"
    words = {True: "stable", False: "unstable", None: "of undecided stability"}
    if data.stable is not None and stable != data.stable:
        error = UndecidedError if stable is None else RefutedError
        raise error(f"it is said to be {words[data.stable]}, and is {words[stable]}")
    lasts = f"the period {int(course.periods)} times {equations.period!r} s"
    across, beside = "", ""
    if motion.autonomous:
        lasts = f"a period within {NEAR:g}, relative, of {period} s"
        across, beside = " on a plane across it", " but for the one of a shift in time"
    word = "neither said to be stable nor unstable" if stable is None else words[stable]
    return (
        f"The system that is linear between events, with the modes of this file {unchecked(course.about)} "
        "and what it says of the states after each event, its numbers taken as exact, has a periodic motion "
        f"with {lasts}, with the {len(course.segments) - 1} events of this file{at_instants(course)} in its "
        f"order and no other, which begins within {NEAR:g} of the state of this file, as a share of the "
        f"sizes of the states. In a ball of {2.0**RADIUS:.1g} of these sizes about it no other start{across} "
        f"returns with these events.{taken_as_zero(course)}{told} It is {word}: the largest modulus of its "
        f"multipliers{beside} is {largest}."
    )


def require_near(motion: BallMotion, unknown: list[arb], near: float) -> None:
    """Hold what returns against what was computed."""
    for i, given in enumerate(motion.start):
        if not abs(unknown[i] - given) < near * motion.sizes[i]:
            told = float((unknown[i] * motion.units[i]).mid())
            raise RefutedError(f"the motion begins elsewhere: state {i} is {told!r}")
    # The period is told to 12 digits.
    if motion.autonomous and not abs(unknown[motion.n]) < 0.99 * near * motion.period:
        raise RefutedError(f"its period is longer by {float(unknown[motion.n].mid())!r} s")


def at_instants(course: Course) -> str:
    """Say which events a clock gives, if it gives any."""
    ticks = sum(each.at is not None for each in course.segments)
    demands = sum(len(each.strict) for each in course.segments)
    return f", {ticks} of them at instants of a clock where its {demands} inequalities hold," if ticks else ""


def unchecked(about: str) -> str:
    """Say what a file calls its equations, which nothing depends on."""
    return f"(of {about!r}, as it says unchecked)"


def taken_as_zero(course: Course) -> str:
    """Say which zeros the law of an event gives, if there are any."""
    count = sum(len(each.zeros) + len(each.together) for each in course.segments)
    if not count:
        return ""
    return (
        f" At its events {count} times an event function is zero because the law of an event makes it so, as "
        f"this file says: it is within {BY_LAW:g} of its terms and taken as zero."
    )
