"""Least misfits and intervals of residuals that are known functions of the numbers."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from tests.trimmer.fitting.known import Known
from trimmer.fitting.minimum import nearby_minimum
from trimmer.fitting.profile import Profile, Side, _Bracket
from trimmer.fitting.unknowns import Unknown

SLOPE = np.array([[30.0, 5.0], [-4.0, 12.0], [6.0, 18.0]])
BEGUN = np.array([2.0, -7.0, 5.0])
BOTH = np.array([True, True])


def linear() -> Known:
    return Known(lambda at: BEGUN + SLOPE @ at)


def lowest(misfit: Any, *begin: float, free: np.ndarray = BOTH, jacobian: np.ndarray | None = None) -> Any:
    return nearby_minimum(misfit, misfit.at(*begin), free, jacobian)


def test_a_linear_misfit_is_least_after_one_step() -> None:
    misfit = linear()
    found = lowest(misfit, 0.3, -0.2)
    np.testing.assert_allclose(found.coordinates, np.linalg.lstsq(SLOPE, -BEGUN, rcond=None)[0], rtol=1e-7)
    assert len(misfit.tried) == 1
    assert misfit.jacobians == 2  # once more to see that nothing is left


def test_held_numbers_stay() -> None:
    misfit = linear()
    found = lowest(misfit, 0.3, -0.2, free=np.array([False, True]))
    rest = BEGUN + 0.3 * SLOPE[:, 0]
    assert found.coordinates == pytest.approx([0.3, -(SLOPE[:, 1] @ rest) / (SLOPE[:, 1] @ SLOPE[:, 1])])
    start = misfit.at(0.3, -0.2)
    assert nearby_minimum(misfit, start, np.array([False, False])) is start  # type: ignore[arg-type]


def test_a_step_is_at_most_seven_tenths_of_a_coordinate() -> None:
    misfit = Known(lambda at: 40.0 * (at - [2.0, 1.0]))
    found = lowest(misfit, 0.0, 0.0)
    assert found.coordinates == pytest.approx([2.0, 1.0])
    assert [each.tolist() for each in misfit.tried] == [
        pytest.approx([0.7, 0.35]),
        pytest.approx([1.4, 0.7]),
        pytest.approx([2.0, 1.0]),
    ]


def test_bounds_are_kept() -> None:
    bound = Unknown("plays.p.gap", "m", 4e-5, True)
    reach = math.log(1e3)
    misfit = Known(lambda at: 40.0 * (at - 9.0), 1, (bound,))
    assert lowest(misfit, 6.5, free=np.array([True])).coordinates == pytest.approx([reach])
    misfit = Known(lambda at: 40.0 * (at + 9.0), 1, (bound,))
    assert lowest(misfit, -6.5, free=np.array([True])).coordinates == pytest.approx([-reach])


def test_a_derivative_that_is_wrong_is_taken_anew() -> None:
    misfit = linear()
    found = lowest(misfit, 0.3, -0.2, jacobian=-SLOPE)
    assert found.chi_square == pytest.approx(lowest(linear(), 0.0, 0.0).chi_square)
    assert misfit.jacobians == 2
    kept = linear()
    lowest(kept, 0.3, -0.2, jacobian=SLOPE)
    assert kept.jacobians == 1


def test_a_derivative_by_which_a_step_does_too_little_is_taken_anew() -> None:
    # Five times too steep, a step does 1 - (4/5)^2 of what it promises; three times, 1 - (2/3)^2.
    for factor, jacobians in ((5.0, 2), (3.0, 1)):
        misfit = linear()
        found = lowest(misfit, 0.3, -0.2, jacobian=factor * SLOPE)
        assert found.chi_square == pytest.approx(lowest(linear(), 0.0, 0.0).chi_square, abs=0.1)
        assert misfit.jacobians == jacobians
        assert (len(misfit.tried) == 2) is (factor == 5.0)


def test_a_step_that_leads_nowhere_is_shortened() -> None:
    misfit = Known(lambda at: None if at[0] > 0.3 else 40.0 * (at - 0.5), 1)
    found = lowest(misfit, 0.0, free=np.array([True]))
    steps = [float(each[0]) for each in misfit.tried[:2]]
    assert steps == pytest.approx([0.5, 0.2])
    assert 0.2 < found.coordinates[0] <= 0.3
    walled = Known(lambda at: None if at[0] > 0.0 else 40.0 * (at - 0.5), 1)
    start = walled.at(0.0)
    assert nearby_minimum(walled, start, np.array([True])) is start  # type: ignore[arg-type]
    assert [float(each[0]) for each in walled.tried] == pytest.approx([0.5, 0.2, 0.08, 0.032])


def profile(misfit: Known, *best: float, place: int = 0, allowed: float = 4.0) -> Profile:
    start: Any = misfit.at(*best)
    made: Any = misfit
    return Profile(made, start, misfit.jacobian(start), place, allowed)


def centred() -> Known:
    return Known(lambda at: np.array([1.0, 2.0, *(SLOPE @ at)]))


@pytest.mark.parametrize("place", [0, 1])
def test_ends_of_a_linear_problem_are_those_of_its_covariance(place: int) -> None:
    deviation = math.sqrt(np.linalg.inv(SLOPE.T @ SLOPE)[place, place])
    misfit = centred()
    for sign in (1.0, -1.0):
        side = profile(misfit, 0.0, 0.0, place=place).side(sign)
        assert side.end == pytest.approx(sign * 2.0 * deviation, rel=1e-6)
        assert side.reached == side.end
        assert (side.lost, side.better) == (False, None)


def test_ends_of_a_curved_problem_are_where_the_excess_is_what_is_allowed() -> None:
    def residual(at: np.ndarray) -> np.ndarray:
        return np.array([1.0, 20.0 * math.expm1(at[0]), 15.0 * (at[1] - math.sin(at[0]))])

    misfit = Known(residual)
    for sign in (1.0, -1.0):
        side = profile(misfit, 0.0, 0.0, allowed=9.0).side(sign)
        exact = math.log1p(sign * 3.0 / 20.0)
        assert side.end == pytest.approx(exact, rel=0.035)


def test_an_interval_is_open_where_nothing_ends_it() -> None:
    misfit = Known(lambda at: np.array([1.0, 0.1 * at[0], 9.0 * at[1]]))
    side = profile(misfit, 0.5, 0.0).side(1.0)
    assert (side.end, side.lost) == (None, False)
    assert side.reached == pytest.approx(math.log(1e3))
    back = profile(misfit, 0.5, 0.0).side(-1.0)
    assert back.reached == pytest.approx(-math.log(1e3))


def test_a_motion_that_is_lost_ends_no_interval() -> None:
    misfit = Known(lambda at: None if at[0] > 0.21 else np.array([1.0, 2.0 * at[0], 9.0 * at[1]]))
    side = profile(misfit, 0.1, 0.0).side(1.0)
    assert (side.end, side.lost) == (None, True)
    assert side.reached == pytest.approx(0.21, rel=1e-3)
    assert side.reached <= 0.21


def test_a_jump_is_lost_and_a_steep_rise_is_not() -> None:
    jump = Known(lambda at: np.array([1.0, 2.0 * at[0] + 50.0 * (at[0] > 0.21), 9.0 * at[1]]))
    side = profile(jump, 0.1, 0.0).side(1.0)
    assert (side.end, side.lost) == (None, True)
    small = Known(lambda at: np.array([1.0, 2.0 * at[0] + 4.0 * (at[0] > 0.21), 9.0 * at[1]]))
    side = profile(small, 0.1, 0.0).side(1.0)
    assert (side.end, side.lost) == (pytest.approx(0.21, rel=3e-3), False)
    assert side.reached < 0.21


def test_a_better_fit_on_the_way_is_told() -> None:
    def residual(at: np.ndarray) -> np.ndarray:
        return np.array([3.0 if at[0] < 0.15 else 1.0, 2.0 * at[0], 9.0 * at[1]])

    side = profile(Known(residual), 0.1, 0.0).side(1.0)
    assert side.end is None
    assert side.reached == 0.1
    assert side.better is not None
    assert side.better.chi_square < 9.04 - 0.5


def test_the_others_make_up_for_a_number() -> None:
    made = profile(centred(), 0.0, 0.0)
    wanted = -(SLOPE[:, 1] @ SLOPE[:, 0]) / (SLOPE[:, 1] @ SLOPE[:, 1])
    assert made._made_up(np.array([False, True])) == pytest.approx([wanted])
    alone = Known(lambda at: np.array([1.0, 5.0 * at[0]]), 1)
    single = profile(alone, 0.0)
    assert single._made_up(np.array([False])).shape == (0,)
    assert single._expected() == pytest.approx(0.4)
    assert single.side(1.0).end == pytest.approx(0.4)
    rest = SLOPE[:, 0] + wanted * SLOPE[:, 1]
    assert made._expected() == pytest.approx(2.0 / np.linalg.norm(rest))
    flat = profile(Known(lambda at: np.array([1.0, 5.0 * at[1]])), 0.0, 0.0)
    assert flat._expected() == math.inf
    # Two thirds of a hundredth: the change of the others is bounded.
    steep = profile(Known(lambda at: np.array([30.0 * at[0] + 1.0 * at[1], 1.0])), 0.0, 0.0)
    assert steep._made_up(np.array([False, True])) == pytest.approx([-3.0])


def test_places_near_a_motion_that_is_far_off_are_begun_anew() -> None:
    def residual(at: np.ndarray) -> np.ndarray | None:
        # Only with the other number as it was there is a motion.
        return None if abs(at[1]) > 1e-3 else np.array([1.0, 10.0 * at[0], 4.0 * at[0] + 5.0 * at[1]])

    misfit = Known(residual)
    made = profile(misfit, 0.0, 0.0)
    misfit.tried.clear()
    found = made._at(0.1, made.best)
    assert found is not None
    assert [each.tolist() for each in misfit.tried[:2]] == [pytest.approx([0.1, -0.08]), [0.1, 0.0]]
    nothing = Known(lambda at: None if at[0] > 0.05 else np.array([1.0, 10.0 * at[0], 5.0 * at[1]]))
    made = profile(nothing, 0.0, 0.0)
    assert made._at(0.1, made.best) is None


def test_what_is_known_of_an_end_narrows() -> None:
    inside = _Bracket().narrowed(0.2, 0.5)
    assert (inside.inside, inside.low, inside.outside) == (0.2, 0.5, math.inf)
    both = inside.narrowed(0.5, 2.0)
    assert (both.inside, both.low, both.outside, both.high) == (0.2, 0.5, 0.5, 2.0)
    assert _Bracket().narrowed(0.2, 1.0).outside == 0.2
    assert not both.is_narrow
    assert _Bracket(1.0, 0.9, 1.0019, 1.2).is_narrow
    assert not _Bracket(1.0, 0.9, 1.0021, 1.2).is_narrow
    # What may be a jump is looked at more closely; where no motion is, not.
    assert not _Bracket(1.0, 0.9, 1.0019, 5.0).is_narrow
    assert _Bracket(1.0, 0.9, 1.000019, 5.0).is_narrow
    assert _Bracket(1.0, 0.9, 1.0019, math.inf).is_narrow
    assert _Bracket(0.0, 0.0, 0.9e-7, 1.2).is_narrow


def test_the_next_place_is_where_a_parabola_crosses() -> None:
    assert _Bracket(0.2, 0.5).following(9.0) == pytest.approx(0.4)
    assert _Bracket(0.2, 0.95).following(9.0) == pytest.approx(0.24)
    assert _Bracket(0.1, 0.1).following(9.0) == pytest.approx(0.4)
    assert _Bracket(0.5, 0.1).following(9.0) == pytest.approx(1.2)
    assert _Bracket(0.5, 0.1).following(0.9) == 0.9
    assert _Bracket(0.2, 0.5, 0.5, 1.5).following(9.0) == pytest.approx(0.35)
    assert _Bracket(0.2, 0.5, 0.5, 2.5).following(9.0) == pytest.approx(0.275)
    assert _Bracket(0.2, 0.99, 0.5, 2.5).following(9.0) == pytest.approx(0.23)
    assert _Bracket(0.2, 0.0, 0.5, 1.02).following(9.0) == pytest.approx(0.47)
    assert _Bracket(0.2, 0.5, 0.5, 4.0).following(9.0) == pytest.approx(0.35)


def test_an_end_close_enough_is_taken_as_it_is() -> None:
    misfit = Known(lambda at: np.array([1.0, 10.0 * math.sinh(at[0])]), 1)
    side = profile(misfit, 0.0).side(1.0)
    exact = brentq(lambda x: 10.0 * math.sinh(x) - 2.0, 0.0, 1.0)
    assert side.end == pytest.approx(0.2)  # where a linear problem would end, 0.7 % off
    assert exact == pytest.approx(0.2, rel=0.01)
    assert isinstance(side, Side)


def test_an_end_before_the_bound_is_found_though_the_bound_was_tried_first() -> None:
    # The bound is 0.408 away, and a line would end at 0.5; the cubic 4 x + 26 x^3 is 2 at 0.3088.
    bound = Unknown("plays.p.gap", "m", 4e-5, True)
    misfit = Known(lambda at: np.array([1.0, 4.0 * (at[0] - 6.5) + 26.0 * (at[0] - 6.5) ** 3]), 1, (bound,))
    found = profile(misfit, 6.5).side(1.0)
    end = brentq(lambda x: 4.0 * x + 26.0 * x**3 - 2.0, 0.0, 1.0)
    assert found.end == pytest.approx(6.5 + end, abs=0.03 * end)
    assert misfit.tried[0][0] == pytest.approx(math.log(1e3), rel=1e-12)
    assert not found.lost
