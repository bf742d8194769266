"""The report on a design: what it says, that it is whole, and that nothing of the thesis is in it."""

import dataclasses
import html
import re
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest

from report.design.comparison import comparison_sentence
from report.design.markdown import to_markdown
from report.design.pictures import pictures
from report.design.report import DesignReport
from report.design.tables.judged import target_rows
from report.design.words.phrases import measure_value
from report.design.words.sentences import helpless_words
from report.design.words.verdict import sureness_sentences, verdict_sentence
from report.pages.formats import Format
from trimmer.design import (
    Design,
    DesignOutcome,
    DesignVerdict,
    JudgedTarget,
    Measure,
    Remedies,
    Sureness,
    compared,
)
from trimmer.design.trials.remedies import Mend

SECTIONS = (
    *("Verdict", "What nobody knows", "The targets over two numbers", "Move the numbers"),
    *("What it settles to", "Impacts, forces and wear", "Spectrum", "Exposure to vibration"),
    *("How far the motion reaches", "What to change first", "The mechanism", "Modes and transfer functions"),
    *("What this rests on", "Appendix: the equations"),
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


def test_no_value_is_left_blank(text: str) -> None:
    for word in ("nan", "None", "inf ", "Undefined", "[[", "{{", "{#", "MISSING"):
        assert word not in text, word


def test_each_picture_is_there_once_and_described(page: str, report: DesignReport) -> None:
    drawn = "diagram motion transfer spectrum-1 map-1 map-2 branch-1 ranges influence"
    assert set(drawn.split()) <= set(report.figures)
    for name, figure in report.figures.items():
        assert page.count(f'<figure class="drawing" id="drawing-{name}">') == 1
        assert figure.alternative_text
    assert 'src="figures/' not in page


@pytest.mark.poppler
def test_the_pages_of_the_pdf_hold_the_same(pdf: Path) -> None:
    command = ["pdftotext", "-layout", str(pdf), "-"]
    found = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    for section in SECTIONS:
        assert section in found
    assert "thesis" not in found.lower()


def with_verdict(design: Design, verdict: DesignVerdict) -> Design:
    """Return a design without ranges, judged otherwise."""
    return dataclasses.replace(design, verdict=verdict, ranges=None)


def test_sentences_for_each_outcome(design: Design) -> None:
    judged = design.verdict.judged
    met = DesignVerdict(
        DesignOutcome.MET, Sureness.SURE, tuple(dataclasses.replace(e, met=True) for e in judged), 0.0, True
    )
    assert verdict_sentence(with_verdict(design, met)).startswith("**All four targets are met**")
    missed = DesignVerdict(DesignOutcome.MISSED, Sureness.SURE, judged, 0.0, True)
    told = verdict_sentence(dataclasses.replace(with_verdict(design, missed), remedies=None))
    assert "missed**: the" in told
    assert "no change" not in told
    nothing = DesignVerdict(DesignOutcome.NO_TARGETS, Sureness.UNSURE, (), 0.0, True)
    assert "names no targets" in verdict_sentence(with_verdict(design, nothing))
    otherwise = DesignVerdict(DesignOutcome.DEPENDS, Sureness.UNSURE, judged, 0.5, False)
    assert "one of 2 starts leads to a motion that" in verdict_sentence(with_verdict(design, otherwise))


def judged_at(design: Design, **bounds: float) -> Design:
    """Return a design without ranges, judged by targets with other bounds, each met or missed by far."""
    judged = tuple(
        JudgedTarget(target, each.value, target.met_by(each.value))
        for each in design.verdict.judged
        if each.target.key in bounds
        for target in [dataclasses.replace(each.target, bound=bounds[each.target.key])]
    )
    outcome = DesignOutcome.MET if all(each.met for each in judged) else DesignOutcome.MISSED
    changed = with_verdict(design, DesignVerdict(outcome, Sureness.SURE, judged, 0.0, True))
    file = dataclasses.replace(design.file, targets=tuple(each.target for each in judged))
    return dataclasses.replace(changed, file=file, remedies=None)


def test_a_bound_of_zero_or_far_away_has_no_margin_and_branches_show_what_is_met(design: Design) -> None:
    none = judged_at(design, impact_speed_at_most=0.0, stroke_at_least=0.0)
    assert [row[3] for row in target_rows(none)[1:]] == ["—", "—"]
    assert "where at most" in verdict_sentence(none)
    assert "%" not in verdict_sentence(judged_at(design, stroke_at_least=0.0))
    both = judged_at(design, impact_speed_at_most=1.0, stroke_at_least=1e-3)
    assert verdict_sentence(both).startswith("**Both targets are met**")
    assert verdict_sentence(judged_at(design, stroke_at_least=1e-9)).endswith("is wanted.")  # far away
    met = judged_at(design, impact_speed_at_most=100.0)
    shown = pictures(dataclasses.replace(met, maps=(), sensitivities=None, spectra={}))
    assert shown["branch-1"].title.startswith("Impact speed")


def test_a_mechanism_that_comes_to_rest_is_said_to_do_so(design: Design) -> None:
    message = "It comes to rest within 60 s, and nothing sets it in motion."
    motions = dataclasses.replace(design.motions, first_failed=True, message=message)
    open_one = DesignVerdict(DesignOutcome.OPEN, Sureness.UNSURE, (), 0.0, True)
    told = verdict_sentence(dataclasses.replace(with_verdict(design, open_one), motions=motions))
    assert told.replace("\\", "") == f"**Nothing can be said about the targets**: it{message[2:]}"


def test_what_was_not_measured_is_called_unknown() -> None:
    assert measure_value(Measure.PERIOD, float("nan")) == "unknown"


def test_a_comparison_says_better_only_of_the_same_targets(design: Design) -> None:
    def told(before: Design, after: Design) -> str:
        return comparison_sentence(compared(before, after), ("A", "B"))

    missed, met = (judged_at(design, stroke_at_least=1e-3, impact_speed_at_most=1e-9),) * 2
    judged = tuple(dataclasses.replace(each, met=True) for each in met.verdict.judged)
    met = dataclasses.replace(met, verdict=dataclasses.replace(met.verdict, judged=judged))
    untold = DesignVerdict(DesignOutcome.NO_TARGETS, Sureness.UNSURE, (), 0.0, True)
    file = dataclasses.replace(design.file, targets=())
    nothing = dataclasses.replace(with_verdict(design, untold), file=file)
    assert told(missed, met).startswith("**Better**: in A one of two targets is met, in B two of two")
    assert told(met, missed).startswith("**Worse**")
    assert told(met, met).startswith("**As many targets are met**")
    assert told(met, nothing).startswith("**The files want different things**: in A two of two targets are")
    assert told(met, nothing).endswith(" met, in B there are no targets.")
    still = DesignVerdict(DesignOutcome.OPEN, Sureness.UNSURE, (), 0.0, True)
    at_rest = dataclasses.replace(met, verdict=still)
    assert told(met, at_rest).endswith("in B there is no motion to judge.")
    one = judged_at(design, stroke_at_least=1e-9)
    assert told(nothing, one).endswith("in B the target is met.")
    other = judged_at(design, stroke_at_least=1e-3, impact_speed_at_most=1.0)
    assert told(met, other).startswith("**The files want different things**")


@pytest.mark.parametrize(
    ("helpless", "told"),
    [
        (((), ()), ""),
        ((("frequency",), ()), ""),  # it meets one of the two
        ((("frequency",),) * 2, "frequency of the drive meets any of the targets that are missed."),
        ((("frequency",),), "frequency of the drive meets the target."),
    ],
)
def test_a_number_helps_if_it_meets_any_target(design: Design, helpless, told: str) -> None:
    targets = design.file.targets
    mends = [Mend(target, None, None, (), each, ()) for target, each in zip(targets, helpless, strict=False)]
    tried = Remedies((), None, tuple(mends), 1, ("frequency", "plays.bridge.gap"), 9)
    words = helpless_words(dataclasses.replace(design, remedies=tried))
    assert words.endswith(told) and bool(words) is bool(told)


def test_how_many_starts_lead_to_it_is_told(design: Design) -> None:
    motion = design.motion
    assert motion is not None
    first, *others = design.motions.found
    for starts, told in ((1, "one of 5 starts leads to it"), (4, "four of 5 starts lead to it")):
        found = (dataclasses.replace(first, starts=starts), *others)
        motions = dataclasses.replace(design.motions, found=found, starts=5)
        assert told in sureness_sentences(dataclasses.replace(design, motions=motions))


def test_a_title_cannot_act_as_markup(report: DesignReport) -> None:
    sly = dataclasses.replace(report, title="<script>alert(1)</script>")
    assert "<script>" not in "".join(to_markdown(sly).values())
