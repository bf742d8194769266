import re
from xml.etree import ElementTree

import matplotlib
import pytest
from matplotlib.figure import Figure

from report.chapters.chapter_2.figures.block_diagrams import feedback_system, linear_system
from report.judging.figure import FigureRecord
from report.pages.drawing.style import LINES, new_figure, style
from report.pages.drawing.svg import to_svg

SVG = "{http://www.w3.org/2000/svg}"


def plot(identifier: str) -> str:
    with style():
        figure = new_figure(2.0)
        axes = figure.subplots()
        axes.plot([0, 1], [1, 2], label="$G(s)$", clip_on=True)
        axes.plot([0, 1], [2, 1])
        axes.fill_between([0, 1], [0, 0], [1, 1], hatch="//")
        axes.legend()
    return to_svg(figure, identifier, "A & B", "Two lines < that cross")


def test_a_last_digit_of_the_layout_changes_nothing() -> None:
    texts = []
    for left in (0.1, 0.1 + 2**-52):
        with style():
            figure = Figure(figsize=(4.0, 2.0))
            axes = figure.add_axes((left, 0.2, 0.8, 0.7))
            axes.plot([0, 1], [1, 2], marker="o")
            axes.fill_between([0, 1], [0, 0], [1, 1], hatch="//")
        texts.append(to_svg(figure, "fig-5.1", "A", "B"))
    assert texts[0] == texts[1]


def test_places_have_two_decimals_and_scales_keep_all() -> None:
    svg = plot("fig-5.1")
    places = " ".join(re.findall(r'\s(?:d|x|y)="([^"]*)"', svg))
    assert re.search(r"\d\.\d", places)
    assert not re.search(r"\d\.\d{3}|-0(?![\d.])", places)
    assert re.search(r"scale\(0\.\d{3}", svg)


def test_nothing_is_written_that_nobody_sees_or_that_reaches_out_of_the_figure() -> None:
    svg = plot("fig-5.1")
    assert not re.search("<!--|<style|<metadata", svg)
    assert not re.search(r">\s|\s<", svg.partition("</desc>")[2])
    assert re.search(r' d="M [\d.]+ [\d.]+L', svg)


def test_every_reference_has_its_target_and_two_figures_share_no_id() -> None:
    svg = plot("fig-5.1")
    references = set(re.findall(r'href="#([^"]+)"|url\(#([^)]+)\)', svg))
    assert {"".join(reference) for reference in references} <= set(re.findall(r'\bid="([^"]+)"', svg))
    assert "clip-path" in svg
    first, second = (set(re.findall(r'\bid="([^"]+)"', each)) for each in (svg, plot("fig-5.2")))
    assert first and not first & second


def test_the_figure_is_one_element_with_a_title_and_a_description() -> None:
    svg = plot("fig-5.1")
    assert svg.startswith("<svg")
    root = ElementTree.fromstring(svg)
    assert root.get("role") == "img"
    named = [root.find(f"{SVG}title"), root.find(f"{SVG}desc")]
    assert [element.text for element in named] == ["A & B", "Two lines < that cross"]
    assert root.get("aria-labelledby") == " ".join(element.get("id") for element in named)


def test_the_style_depends_on_nothing_that_was_set_outside_and_leaves_it() -> None:
    settings, before = dict(matplotlib.rcParams), plot("fig-5.1")
    assert dict(matplotlib.rcParams) == settings
    with matplotlib.rc_context({"lines.linewidth": 9.0, "font.size": 30.0, "svg.hashsalt": "other"}):
        assert plot("fig-5.1") == before


def test_lines_differ_by_more_than_their_colour() -> None:
    assert len({line["linestyle"] for line in LINES}) == len({line["color"] for line in LINES}) == len(LINES)


@pytest.mark.parametrize("record", [linear_system, feedback_system], ids=lambda record: record.id)
def test_block_diagrams_stay_inside_their_figure(record: FigureRecord) -> None:
    figure = record.draw(None)
    renderer = figure.canvas.get_renderer() if hasattr(figure.canvas, "get_renderer") else None
    bounds = figure.get_tightbbox(renderer)
    width, height = figure.get_size_inches()
    assert 0 <= bounds.x0 < bounds.x1 <= width
    assert 0 <= bounds.y0 < bounds.y1 <= height
