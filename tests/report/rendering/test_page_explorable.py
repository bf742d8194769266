"""The explorable in a real browser: it answers to its sliders; its picture stands where no script runs."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.report.rendering.page_checks import Visit, violations

pytestmark = pytest.mark.browser

STILL = "#explorable-still"


@pytest.fixture
def page(shared: Page) -> Page:
    """The explorable at its first view."""
    shared.get_by_role("button", name="Back to the first view").click()
    expect(shared.locator(".explorable output")).to_contain_text("716.20 Hz")
    return shared


def cycles(page: Page) -> str:
    return page.locator(".explorable output").inner_text().replace("\xa0", " ")


def move(page: Page, name: str, value: float) -> None:
    page.locator(f".explorable input[name={name}]").evaluate(
        "(slider, value) => { slider.value = value; "
        "slider.dispatchEvent(new Event('input', { bubbles: true })); }",
        value,
    )


def test_the_first_view_is_that_of_the_sliders(visit: Callable[..., Visit]) -> None:
    visited = visit("#explorable")
    assert "716.20 Hz" in cycles(visited.page)
    assert "amplitude 2.5 gaps = 250 µm" in cycles(visited.page)
    assert visited.page.locator(".explorable svg svg path").count() >= 8
    assert visited.complaints == []


def test_a_slider_moves_what_is_shown(page: Page) -> None:
    move(page, "gap", -3.5)
    assert "790.6 µm" in cycles(page)
    move(page, "force", 2.0)
    assert "716.20" not in cycles(page)
    expect(page.locator(".explorable input[name=force] + .value")).to_have_text("2 N")
    page.get_by_role("button", name="Back to the first view").click()
    expect(page.locator(".explorable output")).to_contain_text("716.20 Hz")


def test_a_slider_is_moved_by_keyboard_and_says_its_value(page: Page) -> None:
    slider = page.get_by_role("slider", name="Gap")
    before = cycles(page)
    slider.focus()
    page.keyboard.press("ArrowRight")
    assert cycles(page) != before
    assert slider.get_attribute("aria-valuetext").endswith(" µm")


def test_without_a_limit_cycle_it_says_so(page: Page) -> None:
    move(page, "gap", -6)
    move(page, "force", 2.0)
    assert "no limit cycle" in cycles(page)


def test_the_picture_stands_where_no_script_runs_and_in_print(visit: Callable[..., Visit]) -> None:
    page = visit("#explorable", scripts=False).page
    expect(page.locator(STILL)).to_be_visible()
    page = visit("#explorable").page
    expect(page.locator(STILL)).to_be_hidden()
    page.emulate_media(media="print")
    expect(page.locator(STILL)).to_be_visible()
    expect(page.locator(".explorable")).to_be_hidden()


def test_it_is_legible(visit: Callable[..., Visit]) -> None:
    page = visit("#explorable", width=360).page
    assert violations(page, ".explorable") == []
