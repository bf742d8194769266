"""Branches of motions without a drive: against closed forms, and against brute force by SciPy."""

import math
from pathlib import Path

import control
import numpy as np
import pytest
from scipy.optimize import brentq

from tests.mechanisms.brute_force import BruteForce, extend, settle
from tests.mechanisms.decision import Judge
from tests.mechanisms.dynamics import System
from tests.quick import quick
from tests.trimmer.branches.published import two_blocks
from trimmer import (
    Feedback,
    FollowedBranch,
    FollowSettings,
    SpecialKind,
    follow,
    limit_cycles,
    periodic_orbits,
    respond,
)
from trimmer.branches import BranchEnd
from trimmer.elements import CoulombFriction, FrictionBacklash
from trimmer.linear import InputChannels, pin_model
from trimmer.loops import BodyFriction, TrimmerLoop
from trimmer.mechanism import Mechanism
from trimmer.thesis import TrimmerParameters

EXAMPLES = Path(__file__).parents[3] / "examples"
SPEED = "pins.belt.velocity"
ALONE = FollowSettings(switches=0, quiet=True, largest_step=0.02)
COARSE = FollowSettings(quiet=True, largest_step=0.1)


def block() -> Mechanism:
    return Mechanism.from_toml(EXAMPLES / "block-on-belt.toml")


@pytest.fixture(scope="module")
def blocks() -> FollowedBranch:
    """From a stable motion to an unstable one; from rest they settle to another."""
    stable = [0.549, 0.543, -0.954, -0.952, 6.44]
    return follow(two_blocks(0.8), SPEED, 0.8, 0.68, state=stable, settings=COARSE)


def period(speed: float, mass: float = 1.0, stiffness: float = 1.0, drop: float = 0.5) -> float:
    """Period of the block: half a turn and more of free vibration, then the belt carries it back."""
    omega = math.sqrt(stiffness / mass)
    slip = 2.0 * (math.pi - math.atan(drop * omega / (stiffness * speed))) / omega
    return slip + 2.0 * drop / (stiffness * speed)


def test_period_and_width_over_the_speed_of_the_belt() -> None:
    branch = follow(block(), SPEED, 0.05, 3.0, settings=COARSE)
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    assert branch.special == ()
    for orbit in branch.points:
        assert orbit.period == pytest.approx(period(orbit.value), rel=1e-11)
        measure = orbit.outputs["block"]
        assert measure.peak_to_peak == pytest.approx(2.0 * math.hypot(0.5, orbit.value), rel=1e-11)
        assert measure.harmonics[0] > measure.harmonics[1] > 0.0
        assert orbit.stable
        assert sorted(abs(orbit.multipliers)) == pytest.approx([0.0, 1.0], abs=1e-12)
        assert orbit.events_per_period == 2.0


@pytest.mark.parametrize(
    ("place", "stop", "expected"),
    [
        ("bodies.block.mass", 4.0, lambda value: period(0.2, mass=value)),
        ("links.spring.stiffness", 3.0, lambda value: period(0.2, stiffness=value)),
        ("frictions.rubbing.static", 1.9, lambda value: period(0.2, drop=value - 0.5)),
    ],
)
def test_period_over_other_numbers(place: str, stop: float, expected: object) -> None:
    branch = follow(block(), place, 1.0, stop, settings=COARSE)
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    found = [orbit.period for orbit in branch.points]
    assert found == pytest.approx([expected(orbit.value) for orbit in branch.points], rel=1e-11)  # type: ignore[operator]


def fastest(speed: float, damping: float) -> float:
    """Highest velocity that the damped block has again after it has begun to slip at that of the belt."""
    decay = 0.5 * damping
    omega = math.sqrt(1.0 - decay**2)
    start, rate = 0.5 - damping * speed, speed
    # y = exp(-decay t) (start cos + c sin); the acceleration -y - damping y' is zero again after one turn.
    c = (rate + decay * start) / omega

    def motion(time: float) -> tuple[float, float]:
        shrunk = math.exp(-decay * time)
        y = shrunk * (start * math.cos(omega * time) + c * math.sin(omega * time))
        ahead = shrunk * omega * (c * math.cos(omega * time) - start * math.sin(omega * time))
        return y, ahead - decay * y

    def acceleration(time: float) -> float:
        y, velocity = motion(time)
        return -y - damping * velocity

    top = brentq(acceleration, 1.1 * math.pi / omega, 2.2 * math.pi / omega, xtol=1e-14)
    return motion(top)[1]


