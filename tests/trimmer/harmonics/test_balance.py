"""Multi-harmonic balance of the published oscillator with a stop against its exact orbit."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable

import numpy as np
import pytest

from tests.trimmer.branches.stop_oscillator import of_pyharm
from trimmer.branches.continuation import continuation
from trimmer.branches.settings import FollowSettings
from trimmer.errors import UnsupportedMotionError
from trimmer.harmonics import balance
from trimmer.harmonics.balance import harmonic_balance_of
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Force, Friction, Link, Pin, Stop

OMEGA = 8.0


def oscillator(damping: float = 0.1 * 40.0**0.5) -> Mechanism:
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=OMEGA / (2.0 * np.pi),
        links={"spring": Link(("ground", "body"), 40.0, damping)},
        stops={"stop": Stop(("ground", "body"), 1000.0, 0.0, 10.0)},
        forces={"drive": Force("body", amplitude=100.0, phase=np.pi / 2.0)},
    )


def exact_coefficients(samples: int = 1024) -> np.ndarray:
    """Follow the closed form to resonance and sample its last orbit."""
    map = of_pyharm()
    state = np.array([2.0, 0.0])
    for _ in range(60):
        state = map.passage(5.0, state).end
    state = continuation(map, state, 5.0, OMEGA, FollowSettings(switches=0)).points[-1].state
    piece_states = map.samples(OMEGA, state, samples)
    coefficients = 2.0 * np.fft.rfft(piece_states[0]) / samples
    coefficients[0] *= 0.5
    return np.asarray(coefficients)


def test_it_comes_closer_to_the_exact_orbit_with_each_harmonic() -> None:
    exact = exact_coefficients()
    distances = []
    for order in (3, 5, 9, 15, 25):
        balance = harmonic_balance_of(oscillator(), exact[None, : order + 1])
        assert balance.converged
        distances.append(abs(balance.coefficients[0] - exact[: order + 1]).max())
    assert all(later < 0.3 * earlier for earlier, later in itertools.pairwise(distances))
    assert distances[-1] < 1e-4


def test_a_linear_mechanism_is_solved_at_once() -> None:
    mechanism = Mechanism(
        bodies={"body": Body(2.0)},
        frequency=1.0,
        pins={"base": Pin("ground", amplitude=0.3, phase=0.4, offset=0.1)},
        links={"spring": Link(("base", "body"), 50.0, 1.5)},
    )
    balance = harmonic_balance_of(mechanism, np.zeros((1, 4), dtype=complex))
    omega = 2.0 * np.pi
    stiffness = 50.0 + 1.5j * omega
    first = stiffness / (stiffness - 2.0 * omega**2) * 0.3 * np.exp(0.4j) / 1j
    assert balance.coefficients[0] == pytest.approx(np.array([0.1, first, 0.0, 0.0]), abs=1e-14)


def test_sliding_friction_against_den_hartog() -> None:
    # Den Hartog 1931: r = 0.7, b = 0.2; x k/P = 1.927774517940 with no stop in the motion.
    mechanism = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=0.7 / (2.0 * np.pi),
        links={"spring": Link(("ground", "body"), 1.0)},
        forces={"drive": Force("body", amplitude=1.0)},
        frictions={"rubbing": Friction(("ground", "body"), 0.2)},
    )
    amplitudes = []
    for count in (30, 60):
        guess = np.zeros((1, count), dtype=complex)
        guess[0, 1] = -1.9j
        balance = harmonic_balance_of(mechanism, guess)
        assert balance.converged
        times = np.linspace(0.0, 2.0 * np.pi, 10_001)
        motion = np.exp(1j * np.multiply.outer(times, np.arange(count))) @ balance.coefficients[0]
        amplitudes.append(0.5 * np.ptp(motion.real))
    # The moment of reversal moves with the sum of 1/n² beyond the last harmonic.
    assert 2.0 * amplitudes[1] - amplitudes[0] == pytest.approx(1.927774517940, rel=1e-5)
    assert amplitudes[1] == pytest.approx(1.927774517940, rel=5e-4)


def test_what_cannot_be_balanced() -> None:
    free = Mechanism(bodies={"body": Body(1.0)}, links={"spring": Link(("ground", "body"), 1.0)})
    with pytest.raises(UnsupportedMotionError, match="frequency"):
        harmonic_balance_of(free, np.zeros((1, 3), dtype=complex))
    pulled = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=1.0,
        pins={"belt": Pin("ground", velocity=1.0)},
        links={"spring": Link(("belt", "body"), 1.0)},
    )
    with pytest.raises(UnsupportedMotionError, match="moves on"):
        harmonic_balance_of(pulled, np.zeros((1, 3), dtype=complex))


class Stubborn:
    """Equations of one unknown that are given by hand, and where they were evaluated."""

    scale = 2.0

    def __init__(self, residual: Callable[[float], float], slope: Callable[[float], float]) -> None:
        self.residual, self.slope = residual, slope
        self.asked: list[float] = []

    def imbalance(self, unknowns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        x = float(unknowns[0])
        self.asked.append(x)
        return np.array([self.residual(x), 0.0]), np.diag([self.slope(x), 1.0])


def test_a_step_that_goes_too_far_is_halved(monkeypatch: pytest.MonkeyPatch) -> None:
    """Newton's method for atan x = 0 diverges from 3 in full steps; a quarter of the first one helps."""
    equations = Stubborn(math.atan, lambda x: 1.0 / (1.0 + x**2))
    monkeypatch.setattr(balance, "_Equations", lambda *given: equations)
    found = harmonic_balance_of(None, np.array([[3.0 + 0j]]), 7)
    step = 10.0 * math.atan(3.0)
    assert equations.asked[:4] == pytest.approx([3.0, 3.0 - step, 3.0 - step / 2.0, 3.0 - step / 4.0])
    assert found.coefficients[0, 0] == pytest.approx(0.0, abs=1e-14)
    assert (found.periods, found.converged) == (7, True)


def test_after_eight_halvings_the_search_ends_where_it_was(monkeypatch: pytest.MonkeyPatch) -> None:
    equations = Stubborn(lambda x: -3.0, lambda x: 1.0)
    monkeypatch.setattr(balance, "_Equations", lambda *given: equations)
    found = harmonic_balance_of(None, np.array([[5.0 + 0j]]))
    assert equations.asked == [5.0, *(5.0 + 3.0 * 0.5**k for k in range(8))]
    assert (found.coefficients[0, 0], found.residual, found.periods) == (5.0, 1.5, 1)
