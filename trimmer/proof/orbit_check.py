"""Whether a periodic motion of a system that is linear between events exists, alone, with these events.

In each mode Z' = M Z, states first, then what forces them; a mode lasts while its event functions,
functionals of Z, are positive. Where one falls to zero, Z is multiplied by a reset and the next mode begins.
The motion is followed in balls from a ball of starts: by matrix exponentials over the durations as computed,
and by Taylor's polynomials for what the event times differ from them, each enclosed by an interval Newton
step. Its derivative by the start has the jump of each event in it (Leine and Nijmeijer 2004, chapter 7).
Krawczyk's operator then says that one start in the ball returns. Last, all event functions are enclosed over
each segment.
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import arb, arb_mat, ctx, fmpq

from trimmer.proof.balls import about, exact, real
from trimmer.proof.outcome import Outcome, Verdict
from trimmer.proof.undecided import UndecidedError

ORBIT_PRECISION = 448
"""Bits: enough for balls that grow by a factor e with each step of 1/|M|."""
TERMS, FEW_TERMS = 18, 12
"""Of Taylor's polynomials over a step, and over what an event is later than computed."""
NEAR = 1e-9
"""Distance from the computed motion, as a share of the size of each state, within which it is that."""
RADIUS = -150
"""Power of two of the radius of the ball of starts, as a share of the sizes."""
MOST_STEPS, MOST_ZEROS, MOST_ITERATIONS = 6000, 3, 30
BY_LAW = 1e-9
"""Share of its terms below which a derivative of an event function is taken for what the law says: zero."""


class RefutedError(Exception):
    """The message says, without a full stop, what is wrong."""


def matrix(rows: list[list[float]]) -> arb_mat:
    """Return doubles as exact balls."""
    return arb_mat([[real(exact(each)) for each in row] for row in rows])


@dataclass(frozen=True)
class Segment:
    """One piece of the motion.

    Attributes:
        flow: M, (N, N).
        functions: The event functions, (f, N).
        reset: What becomes of Z before it, (N, N).
        duration: As computed, s.
        fired: The event function that ends it; None for the last one.
        together: Others that are a multiple of it for all Z that this mode can have.
        zeros: How many derivatives of event functions vanish at its start, counting the zeroth.
    """

    flow: arb_mat
    functions: arb_mat
    reset: arb_mat
    duration: arb
    fired: int | None
    together: list[int]
    zeros: dict[int, int]

    @cached_property
    def norm(self) -> arb:
        """The largest sum of moduli of a row of M."""
        return _norm(self.flow)

    @cached_property
    def propagator(self) -> arb_mat:
        """exp(M duration)."""
        return (self.flow * self.duration).exp()


@dataclass(frozen=True)
class Followed:
    """A motion from a ball of starts.

    Attributes:
        starts: Z at the start of each segment, (N, 1).
        ends: Z at its end, (N, 1).
        lates: What is to be added to the duration of each, s.
        change: Derivative of the end by the start, (N, n).
    """

    starts: list[arb_mat]
    ends: list[arb_mat]
    lates: list[arb]
    change: arb_mat


