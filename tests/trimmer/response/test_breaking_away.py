"""Frictions that break away together: one may hold the other once it resists with its kinetic force."""

import numpy as np
import pytest

from tests.mechanisms.comparison import trusted
from tests.mechanisms.random_mechanisms import random_mechanism
from trimmer import Body, Force, Friction, Mechanism, simulate

ON_TOP = {"floor": Friction(("ground", "lower"), 0.8, 0.9), "between": Friction(("lower", "upper"), 0.5, 1.0)}


def test_a_block_breaks_away_from_one_that_stays() -> None:
    """At their static forces both would go."""
    machine = Mechanism(
        {"lower": Body(1.0), "upper": Body(1.0)},
        frictions=ON_TOP,
        forces={"push": Force("upper", constant=4.0)},
    )
    motion = simulate(machine, 2.0)
    assert motion.success
    # But the floor holds 0.5 N, and the upper block has 3.5 of 4 N left.
    places = [motion.displacement(name, np.array([2.0]))[0] for name in ("lower", "upper")]
    assert places == pytest.approx([0.0, 7.0], abs=1e-13)


@pytest.mark.slow
def test_from_rest_the_motion_is_that_by_brute_force() -> None:
    machine = random_mechanism(5030)
    duration = 3 / machine.frequency
    motion, reference = simulate(machine, duration), trusted(machine, duration)
    assert motion.success
    assert reference.horizon > 0.99 * duration
    assert [(each.part, each.kind.value) for each in motion.events] == [
        (each.part, each.kind.value) for each in reference.motion.events
    ]
    times = np.linspace(0.0, reference.horizon, 50)
    ours = np.transpose([motion.displacement(name, times) for name in machine.bodies])
    assert np.allclose(ours, reference.motion.states(times)[:, :2], rtol=0.0, atol=1e-7 * abs(ours).max())
