"""What has to hold for every page of the report, the sample's and a real one's.

    python -m tests.report.rendering.page_checks build/report/report.html

judges a report that has been built: it prints what it finds wrong and fails if that is anything.
"""

import re
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import chain, product
from pathlib import Path
from typing import Literal

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Browser, Page, sync_playwright

from tests.conftest import find_chromium

WIDTHS = (360, 768, 1440)
HEIGHT = 900
PATIENCE = 10_000  # How long to wait for something to happen in a page, in ms
LOADING = 60_000
"""How long to wait for a page, in ms: the sample takes seconds, and many times that on a busy machine."""
LARGEST = 8_000_000  # Largest size of the file, in bytes
MOST_ERRATA_PAGES = 8  # Most printed pages of the errata sheet, which is to be laid into the thesis
SMALLEST_PRINT = 12.0  # Smallest type of that sheet, in CSS pixels: 9 pt
MOST_TAB_STOPS = 1000  # Most stops of the Tab key on a page whose cards are closed
FIRST_PAINT = 500.0  # Latest time of the first paint, the best of three visits, in ms
A4_WIDTH = 658
"""Width of the text of a printed A4 page, in CSS pixels: 210 mm less twice the margin of print.css."""
EMPTY = "about:blank"  # Address of a page with nothing in it
Scheme = Literal["light", "dark"]
SCHEMES: tuple[Scheme, ...] = ("light", "dark")

_UNFOLD = "for (const details of document.querySelectorAll('details')) details.open = true"
_LAY_OUT = "* { content-visibility: visible !important; }"
_DRESS = """
  (css) => { // the page's policy forbids an element of style
    const style = new CSSStyleSheet();
    style.replaceSync(css);
    document.adoptedStyleSheets = [...document.adoptedStyleSheets, style];
  }
"""
_SETTLED = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"
_OVERFLOWING = """
  () => {
    const scrolls = (e) => !['visible', 'clip'].includes(getComputedStyle(e).overflowX);
    const frames = document.querySelectorAll('article, td, th, figure, main, header, nav, search, body');
    const rights = new Map([...frames].map((frame) => [frame, frame.getBoundingClientRect().right]));
    const found = [];
    for (const e of document.querySelectorAll('body *')) {
      if (e.closest('svg, .skip') || e.parentElement.closest('math') || !e.checkVisibility()) continue;
      const { right, width } = e.getBoundingClientRect();
      for (let frame = e.parentElement; frame && width > 1 && !scrolls(frame); frame = frame.parentElement) {
        if (right > (rights.get(frame) ?? Infinity) + 1) {
          const text = e.textContent.trim().slice(0, 60).replace(/\\s+/g, ' ');
          found.push(`${e.localName}.${e.className} (${right}) out of ${frame.localName}: ${text}`);
          break;
        }
      }
    }
    const width = document.documentElement.scrollWidth;
    return width > innerWidth ? [`the page is ${width} wide`, ...found] : found;
  }
"""
_TAB_STOPS = """
  [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex]')]
    .filter((e) => e.tabIndex >= 0 && e.checkVisibility()).length
"""
_PAINTED = "performance.getEntriesByName('first-contentful-paint')[0].startTime"
_SHEET_SIZES = """
  [...document.querySelectorAll('.errata-sheet :is(td, th) p, .errata-sheet :is(td, th)')]
    .map((e) => parseFloat(getComputedStyle(e).fontSize))
"""
_BROKEN_UNITS = """
  () => {
    const found = [];
    const walker = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (node.parentElement.closest('pre, code, svg, math, script, .passage, .explorable')) continue;
      const [broken] = node.data.match(
        /.{0,20}[\\d⁰¹²³⁴⁵⁶⁷⁸⁹][ \\n](?:Hz|mm|µm|nm|ms|kN|rad\\/s|dB|N\\/m|%)(?!\\p{L})/u
      ) ?? [];
      if (broken) found.push(broken);
    }
    return found;
  }
"""
# Most elements are inside of formulas, where axe has no rules: the box of a formula takes its place.
_EMPTY_FORMULAS = """
  for (const formula of document.querySelectorAll('math')) {
    const { width, height } = formula.getBoundingClientRect();
    formula.style.cssText = `display: inline-block; width: ${width}px; height: ${height}px`;
  }
  for (const formula of document.querySelectorAll('math')) formula.replaceChildren();
"""


