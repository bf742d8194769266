"""A motion followed in balls from a ball of starts: matrix exponentials, Taylor's polynomials, event times.

In each mode Z' = M Z, states first, then what forces them; a mode lasts while its event functions,
functionals of Z, are positive. Where one falls to zero, Z is multiplied by a reset and the next mode begins.
The matrix exponentials are over the durations as computed; what the event times differ from them, each
enclosed by an interval Newton step, is left to Taylor's polynomials. The derivative by the start has the jump
of each event in it (Leine and Nijmeijer 2004, chapter 7).
"""

from __future__ import annotations

import copy
import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from flint import arb, arb_mat, ctx, fmpq

from trimmer.proof.balls import about, exact, real
from trimmer.proof.outcome import UndecidedError, require_time
from trimmer.proof.statement import Course, Equations, Row, StatedSpecialPoint

MOST_TERMS = 36  # Of Taylor's polynomials over what an event is later than computed
BY_LAW = 1e-9  # Share of its terms below which something is taken for what the law says: zero
MOST_STEPS = 6000  # Of a segment
RADIUS = -150  # Power of two of the radius of the ball of starts, as a share of the sizes


def matrix(rows: Sequence[Row]) -> arb_mat:
    """Return doubles as exact balls."""
    return arb_mat([[real(exact(each)) for each in row] for row in rows])


@dataclass(frozen=True)
class Segment:
    """One piece of the motion."""

    flow: arb_mat  # M, (N, N)
    functions: arb_mat  # The event functions, (f, N)
    reset: arb_mat  # What becomes of Z before it, (N, N)
    duration: arb  # As computed, s
    fired: int | None  # The event function that ends it; None for the last one
    together: tuple[int, ...]  # Others that are a multiple of it for all Z that this mode can have
    zeros: dict[int, int]  # How many derivatives of event functions vanish at its start, counting the zeroth
    at: arb | None  # When it ends if a clock ends it, s from the start; None for any other
    strict: arb_mat | None  # What is positive then, (m, N)
    n: int  # How many of Z are states
    sizes: list[arb]  # Of Z, N
    # The first three for Z and its derivative by a number: that above, and Z below, (2N,); where nothing is
    # varied, they are themselves
    lifted: tuple[arb_mat, arb_mat, arb_mat]

    @cached_property
    def norm(self) -> arb:
        """The largest sum of moduli of a row of M, or of what is lifted."""
        return norm(self.lifted[0])

    @cached_property
    def balanced(self) -> tuple[list[arb], arb]:
        """Scales of Z, no smaller than the sizes, in which M has a small norm, and that norm."""
        scales = _balanced(self.flow, self.sizes, self.n)
        rows = zip(self.flow.tolist(), scales, strict=True)
        return scales, norm(
            arb_mat(
                [[entry * scale / own for entry, scale in zip(row, scales, strict=True)] for row, own in rows]
            )
        )

    @cached_property
    def count(self) -> int:
        """Steps so short that Taylor's polynomials hold over each; two at least where an event is to come."""
        steps = math.ceil(float((self.balanced[1] * self.duration).upper()))
        return max(1 if self.fired is None else 2, steps)

    @cached_property
    def step(self) -> arb_mat:
        """exp(M duration / count), lifted."""
        if self.count > MOST_STEPS:
            raise UndecidedError(f"a segment is too long for its fastest rate: {self.count} steps")
        return (self.lifted[0] * (self.duration / self.count)).exp()

    @cached_property
    def propagator(self) -> arb_mat:
        """exp(M duration), lifted."""
        return self.step**self.count


@dataclass(frozen=True)
class Followed:
    """A motion from a ball of starts."""

    starts: list[arb_mat]  # Z at the start of each segment, (N, 1)
    ends: list[arb_mat]  # Z at its end, (N, 1)
    lates: list[arb]  # What is to be added to the duration of each, s
    back: list[arb]  # The states at the end, or their mirror image if that is to be the start, n
    change: list[list[arb]]  # Their derivative by what is unknown, n rows