class Motion:
    """The statement's data in balls."""

    def __init__(self, data: dict[str, Any]) -> None:
        """Take the data of a file."""
        self.n, self.autonomous = len(data["state"]), data["period"] is None
        self.forcing = [real(exact(each)) for each in data["forcing"]]
        # Powers of two as units of the states change no digit.
        units = [math.frexp(each)[1] if each > 0 else 0 for each in data["sizes"]]
        self.units = [arb(2) ** each for each in (*units, *(0 for _ in self.forcing))]
        rotation = self._rotation(data)
        flows = [self._square(self._flow(mode["flow"], rotation)) for mode in data["modes"]]
        functions = [self._rows(matrix(mode["functions"])) for mode in data["modes"]]
        self.segments = [
            Segment(
                flows[each["mode"]],
                functions[each["mode"]],
                self._square(matrix(each["reset"])),
                real(exact(each["duration"])),
                each["fired"],
                each["together"],
                {int(place): int(count) for place, count in each["zeros"]},
            )
            for each in data["segments"]
        ]
        first, last = data["segments"][0], data["segments"][-1]
        if first["mode"] != last["mode"] or last["fired"] is not None:
            raise RefutedError("the motion does not end in the mode in which it begins")
        if any(each["fired"] is None for each in data["segments"][:-1]):
            raise RefutedError("a segment ends without an event")
        total = sum((each.duration for each in self.segments[:-1]), arb(0))
        self.start = [real(exact(each)) / unit for each, unit in zip(data["state"], self.units, strict=False)]
        if not self.autonomous:
            period = real(exact(data["period"])) * int(data["periods"])
            self.rest = period - total - self.segments[-1].duration
        else:
            self.rest = arb(0)
        self.sizes = self._sizes()

    @property
    def period(self) -> arb:
        """The period as computed, s."""
        return sum((each.duration for each in self.segments), arb(0))

    def _rotation(self, data: dict[str, Any]) -> arb_mat:
        """Return the flow of what forces the states: orders times 2 pi over the exact period."""
        orders = data["rotation"]
        omega = arb(0) if data["period"] is None else 2 * arb.pi() / real(exact(data["period"]))
        return arb_mat([[omega * int(each) for each in row] for row in orders])

    def _flow(self, rows: list[list[float]], rotation: arb_mat) -> arb_mat:
        size = self.n + len(self.forcing)
        table = [[real(exact(each)) for each in row] for row in rows]
        for i in range(self.n, size):
            table.append([arb(0)] * self.n + [rotation[i - self.n, k - self.n] for k in range(self.n, size)])
        return arb_mat(table)

    def _square(self, table: arb_mat) -> arb_mat:
        """Return a matrix from Z to Z in the units."""
        size = range(len(self.units))
        return arb_mat([[table[i, k] * self.units[k] / self.units[i] for k in size] for i in size])

    def _rows(self, table: arb_mat) -> arb_mat:
        """Return functionals of Z in the units."""
        size = range(len(self.units))
        return arb_mat([[table[i, k] * self.units[k] for k in size] for i in range(table.nrows())])

    def _sizes(self) -> list[arb]:
        """Return the largest modulus of each entry of Z over the ends of segments, at least a little."""
        middle = self.follow([arb(each.mid()) for each in self.start], arb(0))
        every = [*middle.starts, *middle.ends]
        sizes = [max(float(abs(each[i, 0]).upper()) for each in every) for i in range(self.n)]
        floor = max(sizes) * 2.0**-10
        return [arb(max(each, floor)) for each in sizes] + [arb(1) for _ in self.forcing]

    def follow(self, start: list[arb], longer: arb, with_change: bool = False) -> Followed:
        """Follow the motion from a ball of starts.

        Args:
            start: The states.
            longer: What an unknown period is longer than computed, s.
            with_change: Whether the derivative is wanted too.

        Raises:
            UndecidedError: if an event time is not enclosed.
        """
        size = self.n + len(self.forcing)
        z = arb_mat([[each] for each in [*start, *self.forcing]])
        columns = self.n if with_change else 0
        change = arb_mat([[arb(int(i == k)) for k in range(columns)] for i in range(size)])
        later, total = arb_mat(1, columns), arb(0)
        starts, ends, lates = [], [], []
        for segment in self.segments:
            z, change = segment.reset * z, segment.reset * change
            starts.append(z)
            y, change = segment.propagator * z, segment.propagator * change
            if segment.fired is None:
                late = self.rest - total + longer
                y = _moved(segment, y, late)
                rates = segment.flow * y
                change = _moved(segment, change, late) - rates * later
            else:
                row = arb_mat([[segment.functions[segment.fired, k] for k in range(size)]])
                late, slope = _event(segment, row, y)
                y = _moved(segment, y, late)
                change = _moved(segment, change, late)
                by_start = row * change * (-1 / slope)
                change = change + (segment.flow * y) * by_start
                later, total = later + by_start, total + late
            ends.append(y)
            lates.append(late)
            z = y
        return Followed(starts, ends, lates, change)

    def solve(self) -> tuple[list[arb], arb, Followed]:
        """Find the start that returns; return it, what the period is longer, and the motion from its ball.

        Raises:
            UndecidedError: if nothing is proven.
        """
        middle, longer = [arb(each.mid()) for each in self.start], arb(0)
        inverse = _inverse(self._derivative(self.follow(middle, longer, True)))
        for _ in range(MOST_ITERATIONS):
            step = self._step(self.follow(middle, longer), middle, inverse)
            middle = [arb((each + step[i, 0]).mid()) for i, each in enumerate(middle)]
            if self.autonomous:
                longer = arb((longer + step[self.n, 0]).mid())
            if all(
                abs(step[i, 0]) < self.sizes[i] * arb(2) ** (RADIUS - 20) or step[i, 0].contains(0)
                for i in range(self.n)
            ):
                break
        reach = arb(2) ** RADIUS
        radii = [each * reach for each in self.sizes[: self.n]]
        ball = [each + about(radius) for each, radius in zip(middle, radii, strict=True)]
        at_last = self.segments[-1].duration * reach if self.autonomous else arb(0)
        over = self.follow(ball, longer + about(at_last), True)
        derivative = self._derivative(over)
        inverse = _inverse(derivative)
        image = self._step(self.follow(middle, longer), middle, inverse)
        rest = _identity(inverse.nrows()) - inverse * derivative
        reaches = arb_mat([[about(each)] for each in [*radii, *([at_last] if self.autonomous else [])]])
        image = image + rest * reaches
        if not all(reaches[i, 0].contains_interior(image[i, 0]) for i in range(inverse.nrows())):
            raise UndecidedError("Krawczyk's operator does not map the ball of starts into itself")
        found = [each + image[i, 0] for i, each in enumerate(middle)]
        return found, longer + image[self.n, 0] if self.autonomous else longer, over

    def _derivative(self, followed: Followed) -> arb_mat:
        """Return the derivative of what is to vanish: the gap of the return, and a phase without drive."""
        extra = int(self.autonomous)
        table = [[followed.change[i, k] - int(i == k) for k in range(self.n)] for i in range(self.n)]
        if extra:
            rates = self.segments[-1].flow * followed.ends[-1]
            table = [[*row, rates[i, 0]] for i, row in enumerate(table)]
            table.append([*self.phase, arb(0)])
        return arb_mat(table)

    @cached_property
    def phase(self) -> list[arb]:
        """A functional of the start that is to stay as it is: along the rates there, in sizes."""
        z = self.segments[0].reset * arb_mat([[each] for each in [*self.start, *self.forcing]])
        rates = self.segments[0].flow * z
        return [arb((rates[i, 0] / self.sizes[i] ** 2).mid()) for i in range(self.n)]

    def _step(self, followed: Followed, middle: list[arb], inverse: arb_mat) -> arb_mat:
        """Return Newton's step."""
        gaps = [[each - followed.ends[-1][i, 0]] for i, each in enumerate(middle)]
        if self.autonomous:
            away = (p * (s - m) for p, s, m in zip(self.phase, self.start, middle, strict=True))
            gaps.append([sum(away, arb(0))])
        return inverse * arb_mat(gaps)