@dataclass(frozen=True)
class Visit:
    """An open page, what it asked for, and what its console and its scripts complained about."""

    page: Page
    requests: list[str] = field(default_factory=list)
    complaints: list[str] = field(default_factory=list)


def wait_until(page: Page, expression: str) -> None:
    """Wait until an expression is true of a page, whose policy forbids what Playwright itself would do."""
    patience = time.monotonic() + PATIENCE / 1000
    while not page.evaluate(expression):
        assert time.monotonic() < patience, f"it did not become true: {expression}"
        page.wait_for_timeout(20)


@contextmanager
def chromium_browser(path: str) -> Iterator[Browser]:
    """Start a Chromium of the system and end it afterwards."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=["--no-sandbox"])
        try:
            yield browser
        finally:
            browser.close()


@contextmanager
def opened(browser: Browser, scripts: bool = True) -> Iterator[Visit]:
    """Open an empty page, which ``lead`` brings to an address."""
    context = browser.new_context(java_script_enabled=scripts)
    context.set_default_timeout(PATIENCE)
    context.set_default_navigation_timeout(LOADING)
    visit = Visit(context.new_page())
    visit.page.on("request", lambda request: visit.requests.append(request.url))
    visit.page.on("console", lambda message: visit.complaints.append(message.text))
    visit.page.on("pageerror", lambda error: visit.complaints.append(str(error)))
    try:
        yield visit
    finally:
        context.close()


def lead(visit: Visit, address: str, width: int = 1440, scheme: Scheme = "light") -> Visit:
    """Bring a page to an address, with nothing remembered from another visit, and return it."""
    page = visit.page
    if page.url != EMPTY:
        page.evaluate("localStorage.clear(); sessionStorage.clear()")
        page.goto(EMPTY)  # or else the same address with another fragment would load nothing
    page.mouse.move(0, 0)
    page.set_viewport_size({"width": width, "height": HEIGHT})
    page.emulate_media(media="null", color_scheme=scheme)
    visit.requests.clear()
    visit.complaints.clear()
    page.goto(address)
    return visit


@contextmanager
def visited(browser: Browser, address: str, width: int = 1440, scheme: Scheme = "light") -> Iterator[Visit]:
    """Open a page of its own at an address."""
    with opened(browser) as visit:
        yield lead(visit, address, width, scheme)


def unfold(page: Page) -> None:
    """Open and lay out everything, what is off the screen too, and wait until the page has taken notice."""
    dress(page, _LAY_OUT)
    page.evaluate(_UNFOLD)
    page.evaluate(_SETTLED)


def dress(page: Page, css: str) -> None:
    """Give a page another style, after its own."""
    page.evaluate(_DRESS, css)


def resize(page: Page, width: int) -> None:
    """Give the window another width, in px, and wait until the page has taken notice."""
    page.set_viewport_size({"width": width, "height": HEIGHT})
    page.evaluate(_SETTLED)


def loaded_from_elsewhere(visit: Visit, address: str) -> list[str]:
    """Return the addresses that the page asked for besides its own."""
    asked = {url for url in visit.requests if not url.startswith(("data:", "blob:", "about:"))}
    return sorted(asked - {address})


def overflowing(page: Page) -> list[str]:
    """Return what ends outside of its claim, cell, figure or window, and cannot be scrolled to."""
    return list(page.evaluate(_OVERFLOWING))


def overflowing_in_print(page: Page) -> list[str]:
    """Return what ends outside of the printed page, where nothing scrolls."""
    page.emulate_media(media="print")
    page.set_viewport_size({"width": A4_WIDTH, "height": HEIGHT})
    return overflowing(page)


def broken_units(page: Page) -> list[str]:
    """Return where a line may end between a number and its unit."""
    return list(page.evaluate(_BROKEN_UNITS))


def tab_stops(page: Page) -> int:
    """Return how often Tab has to be pressed from the first to the last stop of a page."""
    return int(page.evaluate(_TAB_STOPS))


def first_paint(browser: Browser, address: str) -> float:
    """Return when something is painted first, in ms, the best of three visits."""
    times = []
    for _ in range(3):
        with visited(browser, address) as visit:
            times.append(float(visit.page.evaluate(_PAINTED)))
    return min(times)


def smallest_print_of_errata_sheet(page: Page) -> float:
    """Return the smallest type of the errata sheet in print, in CSS pixels."""
    page.emulate_media(media="print")
    return float(min(page.evaluate(_SHEET_SIZES), default=SMALLEST_PRINT))


def pages_of_errata_sheet(page: Page) -> int:
    """Return how many A4 pages the errata sheet takes when it is printed alone."""
    page.evaluate("document.documentElement.dataset.print = 'errata'")
    return len(re.findall(rb"/Type\s*/Page\b", page.pdf(format="A4", prefer_css_page_size=True)))


def violations(page: Page, part: str | None = None) -> list[str]:
    """Return what axe-core finds in light and in dark, each with the elements that it concerns.

    Args:
        page: an open page; its formulas are gone afterwards.
        part: selector of what is judged; without it the whole page is.
    """
    page.evaluate(_EMPTY_FORMULAS)
    found = []
    for scheme, rules in (("light", {}), ("dark", {"runOnly": ["color-contrast"]})):
        page.emulate_media(color_scheme=scheme)  # on which nothing but the contrast depends
        options = {"resultTypes": ["violations"], **rules}  # of the others one example each, which is faster
        found += Axe().run(page, part, options).response["violations"]
    return [f"{rule['id']}: {node['html'][:200]}" for rule in found for node in rule["nodes"]]


def faults(browser: Browser, address: str) -> Iterator[str]:
    """Yield everything that is wrong with a page, with the width and the colours at which it shows."""
    if (paint := first_paint(browser, address)) > FIRST_PAINT:
        yield f"the first paint comes after {paint:.0f} ms"
    for width, scheme in product(WIDTHS, SCHEMES):
        with visited(browser, address, width, scheme) as visit:
            unfold(visit.page)
            if scheme == SCHEMES[0]:  # colours move nothing
                yield from (f"{width} px: {fault}" for fault in overflowing(visit.page))
            yield from (f"{width} px, {scheme}: complaint: {complaint}" for complaint in visit.complaints)
            yield from (f"{width} px: asked for {url}" for url in loaded_from_elsewhere(visit, address))
    with visited(browser, address) as visit:
        if (stops := tab_stops(visit.page)) > MOST_TAB_STOPS:
            yield f"the page has {stops} tab stops"
        yield from (f"a line may end in: {place}" for place in broken_units(visit.page))
        if (size := smallest_print_of_errata_sheet(visit.page)) < SMALLEST_PRINT:
            yield f"print: the errata sheet is set in {size} px"
        yield from (f"print: {fault}" for fault in overflowing_in_print(visit.page))
        if (pages := pages_of_errata_sheet(visit.page)) > MOST_ERRATA_PAGES:
            yield f"print: the errata sheet takes {pages} pages"
    for width in WIDTHS:
        with visited(browser, address, width) as visit:
            unfold(visit.page)
            yield from (f"{width} px: {fault}" for fault in violations(visit.page))


def main(arguments: list[str]) -> int:
    """Judge the page that is named; return 1 if something is wrong with it."""
    (name,) = arguments
    page, chromium = Path(name).resolve(), find_chromium()
    if chromium is None:
        print("Chromium is not installed (package chromium)", file=sys.stderr)
        return 2
    found = 0
    with chromium_browser(chromium) as browser:
        size = [f"the file has {page.stat().st_size} bytes"] if page.stat().st_size > LARGEST else []
        for fault in chain(size, faults(browser, page.as_uri())):
            print(fault, flush=True)  # the whole takes minutes
            found += 1
    print(f"{found} faults" if found else "nothing is wrong")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
