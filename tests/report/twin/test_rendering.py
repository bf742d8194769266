"""The chapter on the twin in Markdown and HTML, in whole reports and not in parts."""

from dataclasses import replace

import pytest

from report.document.extras import Observation, TwinChapter, TwinSection
from report.pages.figure import Figure
from report.pages.links import BrokenLinkError
from report.pages.pieces import Converter
from report.rendering.html import to_html
from report.rendering.markdown import to_markdown
from report.rendering.selection import select
from report.rendering.sources import sources
from tests.report.rendering.sample import sample

SOURCE = "report/twin/cell_check.py"
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><title>Map</title></svg>'


@pytest.fixture(scope="module")
def document():
    items = (
        Observation("twin-a", "A title.", "It is $3$ m.", ("first check", "second < check"), SOURCE),
        Figure("twin-map", "A map", "Where *what* is.", "cells & colours", SVG),
        Observation("twin-b", "", "So.", ("third check",), SOURCE),
    )
    others = (section(name, 2) for name in ("advice", "loop", "questions"))
    return replace(
        sample(), twin=TwinChapter("What play does", (TwinSection("twin-one", "One", items),), *others)
    )


def section(name: str, observations: int) -> TwinSection:
    """Return a section with some observations."""
    found = (Observation(f"{name}-{n}", "", f"{name} {n}", ("a check",), SOURCE) for n in range(observations))
    return TwinSection(name, f"Of {name}", tuple(found))


def test_observations_and_figures_stand_in_their_order(document):
    text = to_markdown(document)["twin"]
    places = [
        text.index(each) for each in ("{#twin}", "{#twin-one}", "#twin-a", "#drawing-twin-map", "#twin-b")
    ]
    assert places == sorted(places)
    assert "second \\< check" in text


def test_advice_loop_and_questions_stand_where_they_are_asked_for(document):
    text = to_markdown(document)
    places = {"advice": "advice", "loop": "derived", "questions": "answers"}
    assert all(f"#{name}-1}}" in text[piece] for name, piece in places.items())
    assert text["answers"].index("raises the peaks") < text["answers"].index("#questions-1}")


@pytest.mark.slow
def test_the_page_holds_the_drawing_the_evidence_and_the_code(document):
    html = to_html(document, Converter().html(Converter().parsed(to_markdown(document))))
    assert SVG in html
    assert '<li><a href="#twin">What play does</a>' in html
    assert "<strong>A title.</strong> It is" in html
    assert 'href="#code-report-twin-cell_check"' in html
    (shown,) = (each for each in sources(document) if each.path == SOURCE)
    assert [each.id for each in shown.findings][4:6] == ["twin-a", "twin-b"]


def test_a_part_of_the_report_leaves_the_chapter_out(document):
    part = select(document, ["ch5"])
    assert part.twin is None
    assert to_markdown(part)["twin"].strip() == ""


def test_a_source_that_is_not_there_is_named(document):
    observation = replace(document.twin.observations[0], source="report/twin/nothing.py")
    advice = replace(document.twin.advice, items=(observation,))
    with pytest.raises(BrokenLinkError, match="advice-0"):
        sources(replace(document, twin=replace(document.twin, advice=advice)))
