"""Where a branch may begin and how far it may go: starts, intervals, and what is refused."""

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import control
import numpy as np
import pytest

from tests.trimmer.branches.bouncing_ball import ball, thrown
from tests.trimmer.branches.maps import Cubic, Failing, Logistic, Ring
from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer import (
    Body,
    ClosedLoop,
    ContactLaw,
    Force,
    Friction,
    Link,
    Mechanism,
    Pin,
    Play,
    Saturation,
    Stop,
    follow,
)
from trimmer.branches import BranchEnd, FollowSettings
from trimmer.branches.continuation import continuation
from trimmer.errors import MechanismError, UnsupportedMotionError, WrongTypeError

EXAMPLES = Path(__file__).parents[3] / "examples"
QUIET = FollowSettings(switches=0, quiet=True)
FEW = FollowSettings(most_points=2, quiet=True)
LINEAR, STOPPED = linear_oscillator(), impact_oscillator()
TWIN, BELT = (Mechanism.from_toml(EXAMPLES / f"{name}.toml") for name in ("thesis-play", "block-on-belt"))
SPEED = "pins.belt.velocity"
DRIVE = Force("body", amplitude=3.0)
BENT = ((-2.0, -5.0), (-1.0, -1.0), (1.0, 1.0), (2.0, 5.0))


def pulled(mechanism: Mechanism, velocity: float) -> Mechanism:
    """Return a mechanism with a spring to a pin that moves on."""
    body = next(iter(mechanism.bodies))
    rope = {**mechanism.links, "rope": Link(("far", body), 1.0)}
    return replace(mechanism, pins={**mechanism.pins, "far": Pin("ground", velocity=velocity)}, links=rope)