def _inverse(derivative: arb_mat) -> arb_mat:
    """Return about the inverse of the middle of a matrix, exact as far as it goes."""
    try:
        return derivative.mid().inv().mid()
    except ZeroDivisionError:
        raise UndecidedError("1 is a multiplier, as near as balls tell") from None


def _identity(size: int) -> arb_mat:
    return arb_mat([[arb(int(i == k)) for k in range(size)] for i in range(size)])


def _norm(flow: arb_mat) -> arb:
    rows = flow.tolist()
    return functools.reduce(arb.max, (arb(sum(map(abs, row), arb(0)).upper()) for row in rows), arb(0))


def _moved(segment: Segment, columns: arb_mat, late: arb) -> arb_mat:
    """Multiply columns by exp(M late), late short: Taylor's polynomial, and a bound of what it lacks."""
    size = arb((segment.norm * late.abs_upper()).upper())
    if not size < 1e-2:
        raise UndecidedError("an event is too far from where it was computed")
    term = found = columns
    k, left = 1, size
    while k < FEW_TERMS and left > arb(2) ** -ORBIT_PRECISION:
        term = segment.flow * term * (late / k)
        found, left, k = found + term, left * size, k + 1
    largest = functools.reduce(arb.max, (each.abs_upper() for each in columns.entries()), arb(0))
    off = about((2 * left * largest).upper())
    return found + arb_mat([[off] * found.ncols() for _ in range(found.nrows())])


def _event(segment: Segment, row: arb_mat, y: arb_mat) -> tuple[arb, arb]:
    """Enclose how much later an event function falls to zero, and its rate there.

    Raises:
        UndecidedError: if an interval Newton step does not enclose it.
    """
    first, z = arb(0), y
    for _ in range(4):
        value, rate = (row * z)[0, 0], (row * (segment.flow * z))[0, 0]
        if not rate < 0:
            raise UndecidedError("an event function does not fall strictly: a grazing, to balls")
        following = arb((first - value / rate).mid())
        if (following - first).contains(0) or value.contains(0):
            break
        first, z = following, _moved(segment, y, following)
    value = (row * z)[0, 0]
    reach = arb((4 * (value / rate).abs_upper()).upper()) + arb(2) ** (3 * RADIUS)
    slope = (row * (segment.flow * _moved(segment, z, about(reach))))[0, 0]
    late = -value / slope
    if not (slope < 0 and about(reach).contains_interior(late)):
        raise UndecidedError("an event time is not enclosed")
    late = first + late
    return late, (row * (segment.flow * _moved(segment, y, late)))[0, 0]