def test_the_branch_ends_where_the_damped_block_does_not_reach_the_belt_again() -> None:
    damped = block().with_value("links.spring.damping", 0.1)
    branch = follow(damped, SPEED, 0.3, 1.0, settings=COARSE)
    assert branch.reason is BranchEnd.TORN
    last = brentq(lambda speed: fastest(speed, 0.1) - speed, 0.4, 0.8, xtol=1e-15)
    assert branch.points[-1].value == pytest.approx(last, rel=1e-8)
    (lost,) = branch.special
    assert (lost.kind, lost.value) == (SpecialKind.STICK, branch.points[-1].value)
    assert lost.note.endswith(": stick, -1; no orbit lies beyond")


def brute_multipliers(mechanism: Mechanism, state: np.ndarray, duration: float) -> np.ndarray:
    """Return the eigenvalues of the derivative over a period, by differences of brute-force motions."""
    force, system = BruteForce(), System(mechanism)
    mode = Judge(system).decide(extend(system, state, 0.0)).mode
    step, columns = 1e-6, []
    for place in range(len(state)):
        ends = []
        for sign in (1.0, -1.0):
            moved = state.copy()
            moved[place] += sign * step
            ends.append(force.run(system, settle(system, mode, moved, 0.0), 0.0, duration).final)
        columns.append((ends[0] - ends[1]) / (2.0 * step))
    values = np.linalg.eigvals(np.array(columns).T)
    return values[np.argsort(-abs(values))]


@pytest.mark.slow
def test_period_doublings_of_two_blocks_against_brute_force() -> None:
    blocks = follow(two_blocks(0.1), SPEED, 0.1, 0.8, settings=ALONE)
    doublings = [each for each in blocks.special if each.kind is SpecialKind.PERIOD_DOUBLING]
    assert [each.value for each in doublings] == pytest.approx([0.131882753578, 0.697486236508], rel=1e-9)
    assert len(doublings) == len(blocks.special)
    for special in doublings:
        mechanism = two_blocks(special.value)
        found = brute_multipliers(mechanism, special.state[:-1], float(special.state[-1]))
        assert sorted(found[:2].real) == pytest.approx([-1.0, 1.0], abs=1e-5)
        assert abs(found[2:]).max() < 1e-5


@pytest.mark.slow
def test_doubled_periods_part_and_join_again(blocks: FollowedBranch) -> None:
    doubled = blocks.branches[-1]
    assert doubled.parted is blocks.special[-1]
    assert doubled.periods == 2
    orbit = doubled.points[10]
    assert orbit.period == pytest.approx(2.0 * orbit.state[-1], rel=1e-15)
    # The same orbit alone, with its whole period, leads back to where it parted.
    state = np.append(orbit.state[:-1], orbit.period)
    again = follow(two_blocks(orbit.value), SPEED, orbit.value, 0.72, state=state, settings=COARSE)
    assert again.reason is BranchEnd.REJOINED
    assert again.special[-1].value == pytest.approx(blocks.special[-1].value, rel=1e-11)
    assert again.branches[0].points[-1].period == pytest.approx(0.5 * again.points[-1].period, rel=1e-2)


def test_respond_does_not_settle_to_an_unstable_motion() -> None:
    # At this speed the simple motion is unstable, but what passes it comes near to it at first.
    response = respond(two_blocks(0.15))
    assert response.motion.orbit is not None
    assert response.motion.orbit.stable
    assert len(response.motion.orbit.course.events) == 8


def test_an_orbit_that_begins_on_its_plane_is_told_from_the_next() -> None:
    """Rounding puts the first state of this one on the other side of the plane through it."""
    gap, parameters, channels = 200e-6, TrimmerParameters.thesis(), InputChannels.DISPLACEMENT_ONLY
    system, small = pin_model(parameters, channels=channels), FrictionBacklash(gap / 5)
    orbit, _ = periodic_orbits(system, small, limit_cycles(system, small)[::-1])
    rubbing = BodyFriction("q2-q4", CoulombFriction(0.6))
    loop = TrimmerLoop(parameters, FrictionBacklash(gap), channels=channels, frictions=(rubbing,))
    state = [*5 * orbit.motion.state(0.0), 5 * float(orbit.motion.element_output(0.0)), orbit.period]
    settings = FollowSettings(most_points=4, quiet=True, largest_step=0.05)
    branch = follow(loop, "element.gap", gap, 10e-6, state=state, settings=settings)
    assert branch.reason is BranchEnd.MOST_POINTS
    assert np.all(np.diff([point.value for point in branch.points]) < 0)


