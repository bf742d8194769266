"""The figures of chapters 3 and 4 and of appendix E show what their captions say."""

import re

import numpy as np
import pytest

from report.chapters.appendix_e.figures import appendix_e
from report.chapters.chapter_3.figures import chapters_3_and_4
from report.drawing.style import WIDTH
from report.numbers.driven_motion import LARGEST_GAP
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, MEASURED_DRIVE_FREQUENCY

DRAWINGS = (*chapters_3_and_4.DRAWINGS, *appendix_e.DRAWINGS)
SMALLEST_TEXT = 7.5


@pytest.fixture(scope="module")
def figures(evidence):
    return {drawing.id: drawing.draw(evidence) for drawing in DRAWINGS}


def line(axes, label):
    (found,) = (each for each in axes.lines if each.get_label() == label)
    return np.asarray(found.get_xdata(), float), np.asarray(found.get_ydata(), float)


def test_every_figure_of_these_parts_has_one_drawing(inventory):
    expected = [claim_id for claim_id in inventory if re.match(r"fig-[34E]\.", claim_id)]
    assert [drawing.id for drawing in DRAWINGS] == expected


@pytest.mark.parametrize("drawing", DRAWINGS, ids=lambda drawing: drawing.id)
def test_words_say_what_to_see_and_whose_parameters_are_drawn(drawing):
    assert drawing.id.removeprefix("fig-") in drawing.caption
    assert len(drawing.alternative_text) > 40
    assert drawing.caption.count("$") % 2 == 0
    if drawing.id.startswith("fig-3.") and drawing.id != "fig-3.5":
        assert "Listing A.1" in drawing.caption


@pytest.mark.parametrize("drawing", DRAWINGS, ids=lambda drawing: drawing.id)
def test_text_is_large_enough_axes_are_labelled_and_lines_differ_in_dashes(drawing, figures):
    figure = figures[drawing.id]
    assert figure.get_figwidth() <= WIDTH
    for axes in figure.axes:
        assert min((text.get_fontsize() for text in axes.texts), default=SMALLEST_TEXT) >= SMALLEST_TEXT
        named = [each for each in axes.lines if not each.get_label().startswith("_")]
        styles = {(each.get_linestyle(), str(each._dash_pattern), each.get_marker()) for each in named}
        assert len(styles) == len(named)
    assert all(axes.get_xlabel() for axes in figure.axes if axes.xaxis.get_tick_params()["labelbottom"])
    assert any(axes.get_ylabel() for axes in figure.axes)


def test_spectra_have_odd_harmonics_only(figures):
    (axes,) = figures["fig-3.4"].axes
    for label in ("play of 0.2 mm", "without play"):
        frequency, amplitude = line(axes, label)
        orders = frequency / MEASURED_DRIVE_FREQUENCY
        odd = np.isclose(orders, np.round(orders), atol=0.01) & (np.round(orders) % 2 == 1)
        assert amplitude[odd & (frequency < 1000)].min() > 0.5
        assert amplitude[~odd & (frequency > 0)].max() < 0.01


def test_heights_of_the_fifth_harmonic_are_those_in_the_words(figures):
    _, harmonics = figures["fig-3.6"].axes
    heights = [line(harmonics, f"{force:.2f} N")[1][1] for force in (0.25, 0.5, 0.75)]
    (drawing,) = (each for each in DRAWINGS if each.id == "fig-3.6")
    assert f"{heights[0]:.0f} to {heights[2]:.0f} micrometres" in drawing.alternative_text


def test_the_pin_stays_within_the_printed_gap(figures):
    printed, smaller = figures["fig-3.7"].axes
    assert np.abs(line(printed, "pin")[1]).max() == pytest.approx(1e3 * DRIVE_AMPLITUDE, rel=1e-3)
    assert 1e3 * DRIVE_AMPLITUDE < 500 * LARGEST_GAP
    assert not line(printed, "$q_2 - q_4$")[1].any()
    assert np.abs(line(smaller, "0.25 N")[1]).max() > 0.5


def test_only_the_record_from_rest_has_something_between_the_harmonics(figures, evidence):
    both, _ = figures["fig-3.8"].axes
    near = evidence.numbers.modes[1].frequency
    # Micrometres; the settled record is 33 periods to 1e-6, which leaks some 1e-6 of the 0.6 mm.
    for label, least, most in (("first 0.3 s", 10, 100), ("last 0.3 s", 0, 0.01)):
        frequency, amplitude = line(both, label)
        assert least < amplitude[np.abs(frequency - near).argmin()] < most


def test_peaks_of_the_closed_loop_are_where_the_words_have_them(figures):
    inside_small, outside_small, inside_large, outside_large = figures["fig-3.9"].axes
    for axes, place in (
        (inside_large, 550),
        (outside_small, 728),
        (outside_large, 728),
        (inside_small, 550),
    ):
        frequency, amplitude = line(axes, "$F_c$ = 0.0025 N")
        assert frequency[amplitude.argmax()] == pytest.approx(place, abs=4)


def test_blocks_differ_by_what_the_words_say(figures):
    _, difference = figures["fig-4.1"].axes
    assert not np.asarray(difference.lines[0].get_ydata()).any()
    _, deviation = figures["fig-4.2"].axes
    assert np.asarray(deviation.lines[0].get_ydata()).min() == pytest.approx(-12.4, abs=0.05)


def test_outputs_for_several_gaps_begin_with_the_input_and_grow(figures):
    (axes,) = figures["fig-4.3"].axes
    peaks = [np.asarray(each.get_ydata()).max() for each in axes.lines]
    assert peaks[0] == pytest.approx(1.5, rel=1e-5)
    assert (np.diff(peaks) > 0).all()


def test_ripples_tend_to_one_height(figures):
    *_, ripples = figures["fig-E.2"].axes
    heights = [np.ptp(line(ripples, label)[1]) for label in ("0.15 mm", "1.5 mm", "15 mm", "150 mm")]
    distances = np.abs(np.array(heights[:3]) / heights[3] - 1)
    assert (np.diff(distances) < 0).all()
    assert distances[-1] < 0.01
