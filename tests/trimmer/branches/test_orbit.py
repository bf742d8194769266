"""Newton's method for one orbit, on maps whose orbits are known, in units far from 1."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import pytest

from tests.trimmer.branches.maps import Given, Single
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.period_maps.period_map import Phase
from trimmer.errors import UnsupportedMotionError

A = np.array([[0.4, 3e4], [-2e-6, 0.1]])
B, C = np.array([0.02, 5e-7]), np.array([1.5, -3e-5])
SIZES, SPAN = np.array([2.0, 4e-5]), 691.0


@dataclass(frozen=True, eq=False)
class TurnedPassage(Given):
    """A passage whose multipliers are not those of its derivative, as without a drive."""

    @property
    def monodromy(self) -> np.ndarray:
        return 3.0 * self.jacobian


@dataclass(frozen=True)
class Affine(Single):
    """x -> A x + b p + c: the orbit is (1 - A)^-1 (b p + c)."""

    matrix: np.ndarray = field(default_factory=lambda: A)
    size: int = 2
    mirrored: bool = False

    def passage(self, value: float, state: np.ndarray) -> Given:
        if value < 0.0:
            raise UnsupportedMotionError("it cannot be followed")
        end = self.matrix @ state + B * value + C
        signature = {("stop", Phase.UPPER): 2, ("stop", Phase.LOWER): 0}
        return TurnedPassage(end, self.matrix, B, abs(state), signature)


@dataclass(frozen=True)
class Missing(Single):
    """x -> x + m(x) with a miss m and its derivative that are given."""

    miss: Callable[[float], float]
    slope: Callable[[float], float]
    asked: list[float] = field(default_factory=list)
    size: int = 1
    mirrored: bool = False

    def passage(self, value: float, state: np.ndarray) -> Given:
        x = float(state[0])
        self.asked.append(x)
        end, slope = np.array([x + self.miss(x)]), np.array([[1.0 + self.slope(x)]])
        return Given(end, slope, np.zeros(1), np.ones(1))


def orbit(value: float) -> np.ndarray:
    return np.linalg.solve(np.eye(2) - A, B * value + C)


def placed(value: float, state: np.ndarray) -> Place:
    problem = Problem(Affine(), SPAN, SIZES)
    place = problem.place(problem.position(value, state))
    assert place is not None
    return place


def test_coordinates_have_no_units() -> None:
    problem = Problem(Affine(), SPAN, SIZES)
    position = problem.position(1382.0, np.array([3.0, 2e-5]))
    assert position == pytest.approx([1.5, 0.5, 2.0], rel=1e-14)
    assert problem.value(position) == pytest.approx(1382.0, rel=1e-14)
    assert problem.state(position) == pytest.approx([3.0, 2e-5], rel=1e-14)


def test_miss_and_slope_are_those_of_the_map_in_these_coordinates() -> None:
    state = np.array([3.0, 2e-5])
    place = placed(300.0, state)
    assert place.miss == pytest.approx((A @ state + B * 300.0 + C - state) / SIZES, rel=1e-12)
    assert place.error == max(abs(place.miss))
    expected = np.array([[0.4, 3e4 * 4e-5 / 2.0], [-2e-6 * 2.0 / 4e-5, 0.1]])
    assert place.jacobian == pytest.approx(expected, rel=1e-14)
    assert place.monodromy == pytest.approx(3.0 * expected, rel=1e-14)
    assert sorted(place.multipliers.imag) == pytest.approx(sorted((3.0 * np.linalg.eigvals(A)).imag))
    assert place.slope[:, :2] == pytest.approx(expected - np.eye(2), rel=1e-14)
    assert place.slope[:, 2] == pytest.approx(B / SIZES * SPAN, rel=1e-14)
    assert place.signature == {(("stop", Phase.UPPER), 2)}


def test_the_tangent_leads_along_the_branch_in_the_direction_of_a_reference() -> None:
    place = placed(300.0, orbit(300.0))
    along = np.append((orbit(301.0) - orbit(300.0)) / SIZES * SPAN, 1.0)
    unit = along / np.linalg.norm(along)
    for reference in (np.array([0.0, 0.0, 1.0]), np.array([-1.0, 0.5, 0.0])):
        tangent = place.tangent(reference)
        assert tangent == pytest.approx(math.copysign(1.0, reference @ unit) * unit, rel=1e-9)
    assert place.orientation(unit) == pytest.approx(np.linalg.det(np.vstack([place.slope, unit])), rel=1e-12)
    # Across the branch there is no tangent.
    assert place.tangent(np.zeros(3)) is None


@pytest.mark.parametrize("normal", [np.array([0.0, 0.0, -2.0]), np.array([0.3, -0.8, 0.5])])
def test_one_step_leads_to_the_orbit_of_a_linear_map_on_a_plane(normal: np.ndarray) -> None:
    begin = placed(300.0, np.array([3.0, 2e-5]))
    wanted = begin.problem.position(450.0, orbit(450.0))
    step = begin.correction(normal, float(normal @ wanted))
    assert step == pytest.approx(wanted - begin.position, rel=1e-9)
    # Where the value is right already, only the state moves.
    rest = placed(450.0, np.array([3.0, 2e-5])).correction(np.array([0.0, 0.0, 1.0]), 450.0 / SPAN)
    assert rest is not None
    assert rest[:2] == pytest.approx(wanted[:2] - np.array([1.5, 0.5]), rel=1e-9)
    assert abs(rest[2]) < 1e-15
    found = begin.problem.correct(begin.position, normal, float(normal @ wanted))
    assert found is not None
    assert found.position == pytest.approx(wanted, rel=1e-12)


def test_a_singular_step_is_none() -> None:
    problem = Problem(Affine(np.eye(2)), SPAN, SIZES)
    place = problem.place(problem.position(300.0, np.array([3.0, 2e-5])))
    assert place is not None
    assert place.correction(np.array([0.0, 0.0, 1.0]), 300.0 / SPAN) is None
    assert problem.correct(place.position, np.array([0.0, 0.0, 1.0]), 300.0 / SPAN) is None


def test_a_motion_that_cannot_be_followed_or_has_no_numbers_is_no_place() -> None:
    problem = Problem(Affine(), SPAN, SIZES)
    assert problem.place(problem.position(-1.0, np.ones(2))) is None
    assert problem.place(np.array([np.nan, 1.0, 0.5])) is None
    endless = Missing(lambda x: x, lambda x: math.inf)
    assert Problem(endless, 1.0, np.ones(1)).place(np.array([1.0, 0.0])) is None
    # Newton's method stops where the next motion cannot be followed.
    assert problem.correct(problem.position(300.0, np.ones(2)), np.array([0.0, 0.0, 1.0]), -1.0) is None


def test_a_place_in_other_sizes_is_the_same_state() -> None:
    place = placed(300.0, np.array([3.0, 2e-5]))
    other = Problem(Affine(), SPAN, np.array([0.5, 8e-5]))
    adopted = other.adopted(place)
    assert adopted.problem is other
    assert adopted.passage is place.passage
    assert adopted.position == pytest.approx([6.0, 0.25, 300.0 / SPAN], rel=1e-14)
    assert place.position[0] == 1.5


def solved(map: Missing, begin: float) -> Place | None:
    return Problem(map, 1.0, np.ones(1)).correct(np.array([begin, 0.0]), np.array([0.0, 1.0]), 0.0)


def test_a_step_that_goes_too_far_is_halved_until_the_miss_falls() -> None:
    # Newton's step for arctan x from 3 leads to -9.5, half of it to -3.2: both miss by more.
    map = Missing(math.atan, lambda x: 1.0 / (1.0 + x * x))
    found = solved(map, 3.0)
    assert found is not None
    assert abs(found.position[0]) < 1e-13
    step = -math.atan(3.0) * 10.0
    assert map.asked[:4] == pytest.approx([3.0, 3.0 + step, 3.0 + step / 2.0, 3.0 + step / 4.0], rel=1e-12)
    # From far outside no such share is small enough: four are tried.
    hopeless = Missing(math.atan, lambda x: 1.0 / (1.0 + x * x))
    assert solved(hopeless, 50.0) is None
    assert len(hopeless.asked) == 5


@pytest.mark.parametrize(("floor", "good"), [(1e-12, True), (1e-11, False)])
def test_a_miss_that_rounding_leaves_is_an_orbit_if_it_is_small(floor: float, good: bool) -> None:
    def miss(x: float) -> float:
        exact = 1.0 - x
        return exact if abs(exact) > floor else floor

    found = solved(Missing(miss, lambda x: -1.0), 0.25)
    assert (found is not None) == good
    if found is not None:
        assert found.position[0] == pytest.approx(1.0, abs=3e-12)


def test_newtons_method_converges_quadratically_and_stops_where_only_rounding_is_left() -> None:
    map = Missing(lambda x: x * x - 2.0, lambda x: 2.0 * x)
    found = solved(map, 1.5)
    assert found is not None
    assert found.position[0] == pytest.approx(math.sqrt(2.0), rel=1e-14)
    assert len(map.asked) <= 6
    begin = solved(Missing(lambda x: 0.0, lambda x: 1.0), 7.0)
    assert begin is not None and begin.position[0] == 7.0


@dataclass(frozen=True)
class Partly(Affine):
    """As ``Affine`` with numbers that are missing in the derivatives."""

    slope: float = 0.0
    rate: float = 0.0

    def passage(self, value: float, state: np.ndarray) -> Given:
        found = super().passage(value, state)
        jacobian = found.jacobian + np.array([[0.0, 0.0], [self.slope, 0.0]])
        return Given(found.end, jacobian, found.by_value + np.array([0.0, self.rate]), found.sizes)


def test_derivatives_of_which_one_is_missing_are_no_derivatives() -> None:
    assert Problem(Partly(slope=math.inf), SPAN, SIZES).place(np.ones(3)) is None
    begin = Problem(Partly(rate=math.nan), SPAN, SIZES).place(np.ones(3))
    assert begin is not None
    # On the plane of another value the derivative by the value is needed, on that of its own it is not.
    assert begin.correction(np.array([0.0, 0.0, 1.0]), 2.0) is None
    assert begin.correction(np.array([0.0, 0.0, 1.0]), 1.0) is not None


def test_a_step_that_leaves_the_miss_as_it_is_is_none() -> None:
    map = Missing(lambda x: 0.5, lambda x: -1.0)
    assert solved(map, 1.0) is None
    assert map.asked == [1.0, 1.5, 1.25, 1.125, 1.0625]


@pytest.mark.parametrize(("share", "good"), [(0.9, True), (1.1, False)])
def test_of_slow_convergence_so_many_steps_are_made(share: float, good: bool) -> None:
    # Each step brings the miss to a third.
    map = Missing(lambda x: 1.0 - x, lambda x: -1.5)
    found = solved(map, 1.0 - share * 3e-12 * 3.0**14)
    assert (found is not None) is good
    assert len(map.asked) == 15
