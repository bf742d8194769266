"""Saturation, dead zone, preload and relays with thresholds, beside quadrature in 32 digits and textbooks."""

import itertools

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


def output(element: Element, x: mpf, rising: bool) -> mpf:
    """What it gives for an input that rises or falls, from the definitions."""
    match element:
        case Saturation(threshold, slope):
            return slope * max(min(x, threshold), -threshold)
        case DeadZone(threshold, slope):
            return slope * (x - max(min(x, threshold), -threshold))
        case Preload(level, slope):
            return slope * x + (level if x > 0 else -level)
        case Relay(level, hysteresis, dead_zone):
            on, off = dead_zone + hysteresis, dead_zone - hysteresis
            if x > (on if rising else off):
                return level
            return -level if x < (-off if rising else -on) else 0.0
    raise AssertionError


def corners(element: Element) -> tuple[float, ...]:
    """Sizes of the input at which the output bends or jumps."""
    match element:
        case Relay(_, hysteresis, dead_zone):
            return dead_zone + hysteresis, abs(dead_zone - hysteresis)
        case Preload():
            return ()
    return (element.threshold,)  # type: ignore[attr-defined]


def by_quadrature(element: Element, amplitude: float, harmonic: int) -> mpc:
    """Integrate the output times exp(-jnθ) over the whole period, in pieces of at most about a turn each."""
    with mpmath.workdps(32):
        turn, total = mpmath.pi, mpc(0)
        places = [mpf(0), *(mpmath.asin(each / mpf(amplitude)) for each in corners(element))]
        cuts = {0.5 * turn, 1.5 * turn, 2 * turn}
        cuts.update(side for each in places for side in (each, turn - each, turn + each, 2 * turn - each))
        for start, end in itertools.pairwise(sorted(cuts)):
            middle = (start + end) / 2
            rising = mpmath.cos(middle) > 0
            level = output(element, amplitude * mpmath.sin(middle), rising)

            def turned(t: mpf, rising: bool = rising, level: mpf = level) -> mpc:
                # A relay gives one number in each piece, whatever rounding makes of its ends.
                x = amplitude * mpmath.sin(t)
                now = level if isinstance(element, Relay) else output(element, x, rising)
                return now * mpmath.expj(-harmonic * t)

            parts = mpmath.linspace(start, end, 2 + int(harmonic * (end - start) / 20))
            total += mpmath.quad(turned, parts, method="gauss-legendre")
        return 1j / (turn * amplitude) * total


@pytest.mark.parametrize("element", quick(ELEMENTS, 1, 2, 8), ids=repr)
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


@given(amplitude=amplitudes, harmonic=st.sampled_from([1, 3, 5, 31]))
def test_dead_zone_and_saturation_are_a_gain(amplitude: float, harmonic: int) -> None:
    total = (DeadZone(1.0, 0.7) + Saturation(1.0, 0.7)).describing_function(amplitude, harmonic=harmonic)
    assert total == pytest.approx(0.7 if harmonic == 1 else 0.0, abs=1e-15)


@given(amplitude=amplitudes, harmonic=st.sampled_from([1, 3, 5, 31]))
def test_a_preload_is_a_gain_and_a_relay(amplitude: float, harmonic: int) -> None:
    relay = Relay(0.7).describing_function(amplitude, harmonic=harmonic)
    preload = Preload(0.7, 0.2).describing_function(amplitude, harmonic=harmonic)
    assert preload == pytest.approx(relay + (0.2 if harmonic == 1 else 0.0), rel=1e-15)


@pytest.mark.parametrize("relay", RELAYS, ids=repr)
@settings(max_examples=20)
@given(amplitude=amplitudes)
def test_the_area_of_the_loops_is_the_imaginary_part(relay: Relay, amplitude: float) -> None:
    """The area of a loop over a period is -π A² Im N; both loops are 2 hysteresis wide and one level high."""
    area = 2 * (2 * relay.hysteresis) * relay.level
    if relay.hysteresis:
        value = complex(relay.describing_function(amplitude))
        assert value.imag * -np.pi * amplitude**2 == pytest.approx(area, rel=1e-9, abs=0.0)


@pytest.mark.parametrize("element", [*ELEMENTS, Relay(2.0)], ids=repr)
def test_the_mean_gain_is_the_slope_of_the_mean_output(element: Element) -> None:
    """The output over a period of a biased input, step by step."""
    amplitude, bias, steps = 1.7, 1e-2, 20_000
    phases = (np.arange(steps) + 0.5) * (2.0 * np.pi / steps)

    def mean(offset: float) -> float:
        given = (offset + amplitude * np.sin(phases)).tolist()
        rises = (np.cos(phases) > 0).tolist()
        return sum(output(element, x, rising) for x, rising in zip(given, rises, strict=True)) / steps

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
