"""Each figure shows what it showed when it was last looked at, and its words say what is drawn."""

import numpy as np
import pytest

from report.chapters.chapter_3 import figures as chapter_3
from report.chapters.chapter_5.figures import loop_motion
from tests.report.figures.conftest import DRAWN
from tests.report.figures.told import kept, told
from tests.trimmer.command_line.alike import alike


def line(axes, label):
    """Return x and y of the one curve with a label."""
    (found,) = (each for each in axes.lines if each.get_label() == label)
    return np.asarray(found.get_xdata(), float), np.asarray(found.get_ydata(), float)


def test_each_figure_is_told():
    assert list(kept()) == list(DRAWN)


@pytest.mark.parametrize("figure_id", DRAWN)
def test_it_shows_what_it_showed(figure_id, drawn):
    before, now = kept()[figure_id], list(told(drawn(figure_id)))
    assert len(before) == len(now)
    assert [pair for pair in zip(before, now, strict=True) if pair[0] != pair[1] and not alike(*pair)] == []


def test_heights_of_the_fifth_harmonic_are_those_in_the_words(drawn):
    _, harmonics = drawn("fig-3.6").axes
    heights = [line(harmonics, f"{force:.2f} N")[1][1] for force in (0.25, 0.5, 0.75)]
    words = chapter_3.open_loop_with_small_gap.words.alternative_text
    assert f"{heights[0]:.0f} to {heights[2]:.0f} micrometres" in words


def test_crests_and_peaks_are_those_in_caption_and_labels(drawn):
    _, crest, lower = drawn("fig-5.9").axes
    for label in ("exact", "rounded"):
        assert f"{line(crest, label)[1].max():.2f} µm" in loop_motion.small_gap.words.caption
    named = {each.get_label(): each for each in lower.lines if not each.get_label().startswith("_")}
    assert sorted(label[-6:] for label in named) == ["730 Hz", "734 Hz"]
    for label, curve in named.items():
        assert f"{curve.get_xdata()[np.argmax(curve.get_ydata())]:.0f} Hz" in label
