"""Names, titles and files of a stranger are text in every form of a report, and act in none."""

import dataclasses
import re
import struct
import subprocess
from collections.abc import Iterator, Mapping
from html import unescape
from html.parser import HTMLParser
from http.server import BaseHTTPRequestHandler, HTTPServer, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from playwright.sync_api import Browser

from report.cache.stage_store import StageStore
from report.design.building import files_of, looked_at, report_on
from report.design.comparison import ComparisonReport, spectra_overlaid
from report.design.markdown import comparison_to_markdown, environment
from report.design.origin import Origin, origin_of
from report.design.render import SCRIPTS, STYLES, rendered
from report.pages.drawing.drawn import drawn
from report.pages.drawing.style import new_figure
from report.pages.escaping import markdown, plain, shown_characters
from report.pages.figure import Figure
from report.pages.formats import Format, Paper
from report.pages.html import Look, page
from report.pages.provenance import provenance
from tests.quick import quick
from tests.report.rendering.page_checks import lead, loaded_from_elsewhere, opened, visited
from trimmer import SerialRunner
from trimmer.design import Design, DesignSettings, compared
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.drawing.look import plain_label
from trimmer.mechanism.place_text import quoted

ROOT = Path(__file__).parents[3]
TINY = DesignSettings(
    starts=1, cells=2, cell_periods=30, neighbours=3, trials=1, most_points=4, range_points=3,
    most_periods=100, grid=1,
)  # fmt: skip
NASTY = (
    "a ![x](http://127.0.0.1:9/beacon.png) b",
    "[y](javascript:alert(1))",
    "![x](secret.png)",
    '</script><script>document.title="ran"</script>',
    '<img src="secret.png" onerror="document.title=1">',
    "`<b>` ``",
    '#image("secret.png")',
    "$\\frac{$ \\input{secret.txt}",
    '{#id .c key="v"} | & % ~ ^ _ * x',
    ":::: {.claim}",
    "_mathtext $x$",
    "# a\\",
    '"""',
    "m" * 300,
)
TEXTS = st.one_of(
    st.sampled_from(NASTY), st.text(min_size=1, max_size=30), st.text(st.characters(categories=["Cc", "Cf"]))
)
NAMES = (
    st.text(st.characters(exclude_categories=["C"]), min_size=1, max_size=20)
    .filter(str.isprintable)
    .map(str.strip)
)


@dataclasses.dataclass(frozen=True)
class Small:
    """A document of a few parts."""

    title: str
    subtitle: str
    origin: Origin
    figures: Mapping[str, Figure]
    explorable: None = None


TEMPLATE = """
{% from "design/macros.md.j2" import table, figure with context %}
## {{ texts[0] | plain }} {#one}

{{ texts[0] }} and {{ bold }}.

{{ table("Of " ~ texts[1], "1fr auto", "left right", rows) }}

::::: {.fold .kept summary={{ texts[2] | attribute }}}
- {{ texts[2] }}, {{ texts[1] | code }}
:::::

{{ figure("one") }}

::: end-of-report
:::
"""


def files_of_small(texts: list[str]) -> dict[Format, str | bytes]:
    """Return a small document that shows texts wherever a report shows names."""

    def draw() -> object:
        figure = new_figure(1.0, 2.0)
        figure.add_subplot().set_xlabel(plain_label(shown_characters(texts[1])))
        return figure

    caption = markdown("**{}** by {}", plain(texts[0]), texts[2])
    figures = {"one": drawn("one", shown_characters(texts[0]), caption, shown_characters(texts[1]), draw)}
    origin = Origin("2026-03-01", ((texts[0], texts[1], "0" * 64),), provenance())
    document = Small(shown_characters(texts[0]), shown_characters(texts[1]), origin, figures)
    rows = [["Name", texts[1]], *([each, markdown("*{}*", plain(each))] for each in texts)]
    values = {"texts": texts, "bold": markdown("**{}**", plain(texts[1])), "rows": rows, "report": document}
    pieces = {"one": environment().from_string(TEMPLATE).render(values)}
    return rendered(document, pieces, frozenset({Format.HTML, Format.PDF}), Paper.A4)


