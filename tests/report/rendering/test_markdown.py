import dataclasses
from functools import partial

import pytest

from report.document.document import Document
from report.document.extras import Overview
from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.shown import Mathematics, Number, Words
from report.judging.spread import Follows
from report.judging.verdict import Impact, Verdict
from report.pages.derivation import DerivationStep
from report.pages.figure import Equation
from report.pages.links import BrokenLinkError
from report.pages.pandoc import PandocError
from report.pages.pieces import Converter
from report.rendering.markdown import (
    BACK,
    CARDS,
    FULL_LINE,
    HALF_LINE_OF_WORDS,
    MANY_PARTS,
    REPORT,
    shown,
    side_by_side,
    to_markdown,
)
from report.rendering.selection import select
from tests.report.rendering.sample_formulas import long_coefficient


def with_step(document: Document, **fields: object) -> Document:
    step = DerivationStep("added", "Added", "Text.", (Equation("a = b"),))
    changed = dataclasses.replace(step, **fields)
    return dataclasses.replace(document, derivation=(*document.derivation, changed))


def text_of(document: Document) -> str:
    return "\n".join(to_markdown(document).values())


SECTIONS = (
    *("summary", "answers", "parameters", "corrected", "certificate"),
    *("method", "chapter-2", "section-2.2.1", "chapter-5", "chapter-A"),
    *("programs", "explorable", "spread", "derivation", "describing-functions", "solution"),
    *("nomenclature", "errata"),
)


def test_sections_come_in_their_order(document: Document) -> None:
    text = text_of(document)
    places = [text.index(f"{{#{section}}}") for section in SECTIONS]
    assert places == sorted(places)


def test_the_pieces_are_the_report_the_sections_and_what_follows(document: Document) -> None:
    before = (*REPORT, *CARDS)
    names = list(to_markdown(document))
    assert (*names[: len(before)], *names[-len(BACK) :]) == (*before, *BACK)
    sections = names[len(before) : -len(BACK)]
    assert sections[:2] == ["chapter-2-2.2.1", "chapter-2-2.2.2"]
    assert sections[-1] == "chapter-A-A"


def test_the_summary_says_how_many_statements_are_judged(document: Document) -> None:
    assert f"{len(document.findings)} of 253 statements" in to_markdown(document)["certificate"]


def test_sections_without_content_are_left_out(document: Document) -> None:
    without = {"derivation": (), "overview": Overview(), "programs": ()}
    text = text_of(dataclasses.replace(document, **without))
    left_out = ("derivation", "summary", "answers", "corrected", "programs")
    assert not any(f"{{#{section}}}" in text for section in left_out)


def test_a_figure_stands_with_its_claim_in_the_section_that_the_thesis_has_it_in(document: Document) -> None:
    text = text_of(document)
    places = ("{#section-2.2.2}", "#fig-2.3 ", "(figures/fig-2.3.svg)", "{#section-2.3.4}")
    assert [text.index(place) for place in places] == sorted(text.index(place) for place in places)


def test_a_part_of_the_report_has_its_chapter_and_what_rests_on_it(document: Document) -> None:
    text = text_of(select(document, ["ch5"]))
    assert "**This is a part of the report.**" in text
    assert all(f"{{#{section}}}" in text for section in ("method", "chapter-5", "errata"))
    assert not any(f"{{#{section}}}" in text for section in ("summary", "answers", "chapter-2", "derivation"))
    assert not any(f"#{finding.id}" in text for finding in document.chapters[0].findings)


def test_an_erratum_names_its_place_and_both_forms(document: Document) -> None:
    sheet = to_markdown(document)["errata"]
    assert "[Eq\\. 2\\.9](#eq-2.9)\\, first mass" in sheet
    assert "$-60$\\ dB\\/decade" in sheet
    assert "$-40$\\ dB\\/decade" in sheet
    assert "second mass" not in sheet


def test_describing_functions_have_a_chapter_of_their_own(document: Document) -> None:
    step = DerivationStep("relay", "Relay", "Text.", (Equation("N = 1"),), ("eq-2.8",))
    text = text_of(dataclasses.replace(document, describing_functions=(step,)))
    assert text.index("{#derivation}") < text.index("{#describing-functions}") < text.index("{#step-relay}")
    unknown = dataclasses.replace(step, claims=("eq-9.9",))
    with pytest.raises(BrokenLinkError, match="step relay"):
        to_markdown(dataclasses.replace(document, describing_functions=(unknown,)))


