"""The HTML file as it is written, without a browser."""

import base64
import html
import io
import itertools
import re
import zipfile
from collections.abc import Mapping
from html.parser import HTMLParser
from pathlib import Path

import pytest

from report.document.document import Document
from report.judging.verdict import grade
from report.octave.archive import files
from report.pages.formats import Format
from report.rendering.sources import identifier
from tests.report.rendering.sample_formulas import SPECIAL

NAMESPACES = {
    "http://www.w3.org/1998/Math/MathML",
    "http://www.w3.org/2000/svg",
    "http://www.w3.org/1999/xlink",
}


class Outline(HTMLParser):
    """Collects all elements with their attributes, and the text of each claim's heading."""

    def __init__(self) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.headings: list[tuple[str, str]] = []
        self._heading: str | None = None

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attributes)))
        if re.fullmatch("h[1-6]", tag):
            self._heading = tag
            self.headings.append((tag, ""))

    def handle_endtag(self, tag: str) -> None:
        self._heading = None if tag == self._heading else self._heading

    def handle_data(self, data: str) -> None:
        if self._heading is not None:
            tag, text = self.headings[-1]
            self.headings[-1] = (tag, text + data)

    def values(self, attribute: str) -> list[str]:
        return [value for _, attributes in self.elements if (value := attributes.get(attribute)) is not None]


@pytest.fixture(scope="module")
def text(rendered: Mapping[Format, Path]) -> str:
    return rendered[Format.HTML].read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def outline(text: str) -> Outline:
    outline = Outline()
    outline.feed(text)
    return outline


def test_no_address_is_loaded_and_the_file_is_small(text: str, outline: Outline) -> None:
    targets = [target for name in ("src", "href", "xlink:href") for target in outline.values(name)]
    assert targets
    assert all(target.startswith(("#", "data:")) for target in targets)
    assert set(re.findall(r"\bhttps?://[^\s\"'<)]+", text)) <= NAMESPACES
    assert set(re.findall(r"url\(\"?([a-z]+):", text)) == {"data"}
    assert len(text.encode()) < 1_000_000


def test_ids_are_unique_and_every_inner_link_has_its_target(outline: Outline) -> None:
    ids = outline.values("id")
    assert len(ids) == len(set(ids))
    links = {target[1:] for target in outline.values("href") if target.startswith("#")}
    assert links <= set(ids)


def test_every_claim_can_be_linked_to(outline: Outline, document: Document) -> None:
    articles = [attributes for tag, attributes in outline.elements if tag == "article"]
    marked = {finding.id: (finding.verdict.value, grade(finding).value) for finding in document.findings}
    assert len(articles) == len(marked)
    assert {one["id"]: (one["data-verdict"], one["data-grade"]) for one in articles} == marked


def test_headings_are_nested_without_a_gap(outline: Outline) -> None:
    levels = [int(tag[1]) for tag, _ in outline.headings]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(after <= before + 1 for before, after in itertools.pairwise(levels))


def test_every_chapter_stands_in_the_contents(text: str, outline: Outline) -> None:
    contents = text[text.index("<nav") : text.index("</nav>")]
    chapters = [attributes["id"] for tag, attributes in outline.elements if tag == "h2" and attributes]
    assert len(chapters) > 10 and [each for each in chapters if f'href="#{each}"' not in contents] == []


def test_plain_text_is_shown_as_it_is(outline: Outline) -> None:
    headings = [text.replace("\xa0", " ") for _, text in outline.headings]
    assert f"Equation 2.8: velocity of the pin {SPECIAL}" in headings


def test_the_page_has_landmarks_and_scoped_table_heads(outline: Outline) -> None:
    tags = [tag for tag, _ in outline.elements]
    assert all(tag in tags for tag in ("header", "nav", "main", "search", "figure", "figcaption", "table"))
    heads = [attributes.get("scope") for tag, attributes in outline.elements if tag == "th"]
    assert set(heads) == {"col", "row"}


def test_figures_are_inside_the_page_and_described(outline: Outline, document: Document) -> None:
    drawings = [attributes for tag, attributes in outline.elements if tag == "svg"]
    panels = [drawing for drawing in drawings if "aria-label" in drawing]
    assert len(panels) == len(document.explorable.panels)
    described = [drawing for drawing in drawings if "aria-labelledby" in drawing]
    # and the pictures of a slip's way, and of a waveform
    assert len(described) == len(drawings) - len(panels) == len(document.drawings) + 2
    assert all(drawing["role"] == "img" for drawing in drawings)
    assert "img" not in [tag for tag, _ in outline.elements]


def test_every_formula_offers_its_latex_and_has_the_thesis_number(text: str, document: Document) -> None:
    for step in document.derivation:
        for number, _ in enumerate(step.equations, 1):
            assert f"<figcaption>step {step.id}, equation {number}</figcaption>" in text
    assert "<figcaption>eq-2.12, as derived</figcaption>" in text
    assert '<span class="thesis-number">(2.12)</span>' in text


def test_the_programs_can_be_taken_out_of_the_page(text: str, document: Document) -> None:
    archive = re.search(r'href="data:application/zip;base64,([^"]+)" download="octave.zip"', text)
    with zipfile.ZipFile(io.BytesIO(base64.b64decode(archive[1]))) as packed:
        held = {name: packed.read(name).decode() for name in packed.namelist()}
    assert held == files(document.programs)
    assert held.keys() - {program.name for program in document.programs} == {"README.md"}
    assert "<summary>Show the 50 lines of main_numbers.m</summary>" in text


def test_the_sources_stand_at_the_end_as_they_are(text: str, project_folder: Path) -> None:
    chapter = text[text.index('<h2 id="code">') : text.index("</main>")]
    names = re.findall(r'<pre [^>]*aria-label="([^"]+)"', chapter)
    assert names == ["derivations/mechanism.py", "trimmer/linear/low_pass.py"]
    for name, code in zip(names, re.findall(r"<code>([^<]*)</code></pre>", chapter), strict=True):
        assert html.unescape(code) == (project_folder / name).read_text(encoding="utf-8")


def test_every_card_links_to_its_source_and_the_contents_to_their_chapter(outline, document) -> None:
    links = [attributes for tag, attributes in outline.elements if tag == "a"]
    to_files = [link["href"] for link in links if link.get("class") == "file"]
    assert sorted(to_files) == sorted(f"#{identifier(finding.source)}" for finding in document.findings)
    assert "#code" in [link["href"] for link in links]


def test_figures_come_after_what_is_painted_first(text: str) -> None:
    assert text.index("</style>") < text.index('id="summary"') < text.index('<figure class="drawing"')
    assert re.search(r"<script[^>]* src=|<link[^>]* rel=\"stylesheet\"", text) is None


def test_scripts_come_after_all_content_but_the_one_that_sets_the_colours(text: str) -> None:
    first, *others = [match.start() for match in re.finditer("<script", text)]
    assert first < text.index("<body>")
    assert "theme" in text[first : text.index("</script>")]
    assert others and min(others) > text.rindex("</main>")
