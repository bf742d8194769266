"""Multi-harmonic balance against exact orbits, closed forms, and forces summed over time."""

import itertools
import math

import numpy as np
import pytest

from tests.mechanisms.brute_force import BruteForce
from tests.mechanisms.dynamics import System
from trimmer import Body, ContactLaw, Force, Friction, Link, Mechanism, Pin, Play, Stop, forced_orbit
from trimmer.errors import UnsupportedMotionError
from trimmer.harmonics.balance import harmonic_balance_of

OMEGA = 8.0


def oscillator() -> Mechanism:
    return Mechanism(
        bodies={"body": Body(1.0)},
        frequency=OMEGA / (2.0 * np.pi),
        links={"spring": Link(("ground", "body"), 40.0, 0.1 * 40.0**0.5)},
        stops={"stop": Stop(("ground", "body"), 1000.0, 0.0, 10.0)},
        forces={"drive": Force("body", amplitude=100.0, phase=np.pi / 2.0)},
    )


def exact_coefficients(samples: int = 1024) -> np.ndarray:
    """Sample the orbit with an impact over its period, by an integrator of its own."""
    orbit = forced_orbit(oscillator(), guess={"body": (-25.0, 0.0)}, settling=120)
    motion = BruteForce().run(System(oscillator()), orbit.instant.state, 0.0, orbit.period)
    displacements = motion.states(orbit.period * np.arange(samples) / samples)[:, 0]
    coefficients = 2.0 * np.fft.rfft(displacements) / samples
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
    for count, begun in ((20, 0.1), (40, -1.9j)):  # From afar whole steps lead nowhere.
        guess = np.zeros((1, count), dtype=complex)
        guess[0, 1] = begun
        balance = harmonic_balance_of(mechanism, guess)
        assert balance.converged
        times = np.linspace(0.0, 2.0 * np.pi, 10_001)
        motion = np.exp(1j * np.multiply.outer(times, np.arange(count))) @ balance.coefficients[0]
        amplitudes.append(0.5 * np.ptp(motion.real))
    # The moment of reversal moves with the sum of 1/n² beyond the last harmonic.
    assert 2.0 * amplitudes[1] - amplitudes[0] == pytest.approx(1.927774517940, rel=3e-5)
    assert amplitudes[1] == pytest.approx(1.927774517940, rel=1e-3)


def two_bodies(**rest) -> Mechanism:
    return Mechanism(
        bodies={"hull": Body(2.0), "blade": Body(0.5)},
        frequency=3.0,
        pins={
            "base": Pin("ground", amplitude=0.3, phase=0.4, offset=0.1, order=2),
            "belt": Pin("hull", velocity=0.7),
        },
        links={
            "spring": Link(("base", "hull"), 50.0, 1.5),
            "between": Link(("hull", "blade"), 80.0, 0.6),
            "drag": Link(("belt", "blade"), 0.0, 0.9),
        },
        forces={
            "push": Force("blade", constant=4.0, amplitude=2.0, phase=-0.3, unbalance=0.01),
            "second": Force("hull", amplitude=5.0, phase=0.9, order=3),
        },
        **rest,
    )


DRIVE = 2.0 * math.pi * 3.0


def of_links(omega: float) -> np.ndarray:
    """Dynamic stiffness of both bodies, by hand."""
    s = 1j * omega
    inner, drag, outer = 80.0 + 0.6 * s, 0.9 * s, 50.0 + 1.5 * s
    return np.array(
        [[2.0 * s**2 + inner + drag + outer, -inner - drag], [-inner - drag, 0.5 * s**2 + inner + drag]]
    )


def driving(periods: int, count: int) -> np.ndarray:
    """Harmonics of what acts on both bodies at rest, (2, count), by hand."""
    forces = np.zeros((2, count), complex)
    # The belt, which the hull carries, drags the blade on and the hull back.
    forces[:, 0] = 50.0 * 0.1 - 0.9 * 0.7, 4.0 + 0.9 * 0.7
    forces[1, periods] = -1j * (2.0 + 0.01 * DRIVE**2) * np.exp(-0.3j)
    forces[0, 2 * periods] = (50.0 + 1.5j * 2.0 * DRIVE) * -1j * 0.3 * np.exp(0.4j)
    forces[0, 3 * periods] = -1j * 5.0 * np.exp(0.9j)
    return forces


def test_two_driven_bodies_are_solved_harmonic_by_harmonic() -> None:
    periods, count = 2, 8
    balance = harmonic_balance_of(two_bodies(), np.zeros((2, count), dtype=complex), periods)
    assert (balance.converged, balance.periods) == (True, 2)
    expected = np.column_stack(
        [
            np.linalg.solve(of_links(DRIVE / periods * n), force)
            for n, force in enumerate(driving(periods, count).T)
        ]
    )
    assert balance.coefficients == pytest.approx(expected, abs=1e-12)
    # What has an order beyond the last harmonic is left out.
    fewer = harmonic_balance_of(two_bodies(), np.zeros((2, 6), dtype=complex), periods)
    assert fewer.coefficients == pytest.approx(expected[:, :6], abs=1e-12)