def check_orbit(data: dict[str, Any]) -> Outcome:
    """Hold a periodic motion against the equations of its modes.

    Args:
        data: ``modes`` (flow of the states, event functions), ``segments``, ``state`` at the start,
            ``forcing`` there with its ``rotation`` (orders), ``period`` of the drive or None, ``periods``.
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
    stable, largest = _stability(motion, over)
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
    start, longer, over = motion.solve()
    for i, (found, given) in enumerate(zip(start, motion.start, strict=True)):
        if not abs(found - given) < near * motion.sizes[i]:
            if data["stable"] is None:
                raise UndecidedError("it stays where it is put, and the motion that returns is elsewhere")
            told = float((found * motion.units[i]).mid())
            raise RefutedError(f"the motion begins elsewhere: state {i} is {told!r}")
    if not abs(longer) < NEAR * motion.period:
        raise RefutedError(f"its period is longer by {float(longer.mid())!r} s")
    for number, segment in enumerate(motion.segments):
        _positive(motion, number, segment, over)
    return over


def _positive(motion: Motion, number: int, segment: Segment, over: Followed) -> None:
    """Enclose all event functions over a segment.

    Raises:
        RefutedError: if one is negative.
        UndecidedError: if one may be zero where it must not.
    """
    duration = segment.duration + over.lates[number]
    if not duration > 0:
        raise RefutedError(f"segment {number} ends before it begins")
    scales, rate = _scales(motion, segment)
    count = max(2, math.ceil(float((rate * duration).upper())))
    if count > MOST_STEPS:
        raise UndecidedError(f"segment {number} is too long for its fastest rate: {count} steps")
    step = duration / count
    whole, power = (segment.flow * step).exp(), _identity(len(scales))
    functions = range(segment.functions.nrows())
    falling = [] if segment.fired is None else [segment.fired, *_together(segment)]
    for place in range(count):
        z = power * over.starts[number]
        is_last = place == count - 1
        values = _polynomials(scales, segment, z, step, rate)
        for function in functions:
            zeros = segment.zeros.get(function, 0) if place == 0 else 0
            if is_last and function in falling:
                continue
            _require_positive(values, function, zeros, number)
        power = power * whole
    if falling:
        values = _polynomials(scales, segment, over.ends[number], -step, rate)
        for function in falling:
            _require_positive(values, function, 1, number)


def _scales(motion: Motion, segment: Segment) -> tuple[list[arb], arb]:
    """Choose scales of Z in which M has a small norm, and return it: the sizes, or those that balance M."""
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
        found.append((scales, _norm(arb_mat(table))))
    return min(found, key=lambda each: float(each[1]))


def _together(segment: Segment) -> list[int]:
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


def _stability(motion: Motion, over: Followed) -> tuple[bool | None, str]:
    """Enclose the largest modulus of the multipliers: of A^k at least |trace|/n and at most the norm."""
    sizes, n = motion.sizes, motion.n
    change = arb_mat([[over.change[i, k] for k in range(n)] for i in range(n)])
    if motion.autonomous:
        # Without the shift in time: along the rates, back to where the phase is that of the start.
        rates = motion.segments[-1].flow * over.ends[-1]
        along = arb_mat([[rates[i, 0]] for i in range(n)])
        phase = arb_mat([motion.phase])
        change = change - along * (phase * change) * (1 / (phase * along)[0, 0])
    scaled = arb_mat([[change[i, k] * sizes[k] / sizes[i] for k in range(n)] for i in range(n)])
    least, most, power = arb(0), arb(2) ** 900, scaled
    for doubled in range(13):
        exponent = real(fmpq(1, 2**doubled))
        size, trace = _norm(power), abs(power.trace()) / n
        if not (size > 0 and size < arb(2) ** 800 and size > arb(2) ** -800):
            break
        most = most.min(arb(size.upper()) ** exponent)
        if trace > 0:
            least = least.max(arb(trace.lower()) ** exponent)
        power = power * power
    stable = True if most < 1 else False if least > 1 else None
    # Rounded outwards by more than six digits leave out.
    lower, upper = float((least * (1 - arb(2) ** -17)).lower()), float((most * (1 + arb(2) ** -17)).upper())
    return stable, f"between {lower:.6g} and {upper:.6g}"


def _theorem(motion: Motion, data: dict[str, Any], stable: bool | None, largest: str) -> str:
    """Say what is proven."""
    events = len(motion.segments) - 1
    if motion.autonomous:
        lasts = f"a period within {NEAR:g}, relative, of {float(motion.period.mid()):.12g} s"
    else:
        lasts = f"the period {data['periods']} times {data['period']!r} s"
    word = {True: "stable", False: "unstable", None: "neither said to be stable nor unstable"}[stable]
    beside = " but for the one of a shift in time" if motion.autonomous else ""
    return (
        f"The system that is linear between events, with the modes of this file ({data['about']}), their "
        f"numbers taken as exact, has a periodic motion with {lasts}, with the {events} events of this file "
        f"in its order and no other, which begins within {NEAR:g} of the state of this file, as a share of "
        f"the sizes of the states. Within {2.0**RADIUS:.1g} of its start no other start returns with "
        f"these events. It is {word}: the largest modulus of its multipliers{beside} is {largest}."
    )
