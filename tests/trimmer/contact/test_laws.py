"""Laws that hold for any mechanism, held against the exact engine alone."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.mechanisms.comparison import difference
from tests.mechanisms.dynamics import System
from tests.mechanisms.random_mechanisms import all_with, random_mechanism
from tests.trimmer.contact.exact import ExactMotion, exact_motion
from trimmer import ContactLaw, Link, Mechanism, Play

# Periods, short enough that rounding does not grow to a difference in chaotic motions.
PERIODS = 1.5
TIMES = np.linspace(0.0, PERIODS, 40)
# Of usual sizes and of the period; rounding grows a hundredfold per period in chaotic motions.
ENOUGH = 1e-9

law = settings(max_examples=6)
# Of every other one several frictions rub.
SEEDS = st.integers(0, 79)


def run(mechanism: Mechanism) -> ExactMotion:
    return exact_motion(mechanism, PERIODS / mechanism.frequency)


def same(
    first: Mechanism,
    second: Mechanism,
    turned: Callable[[np.ndarray], np.ndarray] = lambda states: states,
    columns: int | None = None,
) -> None:
    """Hold events and turned states of a second mechanism against those of the first, in usual sizes."""
    one, other = run(first), run(second)
    parted = difference(one.events, other.events, ENOUGH / first.frequency)
    assert math.isinf(parted.time), (parted.first, parted.second)
    found, expected = turned(other.states(TIMES / second.frequency)), one.states(TIMES / first.frequency)
    assert np.max(np.abs(found[:, :columns] - expected[:, :columns]) / usual(first)[:columns]) < ENOUGH


def usual(mechanism: Mechanism) -> np.ndarray:
    system = System(mechanism)
    return system.usual[: system.rows.state_size]


@law
@given(seed=SEEDS, size=st.sampled_from([-3, 5]).map(lambda decades: 10.0**decades))
def test_motion_scales_with_lengths_and_forces(seed, size):
    mechanism = random_mechanism(seed)
    larger = replace(
        mechanism,
        pins=all_with(mechanism.pins, amplitude=size, offset=size, velocity=size),
        plays=all_with(mechanism.plays, gap=size),
        stops=all_with(mechanism.stops, gap=size),
        frictions=all_with(mechanism.frictions, force=size, static=size),
        forces=all_with(mechanism.forces, constant=size, amplitude=size, unbalance=size),
        start={name: (q * size, v * size) for name, (q, v) in mechanism.start.items()},
    )
    same(mechanism, larger, lambda states: states / size)


@law
@given(seed=SEEDS)
def test_motion_is_mirrored(seed):
    """Plays keep their ends, stops swap them: their gap is on the other side."""
    mechanism = random_mechanism(seed)
    mirrored = replace(
        mechanism,
        pins=all_with(mechanism.pins, amplitude=-1, offset=-1, velocity=-1),
        stops={name: replace(stop, between=stop.between[::-1]) for name, stop in mechanism.stops.items()},
        forces=all_with(mechanism.forces, constant=-1, amplitude=-1, unbalance=-1),
        start={name: (-q, -v) for name, (q, v) in mechanism.start.items()},
    )
    if any(pin.amplitude < 0 for pin in mirrored.pins.values()):
        turned = {
            name: replace(pin, amplitude=abs(pin.amplitude), phase=pin.phase + math.pi)
            for name, pin in mirrored.pins.items()
        }
        mirrored = replace(mirrored, pins=turned)
    same(mechanism, mirrored, lambda states: -states, columns=2 * len(mechanism.bodies))


@law
@given(seed=SEEDS)
def test_the_order_of_parts_does_not_matter(seed):
    mechanism = random_mechanism(seed)
    kinds = ("bodies", "pins", "links", "plays", "stops", "frictions", "forces")
    turned = replace(
        mechanism, **{kind: dict(reversed(list(getattr(mechanism, kind).items()))) for kind in kinds}
    )
    count = len(mechanism.bodies)
    same(mechanism, turned, lambda states: states[:, count - 1 :: -1][:, :count], columns=count)


@law
@given(seed=SEEDS, share=st.sampled_from([0.5, 0.1]))
def test_a_link_is_two_side_by_side(seed, share):
    mechanism = random_mechanism(seed)
    parts = {
        f"{name}, {place}": Link(link.between, link.stiffness * factor, link.damping * factor)
        for name, link in mechanism.links.items()
        for place, factor in (("first", share), ("second", 1 - share))
    }
    same(mechanism, replace(mechanism, links=parts))


@law
@given(seed=SEEDS)
def test_motion_does_not_know_when_it_began(seed):
    """After one period it goes on as it would have; without a belt, whose place tells the time."""
    mechanism = random_mechanism(seed)
    moved = {name: replace(pin, velocity=0.0) for name, pin in mechanism.pins.items()}
    mechanism, period = replace(mechanism, pins=moved), 1 / mechanism.frequency
    now, later = exact_motion(mechanism, 2 * period).states(np.array([period, 2 * period]))
    again = exact_motion(mechanism, period, now).states(np.array([period]))[0]
    apart = again - later
    assert np.max(np.abs(apart) / usual(mechanism)) < ENOUGH


@law
@given(seed=SEEDS)
def test_a_pulling_play_without_a_gap_is_a_link(seed):
    mechanism = random_mechanism(seed)
    name = "link 0"
    link = mechanism.links[name]
    others = {key: value for key, value in mechanism.links.items() if key != name}
    joint = Play(link.between, link.stiffness, link.damping, 0.0, ContactLaw.PULLING)
    played = replace(mechanism, links=others, plays={name: joint} | dict(mechanism.plays))
    same(mechanism, played)


def test_the_seeds_have_contacts_and_stick():
    """Otherwise the laws above would say little."""
    kinds = {event.kind for seed in range(6) for event in run(random_mechanism(seed)).events}
    assert len(kinds) == pytest.approx(5)
