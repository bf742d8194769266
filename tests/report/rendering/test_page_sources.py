"""The source files in the page, in a real browser: a card leads to the one that derives it."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.report.rendering.page_checks import Visit, wait_until

pytestmark = pytest.mark.browser

CLAIM, PLACE = "txt-5.1.2-roll-off", "code-trimmer-linear-low_pass"


def link(page: Page) -> Locator:
    return page.locator(f"[id='{CLAIM}']").get_by_role("link", name="trimmer/linear/low_pass.py")


def is_open(page: Page) -> bool:
    return page.locator(f"#{PLACE}").evaluate("place => place.open")


def test_a_card_leads_to_its_source_and_unfolds_it(visit: Callable[..., Visit]) -> None:
    page = visit().page
    code = page.locator(f"#{PLACE} pre")
    assert not is_open(page)
    link(page).click()
    expect(code).to_be_in_viewport()
    expect(code).to_contain_text("def ")
    assert page.evaluate("location.hash") == f"#{PLACE}"
    page.locator(f"#{PLACE} summary").click()
    assert not is_open(page)
    link(page).click()  # the address stays the same
    assert is_open(page)


def test_a_source_leads_back_to_its_cards(visit: Callable[..., Visit]) -> None:
    page = visit(f"#{PLACE}").page
    assert is_open(page)
    page.locator(f"#{PLACE}").get_by_role("link", name=CLAIM).click()
    expect(page.locator(f"[id='{CLAIM}']")).to_be_in_viewport()


def test_a_source_is_read_by_keyboard(visit: Callable[..., Visit]) -> None:
    page = visit().page
    link(page).focus()
    page.keyboard.press("Enter")
    wait_until(page, f"document.getElementById('{PLACE}').open")
    code = page.get_by_role("group", name="trimmer/linear/low_pass.py")
    for _ in range(3):  # past the name of the file and the link to the card
        page.keyboard.press("Tab")
    expect(code).to_be_focused()
    page.keyboard.press("PageDown")
    wait_until(page, "document.activeElement.scrollTop > 0")


def test_long_lines_scroll_inside_of_a_source(visit: Callable[..., Visit]) -> None:
    page = visit(f"#{PLACE}", width=360).page
    code = page.locator(f"#{PLACE} pre")
    assert code.evaluate("code => code.scrollWidth > code.clientWidth")
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_without_script_the_link_leads_to_the_name_of_the_file(visit: Callable[..., Visit]) -> None:
    page = visit(scripts=False).page
    link(page).click()
    summary = page.locator(f"#{PLACE} summary")
    expect(summary).to_be_in_viewport()
    summary.click()
    expect(page.locator(f"#{PLACE} pre")).to_be_visible()


def test_the_code_is_not_printed_and_not_searched(visit: Callable[..., Visit]) -> None:
    page = visit(f"?query=annotations#{PLACE}").page  # a word that every source has, and no claim
    assert page.locator(".results a").count() == 0
    expect(page.locator("#code")).to_be_visible()
    page.emulate_media(media="print")
    expect(page.locator("#code")).to_be_hidden()
    expect(page.locator(f"#{PLACE}")).to_be_hidden()
