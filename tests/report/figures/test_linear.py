"""The figures of the linear trimmer show what their captions and axes say."""

from __future__ import annotations

import math

import numpy as np
import pytest

from report.numbers.thesis import DRIVE_AMPLITUDE
from tests.report.figures.lines import line


@pytest.fixture(scope="module")
def numbers(evidence):
    return evidence.numbers


def test_time_response_shows_the_deviation_that_the_claim_names(numbers, drawn_axes):
    upper, lower = drawn_axes("fig-5.1")
    times, pin = line(upper, "pin, $u$")
    _, output = line(upper, "output from rest, $q_2 - q_4$")
    difference = np.asarray(lower.lines[0].get_ydata())
    assert np.abs(pin).max() == pytest.approx(1e3 * DRIVE_AMPLITUDE, rel=1e-4)
    np.testing.assert_allclose(difference, output - pin, atol=1e-12)
    assert np.abs(difference[times <= 10]).max() == pytest.approx(1e3 * numbers.start.deviation, rel=1e-3)


def test_bode_plot_marks_unit_gain_and_three_decibels_below_the_static_gain(numbers, drawn_axes):
    upper, lower = drawn_axes("fig-5.2")
    unity, cutoff = (each for each in upper.lines if len(each.get_xdata()) == 1)
    omega, magnitude = line(upper, "displacement only (thesis)")
    assert np.interp(unity.get_xdata()[0], omega, magnitude) == pytest.approx(0, abs=0.01)
    static = 20 * math.log10(numbers.numerator[-1] / numbers.denominator[-1])
    assert cutoff.get_ydata()[0] == pytest.approx(static - 3, abs=1e-6)
    assert (magnitude[omega > cutoff.get_xdata()[0]] < static - 3).all()
    (dotted,) = (each for each in upper.lines if each.get_linestyle() == ":")
    fall = np.diff(dotted.get_ydata())[0] / np.diff(np.log10(dotted.get_xdata()))[0]
    assert fall == pytest.approx(-40)
    assert np.asarray(lower.lines[0].get_ydata())[-1] == pytest.approx(-180, abs=1)


def test_light_damping_has_its_peaks_at_the_dotted_lines(drawn_axes):
    (axes,) = drawn_axes("fig-5.4")
    omega, magnitude = line(axes, "a thousandth of the damping")
    inner = magnitude[1:-1]
    peaks = omega[1:-1][(inner > magnitude[:-2]) & (inner > magnitude[2:])]
    dotted = [each.get_xdata()[0] for each in axes.lines if each.get_linestyle() == ":"]
    assert len(dotted) == 4
    assert all(np.abs(peaks / natural - 1).min() < 3e-4 for natural in dotted)


def test_nyquist_locus_closes_with_its_mirror_image_and_stays_clear_of_the_critical_point(
    numbers, drawn_axes
):
    whole, near = drawn_axes("fig-5.3")
    real, imaginary = line(whole, r"$\omega > 0$")
    mirrored, below = line(whole, r"$\omega < 0$")
    np.testing.assert_array_equal(mirrored, real)
    np.testing.assert_array_equal(below, -imaginary)
    assert np.hypot(real + 1, imaginary).min() > 0.05
    assert near.get_xlim() == (-3, 3)
