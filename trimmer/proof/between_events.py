"""Whether event functions stay positive between events: Taylor's polynomials over steps, with errors."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass

from flint import arb, arb_mat, arb_poly

from trimmer.proof.balls import hull
from trimmer.proof.following import BY_LAW, BallMotion, Followed, Segment, moduli, norm
from trimmer.proof.outcome import RefutedError, UndecidedError, require_time

TERMS = 18
"""Of Taylor's polynomials over a step."""
MOST_STEPS = 6000
REACHED, LEAST = 4.0, 1e-5
"""How often the largest modulus of a state a size may be; share of all sizes below which it may be any."""


def require_no_other_events(motion: BallMotion, over: Followed) -> None:
    """Enclose all event functions over each segment; hold the sizes of the file against the states there."""
    largest = [arb(0)] * motion.n
    for number in range(len(motion.segments)):
        for z in _require_positive_between(motion, number, over):
            largest = [each.max(abs(z[i, 0]).lower()) for i, each in enumerate(largest)]
    sizes = motion.course.sizes
    for i, (reached, size) in enumerate(zip(largest, motion.sizes, strict=False)):
        if not (size < REACHED * reached or sizes[i] < LEAST * max(sizes)):
            raise RefutedError(f"the size {sizes[i]!r} of state {i} is none that the motion reaches")


@dataclass(frozen=True)
class Steps:
    """Steps of one length over a segment.

    Attributes:
        duration: How long each is, s.
        begun: Z at the start of each, and at the end of the last.
        scales: Of Z, in which M has a small norm.
        rate: That norm.
    """

    duration: arb
    begun: list[arb_mat]
    scales: list[arb]
    rate: arb

    def taylor(self, flow: arb_mat, z: arb_mat, step: arb, terms: int) -> tuple[list[arb_mat], arb_mat]:
        """Return the terms of Z over a share of a step from Z, and how far their sum may be off."""
        columns = [z]
        for k in range(1, terms):
            columns.append(flow * columns[-1] * (step / k))
        largest = functools.reduce(arb.max, (abs(z[i, 0]) / each for i, each in enumerate(self.scales)))
        reach = self.rate * abs(step)
        off = (reach**terms / math.factorial(terms) * reach.exp() * largest).upper()
        return columns, arb_mat([[each * off] for each in self.scales])


def steps_over(motion: BallMotion, number: int, over: Followed) -> Steps:
    """Divide a segment into steps so short that Taylor's polynomials hold over each."""
    segment = motion.segments[number]
    duration = segment.duration + over.lates[number]
    if not duration > 0:
        raise RefutedError(f"segment {number} ends before it begins")
    scales, rate = _scales(motion, segment)
    count = max(2, math.ceil(float((rate * duration).upper())))
    if count > MOST_STEPS:
        raise UndecidedError(f"segment {number} is too long for its fastest rate: {count} steps")
    whole, passed = (segment.flow * (duration / count)).exp(), [over.starts[number]]
    for _ in range(count):
        require_time()
        passed.append(whole * passed[-1])
    return Steps(duration / count, passed, scales, rate)


def takes_time(motion: BallMotion, number: int) -> bool:
    """Say whether a segment is more than the instant of a clock at which a motion begins."""
    segment = motion.segments[number]
    return not (number == 0 and segment.at == 0 and segment.duration == 0)


def _require_positive_between(motion: BallMotion, number: int, over: Followed) -> list[arb_mat]:
    """Enclose all event functions over a segment; return Z at some instants of it."""
    segment, end = motion.segments[number], over.ends[number]
    _require_demands(segment, end, f"at the end of segment {number}")
    if not takes_time(motion, number):
        return [end]
    steps = steps_over(motion, number, over)
    falling = () if segment.fired is None else (segment.fired, *_together(segment))
    for place, z in enumerate(steps.begun[:-1]):
        zeros, left = ({} if place else segment.zeros), (falling if place == len(steps.begun) - 2 else ())
        _require_positive(motion, number, steps, (z, steps.duration), zeros, left)
    if falling:
        others = tuple(k for k in range(segment.functions.nrows()) if k not in falling)
        _require_positive(motion, number, steps, (end, -steps.duration), dict.fromkeys(falling, 1), others)
    return steps.begun


