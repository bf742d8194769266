"""Pictures of fits that are put together by hand."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from tests.trimmer.drawing.blank import new_axes
from tests.trimmer.drawing.test_measured_signals import assert_framed, lines_of
from trimmer.drawing.look import LINES
from trimmer.drawing.signals import fit as of_fit
from trimmer.fitting.result import Fit
from trimmer.signals.quantity import Quantity


class MadeFit:
    """What is drawn of a fit, with two outputs of which the second is looked at."""

    period = 8e-3
    simulated = np.array([[9.0, -2e-3], [9.0, 4e-3 - 3e-3j]])
    waveforms = Fit.waveforms

    def __init__(self, values: np.ndarray, deviations: np.ndarray) -> None:
        signal = SimpleNamespace(values=values, sample_rate=1000.0, unit="m", quantity=Quantity.DISPLACEMENT)
        self.measured = SimpleNamespace(
            signals={"first": SimpleNamespace(**{**vars(signal), "unit": "m/s"}), "second": signal},
            outputs=["first", "second"],
            frequencies=np.array([125.0, 250.0]),
            lines=np.array([[8.0, 3e-3j], [8.0, 1e-3]]),
            deviations=deviations,
            periods=12.9,
            period_count=2,
        )


VALUES = np.array([1.0, 2.0, 4.0, 8.0, 1.0, 2.0, 4.0, 8.0, 3.0, 5.0])
DEVIATIONS = np.array([[7.0, 3e-5], [7.0, 4e-5]])


def test_samples_at_one_place_of_the_period_are_averaged() -> None:
    made = MadeFit(VALUES, DEVIATIONS)
    times, means = of_fit.averaged(made, "second")
    np.testing.assert_allclose(times, np.arange(8) * 1e-3)
    np.testing.assert_allclose(means, np.array([2.0, 3.5, 4.0, 8.0, 1.0, 2.0, 4.0, 8.0]) - 3.8)


def test_samples_of_one_bin_are_drawn_at_their_middle() -> None:
    made = MadeFit(VALUES, DEVIATIONS)
    made.period = 8.02e-3  # the last sample is then at 0.98 ms, in the bin of that at 1 ms
    times, means = of_fit.averaged(made, "second")
    np.testing.assert_allclose(times, np.array([0.0, 0.99, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]) * 1e-3)
    np.testing.assert_allclose(means, np.array([1.0, 3.5, 4.0, 8.0, 1.0, 2.0, 4.0, 8.0, 3.0]) - 3.8)


def test_a_fit_is_drawn_over_the_means_of_the_measurement() -> None:
    made = MadeFit(1e-3 * VALUES, DEVIATIONS)
    axes = of_fit.draw_waveform(made, "second", new_axes())
    (label, drawn), (_, fitted) = lines_of(axes).items()
    assert "6 periods" in label
    np.testing.assert_array_equal(drawn, of_fit.averaged(made, "second"))
    times = np.arange(400) * 2e-5
    expected = -2e-3 * np.cos(2 * np.pi * 125 * times)
    expected += 4e-3 * np.cos(2 * np.pi * 250 * times) + 3e-3 * np.sin(2 * np.pi * 250 * times)
    np.testing.assert_allclose(fitted, [times, expected], atol=1e-15)
    assert [each.get_color() for each in axes.lines] == ["#000000", LINES[1]["color"]]
    assert_framed(axes)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time in the period, ms", "second, displacement, mm")


def test_what_a_fit_leaves_is_drawn_over_its_noise() -> None:
    made = MadeFit(1e-3 * VALUES, DEVIATIONS)
    axes = of_fit.draw_rest(made, "second", new_axes())
    (curve,) = axes.lines
    times, measured, simulated = made.waveforms("second")
    np.testing.assert_array_equal(curve.get_xydata().T, [times, measured - simulated])
    (band,) = axes.patches
    assert [band.get_y(), band.get_height()] == pytest.approx([-1e-4, 2e-4])  # twice hypot(3e-5, 4e-5)
    assert_framed(axes)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time in the period, ms", "left, mm")


def test_lines_of_a_fit_are_drawn_over_their_noise() -> None:
    made = MadeFit(1e-3 * VALUES, DEVIATIONS)
    axes = of_fit.draw_lines(made, "second", new_axes())
    drawn = lines_of(axes)
    np.testing.assert_allclose(drawn["noise, rms"], [[125, 250], np.sqrt(2) * np.array([3e-5, 4e-5])])
    np.testing.assert_allclose(drawn["measured"][1], [3e-3, 1e-3])
    np.testing.assert_allclose(drawn["fitted"][1], [2e-3, 5e-3])
    left = [np.hypot(2e-3, 3e-3), np.hypot(3e-3, 3e-3)]
    np.testing.assert_allclose(drawn["left"], [[125, 250], left])
    assert axes.get_ylim()[0] == pytest.approx(0.1 * np.sqrt(2) * 3e-5)
    assert axes.get_yscale() == "log"
    assert_framed(axes)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("frequency, Hz", "amplitude, m")
    silent = of_fit.draw_lines(MadeFit(1e-3 * VALUES, 1e-20 * DEVIATIONS), "second", new_axes())
    assert silent.get_ylim()[0] == pytest.approx(3e-12, rel=1e-6, abs=0.0)


def test_each_output_of_a_fit_has_a_column() -> None:
    figure = of_fit.fit_figure(MadeFit(1e-3 * VALUES, DEVIATIONS))
    assert tuple(figure.get_size_inches()) == (13.2, 8.0)
    labels = [axes.get_ylabel() for axes in figure.axes]
    assert [label.split(",")[0] for label in labels[:4]] == ["first", "second", "left", "left"]
    assert figure.axes[0].get_gridspec().get_height_ratios() == (3, 1.4, 3)
    alone = MadeFit(1e-3 * VALUES, DEVIATIONS)
    alone.measured.outputs = ["first"]
    assert len(of_fit.fit_figure(alone).axes) == 3
