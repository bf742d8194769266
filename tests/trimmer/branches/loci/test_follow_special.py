"""Special points over two numbers: against closed forms, and against branches over one number each."""

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure

from tests.trimmer import results
from tests.trimmer.branches.published import ALONE, TURN, dead_zone, oscillator_with_a_stop
from tests.trimmer.maps.machines import linear_oscillator
from trimmer import FollowedBranch, FollowSettings, Force, Mechanism, SpecialKind, Stop, follow
from trimmer.branches import Locus, LocusEnd, LocusRanges, LocusSettings, SpecialPoint, follow_special
from trimmer.errors import MechanismError, UnsupportedMotionError, WrongTypeError

EXAMPLES = Path(__file__).parents[4] / "examples"
QUIET = LocusSettings(quiet=True)
WIDE = LocusSettings(quiet=True, largest_step=0.08)
FAR = LocusSettings(quiet=True, largest_step=0.2)
LONG = LocusSettings(quiet=True, largest_step=0.5)
COARSE = replace(ALONE, largest_step=0.1)
GAP = "stops.stop.gap"
RANGES = LocusRanges((0.6, 1.6), (5.0, 30.0))


@pytest.fixture(scope="module")
def branch() -> FollowedBranch:
    return oscillator_with_a_stop()


@pytest.fixture(scope="module")
def near() -> FollowedBranch:
    """Of the same oscillator, with its first grazing and period doubling only."""
    mechanism = Mechanism.from_toml(EXAMPLES / "oscillator-stop.toml")
    return follow(mechanism, "frequency", 5.4 / TURN, 5.65 / TURN, settings=COARSE)


def of_kind(branch: FollowedBranch, kind: SpecialKind, number: int = 0) -> SpecialPoint:
    return [point for point in branch.special if point.kind is kind][number]


def amplitude(frequency: np.ndarray) -> np.ndarray:
    """Of the linear oscillator, whose motion touches the stop where it is the gap."""
    omega = TURN * frequency
    return np.asarray(100.0 / abs(40.0 - omega**2 + 0.1j * math.sqrt(40.0) * omega))


def assert_one_number_agrees(branch: FollowedBranch, locus: Locus, at: int, rel: float) -> None:
    """Follow a branch from rest at the second number's value, and look for the same point on it."""
    frequency, gap = locus.values[at]
    mechanism = branch.map.mechanism.with_value(GAP, float(gap))
    alone = follow(mechanism, "frequency", 4.2 / TURN, 10.2 / TURN, settings=ALONE)
    found = [each.value for each in alone.special if (each.kind, each.parts) == (locus.kind, locus.parts)]
    assert min(found, key=lambda value: abs(value - frequency)) == pytest.approx(frequency, rel=rel)


@pytest.mark.slow
def test_grazing_where_the_linear_amplitude_is_the_gap_around_the_resonance(branch: FollowedBranch) -> None:
    locus = follow_special(
        branch, of_kind(branch, SpecialKind.GRAZING), GAP, 30.0, ranges=RANGES, settings=WIDE
    )
    assert locus.reason is LocusEnd.LEFT
    assert locus.second == pytest.approx(amplitude(locus.first), rel=1e-10)
    assert locus.second[0] == 10.0
    assert locus.second[-1] == pytest.approx(5.0, rel=1e-12)
    # It turns at the resonance, where the amplitude is largest: a closed form.
    assert locus.second.max() == pytest.approx(100.0 / (0.1 * 40.0 * math.sqrt(1.0 - 0.05**2)), rel=5e-3)
    assert locus.first[0] < 0.9 < 1.2 < locus.first[-1]
    assert locus.residual.max() < 3e-12
    assert np.isnan(locus.distance).all()


