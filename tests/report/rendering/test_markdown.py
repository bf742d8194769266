from __future__ import annotations

import dataclasses

import pytest

from report.claim import Mathematics, Number, Words
from report.document import DerivationStep, Document, Equation
from report.rendering.markdown import FULL_LINE, BrokenLinkError, shown, to_markdown
from report.rendering.pandoc import PandocError
from report.rendering.pdf import to_typst
from tests.report.rendering.sample_formulas import long_coefficient


def with_step(document: Document, **fields: object) -> Document:
    step = DerivationStep("added", "Added", "Text.", (Equation("a = b"),))
    changed = dataclasses.replace(step, **fields)
    return dataclasses.replace(document, derivation=(*document.derivation, changed))


def test_sections_come_in_their_order(document: Document) -> None:
    text = to_markdown(document)
    sections = ("summary", "derivation", "figures", "claims", "nomenclature", "parameters", "provenance")
    places = [text.index(f"{{#{section}}}") for section in sections]
    assert places == sorted(places)


def test_the_summary_says_how_many_statements_are_judged(document: Document) -> None:
    assert f"{len(document.findings)} of 253 statements" in to_markdown(document)


def test_sections_without_content_are_left_out(document: Document) -> None:
    text = to_markdown(dataclasses.replace(document, derivation=(), figures=(), highlights=()))
    assert not any(f"{{#{section}}}" in text for section in ("derivation", "figures", "highlights"))


def test_describing_functions_have_a_chapter_of_their_own(document: Document) -> None:
    step = DerivationStep("relay", "Relay", "Text.", (Equation("N = 1"),), ("eq-2.8",))
    text = to_markdown(dataclasses.replace(document, describing_functions=(step,)))
    assert text.index("{#derivation}") < text.index("{#describing-functions}") < text.index("{#step-relay}")
    unknown = dataclasses.replace(step, claims=("eq-9.9",))
    with pytest.raises(BrokenLinkError, match="step relay"):
        to_markdown(dataclasses.replace(document, describing_functions=(unknown,)))


def test_a_link_to_a_claim_that_is_not_there_is_an_error(document: Document) -> None:
    with pytest.raises(BrokenLinkError, match=r"eq-9\.9"):
        to_markdown(with_step(document, text="See [it](#eq-9.9)."))


def test_a_highlight_of_a_claim_that_is_not_there_is_an_error(document: Document) -> None:
    highlight = dataclasses.replace(document.highlights[0], claim="eq-9.9")
    with pytest.raises(BrokenLinkError, match=r"eq-9\.9"):
        to_markdown(dataclasses.replace(document, highlights=(highlight,)))


def test_two_claims_with_one_id_are_an_error(document: Document) -> None:
    chapter = document.chapters[1]
    doubled = dataclasses.replace(chapter, findings=(*chapter.findings, document.findings[0]))
    with pytest.raises(BrokenLinkError, match=r"twice.*eq-2\.8"):
        to_markdown(dataclasses.replace(document, chapters=(document.chapters[0], doubled)))


def test_mathematics_that_pandoc_cannot_read_is_an_error(document: Document) -> None:
    changed = with_step(document, equations=(Equation(r"\nosuchmacro x"),))
    with pytest.raises(PandocError, match="nosuchmacro"):
        to_typst(changed, to_markdown(changed))


def test_formulas_numbers_and_words_are_shown_each_in_their_way() -> None:
    assert shown(Mathematics("a"), "name", FULL_LINE) == '::: {.formula name="name"}\n$$a$$\n:::'
    assert shown(Number("-60", "dB/decade"), "name", FULL_LINE) == r"$-60$\ dB\/decade"
    assert shown(Words("*so* $x$"), "name", FULL_LINE) == "*so* $x$"


def test_a_long_formula_is_broken() -> None:
    assert r"\begin{aligned}" in shown(Mathematics(long_coefficient()), "name", FULL_LINE)
