"""A motion followed in balls from a ball of starts: matrix exponentials and event times.

In each mode Z' = M Z, states first, then what forces them; a mode lasts while its event functions,
functionals of Z, are positive. Where one falls to zero, Z is multiplied by a reset and the next mode begins.
The matrix exponentials are over the durations as computed; what the event times differ from them, each
enclosed by an interval Newton step, is left to another exponential. The derivative by the start has the jump
of each event in it (Leine and Nijmeijer 2004, chapter 7).
"""

from __future__ import annotations

import copy
import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from flint import arb, arb_mat

from trimmer.proof import statement
from trimmer.proof.balls import about
from trimmer.proof.outcome import UndecidedError, require_time
from trimmer.proof.statement import Course, Equations, Row, StatedSpecialPoint

PRECISION = 1408  # Bits; balls grow by about a factor e with each step of 1/|M|
RADIUS = -640  # Power of two of the radius of the ball of starts, as a share of the sizes
BY_LAW = 1e-9  # Share of its terms below which something is taken for what the law says: zero
MOST_STEPS = 6000  # Of a segment


def diagonal(values: Sequence[arb | int]) -> arb_mat:
    """Return a matrix of values on its diagonal."""
    return arb_mat(
        [[arb(value) if i == k else arb(0) for k in range(len(values))] for i, value in enumerate(values)]
    )


@dataclass(frozen=True)
class Segment:
    """One piece of the motion."""

    told: statement.Segment  # As the file has it
    flow: arb_mat  # M, (N, N)
    functions: arb_mat  # The event functions, (f, N)
    reset: arb_mat  # What becomes of Z before it, (N, N)
    strict: arb_mat  # What is positive when it ends, (m, N)
    scales: list[arb]  # Of Z, N, no smaller than the sizes, in which M has a small norm
    # The first three for Z and its derivative by a number: that above, and Z below, (2N,); where nothing is
    # varied, they are themselves
    lifted: tuple[arb_mat, arb_mat, arb_mat]

    @property
    def duration(self) -> arb:
        """As computed, s."""
        return arb(self.told.duration)

    @cached_property
    def norm(self) -> arb:
        """The largest sum of moduli of a row of M, or of what is lifted."""
        return norm(self.lifted[0])

    @cached_property
    def rate(self) -> arb:
        """The same of M in the scales."""
        return norm(diagonal([1 / each for each in self.scales]) * self.flow * diagonal(self.scales))

    @cached_property
    def count(self) -> int:
        """Steps so short that Taylor's polynomials hold over each; two at least where an event is to come."""
        steps = math.ceil(float((self.rate * self.duration).upper()))
        return max(1 if self.told.fired is None else 2, steps)

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


