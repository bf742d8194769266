"""Points and rotations move as levers and gears do: laws, closed forms, and digits found elsewhere."""

import math

import numpy as np
import pytest

from tests.mechanisms.random_mechanisms import levered, random_mechanism, turned
from tests.quick import quick
from tests.trimmer.contact.test_against_brute_force import compare
from trimmer import Mechanism, forced_orbit, respond, simulate
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin, Play, Point, Stop, linear_matrices


def test_a_lever_multiplies_stiffness_and_damping_by_the_square_of_its_arm() -> None:
    """J theta'' + c r² theta' + k r² theta = M cos: the closed form."""
    inertia, r, k, c, moment, frequency = 3e-4, 0.06, 900.0, 0.8, 0.02, 11.0
    lever = Mechanism(
        {"arm": Body(inertia=inertia)},
        frequency,
        points={"tip": Point({"arm": r}, by_length=True)},
        links={"spring": Link(("ground", "tip"), k, c)},
        forces={"moment": Force("arm", amplitude=moment)},
        outputs={"angle": Output({"arm": 1.0}), "tip": Output({"tip": 1.0})},
    )
    w = math.tau * frequency
    amplitude = moment / abs(complex(k * r * r - inertia * w * w, c * r * r * w))
    measures = forced_orbit(lever).measures.outputs
    assert measures["angle"].peak_to_peak == pytest.approx(2 * amplitude, rel=1e-13)
    assert measures["tip"].peak_to_peak == pytest.approx(2 * r * amplitude, rel=1e-13)


def test_a_gear_pair_without_backlash_is_one_axis() -> None:
    """With a stiff mesh the inertias add as J_1 + n² J_2; the ratio is that of a rigid gear to J / k."""
    first, second, ratio, shaft, mesh = 4e-4, 9e-4, -1.7, 30.0, 1e9
    pair = Mechanism(
        {"a": Body(inertia=first), "b": Body(inertia=second)},
        points={"driven": Point({"a": ratio})},
        links={"shaft": Link(("ground", "a"), shaft), "mesh": Link(("driven", "b"), mesh)},
    )
    matrices = linear_matrices(pair)
    squares = np.linalg.eigvals(np.linalg.solve(matrices.mass, matrices.stiffness))
    assert squares.min() == pytest.approx(shaft / (first + ratio**2 * second), rel=1e-6)


def test_power_is_kept_by_points_with_every_part_on_them() -> None:
    """Pins, forces, frictions, contacts and links on levers: what goes in is stored or lost."""
    mechanism = Mechanism(
        {"arm": Body(inertia=2e-3), "a": Body(0.3), "b": Body(0.2)},
        25.0,
        points={"tip": Point({"arm": 0.1, "a": 1.0}), "mid": Point({"a": 0.5, "b": 0.5})},
        pins={"eccentric": Pin("tip", 1e-3, order=2), "base": Pin("ground", 2e-3)},
        links={
            "twist": Link(("ground", "arm"), 60.0, 0.02),
            "rod": Link(("eccentric", "b"), 4e3, 2.0),
            "foot": Link(("base", "a"), 8e3, 3.0),
        },
        plays={"slot": Play(("mid", "tip"), 2e4, 5.0, 2e-4)},
        stops={"end": Stop(("ground", "mid"), 3e4, 4.0, 1e-4)},
        frictions={
            "rub": Friction(("base", "mid"), 1.5, 2.0, 0.3),
            "drag": Friction(("ground", "arm"), 0.05),
        },
        forces={"push": Force("mid", 1.0, 12.0), "moment": Force("arm", amplitude=0.8)},
    )
    energy = simulate(mechanism, 0.3).energy
    assert energy.residual < 1e-12
    assert all(energy.pins.values()) and all(energy.frictions.values()) and all(energy.contacts.values())


def test_a_gear_that_is_carried_on_advances_by_its_ratio() -> None:
    gears = Mechanism(
        {"shaft": Body(inertia=1e-3), "gear": Body(inertia=2e-3)},
        20.0,
        pins={"engine": Pin("ground", velocity=50.0, amplitude=0.01)},
        points={"pinion": Point({"shaft": -2.5})},
        links={"coupling": Link(("engine", "shaft"), 200.0, 0.1), "mesh": Link(("pinion", "gear"), 5e3, 0.5)},
        frictions={"drag": Friction(("ground", "gear"), 0.2)},
        outputs={"shaft": Output({"shaft": 1.0}), "gear": Output({"gear": 1.0})},
    )
    response = respond(gears)
    assert (response.motion.kind.word, response.period_count) == ("periodic", 1)
    turn = 50.0 / 20.0
    assert response.motion.advance == pytest.approx({"shaft": turn, "gear": -2.5 * turn}, rel=1e-12)


@pytest.mark.parametrize("seed", quick((11, 60, 174, *range(1, 120, 4)), 0))
def test_random_levers_against_brute_force(seed: int) -> None:
    compare(levered(random_mechanism(seed), seed), 3, known=0.5 * (seed in (11, 60, 174)))


@pytest.mark.parametrize("seed", quick(range(40), 3))
def test_bodies_that_turn_at_an_arm_move_as_masses_do(seed: int) -> None:
    """Each body of a random mechanism becomes one that turns at an arm of its own, its ends points on it."""
    mechanism = random_mechanism(seed)
    arms = np.exp(np.random.default_rng(seed).normal(0.0, 2.0, len(mechanism.bodies)))
    duration = 1 / mechanism.frequency
    plain, turns = (simulate(each, duration) for each in (mechanism, turned(mechanism, arms)))
    assert [(e.kind, e.part) for e in plain.events] == [(e.kind, e.part) for e in turns.events]
    times = np.linspace(0, duration, 50)
    for name, arm in zip(mechanism.bodies, arms, strict=True):
        expected = plain.displacement(name, times)
        size = max(abs(plain.displacement(each, times)).max() for each in mechanism.bodies)
        np.testing.assert_allclose(arm * turns.displacement(name, times), expected, rtol=0, atol=1e-9 * size)
