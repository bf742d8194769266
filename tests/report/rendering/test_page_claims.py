"""Search, filter and links among the claims, in a real browser."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from report.claim import Verdict
from report.document import Document
from tests.report.rendering.page_checks import Visit

pytestmark = pytest.mark.browser


def shown(page: Page) -> set[str]:
    return set(
        page.evaluate(
            "[...document.querySelectorAll('article.claim')].filter(c => c.checkVisibility()).map(c => c.id)"
        )
    )


def ids(document: Document, *verdicts: Verdict) -> set[str]:
    return {finding.id for finding in document.findings if not verdicts or finding.verdict in verdicts}


def checkbox(page: Page, verdict: Verdict) -> Locator:
    return page.get_by_role("checkbox", name=verdict.value, exact=True)


def search(page: Page, text: str) -> list[str]:
    """Search in the claims; return the headings of what is found, in their order."""
    page.get_by_label("Search in claims").fill(text)
    return page.locator(".results a").all_inner_texts()


def test_the_verdict_filter_hides_the_other_claims_and_is_in_the_address(
    visit: Callable[..., Visit], document: Document
) -> None:
    page = visit().page
    for verdict in Verdict:
        if verdict is not Verdict.ERRATUM:
            checkbox(page, verdict).uncheck()
    errata = ids(document, Verdict.ERRATUM)
    assert shown(page) == errata
    assert page.evaluate("location.search") == "?verdict=erratum"
    expect(page.locator("search .state output")).to_have_text(
        f"{len(errata)} of {len(document.findings)} claims shown"
    )


def test_an_address_with_a_filter_opens_filtered(visit: Callable[..., Visit], document: Document) -> None:
    page = visit("?verdict=erratum,explained&chapter=2").page
    wanted = {Verdict.ERRATUM, Verdict.EXPLAINED}
    assert shown(page) == {f.id for f in document.chapters[0].findings if f.verdict in wanted}
    assert page.locator("select[name=chapter]").input_value() == "2"


@pytest.mark.parametrize("end", ["?verdict=unheard-of&chapter=99#%E0%A4%A", "?verdict="])
def test_an_address_that_makes_no_sense_shows_everything(
    visit: Callable[..., Visit], document: Document, end: str
) -> None:
    visited = visit(end)
    assert shown(visited.page) == ids(document)
    assert visited.page.locator(".source button").count() > 0
    assert visited.complaints == []


def test_a_filter_that_fits_nothing_hides_the_chapter_headings(visit: Callable[..., Visit]) -> None:
    page = visit("?verdict=not-checkable&chapter=2").page
    assert shown(page) == set()
    assert not page.locator("#chapter-2").is_visible()


def test_a_section_without_claims_to_show_is_hidden(visit: Callable[..., Visit]) -> None:
    page = visit("?verdict=reproduced&chapter=2").page
    assert page.locator("[id='section-2.2.2']").is_visible()
    assert not page.locator("[id='section-2.3.4']").is_visible()


def test_a_link_to_a_hidden_claim_shows_it(visit: Callable[..., Visit]) -> None:
    page = visit("?verdict=erratum").page
    page.evaluate("location.hash = '#eq-2.8'")
    expect(page.locator("[id='eq-2.8']")).to_be_in_viewport()
    assert page.evaluate("location.search") == ""


def test_a_link_with_a_dot_in_its_id_leads_to_the_claim(visit: Callable[..., Visit]) -> None:
    page = visit("#eq-2.36").page
    assert page.evaluate("document.querySelector(':target').id") == "eq-2.36"
    expect(page.locator("[id='eq-2.36']")).to_be_in_viewport()


def test_a_count_in_the_summary_filters_the_claims(visit: Callable[..., Visit], document: Document) -> None:
    page = visit().page
    page.locator("details.fold summary").first.click()
    page.locator("a[data-filter='verdict=erratum&chapter=2']").click()
    page.wait_for_function("location.search === '?verdict=erratum&chapter=2'")
    chapter = {finding.id for finding in document.chapters[0].findings}
    assert shown(page) == ids(document, Verdict.ERRATUM) & chapter
    assert page.evaluate("location.hash") == "#chapter-2"


def test_the_filter_works_by_keyboard_and_can_be_reset(
    visit: Callable[..., Visit], document: Document
) -> None:
    page = visit().page
    checkbox(page, Verdict.ERRATUM).press(" ")
    assert shown(page) == ids(document) - ids(document, Verdict.ERRATUM)
    page.get_by_role("button", name="Show all").press(" ")
    page.wait_for_function("location.search === ''")
    assert shown(page) == ids(document)


def test_a_search_lists_what_fits_best_first_and_hides_the_rest(visit: Callable[..., Visit]) -> None:
    page = visit().page
    found = search(page, "spectrum")
    assert found == ["Figure 5.2: spectrum of the output"]
    assert shown(page) == {"fig-5.2"}
    assert page.evaluate("location.search") == "?query=spectrum"
    found = search(page, "Equation 2.36")
    assert found[0] == "Equation 2.36: waveform"


def test_a_search_needs_all_words_in_any_case_and_order(visit: Callable[..., Visit]) -> None:
    page = visit().page
    assert search(page, "DECADE roll-off per") == [
        "Statement in section 5.1.2: roll-off of −60 dB per decade"
    ]
    assert search(page, "roll-off -60") != []  # the minus of the keyboard finds the printed one
    assert search(page, "roll-off giraffe") == []


def test_the_first_result_is_opened_by_enter(visit: Callable[..., Visit]) -> None:
    page = visit().page
    page.keyboard.press("/")
    expect(page.get_by_label("Search in claims")).to_be_focused()
    page.keyboard.type("impulse")
    page.keyboard.press("Enter")
    page.wait_for_function("location.hash === '#txt-5.2.1-impulse-1e-8'")
    expect(page.locator("[id='txt-5.2.1-impulse-1e-8']")).to_be_in_viewport()


def test_an_address_with_a_search_opens_with_it(visit: Callable[..., Visit]) -> None:
    page = visit("?query=A-matrix").page
    assert "eq-2.12" in shown(page)
    assert page.get_by_label("Search in claims").input_value() == "A-matrix"
