"""Where a branch begins: its interval, its settings, and the first orbit; and what is told of its points."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.branches.maps import Cubic, Failing, Logistic, Ring
from trimmer.branches.branch import BranchEnd
from trimmer.branches.continuation import _by_modulus, _first_front, _interval, continuation
from trimmer.branches.settings import FollowSettings
from trimmer.branches.step import Front
from trimmer.branches.stepping import Interval
from trimmer.errors import WrongTypeError

ALONE = FollowSettings(switches=0, quiet=True)


@pytest.mark.parametrize(
    ("start", "stop", "bounds", "expected"),
    [
        (1.0, 3.0, None, (1.0, 3.0)),
        (3.0, 1.0, None, (3.0, 1.0)),
        (1.0, 3.0, (0.5, 4.0), (0.5, 4.0)),
        (1.0, 3.0, (4.0, 0.5), (0.5, 4.0)),
        (3.0, 1.0, (0.5, 4.0), (4.0, 0.5)),
        (1.0, 3.0, (1.0, 1.5), (1.0, 1.5)),
        (1.0, 3.0, (0.5, 1.0), (0.5, 1.0)),
    ],
)
def test_bounds_take_the_place_of_start_and_stop_in_the_direction_of_travel(
    start: float, stop: float, bounds: tuple[float, float] | None, expected: tuple[float, float]
) -> None:
    interval = _interval(start, stop, bounds)
    assert (interval.start, interval.stop) == expected


@pytest.mark.parametrize("bounds", [(1.0, 1.0), (0.0, 0.9), (1.1, 2.0)])
def test_bounds_that_do_not_hold_the_start_are_refused(bounds: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match="around start"):
        _interval(1.0, 2.0, bounds)


@pytest.mark.parametrize(
    ("name", "value", "error"),
    [
        ("most_points", 1, ValueError),
        ("switches", -1, ValueError),
        ("most_periods", 0, ValueError),
        ("largest_step", 1.01, ValueError),
        ("largest_step", 0.0, ValueError),
        ("bounds", (0.0, math.inf), ValueError),
        ("bounds", ("a", 1.0), WrongTypeError),
    ],
)
def test_settings_out_of_range_are_refused(name: str, value: object, error: type[Exception]) -> None:
    with pytest.raises(error, match=name):
        FollowSettings(**{name: value})  # type: ignore[arg-type]


def test_the_smallest_settings_are_taken() -> None:
    settings = FollowSettings(2, 1.0, 0, (3.0, 1.0), 1)
    assert (settings.most_points, settings.largest_step, settings.switches) == (2, 1.0, 0)
    default = FollowSettings()
    assert (default.largest_step, default.switches, default.bounds, default.quiet) == (0.01, 1, None, False)


def test_multipliers_come_by_falling_modulus() -> None:
    found = _by_modulus(np.array([0.1 + 0.0j, -2.0, 0.5j]))
    assert found.tolist() == [-2.0, 0.5j, 0.1]


def test_the_first_front_is_exact_and_leads_towards_the_other_end() -> None:
    for start, stop in ((2.5, 2.9), (2.9, 2.5)):
        front = _first_front(Logistic(), np.array([0.61]), start, Interval(start, stop))
        assert isinstance(front, Front)
        assert front.problem.span == pytest.approx(0.4)
        assert front.problem.value(front.place.position) == pytest.approx(start, rel=1e-15)
        assert front.problem.state(front.place.position) == pytest.approx([1.0 - 1.0 / start], rel=1e-12)
        assert np.sign(front.tangent[-1]) == math.copysign(1.0, stop - start)
        assert front.problem.sizes == pytest.approx([1.0 - 1.0 / start], rel=1e-12)
    # Where the tangent is not single, and where no orbit is near.
    assert _first_front(Cubic(), np.array([0.0]), 0.0, Interval(0.0, 1.0)) is BranchEnd.NOT_ISOLATED
    assert _first_front(Failing(), np.array([0.0]), 0.7, Interval(0.7, 1.0)) is None
    assert _first_front(Ring(), np.array([0.5]), 2.0, Interval(2.0, 3.0)) is None


def test_a_branch_has_the_fixed_points_of_its_map() -> None:
    branch = continuation(Logistic(), np.array([0.6]), 2.5, 2.9, ALONE)
    for point in branch.points[:: len(branch.points) // 3]:
        assert point.state[0] == pytest.approx(1.0 - 1.0 / point.value, rel=1e-11)
        assert (point.events, point.signature) == (0, {})
    assert branch.message == f"{BranchEnd.LEFT_AT_STOP.value}, at 2.9"
    assert (branch.doublings, branch.parted) == (0, None)
    mirrored = continuation(Cubic(mirrored=True), np.array([0.0]), -0.5, -0.2, ALONE)
    # The whole period is two passages.
    assert [point.multipliers[0] for point in mirrored.points] == pytest.approx(
        [(1.0 + point.value) ** 2 for point in mirrored.points], rel=1e-12
    )