@dataclass(frozen=True)
class Tables:
    """The numbers of the equations, in the units, or by how much they change with a number."""

    flows: list[arb_mat]  # M of each mode
    functions: list[arb_mat]  # Event functions of each mode
    resets: list[arb_mat]  # What becomes of Z before each segment
    forcing: arb_mat  # What forces the states at the start
    period: arb  # How long all takes, s; 0 if that is unknown

    def combined(self, share: arb | fmpq, other: Tables) -> Tables:
        """Return the sum of these and a share of others."""

        def each(own: list[arb_mat], others: list[arb_mat]) -> list[arb_mat]:
            return [one + two * share for one, two in zip(own, others, strict=True)]

        return Tables(
            each(self.flows, other.flows),
            each(self.functions, other.functions),
            each(self.resets, other.resets),
            self.forcing + other.forcing * share,
            self.period + other.period * share,
        )


class BallMotion:
    """The statement's data in balls.

    Args:
        course: The motion.
        equations: Of the system; or the statement with two of them, between which they are a straight line.
    """

    def __init__(self, course: Course, equations: Equations | StatedSpecialPoint) -> None:
        self.course, self.slopes, self.unit = course, None, arb(1)
        sides = (
            [equations] if isinstance(equations, Equations) else [each.equations for each in equations.beside]
        )
        self.n, self.autonomous = len(course.state), sides[0].period is None
        self.count = self.n + len(sides[0].forcing)
        # Powers of two as units of the states change no digit.
        units = [*(math.frexp(each)[1] for each in course.sizes), *(0 for _ in sides[0].forcing)]
        self.units = [arb(2) ** each for each in units]
        self.signs = course.signs or (1,) * self.n
        self.sizes = [*self._in_units(course.sizes), *(arb(1) for _ in sides[0].forcing)]
        self.start = self._in_units(course.state)
        self.shifts = [
            (
                self._in_units(along),
                [real(exact(each)) * unit for each, unit in zip(leader, self.units, strict=False)],
            )
            for along, leader in course.shifts
        ]
        self.tables = self._tables(sides[0])
        if isinstance(equations, StatedSpecialPoint):
            first, last = (exact(each.value) for each in equations.beside)
            change = self._tables(sides[1]).combined(fmpq(-1), self.tables)
            self.unit = arb(2) ** math.frexp(equations.value)[1]
            self.slopes = change.combined(self.unit / real(last - first) - 1, change)
            self.tables = self.tables.combined((exact(equations.value) - first) / (last - first), change)
        self.segments = self._segments(self.tables)

    def _in_units(self, values: Row) -> list[arb]:
        return [real(exact(each)) / unit for each, unit in zip(values, self.units, strict=False)]

    @property
    def unknowns(self) -> int:
        """How many numbers are unknown: start, an unknown period, shifts, the number that is varied."""
        return self.n + self.autonomous + len(self.shifts) + (self.slopes is not None)

    @cached_property
    def period(self) -> arb:
        """The period as computed, s."""
        return sum((each.duration for each in self.segments), arb(0))

    def at(self, off: arb) -> BallMotion:
        """Return the motion at a value that is so much larger, in units of it."""
        assert self.slopes is not None
        found = copy.copy(self)
        found.tables = self.tables.combined(off, self.slopes)
        found.segments = self._segments(found.tables)
        return found

    def _tables(self, given: Equations) -> Tables:
        """Return the numbers of equations in the units."""
        period = arb(0)
        if given.period is not None:
            period = real(exact(given.period)) * real(exact(self.course.periods))
        return Tables(
            [self._square(_padded(matrix(mode.flow), self.count, self.count)) for mode in given.modes],
            [self._rows(matrix(mode.functions)) for mode in given.modes],
            [self._square(matrix(each)) for each in given.resets],
            arb_mat([[real(exact(each))] for each in given.forcing]),
            period,
        )

    def _segments(self, tables: Tables) -> list[Segment]:
        found, by, n, turns = [], self.slopes, self.n, self._rotation(tables.period)
        for each, reset in zip(self.course.segments, range(len(tables.resets)), strict=True):
            mode = each.mode
            three = tables.flows[mode] + turns[0], tables.functions[mode], tables.resets[reset]
            lifted = three
            if by is not None:
                slopes = by.flows[mode] + turns[1] * by.period, by.functions[mode], by.resets[reset]
                lifted = (
                    _blocks([[three[0], slopes[0]], [three[0] * 0, three[0]]]),
                    _blocks([[three[1], slopes[1]]]),
                    _blocks([[three[2], slopes[2]], [three[2] * 0, three[2]]]),
                )
            at = None if each.at is None else real(exact(each.at))
            strict = self._rows(matrix(each.strict)) if each.strict else None
            falls = each.fired, each.together, dict(each.zeros)
            found.append(
                Segment(*three, real(exact(each.duration)), *falls, at, strict, n, self.sizes, lifted)
            )
        return found

    def _rotation(self, period: arb) -> tuple[arb_mat, arb_mat]:
        """Return the flow of what forces the states, orders times 2 pi over a period, and its slope."""
        zeros, orders = [arb(0)] * self.n, self.course.rotation
        table = arb_mat([[arb(0)] * self.count] * self.n + [[*zeros, *map(arb, row)] for row in orders])
        if self.autonomous:
            return table, table
        omega = 2 * arb.pi() * real(exact(self.course.periods)) / period
        return table * omega, table * (-omega / period)

    def _square(self, table: arb_mat) -> arb_mat:
        """Return a matrix from Z to Z in the units."""
        size = range(self.count)
        return arb_mat([[table[i, k] * self.units[k] / self.units[i] for k in size] for i in size])

    def _rows(self, table: arb_mat) -> arb_mat:
        """Return functionals of Z in the units."""
        size = range(self.count)
        return arb_mat([[table[i, k] * self.units[k] for k in size] for i in range(table.nrows())])

    def follow(self, unknown: list[arb], with_change: bool = False) -> Followed:
        """Follow the motion from a ball of what is unknown.

        Args:
            unknown: The states at the start; what an unknown period is longer than computed, s; how far the
                end is shifted; the number that is varied less its value, in its unit.
            with_change: Whether the derivative is wanted too.
        """
        if self.slopes is not None and not unknown[-1].is_zero():
            fixed = [*unknown[:-1], arb(0)]
            return self.at(unknown[-1]).follow(fixed, with_change)
        n, size, unknowns = self.n, self.count, self.unknowns if with_change else 0
        columns, later = self._first(unknown, unknowns)
        total, elapsed = arb(0), arb(0)
        starts, ends, lates = [], [], []
        for segment in self.segments:
            require_time()
            elapsed += segment.duration
            _, functions, reset = segment.lifted
            columns = reset * columns
            starts.append(_column(columns, unknowns, size))
            columns = segment.propagator * columns
            if segment.fired is None:
                known = self.period + unknown[n] if self.autonomous else self.tables.period
                late = (known if segment.at is None else segment.at) - elapsed - total
                columns = _moved(segment, columns, late)
                by_start = later * -1
            else:
                row = arb_mat([[functions[segment.fired, k] for k in range(functions.ncols())]])
                late, slope = _event(segment, row, _column(columns, unknowns, columns.nrows()))
                columns = _moved(segment, columns, late)
                by_start = arb_mat([(row * columns).tolist()[0][:unknowns]]) * (-1 / slope)
            later, total = later + by_start, total + late
            z = _column(columns, unknowns, size)
            columns = columns + _padded((segment.flow * z) * by_start, columns.nrows(), columns.ncols())
            ends.append(z)
            lates.append(late)
        back = [sign * ends[-1][i, 0] for i, sign in enumerate(self.signs)]
        change = [[sign * columns[i, k] for k in range(unknowns)] for i, sign in enumerate(self.signs)]
        for place, (along, _) in enumerate(self.shifts, n + self.autonomous):
            back = [each - unknown[place] * way for each, way in zip(back, along, strict=True)]
            for of_state, way in zip(change, along, strict=True):
                of_state[place : place + 1] = [-way] if unknowns else []
        return Followed(starts, ends, lates, back, change)

    def _first(self, unknown: list[arb], unknowns: int) -> tuple[arb_mat, arb_mat]:
        """Return derivatives of Z by what is unknown with Z behind them, and of how much later it is."""
        n, size, by = self.n, self.count, self.slopes
        z = [*unknown[:n], *(self.tables.forcing[i, 0] for i in range(size - n))]
        table = [[arb(int(i == k < n)) for k in range(unknowns)] + [z[i]] for i in range(size)]
        later = [arb(0)] * unknowns
        if unknowns and self.autonomous:
            later[n] = arb(-1)
        if by is not None:
            table += [[arb(0)] * (unknowns + 1) for _ in range(size)]
            if unknowns:
                later[-1] = -by.period
                for i in range(size):
                    table[i][-2] = arb(0) if i < n else by.forcing[i - n, 0]
                    table[size + i][-2] = z[i]
        return arb_mat(table), arb_mat([later]) if unknowns else arb_mat(1, 0)

    @cached_property
    def phase(self) -> list[arb]:
        """A functional of the start that is to stay as it is: along the rates there, in sizes."""
        z = arb_mat([[each] for each in self.start] + self.tables.forcing.tolist())
        rates = self.segments[0].flow * (self.segments[0].reset * z)
        return [arb((rates[i, 0] / self.sizes[i] ** 2).mid()) for i in range(self.n)]