@pytest.mark.slow
def test_period_doublings_meet_and_each_is_one_of_a_branch_over_one_number(branch: FollowedBranch) -> None:
    first, second = (of_kind(branch, SpecialKind.PERIOD_DOUBLING, number) for number in (0, 1))
    locus = follow_special(branch, first, GAP, 30.0, ranges=RANGES)
    assert locus.reason is LocusEnd.LEFT
    assert locus.distance.max() < 1e-9
    assert locus.residual.max() < 3e-12
    # It passes the other point at the same gap, after both have met where it turns.
    back = int(np.argmin(abs(locus.second[10:] - 10.0))) + 10
    assert locus.first[back - 1 : back + 2].min() < second.value < locus.first[back - 1 : back + 2].max()
    for at in (5, len(locus.values) - 3):
        assert_one_number_agrees(branch, locus, at, 1e-9)


@pytest.mark.slow
def test_folds_are_those_of_branches_over_one_number(branch: FollowedBranch) -> None:
    locus = follow_special(branch, of_kind(branch, SpecialKind.FOLD), GAP, 5.0, ranges=RANGES)
    assert locus.reason is LocusEnd.LEFT
    assert locus.distance.max() < 1e-9
    for at in (4, len(locus.values) - 2):
        assert_one_number_agrees(branch, locus, at, 1e-9)


@pytest.mark.slow
def test_both_folds_lie_on_one_locus_through_a_cusp(branch: FollowedBranch) -> None:
    upper, lower = (of_kind(branch, SpecialKind.FOLD, number) for number in (0, 1))
    ways = [follow_special(branch, each, GAP, 30.0, ranges=RANGES) for each in (upper, lower)]
    assert [way.reason for way in ways] == [LocusEnd.LEFT, LocusEnd.LEFT]
    # The cusp is the highest point of both, and known as well as their steps are short.
    tips = [way.values[np.argmax(way.second)] for way in ways]
    assert tips[0] == pytest.approx(tips[1], rel=1e-3)
    assert ways[0].first[-1] == pytest.approx(
        follow_special(branch, lower, GAP, 5.0, ranges=RANGES).first[-1], rel=1e-9
    )


@pytest.mark.slow
def test_the_grazing_of_the_dead_zone_lies_where_the_linear_motion_is_as_wide_as_the_zone() -> None:
    # The body leans on the upper side of the zone with the constant force, and moves around there with
    # 0.05 omega^2 / |1 - omega^2 + 0.1 i omega|, until it comes down to the side of the zone.
    ranges = LocusRanges((0.4 / TURN, 1.9 / TURN), (0.05, 0.12))
    branch = follow(dead_zone(1.5), "frequency", 1.5 / TURN, 1.35 / TURN, settings=COARSE)
    (point,) = branch.special
    locus = follow_special(branch, point, "forces.drive.constant", 0.12, ranges=ranges, settings=FAR)
    assert locus.reason is LocusEnd.LEFT
    omega = TURN * locus.first
    assert locus.second == pytest.approx(0.05 * omega**2 / abs(1.0 - omega**2 + 0.1j * omega), rel=1e-9)


def onset_of_stick(ratio: np.ndarray) -> np.ndarray:
    """Friction, relative to the force, at which Den Hartog's motion begins to stick where it turns.

    There the displacement times stiffness less the force of the drive is the friction: x k/P r² = b, with
    x k/P = sqrt(V² - b² U²) from his formula.
    """
    v = 1.0 / (1.0 - ratio**2)
    u = np.sin(np.pi / ratio) / (ratio * (1.0 + np.cos(np.pi / ratio)))
    return np.asarray(ratio**2 * abs(v) / np.sqrt(1.0 + ratio**4 * u**2))


