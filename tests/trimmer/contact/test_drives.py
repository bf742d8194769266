"""Several drives: superposition, when all return together, tori, brute force, and who refuses what."""

from dataclasses import replace

import control
import numpy as np
import pytest

from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from tests.trimmer.contact.test_against_brute_force import compare
from trimmer import MotionKind, OrbitNotFoundError, follow, forced_orbit, motion_map, respond, simulate
from trimmer.errors import MechanismError
from trimmer.mechanism import Body, Force, Link, Mechanism, Output, Pin, Stop

PASSES = control.tf([1.0], [0.2, 6.0, 2000.0])


def driven(hum: float | str, gap: float = 1.0, **more: object) -> Mechanism:
    """A body on a spring with two forces, the second of a drive of its own, and a stop."""
    made = Mechanism(
        {"body": Body(0.2)},
        frequency=12.0,
        links={"spring": Link(("ground", "body"), 2000.0, 6.0)},
        stops={"stop": Stop(("ground", "body"), 2e4, 3.0, gap)},
        forces={
            "first": Force("body", amplitude=20.0),
            "second": Force("body", amplitude=12.0, phase=0.4, drive="hum", harmonics=((3, 2.0, 1.0),)),
        },
        outputs={"x": Output({"body": 1.0}), "v": Output({"body": 1.0}, "velocity")},
        drives={"hum": 18.0},
    )
    return replace(made.with_value("drives.hum", hum), **more)  # type: ignore[arg-type]


def passed(frequencies: np.ndarray) -> np.ndarray:
    return np.asarray(PASSES(2j * np.pi * frequencies))


def test_waves_of_two_drives_superpose() -> None:
    motion = respond(driven(18.0)).motion
    assert (motion.kind, motion.period_count) == (MotionKind.PERIODIC, 2)
    assert motion.orbit is not None
    lines = {p: size for p, k, size in motion.orbit.measures.outputs["x"].lines if k == 2}
    expected = {2: 20.0, 3: 12.0, 9: 2.0}
    for p, size in lines.items():
        force = expected.get(p, 0.0)
        assert size == pytest.approx(force * abs(passed(np.array([6.0 * p]))[0]), rel=1e-10, abs=1e-15)


@pytest.mark.parametrize("gap", [1.0, 3e-3])
def test_a_multiple_of_the_frequency_is_an_order(gap: float) -> None:
    """24 Hz are the second order of 12 Hz, also where an impact comes in."""
    several = driven("24 Hz", gap)
    second = replace(several.forces["second"], drive=None, order=2, harmonics=((6, 2.0, 1.0),))
    single = replace(several, forces={**several.forces, "second": second}, drives={})
    ours, theirs = (respond(each).motion for each in (several, single))
    assert (ours.period_count, ours.events_per_period) == (theirs.period_count, theirs.events_per_period)
    assert ours.peak_to_peak == pytest.approx(theirs.peak_to_peak, rel=1e-11)


def test_impacts_repeat_where_the_drives_return_together() -> None:
    mechanism = driven(18.0, 3e-3)
    motion = respond(mechanism).motion
    assert motion.orbit is not None
    assert (motion.period_count, motion.events_per_period) == (2, 2.0)
    followed = simulate(mechanism, 5.0 + motion.orbit.period)
    times = 5.0 + np.linspace(0.0, motion.orbit.period, 2001)
    values = followed.output("x", times)
    assert np.ptp(values) == pytest.approx(motion.peak_to_peak["x"], rel=1e-5)
    assert values[0] == pytest.approx(values[-1], abs=1e-11)
    orbit = forced_orbit(mechanism, periods=2)
    assert orbit.measures.peak_to_peak == pytest.approx(motion.peak_to_peak, rel=1e-10)
    cell = motion_map(mechanism, {"links.spring.stiffness": [2000.0, 2050.0]}).cells[0]
    assert cell.motions[0].period_count == 2
    branch = follow(mechanism, "links.spring.stiffness", 2000.0, 2010.0)
    assert branch.points[0].outputs["x"].peak_to_peak == pytest.approx(motion.peak_to_peak["x"], rel=1e-9)


@pytest.mark.parametrize(
    ("hum", "periods"),
    [(12.0 * 65 / 64, 64), (12.0 * 66 / 65, None), (18.0 * (1 + 1e-11), 2), (18.0 * (1 + 1e-8), None)],
)
def test_drives_return_within_64_periods_to_a_billionth_of_a_turn_or_not(
    hum: float, periods: int | None
) -> None:
    motion = respond(driven(hum)).motion
    assert motion.period_count == periods
    assert motion.kind is (MotionKind.TORUS if periods is None else MotionKind.PERIODIC)