class Tables(NamedTuple):
    """The numbers of the equations, in the units, or by how much they change with a number."""

    flows: list[arb_mat]  # M of each mode, without what turns
    functions: list[arb_mat]  # Event functions of each mode
    resets: list[arb_mat]  # What may become of Z
    forcing: list[arb]  # What forces the states at the start
    period: list[arb]  # How long all takes, s; 0 if that is unknown

    def combined(self, share: arb, other: Tables) -> Tables:
        """Return the sum of these and a share of others."""
        pairs: Any = zip(self, other, strict=True)
        return Tables(*([a + b * share for a, b in zip(one, two, strict=True)] for one, two in pairs))


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
        ones = (1.0,) * len(sides[0].forcing)
        self.count = self.n + len(ones)
        # Powers of two as units of the states change no digit.
        self.units = [
            arb(2) ** (math.frexp(each)[1] if k < self.n else 0)
            for k, each in enumerate((*course.sizes, *ones))
        ]
        self.sizes = [arb(each) / unit for each, unit in zip((*course.sizes, *ones), self.units, strict=True)]
        self.start = [arb(each) / unit for each, unit in zip(course.state, self.units, strict=False)]
        self.tables = self._tables(sides[0])
        if isinstance(equations, StatedSpecialPoint):
            first, last = (arb(each.value) for each in equations.beside)
            change = self._tables(sides[1]).combined(arb(-1), self.tables)
            self.unit = arb(2) ** math.frexp(equations.value)[1]
            self.slopes = change.combined(self.unit / (last - first) - 1, change)
            self.tables = self.tables.combined((arb(equations.value) - first) / (last - first), change)
        self.segments = self._segments(self.tables)

    @property
    def unknowns(self) -> int:
        """How many numbers are unknown: start, an unknown period, the number that is varied."""
        return self.n + self.autonomous + (self.slopes is not None)

    @cached_property
    def period(self) -> arb:
        """The period as computed, s."""
        return sum((each.duration for each in self.segments), arb(0))

    def at(self, off: arb, varied: bool = True) -> BallMotion:
        """Return the motion at a value that is so much larger, in units of it; varied on, or fixed."""
        assert self.slopes is not None
        found = copy.copy(self)
        found.tables = self.tables.combined(off, self.slopes)
        found.slopes = self.slopes if varied else None
        found.segments = found._segments(found.tables)
        return found

    @cached_property
    def mirror(self) -> arb_mat:
        """What makes the start of the end; one where that is the end itself."""
        signs = [*(self.course.signs or (1,) * self.n), *(1 for _ in range(self.count - self.n))]
        for *pair, order in self.course.turning if self.course.signs else ():
            for place in pair:
                signs[self.n + place] = (-1) ** order
        return diagonal(signs)

    def rows(self, table: Sequence[Row]) -> arb_mat:
        """Return functionals of Z in the units, (m, N)."""
        return (
            arb_mat([list(each) for each in table]) * diagonal(self.units)
            if table
            else arb_mat(0, self.count)
        )

    def _tables(self, given: Equations) -> Tables:
        """Return the numbers of equations in the units."""
        period = arb(0)
        if given.period is not None:
            period = arb(given.period) * arb(self.course.periods)
        inverse = diagonal([1 / each for each in self.units])
        still = ((0.0,) * self.count,) * (self.count - self.n)
        return Tables(
            [inverse * self.rows((*mode.flow, *still)) for mode in given.modes],
            [self.rows(mode.functions) for mode in given.modes],
            [inverse * self.rows(each) for each in given.resets],
            [arb(each) for each in given.forcing],
            [period],
        )

    def _segments(self, tables: Tables) -> list[Segment]:
        found, by, same = [], self.slopes, diagonal([1] * self.count)
        turning = same * 0
        for first, second, order in self.course.turning:
            i, k = self.n + first, self.n + second
            turning[i, k], turning[k, i] = arb(order), arb(-order)
        if not self.autonomous:
            turning = turning * (2 * arb.pi() * arb(self.course.periods) / tables.period[0])
        for each in self.course.segments:
            mode, reset = each.mode, same if each.reset is None else tables.resets[each.reset]
            three = tables.flows[mode] + turning, tables.functions[mode], reset
            scales = _balanced(three[0], self.sizes, self.n)
            lifted = three
            if by is not None:
                faster = turning * (-by.period[0] / tables.period[0]) if not self.autonomous else turning
                jump = same * 0 if each.reset is None else by.resets[each.reset]
                zero = same * 0
                lifted = (
                    blocks([[three[0], by.flows[mode] + faster], [zero, three[0]]]),
                    blocks([[three[1], by.functions[mode]]]),
                    blocks([[three[2], jump], [zero, three[2]]]),
                )
            found.append(Segment(each, *three, self.rows(each.strict), scales, lifted))
        return found

    def follow(self, unknown: list[arb], with_change: bool = False) -> Followed:
        """Follow the motion from a ball of what is unknown.

        Args:
            unknown: The states at the start; what an unknown period is longer than computed, s; the number
                that is varied less its value, in its unit.
            with_change: Whether the derivative is wanted too.
        """
        if self.slopes is not None and not (with_change and unknown[-1].is_zero()):
            fixed = [*unknown[:-1], *[arb(0)] * with_change]
            return self.at(unknown[-1], with_change).follow(fixed, with_change)
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
            if segment.told.fired is None:
                known = self.period + unknown[n] if self.autonomous else self.tables.period[0]
                at = segment.told.at
                late = (known if at is None else arb(at)) - elapsed - total
                columns = _moved(segment, columns, late)
                by_start = later * -1
            else:
                row = arb_mat([functions.tolist()[segment.told.fired]])
                late, slope = _event(segment, row, _column(columns, unknowns, columns.nrows()))
                columns = _moved(segment, columns, late)
                by_start = arb_mat([(row * columns).tolist()[0][:unknowns]]) * (-1 / slope)
            later, total = later + by_start, total + late
            z = _column(columns, unknowns, size)
            rates = [*(segment.flow * z).entries(), *([arb(0)] * (columns.nrows() - size))]
            columns = columns + _upright(rates) * arb_mat([[*by_start.entries(), arb(0)]])
            ends.append(z)
            lates.append(late)
        back = (self.mirror * ends[-1]).entries()[:n]
        change = (self.mirror * arb_mat(columns.tolist()[:size])).tolist()
        return Followed(starts, ends, lates, back, [row[:unknowns] for row in change[:n]])

    def _first(self, unknown: list[arb], unknowns: int) -> tuple[arb_mat, arb_mat]:
        """Return derivatives of Z by what is unknown with Z behind them, and of how much later it is."""
        n, size, by = self.n, self.count, self.slopes
        z = [*unknown[:n], *self.tables.forcing]
        table = [[arb(int(i == k < n)) for k in range(unknowns)] + [z[i]] for i in range(size)]
        later = [arb(0)] * unknowns
        if unknowns and self.autonomous:
            later[n] = arb(-1)
        if by is not None:
            table += [[arb(0)] * (unknowns + 1) for _ in range(size)]
            if unknowns:
                later[-1] = -by.period[0]
                for i in range(size):
                    table[i][-2] = arb(0) if i < n else by.forcing[i - n]
                    table[size + i][-2] = z[i]
        return arb_mat(table), arb_mat([later]) if unknowns else arb_mat(1, 0)

    @cached_property
    def phase(self) -> list[arb]:
        """A functional of the start that is to stay as it is: along the rates there, in sizes."""
        rates = self.segments[0].flow * _upright([*self.start, *self.tables.forcing])
        return [arb((rates[i, 0] / self.sizes[i] ** 2).mid()) for i in range(self.n)]