LIMITED = """
[bodies]
motor = {{ mass = 1.0 }}
[plays]
gear = {{ between = ["ground", "motor"], stiffness = {stiffness}, gap = 0.2 }}
[links]
drag = {{ between = ["ground", "motor"], damping = 1.0 }}
[outputs]
x = {{ motor = 1 }}
[controllers.axis]
kind = "transfer"
measure = "x"
reference = "path"
acts = ["ground", "motor"]
numerator = [8.0]
denominator = [1.0, 2.0]
limit = 1.0
[references]
path = {{ step = 1.0 }}
"""


@pytest.mark.slow
def test_a_gap_and_a_friction_are_followed_alike() -> None:
    """Only their ratio counts. A play that is stuck leaves its side in the instant at which the pin slips."""
    plant = control.ss(
        [[0, 1, 0], [0, -0.3, 1], [0, 0, -2]],
        [[0, 0], [0, -1], [-4, 0]],
        [[1, 0, 0], [0, 1, 0]],
        0,
        inputs=["play", "rub"],
        outputs=["play", "rub"],
    )
    loop = Feedback(plant, {"play": FrictionBacklash(0.2), "rub": CoulombFriction(0.05)})
    wider, rougher = (
        follow(loop, "elements.play.gap", 0.2, 0.1),
        follow(loop, "elements.rub.force", 0.05, 0.1),
    )
    assert wider.reason is rougher.reason is BranchEnd.LEFT_AT_STOP
    assert wider.points[-1].period == pytest.approx(rougher.points[-1].period, rel=1e-9)
    assert 0.2 / wider.special[0].value == pytest.approx(rougher.special[0].value / 0.05, rel=1e-9)


@pytest.mark.parametrize("stiffness", quick([0.3, 0.05], 0))
def test_hunting_begins_where_the_linear_loop_loses_its_stability(stiffness: float) -> None:
    """Routh: (s^2 + s + k)(s + 2) + K has the roots +-i sqrt(2 + k) at K + 2 k = 3 (2 + k)."""
    machine = Mechanism.from_toml_text(LIMITED.format(stiffness=stiffness))
    branch = follow(machine, "controllers.axis.numerator.1", 8.0, 3.0)
    last = branch.points[-1]
    assert branch.reason is BranchEnd.HOPF and branch.success
    assert last.value == pytest.approx(3.0 * (2.0 + stiffness) - 2.0 * stiffness, rel=1e-9)
    assert last.period == pytest.approx(2.0 * np.pi / np.sqrt(2.0 + stiffness), rel=1e-9)
    assert "loses its stability there (Hopf)" in branch.message


def test_impacts_alone_are_no_loss_of_stability() -> None:
    """A control shakes a body against a rigid wall: one linear mode is met, and yet the size is decided."""
    text = """
        title = "Shaken against a wall"
        bodies = { m = { mass = 1.0 } }
        links = { k = { between = ["ground", "m"], stiffness = 1.0 } }
        walls = { w = { between = ["ground", "m"], gap = 1.0, restitution = 0.6 } }
        outputs = { x = { m = 1 } }
        references = { r = { step = 0.2 } }
        [controllers.c]
        kind = "pid"
        acts = ["ground", "m"]
        measure = "x"
        reference = "r"
        kp = -0.05
        ki = 0.0
        kd = -0.3
        filter_time = 0.01
    """
    shaken = Mechanism.from_toml_text(text)
    branch = follow(shaken, "walls.w.restitution", 0.6, 0.58)
    assert branch.reason is BranchEnd.LEFT_AT_STOP
    settled = respond(shaken.with_value("walls.w.restitution", 0.58)).motion.orbit
    assert branch.points[-1].period == pytest.approx(settled.period, rel=1e-9)
