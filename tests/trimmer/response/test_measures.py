"""Energies and measures of a motion with two bodies and one of each part, held against dense samples."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer import ContactLaw, forced_orbit, simulate
from trimmer.contact.flow import ExactFlow
from trimmer.contact.statuses import RELAXING
from trimmer.mechanism import Body, Force, Friction, Link, Mechanism, Output, Pin, Play, Stop
from trimmer.response.energy import MechanismEnergy, _Balance
from trimmer.response.extremes import extremes
from trimmer.response.measures import Measures, OutputMeasures
from trimmer.response.motion import MechanismMotion
from trimmer.response.motion_signals import steady

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
def motion() -> MechanismMotion:
    """Two drive periods after a few, from a start that is at rest nowhere."""
    flow = ExactFlow(MACHINE)
    late = flow.strobe(flow.rest({"sled": (0.01, 0.3), "block": (-0.02, -0.1)}), 3).end
    return MechanismMotion(flow, flow.course(late, PERIODS))


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

    def stretch(start: str, end: str) -> np.ndarray:
        return place[end] - place[start]

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
    rod = 400.0 * stretch("crank", "block") + 1.0 * rate("crank", "block")
    pull = -(rod + motion.contact_force("slot", times))
    assert energy.pins["crank"] == pytest.approx(duration * mean(pull * rate("sled", "crank")), rel=1e-4)
    assert energy.pins["wall"] == 0.0
    for when, each in (("start", 0), ("end", 1)):
        time = 0.0 if when == "start" else duration
        kinetic = 0.25 * motion.velocity("sled", time) ** 2 + motion.velocity("block", time) ** 2
        assert energy.kinetic[each] == pytest.approx(float(kinetic), rel=1e-9)
    assert energy.residual < 1e-12
    assert min(energy.contacts.values()) > 0


def test_a_spring_that_relaxes_stores_what_its_own_state_says(motion) -> None:
    balance, course = _Balance(motion.mechanism, motion.course), motion.course
    assert len(motion.flow.names) == 5
    statuses = course.modes.tables.statuses[course.log.mode, 0]
    rows = np.flatnonzero(statuses == RELAXING)
    assert len(rows)
    for row in rows:
        found = balance.stretch(0)(int(course.log.mode[row]))
        np.testing.assert_array_equal(found, np.eye(course.modes.layout.size)[4])
        springs = balance.stored(np.eye(course.modes.layout.size)[4], int(row))
        assert springs == pytest.approx(0.5 * 6000.0)


def test_terms_add_up_with_their_signs() -> None:
    parts = {"pins": {"a": 7.0, "b": -2.0}, "forces": {"c": 4.0}, "dampers": {"d": 1.0}}
    parts |= {"contacts": {"e": 0.75}, "frictions": {"f": 0.25, "g": 2.5}}
    energy = MechanismEnergy((1.0, 3.0), (0.5, 4.5), **parts)
    # 2 + 4 stored, 9 put in, 4.5 lost: 1.5 too much, of 7 at most.
    assert (energy.work, energy.loss) == (9.0, 4.5)
    assert energy.residual == pytest.approx(1.5 / 7)
    rows = list(energy._table().rows())
    assert rows[:4] == [
        ("kinetic, start", 1.0), ("kinetic, end", 3.0), ("stored, start", 0.5), ("stored, end", 4.5)
    ]  # fmt: skip
    assert rows[4:7] == [("pins.a", 7.0), ("pins.b", -2.0), ("forces.c", 4.0)]
    assert [name for name, _ in rows[7:]] == ["dampers.d", "contacts.e", "frictions.f", "frictions.g"]
    assert energy._told() == "work 9 J, loss 4.5 J; it closes to 2.1e-01 of its largest term"
    still = MechanismEnergy((0.0, 0.0), (0.0, 0.0), {}, {}, {}, {}, {})
    assert (still.residual, still.work, still.loss) == (0.0, 0.0, 0.0)


@pytest.fixture(scope="module")
def measures(motion) -> Measures:
    """Of the motion, as if it returned after two drive periods."""
    return Measures(motion.course, motion.flow, PERIODS, PERIODS)


def test_outputs_have_the_sums_and_lines_of_samples(motion, times, measures) -> None:
    for name in ("block", "travel"):
        values, found = motion.output(name, times), measures.outputs[name]
        assert found.mean == pytest.approx(mean(values), rel=1e-6)
        assert found.rms == pytest.approx(float(values.std()), rel=1e-6)
        assert (found.smallest, found.largest) == pytest.approx((values.min(), values.max()), rel=1e-5)
        assert found.peak_to_peak == found.largest - found.smallest
        assert measures.peak_to_peak[name] == found.peak_to_peak
        lines = [
            2 * complex(np.mean((values - values.mean()) * np.exp(-1j * p / PERIODS * OMEGA * times)))
            for p in range(1, 5)
        ]
        np.testing.assert_allclose(found.amplitudes[:4], lines, atol=1e-6 * abs(lines[1]))
        assert len(found.harmonics) == 20
        assert found.harmonics[:2] == pytest.approx([abs(lines[1]), abs(lines[3])], rel=1e-5)
        assert found.phases[:2] == pytest.approx([np.angle(lines[1]), np.angle(lines[3])], abs=1e-4)
        assert found.subharmonics == pytest.approx([abs(lines[0])], abs=1e-6 * abs(lines[1]))


def test_bodies_and_contacts_do_what_samples_do(motion, times, measures) -> None:
    step = motion.duration / COUNT
    for body in ("sled", "block"):
        edges = np.append(times - step / 2, motion.duration)
        accelerations = np.diff(motion.velocity(body, np.maximum(edges, 0.0))) / step
        assert measures.rms_acceleration[body] == pytest.approx(math.sqrt(mean(accelerations**2)), rel=2e-3)
    for name in ("slot", "end"):
        force, found = motion.contact_force(name, times), measures.contacts[name]
        assert found.largest_force == pytest.approx(abs(force).max(), rel=5e-3)
        assert found.share == pytest.approx(mean(force != 0), abs=2e-3)
        made = [each.time for each in motion.events if each.part == name and each.kind.word == "contact-made"]
        assert found.impacts == len(made) / PERIODS
        start, end = ("crank", "block") if name == "slot" else ("wall", "sled")
        speeds = [abs(motion.velocity(end, t) - motion.velocity(start, t)) for t in made]
        assert found.impact_speeds == pytest.approx(speeds, rel=1e-9)
        assert found.impact_speed == max(found.impact_speeds, default=0.0)
    assert measures.contacts["slot"].impacts > 0


def test_frictions_lose_and_stick_as_samples_do(motion, times, measures) -> None:
    for name, (start, end) in (("floor", ("ground", "sled")), ("face", ("sled", "block"))):
        rate = motion.velocity(end, times) - motion.velocity(start, times)
        found, force = measures.frictions[name], MACHINE.frictions[name].force
        lost = force * mean(abs(rate))
        assert found.power == pytest.approx(lost, rel=1e-4)
        assert found.work == pytest.approx(lost * motion.duration / PERIODS, rel=1e-4)
        assert found.stick == pytest.approx(mean(abs(rate) < 1e-12), abs=2e-3)
    assert measures.frictions["face"].stick > 0.05
    assert measures.events_per_period == len(motion.events) / PERIODS


def test_lines_are_numbered_by_parts_of_the_drive() -> None:
    amplitudes = np.array([3j, -4.0, 1 + 1j, 2.0, 0.5, -6j])
    found = OutputMeasures(-1.0, 4.0, 0.5, 1.0, amplitudes, 3)
    assert found.peak_to_peak == 5.0
    assert found.harmonics == pytest.approx([math.sqrt(2), 6.0])
    assert found.phases == pytest.approx([math.pi / 4, -math.pi / 2])
    assert found.subharmonics.tolist() == [3.0, 4.0]
    assert found.lines[:2] == [(1, 3, 3.0), (2, 3, 4.0)]
    assert found.lines[-1] == (6, 3, 6.0)


def test_extremes_between_nodes_are_exact() -> None:
    """A decaying oscillation: extremes at known times, the ends of the motion among the values."""
    damping, stiffness = 0.6, 40.0
    mechanism = Mechanism(
        {"body": Body(1.0)},
        links={"spring": Link(("ground", "body"), stiffness, damping)},
        start={"body": (1.0, 0.0)},
    )
    turned = math.sqrt(stiffness - damping**2 / 4)
    motion = simulate(mechanism, 2.2 * math.pi / turned)
    decay = math.exp(-damping / 2 * math.pi / turned)
    row = np.zeros(motion.course.modes.layout.size)
    row[0] = 1.0
    assert extremes(motion.course, steady(row)) == pytest.approx((-decay, 1.0), rel=1e-12)
    short = simulate(mechanism, 0.5 * math.pi / turned)
    end = float(short.displacement("body", short.duration))
    assert extremes(short.course, steady(row)) == pytest.approx((end, 1.0), rel=1e-12)


def test_without_outputs_there_are_no_measures_of_them() -> None:
    mechanism = Mechanism(
        {"body": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "body"), 4.0, 1.0)},
        forces={"push": Force("body", amplitude=1.0)},
    )
    orbit = forced_orbit(mechanism)
    assert orbit.measures.outputs == {}
    assert orbit.measures.peak_to_peak == {}


def test_a_constant_force_does_force_times_way() -> None:
    mechanism = Mechanism(
        {"body": Body(2.0)},
        links={"spring": Link(("ground", "body"), 40.0, 1.0)},
        forces={"weight": Force("body", constant=3.0)},
        start={"body": (0.1, 0.7)},
    )
    motion = simulate(mechanism, 0.9)
    way = float(motion.displacement("body", 0.9) - motion.displacement("body", 0.0))
    assert motion.energy.forces["weight"] == pytest.approx(3.0 * way, rel=1e-12)
    assert motion.energy.residual < 1e-13


def test_a_pin_works_against_the_friction_that_it_rubs() -> None:
    mechanism = Mechanism(
        {"body": Body(2.0)},
        frequency=3.0,
        pins={"belt": Pin("ground", amplitude=0.05)},
        links={"spring": Link(("ground", "body"), 400.0, 1.0)},
        frictions={"rub": Friction(("belt", "body"), 1.5, viscous=0.7)},
    )
    energy = simulate(mechanism, 1.1).energy
    assert energy.residual < 1e-11
    assert energy.pins["belt"] == energy.work > energy.frictions["rub"] > 0.1
