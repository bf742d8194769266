"""The exact engine against brute force: kind, part and time of each event, states at many times.

The brute force runs at two tolerances. Their difference is its error, and where they part the comparison
ends: a chaotic motion is compared only as long as it is known.
"""

from dataclasses import replace

import numpy as np
import pytest

from tests.mechanisms.comparison import Trusted, difference, trusted
from tests.mechanisms.dynamics import System
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.mechanisms.tricky_mechanisms import TRICKY
from tests.quick import examples, quick
from tests.trimmer.contact.exact import exact_motion
from trimmer.mechanism import Body, ContactLaw, Force, Friction, Link, Mechanism, Output, Pin, Play, Stop

# The longest error that is taken for the brute force's own, in periods and in usual sizes of states.
LARGEST = 1e-8
FORCELESS = ("nothing", "air")
"""A play without spring and damper and a friction without dry force, which have no events."""
QUICK_SEEDS = (11, 174)
QUICK_TRICKY = (
    "preloaded, truncated",
    "play_without_gap, pulling",
    "frictions_side_by_side_with_static_force",
    "rubbing_on_a_shaking_table",
    "ring",
    "weak grazing, 1e-9",
)


def compare(mechanism: Mechanism, periods: float, known: float = 0.0) -> None:
    """Hold the exact motion against brute force as far as that is known, for a share of the time at least.

    ``make test`` holds the first period alone; quick instances of random machines have events in it.
    """
    period, periods = 1 / mechanism.frequency, min(periods, examples(1, 10))
    brute = trusted(mechanism, periods * period, LARGEST)
    assert brute.horizon >= known * periods * period
    exact = exact_motion(mechanism, periods * period)
    enough = max(10 * brute.error, 1e-11)
    heard = [event for event in brute.motion.events if event.part not in FORCELESS]
    parted = difference(exact.events, heard, enough * period)
    assert parted.time >= brute.horizon, (parted.first, parted.second)
    assert states_apart(exact, brute) <= enough


def states_apart(exact, brute: Trusted) -> float:
    """Largest distance of states, in usual sizes."""
    times = np.linspace(0, max(brute.horizon, 0.0), 150)
    system = brute.motion.system
    usual = system.usual[: system.rows.state_size]
    return float(np.max(np.abs(exact.states(times) - brute.motion.states(times)) / usual))


@pytest.mark.parametrize("seed", quick((*QUICK_SEEDS, *range(1, 330, 3)), 0, 1))
def test_a_random_mechanism(seed):
    compare(random_mechanism(seed), 3, known=0.8 * (seed in QUICK_SEEDS))


@pytest.mark.parametrize("seed", quick((8, 174), 1))
def test_a_random_mechanism_from_any_start(seed):
    """Its contacts may be closed at once, also by a pull, and its frictions slide."""
    mechanism, random = random_mechanism(seed), np.random.default_rng(seed)
    usual = System(mechanism).usual
    count = len(mechanism.bodies)
    start = random.normal(size=2 * count) * usual[: 2 * count]
    given = {name: (start[place], start[count + place]) for place, name in enumerate(mechanism.bodies)}
    compare(replace(mechanism, start=given), 2, known=0.5)


def everything() -> Mechanism:
    """Two bodies with parts of each kind; names and ends in mixed orders."""
    return Mechanism(
        bodies={"motor": Body(0.035), "cutter": Body(0.003)},
        frequency=110.0,
        pins={
            "pin": Pin("motor", 1.5e-3, 0.3, offset=2e-4, order=3),
            "belt": Pin("ground", velocity=0.25, offset=-3e-4),
            "idle": Pin("cutter", velocity=0.5),
        },
        links={
            "mount": Link(("motor", "ground"), 200e3, 3.5),
            "leaning": Link(("belt", "cutter"), 40.0, 3.0),
        },
        plays={
            "bridge": Play(("cutter", "pin"), 30e3, 0.4, 4e-5),
            "nothing": Play(("cutter", "motor"), 0.0, 0.0, 1e-3),
            "tight": Play(("motor", "cutter"), 9.0, 0.7, 0.0, ContactLaw.TRUNCATED),
        },
        stops={
            "wall": Stop(("ground", "motor"), 5e4, 0.0, 6e-4),
            "soft": Stop(("cutter", "ground"), 2e4, 0.3, 7e-4, ContactLaw.PULLING),
        },
        frictions={
            "blade": Friction(("motor", "cutter"), 0.8, 1.1, viscous=0.2),
            "air": Friction(("ground", "cutter"), 0.0, viscous=0.1),
            "table": Friction(("belt", "motor"), 0.5),
        },
        forces={"weight": Force("cutter", 0.03), "drum": Force("motor", 0.0, 2.0, 0.4, 1, 1e-6)},
        outputs={"stroke": Output({"cutter": 1.0, "motor": -1.0})},
    )


def test_parts_of_each_kind_together():
    compare(everything(), 1, known=0.8)


@pytest.mark.parametrize("name", quick(TRICKY, *map(list(TRICKY).index, QUICK_TRICKY)))
def test_what_is_easy_to_get_wrong(name):
    compare(TRICKY[name](), 4, known=(name in QUICK_TRICKY) * 0.8 / examples(1, 2))
