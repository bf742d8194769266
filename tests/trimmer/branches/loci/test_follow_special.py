"""Special points over two numbers: against closed forms, and against branches over one number each."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.trimmer.branches.test_follow import dead_zone
from trimmer.branches.follow import follow
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.loci.follow_special import follow_special
from trimmer.branches.loci.locus import Locus, LocusEnd, LocusRanges, LocusSettings
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind, SpecialPoint
from trimmer.errors import MechanismError
from trimmer.mechanism.mechanism import Mechanism

EXAMPLES = Path(__file__).parents[4] / "examples"
TURN = 2.0 * math.pi
ALONE = FollowSettings(switches=0)
GAP = "stops.stop.gap"
RANGES = LocusRanges((0.6, 1.6), (5.0, 30.0))


@pytest.fixture(scope="module")
def branch() -> FollowedBranch:
    mechanism = Mechanism.from_toml(EXAMPLES / "oscillator-stop.toml")
    return follow(mechanism, "frequency", 5.0 / TURN, 9.5 / TURN, settings=ALONE)


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


def test_grazing_where_the_linear_amplitude_is_the_gap_around_the_resonance(branch: FollowedBranch) -> None:
    locus = follow_special(branch, of_kind(branch, SpecialKind.GRAZING), GAP, 30.0, ranges=RANGES)
    assert locus.reason is LocusEnd.LEFT
    assert locus.second == pytest.approx(amplitude(locus.first), rel=1e-10)
    assert locus.second[0] == 10.0
    assert locus.second[-1] == pytest.approx(5.0, rel=1e-12)
    # It turns at the resonance, where the amplitude is largest: a closed form.
    assert locus.second.max() == pytest.approx(100.0 / (0.1 * 40.0 * math.sqrt(1.0 - 0.05**2)), rel=2e-3)
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


def test_both_grazings_of_the_dead_zone_lie_where_the_linear_motion_is_as_wide_as_the_zone() -> None:
    # The body leans on the upper side of the zone with the constant force, and moves around there with
    # 0.05 omega^2 / |1 - omega^2 + 0.1 i omega|, until it comes down to the side of the zone.
    branch = follow(dead_zone(0.5), "frequency", 0.5 / TURN, 1.6 / TURN, settings=ALONE)
    ranges = LocusRanges((0.4 / TURN, 1.9 / TURN), (0.05, 0.12))
    for point in (of_kind(branch, SpecialKind.GRAZING, number) for number in (0, 1)):
        locus = follow_special(branch, point, "forces.drive.constant", 0.12, ranges=ranges)
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


@pytest.mark.parametrize("stop", [0.75, 1.9])
def test_stick_begins_where_den_hartogs_formula_says(stop: float) -> None:
    mechanism = Mechanism.from_toml(EXAMPLES / "den-hartog.toml").with_value("frequency", 1.2 / TURN)
    branch = follow(mechanism, "frictions.floor.force", 0.6, 0.8, settings=ALONE)
    (stick,) = branch.special
    assert (stick.kind, stick.parts) == (SpecialKind.STICK, ("floor",))
    ranges = LocusRanges((0.2, 1.4), (0.75 / TURN, 1.9 / TURN))
    locus = follow_special(branch, stick, "frequency", stop / TURN, ranges=ranges)
    assert locus.reason is LocusEnd.LEFT
    assert locus.second[-1] * TURN == pytest.approx(stop, rel=1e-12)
    assert locus.first == pytest.approx(onset_of_stick(TURN * locus.second), rel=1e-11)


def test_a_doubling_at_which_a_branch_joins_is_followed_as_one_of_the_single_motion(
    branch: FollowedBranch,
) -> None:
    doubled = branch.map.mechanism.with_value("frequency", 0.886)
    joined = follow(doubled, "frequency", 0.886, 0.87, settings=ALONE)
    assert joined.periods == 2
    (joint,) = [each for each in joined.special if each.kind is SpecialKind.PERIOD_DOUBLING]
    ranges = LocusRanges((0.85, 0.95), (9.95, 10.05))
    locus = follow_special(joined, joint, GAP, 10.05, ranges=ranges)
    assert locus.periods == 1
    single = follow_special(branch, of_kind(branch, SpecialKind.PERIOD_DOUBLING), GAP, 10.05, ranges=ranges)
    assert locus.reason is single.reason is LocusEnd.LEFT
    assert locus.values[-1] == pytest.approx(single.values[-1], rel=1e-9)


def test_a_locus_ends_at_most_points_and_says_where(branch: FollowedBranch) -> None:
    point = of_kind(branch, SpecialKind.GRAZING)
    locus = follow_special(branch, point, GAP, 30.0, ranges=RANGES, settings=LocusSettings(most_points=3))
    assert locus.reason is LocusEnd.MOST_POINTS
    assert len(locus.values) == 3
    assert not locus.success
    assert f"{GAP} = {locus.second[-1]:.10g}" in locus.message


def test_wrong_use_is_told(branch: FollowedBranch) -> None:
    point = branch.special[0]
    with pytest.raises(MechanismError, match="a second number"):
        follow_special(branch, point, "frequency", 2.0)
    with pytest.raises(MechanismError, match="did you mean"):
        follow_special(branch, point, "stops.stop.gapp", 2.0)
    with pytest.raises(ValueError, match="is 10 already"):
        follow_special(branch, point, GAP, 10.0)
    with pytest.raises(ValueError, match="do not hold the point"):
        follow_special(branch, point, GAP, 12.0, ranges=LocusRanges((1.0, 2.0), (10.0, 12.0)))
    with pytest.raises(ValueError, match="lower and a higher"):
        LocusRanges((1.0, 1.0), (0.0, 1.0))
    lost = replace(point, kind=SpecialKind.TORUS)
    hasty = LocusSettings(smallest_step=1e-3)
    assert follow_special(branch, lost, GAP, 12.0, settings=hasty).reason is LocusEnd.CHANGED
