from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.balance.loops import FRICTION, GAP, THESIS_LOOP, s, simulate_play
from trimmer.balance.solve import limit_cycles
from trimmer.balance.stability import sine_of_crossing
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash

UNSTABLE, STABLE = limit_cycles(THESIS_LOOP, FRICTION)


@pytest.mark.parametrize("factor", [0.85, 1.2])
def test_a_simulation_returns_to_the_stable_limit_cycle(factor: float) -> None:
    end = simulate_play(THESIS_LOOP, GAP, factor * STABLE.amplitude, STABLE.omega, 0.12, 4e-6)
    assert end.amplitude == pytest.approx(STABLE.amplitude, rel=0.01)
    assert end.omega == pytest.approx(STABLE.omega, rel=0.001)


def test_a_simulation_leaves_the_unstable_limit_cycle_on_either_side() -> None:
    below = simulate_play(THESIS_LOOP, GAP, 0.9 * UNSTABLE.amplitude, UNSTABLE.omega, 0.1, 4e-6)
    above = simulate_play(THESIS_LOOP, GAP, 1.2 * UNSTABLE.amplitude, UNSTABLE.omega, 0.1, 4e-6)
    assert below.amplitude < 0.5 * UNSTABLE.amplitude
    assert above.amplitude > 1.5 * UNSTABLE.amplitude


def test_servo_with_backlash_has_an_outer_stable_limit_cycle() -> None:
    # Of two intersections with the outside of the locus beyond the larger amplitude, that one is stable.
    small, large = sorted(limit_cycles(10 / (s * (s + 1)), FrictionBacklash(1.0)), key=lambda c: c.amplitude)
    assert (small.stable, large.stable) == (False, True)


def test_sign_of_loebs_criterion_against_the_shift_of_a_pole() -> None:
    """G = 1/(s(s+1)^2) is unstable beyond N = 2; with an N that falls with amplitude the cycle is stable."""
    step = 1e-6

    def real_part(gain: float) -> float:
        return float(np.roots([1, 2, 1, gain]).real.max())

    rises_with_gain = real_part(2 + step) > real_part(2 - step)
    omega = 1.0
    response = 1 / (1j * omega * (1j * omega + 1) ** 2)
    by_omega = 2 * (1 / (1j * (omega + step) * (1j * (omega + step) + 1) ** 2) - response) / step
    by_amplitude = -1.0 * response
    assert rises_with_gain
    assert sine_of_crossing(by_amplitude, by_omega) > 0
    assert sine_of_crossing(-by_amplitude, by_omega) < 0
