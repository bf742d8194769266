"""Where branches of asymmetric orbits, or of doubled ones, join those from which they part."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.branches.maps import Cubic, Logistic
from trimmer.branches.branch import BranchEnd
from trimmer.branches.continuation import continuation
from trimmer.branches.follow import follow
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.joining import _middle, joint
from trimmer.branches.orbit import Place, Problem
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind
from trimmer.branches.step import Front, begun, halves, rejoined
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force, Link, Play

EXAMPLES = Path(__file__).parents[3] / "examples"
ALONE = FollowSettings(switches=0)


def test_asymmetric_branch_goes_on_along_the_symmetric_one() -> None:
    branch = continuation(Cubic(mirrored=True).doubled(), np.array([0.5**0.5]), 0.5, -0.5)
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


def test_doubled_branch_ends_where_both_sides_of_the_single_one_begin() -> None:
    branch = continuation(Logistic().doubled(), np.array([0.479]), 3.3, 2.5)
    assert branch.reason is BranchEnd.REJOINED
    assert [point.kind for point in branch.special] == [SpecialKind.PERIOD_DOUBLING]
    assert branch.special[0].value == pytest.approx(3.0, rel=1e-14)
    ends = [(each.doublings, each.reason, each.points[-1].state[0]) for each in branch.branches]
    assert ends == [
        (0, BranchEnd.LEFT_AT_STOP, pytest.approx(0.6)),
        (0, BranchEnd.LEFT_AT_START, pytest.approx(1.0 - 1.0 / 3.3)),
    ]


def test_orbits_that_are_known_are_not_followed_again() -> None:
    # The map knows of no mirror, so that the branch goes through and on to its own mirror image.
    branch = continuation(Cubic(mirrored=False), np.array([0.5**0.5]), 0.5, -0.5)
    assert branch.points[-1].state[0] == pytest.approx(-(0.5**0.5))
    assert SpecialKind.SYMMETRY_BREAKING in [point.kind for point in branch.special]
    assert branch.branches == ()


def between_stops(frequency: float) -> Mechanism:
    """A driven body between two springs of equal gap: near 0.17 Hz its motion leans to one side."""
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


def test_symmetry_breaking_from_both_sides() -> None:
    symmetric = follow(between_stops(0.2), "frequency", 0.2, 0.18, settings=ALONE)
    expected = breaking(symmetric)
    assert expected == [pytest.approx(0.191360833785, rel=1e-11)]
    branch = follow(between_stops(0.18), "frequency", 0.18, 0.2)
    assert [point.kind for point in branch.special] == [SpecialKind.SYMMETRY_BREAKING]
    assert breaking(branch) == [pytest.approx(expected[0], rel=1e-12)]
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    assert not is_its_own_mirror_image(branch, 0)
    assert is_its_own_mirror_image(branch, -1)
    assert branch.points[-1].state == pytest.approx(symmetric.points[0].state, abs=1e-9)
    (behind,) = branch.branches
    assert not any(orbit.stable for orbit in behind.points)
    assert behind.points[-1].state == pytest.approx(symmetric.points[-1].state, abs=1e-9)


def test_doubled_motion_leads_to_the_asymmetric_branch_and_on_to_the_symmetric_one() -> None:
    # At 0.16 Hz it settles to two drive periods. Both values: followed from the symmetric motion at 0.25 Hz.
    branch = follow(
        between_stops(0.16), "frequency", 0.16, 0.25, settings=FollowSettings(bounds=(0.16, 0.25))
    )
    assert (branch.periods, branch.reason) == (2, BranchEnd.REJOINED)
    assert branch.special[-1].value == pytest.approx(0.162204587303, rel=1e-11)
    assert [each.periods for each in branch.branches] == [1, 1]
    wider = FollowSettings(bounds=(0.155, 0.25))
    branch = follow(between_stops(0.16), "frequency", 0.16, 0.25, settings=wider)
    assert breaking(branch.branches[0]) == [pytest.approx(0.191360833785, rel=1e-11)]
    assert branch.branches[0].reason is BranchEnd.LEFT_AT_STOP


def test_single_orbit_beyond_a_joint_is_noticed() -> None:
    # Newton's method found one, and the branch went on along the single orbits as if they were doubled.
    problem = Problem(Logistic().doubled(), 1.0, np.ones(1))
    across = np.array([0.0, 1.0])
    near = problem.correct(np.array([0.63, 3.01]), across, 3.01)
    assert near is not None
    tangent = near.tangent(-across)
    assert tangent is not None
    front = begun(problem, near, tangent)
    assert not rejoined(front, near)
    # Which half is larger by rounding differs.
    for value in np.linspace(2.992, 2.998, 7):
        far = problem.correct(np.array([1.0 - 1.0 / value, value]), across, value)
        assert far is not None
        assert rejoined(front, far)
        meeting = joint(front, far)
        assert meeting is not None
        assert meeting.point.value == pytest.approx(3.0, rel=1e-14)


def doubled(state: float, middle: float | None) -> Place:
    problem = SimpleNamespace(sizes=np.array([0.5, 4.0]))
    after = None if middle is None else np.array([middle, 8.0])
    return SimpleNamespace(  # type: ignore[return-value]
        problem=problem, position=np.array([state, 2.0, 7.0]), passage=SimpleNamespace(middle=after)
    )


@pytest.mark.parametrize(
    ("near", "far", "joined"),
    [
        ((1.0, 0.6), (1.0, 0.55), False),
        ((1.0, 0.6), (1.0, 0.45), True),
        ((1.0, 0.4), (1.0, 0.45), False),
        ((1.0, 0.6), (1.0, 0.5), True),
        ((1.0, None), (1.0, 0.5), False),
        ((1.0, 0.6), (1.0, None), False),
    ],
)
def test_a_doubled_orbit_has_become_a_single_one_where_its_halves_are_exchanged(
    near: tuple[float, float | None], far: tuple[float, float | None], joined: bool
) -> None:
    first, last = doubled(*near), doubled(*far)
    problem = SimpleNamespace(sizes=np.array([0.5, 4.0]))
    assert rejoined(Front(problem, first, np.zeros(3), 1.0), last) is joined  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("near", "far", "joined"),
    [
        ((0.5, 0.3), (-0.2, 0.0), False),
        ((0.2, 0.0), (-0.5, 0.3), False),
        ((0.5, 0.2), (-0.2, 0.0), True),
        ((0.2, 0.0), (-0.5, 0.2), True),
    ],
)
def test_halves_are_exchanged_if_their_differences_are_nearly_opposite(
    near: tuple[float, float], far: tuple[float, float], joined: bool
) -> None:
    # The cosine is -0.857 for (0.5, 0.3) against (-1, 0), and -0.928 for (0.5, 0.2).
    problem = SimpleNamespace(sizes=np.array([0.5, 4.0]))
    places = [doubled(1.0, 0.5) for _ in range(2)]
    for place, difference in zip(places, (near, far), strict=True):
        place.passage.middle = (place.position[:-1] + difference) * problem.sizes  # type: ignore[misc]
    assert rejoined(Front(problem, places[0], np.zeros(3), 1.0), places[1]) is joined  # type: ignore[arg-type]


def test_halves_are_in_the_scale_of_the_problem_and_their_mean_is_the_guess() -> None:
    problem = SimpleNamespace(sizes=np.array([0.5, 4.0]))
    first, last = doubled(1.0, 0.6), doubled(1.4, 0.6)
    assert halves(problem, first) == pytest.approx([0.2, 0.0], rel=1e-12)  # type: ignore[arg-type]
    assert halves(problem, last) == pytest.approx([-0.2, 0.0], rel=1e-12)  # type: ignore[arg-type]
    front = Front(problem, first, np.zeros(3), 1.0)  # type: ignore[arg-type]
    assert _middle(front, last) == pytest.approx([1.2, 2.0, 7.0], rel=1e-12)
    nearer = doubled(1.0, 0.35)
    nearer.position[-1] = 8.0
    # The difference falls from 0.2 to -0.3: it is zero after two fifths.
    assert _middle(front, nearer) == pytest.approx([1.0, 2.0, 7.4], rel=1e-12)
    # From (0.4, 0) to (0, 0.6) it is (0.24, 0.24) at two fifths, and half of that is added.
    turned = doubled(1.0, 0.5)
    turned.passage.middle = np.array([0.5, 10.4])  # type: ignore[misc]
    assert _middle(replace(front, place=doubled(1.0, 0.7)), turned) == pytest.approx(
        [1.12, 2.12, 7.0], rel=1e-12
    )
    single = doubled(2.0, None)
    later = doubled(2.0, None)
    later.position[-1] = 9.0
    assert _middle(Front(problem, single, np.zeros(3), 1.0), later).tolist() == [2.0, 2.0, 8.0]  # type: ignore[arg-type]


@pytest.mark.slow
def test_trimmer_goes_on_from_asymmetric_to_symmetric_motions() -> None:
    mechanism = Mechanism.from_toml(EXAMPLES / "thesis-play.toml")
    branch = follow(mechanism, "frequency", 120.0, 170.0)
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
