"""The exact engine against brute force: kind, part and time of each event, states at many times.

The brute force runs at two tolerances. Their difference is its error, and where they part the comparison
ends: a chaotic motion is compared only as long as it is known.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.mechanisms.comparison import Trusted, difference, trusted
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.mechanisms.tricky_mechanisms import TRICKY
from tests.trimmer.contact.exact import exact_motion
from trimmer.mechanism.mechanism import Mechanism

# The longest error that is taken for the brute force's own, in periods and in usual sizes of states.
LARGEST = 1e-8
QUICK_SEEDS = (2, 4, 7, 8, 11, 13, 15, 17, 27, 174, 186, 190)
QUICK_TRICKY = (
    "two_stops_at_once, relaxing",
    "preloaded, truncated",
    "touching_at_rest, relaxing",
    "play_without_gap, relaxing",
    "play_without_gap, pulling",
    "overdamped_contact, truncated",
    "frictions_side_by_side_with_static_force",
    "ring_with_a_free_body",
    "rubbing_on_a_shaking_table",
    "between_ground_and_belt",
    "coming_to_rest",
    "ring",
    "weak grazing, 1e-6",
    "weak grazing, 1e-9",
)


def compare(mechanism: Mechanism, periods: float, known: float = 0.0) -> None:
    """Hold the exact motion against brute force as far as that is known, for a share of the time at least."""
    period = 1 / mechanism.frequency
    brute = trusted(mechanism, periods * period, LARGEST)
    assert brute.horizon >= known * periods * period
    exact = exact_motion(mechanism, periods * period)
    enough = max(10 * brute.error, 1e-11)
    parted = difference(exact.events, brute.motion.events, enough * period)
    assert parted.time >= brute.horizon, (parted.first, parted.second)
    assert states_apart(exact, brute) <= enough


def states_apart(exact, brute: Trusted) -> float:
    """Largest distance of states, in usual sizes."""
    times = np.linspace(0, max(brute.horizon, 0.0), 150)
    system = brute.motion.system
    usual = system.usual[: system.rows.state_size]
    return float(np.max(np.abs(exact.states(times) - brute.motion.states(times)) / usual))


@pytest.mark.parametrize("seed", QUICK_SEEDS)
def test_a_random_mechanism(seed):
    compare(random_mechanism(seed), 2, known=0.8)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(330))
def test_many_random_mechanisms(seed):
    compare(random_mechanism(seed), 3)


@pytest.mark.parametrize("name", QUICK_TRICKY)
def test_what_is_easy_to_get_wrong(name):
    compare(TRICKY[name](), 2, known=0.8)


@pytest.mark.slow
@pytest.mark.parametrize("name", list(TRICKY))
def test_all_that_is_easy_to_get_wrong(name):
    compare(TRICKY[name](), 4)
