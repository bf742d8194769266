"""Limit cycles where no bounds of N are known: a grid of amplitude and frequency, and Newton's method.

A cell of the grid is kept where the values of N + 1/G at its corners leave room for a zero: where a disk
about their mean that holds them all, widened, holds zero. Where these are many, the linear function through
the corners has to be zero in the cell or near it, too. Kept cells are cut again and again. Newton's method
starts from those at last left where |N + 1/G| is less than in the cells beside them. That proves nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from trimmer.arrays import ArrayRecord, Complexes, Flags, Reals
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.inverse_response import InverseResponse, Sloped
from trimmer.balance.loop import range_of_roots
from trimmer.balance.search import SearchedRegion, SearchResult
from trimmer.balance.uniqueness import cross, newton_step
from trimmer.elements import ControlElement, Element, ElementAtFrequency, ScaledElement, SumOfElements

DECADES = 8.0  # How far on either side of the element's scale amplitudes are searched
_BEYOND_ROOTS = math.log(1e3)  # How far beyond the roots of G frequencies are searched, in x
_AMPLITUDES = 401
_AMPLITUDES_PER_OMEGA = 65
_OMEGAS = 401
_OMEGAS_OF_MANY = 49
_WIDENED = 1.5
_MARGIN = 1.0  # How far beyond a cell the linear function may be zero, over its width
_PARALLEL = 0.05  # Sine of the angle between the derivatives of F below which that tells nothing
_LEVELS = 16
"""How often cells are cut: N may rise steeply at a threshold, where Newton's method needs a near start."""
_HALVINGS = 40
_MANY_CELLS = 1000
_MOST_CELLS = 5000
_STEPS = 40
_LONGEST = 0.5
_CONVERGED = 1e-9
_SOLVED = 1e-7  # Size of N + 1/G over that of 1/G up to which it counts as zero
_SAME = 1e-5  # Distance in ln u and x below which two solutions are one


class GriddedInverse(Sloped, Protocol):
    """1/G over x = ln omega, of which nothing is bounded."""

    def value(self, x: Reals) -> Complexes:
        """Evaluate 1/G at x of shape (n,)."""


METHOD = "a grid of amplitude and frequency, refined, and Newton's method; nothing is proven"


@dataclass(frozen=True)
class _Grid(ArrayRecord):
    """Cells between some u (from their logarithms) and x, and F = N + 1/G at corners that they share."""

    v_lower: Reals
    v_upper: Reals
    x_lower: Reals
    x_upper: Reals

    def quarters(self) -> _Grid:
        """Cut each cell into four."""
        v, x = 0.5 * (self.v_lower + self.v_upper), 0.5 * (self.x_lower + self.x_upper)
        return _Grid(
            np.concatenate([self.v_lower, v, self.v_lower, v]),
            np.concatenate([v, self.v_upper, v, self.v_upper]),
            np.concatenate([self.x_lower, self.x_lower, x, x]),
            np.concatenate([x, x, self.x_upper, self.x_upper]),
        )


def solve_sampled(
    response: InverseResponse, curve: ElementCurve, omega_range: tuple[float, float] | None
) -> SearchedRegion:
    """Search solutions; ``omega_range`` in rad/s, chosen from the roots of G if None."""
    x_range = range_of_roots(response, _BEYOND_ROOTS)
    if omega_range is not None:
        x_range = math.log(omega_range[0]), math.log(omega_range[1])
    even = np.linspace(*x_range, _OMEGAS_OF_MANY if curve.depends_on_x else _OMEGAS)
    x = even if curve.depends_on_x else np.unique(np.concatenate([even, response.breaks(*x_range)]))
    result = found_on_grid(response, curve, x)
    return SearchedRegion(METHOD, result, (math.exp(x_range[0]), math.exp(x_range[1])), False, 0.0)


def found_on_grid(response: GriddedInverse, curve: ElementCurve, x: Reals) -> SearchResult:
    """Search solutions between the first and the last of some x, between which cells begin, rising (n,)."""
    with np.errstate(all="ignore"):
        cells, examined = _first_cells(response, curve, x)
        for _ in range(_LEVELS):
            if not 0 < cells.v_lower.size <= _MOST_CELLS:
                break
            cells = cells.quarters()
            examined += cells.v_lower.size
            cells = cells[_may_hold(_corners(response, curve, cells))]
        u, x = _solutions(response, curve, cells, (float(x[0]), float(x[-1])))
    return SearchResult(u, x, Cells.none(), examined)


