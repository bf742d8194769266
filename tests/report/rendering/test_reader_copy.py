"""The reader's own copy stands in the page as it is, and nowhere else."""

import re
import shutil
from collections.abc import Iterator, Mapping
from html.parser import HTMLParser
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from report.cache.stage_store import StageStore
from report.copy.reading import ReaderCopy
from report.document.document import Document
from report.pages.formats import Format
from report.pages.formulas.foreign_mathematics import to_mathml
from report.pages.pieces import Converter
from report.rendering.html import to_html
from report.rendering.markdown import to_markdown
from report.rendering.render import render
from report.rendering.request import Request
from tests.report.rendering.page_checks import Visit, lead, opened

SECRET = "zanzibar"
HOSTILE = (
    f"{SECRET}<script>window.ran = 1</script><img src=x onerror='window.ran = 2'></code></pre></details>",
    "&lt;b&gt; {{ 7 * 7 }} {% raw %} [link](javascript:alert(1)) ``` ::: <!-- passage eq-2.8 --> $<b>$",
)
LINES = (
    "",
    "",
    r"$$\begin{aligned}",
    r"\dot{u} &= \text{<script>window.ran = 3</script>}",
    r"\end{aligned}\tag{2.8}$$",
    "",
    r"$$\frac{1}{ \href{javascript:window.ran = 4}{x} <img src=x onerror='window.ran = 5'> \quad (5.1)$$",
    "",
    *HOSTILE,
)
"""Lines 3 to 5, 7 and 9 to 10 are those of claims of the sample."""
COPY = ReaderCopy(LINES, "0" * 64, is_judged=True)
OTHER = ReaderCopy(LINES, "f" * 64, is_judged=False)


class Reader(HTMLParser):
    """Collects the text of each passage, as a browser would show it, and all tags."""

    def __init__(self) -> None:
        super().__init__()
        self.texts: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self._inside = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag == "pre" and dict(attrs).get("class") == "copied":
            self.texts.append("")
            self._inside = True

    def handle_endtag(self, tag: str) -> None:
        self._inside = self._inside and tag != "pre"

    def handle_data(self, data: str) -> None:
        if self._inside:
            self.texts[-1] += data


def read(page: str) -> Reader:
    reader = Reader()
    reader.feed(page)
    return reader


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory, rendered: Mapping[Format, Path]) -> Path:
    folder = tmp_path_factory.mktemp("copy")
    shutil.copytree(rendered[Format.HTML].parents[1] / "kept", folder / "kept")
    return folder


@pytest.fixture(scope="module")
def with_copy(document: Document, folder: Path) -> Mapping[Format, Path]:
    """All forms, made with a copy and with a cache."""
    return render(document, folder, Request(copy=COPY), StageStore(folder / "kept"))


@pytest.fixture(scope="module")
def page(with_copy: Mapping[Format, Path]) -> str:
    return with_copy[Format.HTML].read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def other_page(document: Document, with_copy: Mapping[Format, Path], folder: Path) -> str:
    body = Converter.keeping(StageStore(folder / "kept"))
    return to_html(document, body.html(body.parsed(to_markdown(document))), OTHER)


def test_each_card_with_lines_shows_them_to_the_letter(page: str) -> None:
    assert read(page).texts == ["\n".join(LINES[2:5]), LINES[6], "\n".join(HOSTILE)]
    assert page.count("The copy has no text there.") == 1


def test_nothing_of_it_acts_as_markup(page: str, rendered: Mapping[Format, Path]) -> None:
    plain = read(rendered[Format.HTML].read_text(encoding="utf-8"))
    copied = read(page)
    for tag in ("script", "img", "a", "b", "strong", "iframe"):
        expected = sum(name == tag for name, _ in plain.tags) + (tag == "strong")
        assert sum(name == tag for name, _ in copied.tags) == expected, tag
    attributes = {name for _, found in copied.tags for name in found}
    assert not {name for name in attributes if name.startswith("on")}
    assert "{{ 7 * 7 }}" in page


def test_equations_are_shown_as_formulas_where_they_can_be_read(page: str) -> None:
    article = page[page.index('id="eq-2.8"') :].partition("</article>")[0]
    passage = article[article.index('<details class="passage" open>') :].partition("</details>")[0]
    assert "lines 3 to 5" in passage
    assert "<math" in passage
    assert '<span class="thesis-number">(2.8)</span>' in passage
    unread = page[page.index('id="eq-5.1"') :].partition("</article>")[0].partition('class="passage"')[2]
    assert "line 7" in unread
    assert "<math" not in unread.partition("</details>")[0]


def test_another_text_is_called_so_on_the_page_and_on_each_card(page: str, other_page: str) -> None:
    assert "the SHA-256 is the same" in " ".join(page.split())
    assert "may not fit" not in page
    assert other_page.count("the lines may not fit") == 4
    assert "f" * 64 in other_page
    assert "Another text is in this page than the one that was judged" in other_page


def test_without_a_copy_nothing_marks_its_place(rendered: Mapping[Format, Path]) -> None:
    page = rendered[Format.HTML].read_text(encoding="utf-8")
    assert not re.search("<!-- (passage|reader)", page)
    assert 'class="passage' not in page


def test_a_copy_changes_the_page_alone(rendered, with_copy) -> None:
    for form, path in with_copy.items():
        assert (path.read_bytes() == rendered[form].read_bytes()) == (form is not Format.HTML), form


def test_the_cache_holds_nothing_of_it(document, rendered, page, folder, tmp_path) -> None:
    kept = folder / "kept"
    assert SECRET in page
    assert list(kept.iterdir())
    assert not [path for path in kept.iterdir() if SECRET.encode() in path.read_bytes()]
    without = render(document, tmp_path, Request(formats=frozenset({Format.HTML})), StageStore(kept))
    assert without[Format.HTML].read_bytes() == rendered[Format.HTML].read_bytes()


@pytest.mark.parametrize(
    ("latex", "is_read"),
    [
        (r"\frac{a}{b} \tag{2}", True),
        (r"\text{<img src=x onerror=1>}", True),
        ("a\x00\x01b < c & d", False),
        (r"\newcommand{\x}{\x\x}\x", False),
        (r"\href{javascript:1}{x}", False),
        ("{" * 3000, False),
        ("a" * 20_001, False),
        ("</p><p>", True),
    ],
)
def test_formulas_of_others_are_read_or_left(latex: str, is_read: bool) -> None:
    before, found, after = to_mathml(["x = 1", latex, "y = 2"])
    assert before and after
    assert (found is not None) == is_read
    for _, attributes in read(found or "").tags:
        assert not {name for name in attributes if name.startswith("on") or name in ("href", "src")}


@pytest.fixture(scope="module")
def visited(browser: Browser, with_copy: Mapping[Format, Path]) -> Iterator[Visit]:
    with opened(browser) as visit:
        lead(visit, with_copy[Format.HTML].as_uri())
        yield visit


@pytest.mark.browser
def test_nothing_of_it_runs_in_a_browser(visited: Visit) -> None:
    assert visited.page.evaluate("window.ran") is None
    assert visited.page.locator("details.passage").count() == 4
    assert visited.page.locator("pre.copied").last.text_content() == "\n".join(HOSTILE)
    assert not re.search("error", " ".join(visited.complaints), re.IGNORECASE)