def _column(table: arb_mat, place: int, rows: int) -> arb_mat:
    return arb_mat([[table[i, place]] for i in range(rows)])


def _blocks(blocks: list[list[arb_mat]]) -> arb_mat:
    """Put blocks together."""
    rows = []
    for line in blocks:
        lists = [each.tolist() for each in line]
        rows += [[entry for part in parts for entry in part] for parts in zip(*lists, strict=True)]
    return arb_mat(rows)


def _padded(table: arb_mat, rows: int, columns: int) -> arb_mat:
    """Fill a table with zeros below and to the right."""
    wide = [[*row, *([arb(0)] * (columns - len(row)))] for row in table.tolist()]
    return arb_mat(wide + [[arb(0)] * columns for _ in range(rows - len(wide))])


def identity(size: int) -> arb_mat:
    """Return the exact identity."""
    return arb_mat([[arb(int(i == k)) for k in range(size)] for i in range(size)])


def moduli(table: arb_mat) -> arb_mat:
    """Return the moduli of all entries."""
    return arb_mat([[abs(each) for each in row] for row in table.tolist()])


def norm(flow: arb_mat) -> arb:
    """Bound the largest sum of moduli of a row."""
    rows = flow.tolist()
    return functools.reduce(arb.max, (arb(sum(map(abs, row), arb(0)).upper()) for row in rows), arb(0))


