"""The brute force loses no energy that no part takes, and no part gives any."""

from __future__ import annotations

import pytest

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.energy import energy
from tests.mechanisms.random_mechanisms import random_mechanism
from tests.quick import quick


@pytest.mark.slow
@pytest.mark.parametrize("seed", quick((12, 4, 6, 8, 26), 0))
def test_the_energy_of_a_random_mechanism_balances(seed):
    mechanism = random_mechanism(seed)
    balance = energy(BruteForce().from_rest(mechanism, 2 / mechanism.frequency))
    lost = [*balance.links.values(), *balance.contacts.values(), *balance.frictions.values()]
    scale = abs(balance.supplied) + sum(lost)
    assert abs(balance.unbalance) < 1e-9 * scale
    assert min(lost) > -1e-9 * scale
