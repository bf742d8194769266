"""One rule for all figures, each drawn once: its words, letters, marks and lines, and the same each time."""

import re
from string import ascii_lowercase

import pytest

from report.building.collect import collect
from report.data.figures import figure_words
from report.data.statements import read_inventory
from report.pages.drawing.letters import letter_panels, panels_of, title_of
from report.pages.drawing.marks import STABLE, UNSTABLE
from report.pages.drawing.style import WIDTH, new_figure, style
from tests.quick import quick
from tests.report.figures import conftest

FIGURES = tuple(conftest.FIGURES.values())
OF_THESIS = collect(read_inventory()).figures
NOT_DRAWN = ["fig-5.6", "fig-5.17", "fig-5.18"]
SMALLEST_TEXT = 7.5

each_figure = pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: figure.id)
each_of_thesis = pytest.mark.parametrize("figure", OF_THESIS, ids=lambda figure: figure.id)


@each_figure
def test_panels_are_lettered_in_their_order_and_captions_name_no_others(figure, drawn):
    panels = panels_of(drawn(figure.id))
    letters = [title_of(axes)[:3] for axes in panels]
    if len(panels) > 1:
        assert letters == [f"({letter})" for letter in ascii_lowercase[: len(panels)]]
    named = set(re.findall(r"(?:^|[ ,])\(([a-z])\)", figure.words.caption))
    if figure.id != "fig-2.15":  # a block diagram, which has its two parts on one canvas
        assert named <= set(ascii_lowercase[: len(panels)] if len(panels) > 1 else "")


def test_a_letter_is_put_once_and_not_before_a_legend():
    with style():
        figure = new_figure(2.0)
        left, right, legend = figure.subplots(1, 3)
    left.set_title("a title")
    legend.set_axis_off()
    letter_panels(figure)
    letter_panels(figure)
    assert [title_of(axes) for axes in (left, right, legend)] == ["(a) a title", "(b)", ""]


@each_figure
def test_limit_cycles_are_full_or_open_and_the_caption_says_what_that_means(figure, drawn):
    marks = [line for axes in drawn(figure.id).axes for line in axes.lines]
    for label, face, word in ((STABLE, "#000000", "full"), (UNSTABLE, "white", "open")):
        chosen = [mark for mark in marks if mark.get_label() == label]
        assert {mark.get_markerfacecolor() for mark in chosen} <= {face}
        assert not chosen or word in figure.words.caption.lower()


def test_every_figure_of_the_thesis_is_drawn_once(inventory):
    expected = [claim_id for claim_id in inventory if claim_id.startswith("fig-")]
    assert sorted([*NOT_DRAWN, *(figure.id for figure in OF_THESIS)]) == sorted(expected)
    assert figure_words().keys() == conftest.FIGURES.keys()


@each_of_thesis
def test_a_figure_stands_in_the_folder_of_its_chapter(figure):
    number = figure.id.removeprefix("fig-").partition(".")[0]
    chapter = f"chapter_{number}" if number.isdigit() else f"appendix_{number.lower()}"
    assert figure.draw.__module__.startswith(f"report.chapters.{chapter}.figures")


@each_of_thesis
def test_words_say_what_to_see_and_name_the_thesis_s_figure(figure):
    assert figure.id.removeprefix("fig-") in figure.words.caption
    assert len(figure.words.alternative_text) > 40
    assert figure.words.caption.count("$") % 2 == 0
    if figure.id.startswith("fig-3.") and figure.id != "fig-3.5":
        assert "Listing A.1" in figure.words.caption


@each_of_thesis
def test_text_is_large_enough_axes_are_labelled_and_lines_differ_in_dashes(figure, drawn):
    drawing = drawn(figure.id)
    assert drawing.get_figwidth() <= WIDTH
    with_scales = [axes for axes in drawing.axes if axes.axison]
    for axes in with_scales:
        sharing = axes.get_shared_x_axes().get_siblings(axes)
        assert any(each.get_xlabel() for each in sharing)
    assert not with_scales or any(axes.get_ylabel() for axes in with_scales)
    for axes in drawing.axes:
        assert min((text.get_fontsize() for text in axes.texts), default=SMALLEST_TEXT) >= SMALLEST_TEXT
    for axes in with_scales:
        named = [line for line in axes.lines if not line.get_label().startswith("_")]
        styles = [(line.get_linestyle(), str(line._dash_pattern), line.get_marker()) for line in named]
        labels = [line.get_label() for line in named]
        assert len(set(styles)) == len(set(zip(styles, labels, strict=True)))


@pytest.mark.parametrize("figure_id", quick(["fig-2.2", "fig-2.9"], 1))
def test_the_same_figure_gives_the_same_bytes(figure_id):
    (figure,) = (each for each in OF_THESIS if each.id == figure_id)
    assert figure.finished(None).svg == figure.finished(None).svg
