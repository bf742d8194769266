"""Branches of mechanisms against published examples. Digits: two independent computations unless said."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.trimmer.branches.published import DEAD_ZONE, OSCILLATOR_WITH_STOP
from trimmer.branches.branch import BranchEnd
from trimmer.branches.follow import follow
from trimmer.branches.followed import FollowedBranch
from trimmer.branches.settings import FollowSettings
from trimmer.branches.special import SpecialKind
from trimmer.errors import MechanismError, UnsupportedMotionError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force, Friction, Link, Pin, Play, Stop
from trimmer.response.forced_orbit import forced_orbit
from trimmer.response.same import is_mirror_symmetric

EXAMPLES = Path(__file__).parents[3] / "examples"
TURN = 2.0 * math.pi
ALONE = FollowSettings(switches=0)


def values(branch: FollowedBranch, unit: float = 1.0) -> list[tuple[SpecialKind, float]]:
    return [(point.kind, point.value * unit) for point in branch.special]


def assert_special(
    branch: FollowedBranch, expected: list[tuple[SpecialKind, float]], unit: float, rel: float
) -> None:
    found = values(branch, unit)
    assert [kind for kind, _ in found] == [kind for kind, _ in expected]
    assert [each for _, each in found] == pytest.approx([each for _, each in expected], rel=rel)


def test_two_masses_and_a_stop() -> None:
    # Published example of NLvib, rad/s. The fold 6e-9 below the first grazing is in no published list;
    # test_fold_beside_a_grazing.py finds it in another way.
    mechanism = Mechanism.from_toml(EXAMPLES / "two-mass-stop.toml")
    branch = follow(mechanism, "frequency", 0.85 / TURN, 0.5 / TURN, settings=ALONE)
    expected = [
        (SpecialKind.GRAZING, 0.6534401404),
        (SpecialKind.FOLD, 0.6534401345),
        (SpecialKind.FOLD, 0.7556273526),
        (SpecialKind.PERIOD_DOUBLING, 0.7555861594),
        (SpecialKind.PERIOD_DOUBLING, 0.7387830254),
        (SpecialKind.TORUS, 0.6186068743),
        (SpecialKind.TORUS, 0.5819006504),
        (SpecialKind.GRAZING, 0.5818996390),
    ]
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    assert_special(branch, expected, TURN, 1e-10)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "amplitude", "omega"), [("second", 0.936305681, 0.751184560), ("first", 1.3251998, 0.7542713)]
)
def test_resonance_of_two_masses(name: str, amplitude: float, omega: float) -> None:
    # Highest first harmonics of both masses, and where: a coarse branch, then a fine one around its top.
    mechanism = Mechanism.from_toml(EXAMPLES / "two-mass-stop.toml")
    coarse = follow(mechanism, "frequency", 0.85 / TURN, 0.6 / TURN, settings=ALONE)
    at = int(np.argmax([orbit.outputs[name].harmonics[0] for orbit in coarse.points]))
    before, after = coarse.points[at - 1], coarse.points[at + 1]
    fine = follow(
        mechanism, "frequency", before.value, after.value, periods=1, state=before.state, settings=ALONE
    )
    places = np.array([orbit.value for orbit in fine.points]) * TURN
    harmonics = [orbit.outputs[name].harmonics[0] for orbit in fine.points]
    curve = np.polynomial.Polynomial.fit(places, harmonics, 8)
    tops = [float(each.real) for each in curve.deriv().roots() if each.imag == 0.0]
    top = next(each for each in tops if places.min() < each < places.max())
    assert curve(top) == pytest.approx(amplitude, rel=2e-8)
    assert top == pytest.approx(omega, rel=1e-7)


def test_oscillator_with_a_stop() -> None:
    mechanism = Mechanism.from_toml(EXAMPLES / "oscillator-stop.toml")
    branch = follow(mechanism, "frequency", 5.0 / TURN, 12.0 / TURN, settings=ALONE)
    assert_special(branch, OSCILLATOR_WITH_STOP, TURN, 2e-10)
    fold = branch.special[3]
    course = branch.map.passage(fold.value, fold.state).course
    displacements = course.states(np.linspace(0.0, course.duration, 20_001))[:, 0]
    assert (displacements.min(), displacements.max()) == pytest.approx((-22.02946, 13.45651), rel=1e-6)


def dead_zone(omega: float) -> Mechanism:
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=omega / TURN,
        links={"damper": Link(("ground", "body"), damping=0.1)},
        plays={"zone": Play(("ground", "body"), 1.0, gap=2.0)},
        forces={"drive": Force("body", constant=0.1, unbalance=0.05, phase=math.pi / 2.0)},
        outputs={},
    )


def test_dead_zone() -> None:
    branch = follow(dead_zone(0.5), "frequency", 0.5 / TURN, 1.6 / TURN, settings=ALONE)
    assert_special(branch, DEAD_ZONE, TURN, 1e-10)


def twin(force: float = 1.0) -> Mechanism:
    mechanism = Mechanism.from_toml(EXAMPLES / "thesis-play.toml")
    return mechanism.with_value("frictions.blade.force", force)


def test_first_case_of_the_trimmer() -> None:
    branch = follow(twin(), "frequency", 110.0, "110.2 Hz", settings=FollowSettings(most_points=2))
    orbit = branch.points[0]
    assert orbit.periods == 1
    assert orbit.events_per_period == 14.0
    assert orbit.stable
    measure = orbit.outputs["stroke"]
    assert measure.peak_to_peak == pytest.approx(2.933334121400e-3, rel=1e-11)
    expected = [1.50471470358e-3, 1.14721349311e-4, 3.3929164589e-5]
    assert measure.harmonics[:5:2] == pytest.approx(expected, rel=1e-9)
    assert abs(measure.harmonics[1::2]).max() < 1e-14
    balanced = orbit.balanced(5), orbit.balanced(15)
    assert all(each.converged for each in balanced)
    # Dry friction jumps, so that the distance falls with the inverse of the number of harmonics only.
    assert balanced[1].distance < 0.5 * balanced[0].distance < 0.1


@pytest.mark.slow
def test_symmetry_breaking_of_the_trimmer() -> None:
    branch = follow(twin(), "frequency", 120.0, 122.0)
    kinds = [point.kind for point in branch.special]
    broken = [SpecialKind.SYMMETRY_BREAKING, SpecialKind.GRAZING, SpecialKind.SYMMETRY_BREAKING]
    assert kinds == broken
    (asymmetric,) = branch.branches
    assert asymmetric.reason is BranchEnd.REJOINED
    assert asymmetric.periods == 1
    even = [orbit.outputs["stroke"].harmonics[1] for orbit in asymmetric.points]
    assert max(even) > 1e-6
    outside = (branch.special[0].value, branch.special[2].value)
    assert all(orbit.stable == (not outside[0] < orbit.value < outside[1]) for orbit in branch.points)


@pytest.mark.slow
def test_corner_at_the_death_of_stick() -> None:
    # At this gap the branch turns around although no multiplier of it is near 1.
    branch = follow(twin(), "plays.bridge.gap", 1.6e-4, 1.7e-4, settings=ALONE, periods=1, state=_on(1.6e-4))
    corner = next(point for point in branch.special if point.note.startswith("a corner"))
    assert corner.kind is SpecialKind.FOLD
    assert corner.value == pytest.approx(1.68683524969e-4, rel=1e-9)
    assert corner.parts == ("blade",)


def _on(gap: float) -> np.ndarray:
    """Follow the branch from the stable orbit at 40 um."""
    branch = follow(twin(), "plays.bridge.gap", 4e-5, gap, settings=ALONE)
    return branch.points[-1].state


@pytest.mark.parametrize("factor", [1e-3, pytest.param(1e3, marks=pytest.mark.slow)])
def test_scaled_masses_and_forces_make_no_difference(factor: float) -> None:
    mechanism = Mechanism.from_toml(EXAMPLES / "two-mass-stop.toml")
    scaled = replace(
        mechanism,
        bodies={name: Body(factor * body.mass) for name, body in mechanism.bodies.items()},
        links={
            name: replace(link, stiffness=factor * link.stiffness, damping=factor * link.damping)
            for name, link in mechanism.links.items()
        },
        stops={
            name: replace(stop, stiffness=factor * stop.stiffness) for name, stop in mechanism.stops.items()
        },
        forces={
            name: replace(force, amplitude=factor * force.amplitude)
            for name, force in mechanism.forces.items()
        },
    )
    branches = [
        follow(each, "frequency", 0.85 / TURN, 0.6 / TURN, settings=ALONE) for each in (mechanism, scaled)
    ]
    assert len(branches[0].points) == len(branches[1].points)
    for one, other in zip(values(branches[0]), values(branches[1]), strict=True):
        assert one[0] is other[0]
        assert one[1] == pytest.approx(other[1], rel=1e-10)


def test_what_cannot_be_followed() -> None:
    mechanism = twin()
    with pytest.raises(MechanismError, match="gab"):
        follow(mechanism, "plays.bridge.gab", 0.0, 1.0)
    with pytest.raises(MechanismError, match="whole numbers"):
        follow(mechanism, "pins.pin.order", 1.0, 3.0)
    with pytest.raises(ValueError, match="interval"):
        follow(mechanism, "frequency", 110.0, 110.0)
    leaning = replace(mechanism, pins={"pin": replace(mechanism.pins["pin"], velocity=1.0)})
    with pytest.raises(UnsupportedMotionError, match="goes on for ever"):
        follow(leaning, "frequency", 110.0, 120.0)


def test_a_motion_that_does_not_settle_is_said() -> None:
    settings = FollowSettings(most_periods=200)
    branch = follow(twin(0.0), "frequency", 110.0, 120.0, settings=settings)
    assert branch.points == ()
    assert branch.reason is BranchEnd.NO_START
    assert "has not settled within 200 drive periods" in branch.message


def test_mirror_symmetry() -> None:
    mechanism = twin()
    assert is_mirror_symmetric(mechanism)
    assert not is_mirror_symmetric(replace(mechanism, forces={"weight": Force("motor", constant=1.0)}))
    assert not is_mirror_symmetric(mechanism.with_value("pins.pin.order", 2))
    assert not is_mirror_symmetric(mechanism.with_value("pins.pin.offset", 1e-6))
    assert not is_mirror_symmetric(replace(mechanism, stops={"stop": Stop(("ground", "motor"), 1.0)}))
    belt = replace(
        mechanism,
        pins={**mechanism.pins, "belt": Pin("ground", velocity=1.0)},
        frictions={**mechanism.frictions, "rubbing": Friction(("belt", "motor"), 0.1)},
    )
    assert not is_mirror_symmetric(belt)


def test_points_are_the_orbits_that_shooting_finds() -> None:
    branch = follow(twin(), "frequency", 112.0, 120.0, settings=ALONE)
    for orbit in branch.points[5::25]:
        mechanism = twin().with_value("frequency", orbit.value)
        bodies = len(mechanism.bodies)
        start = {
            name: (float(orbit.state[at]), float(orbit.state[bodies + at]))
            for at, name in enumerate(mechanism.bodies)
        }
        shot = forced_orbit(mechanism, guess=start)
        assert shot.success
        assert abs(shot.multipliers) == pytest.approx(abs(orbit.multipliers), rel=1e-6, abs=1e-9)


@pytest.mark.slow
def test_static_friction_that_gives_way_ends_the_branch() -> None:
    # Static friction above the kinetic one makes the motion jump where stick is lost.
    mechanism = Mechanism.from_toml(EXAMPLES / "foil-shaver.toml")
    branch = follow(mechanism, "frequency", 150.0, 152.0, settings=ALONE)
    assert branch.reason is BranchEnd.TORN
    assert branch.points[-1].value == pytest.approx(151.11742835, rel=1e-9)
    assert "static friction" in branch.message


def test_what_sticks_all_the_time_is_said() -> None:
    # The body is held by friction alone and never moves; it could do so anywhere.
    mechanism = Mechanism(
        bodies={"body": Body(1.0), "held": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "body"), 10.0, 1.0), "weak": Link(("body", "held"), 0.1)},
        frictions={"rubbing": Friction(("ground", "held"), 5.0)},
        forces={"drive": Force("body", constant=0.5, amplitude=1.0)},
    )
    branch = follow(mechanism, "frequency", 1.0, 1.2, settings=ALONE)
    assert branch.reason is BranchEnd.NOT_ISOLATED
    assert not branch.success
    assert "sticks all the time" in branch.message
