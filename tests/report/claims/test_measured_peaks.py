"""Bins of the tabulated spectra, and drive frequencies that fit them."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from report.chapters.chapter_3.claims.measured_peaks import (
    BIN,
    FRAMES_OF_TABLES,
    SAMPLE_RATE,
    common_drive,
    nearest_bin,
    on_a_bin,
    tabulated,
)


def test_bins_are_those_of_numpy():
    frequencies = np.fft.rfftfreq(FRAMES_OF_TABLES, 1 / float(SAMPLE_RATE))
    assert frequencies[56] == pytest.approx(float(56 * BIN))
    assert nearest_bin(float(frequencies[56]) + 4.9) == 56


def test_every_tabulated_peak_but_three_is_a_bin():
    assert len(tabulated()) == 18
    assert sorted(cell for cell in tabulated() if not on_a_bin(cell)) == ["109.450", "109.450", "559.725"]


@given(st.floats(105, 115), st.sets(st.integers(1, 9), min_size=1))
def test_the_drive_lies_in_the_range_that_its_nearest_bins_give(drive, orders):
    bins = {order: nearest_bin(order * drive) for order in orders}
    low, high = common_drive(bins, Fraction(1, 2))
    assert low <= drive * (1 + 1e-12)
    assert drive <= high * (1 + 1e-12)


def test_bins_without_a_common_drive_give_an_empty_range():
    low, high = common_drive({1: 11, 3: 40}, Fraction(1, 2))
    assert low > high
