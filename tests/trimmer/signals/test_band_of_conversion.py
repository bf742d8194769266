"""The band of a conversion, from limits and noise that are made by hand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from trimmer.signals.band import Band
from trimmer.signals.convert import _Limits
from trimmer.signals.noise_floor import Powers
from trimmer.signals.signal import Signal, SignalError

FREQUENCY = 10.0 * np.arange(1, 11)
SOURCE = Signal(np.zeros(4000), 1000.0, "x", "m/s")
WHOLE = Band(10.0, 100.0, "low", "high")


def limits(times: int, noise: list[float], source: Signal = SOURCE) -> _Limits:
    """Limits for a result whose variance is 1 in each bin, from 10 Hz to 100 Hz, with noise in it."""
    weight = (2 * np.pi * FREQUENCY) ** (-2.0 * times)
    return _Limits(source, times, Powers(FREQUENCY, weight, weight * np.array(noise)))


@pytest.mark.parametrize("times", [-2, -1, 1])
def test_powers_are_weighted_by_the_square_of_what_lines_are_multiplied_with(times: int) -> None:
    np.testing.assert_allclose(limits(times, [0.0] * 10).gain, abs((2j * np.pi * FREQUENCY) ** times) ** 2)


def test_noise_narrows_an_integrated_band_from_below() -> None:
    """From above noise adds up to 0.05 at 40 Hz, 0.1 at 30 Hz, ...; the flank reaches 0.75 of a frequency.

    At 60 Hz it is N(45) = 0.025 of 5, at 50 Hz N(37.5) = 0.0625 of 6, more than 1 %.
    """
    noisy = limits(-1, [0.05] * 4 + [0.0] * 6)
    narrowed = noisy._above_noise(WHOLE, True, True)
    assert (narrowed.lowest, narrowed.highest, narrowed.highest_reason) == (60.0, 100.0, "high")
    assert narrowed.lowest_reason not in ("", "low")
    assert noisy._above_noise(WHOLE, True, False) == narrowed
    assert noisy._above_noise(WHOLE, False, True) == WHOLE
    # Up to 80 Hz there is less in the band: N(45) = 0.025 of 3 at 60 Hz.
    lower = noisy._above_noise(replace(WHOLE, highest=80.0), True, True)
    assert (lower.lowest, lower.highest) == (60.0, 80.0)
    lower = noisy._above_noise(replace(WHOLE, highest=70.0), True, True)
    assert (lower.lowest, lower.highest) == (70.0, 70.0)


def test_noise_narrows_a_differentiated_band_from_above() -> None:
    """Noise adds up to 0.05 at 60 Hz, 0.1 at 70 Hz, ...; the flank reaches 1.125 of a frequency.

    At 50 Hz it is N(56.25) = 0.03125 of 5, at 60 Hz N(67.5) = 0.0875 of 6, more than 1 %.
    """
    noisy = limits(1, [0.0] * 5 + [0.05] * 5)
    narrowed = noisy._above_noise(WHOLE, True, True)
    assert (narrowed.lowest, narrowed.highest, narrowed.lowest_reason) == (10.0, 50.0, "low")
    assert narrowed.highest_reason not in ("", "high")
    assert noisy._above_noise(WHOLE, False, True) == narrowed
    assert noisy._above_noise(WHOLE, True, False) == WHOLE


@pytest.mark.parametrize("times", [-1, 1])
@pytest.mark.parametrize("noise", [0.0, 0.009, 0.5])
def test_noise_that_is_nothing_or_everything_bounds_no_band(times: int, noise: float) -> None:
    assert limits(times, [noise] * 10)._above_noise(WHOLE, True, True) == WHOLE


def test_ends_of_the_band_are_those_given_or_follow_from_the_record() -> None:
    """4 s at 1000 Hz: 8 times 3/(4 s) is 6 Hz; 1000 Hz/2.56 is 390.625 Hz."""

    def ends(times: int, *given: float | None, source: Signal = SOURCE) -> tuple[float, float]:
        band = limits(times, [0.0] * 10, source).band(*given)
        return band.lowest, band.highest

    assert ends(-1, None, None, None) == ends(-2, None, None, None) == (6.0, 390.625)
    assert ends(1, None, None, None) == (0.0, 390.625)
    assert ends(-1, 2.0, None, None) == (2.0, 390.625)
    assert ends(1, 20.0, 499.0, None) == (20.0, 499.0)
    assert ends(-1, None, None, 5.0) == ends(1, None, None, 5.0) == (15.0, 390.625)
    assert ends(-1, None, 300.0, 1.0) == (6.0, 300.0)
    assert ends(-1, 2.0, None, 5.0) == (2.0, 390.625)
    trusted = replace(SOURCE, trusted=Band(8.0, 90.0))
    assert ends(-1, None, None, None, source=trusted) == (8.0, 90.0)
    assert ends(-1, 30.0, 80.0, None, source=trusted) == (30.0, 80.0)


@pytest.mark.parametrize(
    "given",
    [
        (None, 500.0, None),
        (None, 0.0, None),
        (0.0, None, None),
        (390.625, None, None),
        (80.0, 80.0, None),
        (None, None, 0.0),
        (None, None, 500.0),
    ],
)
def test_frequencies_out_of_their_range_are_refused(given: tuple[float | None, ...]) -> None:
    with pytest.raises(SignalError, match="it must be above 0 Hz and below"):
        limits(-1, [0.0] * 10).band(*given)
