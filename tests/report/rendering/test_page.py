"""The HTML report as a whole in a real browser: silent, offline, legible, printable."""

import re
import threading
from collections.abc import Callable, Iterator, Mapping
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from playwright.sync_api import Browser, expect

from report.document.document import Document
from report.pages.figure_colours import in_the_dark
from report.pages.formats import Format
from tests.quick import quick
from tests.report.rendering import page_checks
from tests.report.rendering.page_checks import SCHEMES, WIDTHS, Visit, wait_until

pytestmark = pytest.mark.browser

CLAIMS_SHOWN = "[...document.querySelectorAll('article.claim')].filter(c => c.checkVisibility()).length"
GROUND = "getComputedStyle(document.body).backgroundColor"
WHITE = "rgb(255, 255, 255)"


def test_the_page_is_silent_and_loads_its_mathematics_font_and_nothing_else(visit, address) -> None:
    visited = visit()
    visited.page.evaluate("document.fonts.ready.then(() => true)")
    assert visited.page.evaluate("[...document.fonts].map(font => font.status)") == ["loaded"]
    assert visited.complaints == []
    assert address in visited.requests
    assert page_checks.loaded_from_elsewhere(visited, address) == []


def test_no_line_ends_between_a_number_and_its_unit(visit: Callable[..., Visit]) -> None:
    page = visit().page
    assert page_checks.broken_units(page) == []
    page.evaluate("document.querySelector('.claim p').append(' at 550 Hz.')")
    assert page_checks.broken_units(page) != []


def test_formulas_have_their_root_signs_and_dots_and_nothing_overflows_at_any_width(visit) -> None:
    page = visit().page
    page_checks.unfold(page)
    roots = "[...document.querySelectorAll('msqrt')]"
    heights = page.evaluate(f"{roots}.map(e => e.getBoundingClientRect().height)")
    assert heights and min(heights) > 10
    dots = page.evaluate("[...document.querySelectorAll('mover > mo')].map(e => e.textContent)")
    assert {"\u02d9", "\u00a8"} <= set(dots)
    assert "\u0307" not in dots
    for width in WIDTHS:
        page_checks.resize(page, width)
        assert page_checks.overflowing(page) == [], f"{width} px"


def test_what_overflows_is_noticed(visit: Callable[..., Visit]) -> None:
    page = visit(width=360).page
    page.evaluate(
        "document.querySelector('.claim p').append('x'.repeat(9), Object.assign("
        "document.createElement('b'), { style: 'display: inline-block; width: 400px' }))"
    )
    page_checks.unfold(page)
    assert any("out of article" in fault for fault in page_checks.overflowing(page))


@pytest.mark.parametrize("width", [WIDTHS[0], pytest.param(WIDTHS[-1], marks=pytest.mark.slow)])
def test_axe_finds_no_violation_in_light_and_dark_narrow_and_wide(visit, width) -> None:
    page = visit(width=width).page
    page_checks.unfold(page)
    assert page_checks.violations(page) == []


def test_axe_finds_no_violation_in_a_search_and_would_notice_low_contrast_in_the_dark(
    visit: Callable[..., Visit],
) -> None:
    page = visit("?query=roll-off").page
    assert page_checks.violations(page, "search, nav") == []
    page_checks.dress(page, "@media (prefers-color-scheme: dark) { .claim p { color: #16181b; } }")
    found = page_checks.violations(page, "[id='txt-5.1.2-roll-off']")
    assert any("color-contrast" in fault for fault in found)


def test_all_is_shown_without_script(visit: Callable[..., Visit], document: Document) -> None:
    page = visit(scripts=False).page
    claims = page.locator("article.claim")
    assert claims.count() == len(document.findings)
    assert all(claim.is_visible() for claim in claims.all())
    assert page.locator("button:visible, input:visible, select:visible").count() == 0
    assert page.locator("nav a").first.is_visible()


@pytest.mark.parametrize("scheme", quick(SCHEMES, 1))
def test_the_colours_are_those_of_the_system_until_others_are_chosen(visit, scheme) -> None:
    page = visit(scheme=scheme).page
    ground = page.evaluate(GROUND)
    assert (ground == WHITE) is (scheme == "light")
    other = "dark" if scheme == "light" else "light"
    page.get_by_label("Colours").select_option(other)
    assert (page.evaluate(GROUND) == WHITE) is (other == "light")
    page.reload()
    assert (page.evaluate(GROUND) == WHITE) is (other == "light")
    page.get_by_label("Colours").select_option("")
    assert page.evaluate(GROUND) == ground