def unproven(curve: ElementCurve, outcome: SearchedRegion) -> tuple[str, ...]:
    """Say what is not proven, in sentences without a full stop; nothing where the element has bounds."""
    element = curve.element
    if element.has_bounds:
        return ()
    lowest, highest = (element.amplitude_scale * 10.0**power for power in (-DECADES, DECADES))
    sentences = [
        f"{element!r} has no bounds of its describing function: amplitudes from {lowest:.3g} to "
        f"{highest:.3g} were searched on a grid, and limit cycles between its points, or beyond them, may be "
        "missing from the list"
    ]
    amplitudes = curve.amplitude(outcome.result.u)
    if np.isnan(element.mean_gain(amplitudes)).any():
        sentences.append(
            "how the mean of the input passes the element is not known: a limit cycle that is called stable "
            "may run away with its mean"
        )
    return (*sentences, *(doubt for part in _parts(element) for doubt in _doubts(part, amplitudes)))


def _parts(element: Element) -> Iterator[Element]:
    match element:
        case SumOfElements():
            for term in element.terms:
                yield from _parts(term)
        case ScaledElement() | ElementAtFrequency():
            yield from _parts(element.element)
        case _:
            yield element


def _doubts(element: Element, amplitudes: Reals) -> Iterator[str]:
    if isinstance(element, ControlElement):
        for amplitude in amplitudes:
            yield from element.doubts_at(float(amplitude))


def _first_cells(response: GriddedInverse, curve: ElementCurve, x: Reals) -> tuple[_Grid, int]:
    """Evaluate the whole grid, and return the cells that may hold a solution, and the number of all."""
    both = curve.depends_on_x
    limit = DECADES * math.log(10.0)
    v = np.linspace(-limit, limit, _AMPLITUDES_PER_OMEGA if both else _AMPLITUDES)
    if not both:
        v = _with_edge(curve, v)
    elif np.isfinite(_largest(curve, x)).all():
        v = np.unique(np.concatenate([v[v < 0], -(0.5 ** np.arange(_HALVINGS))]))
    gains = (
        curve.value(_u(curve, np.repeat(v, x.size), np.tile(x, v.size)), np.tile(x, v.size)).reshape(
            -1, x.size
        )
        if both
        else curve.value(np.exp(v), np.zeros_like(v))[:, None]
    )
    excess = gains + response.value(x)
    corners = np.array([excess[:-1, :-1], excess[1:, :-1], excess[:-1, 1:], excess[1:, 1:]])
    row, column = np.nonzero(_may_hold(corners))
    return _Grid(v[row], v[row + 1], x[column], x[column + 1]), (v.size - 1) * (x.size - 1)


def _corners(response: GriddedInverse, curve: ElementCurve, cells: _Grid) -> Complexes:
    """Return F at the four corners, shape (4, n); N is evaluated once where several cells share it."""
    v = np.concatenate([cells.v_lower, cells.v_upper, cells.v_lower, cells.v_upper])
    x = np.concatenate([cells.x_lower, cells.x_lower, cells.x_upper, cells.x_upper])
    points = np.stack([v, x if curve.depends_on_x else np.zeros_like(x)])
    distinct, place = np.unique(points, axis=1, return_inverse=True)
    gains = curve.value(_u(curve, *distinct), distinct[1])[place.ravel()]
    return np.asarray((gains + response.value(x)).reshape(4, -1))


def _may_hold(corners: Complexes) -> Flags:
    """Return whether cells may hold a zero, from F at the corners, both lower, u, x, both upper: (4, ...)."""
    centre = corners.mean(axis=0)
    near: Flags = np.asarray(np.abs(centre) <= _WIDENED * np.abs(corners - centre).max(axis=0))
    return near & _linear_part_may_vanish(corners, centre) if np.count_nonzero(near) > _MANY_CELLS else near


