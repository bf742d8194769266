"""Measures and energies of an orbit with one of each part, against dense samples."""

import math
from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.response.mechanisms import body as one_body
from tests.trimmer.response.mechanisms import example
from trimmer import ContactLaw, Mechanism, MechanismMotion, forced_orbit, respond, simulate
from trimmer.mechanism import Body, Force, Friction, Link, Output, Pin, Play, Stop
from trimmer.response import MechanismOrbit
from trimmer.response.results.response_json import response_json

FREQUENCY = 7.0
OMEGA = 2 * math.pi * FREQUENCY
PERIODS = 2
COUNT = 40_000
MACHINE = Mechanism(
    {"sled": Body(0.5), "block": Body(2.0)},
    frequency=FREQUENCY,
    pins={"crank": Pin("sled", amplitude=0.02, phase=0.4), "wall": Pin("ground", offset=0.01)},
    links={
        "spring": Link(("ground", "sled"), 900.0, 3.0),
        "strut": Link(("sled", "block"), 1500.0, 2.0),
        "rod": Link(("crank", "block"), 400.0, 1.0),
    },
    plays={"slot": Play(("crank", "block"), 6000.0, 4.0, 0.01, law=ContactLaw.RELAXING)},
    stops={"end": Stop(("wall", "sled"), 3000.0, 5.0, -0.002, law=ContactLaw.PULLING)},
    frictions={
        "floor": Friction(("ground", "sled"), 1.5, viscous=0.7),
        "face": Friction(("sled", "block"), 14.0, static=17.0),
    },
    forces={
        "push": Force("block", constant=2.0, amplitude=25.0, phase=1.1, order=2),
        "wheel": Force("sled", unbalance=3e-3, phase=-0.6),
    },
    outputs={"block": Output({"block": 1.0}), "travel": Output({"block": 2.0, "crank": -1.0})},
)


@pytest.fixture(scope="module")
def orbit() -> MechanismOrbit:
    """It repeats after two drive periods, with play, a stop and stick in them."""
    found = respond(MACHINE).motion.orbit
    assert found.period_count == PERIODS
    return found


@pytest.fixture(scope="module")
def motion(orbit) -> MechanismMotion:
    return simulate(MACHINE, orbit.period, state=orbit.instant.state)


@pytest.fixture(scope="module")
def times(motion) -> np.ndarray:
    """Middles of equal parts of the motion."""
    return motion.duration * (np.arange(COUNT) + 0.5) / COUNT


def mean(values: np.ndarray) -> float:
    return float(values.mean())


def test_each_part_does_the_work_that_its_force_does(motion, times) -> None:
    energy, duration = motion.energy, motion.duration
    ends = ("ground", "sled", "block", "crank", "wall")
    place = {end: motion.displacement(end, times) for end in ends}
    speed = {end: motion.velocity(end, times) for end in ends}

    def rate(start: str, end: str) -> np.ndarray:
        return speed[end] - speed[start]

    for name, link in MACHINE.links.items():
        lost = duration * link.damping * mean(rate(*link.between) ** 2)
        assert energy.dampers[name] == pytest.approx(lost, rel=1e-5)
    floor, face = (motion.friction_force(name, times) for name in ("floor", "face"))
    lost = duration * mean((floor + 0.7 * rate("ground", "sled")) * rate("ground", "sled"))
    assert energy.frictions["floor"] == pytest.approx(lost, rel=1e-4)
    assert energy.frictions["face"] == pytest.approx(duration * mean(face * rate("sled", "block")), rel=1e-4)
    push = 2.0 + 25.0 * np.sin(2 * OMEGA * times + 1.1)
    wheel = 3e-3 * OMEGA**2 * np.sin(OMEGA * times - 0.6)
    assert energy.forces["push"] == pytest.approx(duration * mean(push * speed["block"]), rel=1e-5)
    assert energy.forces["wheel"] == pytest.approx(duration * mean(wheel * speed["sled"]), rel=1e-5)
    rod = 400.0 * (place["block"] - place["crank"]) + 1.0 * rate("crank", "block")
    pull = -(rod + motion.contact_force("slot", times))
    assert energy.pins["crank"] == pytest.approx(duration * mean(pull * rate("sled", "crank")), rel=1e-4)
    assert energy.pins["wall"] == 0.0
    assert energy.residual < 1e-11
    assert energy.work == pytest.approx(energy.loss, rel=1e-9)
    assert min(energy.contacts.values()) > 0


