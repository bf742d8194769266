"""Lines of averaged spectra: where one begins, which side lobes are none, what noise is beside it."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from trimmer.signals import Band, Signal, SignalError
from trimmer.spectra import AveragedSpectrum, Window, averaged_spectrum
from trimmer.spectra.averaged import line_interval

RATE = 2000.0
MEDIAN = 1.0 / (1.0 - 2.0 / 90.0) ** 3
"""Mean over median of chi-squared with 10 degrees of freedom, by Wilson and Hilferty."""


def averaged(density: list[float] | np.ndarray, **rest) -> AveragedSpectrum:
    """Bins 2 Hz apart, of segments of twice as many samples, as 5 independent segments would give."""
    values = np.array(density, float)
    given = {"window": Window.HANN, "segment": 2 * (values.size - 1), "averages": 9, "left_out": 0} | rest
    return AveragedSpectrum(2.0 * np.arange(values.size), values, equivalent_averages=5.0, **given)


def flat(**bins: float) -> np.ndarray:
    density = np.ones(201)
    for name, value in bins.items():
        density[int(name.removeprefix("at"))] = value
    return density


@pytest.mark.parametrize(
    ("density", "trusted", "places"),
    [
        (flat(at50=30, at120=90, at160=2), Band(), [240, 100]),
        (flat(at2=30, at50=40, at120=90, at199=50), Band(), [240, 398, 100, 4]),
        (flat(at2=30, at50=40, at120=90, at199=50), Band(100.0, 240.0), [240, 100]),
        (flat(at50=30, at120=90), Band(101.0, 239.0), []),
        # Below the main lobe of the mean, and at half the sample rate, nothing is looked for.
        (flat(at1=90, at200=90), Band(), []),
        (np.zeros(201), Band(), []),
        # Only the top of a broad peak counts; two equal bins hold a line between them.
        (flat(at80=90, at81=60, at82=40), Band(), [160]),
        (flat(at80=40, at81=60, at82=90), Band(), [164]),
        (flat(at80=30, at81=30), Band(), [161]),
        # The first side lobe of Hann, 0.0267 of a larger line, is none.
        (flat(at100=1e8, at103=1e8 * 0.056**2), Band(), [200, 206]),
        (flat(at97=1e8 * 0.020**2, at100=1e8, at103=1e8 * 0.020**2), Band(), [200]),
    ],
)
def test_lines_are_bins_above_the_noise_by_falling_amplitude(density, trusted: Band, places) -> None:
    lines = averaged(density, trusted=trusted).lines(9)
    assert [line.frequency for line in lines] == pytest.approx(places, abs=1.0)
    assert averaged(density, trusted=trusted).lines(1) == lines[:1]


@pytest.mark.parametrize(("share", "count"), [(0.99, 0), (1.01, 1)])
def test_one_in_a_hundred_spectra_of_noise_has_a_line(share: float, count: int) -> None:
    factor = chi2.isf(0.01 / 198, 10) / 10 * MEDIAN
    assert len(averaged(flat(at80=share * factor)).lines(9)) == count


@pytest.mark.parametrize(
    ("place", "below", "above"),
    [
        (100, range(60, 99), range(102, 140)),
        (20, range(1, 19), range(22, 60)),
        (190, range(150, 189), range(192, 201)),
    ],
)
@pytest.mark.parametrize("colour", [0, 2])
def test_noise_is_the_median_of_forty_bins_on_either_side(place: int, below, above, colour: int) -> None:
    """What is left of a line that is not far above it, and its interval, say how large the noise is."""
    density = 1.0 + np.sqrt(np.arange(201.0))
    level = np.median(density[[*below, *above]]) * MEDIAN * (place**4 if colour else 1.0)
    density[place - 1 : place + 2] = 9.0 * density[place] * np.array([0.25, 1.0, 0.25])
    density = density * np.arange(201.0) ** (2 * colour)
    (line,) = averaged(density, colour=colour).lines(1)
    power, noise = 3.0 * density[place], 3.0 * level
    assert line.amplitude == pytest.approx(math.sqrt(2.0 * (power - noise)), rel=4e-3)
    ends = line_interval(power, noise, 5.0)
    assert line.interval == pytest.approx([math.sqrt(2.0 * each) for each in ends], rel=4e-3)


def test_an_averaged_spectrum_keeps_what_its_signal_was_and_refuses_what_cannot_be_squared() -> None:
    values = np.random.default_rng(1).normal(size=400)
    kept = {"converted": -2, "trusted": Band(1.0, 90.0)}
    parts = [Signal(each, RATE, **kept) for each in (values, values[:100], values[:30])]
    given = averaged_spectrum(parts, 4, "blackman-harris")
    assert (given.window, given.colour, given.trusted) == (Window.BLACKMAN_HARRIS, -2, Band(1.0, 90.0))
    assert given.left_out == sum(size for size in (400, 100, 30) if size < given.segment) > 0
    assert given.frequency == pytest.approx(np.arange(given.segment // 2 + 1) * RATE / given.segment)
    assert repr(given).endswith(f"{given.averages} segments, blackman-harris window>")
    # 16 samples are the fewest of a segment.
    assert averaged_spectrum(Signal(values[:16], RATE), 1).segment == 16
    with pytest.raises(SignalError, match="15 samples are too few"):
        averaged_spectrum(Signal(values[:15], RATE), 1)
    for scale in (1e-141, 1e141):
        with pytest.raises(SignalError, match="cannot be squared"):
            averaged_spectrum([parts[0], replace(parts[0], values=scale * values)][scale < 1 :])
    with pytest.raises(ValueError, match="averages"):
        averaged_spectrum(parts, 0)
    with pytest.raises(ValueError, match="limit"):
        given.lines(0)
