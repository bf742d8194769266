"""The parts of multi-harmonic balance by hand: waveforms, zeros, pieces, contacts, driven equations."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from trimmer.harmonics.balance import (
    BALANCED,
    Balance,
    _as_complex,
    _as_real,
    _Equations,
    harmonic_balance_of,
)
from trimmer.harmonics.crossings import crossings
from trimmer.harmonics.forces import Pieces, piecewise
from trimmer.harmonics.rubbing import friction_harmonics
from trimmer.harmonics.waveform import Decay, Waveform
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Link, Pin, Play, Stop

OMEGA = 691.0
BETWEEN = ("ground", "body")
TIMES = np.array([0.0, 0.3e-3, 4.1e-3])


def test_a_waveform_is_its_sum_less_a_decay() -> None:
    decay = Decay(0.2, 300.0, 1e-3)
    wave = Waveform(np.array([0.5, 1.0 - 2.0j, 0.3j]), OMEGA, decay)
    phase = OMEGA * TIMES
    fading = 0.2 * np.exp(-300.0 * (TIMES - 1e-3))
    plain = 0.5 + np.cos(phase) + 2.0 * np.sin(phase) - 0.3 * np.sin(2.0 * phase)
    rate = OMEGA * (-np.sin(phase) + 2.0 * np.cos(phase) - 0.6 * np.cos(2.0 * phase))
    assert wave.at(TIMES) == pytest.approx(plain - fading)
    assert wave.slope(TIMES) == pytest.approx(rate + 300.0 * fading)
    assert wave.period == pytest.approx(2.0 * math.pi / 691.0)
    assert wave.sharpness == pytest.approx(OMEGA**2 * (math.sqrt(5.0) + 4 * 0.3) + 300.0**2 * 0.2)
    shifted = wave.shifted(-0.7)
    assert shifted.at(TIMES) == pytest.approx(plain - fading - 0.7)
    assert wave.coefficients[0] == 0.5
    without = Waveform(wave.coefficients, OMEGA)
    assert without.at(TIMES) == pytest.approx(plain)
    assert without.slope(TIMES) == pytest.approx(rate)
    assert without.sharpness == pytest.approx(OMEGA**2 * (math.sqrt(5.0) + 1.2))
    negative = Waveform(wave.coefficients, OMEGA, Decay(-0.2, 300.0, 0.0))
    assert negative.sharpness == pytest.approx(wave.sharpness)


def test_all_zeros_between_two_times_are_found() -> None:
    sine = Waveform(np.array([0.0, 0.0, 0.0, -1j]), OMEGA)  # sin(3 omega t)
    step = math.pi / (3.0 * OMEGA)
    found = crossings(sine, 0.4 * step, 7.3 * step)
    assert found == pytest.approx(step * np.arange(1, 8), rel=1e-14)
    assert crossings(sine, 1.1 * step, 1.9 * step).size == 0
    assert crossings(Waveform(np.array([2.0, 1.0 + 0j]), OMEGA), 0.0, 1.0).size == 0
    fading = Waveform(np.array([0.5, 0.0]), OMEGA, Decay(1.0, 100.0, 0.0))
    assert crossings(fading, 0.0, 0.05) == pytest.approx([math.log(2.0) / 100.0], rel=1e-13)
    steep = Waveform(np.array([1e-3, 0.0]), OMEGA, Decay(1.0, 1e5, 0.0))
    assert crossings(steep, 0.0, 0.05) == pytest.approx([math.log(1e3) / 1e5], rel=1e-12)


def test_forces_on_two_pieces_are_integrated_in_closed_form() -> None:
    signal = Waveform(np.array([0.5, 1.0 - 2.0j]), OMEGA)
    period = signal.period
    # 3 s - 7 on a first piece, 3 s + 7 on a second; and the damper's 0.01 s'.
    factors = 3.0 + 0.01 * signal.turning
    pieces = Pieces(period * np.array([0.1, 0.6]), period * np.array([0.2, 0.9]), np.array([1.0, -1.0]))
    harmonics = piecewise(signal, factors, 7.0, pieces)
    expected = np.zeros(2, complex)
    for begin, end, sign in ((0.1, 0.2, 1.0), (0.6, 0.9, -1.0)):
        nodes, weights = np.polynomial.legendre.leggauss(30)
        times = period * (begin + 0.5 * (end - begin) * (1.0 + nodes))
        force = 3.0 * signal.at(times) + 0.01 * signal.slope(times) - sign * 7.0
        for n in range(2):
            share = (end - begin) * (0.5 if n == 0 else 1.0)
            expected[n] += share * (weights * force * np.exp(-1j * n * OMEGA * times)).sum()
    assert harmonics.coefficients == pytest.approx(expected, rel=1e-12)
    again = harmonics.direct @ signal.coefficients + harmonics.conjugate @ signal.coefficients.conj()
    constant = piecewise(signal, 0.0 * factors, 7.0, pieces).coefficients
    assert again.real == pytest.approx((expected - constant).real, rel=1e-12)
    assert again[1] == pytest.approx((expected - constant)[1], rel=1e-12)


def test_friction_of_a_sine_is_a_square_wave() -> None:
    # 2 sign(cos): 4/π cos x - 4/(3π) cos 3x, and a drift beyond the largest velocity is a constant.
    distance = Waveform(np.array([0.0, -1e-3j, 0.0, 0.0]), OMEGA)
    harmonics = friction_harmonics(distance, 0.0, 2.0)
    expected = np.array([0.0, 8.0 / math.pi, 0.0, -8.0 / (3.0 * math.pi)])
    assert harmonics.coefficients == pytest.approx(expected, abs=1e-12)
    assert friction_harmonics(distance, 0.8, 2.0).coefficients == pytest.approx(
        [2.0, 0.0, 0.0, 0.0], abs=1e-12
    )
    assert friction_harmonics(distance, -0.8, 2.0).coefficients[0] == pytest.approx(-2.0)
    # A drift of half of the largest velocity: positive for 2/3 of the period.
    half = friction_harmonics(distance, 0.5 * 1e-3 * OMEGA, 2.0)
    assert half.coefficients[0] == pytest.approx(2.0 / 3.0)
    assert half.coefficients[1] == pytest.approx(8.0 / math.pi * math.sin(2.0 * math.pi / 3.0))


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


def test_two_driven_bodies_are_solved_harmonic_by_harmonic() -> None:
    periods, count = 2, 8
    balance = harmonic_balance_of(two_bodies(), np.zeros((2, count), dtype=complex), periods)
    assert balance.converged
    assert balance.periods == 2
    expected = np.zeros((2, count), complex)
    base = 2.0 * math.pi * 3.0

    def solved(omega: float, on_hull: complex, on_blade: complex) -> np.ndarray:
        s = 1j * omega
        inner, drag, outer = 80.0 + 0.6 * s, 0.9 * s, 50.0 + 1.5 * s
        stiffness = np.array(
            [[2.0 * s**2 + inner + drag + outer, -inner - drag], [-inner - drag, 0.5 * s**2 + inner + drag]]
        )
        return np.linalg.solve(stiffness, np.array([on_hull, on_blade]))

    # At rest: the belt, which the hull carries, drags the blade on and the hull back.
    expected[:, 0] = solved(0.0, 50.0 * 0.1 - 0.9 * 0.7, 4.0 + 0.9 * 0.7)
    expected[:, 2] = solved(base, 0.0, -1j * (2.0 + 0.01 * base**2) * np.exp(-0.3j))
    pin = -1j * 0.3 * np.exp(0.4j)
    expected[:, 4] = solved(2.0 * base, (50.0 + 1.5j * 2.0 * base) * pin, 0.0)
    expected[:, 6] = solved(3.0 * base, -1j * 5.0 * np.exp(0.9j), 0.0)
    assert balance.coefficients == pytest.approx(expected, abs=1e-12)
    # What has an order beyond the last harmonic is left out.
    fewer = harmonic_balance_of(two_bodies(), np.zeros((2, 6), dtype=complex), periods)
    assert fewer.coefficients == pytest.approx(expected[:, :6], abs=1e-12)


def rubbing_bodies() -> Mechanism:
    return two_bodies(
        plays={"play": Play(("base", "blade"), 30.0, 0.4, 0.2, ContactLaw.PULLING)},
        stops={"stop": Stop(("hull", "blade"), 90.0, 0.0, 0.05)},
        frictions={
            "rub": Friction(("belt", "blade"), 1.2, viscous=0.8),
            "free": Friction(("ground", "hull"), 0.5),
        },
    )


def test_forces_act_on_both_their_ends() -> None:
    count, periods = 5, 2
    equations = _Equations(rubbing_bodies(), count, periods)
    random = np.random.default_rng(11)
    q = 0.2 * (random.normal(size=(2, count)) + 1j * random.normal(size=(2, count)))
    q[:, 0] = q[:, 0].real
    residual, slope = equations.imbalance(_as_real(q))
    without = _Equations(
        two_bodies(frictions={"rub": Friction(("belt", "blade"), 0.0, viscous=0.8)}), count, periods
    )
    linear, _ = without.imbalance(_as_real(q))
    samples = 40_000
    omega = 2.0 * math.pi * 3.0 / periods
    times = 2.0 * math.pi / omega * np.arange(samples) / samples
    turns = np.exp(1j * np.outer(np.arange(count), omega * times))
    hull, blade = (q @ turns).real
    hull_rate, blade_rate = ((1j * omega * np.arange(count) * q) @ turns).real
    base = 0.1 + 0.3 * np.sin(2.0 * 2.0 * math.pi * 3.0 * times + 0.4)
    base_rate = 0.3 * 12.0 * math.pi * np.cos(12.0 * math.pi * times + 0.4)
    s = blade - base
    beyond = np.where(s > 0.1, s - 0.1, np.where(s < -0.1, s + 0.1, 0.0))
    play = np.where(beyond != 0.0, 30.0 * beyond + 0.4 * (blade_rate - base_rate), 0.0)
    stop = 90.0 * np.maximum(blade - hull - 0.05, 0.0)
    rub = 1.2 * np.sign(blade_rate - hull_rate - 0.7)
    free = 0.5 * np.sign(hull_rate)
    on_hull, on_blade = -stop - rub + free, play + stop + rub
    expected = 2.0 * np.fft.rfft(np.array([on_hull, on_blade]))[:, :count] / samples
    expected[:, 0] *= 0.5
    found = _as_complex(residual - linear, (2, count))
    assert found == pytest.approx(expected, abs=2e-3)
    assert equations.scale == float(abs(equations.driving).max()) > 1.2
    step = 1e-6 * random.normal(size=20)
    step[10] = step[15] = 0.0  # the imaginary parts of the means
    ahead, behind = (equations.imbalance(_as_real(q) + sign * step)[0] for sign in (1.0, -1.0))
    assert slope @ step == pytest.approx(0.5 * (ahead - behind), abs=1e-9)


def test_viscous_friction_is_a_damper_between_its_ends() -> None:
    rubbing = _Equations(two_bodies(frictions={"rub": Friction(("belt", "blade"), 0.0, viscous=0.8)}), 5, 2)
    plain = two_bodies()
    drag = {**plain.links, "drag": Link(("belt", "blade"), 0.0, 0.9 + 0.8)}
    damped = _Equations(replace(plain, links=drag), 5, 2)
    assert rubbing.linear == pytest.approx(damped.linear)
    assert rubbing.driving == pytest.approx(damped.driving)
    assert rubbing.driving[1, 0] == pytest.approx(4.0 + 1.7 * 0.7)


def test_a_force_without_a_drive_sets_the_scale() -> None:
    free = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=1.0,
        links={"spring": Link(("ground", "body"), 40.0)},
        frictions={"rub": Friction(("ground", "body"), 0.3)},
    )
    assert _Equations(free, 3, 1).scale == 0.3
    bare = Mechanism(
        bodies={"body": Body(1.0)}, frequency=1.0, links={"spring": Link(("ground", "body"), 40.0)}
    )
    assert _Equations(bare, 3, 1).scale == 1.0


def test_a_balance_is_converged_up_to_its_limit() -> None:
    nothing = np.zeros((1, 2), complex)
    assert Balance(nothing, 1, BALANCED).converged
    assert not Balance(nothing, 1, 2.0 * BALANCED).converged


def test_coefficients_go_to_real_numbers_and_back() -> None:
    given = np.array([[1 + 2j, 3 + 4j], [5 + 6j, 7 + 8j]])
    assert _as_real(given).tolist() == [1, 3, 5, 7, 2, 4, 6, 8]
    assert _as_complex(_as_real(given), (2, 2)).tolist() == given.tolist()


def test_without_a_way_to_balance_the_search_ends_where_it_was() -> None:
    # Dry friction larger than the drive: the body sticks, which no polynomial does.
    mechanism = Mechanism(
        bodies={"body": Body(1.0)},
        frequency=0.1,
        links={"spring": Link(("ground", "body"), 1.0)},
        forces={"drive": Force("body", amplitude=1.0)},
        frictions={"rub": Friction(("ground", "body"), 5.0)},
    )
    guess = np.array([[0.0, -0.5j, 0.0, 0.1]])
    balance = harmonic_balance_of(mechanism, guess)
    assert not balance.converged
    first, _ = _Equations(mechanism, 4, 1).imbalance(_as_real(guess))
    assert balance.residual <= abs(first).max() / 5.0
