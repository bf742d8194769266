"""Whether a system that is linear between events moves so from a state, with these events and no other."""

from flint import arb, ctx

from trimmer.proof.following import BallMotion
from trimmer.proof.form import require_events, require_rest_at_start
from trimmer.proof.orbit_check import taken_as_zero, unchecked
from trimmer.proof.outcome import RefutedError, UndecidedError
from trimmer.proof.readings import bounds, readings
from trimmer.proof.statement import StatedMotion

TRIES = (192, 448, 1408)  # Bits; more where balls grow too far


def check_motion(data: StatedMotion) -> str:
    """Hold a motion against the equations of its modes; return the theorem."""
    *fewer, most = TRIES
    for bits in fewer:
        try:
            return _checked(data, bits)
        except UndecidedError:
            continue
    return _checked(data, most)


def _checked(data: StatedMotion, bits: int) -> str:
    with ctx.workprec(bits):
        motion = BallMotion(data.motion, data.whole)
        require_events(motion)
        segments = data.motion.segments
        times = [each.at for each in segments if each.at is not None]
        if segments[-1].at is None or times != sorted(times):
            raise RefutedError("it does not end at a time, or times fall")
        require_rest_at_start(motion, motion.start)
        over = motion.follow([*motion.start, arb(0)])
        told, passed = readings(motion, over, data.functionals, data.levels), arb(0)
        instants: list[str] = []
        for number, (segment, late) in enumerate(zip(motion.segments, over.lates, strict=True), 1):
            passed += segment.duration + late
            if segment.fired is not None:
                instants.append(f"event {number} {bounds(passed)} s")
        return _theorem(motion, data, instants, told)


def _theorem(motion: BallMotion, data: StatedMotion, instants: list[str], told: str) -> str:
    course, end = motion.course, data.motion.segments[-1].at
    known = len(course.segments) - 1 - len(instants)
    strict = sum(len(each.strict) for each in course.segments)
    changes = (
        f" At {known} times the states become what it says, where its {strict} inequalities hold."
        if known
        else ""
    )
    moving = ", in a frame that moves evenly, as this file says unchecked," if any(course.frame) else ""
    when = f" Counted with all else that happens, they come at: {'; '.join(instants)}." if instants else ""
    return (
        f"The system that is linear between events, with the modes of this file {unchecked(course.about)} "
        "and what it says of modes and states after each event, its numbers taken as exact, moves from the "
        f"state of this file{moving} for {end!r} s with the {len(instants)} events of this file in its "
        f"order and no other.{when}{changes}{taken_as_zero(motion)}{told}"
    )
