"""Whether limit cycles are stable: exact orbits beside them, and closed-loop poles where the mean drifts."""

import control
import numpy as np
import pytest

from tests.trimmer.balance.loops import FRICTION, THESIS_LOOP, s
from trimmer import LimitCycle, PeriodicOrbit, limit_cycles, periodic_orbits
from trimmer.elements import Element, FrictionBacklash, InertiaBacklash, Relay, StaticElement


def test_servo_with_backlash_has_an_outer_stable_limit_cycle() -> None:
    # Of two intersections with the outside of the locus beyond the larger amplitude, that one is stable.
    small, large = sorted(limit_cycles(10 / (s * (s + 1)), FrictionBacklash(1.0)), key=lambda c: c.amplitude)
    assert (small.stable, large.stable) == (False, True)


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_at_one_frequency_the_smaller_limit_cycle_comes_first_in_any_unit_of_time() -> None:
    """Without memory all lie where G is real, at sqrt(2) of the unit; rounding parts their frequencies."""
    element = StaticElement(lambda x: np.clip(x, -3, 3) - np.clip(x, -1, 1), scale=1.0, kinks=(1.0, 3.0))
    for unit in np.sqrt([0.01, 10.0]):
        found = limit_cycles(20 / ((s / unit) * (s / unit + 1) * (s / unit + 2)), element)
        assert [each.stable for each in found] == [False, True]
        assert found[0].amplitude < found[1].amplitude
        assert [each.omega for each in found] == pytest.approx([unit * np.sqrt(2.0)] * 2, rel=1e-12)


def test_the_limit_cycles_of_the_trimmer_are_as_stable_as_the_exact_orbits_beside_them() -> None:
    for cycle in limit_cycles(THESIS_LOOP, FRICTION):
        (orbit,) = periodic_orbits(THESIS_LOOP, FRICTION, [cycle])
        assert (orbit.amplitude, 2 * np.pi / orbit.period) == pytest.approx(
            (cycle.amplitude, cycle.omega), rel=5e-3
        )
        assert orbit.stable == cycle.stable


def both(system: control.TransferFunction, element: Element) -> tuple[LimitCycle, PeriodicOrbit]:
    (cycle,) = limit_cycles(system, element)
    (orbit,) = periodic_orbits(system, element, [cycle])
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


@pytest.mark.parametrize("seed", range(8))
def test_other_unstable_poles_are_those_of_the_closed_loop(seed: int) -> None:
    """Of 1 + N G at the limit cycle, but for those at +-j omega; a relay passes the mean with N/2."""
    random = np.random.default_rng(seed)
    poles = [-0.3, *(complex(random.uniform(-1.0, 0.3), w) for w in random.uniform(0.5, 4.0, 2))]
    denominator = np.real(np.poly([*poles, *np.conj(poles[1:])]))
    system = control.tf([random.choice([-1.0, 1.0])], denominator)
    for cycle in limit_cycles(system, Relay(1.0)):
        gain = Relay(1.0).describing_function(cycle.amplitude).real
        swinging = np.roots(np.polyadd(denominator, gain * system.num[0][0]))
        beside = swinging[abs(swinging - 1j * np.sign(swinging.imag) * cycle.omega) > 1e-6 * cycle.omega]
        mean = np.roots(np.polyadd(denominator, 0.5 * gain * system.num[0][0]))
        growing = beside[(beside.real > 1e-9) & (beside.imag > 0)].size
        drifting = mean[(mean.real > 1e-9) & (abs(mean.imag) < 1e-9)].size
        assert cycle.other_unstable_poles == growing + drifting
        assert cycle.stable == (cycle.index == 1 and growing + drifting == 0)
