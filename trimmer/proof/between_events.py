"""Whether event functions stay positive between events: Taylor's polynomials over steps, with errors."""

from __future__ import annotations

import math

from flint import arb, arb_mat

from trimmer.proof.balls import about
from trimmer.proof.following import BY_LAW, Followed, Motion, Segment, norm
from trimmer.proof.statement import MOST_ZEROS
from trimmer.proof.undecided import RefutedError, UndecidedError

TERMS = 18
"""Of Taylor's polynomials over a step."""
MOST_STEPS = 6000
REACHED, LEAST = 4.0, 1e-5
"""How often the largest modulus of a state a size may be; share of all sizes below which it may be any."""


def require_no_other_events(motion: Motion, over: Followed) -> None:
    """Enclose all event functions over each segment; hold the sizes of the file against the states there.

    Raises:
        RefutedError: if one is negative, or a size is none that the motion has.
        UndecidedError: if one may be zero where it must not.
    """
    largest = [arb(0)] * motion.n
    for number in range(len(motion.segments)):
        for z in _require_positive_between(motion, number, over):
            largest = [each.max(abs(z[i, 0]).lower()) for i, each in enumerate(largest)]
    sizes = motion.course.sizes
    for i, (reached, size) in enumerate(zip(largest, motion.sizes, strict=False)):
        if not (size < REACHED * reached or sizes[i] < LEAST * max(sizes)):
            raise RefutedError(f"the size {sizes[i]!r} of state {i} is none that the motion reaches")


def _require_positive_between(motion: Motion, number: int, over: Followed) -> list[arb_mat]:
    """Enclose all event functions over a segment; return Z at some instants of it."""
    segment, end = motion.segments[number], over.ends[number]
    duration = segment.duration + over.lates[number]
    _require_demands(segment, end, f"at the end of segment {number}")
    if number == 0 and segment.at == 0 and segment.duration == 0:
        return [end]
    if not duration > 0:
        raise RefutedError(f"segment {number} ends before it begins")
    scales, rate = _scales(motion, segment)
    count = max(2, math.ceil(float((rate * duration).upper())))
    if count > MOST_STEPS:
        raise UndecidedError(f"segment {number} is too long for its fastest rate: {count} steps")
    step = duration / count
    whole, passed = (segment.flow * step).exp(), [over.starts[number]]
    functions = range(segment.functions.nrows())
    falling = [] if segment.fired is None else [segment.fired, *_together(segment)]
    for place in range(count):
        values = _polynomials(scales, segment, passed[-1], step, rate) if functions else None
        for function in functions:
            if values is not None and not (place == count - 1 and function in falling):
                _require_positive(values, function, 0 if place else segment.zeros.get(function, 0), number)
        passed.append(whole * passed[-1])
    if falling:
        values = _polynomials(scales, segment, end, -step, rate)
        for function in falling:
            _require_positive(values, function, 1, number)
    return passed


def _scales(motion: Motion, segment: Segment) -> tuple[list[arb], arb]:
    """Choose scales of Z in which M has a small norm, and return it: sizes, or what balances M."""
    n, size = motion.n, len(motion.sizes)
    moduli = [[float(abs(segment.flow[i, k]).upper()) for k in range(n)] for i in range(n)]
    balanced = [float(each) for each in motion.sizes[:n]]
    for _ in range(20):
        for i in range(n):
            out = sum(moduli[i][k] * balanced[k] for k in range(n) if k != i)
            into = sum(moduli[k][i] / balanced[k] for k in range(n) if k != i)
            if out > 0 and into > 0:
                balanced[i] = math.sqrt(out / into)
    largest = max(float(each) / other for each, other in zip(motion.sizes[:n], balanced, strict=True))
    choices = [motion.sizes, [*(arb(largest * each) for each in balanced), *motion.sizes[n:]]]
    found = []
    for scales in choices:
        table = [[segment.flow[i, k] * scales[k] / scales[i] for k in range(size)] for i in range(size)]
        found.append((scales, norm(arb_mat(table))))
    return min(found, key=lambda each: float(each[1]))


def _together(segment: Segment) -> tuple[int, ...]:
    """Return the event functions that fall with the one that ends a segment, of which they are multiples.

    Raises:
        UndecidedError: if one is none, on the states that the reset before the segment leaves.
    """
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


Polynomials = tuple[arb_mat, list[arb], list[arb_mat]]
"""Of event functions over a share of a step: coefficients (f, TERMS), errors, sizes of the first of them."""


def _polynomials(scales: list[arb], segment: Segment, z: arb_mat, step: arb, rate: arb) -> Polynomials:
    size, columns = len(scales), [z]
    for k in range(1, TERMS):
        columns.append(segment.flow * columns[-1] * (step / k))
    table = arb_mat([[each[i, 0] for each in columns] for i in range(size)])
    largest = arb(0)
    for i in range(size):
        largest = largest.max(abs(z[i, 0]) / scales[i])
    reach = rate * abs(step)
    off = (reach**TERMS / math.factorial(TERMS) * reach.exp() * largest).upper()
    moduli = arb_mat([[abs(each) for each in row] for row in segment.functions.tolist()])
    errors = [
        sum((moduli[f, k] * scales[k] for k in range(size)), arb(0)) * off for f in range(moduli.nrows())
    ]
    rates, column = (
        arb_mat([[abs(each) for each in row] for row in segment.flow.tolist()]),
        arb_mat([[each] for each in scales]),
    )
    terms = [moduli * column]
    for k in range(1, MOST_ZEROS):
        column = rates * column * (abs(step) / k)
        terms.append(moduli * column)
    return segment.functions * table, errors, terms


def _require_demands(segment: Segment, end: arb_mat, where: str) -> None:
    for value in [] if segment.strict is None else (segment.strict * end).entries():
        if value < 0:
            raise RefutedError(f"a demand is beyond its limit or not, other than said, {where}")
        if not value > 0:
            raise UndecidedError(f"a demand is at its limit {where}, to balls")


def _require_positive(values: Polynomials, function: int, zeros: int, number: int) -> None:
    table, errors, terms = values
    called = f"event function {function} of segment {number}"
    known = [table[function, k] for k in range(zeros)]
    if any(not abs(each) < BY_LAW * terms[k][function, 0] for k, each in enumerate(known)):
        raise UndecidedError(f"{called} is not zero where it is said to be")
    coefficients = [table[function, k] for k in range(zeros, TERMS)]
    error = errors[function]
    waiting = [(0.0, 1.0)]
    while waiting:
        first, last = waiting.pop()
        middle, half = 0.5 * (first + last), about(0.5 * (last - first))
        value = arb(0)
        at = arb(middle) + half
        for each in reversed(coefficients):
            value = value * at + each
        if value > error:
            continue
        if value < -error:
            raise RefutedError(f"{called} is negative within it")
        if last - first < 2.0**-24:
            raise UndecidedError(f"{called} may come to zero within it: a grazing, to balls")
        waiting += [(first, middle), (middle, last)]
