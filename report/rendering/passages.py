"""What the reader's own copy has beside each card; it is put into the finished page and kept nowhere."""

import re
from collections.abc import Mapping
from dataclasses import dataclass

from report.copy.blocks import BlockKind, blocks
from report.copy.places import NUMBER
from report.copy.reading import ReaderCopy
from report.document.document import Document
from report.judging.claim import Kind
from report.judging.finding import Finding
from report.pages.formulas.foreign_mathematics import to_mathml

_CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")


@dataclass(frozen=True)
class CopiedFormula:
    """A displayed formula of the copy: MathML if pandoc can read it, its number there, and its LaTeX."""

    mathml: str | None
    number: str
    latex: str


@dataclass(frozen=True)
class CopiedPassage:
    """What the reader's copy has for a claim."""

    lines: tuple[int, int]  # First and last line
    text: str  # As it stands there; empty if the copy ends before
    formulas: tuple[CopiedFormula, ...]  # The displayed formulas in it
    is_judged: bool  # Whether the copy is the text that was judged
    is_open: bool  # Whether it is shown without being asked for


def passages(document: Document, copy: ReaderCopy) -> Mapping[str, CopiedPassage]:
    """Return what the copy has for each finding that says where it stands, by the finding's id."""
    placed = [finding for finding in document.findings if finding.lines is not None]
    latex = {finding.id: _formulas(finding, copy) for finding in placed}
    all_latex = tuple(dict.fromkeys(formula for formulas in latex.values() for formula in formulas))
    mathml = dict(zip(all_latex, to_mathml([NUMBER.sub("", formula) for formula in all_latex]), strict=True))
    return {
        finding.id: CopiedPassage(
            lines=finding.lines,
            text=_CONTROL.sub("\ufffd", "\n".join(copy.passage(finding.lines)).strip("\n")),
            formulas=tuple(_formula(formula, mathml[formula]) for formula in latex[finding.id]),
            is_judged=copy.is_judged,
            is_open=finding.kind is Kind.EQUATION,
        )
        for finding in placed
        if finding.lines is not None
    }


def _formulas(finding: Finding, copy: ReaderCopy) -> tuple[str, ...]:
    """Return the LaTeX of the displayed formulas of a finding's passage, without dollar signs."""
    if finding.lines is None:
        return ()
    found = (block for block in blocks(copy.passage(finding.lines)) if block.kind is BlockKind.FORMULA)
    return tuple(latex for block in found if (latex := block.text.strip().strip("$").strip()))


def _formula(latex: str, mathml: str | None) -> CopiedFormula:
    number = NUMBER.search(latex)
    return CopiedFormula(mathml, number[1] if number else "", latex)
