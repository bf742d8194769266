"""Simulated motions of mechanisms: events, forces and energy."""

import dataclasses
import math

import numpy as np
import pytest

from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick
from tests.trimmer.response.mechanisms import example, twin
from trimmer import Body, ContactLaw, Force, Link, Mechanism, MechanismError, Stop, simulate
from trimmer.mechanism import Output, Wall

LAWS = list(ContactLaw)
NAMES = ("thesis-play", "second-play", "foil-shaver", "held", "servo", "den-hartog", "thesis", "gear-pair")


@pytest.mark.parametrize("law", quick(LAWS, 0))
@pytest.mark.parametrize("name", [*NAMES, 4, 8])
def test_the_energy_balance_closes_to_rounding(name: str | int, law: ContactLaw) -> None:
    mechanism = example(name) if isinstance(name, str) else random_mechanism(name)
    plays = {key: dataclasses.replace(play, law=law) for key, play in mechanism.plays.items()}
    mechanism = dataclasses.replace(mechanism, plays=plays)
    motion = simulate(mechanism, 20.3 / mechanism.frequency)
    energy = motion.energy
    assert motion.success
    assert energy.residual < 1e-12
    assert (
        min([*energy.dampers.values(), *energy.contacts.values(), *energy.frictions.values(), 0.0]) > -1e-15
    )


def test_what_a_belt_travels_is_in_outputs_and_displacements() -> None:
    outputs = {"belt": Output({"belt": 1.0}), "slip": Output({"block": 1.0, "belt": -1.0})}
    belt = dataclasses.replace(example("block-on-belt"), outputs=outputs)
    motion, times = simulate(belt, 20.0), np.linspace(0.0, 20.0, 7)
    travelled = belt.pins["belt"].velocity * times
    for read in (motion.signal, motion.output, motion.displacement):
        np.testing.assert_allclose(read("belt", times), travelled, rtol=1e-15)
    block = motion.displacement("block", times)
    np.testing.assert_allclose(motion.signal("slip", times), block - travelled, rtol=1e-13)


def test_the_block_on_the_belt_sticks_and_slips() -> None:
    mechanism = example("block-on-belt")
    motion = simulate(mechanism, 30.0)
    kinds = [event.kind.word for event in motion.events]
    assert motion.events[0].part == "rubbing"
    assert set(kinds) == {"stick-begun", "stick-ended"}
    slips = [event.time for event in motion.events if event.kind.word == "stick-ended"]
    assert np.diff(slips) == pytest.approx(8.902605407815, abs=1e-10)
    stuck = slips[-1] - 1.0
    assert motion.friction_force("rubbing", stuck) == pytest.approx(-motion.displacement("block", stuck))
    assert motion.friction_force("rubbing", slips[-1]) == pytest.approx(-0.5)
    assert motion.velocity("block", stuck) == pytest.approx(0.2, abs=1e-13)


def test_events_have_the_speed_at_which_contact_begins_and_ends() -> None:
    """The ratio of speeds is exp(-z/sqrt(1 - z²) atan2(2 z sqrt(1 - z²), 2 z² - 1)), z = 0.1."""
    motion = simulate(example("thrown-body"), 5.0)
    made, broken = motion.events
    assert (made.time, made.rate, made.impulse) == (pytest.approx(1.0), pytest.approx(1.0), None)
    assert broken.rate == pytest.approx(-0.744079397722, abs=1e-12)
    assert broken.speed == -broken.rate
    back = broken.speed * (0.2 / 1.0 - (5.0 - broken.time))  # It lets go where k x + c v = 0.
    assert motion.final["body"] == pytest.approx((back, broken.rate), abs=1e-12)


