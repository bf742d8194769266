import numpy as np
import pytest

from trimmer.signals.sampling import SPLINE_ERROR, resampled, trusted_band


@pytest.mark.parametrize("seed", range(5))
def test_lines_in_the_trusted_band_are_as_exact_as_it_says(seed: int) -> None:
    rng = np.random.default_rng(seed)
    times = np.cumsum(rng.uniform(0.4e-3, 1.6e-3, 2000))
    band = trusted_band(times)
    for share in (0.3, 1.0):
        frequency, phase = share * band.highest, rng.uniform(0, 6)
        made = resampled(times, np.cos(2 * np.pi * frequency * times + phase), 1000.0)
        at = times[0] + np.arange(made.size) / 1000.0
        inside = slice(20, -20)
        error = np.abs(made - np.cos(2 * np.pi * frequency * at + phase))[inside].max()
        assert error < SPLINE_ERROR * share**4
    beyond = 3 * band.highest
    made = resampled(times, np.cos(2 * np.pi * beyond * times), 1000.0)
    at = times[0] + np.arange(made.size) / 1000.0
    assert np.abs(made - np.cos(2 * np.pi * beyond * at))[20:-20].max() > SPLINE_ERROR
