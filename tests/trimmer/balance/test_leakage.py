import math

import pytest

from tests.trimmer.balance.loops import GAP, THESIS_LOOP, THIRD_ORDER
from trimmer import Relay, ViscousBacklash, WrongTypeError, harmonic_leakage, limit_cycles, response_at


def test_leakage_of_a_relay_is_that_of_its_square_wave() -> None:
    relay = Relay(1.0)
    (cycle,) = limit_cycles(THIRD_ORDER, relay)

    def gain(omega: float) -> float:
        return 1 / (omega * math.hypot(omega, 1) * math.hypot(omega, 2))

    expected = [gain(n * cycle.omega) / gain(cycle.omega) / n for n in (1, 3, 5)]
    assert harmonic_leakage(THIRD_ORDER, relay, cycle, (1, 3, 5)) == pytest.approx(expected, rel=1e-12)


def test_leakage_is_that_at_the_amplitude_and_frequency_of_the_limit_cycle() -> None:
    load = ViscousBacklash(GAP, 3e-4)
    cycle = limit_cycles(THESIS_LOOP, load)[-1]

    def returned(n: int) -> float:
        gain = complex(load.describing_function(cycle.amplitude, cycle.omega, n))
        return abs(gain * complex(response_at(THESIS_LOOP, n * cycle.omega)))

    expected = [returned(n) / returned(1) for n in (3, 5, 7)]
    assert harmonic_leakage(THESIS_LOOP, load, cycle) == pytest.approx(expected, rel=1e-12)
    assert harmonic_leakage(THESIS_LOOP, load, cycle, ()) == ()


def test_what_is_no_harmonic_or_no_limit_cycle_is_named() -> None:
    relay = Relay(1.0)
    (cycle,) = limit_cycles(THIRD_ORDER, relay)
    with pytest.raises(ValueError, match=r"harmonics\[1\]"):
        harmonic_leakage(THIRD_ORDER, relay, cycle, (1, 0))
    with pytest.raises(WrongTypeError, match="cycle"):
        harmonic_leakage(THIRD_ORDER, relay, 3.0)
    with pytest.raises(WrongTypeError, match="harmonics"):
        harmonic_leakage(THIRD_ORDER, relay, cycle, 3)
