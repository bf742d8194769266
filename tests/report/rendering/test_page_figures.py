"""Zoom and read-out of figures in a real browser, by mouse and by keyboard."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Locator, Page, expect

from tests.report.rendering.page_checks import unfold, visited
from tests.report.rendering.sample_figures import PEAK

pytestmark = pytest.mark.browser

LOCUS, SPECTRUM, BLOCKS = "drawing-fig-5.1", "drawing-fig-5.2", "drawing-fig-2.3"


@pytest.fixture(scope="module")
def page(browser: Browser, address: str) -> Iterator[Page]:
    with visited(browser, address) as visit:
        unfold(visit.page)  # or else the page moves when what is above a figure is laid out
        yield visit.page


def drawing(page: Page, name: str) -> Locator:
    """Return a figure in the middle of the window, zoomed out and not pointed at."""
    figure = page.locator(f"[id='{name}']")
    for whole in figure.get_by_role("button", name="Whole figure").all():
        whole.click()
    page.mouse.move(0, 0)
    figure.evaluate("figure => figure.scrollIntoView({ block: 'center' })")
    return figure


def point_at(page: Page, figure: Locator, across: float, up: float) -> None:
    """Move the mouse to shares of the width and height of the figure's axes, from their lower left corner."""
    place = figure.locator("svg").evaluate(
        """(svg, [across, up]) => {
          const [left, top, width, height] = JSON.parse(svg.dataset.axes)[0].box;
          const point = new DOMPoint(left + across * width, top + (1 - up) * height);
          const { x, y } = point.matrixTransform(svg.getScreenCTM());
          return [x, y];
        }""",
        [across, up],
    )
    page.mouse.move(*place)


def read(figure: Locator) -> str:
    return figure.locator("output").inner_text()


def number(text: str, name: str) -> float:
    found = re.search(rf"{name} = ([−\d.e+-]+)", text)
    assert found is not None, text
    return float(found[1].replace("−", "-"))


def test_omega_is_read_along_a_locus(page: Page) -> None:
    figure = drawing(page, LOCUS)
    exact = (1 + 1j) ** -3  # at omega = 1 rad/s; the axes go from -0.5 to 1.2 and from -1 to 0.4
    point_at(page, figure, (exact.real + 0.5) / 1.7, (exact.imag + 1.0) / 1.4)
    text = read(figure)
    assert number(text, "ω") == pytest.approx(1.0, abs=0.03)
    assert number(text, "real part") == pytest.approx(exact.real, abs=0.01)
    assert number(text, "imaginary part") == pytest.approx(exact.imag, abs=0.01)
    hertz = re.search(r"\(([\d.]+) Hz\)", text)
    assert hertz is not None
    assert float(hertz[1]) == pytest.approx(1.0 / (2 * math.pi), abs=0.005)


def test_the_peak_of_a_spectrum_is_read_from_its_line(page: Page) -> None:
    figure = drawing(page, SPECTRUM)
    point_at(page, figure, PEAK / 1000, 0.75)  # three of the four decades of its axis
    text = read(figure)
    assert number(text, "frequency") == pytest.approx(PEAK, abs=2.0)
    assert number(text, "amplitude") == pytest.approx(1.0, rel=0.05)


def test_outside_of_the_axes_nothing_is_read(page: Page) -> None:
    figure = drawing(page, LOCUS)
    point_at(page, figure, -0.1, 0.5)
    assert read(figure) == "outside of the axes"


def view(figure: Locator) -> list[float]:
    return [float(number) for number in figure.locator("svg").get_attribute("viewBox").split()]


def test_zooming_keeps_what_is_read_in_place_and_ends_with_the_whole(page: Page) -> None:
    figure = drawing(page, LOCUS)
    whole = view(figure)
    point_at(page, figure, 0.25, 0.3)
    before = read(figure)
    figure.get_by_role("button", name="Zoom in").click()
    assert view(figure)[2] == pytest.approx(whole[2] / 1.5)
    point_at(page, figure, 0.25, 0.3)
    assert read(figure).partition(",")[0] == before.partition(",")[0]
    figure.get_by_role("button", name="Whole figure").click()
    assert view(figure) == whole


def test_a_figure_is_zoomed_and_read_by_keyboard(page: Page) -> None:
    figure = drawing(page, LOCUS)
    paper = figure.locator(".paper")
    paper.focus()
    page.keyboard.press("+")
    assert view(figure)[2] < 400
    page.keyboard.press("ArrowRight")
    first = number(read(figure), "real part")
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    assert number(read(figure), "real part") > first
    expect(figure.locator("output")).to_have_attribute("aria-live", "polite")
    page.keyboard.press("0")
    assert not paper.evaluate("paper => paper.classList.contains('zoomed')")


def test_a_zoomed_figure_is_moved_by_dragging(page: Page) -> None:
    figure = drawing(page, LOCUS)
    point_at(page, figure, 0.5, 0.5)
    page.mouse.dblclick(
        *page.evaluate("""() => {
      const { x, y, width, height } = document.getElementById('drawing-fig-5.1').querySelector('svg')
        .getBoundingClientRect();
      return [x + width / 2, y + height / 2];
    }""")
    )
    left = view(figure)[0]
    box = figure.locator("svg").bounding_box()
    assert box is not None
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.move(*middle)
    page.mouse.down()
    page.mouse.move(middle[0] - 40, middle[1])
    page.mouse.up()
    assert view(figure)[0] > left


def test_a_drawing_without_scales_has_no_tools(page: Page) -> None:
    figure = drawing(page, BLOCKS)
    assert figure.get_by_role("button").count() == 0