def test_a_relay_closes_after_it_bounced() -> None:
    """At rest (100 + 50e3) x = 50e3 · 0.5 mm - 0.4 N, which the seat's spring bears but for 100 x."""
    relay = Mechanism(
        {"relay": Body(mass=0.01)},
        links={"spring": Link(("ground", "relay"), stiffness=100.0, damping=0.05)},
        stops={"seat": Stop(("relay", "ground"), stiffness=50e3, damping=2.0, gap=-0.5e-3)},
        forces={"bias": Force("relay", constant=-0.4)},
        start={"relay": (3e-3, 0.0)},
    )
    motion, early = simulate(relay, 2.0), simulate(relay, 0.02)
    met = [event for event in motion.events if event.kind.word == "contact-made"]
    closing, place = motion.closings["seat"], (50e3 * 0.5e-3 - 0.4) / (100.0 + 50e3)
    assert (closing.closing_time, closing.touches) == (met[0].time, len(met))
    assert closing.bounce_time == met[-1].time - met[0].time > 0.1
    assert closing.impact_speed == met[0].speed
    assert (closing.closed, early.closings["seat"].closed) == (True, False)
    assert closing.force == pytest.approx(0.4 + 100.0 * place, rel=1e-9)
    assert motion.rest.positions["relay"] == pytest.approx(place)
    assert (early.rest, early.closings["seat"].force) == (None, 0.0)


def test_a_ball_that_is_dropped_on_a_wall_bounces_for_a_time_that_is_known() -> None:
    """v = sqrt(2 g h); between the impacts v e/g, v e²/g ... twice, together 2 v e/(g (1 - e))."""
    height, e, g = 0.01, 0.6, 9.81
    ball = Mechanism(
        {"ball": Body(mass=0.02)},
        walls={"floor": Wall(("ball", "ground"), restitution=e)},
        forces={"weight": Force("ball", constant=-0.02 * g)},
        start={"ball": (height, 0.0)},
    )
    closing, speed = simulate(ball, 1.0).closings["floor"], math.sqrt(2 * g * height)
    assert closing.closing_time == pytest.approx(speed / g)
    assert closing.bounce_time == pytest.approx(2 * speed * e / (g * (1 - e)), rel=1e-6)
    assert (closing.impact_speed, closing.force) == (pytest.approx(speed), pytest.approx(0.02 * g))
    assert closing.closed


def test_contact_forces_and_accelerations_are_one() -> None:
    motion = simulate(twin(0.0), 0.05)
    times = np.linspace(0.0, 0.05, 501)[::-1]
    force = motion.contact_force("bridge", times)
    cutter, housing = motion.displacement("cutter", times), motion.displacement("housing", times)
    spring = -1e3 * (cutter - housing)
    step = 1e-7
    inner = (times > step) & (times < 0.05 - step)
    change = motion.velocity("cutter", times[inner] + step) - motion.velocity("cutter", times[inner] - step)
    expected = (spring + force)[inner] / 0.003
    smooth = abs(change / (2 * step) - expected) < 1e-3 * abs(expected).max()
    assert smooth.mean() > 0.99
    assert motion.contact_force("bridge", 0.0).shape == ()


def test_what_is_not_there_is_named() -> None:
    motion = simulate(twin(), 0.01)
    with pytest.raises(MechanismError, match="'wheel'; there are"):
        motion.displacement("wheel", 0.0)
    with pytest.raises(MechanismError, match="no output"):
        motion.output("travel", 0.0)
    with pytest.raises(MechanismError, match="no play or stop"):
        motion.contact_force("blade", 0.0)
    with pytest.raises(MechanismError, match="no friction"):
        motion.friction_force("bridge", 0.0)
    with pytest.raises(ValueError, match="end of the motion"):
        motion.output("stroke", 0.02)
    with pytest.raises(ValueError, match="times must lie between 0 and the end of the motion"):
        motion.output("stroke", [0.0, 0.005, 0.02])
    with pytest.raises(ValueError, match="times must lie between 0 and the end of the motion"):
        motion.output("stroke", [-1e-9, 0.005])
    with pytest.raises(TypeError, match="impulse is an argument for loops"):
        simulate(twin(), 0.01, impulse=1.0)
    with pytest.raises(ValueError, match="duration"):
        simulate(twin(), 0.0)
