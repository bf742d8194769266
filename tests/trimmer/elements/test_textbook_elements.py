"""Saturation, dead zone, preload and relays with thresholds, beside quadrature in 32 digits and textbooks."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mpc, mpf

from tests.quick import quick
from trimmer.elements import DeadZone, Element, Preload, Relay, Saturation

POINTS = [
    (1.0 + 2.0**-40, 1),
    (1.0 + 2.0**-20, 3),
    (1.125, 1),
    (1.125, 3),
    (2.0, 99),
    (7.25, 5),
    (1e9, 1),
    (1e9, 3),
]
ELEMENTS = (
    Saturation(1.0, 0.5),
    DeadZone(1.0, 0.5),
    Preload(0.5, 0.25),
    Relay(2.0, hysteresis=1.0),
    Relay(2.0, dead_zone=1.0),
    Relay(2.0, hysteresis=0.25, dead_zone=0.75),
    Relay(2.0, hysteresis=0.75, dead_zone=0.25),
    Relay(2.0, hysteresis=0.5, dead_zone=0.5),
    Relay(2.0, hysteresis=2.0**-40, dead_zone=1.0 - 2.0**-40),
)
RELAYS = [element for element in ELEMENTS if isinstance(element, Relay)]
amplitudes = st.floats(-3, 3).map(lambda exponent: 1.0 + 10**exponent)


def law(element: Element, amplitude: mpf) -> tuple[list[mpf], Callable[[mpf], mpf]]:
    """Return phases from 0 to 2π between which the output is smooth, and the output, from the definitions."""
    pi = mpmath.pi
    match element:
        case Saturation(threshold, slope) | DeadZone(threshold, slope):
            corner = mpmath.asin(threshold / amplitude)

            def clipped(theta: mpf) -> mpf:
                x = amplitude * mpmath.sin(theta)
                inside = max(min(x, mpf(threshold)), -mpf(threshold))
                return slope * (inside if isinstance(element, Saturation) else x - inside)

            return [mpf(0), corner, pi - corner, pi + corner, 2 * pi - corner, 2 * pi], clipped
        case Preload(level, slope):
            return [
                mpf(0),
                pi,
                2 * pi,
            ], lambda t: slope * amplitude * mpmath.sin(t) + (level if t < pi else -level)
        case Relay(level, hysteresis, dead_zone):
            on, off = (mpf(dead_zone) + side * mpf(hysteresis) for side in (1, -1))
            start, end = mpmath.asin(on / amplitude), pi - mpmath.asin(off / amplitude)

            def switched(theta: mpf) -> mpf:
                # One period of which the first part is the end of the negative output, if off < 0.
                for turn in (0, 2 * pi):
                    if start <= theta + turn < end:
                        return mpf(level)
                    if start - pi <= theta - turn < end - pi or start + pi <= theta + turn < end + pi:
                        return mpf(-level)
                return mpf(0)

            places = [start, end, start + pi, end + pi]
            return sorted(
                {mpf(0), 2 * pi, *(place - 2 * pi if place > 2 * pi else place for place in places)}
            ), switched
    raise AssertionError


def by_quadrature(element: Element, amplitude: float, harmonic: int) -> mpc:
    """Integrate the output times exp(-jnθ) over the whole period, in pieces of at most about a turn each."""
    with mpmath.workdps(32):
        exact = mpf(amplitude)
        cuts, output = law(element, exact)
        total = mpc(0)
        for start, end in itertools.pairwise(cuts):
            parts = 1 + int(harmonic * (end - start) / 20)
            middle = (start + end) / 2
            level = output(middle) if isinstance(element, Relay) else None
            total += mpmath.quad(
                lambda t, level=level: (output(t) if level is None else level) * mpmath.expj(-harmonic * t),
                mpmath.linspace(start, end, parts + 1),
                method="gauss-legendre",
            )
        return 1j / (mpmath.pi * exact) * total


@pytest.mark.parametrize("element", quick(ELEMENTS, 1, 2, 5), ids=repr)
def test_every_harmonic_is_that_of_quadrature(element: Element) -> None:
    for amplitude, harmonic in POINTS:
        value = complex(element.describing_function(amplitude, harmonic=harmonic))
        exact = by_quadrature(element, amplitude, harmonic)
        error = float(abs(value - exact) / abs(exact))
        # A relay's harmonics turn with n times a phase, which is known to rounding.
        rounding = 3e-16 * harmonic * float(2 * 4 / (np.pi * amplitude * harmonic) / abs(exact))
        assert error < 1e-13 or (isinstance(element, Relay) and error < rounding), (amplitude, harmonic)


@pytest.mark.parametrize("element", [Saturation(1.0), DeadZone(1.0), Relay(1.0, dead_zone=1.0)], ids=repr)
def test_harmonics_next_to_the_threshold_keep_their_digits(element: Element) -> None:
    for amplitude, harmonic in ((1.0 + 2.0**-52, 3), (1.0 + 2.0**-40, 5), (1.0 + 2.0**-20, 101)):
        value = complex(element.describing_function(amplitude, harmonic=harmonic))
        exact = by_quadrature(element, amplitude, harmonic)
        assert abs(value - exact) < 1e-13 * abs(exact)


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
def test_the_waveform_has_the_harmonics_and_is_odd(element: Element) -> None:
    phases = (np.arange(20_000) + 0.5) * (2.0 * np.pi / 20_000)
    for amplitude in (1.3, 4.0):
        output = element.waveform(phases, amplitude)
        np.testing.assert_allclose(element.waveform(phases + np.pi, amplitude), -output, rtol=1e-6, atol=1e-9)
        for harmonic in (1, 2, 3, 7):
            summed = 2j * np.mean(output * np.exp(-1j * harmonic * phases)) / amplitude
            assert element.describing_function(amplitude, harmonic=harmonic) == pytest.approx(
                summed, abs=1e-3
            )


@pytest.mark.parametrize("element", [*ELEMENTS, Relay(2.0)], ids=repr)
@settings(max_examples=15)
@given(amplitude=amplitudes, size=st.floats(-6, 6).map(lambda exponent: 10**exponent))
def test_the_scale_of_the_input_only_scales(element: Element, amplitude: float, size: float) -> None:
    larger = {
        Saturation: lambda e: Saturation(size * e.threshold, e.slope / size),
        DeadZone: lambda e: DeadZone(size * e.threshold, e.slope / size),
        Preload: lambda e: Preload(e.level, e.slope / size),
        Relay: lambda e: Relay(e.level, size * e.hysteresis, size * e.dead_zone),
    }[type(element)](element)
    for harmonic in (1, 3):
        own = element.describing_function(amplitude, harmonic=harmonic)
        scaled = size * larger.describing_function(size * amplitude, harmonic=harmonic)
        assert scaled == pytest.approx(own, rel=1e-6, abs=1e-7)


@given(amplitude=amplitudes, harmonic=st.sampled_from([1, 3, 5, 31]))
def test_dead_zone_and_saturation_are_a_gain(amplitude: float, harmonic: int) -> None:
    total = (DeadZone(1.0, 0.7) + Saturation(1.0, 0.7)).describing_function(amplitude, harmonic=harmonic)
    assert total == pytest.approx(0.7 if harmonic == 1 else 0.0, abs=1e-15)


@given(amplitude=amplitudes, harmonic=st.sampled_from([1, 3, 5, 31]))
def test_a_preload_is_a_gain_and_a_relay(amplitude: float, harmonic: int) -> None:
    relay = Relay(0.7).describing_function(amplitude, harmonic=harmonic)
    preload = Preload(0.7, 0.2).describing_function(amplitude, harmonic=harmonic)
    assert preload == pytest.approx(relay + (0.2 if harmonic == 1 else 0.0), rel=1e-15)


@given(amplitude=amplitudes, harmonic=st.sampled_from([1, 3, 5]))
def test_narrow_thresholds_give_the_ideal_relay(amplitude: float, harmonic: int) -> None:
    ideal = Relay(3.0).describing_function(amplitude, harmonic=harmonic)
    for near in (Saturation(1e-9, 3e9), Relay(3.0, 1e-9), Relay(3.0, 0.0, 1e-9), Relay(3.0, 3e-10, 7e-10)):
        assert near.describing_function(amplitude, harmonic=harmonic) == pytest.approx(ideal, rel=1e-7)


@given(amplitude=amplitudes, harmonic=st.sampled_from([1, 3, 5]))
def test_a_narrow_hysteresis_or_dead_zone_changes_little(amplitude: float, harmonic: int) -> None:
    for close, limit in (
        (Relay(3.0, 1e-12, 0.5), Relay(3.0, 0.0, 0.5)),
        (Relay(3.0, 0.5, 1e-12), Relay(3.0, 0.5, 0.0)),
    ):
        exact = limit.describing_function(amplitude, harmonic=harmonic)
        assert close.describing_function(amplitude, harmonic=harmonic) == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("relay", RELAYS, ids=repr)
@settings(max_examples=20)
@given(amplitude=amplitudes)
def test_the_area_of_the_loops_is_the_imaginary_part(relay: Relay, amplitude: float) -> None:
    """The area of a loop over a period is -π A² Im N; both loops are 2 hysteresis wide and one level high."""
    area = 2 * (2 * relay.hysteresis) * relay.level
    if relay.hysteresis:
        value = complex(relay.describing_function(amplitude))
        assert value.imag * -np.pi * amplitude**2 == pytest.approx(area, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("element", ELEMENTS, ids=repr)
def test_the_mean_gain_is_the_slope_of_the_mean_output(element: Element) -> None:
    """The output over a period is computed from a biased input with the definitions, step by step."""
    amplitude, bias, steps = 1.7, 1e-2, 40_000
    phases = (np.arange(steps) + 0.5) * (2.0 * np.pi / steps)

    def mean(offset: float) -> float:
        given = offset + amplitude * np.sin(phases)
        match element:
            case Relay(level, hysteresis, dead_zone):
                on, off = dead_zone + hysteresis, dead_zone - hysteresis
                rising = np.cos(phases) > 0
                up = (given > on) | (~rising & (given > off))
                down = (given < -on) | (rising & (given < -off))
                return float(level * (up.mean() - down.mean()))
            case Preload(level, slope):
                return float((slope * given + level * np.sign(given)).mean())
            case Saturation(threshold, slope) | DeadZone(threshold, slope):
                inside = np.clip(given, -threshold, threshold)
                return float(slope * (inside if isinstance(element, Saturation) else given - inside).mean())
        raise AssertionError

    slope = (mean(bias) - mean(-bias)) / (2.0 * bias)
    assert element.mean_gain(amplitude) == pytest.approx(slope, rel=0.05, abs=0.02)


def test_below_the_threshold() -> None:
    for amplitude in (1e-9, 0.5, 1.0):
        assert Saturation(1.0, 0.5).describing_function(amplitude) == 0.5
        assert Saturation(1.0, 0.5).describing_function(amplitude, harmonic=3) == 0.0
        assert DeadZone(1.0, 0.5).describing_function(amplitude) == 0.0
        # The output is zero from any start, as each other one is left.
        for relay in (Relay(2.0, 0.0, 1.0), Relay(2.0, 0.25, 0.75), Relay(2.0, 0.5, 0.5)):
            assert relay.describing_function(amplitude) == 0.0
            assert relay.waveform(0.3, amplitude) == 0.0
        # The output stays what it was.
        for relay in (Relay(2.0, 1.0), Relay(2.0, 0.75, 0.25)):
            assert np.isnan(relay.describing_function(amplitude))
            assert np.isnan(relay.waveform(0.3, amplitude))
            assert relay.domain() == 1.0


def test_infinite_amplitudes_give_the_limits() -> None:
    assert Saturation(1.0).describing_function(np.inf) == 0.0
    assert DeadZone(1.0, 0.5).describing_function(np.inf) == pytest.approx(0.5, rel=1e-15)
    assert Preload(1.0, 0.5).describing_function(np.inf) == 0.5
    for relay in RELAYS:
        assert relay.describing_function(np.inf) == 0.0
        assert np.isfinite(relay.describing_function(1e300))


def test_values_that_textbooks_print() -> None:
    """Gelb and Vander Velde give 0.6090 for saturation at δ/A = 0.5; Slotine and Li its other half."""
    assert Saturation(1.0).describing_function(2.0).real == pytest.approx(0.6090, abs=5e-5)
    assert DeadZone(1.0).describing_function(2.0).real == pytest.approx(1 - 0.6090, abs=5e-5)
    # The largest N of a relay with dead zone is 2 D / (π δ), at A = √2 δ (Atherton 1975, chapter 3).
    relay = Relay(1.0, dead_zone=1.0)
    largest = relay.describing_function(np.sqrt(2.0)).real
    assert largest == pytest.approx(2.0 / np.pi, rel=1e-15)
    assert relay.describing_function([1.40, 1.43]).real.max() < largest
