"""The sliders in a real browser: the nearest solved motion is shown, and said to be so."""

import json
import re
from collections.abc import Callable, Mapping

import pytest
from playwright.sync_api import Page, expect

from report.design.report import DesignReport
from report.design.tables.judged import target_rows
from report.pages.formats import Format
from tests.report.rendering.page_checks import Visit, lead, violations

pytestmark = pytest.mark.browser
MOST_BYTES = 2_000_000


@pytest.fixture
def visit(window, files: Mapping[Format, str | bytes], tmp_path) -> Callable[..., Visit]:
    path = tmp_path / "desk.html"
    content = files[Format.HTML]
    assert isinstance(content, str)
    path.write_text(content, "utf-8")
    return lambda scripts=True, **options: lead(window(scripts), path.as_uri() + "#sliders", **options)


def told(page: Page) -> str:
    return page.locator(".explorable output").inner_text().replace("\xa0", " ")


def move(page: Page, number: int, value: float) -> None:
    page.locator(f".explorable input[name=number{number}]").evaluate(
        "(slider, value) => { slider.value = value; "
        "slider.dispatchEvent(new Event('input', { bubbles: true })); }",
        value,
    )


def test_the_first_view_is_the_file_with_the_values_of_the_verdict(visit, report) -> None:
    visited = visit()
    shown = told(visited.page)
    assert "Shown is the motion solved for: " in shown
    assert ", as in the file." in shown
    for row in target_rows(report.design)[1:4]:
        assert f"{row[0]}: {row[2]}, {row[1]} is wanted" in shown
    assert visited.page.locator(".explorable svg svg path").count() > 4
    assert visited.complaints == []


def test_between_solved_motions_the_nearest_is_shown_and_said_so(visit, report) -> None:
    page, grid, sliders = visit().page, report.design.grid, report.explorable
    values, slider = grid.values[0], sliders.sliders[0]
    before = page.locator(".explorable svg svg path.load").first.get_attribute("d")
    move(page, 0, 0.3 * values[-2] + 0.7 * values[-1])
    shown = told(page)
    assert "The solved motion nearest to the sliders is shown: " in shown
    nearest = f"{values[-1] * slider.factor:.3g} {slider.unit}"
    assert f": {slider.label[0].lower()}{slider.label[1:]} {nearest}, " in shown
    assert ", as in the file." not in shown
    assert page.locator(".explorable svg svg path.load").first.get_attribute("d") != before
    page.get_by_role("button", name="Back to the first view").click()
    expect(page.locator(".explorable output")).to_contain_text(", as in the file.")


def test_without_a_script_there_is_a_sentence_and_no_slider(visit: Callable[..., Visit]) -> None:
    page = visit(scripts=False).page
    assert "nothing between them is guessed" in page.locator("body").inner_text()
    assert page.locator(".explorable input").count() == 0


def test_they_are_legible_on_a_phone(visit: Callable[..., Visit]) -> None:
    page = visit(width=390).page
    assert violations(page, ".explorable") == []
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_the_table_is_small_and_whole(report: DesignReport) -> None:
    sliders, grid = report.explorable, report.design.grid
    table = json.loads(re.sub(r"^const solvedMotions = |;\n$", "", sliders.script))
    assert len(table["motions"]) == len(grid.motions)
    of_each = len(sliders.script) / len(grid.motions)
    assert of_each * (10 * 10 * 10) < MOST_BYTES  # eight steps of three numbers, each with two values more
