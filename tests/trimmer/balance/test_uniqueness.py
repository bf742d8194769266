"""The test of cells: exact where F = N + 1/G is linear, and never sharper than the disks of its slopes
allow."""

from dataclasses import dataclass, field

import numpy as np
import pytest

from trimmer.arrays import Complexes, Flags, Reals
from trimmer.balance.cells import Cells
from trimmer.balance.inverse_response import Enclosure
from trimmer.balance.uniqueness import CellTest, examine, solve_in
from trimmer.elements.expansion import Expansion


@dataclass(frozen=True)
class Plane:
    """F = p (u - u0) + q (x - x0), as N = p (u - u0) + r (x - x0) and 1/G the rest, with disks of slopes.

    The slopes may differ from p by ``u_radius`` and from q by ``x_radius``, of which 1/G has its ``share``.
    """

    p: complex
    q: complex
    u: float
    x: float
    u_radius: float = 0.0
    x_radius: float = 0.0
    share: float = 0.5
    edge: float = np.inf
    bent: float = 0.0
    r: complex = 0.3 - 0.8j
    limits: Cells = field(default_factory=lambda: cells(-np.inf, np.inf, -np.inf, np.inf))

    def enclose(self, lower: Reals, upper: Reals) -> Enclosure:
        assert np.all(lower <= upper)
        centre, slope = self.value_and_slope(0.5 * (lower + upper))
        nothing = np.zeros(lower.shape)
        return Enclosure(centre, slope, nothing, nothing + self.share * self.x_radius, nothing, nothing)

    def value_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        away = x - self.x
        value, slope = self.q * away * (1.0 + self.bent * away), self.q * (1.0 + 2.0 * self.bent * away)
        return value - self.r * away, slope - self.r

    def expansion(self, u: Reals, x: Reals) -> Expansion:
        away = u - self.u
        return Expansion(
            self.p * away * (1.0 + self.bent * away) + self.r * (x - self.x),
            self.p * (1.0 + 2.0 * self.bent * away),
            np.full(u.shape, self.r),
        )

    def variation(self, regions: Cells) -> tuple[Reals, Reals]:
        nothing = np.zeros(len(regions))
        return nothing + self.u_radius, nothing + (1.0 - self.share) * self.x_radius

    def inside(self, regions: Cells) -> Flags:
        return np.asarray(regions.u_upper <= self.edge)

    def test(self, boxes: Cells, regions: Cells | None = None) -> CellTest:
        return examine(self, self, boxes, boxes if regions is None else regions)


def cells(*limits: float) -> Cells:
    return Cells(*(np.array([limit], float) for limit in limits))


def random_boxes(random: np.random.Generator, count: int) -> tuple[Cells, Cells]:
    """Boxes, and regions that hold them but have other centres."""
    centre, half = random.uniform(-1, 1, (2, count)), random.uniform(0.05, 0.6, (2, count))
    lower, upper = centre - half, centre + half
    wider = [side + sign * random.uniform(0.0, 0.4, (2, count)) for side, sign in ((lower, -1), (upper, 1))]
    return Cells(lower[0], upper[0], lower[1], upper[1]), Cells(
        wider[0][0], wider[1][0], wider[0][1], wider[1][1]
    )


def slopes(random: np.random.Generator) -> tuple[complex, complex]:
    p, q = random.normal(size=2) + 1j * random.normal(size=2)
    return complex(p), complex(q)


def test_a_linear_f_is_decided_exactly() -> None:
    """A box is empty if and only if the one solution lies outside of it as far as from the region's
    middle."""
    random = np.random.default_rng(11)
    for _ in range(30):
        p, q = slopes(random)
        plane = Plane(p, q, *random.uniform(-1, 1, 2))
        boxes, regions = random_boxes(random, 200)
        found = plane.test(boxes, regions)
        u_reach = np.maximum(boxes.u_upper - regions.u_centre, regions.u_centre - boxes.u_lower)
        x_reach = np.maximum(boxes.x_upper - regions.x_centre, regions.x_centre - boxes.x_lower)
        outside = (np.abs(plane.u - regions.u_centre) > u_reach) | (
            np.abs(plane.x - regions.x_centre) > x_reach
        )
        assert np.array_equal(found.empty, outside)
        assert found.single.all()
        assert found.u == pytest.approx(np.clip(plane.u, regions.u_lower, regions.u_upper))
        assert found.x == pytest.approx(np.clip(plane.x, regions.x_lower, regions.x_upper))