def _balanced(flow: arb_mat, sizes: list[arb], n: int) -> list[arb]:
    """Choose scales of the states by how much each drives and is driven; what forces them has its sizes."""
    table = [[float(abs(flow[i, k]).upper()) for k in range(n)] for i in range(n)]
    found = [float(each) for each in sizes[:n]]
    for _ in range(20):
        for i in range(n):
            out = sum(table[i][k] * found[k] for k in range(n) if k != i)
            into = sum(table[k][i] / found[k] for k in range(n) if k != i)
            if out > 0 and into > 0:
                found[i] = math.sqrt(out / into)
    largest = max(float(size) / own for size, own in zip(sizes[:n], found, strict=True))
    return [*(arb(largest * each) for each in found), *sizes[n:]]


def _moved(segment: Segment, columns: arb_mat, late: arb) -> arb_mat:
    """Multiply columns by exp(M late), late short: Taylor's polynomial, and a bound of what it lacks."""
    size = arb((segment.norm * late.abs_upper()).upper())
    if not size < 1e-2:
        raise UndecidedError("an event is too far from where it was computed")
    term = found = columns
    k, left = 1, size
    while k < MOST_TERMS and left > arb(2) ** -ctx.prec:
        term = segment.lifted[0] * term * (late / k)
        found, left, k = found + term, left * size, k + 1
    largest = [
        functools.reduce(arb.max, map(abs, column)).upper() for column in zip(*columns.tolist(), strict=True)
    ]
    off = [about((2 * left * each).upper()) for each in largest]
    return found + arb_mat([off for _ in range(found.nrows())])


def _event(segment: Segment, row: arb_mat, y: arb_mat) -> tuple[arb, arb]:
    """Enclose how much later an event function falls to zero, and its rate there."""
    flow, first, z = segment.lifted[0], arb(0), y
    for _ in range(5):
        value, rate = (row * z)[0, 0], (row * (flow * z))[0, 0]
        if not rate < 0:
            raise UndecidedError("an event function does not fall strictly: a grazing, to balls")
        following = arb((first - value / rate).mid())
        if (following - first).contains(0) or value.contains(0):
            break
        first, z = following, _moved(segment, y, following)
    value = (row * z)[0, 0]
    reach = arb((4 * (value / rate).abs_upper()).upper()) + arb(2) ** (3 * RADIUS)
    slope = (row * (flow * _moved(segment, z, about(reach))))[0, 0]
    late = -value / slope
    if not (slope < 0 and about(reach).contains_interior(late)):
        raise UndecidedError("an event time is not enclosed")
    late = first + late
    return late, (row * (flow * _moved(segment, y, late)))[0, 0]