@pytest.mark.parametrize("stop", [0.85, pytest.param(1.6, marks=pytest.mark.slow)])
def test_stick_begins_where_den_hartogs_formula_says(stop: float) -> None:
    mechanism = Mechanism.from_toml(EXAMPLES / "den-hartog.toml").with_value("frequency", 1.2 / TURN)
    branch = follow(mechanism, "frictions.floor.force", 0.6, 0.8, settings=ALONE)
    (stick,) = branch.special
    assert (stick.kind, stick.parts) == (SpecialKind.STICK, ("floor",))
    ranges = LocusRanges((0.2, 1.4), (0.85 / TURN, 1.6 / TURN))
    locus = follow_special(branch, stick, "frequency", stop / TURN, ranges=ranges, settings=WIDE)
    assert locus.reason is LocusEnd.LEFT
    assert locus.second[-1] * TURN == pytest.approx(stop, rel=1e-12)
    assert locus.first == pytest.approx(onset_of_stick(TURN * locus.second), rel=1e-11)
    steps = np.linalg.norm(np.diff(locus.values, axis=0) / [1.2, 0.75 / TURN], axis=1)
    assert 0.06 < steps.max() < 0.08 * 1.05


@pytest.mark.slow
def test_a_doubling_at_which_a_branch_joins_is_followed_as_one_of_the_single_motion(
    branch: FollowedBranch,
) -> None:
    doubled = branch.map.mechanism.with_value("frequency", 0.886)
    joined = follow(doubled, "frequency", 0.886, 0.87, settings=ALONE)
    assert joined.periods == 2
    (joint,) = [each for each in joined.special if each.kind is SpecialKind.PERIOD_DOUBLING]
    ranges = LocusRanges((0.85, 0.95), (9.95, 10.05))
    locus = follow_special(joined, joint, GAP, 10.05, ranges=ranges, settings=WIDE)
    assert locus.periods == 1
    doubling = of_kind(branch, SpecialKind.PERIOD_DOUBLING)
    single = follow_special(branch, doubling, GAP, 10.05, ranges=ranges, settings=WIDE)
    assert locus.reason is single.reason is LocusEnd.LEFT
    assert locus.values[-1] == pytest.approx(single.values[-1], rel=1e-9)


@pytest.mark.slow
def test_a_grazing_locus_around_a_peak_of_the_amplitude_closes() -> None:
    """Two forces of 50 N, one of them later by a phase, which both the drive and the phase bring down.

    Below contact the motion is linear: its amplitude is the gap on a closed curve around the peak.
    """
    forces = {name: Force("mass", amplitude=50.0) for name in ("first", "second")}
    wall = Stop(("ground", "mass"), 1000.0, gap=24.9)
    machine = replace(linear_oscillator(), forces=forces, stops={"wall": wall}, frequency=0.985)
    branch = follow(machine, "frequency", 0.985, 1.0, settings=ALONE)
    ranges = LocusRanges((0.996, 1.012), (-0.35, 0.35))
    point = next(each for each in branch.special if each.kind is SpecialKind.GRAZING)
    locus = follow_special(branch, point, "forces.second.phase", 0.3, ranges=ranges, settings=LONG)
    assert locus.reason is LocusEnd.CLOSED
    assert locus.success
    assert locus.second.min() < -0.15 < 0.15 < locus.second.max()
    both = 0.5 * abs(1.0 + np.exp(1j * locus.second)) * amplitude(locus.first)
    assert both == pytest.approx(np.full(len(both), 24.9), rel=1e-10)
    assert locus.units == ("Hz", "rad")


def test_a_locus_ends_at_most_points_and_says_where(near: FollowedBranch) -> None:
    point = of_kind(near, SpecialKind.GRAZING)
    few = LocusSettings(most_points=3, quiet=True)
    locus = follow_special(near, point, GAP, 30.0, ranges=RANGES, settings=few)
    assert locus.reason is LocusEnd.MOST_POINTS
    assert len(locus.values) == 3
    assert not locus.success
    assert f"at frequency = {locus.first[-1]:.10g} and {GAP} = {locus.second[-1]:.10g}" in locus.message
    assert (locus.first[0], locus.second[0]) == (pytest.approx(point.value, rel=1e-10), 10.0)
    assert (locus.kind, locus.parts, locus.name) == (SpecialKind.GRAZING, ("stop",), "grazing, stop")