Call = Callable[[], object]
REFUSED: dict[str, tuple[type[Exception], str, Call]] = {
    "no such number": (MechanismError, "gab", lambda: follow(TWIN, "plays.bridge.gab", 0, 1)),
    "an order": (MechanismError, "whole numbers", lambda: follow(LINEAR, "forces.push.order", 1, 3)),
    "no length": (MechanismError, "no length", lambda: follow(LINEAR, "frequency", 1.1, "1.1 Hz")),
    "a value that cannot be": (MechanismError, "mass", lambda: follow(LINEAR, "bodies.mass.mass", 1.0, -1.0)),
    "no drive to vary": (MechanismError, "frequency", lambda: follow(BELT, "frequency", 1.1, 1.2)),
    "it goes on": (
        UnsupportedMotionError,
        "goes on for ever",
        lambda: follow(pulled(LINEAR, 1.0), "frequency", 1.1, 1.2),
    ),
    "it goes on at the start": (
        UnsupportedMotionError,
        "goes on for ever",
        lambda: follow(pulled(LINEAR, 0.0), "pins.far.velocity", 1.0, 0.0),
    ),
    "it goes on at the end": (
        UnsupportedMotionError,
        "goes on for ever",
        lambda: follow(pulled(LINEAR, 0.0), "pins.far.velocity", 0.0, 1.0),
    ),
    "it goes on by itself": (
        UnsupportedMotionError,
        "goes on for ever",
        lambda: follow(
            replace(BELT, links={**BELT.links, "rope": Link(("belt", "block"), 1.0)}), SPEED, 1, 2
        ),
    ),
    "no mechanism": (WrongTypeError, "mechanism", lambda: follow("it", "frequency", 1, 2)),  # type: ignore[arg-type]
    "no state": (WrongTypeError, "state", lambda: follow(LINEAR, "frequency", 1, 2, state="rest")),
    "no periods": (ValueError, "periods", lambda: follow(LINEAR, "frequency", 1, 2, periods=0)),
    "half a period": (WrongTypeError, "periods", lambda: follow(LINEAR, "frequency", 1, 2, periods=1.5)),  # type: ignore[arg-type]
    "periods without a drive": (ValueError, "no drive", lambda: follow(BELT, SPEED, 0.1, 0.2, periods=2)),
    "a stretch is missing": (
        MechanismError,
        "the mechanism has 3 states: ball, ball' and contact",
        lambda: follow(
            ball(1e6, 0.0, law=ContactLaw.RELAXING), "pins.table.amplitude", 0.6, 0.3, state=thrown(0.0)
        ),
    ),
    "the period is missing": (
        MechanismError,
        r"shape \(2,\), but without a drive it is 2 states and the period",
        lambda: follow(BELT, SPEED, 0.1, 0.2, state=[1.0, 0.1]),
    ),
    "no balance without a drive": (
        UnsupportedMotionError,
        "driven motions only",
        lambda: follow(BELT, SPEED, 0.1, 0.2, settings=FEW).points[0].balanced(3),
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_followed_is_refused(name: str) -> None:
    error, told, call = REFUSED[name]
    with pytest.raises(error, match=told):
        call()


def test_a_loop_without_an_orbit_has_nothing_to_follow() -> None:
    loop = ClosedLoop(control.tf([0.5], [1, 2, 1]), Saturation(1.0))
    branch = follow(loop, "element.slope", 1.0, 2.0, settings=FEW)
    assert not branch.points
    assert "there is no motion to begin with: the loop has no orbit to begin with" in branch.message


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
def test_settings_out_of_range_are_refused(name: str, value: Any, error: type[Exception]) -> None:
    with pytest.raises(error, match=name):
        FollowSettings(**{name: value})
    smallest = FollowSettings(most_points=2, largest_step=1.0, switches=0, bounds=(3.0, 1.0), most_periods=1)
    assert (smallest.most_points, smallest.largest_step, smallest.most_periods) == (2, 1.0, 1)


@pytest.mark.parametrize(
    ("start", "stop", "bounds", "end", "reason"),
    [
        (2.5, 2.9, None, 2.9, BranchEnd.LEFT_AT_STOP),
        (2.9, 2.5, None, 2.5, BranchEnd.LEFT_AT_STOP),
        (2.5, 2.9, (2.2, 2.8), 2.8, BranchEnd.LEFT_AT_STOP),
        (2.5, 2.9, (2.8, 2.2), 2.8, BranchEnd.LEFT_AT_STOP),
        (2.9, 2.5, (2.4, 2.95), 2.4, BranchEnd.LEFT_AT_STOP),
        (2.5, 2.9, (2.5, 2.6), 2.6, BranchEnd.LEFT_AT_STOP),
    ],
)
def test_bounds_take_the_place_of_both_ends_in_the_direction_of_travel(
    start: float, stop: float, bounds: tuple[float, float] | None, end: float, reason: BranchEnd
) -> None:
    settings = FollowSettings(switches=0, bounds=bounds, quiet=True, largest_step=0.1)
    branch = continuation(Logistic(), np.array([0.61]), start, stop, settings)
    assert (branch.points[0].value, branch.points[-1].value) == pytest.approx((start, end), rel=1e-15)
    assert (branch.reason, branch.message) == (reason, f"{reason.value}, at {end}")
    # The fixed points are 1 - 1/r, the multiplier 2 - r.
    for point in branch.points:
        assert point.state[0] == pytest.approx(1.0 - 1.0 / point.value, rel=1e-11)
        assert point.multipliers == pytest.approx([2.0 - point.value], rel=1e-9)


@pytest.mark.parametrize(
    ("start", "stop", "bounds"),
    [
        (1.0, 1.0, None),
        (1.0, np.inf, None),
        *((1.0, 2.0, each) for each in ((1.5, 3.0), (1.0, 1.0), (0.0, 0.9))),
    ],
)
def test_an_interval_without_its_start_is_refused(
    start: float, stop: float, bounds: tuple[float, float] | None
) -> None:
    with pytest.raises(ValueError):
        continuation(Logistic(), np.array([0.6]), start, stop, FollowSettings(bounds=bounds))


@pytest.mark.parametrize(
    ("map", "state", "start", "reason"),
    [
        (Failing(), 0.0, 0.7, BranchEnd.NO_START),
        (Ring(), 0.5, 2.0, BranchEnd.NO_START),
        (Cubic(), 0.0, 0.0, BranchEnd.NOT_ISOLATED),
    ],
)
def test_where_no_single_orbit_is_near_nothing_begins(
    map: Any, state: float, start: float, reason: BranchEnd
) -> None:
    branch = continuation(map, np.array([state]), start, start + 1.0, QUIET)
    assert (branch.points, branch.reason, branch.success) == ((), reason, False)
    assert f"at {start:.10g}" in branch.message


def test_which_ends_are_successes() -> None:
    failures = {each for each in BranchEnd if not each.is_success}
    assert failures == {
        BranchEnd.NOT_ISOLATED,
        BranchEnd.STEP_TOO_SMALL,
        BranchEnd.MOST_POINTS,
        BranchEnd.NO_START,
        BranchEnd.OUT_OF_TIME,
    }


def test_the_start_is_what_respond_or_a_given_state_says() -> None:
    """At 7.5 rad/s a motion with contact and one without are both stable."""
    settled = follow(STOPPED, "frequency", STOPPED.frequency, 1.25, settings=FEW)
    given = follow(STOPPED, "frequency", STOPPED.frequency, 1.25, state=[-25.0, 0.0], settings=FEW)
    free = 2.0 * 100.0 / abs(40.0 - 7.5**2 + 0.1j * math.sqrt(40.0) * 7.5)
    strokes = [each.points[0].outputs["x"].peak_to_peak for each in (settled, given)]
    assert min(strokes) == pytest.approx(free, rel=1e-9)
    assert max(strokes) > 1.5 * free
    again = follow(
        STOPPED, "frequency", STOPPED.frequency, 1.25, state=given.points[0].state, settings=FEW
    ).points[0]
    assert again.state == pytest.approx(given.points[0].state, rel=1e-9)


def test_more_periods_than_a_motion_needs_are_a_period_of_it_too() -> None:
    """Its multipliers are those of one, to the power of how many there are."""
    one, two, three = (
        follow(STOPPED, "stops.wall.gap", 10.0, 9.9, periods=each, settings=FEW).points[0]
        for each in (1, 2, 3)
    )
    for number, orbit in ((2, two), (3, three)):
        assert orbit.periods == number
        assert orbit.period == pytest.approx(number * one.period, rel=1e-14)
        assert orbit.state == pytest.approx(one.state, rel=1e-9)
        assert orbit.events_per_period == one.events_per_period
        assert sorted(abs(orbit.multipliers)) == pytest.approx(
            sorted(abs(one.multipliers) ** number), rel=1e-6
        )


def test_a_motion_that_does_not_settle_is_said_and_one_of_given_periods_need_not() -> None:
    hasty = FollowSettings(most_points=2, most_periods=200, quiet=True)
    branch = follow(TWIN.with_value("frictions.blade.force", 0.0), "frequency", 110.0, 120.0, settings=hasty)
    assert (branch.points, branch.reason) == ((), BranchEnd.NO_START)
    assert "from rest at 110 the motion has not settled within 200 drive periods" in branch.message
    # It is unstable, and yet an orbit of one period.
    found = follow(
        TWIN.with_value("frictions.blade.force", 0.0), "frequency", 110.0, 120.0, periods=1, settings=hasty
    )
    assert found.points[0].periods == 1
    assert not found.points[0].stable
    assert found.message.endswith("; the orbit it begins with is unstable")


def test_without_a_drive_what_comes_to_rest_has_no_branch() -> None:
    still = BELT.with_value("frictions.rubbing.static", 0.5).with_value("links.spring.damping", 0.4)
    branch = follow(still, SPEED, 0.2, 0.3, settings=QUIET)
    assert (branch.points, branch.reason) == ((), BranchEnd.NO_START)
    assert branch.message.startswith("at 0.2 there is no motion to begin with: it comes to rest within")


def test_what_nothing_is_lost_in_is_not_isolated() -> None:
    mechanism = Mechanism(
        bodies={"body": Body(1.0)},
        links={"spring": Link(("ground", "body"), 1.0)},
        stops={"wall": Stop(("ground", "body"), 10.0, gap=0.2)},
        start={"body": (1.0, 0.0)},
    )
    branch = follow(mechanism, "bodies.body.mass", 1.0, 2.0, settings=QUIET)
    assert (branch.reason, branch.points) == (BranchEnd.NOT_ISOLATED, ())
    assert "nothing is lost" in branch.message


def test_what_sticks_all_the_time_is_not_isolated() -> None:
    # The body is held by friction alone and never moves; it could do so anywhere.
    mechanism = Mechanism(
        bodies={"body": Body(1.0), "held": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "body"), 10.0, 1.0), "weak": Link(("body", "held"), 0.1)},
        frictions={"rubbing": Friction(("ground", "held"), 5.0)},
        forces={"drive": Force("body", constant=0.5, amplitude=1.0)},
    )
    branch = follow(mechanism, "frequency", 1.0, 1.2, settings=QUIET)
    assert branch.reason is BranchEnd.NOT_ISOLATED
    assert not branch.success
    assert "sticks all the time" in branch.message