def _linear_part_may_vanish(corners: Complexes, centre: Complexes) -> Flags:
    """Return whether the linear function through the corners is zero in a cell or near it."""
    by_v = 0.5 * (corners[1] + corners[3] - corners[0] - corners[2])
    by_x = 0.5 * (corners[2] + corners[3] - corners[0] - corners[1])
    across = np.abs(cross(by_v, by_x))
    limit = (0.5 + _MARGIN) * across
    aside = (np.abs(cross(centre, by_x)) > limit) | (np.abs(cross(by_v, centre)) > limit)
    parallel = across <= _PARALLEL * np.abs(by_v) * np.abs(by_x)
    return np.asarray(parallel | ~aside)


def _with_edge(curve: ElementCurve, v: Reals) -> Reals:
    """Add places ever nearer to where N ceases to exist, of which an element without bounds tells nothing."""
    exists = np.isfinite(curve.value(np.exp(v), np.zeros_like(v)))
    added = [v]
    for place in np.flatnonzero(exists[:-1] != exists[1:]):
        inside, outside = (v[place], v[place + 1]) if exists[place] else (v[place + 1], v[place])
        for _ in range(_HALVINGS):
            middle = 0.5 * (inside + outside)
            found = bool(np.isfinite(curve.value(np.exp(np.full(1, middle)), np.zeros(1)))[0])
            inside, outside = (middle, outside) if found else (inside, middle)
        start = v[place] if exists[place] else v[place + 1]
        added += [np.array([inside]), inside + (start - inside) * 0.5 ** np.arange(_HALVINGS)]
    return np.unique(np.concatenate(added))


def _solutions(
    response: GriddedInverse, curve: ElementCurve, cells: _Grid, x_range: tuple[float, float]
) -> tuple[Reals, Reals]:
    """Solve by Newton's method, and return the distinct solutions."""
    u, x = _starts(response, curve, cells)
    steps = np.full(u.size, np.inf)
    for _ in range(_STEPS):
        moving = np.flatnonzero(~(steps <= _CONVERGED) & np.isfinite(u) & np.isfinite(x))
        if not moving.size:
            break
        u_step, x_step = newton_step(response, curve, u[moving], x[moving])
        relative = u_step / u[moving]
        size = np.maximum(np.abs(relative), np.abs(x_step))
        shortened = np.minimum(1.0, _LONGEST / size)
        u[moving] *= 1.0 + relative * shortened
        x[moving] += x_step * shortened
        steps[moving] = size
    inverse = response.value(x)
    zero = np.abs(curve.value(u, x) + inverse) <= _SOLVED * np.abs(inverse)
    limit = DECADES * math.log(10.0)
    inside = (np.abs(np.log(u)) <= limit) & (x >= x_range[0]) & (x <= x_range[1])
    return _distinct(u[zero & inside], x[zero & inside])


def _starts(response: GriddedInverse, curve: ElementCurve, cells: _Grid) -> tuple[Reals, Reals]:
    """Return u and x of the middles of the cells at which |F| is least among those that touch."""
    v, x = 0.5 * (cells.v_lower + cells.v_upper), 0.5 * (cells.x_lower + cells.x_upper)
    u = _u(curve, v, x)
    size = np.abs(curve.value(u, x) + response.value(x))
    v_reach, x_reach = 1.1 * (cells.v_upper - cells.v_lower), 1.1 * (cells.x_upper - cells.x_lower)
    least = np.ones(v.size, dtype=bool)
    for each in range(v.size):
        beside = (np.abs(v - v[each]) <= v_reach) & (np.abs(x - x[each]) <= x_reach)
        least[each] = bool(np.isfinite(size[each]) and size[each] <= np.nanmin(size[beside]))
    return u[least], x[least]


def _u(curve: ElementCurve, v: Reals, x: Reals) -> Reals:
    """Return u of v = ln u; over its largest value where that is finite and changes with x, all (n,)."""
    largest = _largest(curve, x) if curve.depends_on_x else 1.0
    return np.asarray(np.exp(v) * np.where(np.isfinite(largest), largest, 1.0))


def _largest(curve: ElementCurve, x: Reals) -> Reals:
    return np.broadcast_to(curve.element.domain(np.exp(x)), x.shape)


def _distinct(u: Reals, x: Reals) -> tuple[Reals, Reals]:
    kept: list[int] = []
    for each in range(u.size):
        apart = [max(abs(math.log(u[each] / u[other])), abs(x[each] - x[other])) for other in kept]
        if min(apart, default=math.inf) > _SAME:
            kept.append(each)
    return u[kept], x[kept]
