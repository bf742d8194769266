"""The PDF, as poppler reads it."""

import dataclasses
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest

from report.document.document import Document
from report.pages.derivation import DerivationStep
from report.pages.figure import Equation
from report.pages.formats import Format, Paper
from report.pages.pdf import Head, TypesettingError, typeset
from report.pages.pieces import Converter
from report.rendering.markdown import to_markdown
from report.rendering.render import pdf_sources, to_pdf
from report.rendering.selection import select


def cards_of(document: Document) -> str:
    converter = Converter()
    return pdf_sources(converter, converter.parsed(to_markdown(document)))[1]


def cards_pdf(document: Document, paper: Paper = Paper.A4) -> bytes:
    return to_pdf(document, Format.CARDS, cards_of(document), paper)


def poppler(tool: str, *arguments: str) -> str:
    return subprocess.run([tool, *arguments], capture_output=True, check=True, text=True).stdout


@pytest.fixture(scope="module")
def text(rendered: Mapping[Format, Path]) -> str:
    return poppler("pdftotext", "-layout", str(rendered[Format.CARDS]), "-")


@pytest.fixture(scope="module")
def report(rendered: Mapping[Format, Path]) -> str:
    return poppler("pdftotext", "-layout", str(rendered[Format.PDF]), "-")


@pytest.mark.poppler
def test_the_pdf_has_its_title_size_and_date(rendered: Mapping[Format, Path], document: Document) -> None:
    lines = poppler("pdfinfo", "-isodates", str(rendered[Format.PDF])).splitlines()
    information = {key: value.strip() for key, _, value in (line.partition(":") for line in lines)}
    assert information["Title"] == document.title
    assert "A4" in information["Page size"]
    assert information["CreationDate"].startswith("2026-05-04T08:11:12")


@pytest.mark.poppler
def test_every_claim_and_section_is_in_the_text(text: str, report: str, document: Document) -> None:
    assert all(finding.id in text for finding in document.findings)
    assert all(step.title in text for step in document.derivation)
    assert f"{len(document.findings)} of 253 statements" in report


@pytest.mark.poppler
def test_a_source_is_named_without_a_link(text: str, document: Document) -> None:
    assert "trimmer/linear/low_pass.py" in text
    assert "code-trimmer" not in cards_of(select(document, ["ch5"]))


@pytest.mark.poppler
def test_pages_are_numbered_and_have_a_running_head(text: str) -> None:
    *pages, sheet = text.split("\f")[:-1]
    assert len(pages) > 3
    for number, page in enumerate(pages, 1):
        assert page.replace(" ", "").endswith(f"\n{number}/{len(pages)}\n")
    assert sheet.replace(" ", "").endswith("\nE1/E1\n")
    assert pages[1].lstrip().startswith("The linear trimmer & its claims")


@pytest.mark.poppler
def test_only_the_fonts_that_typst_carries_are_used(rendered: Mapping[Format, Path]) -> None:
    rows = poppler("pdffonts", str(rendered[Format.PDF])).splitlines()[2:]
    families = {row.split()[0].partition("+")[2].partition("-")[0] for row in rows}
    assert families <= {"LibertinusSerif", "NewCMMath", "DejaVuSansMono"}
    assert "NewCMMath" in families


@pytest.mark.poppler
def test_claims_can_be_reached_from_the_outline_and_by_links(rendered: Mapping[Format, Path]) -> None:
    raw = poppler("pdfinfo", "-dests", str(rendered[Format.CARDS]))
    assert '"eq-2.8"' in raw
    assert '"txt-5.2.1-impulse-1e-8"' in raw
    assert b"/Outlines" in rendered[Format.CARDS].read_bytes()
    assert "cards.pdf#nameddest=eq-2.9" in poppler("pdfinfo", "-url", str(rendered[Format.PDF]))


@pytest.mark.poppler
def test_the_programs_are_attached(rendered: Mapping[Format, Path], document: Document) -> None:
    listed = poppler("pdfdetach", "-list", str(rendered[Format.CARDS]))
    assert all(program.name in listed for program in document.programs)


