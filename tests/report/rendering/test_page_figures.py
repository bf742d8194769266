"""Zoom and read-out of figures in a real browser, by mouse and by keyboard."""

import math
import re

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.report.rendering.page_checks import unfold
from tests.report.rendering.sample_figures import PEAK

pytestmark = pytest.mark.browser

LOCUS, SPECTRUM, BLOCKS = "drawing-fig-5.1", "drawing-fig-5.2", "drawing-fig-2.3"


@pytest.fixture(scope="module")
def page(shared: Page) -> Page:
    unfold(shared)  # or else the page moves when what is above a figure is laid out
    return shared


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


def test_a_peak_is_met_from_beside_it_and_from_below(page: Page) -> None:
    figure = drawing(page, SPECTRUM)
    for across, up in ((PEAK / 1000 + 0.02, 0.74), (PEAK / 1000 + 0.005, 0.4)):
        point_at(page, figure, across, up)
        assert read(figure).startswith("peak: ")
        assert number(read(figure), "frequency") == pytest.approx(PEAK, abs=0.05)
    point_at(page, figure, 0.2, 0.4)
    assert not read(figure).startswith("peak: ")


def numbers_at(figure: Locator) -> list[str]:
    """The numbers that are shown in the place of the drawing's own, which then are hidden."""
    return figure.locator(".zoom-number").all_text_contents()


def sizes(figure: Locator) -> list[object]:
    """What zooming has to keep: the part of the drawing, its frame, its labels and the width of its curve."""
    return list(
        figure.locator("svg").evaluate("""(svg) => {
          const box = (end) => {
            const { x, y, width, height } = svg.querySelector(`[id$="${end}"]`).getBoundingClientRect();
            return [x, y, width, height].map(Math.round);
          };
          const line = svg.querySelector('path[style*=c0072b2]');
          return [svg.getAttribute('viewBox'), ...['-patch_2', '-label_x_0', '-label_y_0'].map(box),
            getComputedStyle(line).strokeWidth, line.getCTM().a];
        }""")
    )


def width_of_curve(figure: Locator) -> float:
    curve = figure.locator("path[style*=c0072b2]").first
    return float(curve.evaluate("line => line.getBoundingClientRect().width"))


def test_zooming_keeps_frame_and_labels_and_what_is_read_in_place(page: Page) -> None:
    figure = drawing(page, LOCUS)
    before, width = sizes(figure), width_of_curve(figure)
    point_at(page, figure, 0.25, 0.3)
    place = read(figure).partition(";")[0]
    figure.get_by_role("button", name="Zoom in").click()
    assert sizes(figure) == before
    assert width_of_curve(figure) == pytest.approx(1.5 * width, rel=0.01)
    point_at(page, figure, 0.25, 0.3)
    for name in ("real part", "imaginary part"):
        assert number(read(figure), name) == pytest.approx(number(place, name), abs=0.01)
    figure.get_by_role("button", name="Whole figure").click()
    assert (sizes(figure), width_of_curve(figure)) == (before, pytest.approx(width, rel=1e-3))
    assert numbers_at(figure) == []


def test_the_numbers_at_the_axes_are_those_of_the_part(page: Page) -> None:
    figure = drawing(page, LOCUS)
    own = figure.locator("[id$='-xtick_1']")
    assert own.evaluate("tick => getComputedStyle(tick).visibility") == "visible"
    point_at(page, figure, 1.0, 1.0)
    for _ in range(4):
        figure.get_by_role("button", name="Zoom in").click()
    assert own.evaluate("tick => getComputedStyle(tick).visibility") == "hidden"
    shown = [float(text.replace("−", "-")) for text in numbers_at(figure)]
    across = [value for value in shown if 1.2 - 1.7 / 1.5**4 - 1e-6 <= value <= 1.2 + 1e-6]
    up = [value for value in shown if 0.4 - 1.4 / 1.5**4 - 1e-6 <= value <= 0.4 + 1e-6]
    assert len(across) >= 3
    assert len(up) >= 3
    assert len(across) + len(up) >= len(shown)


def test_axes_with_a_logarithmic_scale_keep_powers_of_ten(page: Page) -> None:
    figure = drawing(page, SPECTRUM)
    point_at(page, figure, 0.5, 0.5)
    figure.get_by_role("button", name="Zoom in").click()
    powers = [text for text in numbers_at(figure) if re.fullmatch("10[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+", text)]
    assert powers == ["10⁻²", "10⁻¹", "10⁰"]


def test_a_figure_is_zoomed_and_read_by_keyboard(page: Page) -> None:
    figure = drawing(page, LOCUS)
    paper = figure.locator(".paper")
    point_at(page, figure, 0.5, 0.5)
    page.mouse.move(0, 0)
    paper.focus()
    page.keyboard.press("+")
    assert numbers_at(figure) != []
    page.keyboard.press("ArrowRight")
    first = number(read(figure), "real part")
    for _ in range(3):
        page.keyboard.press("Shift+ArrowRight")
    assert number(read(figure), "real part") > first
    expect(figure.locator("output")).to_have_attribute("aria-live", "polite")
    page.keyboard.press("0")
    assert not paper.evaluate("paper => paper.classList.contains('zoomed')")


def test_a_zoomed_figure_is_moved_by_dragging(page: Page) -> None:
    figure = drawing(page, LOCUS)
    point_at(page, figure, 0.5, 0.5)
    before = number(read(figure), "real part")
    box = figure.locator("svg").bounding_box()
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.dblclick(*middle)
    page.mouse.move(*middle)
    page.mouse.down()
    page.mouse.move(middle[0] - 80, middle[1])
    page.mouse.up()
    point_at(page, figure, 0.5, 0.9)
    assert number(read(figure), "real part") > before + 0.05


def test_a_drawing_without_scales_has_no_tools(page: Page) -> None:
    figure = drawing(page, BLOCKS)
    assert figure.get_by_role("button").count() == 0
