"""Pictures of recordings, spectra and comparisons, of results put together by hand."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex

import trimmer
from tests.trimmer import results
from tests.trimmer.drawing.blank import new_axes
from trimmer.drawing.look import LINES, colour
from trimmer.drawing.signals import comparison as of_comparison
from trimmer.drawing.signals import samples, spectrum
from trimmer.signals.quantity import Quantity
from trimmer.spectra.classification import Harmonic, LimitCycleLine, NaturalMode
from trimmer.spectra.harmonics import HarmonicFit


def assert_framed(axes: Axes) -> None:
    """Assert that there is a grid, and that units are no mathematics."""
    assert axes.xaxis.get_gridlines()[0].get_visible()
    assert not axes.yaxis.label.get_parse_math()


def lines_of(axes: Axes) -> dict[str, np.ndarray]:
    return {each.get_label(): each.get_xydata().T for each in axes.lines}


def test_few_samples_are_all_drawn() -> None:
    times = np.arange(samples.MOST_POINTS) * 0.5
    values = np.sin(times)
    assert samples.thinned(times, values)[0] is times


def test_blocks_keep_the_lowest_and_the_highest() -> None:
    # 8001 samples in blocks of 3 (2 per block of at most 8000 in all): 0 1 2 | 3 4 5 | ...
    values = np.tile([5.0, 7.0, 6.0], 2667)
    values[4] = -7.0
    times = 0.5 * np.arange(8001)
    kept, drawn = samples.thinned(times, values)
    assert kept[:5].tolist() == [0.0, 0.5, 2.0, 2.5, 3.0]  # in the second block 4 and 5
    assert drawn[:4].tolist() == [5.0, 7.0, -7.0, 6.0]
    assert kept[-1] == times[-1]
    assert kept.size == 2 * 2667 + 1


def test_signals_fill_the_width() -> None:
    signal = trimmer.Signal(np.array([1e-3, 3e-3, 2e-3]), 2.0, "stroke", "m")
    axes = signal.plot(new_axes())
    assert axes.get_xlim() == (0.0, 1.0)
    (curve,) = axes.lines
    assert curve.get_xydata().tolist() == [[0.0, 1e-3], [0.5, 3e-3], [1.0, 2e-3]]
    assert curve.get_color() == LINES[0]["color"]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time, s", "stroke, mm")


def test_the_lines_of_a_response_follow_in_order() -> None:
    axes = results.time_response().plot(new_axes())
    assert [each.get_color() for each in axes.lines] == [each["color"] for each in LINES[:2]]
    assert axes.get_xlim() == (0.0, pytest.approx(0.06))
    assert axes.get_xlabel() == "time, ms"
    assert axes.get_ylabel()
    assert len(axes.get_legend().get_texts()) == 2


def made_spectrum(amplitude: np.ndarray, bin_width: float = 0.5) -> SimpleNamespace:
    return SimpleNamespace(
        amplitude=amplitude,
        frequency=bin_width * np.arange(amplitude.size),
        bin_width=bin_width,
        window=SimpleNamespace(word="some"),
    )


def test_an_outline_has_the_largest_bin_of_each_block() -> None:
    amplitude = np.full(8004, 2e-3)  # the first is the mean; 8003 others, in blocks of 3
    amplitude[[0, 1, 5, 8003]] = 9.0, 1e-12, 4.0, 3.0
    frequency, largest = spectrum.outline(made_spectrum(amplitude), np.inf)
    assert frequency.size == 2668
    assert frequency[:3].tolist() == [0.5, 2.0, 3.5]
    assert largest[:3].tolist() == [2e-3, 4.0, 2e-3]
    assert (frequency[-1], largest[-1]) == (0.5 * 8002, 3.0)


def test_an_outline_ends_a_little_above_the_highest_peak() -> None:
    amplitude = np.linspace(1.0, 2.0, 200)
    frequency, drawn = spectrum.outline(made_spectrum(amplitude), 40.0)
    assert frequency[-1] == 0.5 * (1.25 * 80 + 8)
    np.testing.assert_array_equal(drawn, amplitude[1:109])
    assert spectrum.outline(made_spectrum(amplitude), 90.0)[0][-1] == 0.5 * 199


def test_what_is_nothing_beside_the_largest_is_at_its_floor() -> None:
    amplitude = np.array([0.0, 3.0, 1e-12, 0.0])
    np.testing.assert_allclose(spectrum.outline(made_spectrum(amplitude), np.inf)[1], [3.0, 3e-7, 3e-7])
    np.testing.assert_allclose(spectrum.outline(made_spectrum(0 * amplitude), np.inf)[1], 3 * [1e-7])


def test_a_spectrum_has_its_unit_if_that_is_known() -> None:
    made = made_spectrum(np.array([0.0, 3.0, 1.0]))
    axes = spectrum.draw_spectrum(made, new_axes(), "m")
    assert_framed(axes)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("frequency, Hz", "amplitude, m")
    assert axes.get_yscale() == "log"
    assert axes.get_title()
    assert spectrum.draw_spectrum(made, new_axes()).get_ylabel() == "amplitude"


def classified(frequency: float, amplitude: float, origin: object) -> SimpleNamespace:
    explanation = None if origin is None else SimpleNamespace(origin=origin)
    return SimpleNamespace(
        peak=SimpleNamespace(frequency=frequency, amplitude=amplitude, resolved=True), explanation=explanation
    )


def test_peaks_are_marked_by_what_they_may_be_and_the_largest_written() -> None:
    origins = [object.__new__(kind) for kind in (Harmonic, NaturalMode, LimitCycleLine)]
    # By falling amplitude; 100 and 103 are too close to be written both, the last is one too many.
    frequencies = [100.0, 103.0, 200.0, 300.0, 400.0, 500.0, 600.0, 700.0]
    kinds = [origins[0], origins[1], origins[2], None, *(4 * [origins[0]])]
    peaks = [
        classified(frequency, 1.0 / (number + 1), kind)
        for number, (frequency, kind) in enumerate(zip(frequencies, kinds, strict=True))
    ]
    made = made_spectrum(np.full(3000, 1e-3))
    axes = spectrum.draw_analysis(
        SimpleNamespace(peaks=peaks, spectrum=made, signal=SimpleNamespace(unit="m")), new_axes()
    )
    marked = lines_of(axes)
    assert marked["natural mode"].ravel().tolist() == [103.0, 0.5]
    assert marked["limit cycle"].ravel().tolist() == [200.0, 1 / 3]
    assert marked["unexplained"].ravel().tolist() == [300.0, 0.25]
    assert marked["harmonic of the drive"][0].tolist() == [100.0, 400.0, 500.0, 600.0, 700.0]
    colours = {each.get_label(): each.get_color() for each in axes.lines}
    names = ["harmonic of the drive", "natural mode", "limit cycle", "unexplained"]
    assert [colours[name] for name in names] == [colour(number) for number in range(4)]
    assert [text.get_text() for text in axes.texts] == ["100", "200", "300", "400", "500", "600"]
    assert [text.xy for text in axes.texts][:2] == [(100.0, 1.0), (200.0, 1 / 3)]
    assert {text.xyann for text in axes.texts} == {(0, 7)}
    low, high = axes.get_xlim()
    # To 8 bins above 1.25 of the highest, with a margin.
    assert (low, high) == pytest.approx((0.5 - 0.01 * 878.5, 879.0 + 0.01 * 878.5))
    bottom, top = np.log10(axes.get_ylim())
    assert (bottom, top) == (pytest.approx(-3 - 0.12 * 3), pytest.approx(0.12 * 3))
    assert len(axes.get_legend().get_texts()) == 4


def test_frequencies_are_apart_by_a_share_of_what_is_shown() -> None:
    axes = new_axes()
    axes.set_xlim(50.0, 150.0)
    peaks = [classified(frequency, 1.0, None) for frequency in (100.0, 106.5, 94.5, 112.0)]
    spectrum._write_frequencies(axes, SimpleNamespace(peaks=peaks))
    assert [text.get_text() for text in axes.texts] == ["100", "106.5"]


def test_no_peaks_show_the_whole_spectrum() -> None:
    made = made_spectrum(np.full(200, 1e-3))
    told = SimpleNamespace(peaks=[], spectrum=made, signal=SimpleNamespace(unit="m"))
    (curve,) = spectrum.draw_analysis(told, new_axes()).lines
    assert curve.get_xdata()[-1] == 99.5


def test_harmonics_stand_on_the_floor() -> None:
    coefficients = np.array([3j, 1e-9, -0.5, 4e-7])
    axes = spectrum.draw_harmonics(HarmonicFit(110.0, 0.0, coefficients, 0.0, 1.0), new_axes())
    (dots,) = axes.lines
    assert dots.get_xydata().tolist() == [[1.0, 3.0], [3.0, 0.5], [4.0, 4e-7]]
    (stems,) = axes.collections
    ends = [each[:, 1].tolist() for each in stems.get_segments()]
    assert ends == [pytest.approx([3e-7, each]) for each in (3.0, 0.5, 4e-7)]
    assert to_hex(stems.get_color()[0]) == colour(0)
    assert (axes.get_xlabel(), axes.get_yscale()) == ("order of the drive, 110 Hz", "log")
    assert axes.get_ylabel()
    ticks = axes.xaxis.get_major_locator().tick_values(1.0, 4.0)
    assert np.array_equal(ticks, np.round(ticks))


def test_harmonics_of_nothing_are_drawn_too() -> None:
    axes = spectrum.draw_harmonics(HarmonicFit(110.0, 0.0, np.zeros(2, complex), 0.0, 1.0), new_axes())
    assert not axes.lines[0].get_xydata().size


def test_the_density_leaves_out_the_mean_and_has_a_band_for_each_bin() -> None:
    made = SimpleNamespace(
        frequency=np.array([0.0, 1.0, 2.0]), density=np.array([9.0, 4.0, 1.0]), interval=(0.5, 3.0)
    )
    axes = spectrum.draw_averaged(made, new_axes())
    assert lines_of(axes)["density"].tolist() == [[1.0, 2.0], [4.0, 1.0]]
    (band,) = axes.collections
    corners = {tuple(each) for each in band.get_paths()[0].vertices.tolist()}
    assert corners == {(1.0, 2.0), (1.0, 12.0), (2.0, 0.5), (2.0, 3.0)}
    assert axes.get_xlabel() and axes.get_ylabel()
    assert axes.lines[0].get_color() == colour(0)


def made_comparison(values: np.ndarray) -> SimpleNamespace:
    signal = SimpleNamespace(values=values, sample_rate=1000.0, unit="m", quantity=Quantity.DISPLACEMENT)
    waveforms = np.array([0.0, 4e-3]), np.array([1e-3, 2e-3]), np.array([5e-3, 7e-3])
    return SimpleNamespace(
        signal=signal,
        frequencies=np.array([125.0, 250.0]),
        measured=np.array([3e-3j, 1e-3]),
        simulated=np.array([-2e-3, 4e-3 - 3e-3j]),
        period=8e-3,
        shift=2.5e-3,
        residual=0.125,
        waveforms=lambda: waveforms,
    )


def test_lines_are_drawn_over_the_measured_spectrum() -> None:
    values = 3e-3 * np.sin(2 * np.pi * 125 * np.arange(1600) / 1000.0) + 2e-3
    axes = of_comparison.draw_comparison(made_comparison(values), new_axes())
    drawn = lines_of(axes)
    assert drawn["its lines"].tolist() == [[125.0, 250.0], [3e-3, 1e-3]]
    assert drawn["simulated lines"].tolist() == [[125.0, 250.0], [2e-3, 5e-3]]
    whole = trimmer.amplitude_spectrum(values, 1000.0)
    frequency, amplitude = spectrum.outline(whole, 250.0)
    np.testing.assert_array_equal(drawn["measured"], [frequency, amplitude])
    bottom = max(0.3 * np.median(amplitude), 1e-7 * amplitude.max())
    assert axes.get_ylim()[0] == pytest.approx(bottom)
    assert_framed(axes)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("frequency, Hz", "amplitude, m")
    noisy = values + np.random.default_rng(3).normal(scale=1e-3, size=1600)
    axes = of_comparison.draw_comparison(made_comparison(noisy), new_axes())
    assert axes.get_ylim()[0] == pytest.approx(0.3 * np.median(lines_of(axes)["measured"][1]))


def test_samples_are_folded_into_a_period() -> None:
    values = np.arange(20.0) * 1e-3
    axes = of_comparison.draw_waveforms(made_comparison(values), new_axes())
    drawn = lines_of(axes)
    np.testing.assert_allclose(drawn["samples"][0], [*range(8), *range(8), *range(4)] * np.array(1e-3))
    np.testing.assert_allclose(drawn["samples"][1], values - 9.5e-3)
    assert drawn["measured lines"].tolist() == [[0.0, 4e-3], [1e-3, 2e-3]]
    assert drawn["simulated, shifted"].tolist() == [[0.0, 4e-3], [5e-3, 7e-3]]
    assert_framed(axes)
    assert axes.get_title() == "shifted by 2.5 ms; difference 12.5 % rms"
    assert (axes.get_xlabel(), axes.get_ylabel()) == (
        "time in the period, ms",
        "displacement about its mean, mm",
    )
    many = of_comparison.draw_waveforms(made_comparison(np.arange(4001.0)), new_axes())
    shown = lines_of(many)["samples"][1] + 2000.0
    assert (shown.size, shown[0], shown[-1]) == (2000, 0.0, 4000.0)
    assert set(np.diff(shown)) == {2.0, 3.0}


def test_spectra_stand_above_waveforms() -> None:
    figure = of_comparison.comparison_figure(made_comparison(np.arange(40.0)))
    assert tuple(figure.get_size_inches()) == (7.2, 6.8)
    above, below = figure.axes
    assert (above.get_xlabel()[:9], below.get_xlabel()[:4]) == ("frequency", "time")
