"""Pictures of samples, spectra, harmonics and frequency responses."""

from __future__ import annotations

import control
import numpy as np
import pytest

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.blank import new_axes
from trimmer.drawing.frequency_response import summary_figure
from trimmer.drawing.signals.comparison import comparison_figure
from trimmer.drawing.signals.samples import MOST_POINTS, thinned


def test_samples_are_drawn_over_time() -> None:
    signal = results.signal()
    axes = signal.plot(new_axes())
    (curve,) = axes.lines
    np.testing.assert_array_equal(curve.get_xdata(), signal.times)
    np.testing.assert_array_equal(curve.get_ydata(), signal.values)
    assert axes.get_ylabel() == "q2-q4, mm"
    assert axes.get_xlabel() == "time, s"


def test_many_samples_keep_their_extremes() -> None:
    values = np.random.default_rng(1).normal(size=300_001)
    values[123_456], values[200_000] = 50.0, -60.0
    times = np.arange(values.size) * 1e-3
    kept, drawn = thinned(times, values)
    assert kept.size <= 2 * MOST_POINTS
    assert (drawn.min(), drawn.max()) == (-60.0, 50.0)
    assert (np.diff(kept) > 0).all()
    np.testing.assert_array_equal(drawn, values[np.searchsorted(times, kept)])
    assert (kept[0], kept[-1]) == (times[0], times[-1])


def test_inputs_and_outputs_of_a_response_are_drawn() -> None:
    response = results.time_response()
    axes = response.plot(new_axes())
    given, answer = axes.lines
    np.testing.assert_array_equal(given.get_ydata(), 1.0)
    np.testing.assert_allclose(answer.get_ydata(), 1 - np.exp(-100 * response.time), atol=1e-9)


def test_several_outputs_are_numbered() -> None:
    system = control.ss(-np.eye(2), np.eye(2), np.eye(2), np.zeros((2, 2)))
    response = trimmer.time_response(system, np.linspace(0, 1, 5), np.ones((2, 5)))
    labels = [line.get_label() for line in response.plot(new_axes()).lines]
    assert labels == ["input 1", "input 2", "output 1", "output 2"]
    assert response.to_dataframe().columns[-1] == "state 2"


def test_peaks_are_marked_where_they_are_with_their_explanation() -> None:
    analysis = results.analysis()
    axes = analysis.plot(new_axes())
    marked = {each.get_label(): each.get_xydata() for each in axes.lines[1:]}
    assert set(marked) == {"harmonic of the drive", "limit cycle"}
    peaks = {(each.peak.frequency, each.peak.amplitude) for each in analysis.peaks}
    assert {tuple(place) for places in marked.values() for place in places} == peaks
    assert [text.get_text() for text in axes.texts] == ["110", "554.3"]
    assert axes.get_ylabel() == "amplitude, m"


def test_texts_at_peaks_are_apart() -> None:
    times = np.arange(4000) / 4000.0
    values = sum(np.sin(2 * np.pi * frequency * times) for frequency in (100.0, 110.0, 900.0))
    analysis = trimmer.analyse_signal(trimmer.Signal(values, 4000.0))
    places = sorted(float(text.get_text()) for text in analysis.plot(new_axes()).texts)
    assert len(analysis.peaks) == 3
    assert places in ([100.0, 900.0], [110.0, 900.0])


def test_the_outline_of_a_spectrum_has_its_highest_bin() -> None:
    spectrum = results.analysis().spectrum
    (curve,) = spectrum.plot(new_axes()).lines
    assert curve.get_ydata().max() == spectrum.amplitude.max()
    assert curve.get_xdata()[curve.get_ydata().argmax()] == 110.0


def test_harmonics_have_their_orders() -> None:
    fit = results.analysis().harmonics
    axes = fit.plot(new_axes())
    (dots,) = axes.lines
    assert dots.get_xdata()[0] == 1
    assert dots.get_ydata()[0] == pytest.approx(1e-3, rel=1e-6)


def test_the_bode_plot_is_that_of_the_system() -> None:
    summary = results.summary()
    upper, lower = summary_figure(summary).axes
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


def test_measured_and_simulated_lines_are_drawn_over_each_other() -> None:
    comparison = results.comparison()
    axes, waveforms = comparison_figure(comparison).axes
    lines = {each.get_label(): each.get_xydata().T for each in axes.lines}
    np.testing.assert_allclose(lines["its lines"], [comparison.frequencies, abs(comparison.measured)])
    np.testing.assert_allclose(lines["simulated lines"], [comparison.frequencies, abs(comparison.simulated)])
    (measured,) = (each for each in waveforms.lines if each.get_label() == "measured lines")
    np.testing.assert_allclose(np.ptp(measured.get_ydata()) / 2, 1e-3, rtol=1e-2)
    assert waveforms.get_xlabel() == "time in the period, ms"


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
