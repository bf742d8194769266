"""Whether a motion, as a file tells it, is one of one system, whole and begun where nothing happens."""

from itertools import pairwise

from flint import arb, arb_mat

from trimmer.proof.following import BY_LAW, BallMotion, Followed, blocks
from trimmer.proof.outcome import RefutedError, UndecidedError
from trimmer.proof.statement import Course

TOGETHER = 1e-9  # Share of a sample within which what a clock does is at one instant


def require_form(motion: BallMotion) -> None:
    """Hold how a motion is told against what a motion that returns is, before it is followed."""
    course = motion.course
    if course.segments[-1].at is not None or course.segments[0].zeros:
        raise RefutedError("the motion begins or ends at an event")
    require_events(course)
    if not all(_leaves_forcing(motion, each.lifted[2]) for each in motion.segments):
        raise RefutedError("what forces the states does not return")
    if not _ends_as_it_begins(motion):
        raise RefutedError("the motion does not end in the mode in which it begins")
    _require_clock(course, motion)


def require_events(course: Course) -> None:
    """Hold it against a motion that each segment but the last ends by one event, which does one thing."""
    if course.segments[-1].fired is not None:
        raise RefutedError("the motion begins or ends at an event")
    if any((each.fired is None) == (each.at is None) for each in course.segments[:-1]):
        raise RefutedError("a segment ends without an event")
    resets: dict[object, int | None] = {}
    for before, after in pairwise(course.segments):
        key = before.mode, before.fired, before.together, after.mode, after.zeros
        if before.fired is not None and resets.setdefault(key, after.reset) != after.reset:
            raise RefutedError("one event does different things to the states")


def require_shortest(motion: BallMotion, over: Followed) -> None:
    """Hold it against the motion that it is not a shorter one several times over."""
    told, count = motion.course.segments[:-1], len(over.ends) - 1
    rates = [segment.flow * end for segment, end in zip(motion.segments, over.ends, strict=True)]
    for times in range(2, max(count, int(motion.course.periods)) + 1):
        if count % times or (not motion.autonomous and motion.course.periods % times):
            continue
        pairs = [(k, k + count // times) for k in range(count - count // times)]
        kinds = [(each.mode, each.fired) for each in told]
        if all(kinds[i] == kinds[k] and rates[i].overlaps(rates[k]) for i, k in pairs):
            raise UndecidedError(f"it may be a motion of a share of its length, {times} times over")


def _leaves_forcing(motion: BallMotion, reset: arb_mat) -> bool:
    rows = range(motion.n, motion.count)
    return all(reset[i, k] == int(i == k) for i in rows for k in range(reset.ncols()))


def _ends_as_it_begins(motion: BallMotion) -> bool:
    """Return whether the last mode is the first one, or its mirror image."""
    first, last, zero = motion.segments[0], motion.segments[-1], motion.mirror * 0
    if not motion.course.signs:
        return first.told.mode == last.told.mode
    mirror = (
        motion.mirror if motion.slopes is None else blocks([[motion.mirror, zero], [zero, motion.mirror]])
    )
    functions, mirrored = last.lifted[1].tolist(), (first.lifted[1] * mirror).tolist()
    flows = zip((mirror * first.lifted[0] * mirror).tolist(), last.lifted[0].tolist(), strict=True)
    return (
        len(functions) == len(mirrored)
        and all(_are_alike(*rows) for rows in flows)
        and all(any(_are_alike(row, other) for other in functions) for row in mirrored)
        and all(any(_are_alike(row, other) for other in mirrored) for row in functions)
    )


def _are_alike(row: list[arb], other: list[arb]) -> bool:
    largest = max(map(_size, row), default=0.0)
    return all(_size(a - b) <= BY_LAW * largest for a, b in zip(row, other, strict=True))


def _size(value: arb) -> float:
    return float(abs(value).upper())


def _require_clock(course: Course, motion: BallMotion) -> None:
    """Hold the times at which a clock ends segments against its samples and delays."""
    told = [each.at for each in course.segments if each.at is not None]
    whole = 0.0 if motion.autonomous else float(motion.tables.period[0])
    slack = TOGETHER * min((sample for sample, _ in course.clock), default=0.0)
    counts = [round(whole / sample) for sample, _ in course.clock]
    fits = all(abs(n * sample - whole) <= slack for n, (sample, _) in zip(counts, course.clock, strict=True))
    due = sorted(
        each % whole if each > whole - slack else each
        for n, (sample, delay) in zip(counts, course.clock, strict=True)
        for late in (0.0, delay)
        for each in (late + k * sample for k in range(min(n, len(told) + 1)))
    )
    apart = [each for place, each in enumerate(due) if not place or each - due[place - 1] > slack]
    pairs = zip(apart, told, strict=False)
    if not fits or len(apart) != len(told) or any(abs(a - b) > slack for a, b in pairs):
        raise RefutedError("the instants of the clock are not those of its samples")