def test_parallel_slopes_prove_nothing_of_uniqueness() -> None:
    plane = Plane(1.0 + 2.0j, -2.0 - 4.0j, 0.0, 0.0, r=0.5)
    with np.errstate(all="ignore"):
        found = plane.test(cells(-1.0, 1.0, -1.0, 1.0))
    assert not found.single[0]
    assert not found.empty[0]


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
@pytest.mark.parametrize(("u_radius", "x_radius"), [(0.0, 1.0), (1.0, 0.0), (1.0, 1.0), (1.0, 0.4)])
@pytest.mark.parametrize("turn", [1.0, np.exp(2j)])
def test_uniqueness_is_claimed_up_to_where_slopes_can_be_parallel(
    share: float, u_radius: float, x_radius: float, turn: complex
) -> None:
    """With p = 3 and q = 2j and disks of radius r_u and r_x, 6 > 2 r_u + 3 r_x + r_u r_x decides.

    By a and b in the disks the cross product changes by cross(a, q) + cross(p, b) + cross(a, b), in size at
    most the right side. With one disk alone that is reached, so the slopes can then be parallel just beyond
    it.
    """
    square, linear = u_radius * x_radius, 2.0 * u_radius + 3.0 * x_radius
    r = 6.0 / linear if square == 0.0 else (np.sqrt(linear**2 + 24.0 * square) - linear) / (2.0 * square)
    for factor, proven in ((0.999, True), (1.001, False)):
        plane = Plane(3.0 * turn, 2.0j * turn, 0.0, 0.0, factor * r * u_radius, factor * r * x_radius, share)
        assert plane.test(cells(-0.1, 0.1, -0.1, 0.1)).single[0] == proven


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("turn", [1.0, np.exp(2j), -1.0])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_emptiness_is_claimed_up_to_what_the_disks_can_make_up_for(
    share: float, turn: complex, sign: float
) -> None:
    """With p = 3 and q = 2j and the box |u| <= 0.2, |x| <= 0.4 the two parts of F are 3 (u - u0) and 2 (x -
    x0).

    Both may be off by 0.2 r_u + 0.4 r_x = 0.18. So u0 has to be beyond 0.2 + 0.18/3, or x0 beyond 0.4 +
    0.18/2.
    """
    box = cells(-0.2, 0.2, -0.4, 0.4)
    for factor, empty in ((1.001, True), (0.999, False)):
        for u, x in ((0.26 * factor, 0.0), (0.0, 0.49 * factor)):
            plane = Plane(3.0 * turn, 2.0j * turn, sign * u, sign * x, 0.3, 0.3, share)
            assert plane.test(box).empty[0] == empty


def test_nothing_is_claimed_of_a_region_that_leaves_the_domain() -> None:
    boxes, regions = cells(0.0, 1.0, 0.0, 1.0), cells(-0.5, 1.5, -0.5, 1.5)
    for edge, known in ((1.6, True), (1.4, False)):
        found = Plane(1.0, 1.0j, 9.0, 9.0, edge=edge).test(boxes, regions)
        assert found.empty[0] == found.single[0] == known


def test_newtons_method_converges_inside_a_box_and_says_where_it_did_not() -> None:
    """Of three boxes one holds the solution of a bent F, one is empty, one holds it too and need not go
    on."""
    plane = Plane(1.0 + 0.5j, -0.3 + 1.0j, 1.0, 2.0, bent=0.2)
    boxes = Cells(
        np.array([0.8, 3.0, 0.99]),
        np.array([1.2, 3.1, 1.4]),
        np.array([1.8, 4.0, 1.9]),
        np.array([2.2, 4.1, 2.3]),
    )
    u, x, solved = solve_in(plane, plane, boxes, np.array([1.02, 3.05, 1.4]), np.array([2.02, 4.05, 2.3]))
    assert solved.tolist() == [True, False, False]
    assert (u[0], x[0]) == (pytest.approx(1.0, abs=1e-12), pytest.approx(2.0, abs=1e-12))
    (alone,) = (solve_in(plane, plane, boxes[np.array([2])], np.array([1.4]), np.array([2.3])),)
    assert alone[2].tolist() == [True]
    assert alone[0] == pytest.approx([1.0], abs=1e-12)
