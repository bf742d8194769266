"""Slips that die away, each with a smaller one to follow, until friction holds all."""

import numpy as np
import pytest

from tests.mechanisms.random_mechanisms import random_mechanism
from tests.mechanisms.shifted_phases import shifted, state_at
from tests.quick import quick
from trimmer import respond


@pytest.mark.parametrize(("seed", "share"), quick([(1069, 0.22), (1125, 0.72)]))
def test_where_slips_die_away_the_motion_is_neutral_whenever_the_clock_begins(
    seed: int, share: float
) -> None:
    """On the way their multiplier is below 1, and the return is closed to rounding."""
    machine = random_mechanism(seed)
    others = respond(shifted(machine, share), state=state_at(machine, share), most_periods=300).motion
    motion = respond(machine, most_periods=300).motion
    for each in (motion, others):
        assert (each.orbit.success, each.orbit.stable, each.orbit.neutral) == (True, False, True)
        assert abs(each.orbit.multipliers[0]) == pytest.approx(1.0, abs=1e-7)
        # The brief slips are gone: one friction slides and sticks once a period or not at all.
        assert each.orbit.events_per_period == motion.orbit.events_per_period
    assert np.allclose(*(abs(each.orbit.multipliers[1:]) for each in (motion, others)), atol=1e-6)
