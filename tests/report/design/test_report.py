"""The report on a design: what it says, that it is whole, and that nothing of the thesis is in it."""

from __future__ import annotations

import dataclasses
import html
import re
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest

from report.design.markdown import to_markdown
from report.design.report import DesignReport
from report.design.words import verdict_sentence
from report.rendering.request import Format
from trimmer.design.design import Design
from trimmer.design.verdict import Outcome, Sureness, Verdict

SECTIONS = (
    *("Verdict", "What nobody knows", "The mechanism", "Its equations", "Modes and transfer functions"),
    *("What it settles to", "Impacts, forces and wear", "Spectrum", "Which motion where"),
    *("How far the motion reaches", "What to change first", "Exposure to vibration", "What this rests on"),
)


@pytest.fixture(scope="module")
def page(files: Mapping[Format, str | bytes]) -> str:
    content = files[Format.HTML]
    assert isinstance(content, str)
    return content


@pytest.fixture(scope="module")
def text(page: str) -> str:
    """What a reader sees of the page."""
    body = re.sub(r"<(script|style|template|annotation)\b.*?</\1>", " ", page, flags=re.DOTALL)
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", body)).split())


def test_sections_stand_in_their_order_and_in_the_contents(page: str) -> None:
    headings = [re.sub(r"<[^>]+>", "", each) for each in re.findall(r"<h2 id=.*?>(.*?)</h2>", page)]
    assert tuple(headings) == SECTIONS
    nav = page[page.index("<nav") : page.index("</nav>")]
    assert all(f">{section}</a>" in nav for section in SECTIONS)


def test_no_word_of_the_thesis_is_in_it(text: str) -> None:
    assert "thesis" not in text.lower()
    assert "claim" not in text.lower()


def test_the_verdict_stands_at_the_top_in_one_sentence(design: Design, text: str) -> None:
    assert design.verdict.outcome is Outcome.DEPENDS
    start = text.index("It depends on what nobody knows")
    assert start < text.index("What nobody knows The gap of bridge")
    assert verdict_sentence(design).count(". ") == 0


def test_no_value_is_left_blank(text: str) -> None:
    for word in ("nan", "None", "inf ", "Undefined", "[[", "{{", "{#", "MISSING"):
        assert word not in text, word


def test_exposure_names_axis_standard_and_held_body(text: str) -> None:
    part = text[text.index("Exposure to vibration The hand") :]
    assert "The hand holds the motor" in part
    for words in ("ISO 5349-1", "one axis", "no measure of comfort", "2002/44/EC"):
        assert words in part


def test_each_picture_is_there_once_and_described(page: str, report: DesignReport) -> None:
    assert {
        "diagram",
        "motion",
        "transfer",
        "spectrum-1",
        "map-1",
        "map-2",
        "branch-1",
        "ranges",
        "influence",
    } <= set(report.figures)
    for name, figure in report.figures.items():
        assert page.count(f'<figure class="drawing" id="drawing-{name}">') == 1
        assert figure.alternative_text
    assert 'src="figures/' not in page


def test_the_pages_of_the_pdf_hold_the_same(pdf: Path) -> None:
    pytest.importorskip("shutil")
    found = subprocess.run(
        ["pdftotext", "-layout", str(pdf), "-"], capture_output=True, text=True, check=True
    ).stdout
    for section in SECTIONS:
        assert section in found
    assert "thesis" not in found.lower()


def with_verdict(design: Design, verdict: Verdict) -> Design:
    """Return a design without ranges, judged otherwise."""
    return dataclasses.replace(design, verdict=verdict, ranges=None)


def test_sentences_for_each_outcome(design: Design) -> None:
    judged = design.verdict.judged
    met = Verdict(
        Outcome.MET, Sureness.SURE, tuple(dataclasses.replace(e, met=True) for e in judged), 0.0, True
    )
    assert verdict_sentence(with_verdict(design, met)).startswith("**All four targets are met**")
    missed = Verdict(Outcome.MISSED, Sureness.SURE, judged, 0.0, True)
    told = verdict_sentence(dataclasses.replace(with_verdict(design, missed), remedies=None))
    assert "missed**: the" in told
    assert "no change" not in told
    nothing = Verdict(Outcome.NO_TARGETS, Sureness.UNSURE, (), 0.0, True)
    assert "names no targets" in verdict_sentence(with_verdict(design, nothing))
    otherwise = Verdict(Outcome.DEPENDS, Sureness.UNSURE, judged, 0.5, False)
    assert "one of 2 starts leads to a motion that" in verdict_sentence(with_verdict(design, otherwise))


def test_a_title_cannot_act_as_markup(report: DesignReport) -> None:
    sly = dataclasses.replace(report, title="<script>alert(1)</script>")
    assert "<script>" not in "".join(to_markdown(sly).values())