def test_a_linear_torus_has_the_swing_and_the_rms_of_its_waves() -> None:
    hum = 12.0 * np.sqrt(2.0)
    response = respond(replace(driven(hum), stops={}))
    motion = response.motion
    assert motion.kind is MotionKind.TORUS
    assert "its drives do not return together within 64 periods" in response.message
    first, *second = abs(passed(np.array([12.0, hum, 3 * hum]))) * [20.0, 12.0, 2.0]
    assert motion.rms["x"].value == pytest.approx(
        np.sqrt(0.5 * (first**2 + np.square(second).sum())), rel=1e-10
    )
    turns = np.linspace(0, 2 * np.pi, 100001)
    both = 12.0 * passed(np.array([hum])) * np.exp(1j * (turns + 0.4))
    both = both + 2.0 * passed(np.array([3 * hum])) * np.exp(1j * (3 * turns + 1.0))
    assert motion.peak_to_peak["x"] == pytest.approx(2 * first + np.ptp(both.imag), rel=1e-6)


def test_impacts_with_drives_that_never_return_run_on_a_torus() -> None:
    response = respond(driven(12.0 * np.sqrt(2.0), 3e-3), most_periods=200)
    motion = response.motion
    assert (motion.kind, motion.period_count, motion.orbit) == (MotionKind.TORUS, None, None)
    assert "small distances shrink" in response.message
    values = simulate(driven(12.0 * np.sqrt(2.0), 3e-3), 60.0).output("x", np.linspace(20.0, 60.0, 80001))
    assert motion.rms["x"].value == pytest.approx(values.std(), rel=5e-3)
    assert motion.peak_to_peak["x"] == pytest.approx(np.ptp(values), rel=5e-3)


def several(seed: int) -> Mechanism:
    """A random mechanism in which each pin and force has a drive of its own."""
    made, random = random_mechanism(seed), np.random.default_rng(seed)
    parts = [*made.pins, *made.forces]
    drives = {name: made.frequency * float(random.uniform(0.4, 2.5)) for name in parts}
    pins = {name: replace(pin, drive=name) for name, pin in made.pins.items()}
    forces = {name: replace(force, drive=name) for name, force in made.forces.items()}
    return replace(made, pins=pins, forces=forces, drives=drives)


@pytest.mark.parametrize("seed", quick(range(20), 7))
def test_random_mechanisms_with_a_drive_for_each_part(seed: int) -> None:
    compare(several(seed), 3)


def test_who_needs_what_repeats_says_what_is_wrong() -> None:
    never = driven(12.0 * np.sqrt(2.0))
    with pytest.raises(OrbitNotFoundError, match="do not return together within 64 periods"):
        forced_orbit(never)
    with pytest.raises(OrbitNotFoundError, match="return together after 2, so give a multiple"):
        forced_orbit(driven(18.0), periods=3)
    with pytest.raises(MechanismError, match=r"drives\.hum: the drives return together at single values"):
        follow(driven(18.0), "drives.hum", 18.0, 19.0)
    with pytest.raises(MechanismError, match=r"frequency: the drives return together at single values"):
        follow(driven(18.0), "frequency", 12.0, 13.0)
    with pytest.raises(MechanismError, match="nothing repeats that could be followed"):
        follow(never, "links.spring.stiffness", 2000.0, 2100.0)


TEXT = """
frequency = 12.0
[drives]
hum = "18 Hz"
[bodies]
body = { mass = 0.2 }
[links]
spring = { between = ["ground", "body"], stiffness = 2000.0 }
[forces]
push = { on = "body", amplitude = 20.0, drive = "hum" }
"""


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("frequency = 12.0", "", 'drives.hum = "18 Hz": periods count in those of frequency'),
        (
            'drive = "hum"',
            'drive = "hun"',
            "forces.push.drive = 'hun': there is no drive 'hun'; there is 'hum'",
        ),
        ('drive = "hum"', "drive = 3", "forces.push.drive = 3: name one of [drives]"),
        ('"18 Hz"', "0", "drives.hum = 0: must be greater than zero, in Hz"),
        ('"18 Hz"', '"18 mm"', "drives.hum = '18 mm': 'mm' does not measure what Hz does"),
    ],
)
def test_drives_that_are_none(old: str, new: str, sentence: str) -> None:
    with pytest.raises(MechanismError) as caught:
        Mechanism.from_toml_text(TEXT.replace(old, new))
    assert sentence.replace('"18 Hz"', "'18 Hz'") in str(caught.value)


def test_a_drive_has_a_place_and_is_written() -> None:
    mechanism = Mechanism.from_toml_text(TEXT)
    assert mechanism.places["drives.hum"] == "Hz"
    assert mechanism.with_value("drives.hum", "1 kHz").value("drives.hum") == 1000.0
    assert Mechanism.from_toml_text(mechanism.to_toml()) == mechanism
    with pytest.raises(MechanismError, match="there is no number at drives"):
        mechanism.with_value("drives.hun", 3.0)
    still = replace(mechanism, pins={"table": Pin("ground", drive="hum")})
    assert simulate(still, 0.1).success