def test_an_energy_balance_is_a_table_and_a_sentence(motion) -> None:
    energy = motion.energy
    frame = energy.to_dataframe()
    values = dict(zip(frame.iloc[:, 0], frame.iloc[:, 1], strict=True))
    assert list(values)[:4] == ["kinetic, start", "kinetic, end", "stored, start", "stored, end"]
    assert (values["kinetic, start"], values["stored, end"]) == (energy.kinetic[0], energy.stored[1])
    kinetic = 0.25 * motion.velocity("sled", 0.0) ** 2 + motion.velocity("block", 0.0) ** 2
    assert energy.kinetic[0] == pytest.approx(float(kinetic), rel=1e-9)
    for section in ("pins", "forces", "dampers", "contacts", "frictions"):
        for name, value in getattr(energy, section).items():
            assert values[f"{section}.{name}"] == value
    assert repr(energy).startswith(f"<MechanismEnergy: work {energy.work:.6g} J, loss {energy.loss:.6g} J")


def test_outputs_have_the_sums_and_lines_of_samples(orbit, motion, times) -> None:
    for name in ("block", "travel"):
        values, found = motion.output(name, times), orbit.measures.outputs[name]
        assert found.mean == pytest.approx(mean(values), rel=1e-6)
        assert found.rms == pytest.approx(float(values.std()), rel=1e-6)
        assert (found.smallest, found.largest) == pytest.approx((values.min(), values.max()), rel=1e-5)
        assert found.peak_to_peak == found.largest - found.smallest
        lines = [
            2 * complex(np.mean((values - values.mean()) * np.exp(-1j * p / PERIODS * OMEGA * times)))
            for p in range(1, 5)
        ]
        np.testing.assert_allclose(found.amplitudes[:4], lines, atol=1e-6 * abs(lines[1]))
        assert len(found.harmonics) == 20
        assert found.harmonics[:2] == pytest.approx([abs(lines[1]), abs(lines[3])], rel=1e-5)
        assert found.phases[:2] == pytest.approx([np.angle(lines[1]), np.angle(lines[3])], abs=1e-4)
        sizes = abs(found.amplitudes)
        assert found.subharmonics.tolist() == sizes[: 2 * 20 : 2].tolist()[: len(found.subharmonics)]
        assert found.lines[:3] == [(1, 2, sizes[0]), (2, 2, sizes[1]), (3, 2, sizes[2])]
    frame = orbit.to_dataframe()
    assert frame["frequency"].tolist()[:2] == pytest.approx([FREQUENCY, 2 * FREQUENCY])
    assert frame["outputs.block"].tolist() == list(orbit.measures.outputs["block"].harmonics)


def test_bodies_and_contacts_do_what_samples_do(orbit, motion, times) -> None:
    step, measures = motion.duration / COUNT, orbit.measures
    for body in ("sled", "block"):
        edges = np.append(times - step / 2, motion.duration)
        accelerations = np.diff(motion.velocity(body, np.maximum(edges, 0.0))) / step
        assert measures.rms_acceleration[body] == pytest.approx(math.sqrt(mean(accelerations**2)), rel=2e-3)
    for name, (start, end) in (("slot", ("crank", "block")), ("end", ("wall", "sled"))):
        force, found = motion.contact_force(name, times), measures.contacts[name]
        assert found.largest_force == pytest.approx(abs(force).max(), rel=5e-3)
        assert found.share == pytest.approx(mean(force != 0), abs=2e-3)
        made = [each.time for each in motion.events if each.part == name and each.kind.word == "contact-made"]
        assert found.impacts == len(made) / PERIODS > 0
        speeds = [abs(motion.velocity(end, t) - motion.velocity(start, t)) for t in made]
        assert sorted(found.impact_speeds) == pytest.approx(sorted(speeds), rel=1e-8)
        assert found.impact_speed == max(found.impact_speeds)


def test_frictions_lose_and_stick_as_samples_do(orbit, motion, times) -> None:
    for name, (start, end) in (("floor", ("ground", "sled")), ("face", ("sled", "block"))):
        rate = motion.velocity(end, times) - motion.velocity(start, times)
        found, force = orbit.measures.frictions[name], MACHINE.frictions[name].force
        lost = force * mean(abs(rate))
        assert found.power == pytest.approx(lost, rel=1e-4)
        assert found.work == pytest.approx(lost * motion.duration / PERIODS, rel=1e-4)
        assert found.stick == pytest.approx(mean(abs(rate) < 1e-12), abs=2e-3)
    assert orbit.measures.frictions["face"].stick > 0.05
    assert orbit.events_per_period == len(motion.events) / PERIODS