def _scales(motion: BallMotion, segment: Segment) -> tuple[list[arb], arb]:
    """Choose scales of Z in which M has a small norm, and return it; they are no smaller than the sizes."""
    n, size = motion.n, len(motion.sizes)
    flow = [[float(abs(segment.flow[i, k]).upper()) for k in range(n)] for i in range(n)]
    balanced = [float(each) for each in motion.sizes[:n]]
    for _ in range(20):
        for i in range(n):
            out = sum(flow[i][k] * balanced[k] for k in range(n) if k != i)
            into = sum(flow[k][i] / balanced[k] for k in range(n) if k != i)
            if out > 0 and into > 0:
                balanced[i] = math.sqrt(out / into)
    largest = max(float(each) / other for each, other in zip(motion.sizes[:n], balanced, strict=True))
    scales = [*(arb(largest * each) for each in balanced), *motion.sizes[n:]]
    table = [[segment.flow[i, k] * scales[k] / scales[i] for k in range(size)] for i in range(size)]
    return scales, norm(arb_mat(table))


def _together(segment: Segment) -> tuple[int, ...]:
    """Return the event functions that fall with the one that ends a segment, of which they are multiples."""
    rows = (segment.functions * segment.reset).tolist()
    ending = rows[segment.fired or 0]
    for function in segment.together:
        row = rows[function]
        share = sum((a * b for a, b in zip(row, ending, strict=True)), arb(0))
        share /= sum((each * each for each in ending), arb(0))
        apart = max(float(abs(a - share * b).upper()) for a, b in zip(row, ending, strict=True))
        if not (share > 0 and apart < BY_LAW * max(float(abs(each).upper()) for each in row)):
            raise UndecidedError("two event functions come to zero at one instant")
    return segment.together


def _require_demands(segment: Segment, end: arb_mat, where: str) -> None:
    for value in [] if segment.strict is None else (segment.strict * end).entries():
        if value < 0:
            raise RefutedError(f"a demand is beyond its limit or not, other than said, {where}")
        if not value > 0:
            raise UndecidedError(f"a demand is at its limit {where}, to balls")


def _require_positive(
    motion: BallMotion,
    number: int,
    steps: Steps,
    begun: tuple[arb_mat, arb],
    zeros: dict[int, int],
    left: tuple[int, ...],
) -> None:
    """Enclose event functions, but for some that are left out, over a step from Z by Taylor's polynomials."""
    segment, (z, step) = motion.segments[number], begun
    if not segment.functions.nrows():
        return
    columns, off = steps.taylor(segment.flow, z, step, TERMS)
    errors = moduli(segment.functions) * off
    for function in range(segment.functions.nrows()):
        if function in left:
            continue
        called = f"event function {function} of segment {number}"
        row = arb_mat([segment.functions.tolist()[function]])
        _require_zeros(motion, row, segment.flow, z, zeros.get(function, 0), called)
        terms = [(row * each)[0, 0] for each in columns[zeros.get(function, 0) :]]
        _require_above(arb_poly(terms), errors[function, 0], called)


def _require_zeros(
    motion: BallMotion, row: arb_mat, flow: arb_mat, z: arb_mat, zeros: int, called: str
) -> None:
    """Hold what the law of an event makes zero against the sizes of its terms."""
    sizes = arb_mat([[each] for each in motion.sizes])
    for _ in range(zeros):
        if not abs((row * z)[0, 0]) < BY_LAW * (moduli(row) * sizes)[0, 0]:
            raise UndecidedError(f"{called} is not zero where it is said to be")
        z, sizes = flow * z, moduli(flow) * sizes


def _require_above(polynomial: arb_poly, error: arb, called: str) -> None:
    """Divide the shares of a step, 0 to 1, until a polynomial is larger than its error on each."""
    waiting = [(0.0, 1.0)]
    while waiting:
        require_time()
        first, last = waiting.pop()
        value = polynomial(hull(first, last))
        if value < -error:
            raise RefutedError(f"{called} is negative within it")
        if value > error:
            continue
        if last - first < 2.0**-24:
            raise UndecidedError(f"{called} may come to zero within it: a grazing, to balls")
        middle = 0.5 * (first + last)
        waiting += [(first, middle), (middle, last)]
