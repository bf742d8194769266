"""What ``follow`` makes of its arguments: where a branch begins, on which map, and what is told of it."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.branches.test_joining import between_stops
from tests.trimmer.branches.test_self_excited_map import PERIOD, SPEED, belt
from tests.trimmer.maps.machines import linear_oscillator
from trimmer.branches import follow as following
from trimmer.branches.branch import Branch, BranchEnd, BranchPoint
from trimmer.branches.follow import _followed, _interval, _orbit_at_start, _unsettled, follow
from trimmer.branches.followed import FollowedOrbit
from trimmer.branches.period_maps.mechanism_map import MechanismMap
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.errors import MechanismError, OrbitNotFoundError, UnsupportedMotionError, WrongTypeError
from trimmer.mechanism.parts import Link, Pin
from trimmer.response.orbit import NEUTRAL

SETTINGS = FollowSettings(most_points=2, most_periods=17, quiet=True)
STATE = np.array([0.1, -0.2])


class Asked:
    """Stands in for ``continuation`` and the orbit at the start, and keeps what they are asked."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.reason, self.doublings = BranchEnd.LEFT_AT_STOP, 0
        self.orbit: Any = SimpleNamespace(periods=3, instant=SimpleNamespace(state=STATE))
        monkeypatch.setattr(following, "continuation", self.continuation)
        monkeypatch.setattr(following, "_orbit_at_start", self.at_start)
        monkeypatch.setattr(following, "fitting", self.fitting)

    def continuation(self, map: Any, state: Any, start: float, stop: float, settings: Any) -> Branch:
        self.map, self.state, self.interval, self.settings = map, state, (start, stop), settings
        return Branch((), (), self.reason, "as it was", doublings=self.doublings)

    def at_start(self, mechanism: Any, most_periods: int, periods: int | None) -> Any:
        self.start = mechanism, most_periods, periods
        return self.orbit

    def fitting(self, map: MechanismMap, value: float, state: Any) -> MechanismMap:
        self.fitted = map, value, state
        return map.doubled()


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Asked:
    return Asked(monkeypatch)


def test_a_branch_begins_with_what_the_mechanism_settles_to(asked: Asked) -> None:
    asked.doublings = 1
    branch = follow(linear_oscillator(), "forces.push.phase", -2.0, 1.5, settings=SETTINGS)
    mechanism, most, periods = asked.start
    assert (mechanism.value("forces.push.phase"), most, periods) == (-2.0, 17, None)
    map, value, state = asked.fitted
    assert (map.place, map.scale, map.periods, map.mirrored) == ("forces.push.phase", 2.0, 3, False)
    assert map.mechanism is mechanism
    assert (value, state) == (-2.0, STATE)
    assert (asked.map.single is map, asked.state is STATE, asked.settings is SETTINGS) == (True, True, True)
    assert asked.interval == (-2.0, 1.5)
    # The map is doubled as often as that with which the branch begins.
    assert (branch.periods, branch.reason, branch.message) == (6, BranchEnd.LEFT_AT_STOP, "as it was")
    wider = follow(linear_oscillator(), "forces.push.phase", -1.0, 1.5, periods=2, settings=SETTINGS)
    assert asked.start[2] == 2
    assert (asked.fitted[0].scale, asked.fitted[0].periods) == (1.5, 2)
    assert wider.periods == 4


def test_a_branch_begins_with_a_state_that_is_given(asked: Asked) -> None:
    follow(linear_oscillator(), "frequency", 1.1, 1.2, state=[0.3, 0.4], settings=SETTINGS)
    map, value, state = asked.fitted
    assert (map.periods, value, state.tolist()) == (1, 1.1, [0.3, 0.4])
    assert asked.state.tolist() == [0.3, 0.4]
    assert not hasattr(asked, "start")
    follow(linear_oscillator(), "frequency", 1.1, 1.2, periods=5, state=[0.3, 0.4], settings=SETTINGS)
    assert asked.fitted[0].periods == 5
    with pytest.raises(WrongTypeError, match="state"):
        follow(linear_oscillator(), "frequency", 1.1, 1.2, state="rest", settings=SETTINGS)
    with pytest.raises(ValueError, match="periods"):
        follow(linear_oscillator(), "frequency", 1.1, 1.2, periods=0, state=STATE, settings=SETTINGS)