class Skeleton(HTMLParser):
    """Elements of a page with the names of their attributes, in order, and the text of its cells."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, ...]] = []
        self.cells: list[str] = []
        self._inside = self._drawing = False
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._drawing |= tag == "svg"
        if not self._drawing:
            self.elements.append((tag, *(name for name, _ in attrs)))
        if tag in ("td", "th"):
            self._inside = True
            self.cells.append("")

    def handle_endtag(self, tag: str) -> None:
        self._drawing &= tag != "svg"
        self._inside &= tag not in ("td", "th")

    def handle_data(self, data: str) -> None:
        if self._inside:
            self.cells[-1] += data


def words(text: str) -> list[str]:
    """Return the words of a text as pages show it."""
    return shown_characters(text).replace("\u00a0", " ").split()


@pytest.fixture(scope="module")
def harmless() -> Skeleton:
    return Skeleton(str(files_of_small(["x"] * len(NASTY))[Format.HTML]))


SEVERAL = st.lists(TEXTS.filter(words), min_size=len(NASTY), max_size=len(NASTY))


@pytest.mark.slow
@settings(max_examples=40, deadline=None, phases=[Phase.generate])  # making it smaller takes long
@given(SEVERAL)
def test_no_text_changes_what_a_page_is_made_of(harmless: Skeleton, texts: list[str]) -> None:
    """Check that a page with these texts has the elements of a harmless one, and shows each as it is."""
    files = files_of_small(texts)
    found = Skeleton(str(files[Format.HTML]))
    assert found.elements == harmless.elements
    assert [words(cell) for cell in found.cells[2:]] == [words(text) for text in texts for _ in range(2)]
    assert bytes(files[Format.PDF]).startswith(b"%PDF-")


def test_known_attacks_are_shown_as_they_are_written(harmless: Skeleton) -> None:
    found = Skeleton(str(files_of_small(list(NASTY))[Format.HTML]))
    assert found.elements == harmless.elements
    assert [cell.strip() for cell in found.cells[2::2]] == list(NASTY)


SMUGGLED = (
    "<script>document.title = 'ran'</script>",
    "<img src='secret.png' onload=\"document.title = 'ran'\" onerror=\"document.title = 'ran'\">",
    "<img src='SERVER/a.png'>",
    "<svg><image href='SERVER/a.svg'/></svg>",
    "<style>@import url(SERVER/a.css); h2 { display: none !important }</style>",
    "<link rel='stylesheet' href='SERVER/b.css'>",
    "<p style=\"background: url('SERVER/c.png')\">a</p>",
    "<iframe src='SERVER/frame'></iframe>",
    "<object data='secret.png'></object>",
    "<script src='SERVER/a.js'></script>",
    "<a id='bad' href=\"javascript:document.title = 'ran'\">b</a>",
    "<base href='SERVER/'>",
)


class Counting(BaseHTTPRequestHandler):
    """Notes each request."""

    def do_GET(self) -> None:
        self.server.asked.append(self.path)  # type: ignore[attr-defined]
        self.send_response(200)
        self.end_headers()

    def log_message(self, *_: object) -> None:
        """Tell nobody."""


@pytest.fixture
def server() -> Iterator[HTTPServer]:
    with ThreadingHTTPServer(("127.0.0.1", 0), Counting) as server:
        server.asked = []  # type: ignore[attr-defined]
        Thread(target=server.serve_forever, daemon=True).start()
        yield server
        server.shutdown()


@pytest.mark.browser
@pytest.mark.parametrize("stopped", quick([True, False], 0))
def test_the_policy_of_a_page_stops_what_is_smuggled_into_it(browser, tmp_path, server, stopped) -> None:
    """If escaping failed, the page would still ask for nothing and run nothing but its own scripts."""
    smuggled = "".join(SMUGGLED).replace("SERVER", f"http://127.0.0.1:{server.server_port}")
    document = Small("Mine", "", Origin("2026-03-01", (), provenance()), {})
    body = f"<h2 id='one'>A</h2>{smuggled}"
    html = page("design/page.html.j2", Look(STYLES, SCRIPTS, []), body, document=document)
    path = tmp_path / "page.html"
    path.write_text(html if stopped else re.sub("<meta http-equiv[^>]*>", "", html))
    (tmp_path / "secret.png").write_bytes((ROOT / "docs" / "report.png").read_bytes())
    loaded = set()
    with opened(browser) as visit:
        visit.page.on("requestfinished", lambda request: loaded.add(request.url))
        lead(visit, path.as_uri())
        visit.page.evaluate("document.getElementById('bad').click()")
        visit.page.wait_for_timeout(300)
        elsewhere = {url for url in loaded if not url.startswith(("data:", path.as_uri()))}
        assert (visit.page.title() == "Mine") is stopped
        assert visit.page.locator("#one").is_visible() is stopped
        if stopped:
            assert visit.page.locator("search.tools").count() == 1, "its own scripts run"
    assert bool(elsewhere or server.asked) is not stopped  # type: ignore[attr-defined]


def text_of(names: list[str], title: str) -> str:
    """Return the text of a file in which everything that has a name has one of these."""
    motor, cutter, pin, mount, bridge, wall, blade, weight, stroke = map(quoted, names)
    return f"""