def _upright(values: Sequence[arb]) -> arb_mat:
    return arb_mat([[each] for each in values])


def _column(table: arb_mat, place: int, rows: int) -> arb_mat:
    return arb_mat([[table[i, place]] for i in range(rows)])


def blocks(blocks: list[list[arb_mat]]) -> arb_mat:
    """Put blocks together."""
    rows = []
    for line in blocks:
        lists = [each.tolist() for each in line]
        rows += [[entry for part in parts for entry in part] for parts in zip(*lists, strict=True)]
    return arb_mat(rows)


def block(table: arb_mat, size: int) -> arb_mat:
    """Return what of a matrix, lifted or not, is for Z alone."""
    return arb_mat([row[:size] for row in table.tolist()[:size]])


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
    """Multiply columns by exp(M late), late short."""
    if not segment.norm * late.abs_upper() < 1e-2:
        raise UndecidedError("an event is too far from where it was computed")
    return (segment.lifted[0] * late).exp() * columns


def _event(segment: Segment, row: arb_mat, z: arb_mat) -> tuple[arb, arb]:
    """Enclose how much later an event function falls to zero, and its rate there."""
    flow, first = segment.lifted[0], arb(0)
    for _ in range(5):
        value, rate = (row * z)[0, 0], (row * (flow * z))[0, 0]
        if not rate < 0:
            raise UndecidedError("an event function does not fall strictly: a grazing, to balls")
        following = arb((first - value / rate).mid())
        if (following - first).contains(0) or value.contains(0):
            break
        first, z = following, _moved(segment, z, following - first)
    value = (row * z)[0, 0]
    reach = arb((4 * (value / rate).abs_upper()).upper()) + arb(2) ** (3 * RADIUS)
    slope = (row * (flow * _moved(segment, z, about(reach))))[0, 0]
    late = -value / slope
    if not (slope < 0 and about(reach).contains_interior(late)):
        raise UndecidedError("an event time is not enclosed")
    return first + late, (row * (flow * _moved(segment, z, late)))[0, 0]
