"""Pictures of samples, spectra, fits and frequency responses: what is drawn is what the result holds."""

from __future__ import annotations

import control
import numpy as np
import pytest

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.pictures import FIGURES, new_axes, peaks, points
from trimmer.spectra.harmonics import HarmonicFit


def test_samples_are_drawn_over_time() -> None:
    signal = results.signal()
    axes = signal.plot(new_axes())
    (curve,) = axes.lines
    np.testing.assert_array_equal(curve.get_xdata(), signal.times)
    np.testing.assert_array_equal(curve.get_ydata(), signal.values)
    assert axes.get_ylabel() == "q2-q4, mm"
    assert axes.get_xlabel() == "time, s"


def test_the_outline_of_a_spectrum_has_its_highest_bin() -> None:
    spectrum = results.analysis().spectrum
    (curve,) = spectrum.plot(new_axes()).lines
    assert curve.get_ydata().max() == spectrum.amplitude.max()
    assert curve.get_xdata()[curve.get_ydata().argmax()] == 110.0


def test_the_bode_plot_is_that_of_the_system() -> None:
    summary = results.summary()
    upper, lower = FIGURES["linear"]().axes
    system = trimmer.transfer_function(summary.parameters, summary.output, summary.channels)
    frequency, level = upper.lines[0].get_data()
    expected = control.frequency_response(system, 2 * np.pi * frequency).complex
    np.testing.assert_allclose(level, 20 * np.log10(abs(expected)), atol=1e-6)
    phase = np.radians(lower.lines[0].get_ydata())
    np.testing.assert_allclose(np.exp(1j * phase), expected / abs(expected), atol=1e-6)
    (peaks,) = (each for each in upper.lines if each.get_label() == "peak")
    np.testing.assert_allclose(peaks.get_xdata(), [each.omega / (2 * np.pi) for each in summary.peaks])
    dotted = [each.get_xdata()[0] for each in upper.lines if each.get_linestyle() == ":"]
    np.testing.assert_allclose(dotted, [mode.frequency for mode in summary.modes])


def test_an_averaged_spectrum_has_its_confidence() -> None:
    spectrum = results.averaged()
    axes = spectrum.plot(new_axes())
    (density,) = axes.lines
    np.testing.assert_array_equal(density.get_ydata(), spectrum.density[1:])
    (band,) = axes.collections
    low, high = spectrum.interval
    reached = band.get_paths()[0].vertices[:, 1]
    assert reached.max() == pytest.approx(high * spectrum.density[1:].max())
    assert reached.min() == pytest.approx(low * spectrum.density[1:].min(), rel=1e-6, abs=0.0)