def test_figures_follow_the_colours_of_the_page(visit: Callable[..., Visit]) -> None:
    page = visit(scheme="dark").page
    grounds = "[...document.querySelectorAll('.paper')].map(p => getComputedStyle(p).backgroundColor)"
    lines = "getComputedStyle(document.querySelector('[id=\"drawing-fig-5.1\"] path[style*=c0072b2]')).stroke"
    for scheme, ground, line in (
        ("dark", in_the_dark("ffffff"), in_the_dark("0072b2")),
        ("light", "#ffffff", "#0072b2"),
    ):
        page.emulate_media(color_scheme=scheme)
        assert set(page.evaluate(grounds)) == {rgb(ground)}
        assert page.evaluate(lines) == rgb(line)
    page.emulate_media(media="print", color_scheme="dark")
    assert page.evaluate(lines) == rgb("#0072b2")


def rgb(colour: str) -> str:
    """Write #rrggbb as a browser does."""
    return "rgb({}, {}, {})".format(*(int(colour[place : place + 2], 16) for place in (1, 3, 5)))


def test_latex_can_be_copied_and_without_a_clipboard_it_is_selected(visit: Callable[..., Visit]) -> None:
    page = visit().page
    page.evaluate("() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; }")
    page_checks.unfold(page)
    page.locator(".source button").first.click()
    source = page.locator(".source code").first.text_content()
    assert source == page.evaluate("window.copied") != ""
    page.evaluate("() => { navigator.clipboard.writeText = async () => { throw new Error('no'); }; }")
    page.locator(".source button").nth(1).click()
    page.get_by_role("button", name="Selected").wait_for()
    source = page.locator(".source code").nth(1).text_content()
    assert page.evaluate("getSelection().toString()").strip() == (source or "").strip() != ""


def test_the_printed_page_holds_all_claims_and_no_tools(visit, document) -> None:
    page = visit(scheme="dark").page
    assert page_checks.overflowing_in_print(page) == []
    assert page.evaluate(CLAIMS_SHOWN) == len(document.findings)
    assert page.evaluate(GROUND) == WHITE
    hidden = page.locator("nav, search, .figure-tools, .theme, .print-sheet, details.latex")
    assert hidden.count() > 5
    assert not any(element.is_visible() for element in hidden.all())


def test_the_errata_sheet_can_be_printed_alone(visit: Callable[..., Visit]) -> None:
    page = visit().page
    page.evaluate("() => { print = () => { window.printed = document.documentElement.dataset.print; }; }")
    page.get_by_role("button", name="Print this sheet alone").click()
    assert page.evaluate("window.printed") == "errata"
    page.emulate_media(media="print")
    assert page.locator(".errata-sheet").is_visible()
    assert page.evaluate(CLAIMS_SHOWN) == 0
    assert page_checks.pages_of_errata_sheet(page) == 1
    assert page_checks.smallest_print_of_errata_sheet(page) >= page_checks.SMALLEST_PRINT
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert page.evaluate(CLAIMS_SHOWN) > 0


@pytest.fixture
def half_a_page(rendered: Mapping[Format, Path]) -> Iterator[str]:
    """Address at which the page comes up to its first figure, and no further while the test runs."""
    before_figures = rendered[Format.HTML].read_bytes().partition(b'<figure class="drawing"')[0]
    finished = threading.Event()

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.end_headers()
            self.wfile.write(before_figures)
            finished.wait()

        def log_message(self, *_: object) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever).start()
    yield f"http://127.0.0.1:{server.server_address[1]}/"
    finished.set()
    server.shutdown()
    server.server_close()


def test_the_first_paint_does_not_wait_for_figures(browser: Browser, half_a_page: str) -> None:
    page = browser.new_page()
    page.goto(half_a_page, wait_until="commit")
    wait_until(page, "performance.getEntriesByName('first-contentful-paint').length === 1")
    assert page.evaluate("document.readyState") == "loading"
    assert re.match("The linear trimmer", page.locator("h1").inner_text())
    page.close()


def test_the_first_screen_shows_what_matters_and_what_to_do(visit: Callable[..., Visit]) -> None:
    page = visit().page
    for width, height in ((768, 900), (1440, 900)):
        page.set_viewport_size({"width": width, "height": height})
        for part in (".highlights li:last-child", ".designer"):
            expect(page.locator(part)).to_be_in_viewport(ratio=1)
    page.set_viewport_size({"width": 360, "height": 740})  # a phone
    expect(page.locator(".highlights li").first).to_be_in_viewport(ratio=1)
