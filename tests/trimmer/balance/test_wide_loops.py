"""Loops with delays, many lags and all scales, of every element: what is called complete misses nothing."""

import math
from collections import Counter

import control
import mpmath
import numpy as np
import pytest

from tests.trimmer.balance.fuzz import Outcome, judged
from tests.trimmer.balance.wide_loops import Kind, wide_loop
from trimmer import ClosedLoop, CoulombFriction, Relay, harmonic_balance, limit_cycles


def crossings(system: control.TransferFunction) -> list[tuple[float, float]]:
    """Return omega and -G where G is real and negative, from its coefficients, with 120 digits."""
    with mpmath.workdps(120):
        numerator, denominator = (
            [mpmath.mpf(float(each)) for each in side[0][0][::-1]] for side in (system.num, system.den)
        )
        # Of num(j omega) conj(den(j omega)) the imaginary part, over omega, in omega squared.
        product = [mpmath.mpf(0)] * (len(numerator) + len(denominator) - 1)
        for i, above in enumerate(numerator):
            for k, below in enumerate(denominator):
                product[i + k] += above * below * (1 if (i - k) % 4 in (0, 1) else -1)
        squares = mpmath.polyroots(product[1::2][::-1], maxsteps=2000, extraprec=1500)
        found = []
        for square in squares:
            if square.real > 0 and abs(square.imag) < mpmath.mpf(10) ** -40 * abs(square):
                s = 1j * mpmath.sqrt(square.real)
                value = mpmath.polyval(numerator[::-1], s) / mpmath.polyval(denominator[::-1], s)
                if value.real < 0:
                    found.append((float(s.imag), float(-value.real)))
    return sorted(found)


DELAYED = control.tf(*control.pade(2.854, 2)) * control.tf([1], [1, 1, 0])
EXAMPLES = {
    "a delay of order 2 before 1/(s(s + 1))": (DELAYED, 0.4139),
    "18 lags": (control.tf([1], np.poly([-1.0] * 18)), 2.7475),
    "a delay of order 10 before two lags": (
        control.tf(*control.pade(1, 10)) * control.tf([1], [1, 2, 1]),
        36.33,
    ),
    "poles from -1 to -26": (control.tf([1], np.poly(-np.arange(1.0, 27.0))), 53.80),
}


@pytest.mark.parametrize("name", EXAMPLES)
def test_limit_cycles_behind_delays_and_many_lags_are_found(name: str) -> None:
    system, highest = EXAMPLES[name]
    balance = harmonic_balance(ClosedLoop(system, Relay(1.0)))
    expected = crossings(system)
    assert expected[-1][0] == pytest.approx(highest, rel=1e-3)
    assert [cycle.omega for cycle in balance.limit_cycles] == pytest.approx([each for each, _ in expected])
    amplitudes = [4.0 / math.pi * size for _, size in expected]
    assert [cycle.amplitude for cycle in balance.limit_cycles] == pytest.approx(amplitudes)
    assert balance.certificate.complete
    assert balance.certificate.outside_excluded
    assert balance.confirmed


def test_the_winding_number_has_a_range_of_its_own() -> None:
    """What it covers follows from the coefficients: it need not be what was searched."""
    for system in (DELAYED, EXAMPLES["18 lags"][0]):
        certificate = harmonic_balance(system, Relay(1.0)).certificate
        lowest, highest = certificate.winding_omegas
        assert certificate.winding_omegas != certificate.omegas
        assert lowest < crossings(system)[0][0]
        assert crossings(system)[-1][0] < highest
    given = harmonic_balance(DELAYED, Relay(1.0), omega_range=(0.1, 1.0)).certificate
    assert given.winding_omegas == given.omegas == (0.1, 1.0)


def test_slow_roots_are_found_beside_fast_ones() -> None:
    """1/((s + p)(s + 1)(s + q)) has its limit cycle at omega**2 = q (1 + p) + p: p makes no integrator."""
    slow = 1e-9
    system = control.tf([1.0], np.poly([-slow, -1.0, -1e9]))
    balance = harmonic_balance(system, Relay(1.0))
    (cycle,) = balance.limit_cycles
    assert cycle.omega == pytest.approx(math.sqrt(slow + 1e9 * (1.0 + slow)), rel=1e-9)
    assert balance.certificate.complete
    # Friction leads by a quarter turn: 1/((s + p)(s + 1)) lags by three quarters nowhere, by one at sqrt(p).
    (delayed,) = limit_cycles(control.tf([-1.0], np.poly([-slow, -1.0])), CoulombFriction(1.0))
    assert delayed.omega == pytest.approx(math.sqrt(slow), rel=1e-9)


def test_a_first_or_last_coefficient_that_is_rounding_is_a_doubt() -> None:
    """(s + 3)/(s + 1)**3 turns the phase by 0 in first order; one digit decides on a limit cycle far out."""
    for digit in (0.0, 1e-15, -1e-15):
        system = control.tf([1.0, 3.0 + digit], [1.0, 3.0, 3.0, 1.0])
        certificate = harmonic_balance(system, Relay(1.0)).certificate
        assert not certificate.outside_excluded or not certificate.complete


def outcomes(seed: int, places: range) -> Counter[Outcome]:
    """Judge loops; none is missed, false or crashes."""
    counts: Counter[Outcome] = Counter()
    for place in places:
        loop = wide_loop((seed, place))
        outcome, details = judged(loop)
        assert outcome in {Outcome.COMPLETE, Outcome.DOUBTS, Outcome.REFUSED}, (place, loop.kind, details)
        counts[outcome] += 1
    return counts


def test_no_limit_cycle_of_random_loops_is_missed() -> None:
    assert outcomes(23, range(50))[Outcome.COMPLETE] >= 40
    assert {wide_loop((23, place)).kind for place in range(50)} == set(Kind)


@pytest.mark.slow
@pytest.mark.parametrize("chunk", range(0, 2000, 300))
def test_no_limit_cycle_of_700_random_loops_is_missed(chunk: int) -> None:
    counts = outcomes(2000, range(chunk, chunk + 100))
    assert counts[Outcome.COMPLETE] >= 75