@pytest.mark.parametrize("given", [False, True])
def test_what_was_looked_for_in_vain_at_the_start_is_told(asked: Asked, given: bool) -> None:
    asked.reason = BranchEnd.NO_START
    told = follow(
        linear_oscillator(), "frequency", 1.1, 1.2, state=STATE if given else None, settings=SETTINGS
    )
    assert told.message == ("as it was" if given else _unsettled(1.1, 17))
    assert "from rest at 1.1 the motion has not settled within 17 drive periods" in _unsettled(1.1, 17)
    asked.orbit = None
    if not given:
        nothing = follow(linear_oscillator(), "frequency", 1.1, 1.2, settings=SETTINGS)
        assert (nothing.points, nothing.special, nothing.reason) == ((), (), BranchEnd.NO_START)
        assert nothing.message == _unsettled(1.1, 17)
        assert (nothing.map.scale, nothing.map.periods) == (1.2, 1)


def test_an_orbit_of_given_periods_must_have_been_found(monkeypatch: pytest.MonkeyPatch) -> None:
    orbit = SimpleNamespace(success=True)
    asked = []

    def found(mechanism: Any, periods: int) -> Any:
        asked.append((mechanism, periods))
        if periods == 4:
            raise OrbitNotFoundError("it is lost")
        return orbit

    monkeypatch.setattr(following, "mechanism_orbit", found)
    monkeypatch.setattr(following, "orbit_from_rest", lambda *given: given)
    assert _orbit_at_start("it", 9, 3) is orbit  # type: ignore[arg-type]
    assert _orbit_at_start("it", 9, 4) is None  # type: ignore[arg-type]
    orbit.success = False
    assert _orbit_at_start("it", 9, 3) is None  # type: ignore[arg-type]
    assert asked == [("it", 3), ("it", 4), ("it", 3)]
    assert _orbit_at_start("it", 9, None) == ("it", 9)  # type: ignore[arg-type, comparison-overlap]


def test_periods_and_places_are_checked() -> None:
    for periods in (0, 1.5):
        with pytest.raises((ValueError, WrongTypeError), match="periods"):
            follow(linear_oscillator(), "frequency", 1.1, 1.2, periods=periods)  # type: ignore[arg-type]
    with pytest.raises(WrongTypeError, match="mechanism"):
        follow("it", "frequency", 1.1, 1.2)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="periods is 1, but the mechanism has no drive"):
        follow(belt(), SPEED, 0.2, 0.3, periods=1)
    with pytest.raises(
        MechanismError, match=r"shape \(2,\), but without a drive it is 2 states and the period"
    ):
        follow(belt(), SPEED, 0.2, 0.3, state=[0.7, 0.2])


def test_branches_of_a_mechanism_have_the_map_of_their_whole_period() -> None:
    base = MechanismMap(between_stops(0.2), "frequency", 0.3, mirrored=True)
    point = BranchPoint(0.2, np.zeros(2), np.zeros(2, complex), {}, 0)
    parted = SpecialPoint(SpecialKind.PERIOD_DOUBLING, 0.1, np.zeros(2))
    inner = Branch((), (), BranchEnd.TORN, "inner", parted=parted, doublings=2)
    branch = Branch((point,), (parted,), BranchEnd.CLOSED, "outer", (inner,))
    found = _followed(branch, base)
    assert (found.map.periods, found.map.mirrored, found.map.single) == (1, False, None)
    assert (found.special, found.reason, found.message) == ((parted,), BranchEnd.CLOSED, "outer")
    assert found.parted is None
    (orbit,) = found.points
    assert (orbit.point is point, orbit.map is found.map) == (True, True)
    (other,) = found.branches
    assert (other.map.periods, other.map.doublings, other.parted) == (2, 2, parted)
    assert (other.points, other.reason, other.message) == ((), BranchEnd.TORN, "inner")