def test_play_stop_and_friction_balance_with_inertia_and_springs() -> None:
    """Forces of a balanced motion, summed over fine samples, in each harmonic."""
    mechanism = two_bodies(
        plays={"play": Play(("base", "blade"), 30.0, 0.4, 0.2, ContactLaw.PULLING)},
        stops={"stop": Stop(("hull", "blade"), 90.0, 0.0, 0.05)},
        frictions={
            "rub": Friction(("belt", "blade"), 0.4, viscous=0.8),
            "free": Friction(("ground", "hull"), 0.2),
        },
    )
    count, periods, samples = 12, 1, 40_000
    without = harmonic_balance_of(two_bodies(), np.zeros((2, count), dtype=complex), periods)
    balance = harmonic_balance_of(mechanism, without.coefficients, periods)
    assert balance.converged
    q = balance.coefficients
    times = 2.0 * np.pi / DRIVE * np.arange(samples) / samples
    turns = np.exp(1j * np.outer(np.arange(count), DRIVE * times))
    hull, blade = (q @ turns).real
    hull_rate, blade_rate = ((1j * DRIVE * np.arange(count) * q) @ turns).real
    base = 0.1 + 0.3 * np.sin(2.0 * DRIVE * times + 0.4)
    base_rate = 0.6 * DRIVE * np.cos(2.0 * DRIVE * times + 0.4)
    s = blade - base
    beyond = np.where(s > 0.1, s - 0.1, np.where(s < -0.1, s + 0.1, 0.0))
    play = np.where(beyond != 0.0, 30.0 * beyond + 0.4 * (blade_rate - base_rate), 0.0)
    stop = 90.0 * np.maximum(blade - hull - 0.05, 0.0)
    slip = blade_rate - hull_rate - 0.7
    rub = 0.4 * np.sign(slip) + 0.8 * slip
    acting = np.array([-stop - rub + 0.2 * np.sign(hull_rate), play + stop + rub])
    harmonics = 2.0 * np.fft.rfft(acting)[:, :count] / samples
    harmonics[:, 0] *= 0.5
    linear = np.column_stack([of_links(DRIVE * n) @ q[:, n] for n in range(count)])
    assert linear + harmonics == pytest.approx(driving(periods, count), abs=2e-3)
    assert abs(harmonics[:, 1:]).max() > 0.5


def test_without_a_way_to_balance_the_search_ends() -> None:
    # Dry friction larger than the drive: the body sticks, which no polynomial does.
    mechanism = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=0.1,
        links={"spring": Link(("ground", "body"), 1.0)},
        forces={"drive": Force("body", amplitude=1.0)},
        frictions={"rub": Friction(("ground", "body"), 5.0)},
    )
    balance = harmonic_balance_of(mechanism, np.array([[0.0, -0.5j, 0.0, 0.1]]))
    assert not balance.converged
    # Beside the friction of 5 N the rest is small: relative to that it is never worse than where it began.
    assert 1e-3 < balance.residual < 2.0


def test_a_velocity_that_is_zero_all_the_time_has_no_turning_points() -> None:
    held = Mechanism(
        bodies={"held": Body(1.0), "body": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "body"), 100.0, 1.0), "tie": Link(("body", "held"), 10.0, 0.5)},
        frictions={"floor": Friction(("ground", "held"), 50.0)},
        forces={"push": Force("body", amplitude=5.0)},
    )
    assert not harmonic_balance_of(held, np.zeros((2, 4), dtype=complex)).converged


MOVING = Pin("ground", velocity=1.0)
BODY = {"body": Body(1.0)}


@pytest.mark.parametrize(
    ("mechanism", "told"),
    [
        (Mechanism(bodies=BODY, links={"spring": Link(("ground", "body"), 1.0)}), "frequency"),
        (
            Mechanism(
                bodies=BODY,
                frequency=1.0,
                pins={"belt": MOVING},
                links={"spring": Link(("belt", "body"), 1.0)},
            ),
            "moves on",
        ),
        (
            Mechanism(bodies=BODY, frequency=1.0, forces={"drive": Force("body", amplitude=1.0)}),
            "nothing holds body",
        ),
    ],
)
def test_what_cannot_be_balanced(mechanism: Mechanism, told: str) -> None:
    with pytest.raises(UnsupportedMotionError, match=told):
        harmonic_balance_of(mechanism, np.zeros((1, 3), dtype=complex))
