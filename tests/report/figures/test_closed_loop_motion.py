"""The figures of section 5.2 that rest on simulation show what their captions say."""

import numpy as np
import pytest

from report.chapters.chapter_5.figures import loop_motion
from report.numbers.impulse_response import GAPS
from report.numbers.relay_loop import IMPULSES
from tests.report.figures.lines import line


@pytest.fixture(scope="module")
def closed(evidence):
    return evidence.motion.closed


def test_only_the_largest_gap_dies_out_after_the_weaker_impulse(drawn_axes):
    axes = drawn_axes("fig-5.7")
    words = [each.texts[0].get_text() for each in axes]
    assert words.count("dies out") == 1
    assert words[-1] == "dies out"
    for place, gap in enumerate(GAPS):
        upper = max(each.get_ydata()[-1] for each in axes[2 * place].lines)
        assert upper == pytest.approx(8.289 * 1e9 * gap, rel=1e-3)


def test_bins_of_one_second_and_of_a_tenth_peak_at_different_places(drawn_axes, closed):
    upper, crest, lower = drawn_axes("fig-5.9")
    sine = np.asarray(upper.lines[0].get_ydata())
    assert np.abs(sine).max() == pytest.approx(4 * closed.orbits.friction.stable.amplitude, rel=1e-4)
    heights = [line(crest, label)[1].max() for label in ("exact", "rounded")]
    assert [f"{height:.2f} µm" in loop_motion.small_gap.words.caption for height in heights] == [True, True]
    named = {each.get_label(): each for each in lower.lines if not each.get_label().startswith("_")}
    for label, curve in named.items():
        highest = curve.get_xdata()[np.argmax(curve.get_ydata())]
        assert f"{highest:.0f} Hz" in label
    assert sorted(label[-6:] for label in named) == ["730 Hz", "734 Hz"]


def test_an_orbit_is_continued_beyond_its_period(closed):
    orbit = closed.orbits.friction.stable
    times = np.array([0.1, 1.1, 7.1]) * orbit.period
    values = loop_motion.periodic(orbit, times)
    np.testing.assert_allclose(values, values[0], rtol=1e-9)


def test_only_the_loop_with_feedback_stays_near_one_millimetre(drawn_axes):
    opened, fed_back = (line(axes, "output $y$")[1] for axes in drawn_axes("fig-5.11"))
    assert np.abs(opened).max() == pytest.approx(1.48, abs=0.005)
    assert 1.0 < np.abs(fed_back).max() < 1.1


def test_only_spectra_with_feedback_have_the_limit_cycle(drawn_axes, closed):
    top, middle, bottom = drawn_axes("fig-5.12")
    cycle = closed.orbits.friction.stable.frequency
    (alone,) = (each.get_xdata() for each in top.lines if each.get_marker() == "o")
    np.testing.assert_allclose(alone, [cycle])
    (opened,) = (np.asarray(each.get_xdata()) for each in middle.lines if each.get_marker() == "o")
    np.testing.assert_allclose(opened, [100, 300, 500, 700, 900, 1100])
    frequency, amplitude = (np.asarray(each, float) for each in bottom.lines[0].get_data())
    near = np.abs(frequency - cycle) < 5
    assert amplitude[near].max() > 100
    assert amplitude[np.abs(frequency - 700) < 10].max() < 1


def test_the_block_in_the_loop_has_a_hump_where_the_open_loop_has_none(drawn_axes):
    _, opened, _, block = drawn_axes("fig-5.14")
    for axes, hump in ((opened, False), (block, True)):
        frequency, amplitude = (np.asarray(each, float) for each in axes.lines[0].get_data())
        near = np.abs(frequency - 659.7) < 1
        beside = np.abs(frequency - 619.7) < 1
        assert (amplitude[near].item() > 3 * amplitude[beside].item()) == hump


def test_swings_shrink_and_quicken_and_friction_stops(drawn_axes):
    sizes, frequencies = drawn_axes("fig-5.19")
    for impulse in IMPULSES:
        label = f"10$^{{{np.log10(impulse):.0f}}}$ s"
        assert np.diff(line(sizes, label)[1][[0, -1]]) < 0
        assert np.diff(line(frequencies, label)[1][[0, -1]]) > 0
    _, motion = drawn_axes("fig-5.20")
    for each in motion.lines:
        assert np.asarray(each.get_ydata())[-1] == pytest.approx(1, abs=1e-3)


def test_the_released_loop_peaks_at_the_modes(drawn_axes, closed):
    *_, axes = drawn_axes("fig-5.23")
    frequency, size = line(axes, "1 m")
    for mode in closed.released_bodies.modes[:3]:
        near = np.abs(frequency - mode) < 20
        assert frequency[near][np.argmax(size[near])] == pytest.approx(mode, abs=1)
