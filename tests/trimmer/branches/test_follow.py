"""Branches of mechanisms against published examples. Digits: two independent computations unless said."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.trimmer.branches.published import (
    ALONE,
    OSCILLATOR_WITH_STOP,
    TURN,
    dead_zone,
    oscillator_with_a_stop,
)
from trimmer import Body, FollowSettings, Force, Link, Mechanism, Play, SpecialKind, follow, forced_orbit
from trimmer.branches import BranchEnd, FollowedBranch

EXAMPLES = Path(__file__).parents[3] / "examples"
COARSE = FollowSettings(switches=0, quiet=True, largest_step=0.2)


def assert_special(
    branch: FollowedBranch, expected: list[tuple[SpecialKind, float]], unit: float, rel: float
) -> None:
    assert [point.kind for point in branch.special] == [kind for kind, _ in expected]
    found = [point.value * unit for point in branch.special]
    assert found == pytest.approx([each for _, each in expected], rel=rel)


@pytest.fixture(scope="module")
def two_masses() -> FollowedBranch:
    mechanism = Mechanism.from_toml(EXAMPLES / "two-mass-stop.toml")
    return follow(mechanism, "frequency", 0.85 / TURN, 0.5 / TURN, settings=ALONE)


@pytest.mark.slow
def test_two_masses_and_a_stop(two_masses: FollowedBranch) -> None:
    # Published example of NLvib, rad/s. The fold 6e-9 below the first grazing is in no published list; the
    # equations of a period with one contact, solved in 30 digits, have it there.
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
    assert two_masses.reason is BranchEnd.LEFT_AT_STOP
    assert two_masses.points[0].value == pytest.approx(0.85 / TURN, rel=1e-15)
    assert two_masses.points[-1].value == pytest.approx(0.5 / TURN, rel=1e-15)
    assert_special(two_masses, expected, TURN, 1e-10)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "amplitude", "omega"), [("second", 0.936305681, 0.751184560), ("first", 1.3251998, 0.7542713)]
)
def test_resonance_of_two_masses(
    two_masses: FollowedBranch, name: str, amplitude: float, omega: float
) -> None:
    # Highest first harmonics of both masses, and where: a coarse branch, then a fine one around its top.
    coarse, mechanism = two_masses, two_masses.map.mechanism
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
    branch = oscillator_with_a_stop()
    assert_special(branch, OSCILLATOR_WITH_STOP, TURN, 2e-10)
    fold = branch.special[3]
    course = branch.map.passage(fold.value, fold.state).course
    displacements = course.states(np.linspace(0.0, course.duration, 20_001))[:, 0]
    assert (displacements.min(), displacements.max()) == pytest.approx((-22.02946, 13.45651), rel=1e-6)


def twin(force: float = 1.0) -> Mechanism:
    mechanism = Mechanism.from_toml(EXAMPLES / "thesis-play.toml")
    return mechanism.with_value("frictions.blade.force", force)


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


def test_scaled_units_make_no_difference() -> None:
    """Grams, milliseconds and micrometres in place of kilograms, seconds and metres, over a force."""
    mass, time, length, mechanism = 1e-3, 1e-3, 1e-6, dead_zone(0.75)
    branch = follow(mechanism, "forces.drive.constant", 0.1, 0.06, settings=COARSE)
    # The motion grazes where the constant force leads it as far beyond the zone as it swings.
    swing = 0.05 * 0.75**2 / abs(1.0 - 0.75**2 + 0.075j)
    assert_special(branch, [(SpecialKind.GRAZING, swing)], 1.0, 1e-10)
    force = mass * length / time**2
    scaled = replace(
        mechanism,
        bodies={"body": Body(mass)},
        frequency=mechanism.frequency / time,  # type: ignore[operator]
        links={"damper": Link(("ground", "body"), damping=0.1 * mass / time)},
        plays={"zone": Play(("ground", "body"), mass / time**2, gap=2.0 * length)},
        forces={"drive": Force("body", 0.1 * force, unbalance=0.05 * mass * length, phase=math.pi / 2.0)},
    )
    other = follow(scaled, "forces.drive.constant", 0.1 * force, 0.06 * force, settings=COARSE)
    assert_special(other, [(SpecialKind.GRAZING, swing)], 1.0 / force, 1e-10)
    assert [abs(each.multipliers) for each in other.points[:: len(other.points) - 1]] == [
        pytest.approx(abs(each.multipliers), rel=1e-6) for each in branch.points[:: len(branch.points) - 1]
    ]


def test_points_are_the_orbits_that_shooting_finds() -> None:
    branch = follow(twin(), "frequency", 112.0, 112.5, settings=COARSE)
    for orbit in branch.points[:: len(branch.points) - 1]:
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


def test_a_friction_that_fades_away_leaves_the_linear_motion() -> None:
    oscillator = Mechanism.from_toml(EXAMPLES / "den-hartog.toml")
    end = follow(oscillator, "frictions.floor.force", 0.2, 0.0).points[-1]
    assert (end.value, end.outputs["block"].peak_to_peak) == pytest.approx((0.0, 2 / 0.51), rel=1e-9)
