"""Harmonics by quadrature, differences of small arguments, and what elements without bounds say of them."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest

from trimmer.elements import quadrature, small_arguments
from trimmer.elements.bounds import constant_sensitivity, no_variation, range_shape, unlimited_domain
from trimmer.elements.dead_zone import DeadZone
from trimmer.elements.own_element import StaticElement
from trimmer.elements.quadrature import NODES, TO_ENDS, TO_OTHERS, WEIGHTS, harmonic_by_quadrature
from trimmer.elements.saturation import Saturation
from trimmer.elements.small_gains import SmallGains, real_small_gains, small_gains_of_backlash


def halves(output):
    """Return the outputs at phases and half a period later of an odd function of the phase."""
    return lambda phases: (output(phases), output(phases + math.pi))


def test_nodes_and_continuations_are_exact_for_polynomials() -> None:
    for power in range(23):
        exact = 2 / (power + 1) if power % 2 == 0 else 0.0
        assert WEIGHTS @ NODES**power == pytest.approx(exact, abs=1e-14)
    for power in (0, 1, 6):
        coarse, others = NODES[quadrature.COARSE] ** power, NODES[quadrature.OTHERS] ** power
        np.testing.assert_allclose(coarse @ TO_OTHERS, others, atol=1e-12)
        np.testing.assert_allclose(NODES**power @ TO_ENDS, [(-1.0) ** power, 1.0], rtol=1e-7)


@pytest.mark.parametrize("harmonic", [1, 3, 5])
def test_the_harmonics_of_a_sum_of_sines(harmonic: int) -> None:
    # For y = b sin(n theta + p) the factor is b exp(j p) / A.
    def output(phases: np.ndarray) -> np.ndarray:
        return 3.0 * np.sin(phases + 0.4) + 0.7 * np.sin(3 * phases - 0.9) + 0.2 * np.cos(5 * phases)

    expected = {1: 3.0 * np.exp(0.4j), 3: 0.7 * np.exp(-0.9j), 5: 0.2j}[harmonic] / 4e-5
    found = harmonic_by_quadrature(halves(output), 4e-5, harmonic)
    assert found.value == pytest.approx(expected, rel=1e-12)
    assert 0 < found.error < 1e-8 * abs(expected)
    assert found.odd == pytest.approx(0.0, abs=1e-14)


@pytest.mark.parametrize("breaks", [(), (0.3,), (0.3 - math.pi, math.nan)])
def test_a_square_wave_with_and_without_its_jumps(breaks: tuple[float, ...]) -> None:
    # sign(sin(theta - 0.3)) has 4 / (n pi) exp(-0.3 j n).
    for harmonic in (1, 3):
        found = harmonic_by_quadrature(
            halves(lambda phases: np.sign(np.sin(phases - 0.3))), 2.0, harmonic, breaks
        )
        expected = 4 / (harmonic * math.pi * 2.0) * np.exp(-0.3j * harmonic)
        assert found.value == pytest.approx(expected, rel=1e-12)
        assert abs(found.value - expected) <= found.error


def test_a_narrow_peak_is_not_overlooked() -> None:
    # Above cos(0.001) of the amplitude the output is one: 4 / pi sin(0.001).
    limit = math.cos(1e-3)

    def output(phases: np.ndarray) -> np.ndarray:
        return np.where(abs(np.sin(phases)) > limit, np.sign(np.sin(phases)), 0.0)

    found = harmonic_by_quadrature(halves(output), 1.0, 1)
    assert found.value == pytest.approx(4 / math.pi * math.sin(1e-3), rel=1e-9)


def test_what_is_not_odd_and_what_is_not_there() -> None:
    found = harmonic_by_quadrature(halves(lambda phases: np.sin(phases) + 0.5), 2.0, 1)
    assert found.odd == pytest.approx(1.0 / 1.5, rel=1e-3)
    assert found.value == pytest.approx(0.5)
    nothing = harmonic_by_quadrature(lambda phases: (phases, phases * math.nan), 2.0, 1)
    assert all(np.isnan([nothing.value, nothing.error, nothing.odd]))
    zero = harmonic_by_quadrature(halves(np.zeros_like), 2.0, 1)
    assert (zero.value, zero.odd) == (0, 0.0)


def test_first_panels_begin_and_end_at_the_half_period() -> None:
    cuts = quadrature._first_cuts(1, (0.3, 4.0, math.nan))
    assert (cuts[0], cuts[-1]) == (0.0, math.pi)
    assert (np.diff(cuts) > 0).all()
    assert {0.3, 4.0 - math.pi} <= set(cuts.tolist())
    assert np.diff(cuts).min() < 1e-4
    assert len(quadrature._first_cuts(3, ())) == len(quadrature._first_cuts(1, ())) + 4


SMALL_ARGUMENTS = {
    small_arguments.argument_less_sine: lambda x: x - mpmath.sin(x),
    small_arguments.sine_less_cosine_part: lambda x: mpmath.sin(x) - x * mpmath.cos(x),
    small_arguments.damped_excess_of_sinh: lambda x: 2 * mpmath.exp(-x) * (mpmath.sinh(x) - x),
}
REMAINDERS = {
    small_arguments.sine_remainder: lambda x: (x - mpmath.sin(x)) / x**3,
    small_arguments.cosine_remainder: lambda x: (mpmath.cos(x) - 1 + x**2 / 2) / x**4,
    small_arguments.decay_remainder: lambda x: (mpmath.exp(-x) - 1 + x) / x**2,
    small_arguments.decay_integral_remainder: lambda x: (1 - mpmath.exp(-x) - x + x**2 / 2) / x**3,
}


@pytest.mark.parametrize("function", SMALL_ARGUMENTS)
def test_differences_keep_their_digits(function) -> None:
    x = np.array([1e-6, 1e-3, 0.2, 0.25, 0.3, 1.0, 1.99, 2.0, 2.5, 3.0, 20.0])
    with mpmath.workdps(50):
        exact = [float(SMALL_ARGUMENTS[function](mpmath.mpf(each))) for each in x.tolist()]
    np.testing.assert_allclose(function(x), exact, rtol=2e-13)
    assert function(np.zeros(1)).tolist() == [0.0]


@pytest.mark.parametrize("function", REMAINDERS)
def test_remainders_keep_their_digits(function) -> None:
    x = np.array([1e-6, 1e-3, 0.1, 0.25])
    with mpmath.workdps(50):
        exact = [float(REMAINDERS[function](mpmath.mpf(each))) for each in x.tolist()]
    np.testing.assert_allclose(function(x), exact, rtol=4e-16)


def test_large_arguments() -> None:
    found = small_arguments.damped_excess_of_sinh(np.array([800.0, math.inf]))
    assert found.tolist() == [1.0, 1.0]


def test_elements_without_bounds_say_so_in_the_shape_of_what_is_asked() -> None:
    element = StaticElement(np.tanh)
    assert not element.has_bounds
    assert not element.depends_on_frequency
    u = (np.zeros((2, 1)), np.ones(3))
    for found in (element.sensitivity(u), element.variation(u)):
        assert [np.shape(each) for each in found] == [(2, 3), (2, 3)]
        assert all(np.isinf(each).all() for each in found)
    assert element.sensitivity((0.0, 1.0)).by_u == math.inf
    assert element.domain() == math.inf
    # An even harmonic of an odd element is nothing; the mean slope of tanh at small amplitudes is one.
    assert element.describing_function_estimate(1.0, harmonic=2).value == 0
    assert element.mean_gain(1e-4) == pytest.approx(1.0, rel=1e-6)
    for amplitude in ([1.0, 2.0], math.inf):
        with pytest.raises(ValueError, match="finite"):
            element.describing_function_estimate(amplitude)  # type: ignore[arg-type]


def test_shapes_of_bounds() -> None:
    assert range_shape((0.0, 1.0), None) == ()
    assert range_shape((np.zeros(3), 1.0), (np.zeros((2, 1)), 1.0)) == (2, 3)
    found = constant_sensitivity(2.0, 5.0, (np.zeros(3), 1.0), None)
    assert (found.by_u.tolist(), found.by_log_omega.tolist()) == ([2.0] * 3, [5.0] * 3)
    assert not any(np.any(each) for each in no_variation((np.zeros(3), 1.0), None))
    assert unlimited_domain(np.ones(2)).tolist() == [math.inf] * 2


@pytest.mark.parametrize("kind", [Saturation, DeadZone])
def test_bounds_of_corners_are_those_of_the_derivative(kind) -> None:
    # dN/du is 4 / pi slope cos(asin u) up or down.
    element, steepest = kind(4e-5, 691.0), 4 / math.pi * 691.0
    found = element.sensitivity((np.array([0.0, 0.6, 2.0]), 3.0))
    np.testing.assert_allclose(found.by_u, steepest * np.array([1.0, 0.8, 0.0]), rtol=1e-9, atol=1e-9)
    assert not found.by_log_omega.any()
    change = element.variation((np.array([0.0, 0.6, 1.5]), np.array([0.6, 1.0, 2.0])))
    np.testing.assert_allclose(change.by_u, steepest * np.array([0.2, 0.8, 0.0]), rtol=1e-9, atol=1e-9)
    assert (change.by_u > 0).all()
    assert not change.by_log_omega.any()
    assert (element.amplitude_scale, element.constant_from) == (4e-5, 1.0)


def test_small_gains() -> None:
    backlash = small_gains_of_backlash(0.02)
    assert (backlash.direction, backlash.lag, backlash.largest) == (-1j, 0.02, 0.003)
    assert backlash.scaled(-5.0) == SmallGains(1j, 5.0, 0.02)
    assert backlash.scaled(5.0).direction == -1j
    assert backlash.scaled(5.0).largest == 0.015
    real = real_small_gains(7.0)
    assert (real.direction, real.scale, real.lag, real.steepest, real.gentlest) == (1.0, 7.0, 0.0, 0.0, 0.0)
    assert real.largest == math.inf
