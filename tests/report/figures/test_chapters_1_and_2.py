"""Every figure of chapters 1 and 2 is drawn once, readably, and the same each time."""

import re

import pytest

from report.chapters.all_figures import DRAWINGS as ALL
from report.chapters.chapter_2.figures.chapters_1_and_2 import DRAWINGS
from report.drawing.style import WIDTH

SMALLEST_TEXT = 7.5


@pytest.fixture(scope="module")
def figures():
    return {drawing.id: drawing.draw(None) for drawing in DRAWINGS}


def test_every_figure_of_both_chapters_has_one_drawing(inventory):
    expected = [claim_id for claim_id in inventory if re.match(r"fig-[12]\.", claim_id)]
    assert [drawing.id for drawing in DRAWINGS] == expected
    assert len({drawing.id for drawing in ALL}) == len(ALL)


@pytest.mark.parametrize("drawing", DRAWINGS, ids=lambda drawing: drawing.id)
def test_words_say_what_to_see_and_name_the_thesis_s_figure(drawing):
    assert drawing.id.removeprefix("fig-") in drawing.caption
    assert len(drawing.alternative_text) > 40
    assert drawing.caption.count("$") % 2 == 0


@pytest.mark.parametrize("drawing", DRAWINGS, ids=lambda drawing: drawing.id)
def test_text_is_large_enough_and_the_figure_not_wider_than_the_page(drawing, figures):
    figure = figures[drawing.id]
    assert figure.get_figwidth() <= WIDTH
    sizes = [text.get_fontsize() for axes in figure.axes for text in axes.texts]
    assert min(sizes, default=SMALLEST_TEXT) >= SMALLEST_TEXT


@pytest.mark.parametrize("claim_id", ["fig-2.2", "fig-2.9", "fig-2.14"])
def test_the_same_drawing_gives_the_same_bytes(claim_id):
    (drawing,) = (each for each in DRAWINGS if each.id == claim_id)
    assert drawing.finished(None).svg == drawing.finished(None).svg
