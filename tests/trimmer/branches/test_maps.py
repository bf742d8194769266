"""Branches of maps whose special points are known in closed form, or to many digits."""

import numpy as np
import pytest

from tests.trimmer.branches.maps import (
    Bent,
    Cubic,
    DelayedLogistic,
    Failing,
    Henon,
    Logistic,
    Ring,
    Steps,
    Torn,
    Twice,
)
from trimmer.branches import BranchEnd, FollowSettings, SpecialKind
from trimmer.branches.branch import Branch
from trimmer.branches.continuation import continuation
from trimmer.motion.part import Phase

COARSE = FollowSettings(largest_step=0.05)
CASCADE = (3.0, 1.0 + 6.0**0.5, 3.544090359551, 3.564407266095, 3.568759419544)
"""Period doublings of the logistic map: OEIS A086181, A091517 and Briggs, Math. Comp. 57 (1991)."""


def found(branch: Branch, kind: SpecialKind) -> list[float]:
    return [point.value for point in branch.special if point.kind is kind]


def test_cascade_of_period_doublings() -> None:
    branch = continuation(Logistic(), np.array([0.6]), 2.5, 3.9, FollowSettings(switches=4, largest_step=0.1))
    values = []
    for _ in range(4):
        assert branch.reason is BranchEnd.LEFT_AT_STOP
        values += found(branch, SpecialKind.PERIOD_DOUBLING)[:1]
        (branch,) = branch.branches
    values += found(branch, SpecialKind.PERIOD_DOUBLING)[:1]
    assert values == pytest.approx(CASCADE, rel=1e-12)
    assert branch.parted is not None and branch.parted.value == values[3]


def test_stability_along_the_logistic_branch() -> None:
    branch = continuation(Logistic(), np.array([0.6]), 2.5, 3.9, FollowSettings(switches=0))
    assert all(point.stable == (point.value < 3.0) for point in branch.points)
    assert all(point.multipliers[0] == pytest.approx(2.0 - point.value) for point in branch.points)


@pytest.mark.parametrize(
    ("units", "unit_of_value"), [((1.0, 1.0), 1.0), ((1e-6, 3e3), 1e4), ((2e5, 1e-9), 1e-7)]
)
def test_fold_and_flip_of_henon_in_all_units(units: tuple[float, float], unit_of_value: float) -> None:
    map = Henon(units=units, unit_of_value=unit_of_value)
    state = np.array([1.2, 0.36]) * units
    branch = continuation(map, state, -0.05 * unit_of_value, -0.5 * unit_of_value, COARSE)
    assert branch.reason is BranchEnd.LEFT_AT_START
    values = [value / unit_of_value for value in found(branch, SpecialKind.FOLD)]
    assert values == pytest.approx([-0.1225], rel=1e-11)
    state = np.array([0.6, 0.2]) * units
    up = continuation(map, state, 0.2 * unit_of_value, 1.0 * unit_of_value, COARSE)
    values = [value / unit_of_value for value in found(up, SpecialKind.PERIOD_DOUBLING)]
    assert values == pytest.approx([0.3675], rel=1e-11)
    (doubled,) = up.branches
    values = [value / unit_of_value for value in found(doubled, SpecialKind.PERIOD_DOUBLING)]
    assert values == pytest.approx([0.9125], rel=1e-11)
    assert len(up.points) == 27


def test_torus() -> None:
    branch = continuation(DelayedLogistic(), np.array([0.3, 0.3]), 1.5, 2.2, COARSE)
    assert [point.kind for point in branch.special] == [SpecialKind.TORUS]
    assert branch.special[0].value == pytest.approx(2.0, rel=1e-12)


@pytest.mark.parametrize(
    ("phase", "kind"),
    [
        (Phase.UPPER, SpecialKind.GRAZING),
        (Phase.LOWER, SpecialKind.GRAZING),
        (Phase.EITHER, SpecialKind.GRAZING),
        (Phase.STICK, SpecialKind.STICK),
    ],
)
def test_corner_that_the_branch_passes(phase: Phase, kind: SpecialKind) -> None:
    branch = continuation(Bent(0.5, -0.5, phase=phase), np.array([-1.0]), -1.0, 1.0, COARSE)
    assert [point.kind for point in branch.special] == [kind]
    assert branch.special[0].note == f"stop: {phase.value}, +1"
    assert branch.special[0].value == pytest.approx(0.0, abs=1e-12)
    assert branch.special[0].parts == ("stop",)
    assert branch.reason is BranchEnd.LEFT_AT_STOP