def leaning(**changes: Any) -> Mechanism:
    """Return two like sides with something that leans to one of them."""
    like = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=0.2,
        links={"spring": Link(("ground", "body"), stiffness=1.0, damping=0.3)},
        plays={"springs": Play(("ground", "body"), 10.0, gap=2.0)},
        forces={"drive": DRIVE},
    )
    return replace(like, **changes)


@pytest.mark.parametrize(
    ("mechanism", "symmetric"),
    [
        (leaning(), True),
        (leaning(forces={"drive": Force("body", constant=1.0, amplitude=3.0)}), False),
        (leaning(forces={"drive": DRIVE, "more": Force("body", amplitude=1.0, order=2)}), False),
        (leaning(forces={"drive": DRIVE, "more": Force("body", amplitude=1.0, order=3)}), True),
        (leaning(stops={"stop": Stop(("ground", "body"), 5.0, gap=1.2)}), False),
        (leaning(plays={}, links={"spring": Link(("ground", "body"), damping=0.3, curve=BENT)}), True),
        (
            leaning(
                pins={"pin": Pin("ground", offset=0.5)}, plays={"springs": Play(("pin", "body"), 10.0, gap=2)}
            ),
            False,
        ),
        (
            leaning(
                pins={"belt": Pin("ground", velocity=1.0)},
                frictions={"rubbing": Friction(("belt", "body"), 0.3)},
            ),
            False,
        ),
    ],
)
def test_only_what_has_two_like_sides_is_followed_as_its_own_mirror_image(
    mechanism: Mechanism, symmetric: bool
) -> None:
    """A first orbit closes after its whole period, and half of that mirrors it where both sides are alike."""
    (orbit, *_) = follow(mechanism, "links.spring.damping", 0.3, 0.31, settings=FEW).points
    course = orbit.passage.course
    middle, end = course.states(np.array([0.5, 1.0]) * course.duration)[:, : len(orbit.state)]
    size = abs(orbit.state).max()
    assert end == pytest.approx(orbit.state, abs=1e-9 * size)
    assert (abs(middle + orbit.state).max() < 1e-9 * size) == symmetric
