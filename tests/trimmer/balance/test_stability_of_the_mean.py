"""Whether a limit cycle is called stable whose mean runs away: harmonic balance beside exact multipliers."""

from __future__ import annotations

import control
import numpy as np
import pytest

from trimmer import InertiaBacklash, LimitCycle, PeriodicOrbit, Relay, limit_cycles, periodic_orbits
from trimmer.elements.element import Element


def both(system: control.TransferFunction, element: Element) -> tuple[LimitCycle, PeriodicOrbit]:
    (cycle,) = limit_cycles(system, element)
    (orbit,) = (each for each in periodic_orbits(system, element) if each.prediction is not None)
    return cycle, orbit


def test_a_real_unstable_pole_of_the_loop_makes_a_relays_cycle_unstable() -> None:
    # 1 + N G = (s^2 + 1)(s - 0.5) at the limit cycle; the largest exact multiplier is 130.
    cycle, orbit = both(control.tf([1], [1, -0.5, 1, -1.5]), Relay(1.0))
    assert abs(orbit.multipliers).max() == pytest.approx(129.737, rel=1e-4)
    assert (cycle.stable, orbit.stable) == (False, False)


def test_a_mean_that_runs_away_makes_a_cycle_with_play_unstable() -> None:
    # The mean of the input passes a play with the gain 1, and 1 + G(s) has the real root p > 0, as G(0) < -1.
    numerator, denominator = [2.9, -1.0], np.polymul([1, 0.38, 1], [1, 0.8])
    (root,) = (each.real for each in np.roots(np.polyadd(numerator, denominator)) if each.imag == 0)
    cycle, orbit = both(control.tf(numerator, denominator), InertiaBacklash(1.0))
    assert abs(orbit.multipliers).max() == pytest.approx(np.exp(root * orbit.period), rel=1e-3)
    assert (cycle.stable, orbit.stable) == (False, False)
