"""Harmonic balance of several elements in one loop, beside exact orbits and the balance of one element."""

from itertools import pairwise

import control
import numpy as np
import pytest
import scipy.integrate

from tests.quick import quick
from trimmer import DeadZone, Feedback, FrictionBacklash, Relay, Saturation, WrongTypeError, periodic_orbits
from trimmer.balance import FeedbackBalance, harmonic_balance, limit_cycles
from trimmer.balance.many_harmonics.feedback import feedback_balance
from trimmer.elements import CoulombFriction, Element

# A positioner: amplifier, motor with friction, and a sensor with a lag, before which its gear may have play.
RATES = {"amplifier": [0, 4.0, 0], "rub": [0, -1.0, 0], "gear": [0, 0, 5.0]}
TAKEN = {"amplifier": [0, 0, -1.0], "rub": [0, 1.0, 0], "gear": [1.0, 0, 0]}


def positioner(**elements: Element) -> Feedback:
    sensor = [0.0, 0.0, -5.0] if "gear" in elements else [5.0, 0.0, -5.0]
    names = list(elements)
    plant = control.ss(
        [[0, 1, 0], [0, -1, 0], sensor],
        np.array([RATES[name] for name in names]).T,
        np.array([TAKEN[name] for name in names]),
        np.zeros((len(names), len(names))),
        inputs=names,
        outputs=names,
    )
    return Feedback(plant, elements)


LOOPS = {
    "relay and friction": positioner(amplifier=Relay(1.0), rub=CoulombFriction(0.05)),
    "saturation and play": positioner(amplifier=Saturation(0.3), gear=FrictionBacklash(0.2)),
}
THREE = positioner(amplifier=Saturation(0.3), gear=FrictionBacklash(0.2), rub=CoulombFriction(0.05))


def approaches(loop: Feedback, orders: tuple[int, ...], factor: float) -> None:
    """Check that predictions come the nearer to the exact orbit the more harmonics there are."""
    (exact,) = (each for each in periodic_orbits(loop) if each.stable)
    errors = []
    for order in orders:
        found = harmonic_balance(loop, (0.5, 20.0), order=order)
        assert isinstance(found, FeedbackBalance)
        motion = min(found.motions, key=lambda each: abs(each.period - exact.period))
        assert (motion.order, motion.residual < 1e-9) == (order, True)
        errors.append(abs(motion.period / exact.period - 1.0))
        size = motion.amplitudes[next(iter(loop.elements))]
        assert size == pytest.approx(exact.amplitude, rel=0.2 / order)
    assert all(later < factor * earlier for earlier, later in pairwise(errors))


@pytest.mark.parametrize("name", quick(LOOPS, 0))
def test_the_error_falls_with_the_order(name: str) -> None:
    approaches(LOOPS[name], (1, 3, 7), 0.5)


@pytest.mark.slow
def test_the_error_falls_with_the_order_of_three_elements() -> None:
    """What sticks makes it fall as one over the order at last."""
    approaches(THREE, (1, 5, 11, 31), 0.5)


def test_an_element_written_as_a_sum_of_multiples_balances_alike() -> None:
    written = positioner(amplifier=50 * Relay(0.01) + Relay(0.5), rub=2 * CoulombFriction(0.025))
    loops = (LOOPS["relay and friction"], written)
    (one,), (other,) = (feedback_balance(loop, (0.5, 20.0), order=1).motions for loop in loops)
    assert other.period == pytest.approx(one.period, rel=1e-9)
    assert other.amplitudes == pytest.approx(one.amplitudes, rel=1e-8)


def test_of_one_element_and_one_harmonic_it_is_the_prediction() -> None:
    # 4/(s (s + 1)^2) with a saturation: A = 2.4754 at 1 rad/s.
    plant = control.ss(control.tf([-4.0], [1, 2, 1, 0]), inputs=["limit"], outputs=["limit"])
    loop = Feedback(plant, {"limit": Saturation(1.0)})
    (motion,), (cycle,) = feedback_balance(loop, order=1).motions, harmonic_balance(loop).limit_cycles
    assert motion.omega == pytest.approx(cycle.omega, rel=1e-9)
    assert motion.amplitudes["limit"] == pytest.approx(cycle.amplitude, rel=1e-8)


def test_an_unstable_orbit_that_no_simulation_settles_on_is_found_with_its_multipliers() -> None:
    """Held against SciPy: it returns after the period, and small changes of the start grow as said."""
    A, B = np.array([[0.0, 1, 0], [-1, 0.35, 0], [0.6, 0, -1]]), np.array([[0, 0], [-0.8, -0.2], [0, 0.2]])
    C = np.array([[0, 1.0, 0], [0.5, 0.5, 0]])
    names = ["limit", "dead"]
    elements = {"limit": Saturation(1.0), "dead": DeadZone(0.7)}
    orbits = periodic_orbits(Feedback(control.ss(A, B, C, 0, inputs=names, outputs=names), elements))
    (orbit,) = orbits
    assert not orbit.stable
    assert "near 1 prediction of harmonic balance (order 15 from " in orbits.search.sentence

    def rates(_: float, state: np.ndarray) -> np.ndarray:
        limit, dead = C @ state
        return A @ state + B @ [np.clip(limit, -1.0, 1.0), dead - np.clip(dead, -0.7, 0.7)]

    def end(begin: np.ndarray) -> np.ndarray:
        span, settings = (0.0, orbit.period), {"rtol": 1e-11, "atol": 1e-12, "max_step": 0.02}
        return np.asarray(scipy.integrate.solve_ivp(rates, span, begin, "DOP853", **settings).y[:, -1])

    begin, steps = orbit.motion.state(0.0), 3e-3 * np.eye(3)
    assert end(begin) == pytest.approx(begin, abs=1e-7)
    own = np.linalg.eigvals(np.array([end(begin + step) - end(begin - step) for step in steps]) / 6e-3)
    # An end is off by up to 1e-7 where a step goes over a corner, whatever rtol is.
    assert sorted(own) == pytest.approx(sorted(orbit.multipliers.real), abs=1e-4)


def test_what_is_not_known_is_told() -> None:
    found = harmonic_balance(
        positioner(amplifier=Relay(1.0), rub=CoulombFriction(0.05, static=0.06)), order=1
    )
    assert isinstance(found, FeedbackBalance)
    assert "no certificate: others may exist, and whether these are stable is not told" in found.message
    assert "rub: what stick holds beyond the sliding force is left out" in found.message
    assert np.isnan(found.motions[0].change)
    assert len({f"{each.omega:.5e}" for each in found.motions}) == len(found.motions)
    lowest = 1.05 * found.motions[-1].omega
    assert harmonic_balance(found.loop, (lowest, 10.0 * lowest), order=1).motions == ()


def test_what_does_not_go_together_is_refused() -> None:
    loop = LOOPS["relay and friction"]
    for call, error, told in (
        (lambda: harmonic_balance(loop, order=4), ValueError, "order must be odd, not 4"),
        (lambda: harmonic_balance(loop, frozen_omega=1.0), ValueError, "frozen_omega is for one element"),
        (lambda: limit_cycles(loop), WrongTypeError, "several elements or frictions; harmonic_balance, per"),
        (
            lambda: harmonic_balance(positioner(amplifier=Relay(1.0)), order=3),
            ValueError,
            "order 3 is for several elements; multi_harmonic_balance",
        ),
    ):
        with pytest.raises(error, match=told):
            call()
