"""Whether a motion, as a file tells it, is one of one system, whole and begun where nothing happens."""

import math
from itertools import pairwise

from flint import arb, arb_mat

from trimmer.proof.following import BY_LAW, BallMotion, Followed, identity, moduli
from trimmer.proof.outcome import RefutedError, UndecidedError
from trimmer.proof.statement import Course

TOGETHER = 1e-9  # Share of a sample within which what a clock does is at one instant


def require_form(motion: BallMotion) -> None:
    """Hold how a motion is told against what a motion that returns is, before it is followed."""
    course, segments = motion.course, motion.segments
    first, last = course.segments[0], course.segments[-1]
    if last.at is not None or first.zeros:
        raise RefutedError("the motion begins or ends at an event")
    require_events(motion)
    if any(each not in (1, -1) for each in motion.signs):
        raise RefutedError("a mirror image has other signs than 1 and -1")
    squares = _squares(course.rotation)
    if squares is None or not all(_leaves_forcing(motion, each.lifted[2]) for each in segments):
        raise RefutedError("what forces the states does not return")
    turned = [(-1) ** math.isqrt(each) if course.signs else 1 for each in squares]
    if not _ends_as_it_begins(motion, [*motion.signs, *turned]):
        raise RefutedError("the motion does not end in the mode in which it begins")
    _require_clock(course, motion)
    _require_shifts(motion)


def require_events(motion: BallMotion) -> None:
    """Hold it against a motion that each segment but the last ends by one event, which does one thing."""
    course, segments = motion.course, motion.segments
    if course.segments[-1].fired is not None:
        raise RefutedError("the motion begins or ends at an event")
    if any((each.fired is None) == (each.at is None) for each in course.segments[:-1]):
        raise RefutedError("a segment ends without an event")
    resets: dict[object, arb_mat] = {}
    for (before, after), segment in zip(pairwise(course.segments), segments[1:], strict=True):
        key = before.mode, before.fired, before.together, after.mode, after.zeros
        if before.fired is not None and not resets.setdefault(key, segment.lifted[2]).overlaps(
            segment.lifted[2]
        ):
            raise RefutedError("one event does different things to the states")


def require_rest_at_start(motion: BallMotion, start: list[arb]) -> None:
    """Hold it against the equations that nothing happens to the states where the motion begins."""
    z = arb_mat([[each] for each in start[: motion.n]] + motion.tables.forcing.tolist())
    jumps = ((motion.segments[0].reset - identity(motion.count)) * z).entries()
    if not all(abs(jump) < BY_LAW * size for jump, size in zip(jumps, motion.sizes, strict=True)):
        raise RefutedError("the states jump where the motion begins, without an event")


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


def _squares(orders: tuple[tuple[int, ...], ...]) -> list[int] | None:
    """Return the diagonal of -R^2 of whole numbers R with exp(2 pi R) = 1; None if that is not so.

    R must be antisymmetric, and -R^2 diagonal, of squares.
    """
    size = range(len(orders))
    table = [[-sum(orders[i][j] * orders[j][k] for j in size) for k in size] for i in size]
    holds = all(
        orders[i][k] == -orders[k][i]
        and table[i][k] == (math.isqrt(max(0, table[i][i])) ** 2 if i == k else 0)
        for i in size
        for k in size
    )
    return [table[i][i] for i in size] if holds else None


def _leaves_forcing(motion: BallMotion, reset: arb_mat) -> bool:
    rows = range(motion.n, motion.count)
    return all(reset[i, k] == int(i == k) for i in rows for k in range(reset.ncols()))


def _ends_as_it_begins(motion: BallMotion, signs: list[int]) -> bool:
    """Return whether the last mode is the first one, or its mirror image."""
    first, last = motion.segments[0], motion.segments[-1]
    if not motion.course.signs:
        return motion.course.segments[0].mode == motion.course.segments[-1].mode
    both = signs * (1 if motion.slopes is None else 2)
    mirror = arb_mat([[arb(sign * int(i == k)) for k in range(len(both))] for i, sign in enumerate(both)])
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
    if not course.clock and not told:
        return
    whole = 0.0 if motion.autonomous else float(motion.tables.period)
    slack = TOGETHER * min((sample for sample, _ in course.clock), default=0.0)
    due = sorted(
        each % whole if each > whole - slack else each
        for sample, delay in course.clock
        for late in (0.0, delay)
        for each in (late + k * sample for k in range(round(whole / sample)))
    )
    apart = [each for place, each in enumerate(due) if not place or each - due[place - 1] > slack]
    fits = all(abs(round(whole / sample) * sample - whole) <= slack for sample, _ in course.clock)
    if (
        not fits
        or len(apart) != len(told)
        or any(abs(a - b) > slack for a, b in zip(apart, told, strict=True))
    ):
        raise RefutedError("the instants of the clock are not those of its samples")


def _require_shifts(motion: BallMotion) -> None:
    """Hold it against the equations that nothing changes along the shifts, but for rounding."""
    for along, _ in motion.shifts:
        way = arb_mat([[each] for each in along] + [[arb(0)] for _ in range(motion.count - motion.n)])
        for segment in motion.segments:
            tables = [segment.flow, segment.functions, segment.reset - identity(motion.count)]
            for table in [*tables, *([segment.strict] if segment.strict is not None else [])]:
                pairs = zip((table * way).entries(), (moduli(table) * moduli(way)).entries(), strict=True)
                if any(not abs(value) <= BY_LAW * size for value, size in pairs):
                    raise RefutedError("something changes along a shift")
