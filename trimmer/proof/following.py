"""A motion followed in balls from a ball of starts: matrix exponentials, Taylor's polynomials, event times.

In each mode Z' = M Z, states first, then what forces them; a mode lasts while its event functions,
functionals of Z, are positive. Where one falls to zero, Z is multiplied by a reset and the next mode begins.
The matrix exponentials are over the durations as computed; what the event times differ from them, each
enclosed by an interval Newton step, is left to Taylor's polynomials. The derivative by the start has the jump
of each event in it (Leine and Nijmeijer 2004, chapter 7).
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from flint import arb, arb_mat

from trimmer.proof.balls import about, exact, real
from trimmer.proof.undecided import RefutedError, UndecidedError

ORBIT_PRECISION = 448
"""Bits: enough for balls that grow by a factor e with each step of 1/|M|."""
MOST_TERMS = 12
"""Of Taylor's polynomials over what an event is later than computed."""
RADIUS = -150
"""Power of two of the radius of the ball of starts, as a share of the sizes."""


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
        return norm(self.flow)

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
        if not _returns(data["rotation"]) or not all(
            row[k] == int(i == k)
            for each in data["segments"]
            for i, row in enumerate(each["reset"][self.n :], self.n)
            for k in range(len(row))
        ):
            raise RefutedError("what forces the states does not return")
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

    @cached_property
    def phase(self) -> list[arb]:
        """A functional of the start that is to stay as it is: along the rates there, in sizes."""
        z = self.segments[0].reset * arb_mat([[each] for each in [*self.start, *self.forcing]])
        rates = self.segments[0].flow * z
        return [arb((rates[i, 0] / self.sizes[i] ** 2).mid()) for i in range(self.n)]


def _returns(orders: list[list[int]]) -> bool:
    """Return whether exp(2 pi R) = 1 of whole numbers R: antisymmetric, -R^2 diagonal, of squares."""
    table, size = [[int(each) for each in row] for row in orders], range(len(orders))
    opposite = [[-table[k][i] for k in size] for i in size]
    squares = [[-sum(table[i][j] * table[j][k] for j in size) for k in size] for i in size]
    return opposite == table and all(
        squares[i][k] == (math.isqrt(squares[i][k]) ** 2 if i == k else 0) for i in size for k in size
    )


def identity(size: int) -> arb_mat:
    """Return the exact identity."""
    return arb_mat([[arb(int(i == k)) for k in range(size)] for i in range(size)])


def norm(flow: arb_mat) -> arb:
    """Bound the largest sum of moduli of a row."""
    rows = flow.tolist()
    return functools.reduce(arb.max, (arb(sum(map(abs, row), arb(0)).upper()) for row in rows), arb(0))


def _moved(segment: Segment, columns: arb_mat, late: arb) -> arb_mat:
    """Multiply columns by exp(M late), late short: Taylor's polynomial, and a bound of what it lacks."""
    size = arb((segment.norm * late.abs_upper()).upper())
    if not size < 1e-2:
        raise UndecidedError("an event is too far from where it was computed")
    term = found = columns
    k, left = 1, size
    while k < MOST_TERMS and left > arb(2) ** -ORBIT_PRECISION:
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
