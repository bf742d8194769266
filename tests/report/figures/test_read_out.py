"""What a page reads off a figure: peaks, places of texts, and which axes are zoomed together."""

import json
import re

import numpy as np
import pytest

from report.pages.drawing.marks import STABLE, arrow, limit_cycle, name_places
from report.pages.drawing.peaks import peaks
from report.pages.drawing.style import new_figure, style
from report.pages.drawing.svg import to_svg


@pytest.fixture
def axes():
    with style():
        axes = new_figure(3.0).subplots()
    axes.set(xlabel="frequency [Hz]", xlim=(0, 1000), ylim=(0, 2))
    return axes


def described(figure):
    """What the drawing says of its axes."""
    with style():
        svg = to_svg(figure, "fig-5.1", "title", "words")
    return json.loads(re.search(r"data-axes='([^']*)'", svg)[1]), svg


def bell(place, height, frequency):
    return height / (1 + ((frequency - place) / 5) ** 2)


def test_peaks_are_those_that_stand_out_and_are_seen_the_highest_first(axes):
    frequency = np.linspace(-500, 1500, 20_001)
    amplitude = bell(300, 1.0, frequency) + bell(700, 1.5, frequency) + bell(1200, 1.9, frequency)
    amplitude += 0.002 * np.sin(frequency)
    (line,) = axes.plot(frequency, amplitude)
    found = peaks(line, axes)
    np.testing.assert_allclose(found[:, 0], [700, 300], atol=0.5)


def test_of_stems_each_symbol_is_a_peak_and_a_mark_of_a_limit_cycle_is_none(axes):
    (symbols,) = axes.plot([100, 300], [1.0, 0.5], "o")
    np.testing.assert_allclose(peaks(symbols, axes), [[100, 1.0], [300, 0.5]])
    limit_cycle(axes, (500, 1.0), stable=True)
    (mark,) = (line for line in axes.lines if line.get_label() == STABLE)
    assert peaks(mark, axes).size == 0


def test_a_straight_line_has_no_peak(axes):
    (line,) = axes.plot([0, 1000], [0, 1])
    assert peaks(line, axes).size == 0


def test_texts_at_data_are_placed_and_others_are_not(axes):
    axes.annotate("beside", (500, 1.0), (5, 5), textcoords="offset points")
    axes.text(0.5, 0.5, "in the middle", transform=axes.transAxes)
    axes.annotate("above", (250, 0.9), xycoords=("data", "axes fraction"))
    arrow(axes, (0, 0), (1000, 2))
    ((one,), svg) = described(axes.figure)
    left, top, width, height = one["box"]
    placed = dict((name, places) for name, *places in one["placed"])
    assert placed["placed_0_0"] == [pytest.approx([left + width / 2, top + height / 2], abs=0.05)]
    assert placed["placed_0_2"][0] == [pytest.approx(left + width / 4, abs=0.05), None]
    end, start = placed["placed_0_3"]
    assert (end, start) == (
        pytest.approx([left + width, top], abs=0.05),
        pytest.approx([left, top + height], abs=0.05),
    )
    assert "placed_0_1" not in placed
    for name in placed:
        assert svg.count(f'"fig-5.1-{name}"') + svg.count(f'"fig-5.1-{name}_arrow"') == 1


def test_axes_that_share_a_range_say_so_and_words_have_no_numbers():
    with style():
        figure = new_figure(3.0)
        grid = figure.subplots(2, 2, sharex="col")
    for axes in grid.flat:
        axes.set(xlabel="time [s]", ylabel="y")
    name_places(grid[0, 1].yaxis, ["one", "two"])
    axes, _ = described(figure)
    assert [each["x"]["shared"] for each in axes] == [0, 1, 0, 1]
    assert [each["y"]["shared"] for each in axes] == [0, 1, 2, 3]
    assert [each["y"]["label"] for each in axes] == ["y", "", "y", "y"]
