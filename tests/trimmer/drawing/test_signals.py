"""Pictures of samples, spectra, fits and frequency responses: what is drawn is what the result holds."""

import numpy as np
import pytest

import trimmer
from tests.trimmer.drawing.pictures import new_axes


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