def test_multiplier_that_jumps_past_minus_one_is_no_period_doubling() -> None:
    branch = continuation(Bent(0.5, -3.0), np.array([-1.0]), -1.0, 1.0)
    assert [point.kind for point in branch.special] == [SpecialKind.GRAZING]
    assert "multipliers outside the unit circle jump from 0 to 1" in branch.special[0].note


def test_corner_at_which_the_branch_turns_around() -> None:
    branch = continuation(Bent(0.5, 2.0), np.array([-1.0]), -1.0, 1.0)
    assert [point.kind for point in branch.special] == [SpecialKind.GRAZING, SpecialKind.FOLD]
    assert branch.special[1].value == pytest.approx(0.0, abs=1e-11)
    assert branch.special[1].note == "a corner at grazing"
    assert branch.reason is BranchEnd.LEFT_AT_START
    assert branch.points[-1].state[0] == pytest.approx(1.0)


@pytest.mark.parametrize("mirrored", [False, True])
def test_symmetry_breaking(mirrored: bool) -> None:
    branch = continuation(Cubic(mirrored), np.array([0.0]), -0.5, 0.5, COARSE)
    assert [point.kind for point in branch.special] == [SpecialKind.SYMMETRY_BREAKING]
    assert branch.special[0].value == pytest.approx(0.0, abs=1e-12)
    ends = sorted(abs(other.points[-1].state[0]) for other in branch.branches)
    # A mirrored map has one branch for both images, one without mirror two.
    assert ends == pytest.approx([0.5**0.5] * (1 if mirrored else 2))


def test_isolated_branch_closes_on_itself() -> None:
    branch = continuation(Ring(), np.array([1.0]), 0.0, 1.0, FollowSettings(bounds=(-2.0, 2.0)))
    assert branch.reason is BranchEnd.CLOSED
    assert found(branch, SpecialKind.FOLD) == pytest.approx([1.0, -1.0])


@pytest.mark.parametrize("distance", [3e-3, 1e-4, 1e-6])
def test_two_crossings_of_the_circle_on_one_step(distance: float) -> None:
    branch = continuation(Twice(0.1, 0.1 + distance), np.array([0.0]), -1.0, 1.0, FollowSettings(switches=0))
    assert found(branch, SpecialKind.PERIOD_DOUBLING) == pytest.approx([0.1, 0.1 + distance], rel=1e-9)


@pytest.mark.parametrize("distance", [1e-2, 1e-6, 1e-9])
def test_two_contacts_on_one_step(distance: float) -> None:
    kinks = (0.1, 0.1 + distance)
    branch = continuation(Steps(kinks), np.array([0.0]), -1.0, 1.0, COARSE)
    assert found(branch, SpecialKind.GRAZING) == pytest.approx(kinks, rel=1e-11)
    assert [point.parts for point in branch.special] == [(f"stop {each}",) for each in kinks]


def test_branch_that_is_torn_ends_with_a_reason() -> None:
    branch = continuation(Torn(), np.array([-2.0]), -1.0, 1.0, COARSE)
    assert branch.reason is BranchEnd.TORN
    assert branch.success
    assert branch.points[-1].value == pytest.approx(0.0, abs=1e-10)
    assert branch.message.startswith("the motion jumps, ")


def test_motion_that_cannot_be_followed_ends_the_branch() -> None:
    branch = continuation(Failing(), np.array([-2.0]), -1.0, 1.0)
    assert branch.reason is BranchEnd.STEP_TOO_SMALL
    assert branch.points[-1].value == pytest.approx(0.5, abs=1e-10)


def test_most_points() -> None:
    branch = continuation(Logistic(), np.array([0.6]), 2.5, 2.9, FollowSettings(most_points=7))
    assert branch.reason is BranchEnd.MOST_POINTS
    assert len(branch.points) == 7
