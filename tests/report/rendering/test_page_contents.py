"""The table of contents in a real browser: it marks where the reader is."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.report.rendering.page_checks import Visit

pytestmark = pytest.mark.browser


def expect_current(page: Page, target: str) -> None:
    expect(page.locator("nav a[aria-current=true]")).to_have_attribute("href", f"#{target}")


def test_the_contents_follow_the_reader(shared: Page) -> None:
    page = shared
    page.evaluate("scrollTo(0, 0)")
    expect_current(page, "summary")
    page.locator("[id='section-2.3.4']").evaluate("heading => heading.scrollIntoView()")
    expect_current(page, "section-2.3.4")
    page.evaluate("scrollTo(0, 0)")
    expect_current(page, "summary")


def test_only_the_chapter_that_is_read_is_unfolded(visit: Callable[..., Visit]) -> None:
    page = visit("#section-2.3.4").page
    expect(page.locator("nav a[href='#section-2.2.1']")).to_be_visible()
    expect(page.locator("nav a[href='#section-5.1.1']")).to_be_hidden()
    page.locator("nav a[href='#chapter-5']").click()
    expect(page.locator("nav a[href='#section-5.1.1']")).to_be_visible()
    expect(page.locator("nav a[href='#section-2.2.1']")).to_be_hidden()


def test_an_entry_is_reached_and_followed_by_keyboard(shared: Page) -> None:
    page = shared
    page.locator("nav a[href='#derivation']").focus()
    page.keyboard.press("Enter")
    expect(page.locator("#derivation")).to_be_in_viewport()
    expect_current(page, "derivation")


def test_the_first_tab_stop_skips_to_the_content(visit: Callable[..., Visit]) -> None:
    page = visit().page
    page.keyboard.press("Tab")
    skip = page.get_by_role("link", name="Skip to the content")
    expect(skip).to_be_focused()
    expect(skip).to_be_in_viewport()
    page.keyboard.press("Enter")
    expect(page.locator("main")).to_be_focused()


def test_on_a_narrow_screen_the_contents_are_folded(visit: Callable[..., Visit]) -> None:
    page = visit(width=360).page
    link = page.locator("nav a[href='#chapter-5']")
    expect(link).to_be_hidden()
    page.locator("nav summary").click()
    expect(link).to_be_visible()