def test_json_and_table_hold_what_no_key_of_a_measure_names(orbit) -> None:
    response = respond(MACHINE)
    content, measures = response_json(response), response.motion.orbit.measures
    assert content["multipliers"] == [[each.real, each.imag] for each in response.motion.orbit.multipliers]
    assert (content["period"], content["events_per_period"]) == (orbit.period, orbit.events_per_period)
    for name, each in measures.outputs.items():
        told = content["outputs"][name]
        assert (told["rms_interval"], told["subharmonics"]) == ([each.rms] * 2, list(each.subharmonics))
    slot = measures.contacts["slot"]
    assert content["contacts"]["slot"]["impact_speeds"] == list(slot.impact_speeds)
    sled = measures.rms_acceleration["sled"]
    assert content["bodies"]["sled"] == {"rms_acceleration": sled, "rms_acceleration_interval": [sled, sled]}
    largest = abs(orbit.multipliers).max()
    assert content["lyapunov"]["value"] == pytest.approx(math.log(largest) / PERIODS, rel=1e-9)
    assert content["lyapunov"]["uncertainty"] == 0.0
    assert (content["spectrum"], content["window_periods"]) == (None, None)
    row = response.to_dataframe().iloc[0].to_dict()
    assert (row["kind"], row["period_count"], row["share"]) == ("periodic", 2, 1.0)
    assert row["outputs.block.peak_to_peak"] == measures.outputs["block"].peak_to_peak


def test_extremes_between_events_are_exact() -> None:
    """A steady wave of two harmonics turns where its slope says, four times a period."""
    forces = {"one": Force("body", amplitude=1.0), "three": Force("body", amplitude=9.0, order=3)}
    mechanism = one_body(frequency=1.0, links={"s": Link(("ground", "body"), 4.0, 3.0)}, forces=forces)
    orders, omega = np.array([1, 3]), 2 * math.pi
    sizes = np.array([1.0, 9.0]) / (4 - (orders * omega) ** 2 + 3j * orders * omega)
    angles = np.linspace(0, 2 * math.pi, 2_000_001)
    wave = (sizes[:, None] * np.exp(1j * orders[:, None] * angles)).sum(axis=0).imag
    found = forced_orbit(mechanism).measures.outputs["body"]
    assert (found.smallest, found.largest) == pytest.approx((wave.min(), wave.max()), rel=1e-10)
    assert found.rms == pytest.approx(np.sqrt((abs(sizes) ** 2).sum() / 2), rel=1e-10)


def test_without_outputs_there_are_no_measures_of_them() -> None:
    mechanism = replace(MACHINE, outputs={})
    assert forced_orbit(mechanism).measures.outputs == {}
    assert response_json(respond(mechanism))["outputs"] == {}


def test_constant_forces_and_pins_that_rub_do_work() -> None:
    mechanism = one_body(
        2.0,
        frequency=3.0,
        pins={"belt": Pin("ground", amplitude=0.05)},
        links={"spring": Link(("ground", "body"), 400.0, 1.0)},
        frictions={"rub": Friction(("belt", "body"), 1.5, viscous=0.7)},
        forces={"weight": Force("body", constant=3.0)},
        start={"body": (0.1, 0.7)},
    )
    motion = simulate(mechanism, 1.1)
    way = float(motion.displacement("body", 1.1) - motion.displacement("body", 0.0))
    energy = motion.energy
    assert energy.forces["weight"] == pytest.approx(3.0 * way, rel=1e-12)
    assert energy.residual < 1e-11
    assert energy.pins["belt"] + energy.forces["weight"] == pytest.approx(energy.work, rel=1e-12)


def test_what_differs_by_rounding_alone_is_still() -> None:
    """A ball rests on a table that moves by a millimetre."""
    ball = example("bouncing-ball").with_value("walls.plate.restitution", 0.45).with_value("frequency", 20.0)
    outputs = respond(ball).motion.measures.outputs
    assert (outputs["height"].peak_to_peak, outputs["height"].rms, outputs["height"].amplitudes.any()) == (
        0,
        0,
        False,
    )
    assert outputs["ball"].peak_to_peak == pytest.approx(1e-3, rel=1e-12)