def test_a_card_leads_to_its_step_and_a_step_to_its_code_and_claims(document: Document) -> None:
    text = text_of(document)
    assert "the step [Kinetic energy](#step-kinetic); [" in text
    assert '{.lines place="trimmer/linear/low_pass.py, lines 29–31" name="bandwidth"}' in text
    assert "1 other claims rest on this step" not in text
    assert 'summary="One other claim rests on this step"' in text
    unknown = dataclasses.replace(document, spread=(*document.spread, Follows("eq-9.9", "eq-2.8", "x")))
    with pytest.raises(BrokenLinkError, match=r"graph of a slip.*eq-9\.9"):
        to_markdown(unknown)


def test_a_symbol_leads_to_its_first_place(document: Document) -> None:
    tables = to_markdown(document)["nomenclature"]
    assert "[Kinetic energy](#step-kinetic)" in tables
    assert "[Eq\\. 2\\.37](#eq-2.37)" in tables


def test_a_part_of_the_report_has_no_derivation_nor_what_rests_on_it(document: Document) -> None:
    part = select(document, ["ch5"])
    assert not part.steps
    assert not part.step_of
    text = text_of(part)
    assert not any(f"{{#{section}}}" in text for section in ("explorable", "spread", "solution"))


def test_a_link_to_a_claim_that_is_not_there_is_an_error(document: Document) -> None:
    with pytest.raises(BrokenLinkError, match=r"eq-9\.9"):
        to_markdown(with_step(document, text="See [it](#eq-9.9)."))


def test_a_highlight_of_a_place_that_is_not_there_is_an_error(document: Document) -> None:
    highlight = dataclasses.replace(document.overview.opening.highlights[0], places=("eq-9.9",))
    opening = dataclasses.replace(document.overview.opening, highlights=(highlight,))
    changed = dataclasses.replace(document.overview, opening=opening)
    with pytest.raises(BrokenLinkError, match=r"eq-9\.9"):
        to_markdown(dataclasses.replace(document, overview=changed))


def test_two_claims_with_one_id_are_an_error(document: Document) -> None:
    chapter = document.chapters[1]
    doubled = dataclasses.replace(chapter, findings=(*chapter.findings, document.findings[0]))
    first, _, *others = document.chapters
    with pytest.raises(BrokenLinkError, match=r"twice.*eq-2\.8"):
        to_markdown(dataclasses.replace(document, chapters=(first, doubled, *others)))


def test_mathematics_that_pandoc_cannot_read_is_an_error(document: Document) -> None:
    changed = with_step(document, equations=(Equation(r"\nosuchmacro x"),))
    converter = Converter()
    text = converter.parsed({"derivation": to_markdown(changed)["derivation"]})
    with pytest.raises(PandocError, match="nosuchmacro"):
        converter.typst(text)


def test_formulas_numbers_and_words_are_shown_each_in_their_way() -> None:
    assert shown(Mathematics("a"), "name", FULL_LINE) == '::: {.formula name="name"}\n$$a$$\n:::'
    assert shown(Number("-60", "dB/decade"), "name", FULL_LINE) == r"[$-60$\ dB\/decade]{.number}"
    assert shown(Words("*so* $x$"), "name", FULL_LINE) == "*so* $x$"


def test_many_parts_stand_in_a_table_although_some_words_are_long() -> None:
    long = JudgedPart("", Verdict.REPRODUCED, Number("1"), Words("x" * (HALF_LINE_OF_WORDS + 1)), "")
    finding = partial(Finding, "eq-1", Kind.EQUATION, "1", "", Verdict.REPRODUCED, "", "", Impact.NONE, "")
    assert not side_by_side(finding((long,) * (MANY_PARTS - 1)))
    assert side_by_side(finding((long,) * MANY_PARTS))


def test_a_long_formula_is_broken() -> None:
    assert r"\begin{aligned}" in shown(Mathematics(long_coefficient()), "name", FULL_LINE)
