"""Averaged spectra against SciPy, Parseval and repeated trials."""

import numpy as np
import pytest
from scipy import signal as scipy_signal
from scipy.stats import chi2, ncx2

from tests.quick import quick
from trimmer import Signal
from trimmer.signals import SignalError
from trimmer.spectra import Window, averaged_spectrum
from trimmer.spectra.averaged import line_interval

RATE = 1000.0
TIMES = np.arange(8000) / RATE
RNG = np.random.default_rng(0)
NOISE = RNG.normal(size=8000)
VALUES = 3.0 + NOISE + 0.5 * np.cos(2 * np.pi * 110.3 * TIMES)


@pytest.mark.parametrize("window", Window)
def test_density_is_that_of_segments_averaged_by_hand(window: Window) -> None:
    averaged = averaged_spectrum(Signal(VALUES, RATE, "a", "m"), 8, window)
    segment = averaged.segment
    weights = scipy_signal.windows.general_cosine(segment, window.value, sym=False)
    begins = range(0, VALUES.size - segment + 1, segment - segment // 2)
    power = np.zeros(segment // 2 + 1)
    for begin in begins:
        part = VALUES[begin : begin + segment]
        power += np.abs(np.fft.rfft((part - part.mean()) * weights)) ** 2
    power *= 2.0 / (len(begins) * RATE * (weights @ weights))
    power[0] /= 2.0
    if segment % 2 == 0:
        power[-1] /= 2.0
    assert averaged.averages == len(begins) >= 8
    np.testing.assert_allclose(averaged.density, power, rtol=1e-9, atol=1e-12 * power.max())
    assert averaged.noise_bandwidth == pytest.approx(
        RATE * (weights @ weights) / weights.sum() ** 2, rel=1e-9
    )


@pytest.mark.parametrize("window", Window)
@pytest.mark.parametrize("place", quick([100.0, 100.25, 100.5, 99.7], 2))
def test_a_line_between_bins_has_its_amplitude_and_frequency(window: Window, place: float) -> None:
    times = np.arange(9000) / RATE
    segment = averaged_spectrum(Signal(times, RATE), 8).segment
    frequency = place * RATE / segment
    values = 0.25 * np.cos(2 * np.pi * frequency * times + 1.0)
    line = averaged_spectrum(Signal(values, RATE), 8, window).lines(1)[0]
    assert line.amplitude == pytest.approx(0.25, rel=4e-3 if window is Window.RECTANGULAR else 1e-3)
    assert line.frequency == pytest.approx(frequency, abs=0.02 * RATE / segment)


@pytest.mark.slow
def test_nine_of_ten_intervals_and_more_hold_the_line() -> None:
    rng = np.random.default_rng(3)
    held, widths = 0, []
    for trial in range(80):
        values = rng.normal(size=4000) + 0.25 * np.cos(2 * np.pi * 110.3 * TIMES[:4000] + trial)
        lines = averaged_spectrum(Signal(values, RATE), 10).lines(5)
        near = [line for line in lines if abs(line.frequency - 110.3) < 2.0]
        assert near
        held += near[0].interval[0] <= 0.25 <= near[0].interval[1]
        widths.append(near[0].interval[1] - near[0].interval[0])
    assert held >= 70  # 76 are expected, with a standard deviation of 1.9
    assert np.mean(widths) < 0.25


def test_scatter_of_noise_is_that_of_the_equivalent_averages() -> None:
    rng = np.random.default_rng(4)
    averaged = [averaged_spectrum(Signal(rng.normal(size=4000), RATE), 12) for _ in range(60)]
    densities = np.array([each.density[5:-5] for each in averaged])
    share = densities.var() / densities.mean() ** 2
    assert 1.0 / share == pytest.approx(averaged[0].equivalent_averages, rel=0.05)
    low, high = averaged[0].interval
    truth = 2.0 / RATE
    assert np.mean((densities * low <= truth) & (truth <= densities * high)) == pytest.approx(0.95, abs=0.01)


@pytest.mark.parametrize(("power", "averages"), [(0.1, 4.0), (1.5, 4.0), (30, 4), (900, 20), (1e6, 3.0)])
def test_ends_of_an_interval_are_those_of_the_noncentral_distribution(power: float, averages: float) -> None:
    low, high = line_interval(power, 1.0, averages)
    seen, freedom = 2 * averages * power, 2 * averages
    alone = chi2.sf(seen, freedom)
    assert (low > 0, high > 0) == (alone < 0.025, alone < 0.975)
    if high > 0:
        assert ncx2.cdf(seen, freedom, 2 * averages * high) == pytest.approx(0.025, abs=2e-3)
    if low > 0:
        assert ncx2.sf(seen, freedom, 2 * averages * low) == pytest.approx(0.025, abs=2e-3)
    assert line_interval(power, 0.0, averages) == (power, power)


def test_noise_alone_has_hardly_ever_a_line() -> None:
    rng = np.random.default_rng(5)
    noise = [Signal(rng.normal(size=4000), RATE) for _ in range(25)]
    assert sum(len(averaged_spectrum(each, 10).lines(9)) for each in noise) <= 2


def test_stretches_are_averaged_together_and_short_ones_left_out() -> None:
    parts = [Signal(VALUES[:3000], RATE), Signal(VALUES[3000:3100], RATE), Signal(VALUES[3100:], RATE)]
    averaged = averaged_spectrum(parts, 10)
    assert (averaged.left_out, averaged.averages >= 10) == (100, True)
    segment, total = averaged.segment, np.zeros_like(averaged.density)
    for values in (parts[0].values, parts[2].values):
        welch = scipy_signal.welch(values, RATE, Window.HANN.samples(segment), noverlap=segment // 2)[1]
        total += ((values.size - segment) // (segment - segment // 2) + 1) * welch
    np.testing.assert_allclose(averaged.density, total / averaged.averages, rtol=1e-9)


def test_what_cannot_be_averaged_is_refused() -> None:
    with pytest.raises(SignalError, match="1000 Hz in m, 1000 Hz in no unit"):
        averaged_spectrum([Signal(VALUES, RATE), Signal(VALUES, RATE, "a", "m")])
    with pytest.raises(SignalError, match="too few for 9 averages"):
        averaged_spectrum(Signal(VALUES[:40], RATE), 9)
    with pytest.raises(SignalError, match="no signal to average"):
        averaged_spectrum([])
