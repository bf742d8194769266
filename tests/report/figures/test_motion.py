"""The figures of chapters 3 and 4 and of appendix E show what their captions say."""

import numpy as np
import pytest

from report.chapters.chapter_3 import figures
from report.numbers.thesis import DRIVE_AMPLITUDE, LARGEST_GAP, MEASURED_DRIVE_FREQUENCY, TABLE_2
from tests.report.figures.lines import line


def test_spectra_have_odd_harmonics_only(drawn_axes):
    (axes,) = drawn_axes("fig-3.4")
    for label in ("play of 0.2 mm", "without play"):
        frequency, amplitude = line(axes, label)
        orders = frequency / MEASURED_DRIVE_FREQUENCY
        odd = np.isclose(orders, np.round(orders), atol=0.01) & (np.round(orders) % 2 == 1)
        assert amplitude[odd & (frequency < 1000)].min() > 0.5
        assert amplitude[~odd & (frequency > 0)].max() < 0.01


def test_frequencies_without_heights_stand_in_a_strip_of_their_own(drawn_axes):
    model, rug = drawn_axes("fig-3.5")
    assert {each.get_marker() for each in model.lines} <= {".", "None"}
    measured = [each for each in rug.lines if each.get_marker() == "|"]
    assert len(measured) == len(TABLE_2)
    for row, (each, cells) in enumerate(zip(measured, TABLE_2.values(), strict=True)):
        assert [f"{place:g}" for place in each.get_xdata()] == [f"{float(cell):g}" for cell in cells[1:]]
        assert set(each.get_ydata()) == {row}


def test_one_motion_scaled_by_the_gap(drawn_axes):
    lengths, gaps = drawn_axes("fig-E.1")
    largest = [np.abs(np.asarray(each.get_ydata())).max() for each in lengths.lines]
    assert (np.diff(largest) > 0.5).all()
    over_gap = [np.abs(np.asarray(each.get_ydata())).max() for each in gaps.lines]
    assert over_gap == pytest.approx([over_gap[0]] * len(over_gap), rel=1e-3)


def test_heights_of_the_fifth_harmonic_are_those_in_the_words(drawn_axes):
    _, harmonics = drawn_axes("fig-3.6")
    heights = [line(harmonics, f"{force:.2f} N")[1][1] for force in (0.25, 0.5, 0.75)]
    assert (
        f"{heights[0]:.0f} to {heights[2]:.0f} micrometres"
        in figures.open_loop_with_small_gap.words.alternative_text
    )


def test_the_pin_stays_within_the_printed_gap(drawn_axes):
    printed, smaller = drawn_axes("fig-3.7")
    assert np.abs(line(printed, "pin")[1]).max() == pytest.approx(1e3 * DRIVE_AMPLITUDE, rel=1e-3)
    assert 1e3 * DRIVE_AMPLITUDE < 500 * LARGEST_GAP
    assert not line(printed, "$q_2 - q_4$")[1].any()
    assert np.abs(line(smaller, "0.25 N")[1]).max() > 0.5


def test_only_the_record_from_rest_has_something_between_the_harmonics(drawn_axes, evidence):
    both, _ = drawn_axes("fig-3.8")
    near = evidence.numbers.modes[1].frequency
    # Micrometres; the settled record is 33 periods to 1e-6, which leaks some 1e-6 of the 0.6 mm.
    for label, least, most in (("first 0.3 s", 10, 100), ("last 0.3 s", 0, 0.01)):
        frequency, amplitude = line(both, label)
        assert least < amplitude[np.abs(frequency - near).argmin()] < most


def test_peaks_of_the_closed_loop_are_where_the_words_have_them(drawn_axes):
    inside_small, outside_small, inside_large, outside_large = drawn_axes("fig-3.9")
    for axes, place in (
        (inside_large, 550),
        (outside_small, 728),
        (outside_large, 728),
        (inside_small, 550),
    ):
        frequency, amplitude = line(axes, "$F_c$ = 0.0025 N")
        assert frequency[amplitude.argmax()] == pytest.approx(place, abs=4)


def test_blocks_differ_by_what_the_words_say(drawn_axes):
    _, difference = drawn_axes("fig-4.1")
    assert not np.asarray(difference.lines[0].get_ydata()).any()
    _, deviation = drawn_axes("fig-4.2")
    assert np.asarray(deviation.lines[0].get_ydata()).min() == pytest.approx(-12.4, abs=0.05)


def test_outputs_for_several_gaps_begin_with_the_input_and_grow(drawn_axes):
    (axes,) = drawn_axes("fig-4.3")
    peaks = [np.asarray(each.get_ydata()).max() for each in axes.lines]
    assert peaks[0] == pytest.approx(1.5, rel=1e-5)
    assert (np.diff(peaks) > 0).all()


def test_ripples_tend_to_one_height(drawn_axes):
    *_, ripples = drawn_axes("fig-E.2")
    heights = [np.ptp(line(ripples, label)[1]) for label in ("0.15 mm", "1.5 mm", "15 mm", "150 mm")]
    distances = np.abs(np.array(heights[:3]) / heights[3] - 1)
    assert (np.diff(distances) < 0).all()
    assert distances[-1] < 0.01
