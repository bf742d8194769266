"""Every figure is drawn once, readably, and the same each time."""

import pytest

from report.collect import collect
from report.drawing.style import WIDTH
from report.inventory import read_inventory

FIGURES = collect(read_inventory()).figures
NOT_DRAWN = ["fig-5.6", "fig-5.17", "fig-5.18"]
SMALLEST_TEXT = 7.5

each_figure = pytest.mark.parametrize("figure", FIGURES, ids=lambda figure: figure.id)


def test_every_figure_of_the_thesis_is_drawn_once(inventory):
    expected = [claim_id for claim_id in inventory if claim_id.startswith("fig-")]
    assert sorted([*NOT_DRAWN, *(figure.id for figure in FIGURES)]) == sorted(expected)


@each_figure
def test_a_figure_stands_in_the_folder_of_its_chapter(figure):
    number = figure.id.removeprefix("fig-").partition(".")[0]
    chapter = f"chapter_{number}" if number.isdigit() else f"appendix_{number.lower()}"
    assert figure.draw.__module__.startswith(f"report.chapters.{chapter}.figures")


@each_figure
def test_words_say_what_to_see_and_name_the_thesis_s_figure(figure):
    assert figure.id.removeprefix("fig-") in figure.caption
    assert len(figure.alternative_text) > 40
    assert figure.caption.count("$") % 2 == 0
    if figure.id.startswith("fig-3.") and figure.id != "fig-3.5":
        assert "Listing A.1" in figure.caption


@each_figure
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


@pytest.mark.parametrize("figure_id", ["fig-2.2", "fig-2.9", "fig-2.14"])
def test_the_same_figure_gives_the_same_bytes(figure_id):
    (figure,) = (each for each in FIGURES if each.id == figure_id)
    assert figure.finished(None).svg == figure.finished(None).svg
