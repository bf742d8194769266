"""The variants of the equivalent nonlinearity, against the listing's lines and the equation's print."""

import math

import numpy as np
import pytest

from report.numbers.equivalent_nonlinearity import FORCE, listing_element, printed_function, right_element
from report.numbers.thesis import DRIVE_OMEGA, SMALL_GAP
from trimmer import FrictionBacklash


def line_by_line(A, D, w, Fc):
    """Listing A.6, its lines 10 to 18 as they stand."""
    N_re = (
        0.5 + 1 / np.pi * (1 - (D / A)) * np.sqrt(1 - (1 - D / A) ** 2) + 1 / np.pi * np.arcsin(1 - (D / A))
    )
    N_im = -(1 / np.pi) * (1 - (1 - D / A) ** 2)
    Nr = N_re + 1j * N_im
    a_1 = 0
    b_1 = (4 * Fc) / np.pi
    Nf = (1 / A) * (b_1 + 1j * a_1)
    return Nr - (1j / w) * Nf


def test_the_listing_element_is_the_listing():
    amplitudes = SMALL_GAP * np.geomspace(0.51, 1e4, 60)
    ours = listing_element(FORCE).describing_function(amplitudes)
    np.testing.assert_allclose(ours, line_by_line(amplitudes, SMALL_GAP, DRIVE_OMEGA, FORCE), rtol=1e-9)


def test_the_right_element_damps_where_the_listing_feeds():
    """Friction takes energy where the imaginary part of what it adds is positive: a force ahead of x."""
    amplitude, k2 = 3 * SMALL_GAP, 30e3
    backlash = FrictionBacklash(SMALL_GAP).describing_function(amplitude)
    right = (right_element(FORCE, k2).describing_function(amplitude) - backlash) * k2
    assert right == pytest.approx(4j * FORCE / (math.pi * amplitude))
    wrong = listing_element(FORCE).describing_function(amplitude) - backlash
    assert wrong.real == pytest.approx(0, abs=1e-9)
    assert wrong.imag < 0


@pytest.mark.parametrize("factor", [1e-3, 7.0])
def test_only_force_over_frequency_and_gap_counts(factor):
    """One family of contours, as the claim on figure 5.21 says."""
    amplitudes = np.geomspace(0.6, 50, 20)
    reference = listing_element(FORCE).describing_function(SMALL_GAP * amplitudes)
    for changed, gap in (
        (listing_element(factor * FORCE, SMALL_GAP, factor * DRIVE_OMEGA), SMALL_GAP),
        (listing_element(factor * FORCE, factor * SMALL_GAP), factor * SMALL_GAP),
        (listing_element(FORCE, SMALL_GAP / factor, factor * DRIVE_OMEGA), SMALL_GAP / factor),
    ):
        np.testing.assert_allclose(changed.describing_function(gap * amplitudes), reference, rtol=1e-9)


def test_the_printed_equation_needs_pi_and_the_amplitude_in_its_real_part():
    """With A/π in its real part, one A fewer under friction and b half of the gap it is the listing."""
    amplitude = 2.3 * SMALL_GAP
    printed = printed_function(amplitude, FORCE, SMALL_GAP / 2)
    friction = -4 * FORCE / (DRIVE_OMEGA * math.pi * amplitude)
    real = printed.real * amplitude / math.pi
    imaginary = printed.imag - friction / amplitude + friction
    assert complex(real, imaginary) == pytest.approx(listing_element(FORCE).describing_function(amplitude))
