"""What a report leaves out, and which documents are none; what it tells stands in ``sample_told.txt``."""

from dataclasses import replace
from functools import partial

import pytest

from report.document.document import Document
from report.document.extras import Overview
from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.shown import Number, Words
from report.judging.spread import Follows
from report.judging.verdict import Impact, Verdict
from report.pages.derivation import DerivationStep
from report.pages.figure import Equation
from report.pages.links import BrokenLinkError
from report.pages.pandoc import PandocError
from report.pages.pieces import Converter
from report.rendering.markdown import HALF_LINE_OF_WORDS, MANY_PARTS, side_by_side, to_markdown
from report.rendering.selection import select

STEP = DerivationStep("added", "Added", "Text.", (Equation("a = b"),))


def text_of(document: Document) -> str:
    return "\n".join(to_markdown(document).values())


def test_sections_without_content_are_left_out(document: Document) -> None:
    text = text_of(replace(document, derivation=(), overview=Overview(), programs=()))
    left_out = ("derivation", "summary", "answers", "corrected", "programs")
    assert not any(f"{{#{section}}}" in text for section in left_out)


def test_a_part_of_the_report_has_its_chapter_and_what_rests_on_it(document: Document) -> None:
    part = select(document, ["ch5"])
    text = text_of(part)
    assert not part.steps and not part.step_of
    assert "**This is a part of the report.**" in text
    assert all(f"{{#{section}}}" in text for section in ("method", "chapter-5", "errata"))
    left_out = ("summary", "answers", "chapter-2", "derivation", "explorable", "spread", "solution")
    assert not any(f"{{#{section}}}" in text for section in left_out)
    assert not any(f"#{finding.id}" in text for finding in document.chapters[0].findings)


def test_describing_functions_have_a_chapter_of_their_own(document: Document) -> None:
    text = text_of(replace(document, describing_functions=(replace(STEP, id="relay", claims=("eq-2.8",)),)))
    assert text.index("{#derivation}") < text.index("{#describing-functions}") < text.index("{#step-relay}")


def with_highlight_elsewhere(document: Document) -> Document:
    opening = document.overview.opening
    highlights = (replace(opening.highlights[0], places=("eq-9.9",)),)
    return replace(
        document, overview=replace(document.overview, opening=replace(opening, highlights=highlights))
    )


def with_a_claim_twice(document: Document) -> Document:
    first, second, *others = document.chapters
    doubled = replace(second, findings=(*second.findings, document.findings[0]))
    return replace(document, chapters=(first, doubled, *others))


@pytest.mark.parametrize(
    ("changed", "told"),
    [
        (lambda d: replace(d, describing_functions=(replace(STEP, claims=("eq-9.9",)),)), "step added"),
        (lambda d: replace(d, spread=(*d.spread, Follows("eq-9.9", "eq-2.8", "x"))), r"of a slip.*eq-9\.9"),
        (lambda d: replace(d, derivation=(*d.derivation, replace(STEP, text="[It](#eq-9.9)."))), r"eq-9\.9"),
        (with_highlight_elsewhere, r"eq-9\.9"),
        (with_a_claim_twice, r"twice.*eq-2\.8"),
    ],
)
def test_a_link_that_leads_nowhere_or_to_two_places_is_an_error(document, changed, told) -> None:
    with pytest.raises(BrokenLinkError, match=told):
        to_markdown(changed(document))


def test_mathematics_that_pandoc_cannot_read_is_an_error(document: Document) -> None:
    step = replace(STEP, equations=(Equation(r"\nosuchmacro x"),))
    changed = replace(document, derivation=(*document.derivation, step))
    converter = Converter()
    text = converter.parsed({"derivation": to_markdown(changed)["derivation"]})
    with pytest.raises(PandocError, match="nosuchmacro"):
        converter.typst(text)


def test_many_parts_stand_in_a_table_although_some_words_are_long() -> None:
    long = JudgedPart("", Verdict.REPRODUCED, Number("1"), Words("x" * (HALF_LINE_OF_WORDS + 1)), "")
    finding = partial(Finding, "eq-1", Kind.EQUATION, "1", "", Verdict.REPRODUCED, "", "", Impact.NONE, "")
    assert not side_by_side(finding((long,) * (MANY_PARTS - 1)))
    assert side_by_side(finding((long,) * MANY_PARTS))
