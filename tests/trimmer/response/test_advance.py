"""Motions that repeat up to an advance along which no force changes: conveyors, shafts, what belts carry."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.dynamics import System
from tests.trimmer.response.mechanisms import body
from trimmer import FollowSettings, Mechanism, MotionKind, follow, forced_orbit, respond
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin, Play
from trimmer.response import MechanismOrbit
from trimmer.response.results.response_json import response_json


def conveyor(belt: float = 0.0, sign: float = 1.0, lengths: float = 1.0) -> Mechanism:
    """The vibratory conveyor; its base may be a belt, its forces negated, its lengths and forces scaled."""
    shift = 0.0 if sign > 0 else math.pi
    return Mechanism(
        {"plate": Body(2.0), "part": Body(0.1)},
        frequency=20.0,
        pins={"base": Pin("ground", velocity=belt)},
        links={"spring": Link(("base", "plate"), 20e3, 20.0)},
        frictions={"grip": Friction(("plate", "part"), 0.3 * lengths)},
        forces={
            "first": Force("plate", amplitude=200.0 * lengths, phase=shift),
            "second": Force("plate", amplitude=200.0 * lengths, order=2, phase=math.radians(60.0) + shift),
        },
        outputs={
            "part": Output({"part": 1}),
            "plate": Output({"plate": 1}),
            "slip": Output({"part": 1, "plate": -1}),
        },
    )


def settled(mechanism: Mechanism) -> MechanismOrbit:
    response = respond(mechanism)
    assert (response.kind, response.success) == (MotionKind.PERIODIC, True)
    assert response.motion.orbit is not None
    return response.motion.orbit


def advances(orbit: MechanismOrbit) -> dict[str, float]:
    return {name: each.advance for name, each in orbit.measures.outputs.items()}


def by_hand(orbit: MechanismOrbit, name: str, samples: int = 4001) -> tuple[float, np.ndarray]:
    """The advance of an output over a period, and the output without it, by an integrator of its own."""
    mechanism, period = orbit.mechanism, orbit.period
    motion = BruteForce(1e-11).run(System(mechanism), orbit.instant.state, 0.0, period)
    times = np.linspace(0.0, period, samples)
    states, bodies = motion.states(times), list(mechanism.bodies)
    weights = mechanism.outputs[name].weights
    signal = sum(weight * states[:, bodies.index(of)] for of, weight in weights.items())
    return float(signal[-1] - signal[0]), signal - (signal[-1] - signal[0]) * times / period


def test_the_conveyor_repeats_up_to_its_advance() -> None:
    response = respond(conveyor())
    content = response_json(response)
    assert (content["kind"], content["period_count"], content["success"]) == ("periodic", 1, True)
    assert content["outputs"]["part"]["advance"] == pytest.approx(19.11e-3, abs=5e-6)
    assert content["outputs"]["plate"]["advance"] == 0.0
    orbit = settled(conveyor())
    assert orbit.stable
    assert abs(np.array(content["multipliers"])[:, 0] - 1).min() == 0.0
    assert len(content["multipliers"]) == 4
    for name in ("part", "slip"):
        advance, left = by_hand(orbit, name)
        measured = content["outputs"][name]
        assert measured["advance"] == pytest.approx(advance, rel=1e-9)
        assert measured["peak_to_peak"] == pytest.approx(np.ptp(left), rel=1e-5)
        assert measured["mean"] == pytest.approx(np.mean(left[:-1]), abs=1e-5 * np.ptp(left))
        assert measured["rms"] == pytest.approx(np.std(left[:-1]), rel=1e-4)
        lines = abs(np.fft.rfft(left[:-1])) * 2 / (len(left) - 1)
        assert measured["harmonics"][:4] == pytest.approx(lines[1:5], abs=1e-6 * np.ptp(left))


def test_negated_forces_negate_the_advance_and_scaled_ones_scale_it() -> None:
    usual = settled(conveyor()).measures.outputs
    mirrored = settled(conveyor(sign=-1.0)).measures.outputs
    scaled = settled(conveyor(lengths=1e-4)).measures.outputs
    for name in ("part", "slip"):
        assert mirrored[name].advance == pytest.approx(-usual[name].advance, rel=1e-9)
        assert scaled[name].advance == pytest.approx(1e-4 * usual[name].advance, rel=1e-9)
        assert mirrored[name].peak_to_peak == pytest.approx(usual[name].peak_to_peak, rel=1e-9)
        assert scaled[name].peak_to_peak == pytest.approx(1e-4 * usual[name].peak_to_peak, rel=1e-9)


@pytest.mark.parametrize("belt", [0.3, -50.0])
def test_a_machine_that_rides_on_a_belt_does_the_same_beside_it(belt: float) -> None:
    standing, riding = settled(conveyor()), settled(conveyor(belt))
    carried = belt * standing.period
    for name, along in (("part", carried), ("plate", carried), ("slip", 0.0)):
        here, there = standing.measures.outputs[name], riding.measures.outputs[name]
        assert there.advance == pytest.approx(here.advance + along, rel=1e-9, abs=1e-12 * abs(belt))
        assert there.peak_to_peak == pytest.approx(here.peak_to_peak, rel=1e-8)
        assert there.harmonics == pytest.approx(here.harmonics, rel=1e-7, abs=1e-9 * here.peak_to_peak)
    assert np.sort_complex(riding.multipliers) == pytest.approx(
        np.sort_complex(standing.multipliers), abs=1e-9
    )


def pulled(static: float = 1.4, **parts: object) -> Mechanism:
    """A block on the floor, pulled along by a spring whose other end moves evenly."""
    return Mechanism(
        {"block": Body(1.0)},
        pins={"winch": Pin("ground", velocity=0.1)},
        links={"rope": Link(("winch", "block"), 40.0, 0.3)},
        frictions={"floor": Friction(("ground", "block"), 1.0, static=static)},
        outputs={"block": Output({"block": 1}), "winch": Output({"winch": 1})},
        **parts,
    )


def test_what_is_pulled_over_the_floor_sticks_and_slips_as_on_a_belt() -> None:
    belt = replace(
        pulled(),
        pins={"winch": Pin("ground", velocity=-0.1)},
        links={"rope": Link(("ground", "block"), 40.0, 0.3)},
        frictions={"floor": Friction(("winch", "block"), 1.0, static=1.4)},
    )
    on_floor, on_belt = settled(pulled()), settled(belt)
    assert on_floor.period == pytest.approx(on_belt.period, rel=1e-12)
    here, there = on_floor.measures.outputs["block"], on_belt.measures.outputs["block"]
    assert here.peak_to_peak == pytest.approx(there.peak_to_peak, rel=1e-10)
    assert (here.advance, there.advance) == (pytest.approx(0.1 * on_floor.period, rel=1e-12), 0.0)
    assert advances(on_floor)["winch"] == pytest.approx(0.1 * on_floor.period, rel=1e-12)


def test_a_constant_force_against_a_damper_advances_by_its_closed_form() -> None:
    mass, damping, force, frequency = 1.5, 4.0, 3.0, 2.0
    oil = {"oil": Link(("ground", "body"), 0.0, damping)}
    push = {"push": Force("body", constant=force, amplitude=2.0, order=3)}
    mechanism = body(
        mass, frequency=frequency, links=oil, forces=push, outputs={"body": Output({"body": -2.0})}
    )
    orbit = settled(mechanism)
    assert advances(orbit)["body"] == pytest.approx(-2 * force / damping / frequency, rel=1e-12)
    slow = math.exp(-damping / mass / frequency)
    assert np.sort(orbit.multipliers.real) == pytest.approx([slow, 1.0], rel=1e-12)
    assert orbit.stable
    omega = 3 * 2 * math.pi * frequency
    swing = 2 * 2 * 2.0 / (omega * math.hypot(mass * omega, damping))
    assert orbit.measures.outputs["body"].peak_to_peak == pytest.approx(swing, rel=1e-10)


def test_a_shaft_of_two_bodies_turns_on_as_one_and_twists_as_if_held() -> None:
    masses, stiffness, damping, force, frequency = (1.0, 2.0), 300.0, 4.0, 3.0, 2.0
    shaft = Mechanism(
        {"first": Body(masses[0]), "second": Body(masses[1])},
        frequency=frequency,
        links={
            "shaft": Link(("first", "second"), stiffness, 1.0),
            "oil": Link(("ground", "second"), 0.0, damping),
        },
        forces={
            "push": Force("first", constant=force, amplitude=5.0),
            "back": Force("second", amplitude=-5.0),
        },
        outputs={"first": Output({"first": 1}), "twist": Output({"first": 1, "second": -1})},
    )
    orbit = settled(shaft)
    outputs = orbit.measures.outputs
    assert outputs["first"].advance == pytest.approx(force / damping / frequency, rel=1e-11)
    assert outputs["twist"].advance == pytest.approx(0.0, abs=1e-15)
    assert outputs["twist"].mean == pytest.approx(force / stiffness, rel=1e-10)
    omega = 2 * math.pi * frequency
    dynamic = np.array(
        [
            [stiffness + 1j * omega - masses[0] * omega**2, -stiffness - 1j * omega],
            [-stiffness - 1j * omega, stiffness + 1j * omega * (1 + damping) - masses[1] * omega**2],
        ]
    )
    first, second = np.linalg.solve(dynamic, [5.0, -5.0])
    assert outputs["twist"].harmonics[0] == pytest.approx(abs(first - second), rel=1e-10)
    assert outputs["first"].harmonics[0] == pytest.approx(abs(first), rel=1e-10)
    assert orbit.stable


def test_several_directions_at_once_are_each_as_if_alone() -> None:
    """Beside the conveyor a shaft turns; a chip lies on the part, and lies still or is carried along."""
    base = conveyor()
    machine = replace(
        base,
        bodies={**base.bodies, "shaft": Body(1.5), "chip": Body(0.01)},
        links={**base.links, "oil": Link(("ground", "shaft"), 0.0, 4.0)},
        frictions={**base.frictions, "chip": Friction(("part", "chip"), 10.0)},
        forces={**base.forces, "turn": Force("shaft", constant=3.0, amplitude=2.0)},
        outputs={**base.outputs, "shaft": Output({"shaft": 1}), "chip": Output({"chip": 1})},
    )
    orbit = settled(machine)
    assert int((orbit.multipliers == 1).sum()) == 3
    assert orbit.stable
    found = advances(orbit)
    for output, advance in advances(settled(base.with_value("bodies.part.mass", 0.11))).items():
        assert found[output] == pytest.approx(advance, rel=1e-9, abs=1e-15)
    assert found["shaft"] == pytest.approx(3.0 / 4.0 / 20.0, rel=1e-9)
    assert found["chip"] == pytest.approx(found["part"], rel=1e-12)


def test_a_gap_does_not_free_a_body_and_what_is_joined_by_play_advances_together() -> None:
    base = conveyor()
    joined = replace(
        base,
        bodies={**base.bodies, "trailer": Body(0.05)},
        plays={"hook": Play(("part", "trailer"), 500.0, 2.0, 1e-4)},
        frictions={**base.frictions, "trail": Friction(("ground", "trailer"), 0.05)},
        outputs={**base.outputs, "trailer": Output({"trailer": 1})},
    )
    orbit = settled(joined)
    assert int((orbit.multipliers == 1).sum()) == 1
    found = advances(orbit)
    assert found["trailer"] == pytest.approx(found["part"], rel=1e-12)
    assert found["trailer"] == pytest.approx(by_hand(orbit, "trailer", 3)[0], rel=1e-8)
    held = replace(joined, plays={**joined.plays, "tether": Play(("ground", "trailer"), 500.0, 2.0, 1e-4)})
    assert not (forced_orbit(held, guess={}).multipliers == 1).any()


COARSE = FollowSettings(quiet=True, largest_step=0.2)


def test_a_branch_of_advancing_orbits_is_followed() -> None:
    branch = follow(conveyor(), "forces.second.amplitude", 200.0, 150.0, settings=COARSE)
    assert branch.success
    assert len(branch.points) > 2
    for point in (branch.points[0], branch.points[len(branch.points) // 2], branch.points[-1]):
        orbit = settled(conveyor().with_value("forces.second.amplitude", point.value))
        measured = orbit.measures.outputs["part"]
        assert point.outputs["part"].advance == pytest.approx(measured.advance, rel=1e-8)
        assert point.outputs["part"].peak_to_peak == pytest.approx(measured.peak_to_peak, rel=1e-8)
        assert point.stable is orbit.stable
        assert abs(point.multipliers) == pytest.approx(abs(orbit.multipliers), abs=1e-7)


def test_a_branch_of_a_block_that_is_pulled_has_its_period_as_an_unknown() -> None:
    branch = follow(pulled(), "pins.winch.velocity", 0.1, 0.105, settings=COARSE)
    assert branch.success
    last = branch.points[-1]
    found = settled(pulled().with_value("pins.winch.velocity", last.value))
    assert last.period == pytest.approx(found.period, rel=1e-9)
    assert last.outputs["block"].advance == pytest.approx(last.value * last.period, rel=1e-12)