title = {quoted(title)}
author = {quoted(title)}
held = {motor}
frequency = 60.0
[bodies]
{motor} = {{ mass = "35 g" }}
{cutter} = {{ mass = "3 g" }}
[pins]
{pin} = {{ on = {motor}, amplitude = "1 mm" }}
[links]
{mount} = {{ between = ["ground", {motor}], stiffness = "200 N/mm", damping = 30.0 }}
[plays]
{bridge} = {{ between = [{cutter}, {pin}], stiffness = "30 N/mm", damping = 4.0, gap = "20 um..60 um" }}
[stops]
{wall} = {{ between = ["ground", {cutter}], stiffness = "30 N/mm", damping = 4.0, gap = "2 mm" }}
[frictions]
{blade} = {{ between = ["ground", {cutter}], force = 0.8 }}
[forces]
{weight} = {{ on = {cutter}, constant = 0.1 }}
[outputs]
{stroke} = {{ {cutter} = 1 }}
[targets]
stroke_at_least = {{ {stroke} = "1.931 mm" }}
impact_speed_at_most = "0.15 m/s"
"""


def made(names: list[str], title: str, folder: Path, name: str = "mine.toml") -> dict[Format, Path]:
    """Return the files of a whole report on such a file."""
    store = StageStore(folder / ".kept")
    file = design_file_of_text(text_of(names, title), name)
    report = report_on(looked_at(file, TINY, SerialRunner(), store, lambda *_: None), store, "2026-03-01")
    files = files_of(report, frozenset({Format.HTML, Format.PDF}), Paper.A4)
    for form, content in files.items():
        path = folder / f"mine.{form.value}"
        path.write_bytes(content.encode() if isinstance(content, str) else content)
    return {form: folder / f"mine.{form.value}" for form in files}


def acting(html: str) -> list[str]:
    """Return the elements of a page that are none of its own."""
    main = html[html.index("<main") : html.index("</main>")]
    return re.findall(r"<(?:img|script|style|link|iframe|object|form|base|a href=\"(?!#))[^>]*>", main)


@pytest.mark.slow
@settings(max_examples=5, deadline=None, phases=[Phase.generate])
@given(st.lists(NAMES.filter(bool), min_size=9, max_size=9, unique_by=str.casefold), NAMES)
def test_a_whole_report_is_made_whatever_names_are(tmp_path_factory, names: list[str], title: str) -> None:
    files = made([each if each != "ground" else "g" for each in names], title, tmp_path_factory.mktemp("d"))
    assert acting(files[Format.HTML].read_text()) == []


@pytest.mark.slow
@pytest.mark.browser
@pytest.mark.poppler
def test_a_report_on_a_hostile_file_asks_for_nothing_and_holds_no_file(
    browser: Browser, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "secret.png").write_bytes((ROOT / "docs" / "report.png").read_bytes())
    (tmp_path / "secret.txt").write_text("secret words")
    files = made(list(NASTY[:9]), NASTY[3], tmp_path, "a`b ![x](secret.png).toml")
    address = files[Format.HTML].as_uri()
    with visited(browser, address) as visit:
        visit.page.evaluate("for (const each of document.querySelectorAll('details')) each.open = true")
        assert loaded_from_elsewhere(visit, address) == []
        assert visit.complaints == []
        assert visit.page.title() == NASTY[3]
    assert acting(files[Format.HTML].read_text()) == []

    def told(*command: str) -> str:
        return subprocess.run([*command], capture_output=True, text=True, check=True).stdout

    pdf = str(files[Format.PDF])
    pixels = struct.unpack(">II", (tmp_path / "secret.png").read_bytes()[16:24])
    # Maps have pictures of their own, such as the bar of their colours.
    pictures = [line.split()[3:5] for line in told("pdfimages", "-list", pdf).splitlines()[2:]]
    assert [*map(str, pixels)] not in pictures
    assert told("pdfdetach", "-list", pdf).startswith("0 ")
    pages = told("pdftotext", "-layout", pdf, "-")
    assert "secret words" not in pages
    assert "a ![x](http://127.0.0.1:9/beacon.png) b" in pages


def test_a_comparison_shows_names_of_files_as_they_are(design: Design) -> None:
    names = ("a`b ![x](secret.png)", "<script>x</script> **y**")
    files = [dataclasses.replace(design.file, name=name) for name in names]
    before, after = (dataclasses.replace(design, file=file) for file in files)
    comparison = compared(before, after)
    figures = spectra_overlaid(comparison, names)
    report = ComparisonReport("A", figures, origin_of(files, "2026-03-01"), comparison, names)
    pieces = comparison_to_markdown(report)
    html = str(rendered(report, pieces, frozenset({Format.HTML}), Paper.A4)[Format.HTML])
    assert acting(html) == []
    shown = unescape(re.sub(r"<[^>]+>", "", html))
    assert all(shown.count(name) >= 4 for name in names)
