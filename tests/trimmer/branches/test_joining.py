"""Where branches of asymmetric orbits, or of doubled ones, join those from which they part."""

from pathlib import Path

import numpy as np
import pytest

from tests.trimmer.branches.maps import Cubic, Logistic
from trimmer import Body, FollowedBranch, FollowSettings, Force, Link, Mechanism, Play, SpecialKind, follow
from trimmer.branches import BranchEnd
from trimmer.branches.continuation import continuation

EXAMPLES = Path(__file__).parents[3] / "examples"
ALONE = FollowSettings(switches=0, quiet=True, largest_step=0.05)
QUIET = FollowSettings(quiet=True, largest_step=0.05)
BREAKING = 0.191360833785
"""Frequency, Hz, below which the motion of ``between_stops`` leans to a side; two computations."""
DOUBLING = 0.162204587303
"""Frequency, Hz, below which what leans repeats after two drive periods only; two computations."""


def test_an_asymmetric_branch_goes_on_along_the_symmetric_one() -> None:
    branch = continuation(Cubic(mirrored=True).doubled(), np.array([0.5**0.5]), 0.5, -0.5, QUIET)
    (special,) = branch.special
    assert special.kind is SpecialKind.SYMMETRY_BREAKING
    assert special.value == pytest.approx(0.0, abs=1e-14)
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    # Next to the joint the orbits are not known to the digits to which their equation holds.
    for point in branch.points:
        assert point.state[0] * (point.state[0] ** 2 - point.value) == pytest.approx(0.0, abs=1e-11)
        assert (point.state[0] > 1e-5) == (point.value > 0.0)
    (behind,) = branch.branches
    assert behind.parted is special
    assert behind.reason is BranchEnd.LEFT_AT_START
    assert behind.points[-1].value == 0.5
    assert max(abs(point.state[0]) for point in behind.points) < 1e-12


def test_without_switches_nothing_but_the_way_on_is_followed() -> None:
    branch = continuation(Cubic(mirrored=True).doubled(), np.array([0.5**0.5]), 0.5, -0.5, ALONE)
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    assert branch.branches == ()


def test_a_doubled_branch_ends_where_both_sides_of_the_single_one_begin() -> None:
    branch = continuation(Logistic().doubled(), np.array([0.479]), 3.3, 2.5, QUIET)
    assert branch.reason is BranchEnd.REJOINED
    assert [point.kind for point in branch.special] == [SpecialKind.PERIOD_DOUBLING]
    assert branch.special[0].value == pytest.approx(3.0, rel=1e-14)
    assert "joins the one with half the period" in branch.special[0].note
    ends = [(each.doublings, each.reason, each.points[-1].state[0]) for each in branch.branches]
    assert ends == [
        (0, BranchEnd.LEFT_AT_STOP, pytest.approx(0.6)),
        (0, BranchEnd.LEFT_AT_START, pytest.approx(1.0 - 1.0 / 3.3)),
    ]


def test_orbits_that_are_known_are_not_followed_again() -> None:
    # The map knows of no mirror, so that the branch goes through and on to its own mirror image.
    branch = continuation(Cubic(mirrored=False), np.array([0.5**0.5]), 0.5, -0.5, QUIET)
    assert branch.points[-1].state[0] == pytest.approx(-(0.5**0.5))
    assert SpecialKind.SYMMETRY_BREAKING in [point.kind for point in branch.special]
    assert branch.branches == ()


def between_stops(frequency: float) -> Mechanism:
    """A driven body between two springs of equal gap."""
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=frequency,
        links={"spring": Link(("ground", "body"), stiffness=1.0, damping=0.1)},
        plays={"springs": Play(("ground", "body"), 10.0, gap=2.0)},
        forces={"drive": Force("body", amplitude=3.0)},
        outputs={},
    )


def breaking(branch: FollowedBranch) -> list[float]:
    return [point.value for point in branch.special if point.kind is SpecialKind.SYMMETRY_BREAKING]