@pytest.mark.slow
def test_a_point_that_is_not_there_is_lost_and_what_lies_beside_it_is_named(near: FollowedBranch) -> None:
    grazing = of_kind(near, SpecialKind.GRAZING)
    torus = replace(grazing, kind=SpecialKind.TORUS, parts=())
    hasty = LocusSettings(smallest_step=1e-3, quiet=True)
    found = follow_special(near, torus, GAP, 12.0, settings=hasty)
    assert found.reason is LocusEnd.CHANGED
    assert found.message.endswith("; beside it: grazing, period-doubling")


@pytest.mark.parametrize(
    ("error", "told", "arguments"),
    [
        (MechanismError, "a second number", ("frequency", 2.0)),
        (MechanismError, "a second number", ("forces.drive.order", 2)),
        (MechanismError, "did you mean", ("stops.stop.gapp", 2.0)),
        (ValueError, "is 10 already", (GAP, "10 m")),
        (ValueError, "do not hold the point", (GAP, 12.0, LocusRanges((1.0, 2.0), (10.0, 12.0)))),
    ],
)
def test_a_second_number_that_cannot_be_is_told(
    near: FollowedBranch, error: type[Exception], told: str, arguments: tuple[Any, ...]
) -> None:
    place, stop, *ranges = arguments
    with pytest.raises(error, match=told):
        follow_special(near, near.special[0], place, stop, ranges=next(iter(ranges), None))


def test_what_is_no_special_point_of_a_driven_branch_is_told(near: FollowedBranch) -> None:
    with pytest.raises(WrongTypeError, match="branch"):
        follow_special(near.map, near.special[0], GAP, 11.0)  # type: ignore[arg-type]
    with pytest.raises(WrongTypeError, match="special"):
        follow_special(near, 1.25, GAP, 11.0)  # type: ignore[arg-type]
    belt, few = (
        Mechanism.from_toml(EXAMPLES / "block-on-belt.toml"),
        FollowSettings(most_points=2, quiet=True),
    )
    free = follow(belt, "pins.belt.velocity", 0.1, 0.2, settings=few)
    with pytest.raises(UnsupportedMotionError, match="driven motions only"):
        follow_special(free, near.special[0], "links.spring.stiffness", 1.3)


@pytest.mark.parametrize(
    ("name", "value"),
    [("most_points", 1), ("largest_step", 1.5), ("smallest_step", 0.04), ("smallest_step", 0.0)],
)
def test_settings_out_of_bounds_are_refused(name: str, value: Any) -> None:
    with pytest.raises(ValueError, match=name):
        LocusSettings(**{name: value})
    assert LocusSettings(2, 1.0, 1.0).smallest_step == 1.0


@pytest.mark.parametrize(("name", "range"), [("first", (1.0, 1.0)), ("second", (2.0, 1.0))])
def test_ranges_without_a_length_are_refused(name: str, range: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match=name):
        LocusRanges(**{"first": (0.0, 1.0), "second": (0.0, 1.0), name: range})


def test_a_locus_tells_its_points() -> None:
    locus = results.locus()
    assert "fold over frequency and stops.wall.gap, 3 points" in repr(locus)
    frame = locus.to_dataframe()
    assert frame.to_numpy().tolist() == [[*row, 0.0, 0.0] for row in locus.values.tolist()]
    assert frame.attrs["units"] == {"frequency": "Hz", "stops.wall.gap": "m", "residual": "", "distance": ""}
    both = replace(locus, kind=SpecialKind.STICK, parts=("a", "b"), units=("", ""))
    assert both.name == "stick, a and b"
    assert both.plot(Figure().add_subplot()).get_xlabel() == "frequency"
    assert {each for each in LocusEnd if each.is_success} == {LocusEnd.LEFT, LocusEnd.CLOSED}
