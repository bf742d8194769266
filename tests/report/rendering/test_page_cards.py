"""Cards by keyboard, in a real browser: each is one tab stop until the reader goes into it."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from report.document.document import Document
from tests.report.rendering import page_checks
from tests.report.rendering.page_checks import Visit

pytestmark = pytest.mark.browser

FOCUSED = "document.activeElement.closest('article.claim')?.id"
IS_CARD = "document.activeElement.matches('article.claim')"
STOPS = """
  (inside) => [...document.querySelectorAll('a[href], button, summary, input, select, [tabindex]')]
    .filter((e) => e.tabIndex >= 0 && e.checkVisibility() && e.matches(`${inside}, ${inside} *`)).length
"""
MANY = 8  # Most links of a table each of which is a stop
STOPS_OF_TABLES = """
  [...document.querySelectorAll('.table-box')]
    .filter((box) => !box.closest('article.claim, .errata-sheet'))
    .map((box) => [...box.querySelectorAll('a[href]')].filter((link) => link.checkVisibility()))
    .map((links) => [links.length, links.filter((link) => link.tabIndex >= 0).length])
"""


def ids(document: Document) -> list[str]:
    return [finding.id for finding in document.findings]


def focus(page: Page, card: str) -> None:
    page.locator(f"[id='{card}']").evaluate("card => card.focus()")


def test_tab_goes_from_card_to_card(shared: Page) -> None:
    page = shared
    cards = page.evaluate("[...document.querySelectorAll('article.claim')].map((card) => card.id)")
    focus(page, cards[0])
    met = [page.evaluate(FOCUSED)]
    for _ in cards[1:4]:
        page.keyboard.press("Tab")
        met.append(page.evaluate(FOCUSED))
        assert page.evaluate(IS_CARD)
    assert met == cards[:4]


def test_each_card_and_each_table_of_errata_or_of_many_links_is_one_stop(visit, document) -> None:
    page = visit().page
    page.wait_for_timeout(300)  # scrolling boxes are found when they are laid out
    assert page.evaluate(STOPS, "article.claim") == len(ids(document))
    tables = page.locator(".errata-sheet .table-box").count()
    assert page.evaluate(STOPS, ".errata-sheet .table-box") == tables > 0
    stops = page.evaluate(STOPS_OF_TABLES)
    assert all((inside == 0) == (links > MANY) for links, inside in stops if links)
    assert max(links for links, _ in stops) > MANY
    assert page_checks.tab_stops(page) <= page_checks.MOST_TAB_STOPS


def test_enter_leads_into_a_card_and_escape_back(shared: Page) -> None:
    page = shared
    card = "txt-5.1.2-roll-off"
    focus(page, card)
    page.keyboard.press("Enter")
    assert page.evaluate(FOCUSED) == card
    assert not page.evaluate(IS_CARD)
    page.keyboard.press("Tab")
    assert page.evaluate(FOCUSED) == card
    page.keyboard.press("Escape")
    assert page.evaluate(IS_CARD)
    page.keyboard.press("Tab")
    assert page.evaluate(FOCUSED) != card


def test_who_follows_a_link_to_a_card_is_in_it(visit: Callable[..., Visit]) -> None:
    page = visit("#eq-2.36").page
    link = page.locator("[id='eq-2.36'] a").first
    assert link.evaluate("link => link.tabIndex") == 0
    page.evaluate("location.hash = '#eq-2.8'")
    expect(page.locator("[id='eq-2.8']")).to_have_class("claim entered")
    assert link.evaluate("link => link.tabIndex") == -1


def test_a_card_says_its_title_and_how_to_go_into_it(shared: Page) -> None:
    page = shared
    card = page.get_by_role("article", name="Statement in section 5.1.2: roll-off of −60 dB per decade")
    card.focus()
    page.keyboard.press("Shift+Tab")
    page.keyboard.press("Tab")
    hint = card.evaluate("card => getComputedStyle(card, '::before').content")
    assert "Enter" in hint
    assert card.get_attribute("aria-keyshortcuts") == "Enter"