def is_its_own_mirror_image(branch: FollowedBranch, number: int) -> bool:
    orbit = branch.points[number]
    course = orbit.passage.course
    (middle,) = course.states(np.array([0.5 * course.duration]))
    return bool(abs(middle[: len(orbit.state)] + orbit.state).max() < 1e-9)


@pytest.fixture(scope="module")
def symmetric() -> FollowedBranch:
    return follow(between_stops(0.2), "frequency", 0.2, 0.18, settings=ALONE)


def test_symmetry_breaking_from_both_sides(symmetric: FollowedBranch) -> None:
    assert breaking(symmetric) == [pytest.approx(BREAKING, rel=1e-11)]
    branch = follow(between_stops(0.18), "frequency", 0.18, 0.2, settings=QUIET)
    assert breaking(branch) == [pytest.approx(breaking(symmetric)[0], rel=1e-12)]
    assert len(branch.special) == 1
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    assert not is_its_own_mirror_image(branch, 0)
    assert is_its_own_mirror_image(branch, -1)
    assert branch.points[-1].state == pytest.approx(symmetric.points[0].state, abs=1e-9)
    (behind,) = branch.branches
    assert not any(orbit.stable for orbit in behind.points)
    assert behind.points[-1].state == pytest.approx(symmetric.points[-1].state, abs=1e-9)


def test_multipliers_and_events_of_a_symmetric_motion_are_those_of_its_whole_period(
    symmetric: FollowedBranch,
) -> None:
    """It is followed as half a period and its mirror image; what is told is of all of it."""
    first = symmetric.points[0]
    whole = first.passage
    assert sorted(abs(first.multipliers)) == pytest.approx(sorted(abs(np.linalg.eigvals(whole.monodromy))))
    assert first.events_per_period == len(whole.course.events) > 0


@pytest.mark.slow
def test_a_doubled_motion_leads_to_the_asymmetric_branch_and_on_to_the_symmetric_one() -> None:
    # At 0.16 Hz it settles to two drive periods.
    wider = FollowSettings(bounds=(0.155, 0.25), quiet=True, largest_step=0.05)
    branch = follow(between_stops(0.16), "frequency", 0.16, 0.25, settings=wider)
    assert (branch.periods, branch.reason) == (2, BranchEnd.REJOINED)
    assert branch.special[-1].value == pytest.approx(DOUBLING, rel=1e-11)
    assert breaking(branch.branches[0]) == [pytest.approx(BREAKING, rel=1e-11)]
    assert branch.branches[0].reason is BranchEnd.LEFT_AT_STOP
    assert [each.periods for each in branch.branches][:2] == [1, 1]


@pytest.mark.slow
def test_the_trimmer_goes_on_from_asymmetric_to_symmetric_motions() -> None:
    mechanism = Mechanism.from_toml(EXAMPLES / "thesis-play.toml")
    branch = follow(mechanism, "frequency", 120.0, 170.0, settings=QUIET)
    kinds = [point.kind for point in branch.special]
    assert SpecialKind.FOLD not in kinds
    assert kinds.count(SpecialKind.SYMMETRY_BREAKING) == 1
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    assert is_its_own_mirror_image(branch, -1)
    behind, doubled = branch.branches
    assert behind.points[-1].value == 120.0
    assert not any(orbit.stable for orbit in behind.points)
    assert (doubled.periods, doubled.reason) == (2, BranchEnd.REJOINED)
    # This fold is 3.6e-4 Hz from the period doubling; it was lost where the branch began farther from it.
    folds = [point.value for point in doubled.special if point.kind is SpecialKind.FOLD]
    assert folds == [pytest.approx(126.914348928, rel=1e-10)]
    state = behind.points[-1].state
    symmetric = follow(mechanism, "frequency", 120.0, 130.0, periods=1, state=state, settings=ALONE)
    assert breaking(symmetric) == [pytest.approx(branch.special[-1].value, rel=1e-10)]
    assert breaking(branch) == [pytest.approx(129.307987512, rel=1e-11)]
