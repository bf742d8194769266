"""The figures of section 5.2 that rest on simulation show what their captions say."""

import numpy as np
import pytest

from report.chapters import all_figures
from report.chapters.chapter_5.figures import closed_loop_motion, section_5_2_simulated
from report.drawing.style import WIDTH
from report.numbers.impulse_response import GAPS
from report.numbers.relay_loop import IMPULSES

DRAWINGS = (
    section_5_2_simulated.THREE_GAPS,
    section_5_2_simulated.SMALL_GAP,
    section_5_2_simulated.RESPONSES,
    section_5_2_simulated.SPECTRA,
    section_5_2_simulated.INERTIA,
    *section_5_2_simulated.RELAY,
)
SMALLEST_TEXT = 7.5


@pytest.fixture(scope="module")
def figures(evidence):
    return {drawing.id: drawing.draw(evidence) for drawing in DRAWINGS}


@pytest.fixture(scope="module")
def closed(evidence):
    return evidence.motion.closed


def line(axes, label):
    (found,) = (each for each in axes.lines if each.get_label() == label)
    return np.asarray(found.get_xdata(), float), np.asarray(found.get_ydata(), float)


def test_each_is_drawn_once_and_in_thesis_order(inventory):
    drawn = [drawing.id for drawing in all_figures.DRAWINGS]
    assert all(drawn.count(drawing.id) == 1 for drawing in DRAWINGS)
    order = list(inventory)
    places = [order.index(claim_id) for claim_id in drawn]
    assert places == sorted(places)


@pytest.mark.parametrize("drawing", DRAWINGS, ids=lambda drawing: drawing.id)
def test_text_is_large_enough_axes_are_labelled_and_lines_differ_in_dashes(drawing, figures):
    figure = figures[drawing.id]
    assert figure.get_figwidth() <= WIDTH
    assert drawing.id.removeprefix("fig-") in drawing.caption
    assert len(drawing.alternative_text) > 40
    for axes in figure.axes:
        assert min((text.get_fontsize() for text in axes.texts), default=SMALLEST_TEXT) >= SMALLEST_TEXT
        named = [each for each in axes.lines if not each.get_label().startswith("_")]
        styles = {(each.get_linestyle(), str(each._dash_pattern), each.get_marker()) for each in named}
        assert len(styles) == len(named)
    assert all(axes.get_xlabel() for axes in figure.axes if axes.xaxis.get_tick_params()["labelbottom"])
    assert any(axes.get_ylabel() for axes in figure.axes)


def test_only_the_largest_gap_dies_out_after_the_weaker_impulse(figures):
    axes = figures["fig-5.7"].axes
    words = [each.texts[0].get_text() for each in axes]
    assert words.count("dies out") == 1
    assert words[-1] == "dies out"
    for place, gap in enumerate(GAPS):
        upper = max(each.get_ydata()[-1] for each in axes[2 * place].lines)
        assert upper == pytest.approx(8.289 * 1e9 * gap, rel=1e-3)


def test_bins_of_one_second_and_of_a_tenth_peak_at_different_places(figures, closed):
    upper, lower = figures["fig-5.9"].axes
    sine = np.asarray(upper.lines[0].get_ydata())
    assert np.abs(sine).max() == pytest.approx(4 * closed.orbits.friction.stable.amplitude, rel=1e-4)
    named = {each.get_label(): each for each in lower.lines if not each.get_label().startswith("_")}
    for label, curve in named.items():
        highest = curve.get_xdata()[np.argmax(curve.get_ydata())]
        assert f"{highest:.0f} Hz" in label
    assert sorted(label[-6:] for label in named) == ["730 Hz", "734 Hz"]


def test_an_orbit_is_continued_beyond_its_period(closed):
    orbit = closed.orbits.friction.stable
    times = np.array([0.1, 1.1, 7.1]) * orbit.period
    values = closed_loop_motion.periodic(orbit, times)
    np.testing.assert_allclose(values, values[0], rtol=1e-9)


def test_only_the_loop_with_feedback_stays_near_one_millimetre(figures):
    opened, fed_back = (line(axes, "output $y$")[1] for axes in figures["fig-5.11"].axes)
    assert np.abs(opened).max() == pytest.approx(1.48, abs=0.005)
    assert 1.0 < np.abs(fed_back).max() < 1.1


def test_only_spectra_with_feedback_have_the_limit_cycle(figures, closed):
    top, middle, bottom = figures["fig-5.12"].axes
    cycle = closed.orbits.friction.stable.frequency
    (alone,) = (each.get_xdata() for each in top.lines if each.get_marker() == "o")
    np.testing.assert_allclose(alone, [cycle])
    (opened,) = (np.asarray(each.get_xdata()) for each in middle.lines if each.get_marker() == "o")
    np.testing.assert_allclose(opened, [100, 300, 500, 700, 900, 1100])
    frequency, amplitude = (np.asarray(each, float) for each in bottom.lines[0].get_data())
    near = np.abs(frequency - cycle) < 5
    assert amplitude[near].max() > 100
    assert amplitude[np.abs(frequency - 700) < 10].max() < 1


def test_the_block_in_the_loop_has_a_hump_where_the_open_loop_has_none(figures):
    _, opened, _, block = figures["fig-5.14"].axes
    for axes, hump in ((opened, False), (block, True)):
        frequency, amplitude = (np.asarray(each, float) for each in axes.lines[0].get_data())
        near = np.abs(frequency - 659.7) < 1
        beside = np.abs(frequency - 619.7) < 1
        assert (amplitude[near].item() > 3 * amplitude[beside].item()) == hump


def test_swings_shrink_and_quicken_and_friction_stops(figures):
    sizes, frequencies = figures["fig-5.19"].axes
    for impulse in IMPULSES:
        label = f"10$^{{{np.log10(impulse):.0f}}}$ s"
        assert np.diff(line(sizes, label)[1][[0, -1]]) < 0
        assert np.diff(line(frequencies, label)[1][[0, -1]]) > 0
    _, motion = figures["fig-5.20"].axes
    for each in motion.lines:
        assert np.asarray(each.get_ydata())[-1] == pytest.approx(1, abs=1e-3)


def test_the_released_loop_peaks_at_the_modes(evidence, closed):
    drawing = next(each for each in all_figures.DRAWINGS if each.id == "fig-5.23")
    *_, axes = drawing.draw(evidence).axes
    frequency, size = line(axes, "1 m")
    for mode in closed.released_bodies.modes[:3]:
        near = np.abs(frequency - mode) < 20
        assert frequency[near][np.argmax(size[near])] == pytest.approx(mode, abs=1)
