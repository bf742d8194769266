"""Search, filter and links among the claims, in a real browser."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from report.document.document import Document
from report.judging.verdict import Grade, grade
from report.rendering.summary import GRADES
from tests.report.rendering.page_checks import Visit, wait_until

pytestmark = pytest.mark.browser


def shown(page: Page) -> set[str]:
    claims = "[...document.querySelectorAll('article.claim')]"
    return set(page.evaluate(f"{claims}.filter(c => c.checkVisibility()).map(c => c.id)"))


def ids(document: Document, *grades: Grade) -> set[str]:
    return {finding.id for finding in document.findings if not grades or grade(finding) in grades}


def checkbox(page: Page, one: Grade) -> Locator:
    return page.get_by_role("checkbox", name=GRADES[one], exact=True)


def search(page: Page, text: str) -> list[str]:
    """Search in the report; return the headings of what is found, in their order."""
    page.get_by_label("Search", exact=True).fill(text)
    return [text.replace("\u00a0", " ") for text in page.locator(".results a").all_inner_texts()]


def test_the_grade_filter_hides_the_other_claims_and_is_in_the_address(visit, document) -> None:
    page = visit().page
    for one in Grade:
        if one is not Grade.RESULT:
            checkbox(page, one).uncheck()
    wrong = ids(document, Grade.RESULT)
    assert shown(page) == wrong
    assert page.evaluate("location.search") == "?grade=result"
    told = f"{len(wrong)} of {len(document.findings)} claims shown"
    expect(page.locator("search .state output")).to_have_text(told)


def test_an_address_with_a_filter_opens_filtered(visit: Callable[..., Visit], document: Document) -> None:
    page = visit("?grade=result,slip&chapter=2").page
    wanted = {Grade.RESULT, Grade.SLIP}
    assert shown(page) == {f.id for f in document.chapters[0].findings if grade(f) in wanted}
    assert page.locator("select[name=chapter]").input_value() == "2"


@pytest.mark.parametrize("end", ["?grade=unheard-of&chapter=99#%E0%A4%A", "?grade="])
def test_an_address_that_makes_no_sense_shows_everything(visit, document, end) -> None:
    visited = visit(end)
    assert shown(visited.page) == ids(document)
    assert visited.page.locator(".source button").count() > 0
    assert visited.complaints == []


@pytest.mark.parametrize(
    ("end", "seen", "hidden"),
    [
        ("?grade=not-checkable&chapter=2", "search", "#chapter-2"),
        ("?grade=reproduced&chapter=2", "[id='section-2.2.2']", "[id='section-2.3.4']"),
        ("?query=A-matrix", "[id='eq-2.12']", "[id='eq-2.8']"),
    ],
)
def test_what_an_address_leaves_out_is_hidden_with_its_headings(
    visit, end: str, seen: str, hidden: str
) -> None:
    page = visit(end).page
    assert page.locator(seen).first.is_visible() and not page.locator(hidden).is_visible()


def test_a_link_to_a_hidden_claim_shows_it(visit: Callable[..., Visit]) -> None:
    page = visit("?grade=result").page
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
    page.locator("a[data-filter='grade=result&chapter=2']").click()
    wait_until(page, "location.search === '?grade=result&chapter=2'")
    chapter = {finding.id for finding in document.chapters[0].findings}
    assert shown(page) == ids(document, Grade.RESULT) & chapter
    assert page.evaluate("location.hash") == "#chapter-2"


def test_the_filter_works_by_keyboard_and_can_be_reset(visit, document) -> None:
    page = visit().page
    checkbox(page, Grade.RESULT).press(" ")
    assert shown(page) == ids(document) - ids(document, Grade.RESULT)
    page.get_by_role("button", name="Show all").press(" ")
    wait_until(page, "location.search === ''")
    assert shown(page) == ids(document)


def test_a_search_lists_what_fits_best_first_and_hides_the_rest(shared: Page) -> None:
    page = shared
    found = search(page, "spectrum of")
    assert found == ["Figure 5.2: spectrum of the output"]
    assert shown(page) == {"fig-5.2"}
    assert page.evaluate("location.search") == "?query=spectrum+of"
    found = search(page, "Equation 2.36")
    assert found[0] == "Equation 2.36: waveform"


def test_a_search_needs_all_words_in_any_case_and_order(shared: Page) -> None:
    page = shared
    found = search(page, "DECADE roll-off per")
    assert found[0] == "Statement in section 5.1.2: roll-off of −60 dB per decade"
    assert shown(page) == {"txt-5.1.2-roll-off"}
    assert search(page, "roll-off -60") != []  # the minus of the keyboard finds the printed one
    assert search(page, "roll-off giraffe") == []


def test_the_first_result_is_opened_by_enter(visit: Callable[..., Visit]) -> None:
    page = visit().page
    page.keyboard.press("/")
    expect(page.get_by_label("Search", exact=True)).to_be_focused()
    page.keyboard.type("impulse")
    page.keyboard.press("Enter")
    wait_until(page, "location.hash === '#txt-5.2.1-impulse-1e-8'")
    expect(page.locator("[id='txt-5.2.1-impulse-1e-8']")).to_be_in_viewport()


def test_an_equation_is_found_by_its_number(shared: Page, document: Document) -> None:
    page = shared
    assert search(page, "(2.36)")[0] == "Equation 2.36: waveform"
    (step,) = (each for each in document.derivation if any(e.thesis == "2.36" for e in each.equations))
    assert step.title in search(page, "(2.36)")  # which derives it
    assert search(page, "2.36")[0] == "Equation 2.36: waveform"
    assert all("2.3" not in heading for heading in search(page, "(2.3)"))


def test_a_number_is_found_however_it_is_written(shared: Page) -> None:
    page = shared
    written = ("2e-8", "2·10^-8", "2 × 10^-8", "2*10^-8", "0.00000002", "2.0e-08", "2 · 10⁻⁸")
    found = [search(page, text) for text in written]
    assert all("Sec. 5.2.1: smallest gap" in headings for headings in found), found
    assert "Sec. 5.2.1: smallest gap" not in search(page, "3e-8")


def test_the_derivation_and_the_nomenclature_are_searched(shared: Page) -> None:
    page = shared
    assert "Relay" in search(page, "relay switches")
    (symbol,) = search(page, "stiffness between masses")
    assert symbol.startswith("k1")
    page.locator(".results a").click()
    expect(page.get_by_role("row", name="stiffness between masses 1 and 2")).to_be_in_viewport()


def test_other_words_for_the_same_thing_find_it(visit: Callable[..., Visit]) -> None:
    page = visit().page  # its own, as what is searched is read once
    page.evaluate("document.querySelector('#certificate').append(' of the dead band')")
    for words in ("dead zone", "Deadband", "dead-zone"):
        assert search(page, words) == ["Certificate of the dead band"]


def test_a_search_without_hit_says_what_to_do(visit: Callable[..., Visit], shared: Page) -> None:
    page = shared
    assert search(page, "roll-off giraffe") == []
    hint = page.locator("search .hint")
    expect(hint).to_contain_text("No place has “giraffe”")
    expect(hint).to_contain_text("(5.13)")
    search(page, "roll-off")
    expect(hint).to_be_hidden()
    page = visit("?grade=reproduced&chapter=2").page
    search(page, "roll-off")
    expect(page.locator("search .hint")).to_contain_text("The filter hides")


MARKED = "[...(CSS.highlights.get('search-hit') ?? [])].map((range) => range.toString())"


def test_what_is_found_is_marked(shared: Page) -> None:
    page = shared
    search(page, "Roll-OFF")
    marked = page.evaluate(MARKED)
    assert marked
    assert {text.lower().replace("\u2011", "-") for text in marked} == {"roll-off"}
    search(page, "2e-8")
    assert any("10" in text for text in page.evaluate(MARKED))  # as it stands there: a formula
    page.get_by_role("button", name="Show all").click()
    wait_until(page, "location.search === ''")
    assert page.evaluate(MARKED) == []
