from __future__ import annotations

import math

import pytest

from tests.trimmer.balance.loops import THIRD_ORDER
from trimmer.balance.leakage import harmonic_leakage
from trimmer.balance.solve import limit_cycles
from trimmer.elements.relay import Relay


def test_leakage_of_a_relay_is_that_of_its_square_wave() -> None:
    relay = Relay(1.0)
    (cycle,) = limit_cycles(THIRD_ORDER, relay)

    def gain(omega: float) -> float:
        return 1 / (omega * math.hypot(omega, 1) * math.hypot(omega, 2))

    expected = [gain(n * cycle.omega) / gain(cycle.omega) / n for n in (1, 3, 5)]
    assert harmonic_leakage(THIRD_ORDER, relay, cycle, (1, 3, 5)) == pytest.approx(expected, rel=1e-12)
