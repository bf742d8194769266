"""The weighting of hand-arm vibration against the published table, and of motions that are known."""

import numpy as np
import pytest

from trimmer.design import hand_arm_weighting

PUBLISHED = {
    6.3: 0.727, 8: 0.873, 10: 0.951, 12.5: 0.958, 16: 0.896, 20: 0.782, 25: 0.647, 31.5: 0.519, 40: 0.411,
    50: 0.324, 63: 0.256, 80: 0.202, 100: 0.160, 125: 0.127, 160: 0.101, 200: 0.0799, 250: 0.0634,
    315: 0.0503, 400: 0.0398, 500: 0.0314, 630: 0.0245, 800: 0.0186, 1000: 0.0135, 1250: 0.00894,
}  # fmt: skip
"""Factors W_hi of one-third octaves by nominal centre frequency: ISO 5349-1:2001, table A.2."""


def exact_centre(nominal: float) -> float:
    """Return the exact centre frequency 10^(i/10) of a one-third octave."""
    return 10 ** (round(10 * np.log10(nominal)) / 10)


@pytest.mark.parametrize(("nominal", "factor"), PUBLISHED.items())
def test_the_published_factors_come_out_to_every_printed_digit(nominal: float, factor: float) -> None:
    found = abs(hand_arm_weighting(exact_centre(nominal)))
    assert float(f"{found:.3g}") == factor


def test_it_lags_at_the_frequency_of_its_transition_as_its_formula_says() -> None:
    # There s = j w3, so that the transition is (1 + j)/(1 + j/Q - 1) = Q (1 - j), Q = 0.64.
    s = 100j
    first, second = 2 * np.pi * 10**0.8, 2 * np.pi * 10**3.1
    band = s**2 * second**2 / (s**2 + first * s * np.sqrt(2) + first**2)
    band /= s**2 + second * s * np.sqrt(2) + second**2
    assert hand_arm_weighting(50 / np.pi) == pytest.approx(0.64 * (1 - 1j) * band, rel=1e-12)