@pytest.mark.parametrize("count", [8000, 8001, 300_001])
def test_many_samples_keep_their_extremes(count: int) -> None:
    values = np.random.default_rng(1).normal(size=count)
    values[count // 3], values[count // 2] = 50.0, -60.0
    axes = trimmer.Signal(values, 1000.0).plot(new_axes())
    (kept, drawn) = axes.lines[0].get_data()
    assert kept.size == count if count == 8000 else 5000 < kept.size <= 8002
    assert (drawn.min(), drawn.max()) == (-60.0, 50.0)
    assert (np.diff(kept) > 0).all()
    np.testing.assert_array_equal(drawn, values[np.rint(kept * 1000).astype(int)])
    assert (kept[0], kept[-1]) == axes.get_xlim() == (0.0, (count - 1) / 1000)


def test_signals_of_a_response_are_drawn_by_their_names() -> None:
    system = control.ss(-np.eye(2), np.eye(2), np.eye(2), np.zeros((2, 2)))
    response = trimmer.linear.time_response(system, np.linspace(0, 1, 5), np.ones((2, 5)))
    axes = response.plot(new_axes())
    assert [each.get_label() for each in axes.lines] == ["input 1", "input 2", "output 1", "output 2"]
    for line, values in zip(axes.lines, response.named.values(), strict=True):
        np.testing.assert_array_equal(line.get_xydata().T, [response.time, values])


def test_each_peak_is_marked_once_and_the_largest_are_written_apart() -> None:
    analysis = peaks()
    axes = analysis.plot(new_axes())
    marked = {tuple(place) for line in axes.lines[1:] for place in line.get_xydata()}
    assert marked == {(each.peak.frequency, each.peak.amplitude) for each in analysis.peaks}
    assert sum(len(line.get_xdata()) for line in axes.lines[1:]) == len(analysis.peaks)
    places = [text.xy for text in axes.texts]
    assert places[0] == (analysis.peaks[0].peak.frequency, analysis.peaks[0].peak.amplitude)
    apart = np.diff(sorted(place[0] for place in places))
    assert apart.min() > 0.06 * np.ptp(axes.get_xlim())


@pytest.mark.parametrize("count", [8000, 8001, 30_000])
def test_an_outline_of_many_bins_has_the_largest_of_each_block(count: int) -> None:
    values = np.random.default_rng(2).normal(size=count)
    spectrum = trimmer.spectra.amplitude_spectrum(values, 1000.0)
    frequency, amplitude = spectrum.plot(new_axes()).lines[0].get_data()
    assert frequency.size == 4000 if count == 8000 else 2000 <= frequency.size <= 4000
    begins = np.searchsorted(spectrum.frequency, frequency)
    expected = np.maximum.reduceat(spectrum.amplitude, begins)
    np.testing.assert_array_equal(amplitude, expected)


def test_nothing_is_drawn_too() -> None:
    silent = trimmer.Signal(np.zeros(400), 1000.0, "x", "m")
    assert silent.plot(new_axes()).get_ylabel() == "x, mm"
    analysis = trimmer.analyse_signal(silent, 110.0)
    axes = analysis.plot(new_axes())
    assert axes.lines[0].get_xdata()[-1] == 500.0  # without a peak all is shown
    np.testing.assert_allclose(axes.lines[0].get_ydata(), 1e-7)
    assert analysis.harmonics.plot(new_axes()).lines[0].get_xydata().size == 0


def test_harmonics_above_the_floor_have_a_stem() -> None:
    fit = HarmonicFit(110.0, 0.0, np.array([3j, 1e-9, -0.5, 4e-7]), 0.0, 1.0)
    axes = fit.plot(new_axes())
    assert axes.lines[0].get_xydata().tolist() == [[1.0, 3.0], [3.0, 0.5], [4.0, 4e-7]]
    ends = [each[:, 1].tolist() for each in axes.collections[0].get_segments()]
    assert ends == [pytest.approx([3e-7, each]) for each in (3.0, 0.5, 4e-7)]
    ticks = axes.xaxis.get_major_locator().tick_values(1.0, 4.0)
    assert np.array_equal(ticks, np.round(ticks))


def test_samples_and_lines_are_drawn_over_each_other() -> None:
    comparison = results.comparison()
    axes, waveforms = FIGURES["overlay"]().axes
    measured, simulated = (points(axes, label).T for label in ("its lines", "simulated lines"))
    np.testing.assert_allclose(measured, [comparison.frequencies, abs(comparison.measured)])
    np.testing.assert_allclose(simulated, [comparison.frequencies, abs(comparison.simulated)])
    times, *both = comparison.waveforms()
    for label, values in zip(("measured lines", "simulated, shifted"), both, strict=True):
        np.testing.assert_array_equal(points(waveforms, label).T, [times, values])
    # Samples are the measured lines but for the line of 1e-5 m at 554.3 Hz, which is none of the drive's.
    folded, values = points(waveforms, "samples").T
    assert folded.max() < comparison.period
    assert abs(values - np.interp(folded, times, both[0], period=comparison.period)).max() < 1.1e-5


def test_a_fit_is_drawn_over_means_of_the_measurement_with_what_is_left() -> None:
    fit = results.fit()
    above, middle, below = FIGURES["fit"]().axes
    times, measured, simulated = fit.waveforms("stroke")
    np.testing.assert_array_equal(points(above, "fitted").T, [times, simulated])
    folded, means = above.lines[0].get_data()
    # Means of samples lie on the lines added up, but for the noise of a mean.
    assert folded.size == 200 and (np.diff(folded) > 0).all()
    assert abs(means - np.interp(folded, times, measured)).max() < 8e-6 / np.sqrt(4000 / 200) + 2e-6
    np.testing.assert_array_equal(middle.lines[0].get_ydata(), measured - simulated)
    noise = fit.measured.deviations[:, 0]
    (band,) = middle.patches
    assert [band.get_y(), band.get_height()] == pytest.approx(np.array([-2, 4]) * np.linalg.norm(noise))
    lines, fitted = fit.measured.lines[:, 0], fit.simulated[:, 0]
    wanted = {"measured": lines, "fitted": fitted, "left": lines - fitted, "noise, rms": np.sqrt(2) * noise}
    for label, values in wanted.items():
        np.testing.assert_array_equal(points(below, label).T, [fit.measured.frequencies, abs(values)])
