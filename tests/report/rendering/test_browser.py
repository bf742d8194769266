"""The HTML report in a real browser."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from report.claim import Verdict
from report.document import Document
from report.rendering.request import Format
from tests.report.rendering.chromium import Connection, Page

pytestmark = pytest.mark.browser

SHOWN = "[...document.querySelectorAll('article.claim')].filter(c => c.checkVisibility()).map(c => c.id)"
TOO_WIDE = """
  [...document.querySelectorAll('body *')]
    .filter(e => e.getBoundingClientRect().right > innerWidth + 1 && !e.closest('math, svg'))
    .filter(e => { for (let p = e.parentElement; p; p = p.parentElement)
                     if (getComputedStyle(p).overflowX !== 'visible') return false; return true; })
    .map(e => e.tagName + '.' + e.className)
"""
LOW_CONTRAST = """
(() => {
  const canvas = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  const channels = (colour) => { canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = colour;
    canvas.fillRect(0, 0, 1, 1); return [...canvas.getImageData(0, 0, 1, 1).data]; };
  const linear = (c) => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  const ground = (e) => { for (; e; e = e.parentElement) {
    const colour = channels(getComputedStyle(e).backgroundColor); if (colour[3] === 255) return colour; }
    return [255, 255, 255, 255]; };
  const low = [];
  for (const e of document.querySelectorAll('body *')) {
    if (e.closest('svg, script, annotation') || !e.checkVisibility()) continue;
    if (![...e.childNodes].some(n => n.nodeType === 3 && n.data.trim())) continue;
    const [a, b] = [luminance(channels(getComputedStyle(e).color)), luminance(ground(e))];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (ratio < 4.5) low.push([e.tagName, e.className, ratio]);
  }
  return low;
})()
"""


@pytest.fixture
def page(browser: Connection) -> Iterator[Page]:
    page = browser.page()
    page.view(1440, 900)
    yield page
    page.close()


@pytest.fixture
def address(rendered: Mapping[Format, Path]) -> str:
    return rendered[Format.HTML].as_uri()


def test_the_page_is_silent_and_asks_the_network_for_nothing(page: Page, address: str) -> None:
    page.open(address)
    page.evaluate("document.fonts.ready.then(() => true)")
    methods = [event["method"] for event in page.events]
    requests = [event["params"] for event in page.events if event["method"] == "Network.requestWillBeSent"]
    requested = [request["request"]["url"] for request in requests]
    assert "Page.loadEventFired" in methods
    assert not {"Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded"} & set(methods)
    assert address in requested
    assert {url.partition(":")[0] for url in requested} <= {"about", "file", "data"}
    assert [url for url in requested if url.startswith("file:")] == [address]


def test_the_mathematics_font_is_loaded(page: Page, address: str) -> None:
    page.open(address)
    page.evaluate("document.fonts.ready.then(() => true)")
    assert page.evaluate("[...document.fonts].map(font => font.status)") == ["loaded"]


@pytest.mark.parametrize("width", [360, 768, 1440])
def test_nothing_makes_the_page_wider_than_the_window(page: Page, address: str, width: int) -> None:
    page.view(width, 900)
    page.open(address)
    page.evaluate("for (const details of document.querySelectorAll('details')) details.open = true")
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.evaluate(TOO_WIDE) == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_text_stands_out_from_its_ground(page: Page, address: str, scheme: str) -> None:
    page.view(1440, 900, scheme)
    page.open(address)
    page.evaluate("for (const details of document.querySelectorAll('details')) details.open = true")
    assert page.evaluate(LOW_CONTRAST) == []


def test_figures_lie_on_light_ground_in_the_dark(page: Page, address: str) -> None:
    page.view(1440, 900, "dark")
    page.open(address)
    grounds = "[...document.querySelectorAll('.paper')].map(p => getComputedStyle(p).backgroundColor)"
    assert set(page.evaluate(grounds)) == {"rgb(255, 255, 255)"}
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") != "rgb(255, 255, 255)"


def test_a_link_with_a_dot_in_its_id_leads_to_the_claim(page: Page, address: str) -> None:
    page.open(f"{address}#eq-2.36")
    assert page.evaluate("document.querySelector(':target').id") == "eq-2.36"
    assert 0 <= page.evaluate("document.getElementById('eq-2.36').getBoundingClientRect().top") < 900


def test_the_verdict_filter_hides_the_other_claims_and_is_in_the_address(
    page: Page, address: str, document: Document
) -> None:
    page.open(address)
    page.evaluate(
        "document.querySelectorAll('.filter input').forEach(i => { if (i.value !== 'erratum') i.click(); })"
    )
    errata = [finding.id for finding in document.findings if finding.verdict is Verdict.ERRATUM]
    assert page.evaluate(SHOWN) == errata
    assert page.evaluate("location.search") == "?verdict=erratum"
    total = len(document.findings)
    assert page.evaluate("document.querySelector('.filter output').textContent") == (
        f"{len(errata)} of {total} claims shown"
    )


def test_an_address_with_a_filter_opens_filtered(page: Page, address: str, document: Document) -> None:
    page.open(f"{address}?verdict=erratum,explained&chapter=2#claims")
    chapter = document.chapters[0]
    wanted = {Verdict.ERRATUM, Verdict.EXPLAINED}
    assert page.evaluate(SHOWN) == [finding.id for finding in chapter.findings if finding.verdict in wanted]
    assert page.evaluate("document.querySelector('.filter select').value") == "2"


@pytest.mark.parametrize("end", ["?verdict=unheard-of", "?chapter=99", "#%E0%A4%A", "?verdict="])
def test_an_address_that_makes_no_sense_shows_everything(
    page: Page, address: str, document: Document, end: str
) -> None:
    page.open(address + end)
    assert page.evaluate(SHOWN) == [finding.id for finding in document.findings]
    assert page.evaluate("document.querySelector('.source button') !== null")


def test_a_filter_that_fits_nothing_hides_the_chapter_headings(page: Page, address: str) -> None:
    page.open(f"{address}?verdict=not-checkable&chapter=2")
    assert page.evaluate(SHOWN) == []
    assert not page.evaluate("document.getElementById('chapter-2').checkVisibility()")


def test_a_link_to_a_hidden_claim_shows_it(page: Page, address: str) -> None:
    page.open(f"{address}?verdict=erratum#claims")
    page.evaluate("location.hash = '#eq-2.8'")
    page.wait_for("document.getElementById('eq-2.8').checkVisibility()")
    assert page.evaluate("location.search") == ""


def test_a_count_in_the_summary_filters_the_claims(page: Page, address: str, document: Document) -> None:
    page.open(address)
    page.evaluate("document.querySelector('a[data-filter=\"verdict=erratum&chapter=2\"]').click()")
    page.wait_for("location.search === '?verdict=erratum&chapter=2'")
    errata = Counter(finding.verdict for finding in document.chapters[0].findings)[Verdict.ERRATUM]
    assert len(page.evaluate(SHOWN)) == errata
    assert page.evaluate("location.hash") == "#chapter-2"


def test_the_filter_works_by_keyboard_and_can_be_reset(page: Page, address: str, document: Document) -> None:
    page.open(address)
    page.evaluate("document.querySelector('.filter input[value=erratum]').focus()")
    page.press(" ", 32)
    errata = sum(finding.verdict is Verdict.ERRATUM for finding in document.findings)
    assert len(page.evaluate(SHOWN)) == len(document.findings) - errata
    page.evaluate("document.querySelector('.filter button').focus()")
    page.press(" ", 32)
    page.wait_for("location.search === ''")
    assert len(page.evaluate(SHOWN)) == len(document.findings)


def test_formulas_have_their_root_signs_and_dots(page: Page, address: str) -> None:
    page.open(address)
    tall = "[...document.querySelectorAll('{}')].every(e => e.getBoundingClientRect().height > {})"
    assert page.evaluate("document.querySelectorAll('msqrt').length") > 0
    assert page.evaluate(tall.format("msqrt", 10))
    dots = "[...document.querySelectorAll('mover > mo')].map(e => e.textContent)"
    assert {"\u02d9", "\u00a8"} <= set(page.evaluate(dots))
    assert "\u0307" not in page.evaluate(dots)


def test_all_is_shown_without_script(page: Page, address: str, document: Document) -> None:
    page.send("Emulation.setScriptExecutionDisabled", value=True)
    page.open(address)
    assert page.evaluate(SHOWN) == [finding.id for finding in document.findings]
    assert page.evaluate("document.querySelectorAll('button, input, select').length") == 0
    assert page.evaluate("document.querySelector('nav details').open")


def test_latex_can_be_copied(page: Page, address: str) -> None:
    page.open(address)
    page.send("Emulation.setFocusEmulationEnabled", enabled=True)
    page.evaluate("navigator.clipboard.writeText = async (text) => { window.copied = text; }")
    page.evaluate("document.querySelector('.source button').click()")
    source = page.evaluate("document.querySelector('.source code').textContent")
    assert source == page.evaluate("window.copied") != ""


def test_without_a_clipboard_the_latex_is_selected(page: Page, address: str) -> None:
    page.open(address)
    page.evaluate("navigator.clipboard.writeText = async () => { throw new Error('not allowed'); }")
    page.evaluate("document.querySelector('details.latex').open = true")
    page.evaluate("document.querySelector('.source button').click()")
    page.wait_for("document.querySelector('.source button').textContent === 'Selected'")
    source = page.evaluate("document.querySelector('.source code').textContent")
    assert page.evaluate("getSelection().toString()").strip() == source.strip()