@pytest.mark.slow
@pytest.mark.poppler
def test_the_report_can_be_set_on_letter_paper(document: Document, tmp_path_factory) -> None:
    path = tmp_path_factory.mktemp("letter") / "letter.pdf"
    part = select(document, ["appA"])
    path.write_bytes(cards_pdf(part, Paper.LETTER))
    assert "(letter)" in poppler("pdfinfo", str(path))


def with_equation(document: Document, latex: str) -> Document:
    """Return a small part of the report, with a derivation of one equation."""
    part = select(document, ["appA"])
    return dataclasses.replace(part, derivation=(DerivationStep("wide", "Wide", "", (Equation(latex),)),))


def test_bars_enclose_instead_of_relating(document: Document) -> None:
    source = cards_of(with_equation(document, r"|G| \gg |N|"))
    assert "lr(|G|)" in source.replace(" ", "")
    assert "lr(|N|)" in source.replace(" ", "")


def fraction(terms: int) -> str:
    return rf"\frac{{{' + '.join(f'a_{{{i}}}' for i in range(terms))}}}{{2}}"


def test_a_formula_that_cannot_fit_stops_the_build_and_is_named(document: Document) -> None:
    wide = with_equation(document, fraction(80))
    with pytest.raises(TypesettingError, match="step wide, equation 1"):
        cards_pdf(wide)


@pytest.mark.poppler
def test_a_formula_that_is_a_little_too_wide_is_set_smaller(document: Document, tmp_path_factory) -> None:
    wide = with_equation(document, fraction(30))
    path = tmp_path_factory.mktemp("wide") / "wide.pdf"
    path.write_bytes(cards_pdf(wide))
    boxes = poppler("pdftotext", "-bbox", str(path), "-")
    right_ends = [float(piece.partition('"')[0]) for piece in boxes.split('xMax="')[1:]]
    assert max(right_ends) < 595.3 - 59


@pytest.mark.parametrize(
    "source", ['#image("secret.svg")', '#read("secret.svg")', '#include "secret.typ"', '#read("/etc/hosts")']
)
def test_typst_sees_no_file_of_the_folder(source: str, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "secret.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" width="1" height="1"/>')
    (tmp_path / "secret.typ").write_text("secret")
    end = '#[#metadata("end of report") <end-of-report>]'
    head = Head("Title", "", "2026-03-01")
    assert typeset(head, end, {}).startswith(b"%PDF-")
    with pytest.raises(TypesettingError, match="file not found"):
        typeset(head, f"{source}\n{end}", {})


def test_a_formula_of_a_design_that_is_too_wide_is_set_small() -> None:
    wide = f'#formula("long")[$ {" + ".join(["x"] * 600)} $] #[#metadata("end") <end-of-report>]'
    with pytest.raises(TypesettingError, match="does not fit"):
        typeset(Head("Title", "", "2026-03-01"), wide, {})
    assert typeset(Head("Title", "", "2026-03-01", strict=False), wide, {}).startswith(b"%PDF-")


@pytest.mark.poppler
@pytest.mark.parametrize(
    "source",
    [
        '#leading[\nstable if\n\n] #numbered("")[$ "growth" < 0 $]',
        '#answer[#leading[\nstable if\n\n] #answer-side("Right")[growth]]',
        "#report-table((1fr,), (left,), ([Head],), [stable if #parbreak() growth])",
    ],
)
def test_words_stay_with_what_they_lead_to_and_a_row_on_its_page(source: str, tmp_path: Path) -> None:
    fills = [f"#block(height: {height}pt) {source} #pagebreak()" for height in range(600, 710, 6)]
    path = tmp_path / "pages.pdf"
    path.write_bytes(
        typeset(Head("Title", "", "2026-03-01"), "\n".join([*fills, '#[#metadata("") <end-of-report>]']), {})
    )
    pages = poppler("pdftotext", str(path), "-").split("\f")
    assert sum("stable if" in page for page in pages) == len(fills)
    assert ["stable if" in page for page in pages] == ["growth" in page for page in pages]