def test_an_orbit_without_a_drive_has_its_own_period() -> None:
    from trimmer.branches.period_maps.self_excited_map import SelfExcitedMap

    multipliers = np.array([-0.5, 0.25, 0.0], dtype=complex)
    point = BranchPoint(0.2, np.array([0.7, 0.2, PERIOD]), multipliers, {}, 12)
    orbit = FollowedOrbit(point, SelfExcitedMap(belt(), SPEED, 0.2, 2))
    assert orbit.period == pytest.approx(2.0 * PERIOD, rel=1e-14)
    assert (orbit.events_per_period, orbit.periods) == (12.0, 2)
    assert orbit.multipliers.tolist() == [1.0, -0.5]
    assert orbit.largest_multiplier == 0.5
    driven = FollowedOrbit(point, MechanismMap(linear_oscillator(), "bodies.mass.mass", 1.0, 3))
    assert driven.events_per_period == 4.0
    assert driven.period == pytest.approx(3.0 * 2.0 * math.pi / 7.5, rel=1e-12)
    assert driven.multipliers is multipliers


def test_without_a_drive_the_map_is_doubled_as_often_as_the_events_halve(
    asked: Asked, monkeypatch: pytest.MonkeyPatch
) -> None:
    from trimmer.branches.period_maps.self_excited_map import SelfExcitedPassage

    monkeypatch.setattr(SelfExcitedPassage, "halvings", 2)
    branch = follow(belt(), SPEED, 0.2, -0.3, state=[0.7, 0.2, 2.0 * PERIOD], settings=SETTINGS)
    assert (asked.map.periods, asked.map.doublings, asked.map.scale) == (4, 2, 0.3)
    assert asked.state == pytest.approx([0.7, 0.2, 0.5 * PERIOD], rel=1e-14)
    assert (asked.interval, asked.settings) == ((0.2, -0.3), SETTINGS)
    assert branch.map.periods == 1


def test_without_a_drive_a_motion_that_does_not_repeat_begins_no_branch(asked: Asked) -> None:
    still = belt().with_value("frictions.rubbing.static", 0.5).with_value("links.spring.damping", 0.4)
    branch = follow(still, SPEED, 0.2, 0.3, settings=SETTINGS)
    assert (branch.points, branch.reason) == ((), BranchEnd.NO_START)
    assert branch.message.startswith("at 0.2 there is no motion to begin with: ")
    assert (branch.map.place, branch.map.scale, branch.map.mechanism.value(SPEED)) == (SPEED, 0.3, 0.2)
    settled = follow(belt(), SPEED, 0.2, 0.3, settings=SETTINGS)
    assert settled.reason is BranchEnd.LEFT_AT_STOP
    assert asked.state[-1] == pytest.approx(PERIOD, rel=1e-9)
    assert asked.map.scale == 0.3


@pytest.mark.parametrize(
    ("nearest", "alone"), [(1.0 + 9e-7, False), (1.0 - 9e-7, False), (1.0 + 1.1e-6, True)]
)
def test_without_a_drive_one_orbit_of_many_begins_no_branch(
    asked: Asked, monkeypatch: pytest.MonkeyPatch, nearest: float, alone: bool
) -> None:
    from trimmer.branches.period_maps.self_excited_map import SelfExcitedPassage

    assert NEUTRAL == 1e-6
    monkeypatch.setattr(SelfExcitedPassage, "monodromy", np.diag([0.5, nearest, 0.0]))
    branch = follow(belt(), SPEED, 0.2, 0.3, state=[0.7, 0.2, PERIOD], settings=SETTINGS)
    assert (branch.reason is BranchEnd.LEFT_AT_STOP) is alone
    assert branch.map.place == SPEED
    if not alone:
        assert (branch.points, branch.special, branch.reason) == ((), (), BranchEnd.NOT_ISOLATED)
        assert branch.message == f"{BranchEnd.NOT_ISOLATED.value}, at 0.2"


def test_orders_are_not_followed_over() -> None:
    with pytest.raises(MechanismError, match="orders are whole numbers"):
        _interval(linear_oscillator(), "forces.push.order", 1, 3)


def test_a_motion_must_repeat_at_both_ends() -> None:
    leaning = replace(linear_oscillator(), pins={"pin": Pin("ground", amplitude=0.1)})
    leaning = replace(leaning, links={**leaning.links, "pull": Link(("pin", "mass"), stiffness=3.0)})
    for interval in ((0.0, 1.0), (1.0, 0.0)):
        with pytest.raises(UnsupportedMotionError, match="goes on for ever"):
            _interval(leaning, "pins.pin.velocity", *interval)
