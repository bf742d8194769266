"""The chapter on the twin in Markdown and HTML, in whole reports and not in parts."""

from __future__ import annotations

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
    return replace(sample(), twin=TwinChapter("What play does", (TwinSection("twin-one", "One", items),)))


def test_observations_and_figures_stand_in_their_order(document):
    text = to_markdown(document)["twin"]
    places = [
        text.index(each) for each in ("{#twin}", "{#twin-one}", "#twin-a", "#drawing-twin-map", "#twin-b")
    ]
    assert places == sorted(places)
    assert "second \\< check" in text


@pytest.mark.slow
def test_the_page_holds_the_drawing_the_evidence_and_the_code(document):
    html = to_html(document, Converter().html(Converter().parsed(to_markdown(document))))
    assert SVG in html
    assert '<li><a href="#twin">What play does</a>' in html
    assert "<strong>A title.</strong> It is" in html
    assert 'href="#code-report-twin-cell_check"' in html
    (shown,) = (each for each in sources(document) if each.path == SOURCE)
    assert [each.id for each in shown.findings] == ["twin-a", "twin-b"]


def test_a_part_of_the_report_leaves_the_chapter_out(document):
    part = select(document, ["ch5"])
    assert part.twin is None
    assert to_markdown(part)["twin"].strip() == ""


def test_a_source_that_is_not_there_is_named(document):
    observation = replace(document.twin.observations[0], source="report/twin/nothing.py")
    section = replace(document.twin.sections[0], items=(observation,))
    with pytest.raises(BrokenLinkError, match="twin-a"):
        sources(replace(document, twin=replace(document.twin, sections=(section,))))
