"""The picture of a fit."""

from __future__ import annotations

import numpy as np

from tests.trimmer import results
from trimmer.drawing.signals.fit import averaged, fit_figure


def test_the_picture_shows_what_was_measured_and_fitted() -> None:
    fit = results.fit()
    above, middle, below = fit_figure(fit).axes
    measured, fitted = above.get_lines()
    waveforms = fit.waveforms("stroke")
    np.testing.assert_allclose(fitted.get_ydata(), waveforms[2])
    times, means = averaged(fit, "stroke")
    np.testing.assert_allclose(measured.get_ydata(), means)
    # Means of samples lie on the lines added up, but for the noise of a mean.
    apart = means - np.interp(times, *waveforms[:2])
    assert abs(apart).max() < 8e-6 / np.sqrt(4000 / 200) + 2e-6
    assert middle.get_ylabel().startswith("left") and below.get_yscale() == "log"
