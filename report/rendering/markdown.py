"""Document to pandoc Markdown: one content for all outputs."""

from __future__ import annotations

import functools
import re
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from report.claim import Finding, Mathematics, Number, Shown, Verdict, Words
from report.document import Document
from report.rendering import escaping, summary
from report.rendering.latex import width
from report.rendering.line_breaking import fit

TEMPLATES = Path(__file__).parent.parent / "templates"
FULL_LINE = 40.0
"""Width of a displayed formula's line, in em."""
HALF_LINE = 15.0
"""Width of a formula in a table that holds printed and derived side by side, in em."""

_INTERNAL_LINK = re.compile(r"\]\(#([^)\s]+)\)")
_IDENTIFIER = re.compile(r"(?<=[{ ])#([^\s}#]+)(?=[^{}\n]*\}\s*$)", re.MULTILINE)


class BrokenLinkError(ValueError):
    """The report links to a place that it does not have, or has the same place twice."""


def to_markdown(document: Document) -> str:
    """Return the whole report as pandoc Markdown.

    Raises:
        BrokenLinkError: if two places share an identifier, or a link, a highlight or a step of the derivation
            names a place or a claim that the report does not have.
        ValueError: if an equation is empty or holds a dollar sign.
    """
    _check_claims(document)
    text = (
        _environment()
        .get_template("report.md.j2")
        .render(
            document=document,
            findings={finding.id: finding for finding in document.findings},
            drawn={figure.id for figure in document.figures},
            counts=summary.count_table(document),
        )
    )
    _check_links(text)
    return text


def shown(content: Shown, name: str, line: float) -> str:
    """Return one side of a comparison as Markdown.

    Args:
        content: the formula, number or words.
        name: what the formula is called when it does not fit, and above its LaTeX.
        line: width of the line it has to fit into, in em.
    """
    match content:
        case Mathematics(latex):
            return formula(latex, name, line)
        case Number(digits, unit):
            return escaping.digits(digits) + (rf"\ {escaping.plain(unit)}" if unit else "")
        case Words(text):
            return escaping.prose(text)


def formula(latex: str, name: str, line: float) -> str:
    """Return a displayed formula, broken to fit the line, in a Div that carries its name."""
    broken = escaping.display_mathematics(fit(escaping.checked(latex), line))
    return f"::: {{.formula name={escaping.attribute(name)}}}\n{broken}\n:::"


def side_by_side(finding: Finding) -> bool:
    """Say whether every printed and derived side is narrow enough for half a line."""
    sides = [side for part in finding.parts for side in (part.printed, part.derived)]
    return all(width(side.latex) <= HALF_LINE for side in sides if isinstance(side, Mathematics))


@functools.cache
def _environment() -> Environment:
    environment = Environment(
        loader=FileSystemLoader(TEMPLATES),
        undefined=StrictUndefined,
        autoescape=False,
        trim_blocks=True,
        lstrip_blocks=True,
        comment_start_string="((*",
        comment_end_string="*))",
    )
    environment.filters.update(
        plain=escaping.plain,
        plain_with_mathematics=escaping.plain_with_mathematics,
        prose=escaping.prose,
        attribute=escaping.attribute,
        mathematics=escaping.inline_mathematics,
        digits=escaping.digits,
        reference=summary.reference,
        methods=summary.methods,
        slips=summary.slips,
        sentence=summary.sentence,
    )
    environment.globals.update(
        shown=shown,
        formula=formula,
        side_by_side=side_by_side,
        verdicts=tuple(Verdict),
        symbols=summary.SYMBOLS,
        meanings=summary.MEANINGS,
        reaches=summary.REACHES,
        FULL_LINE=FULL_LINE,
        HALF_LINE=HALF_LINE,
    )
    return environment


def _check_claims(document: Document) -> None:
    named = {highlight.claim: "a highlight" for highlight in document.highlights}
    named |= {
        claim: f"step {step.id} of the derivation" for step in document.derivation for claim in step.claims
    }
    for claim in sorted(set(named) - {finding.id for finding in document.findings}):
        raise BrokenLinkError(f"{named[claim]} names the claim {claim}, which the report does not have")


def _check_links(text: str) -> None:
    identifiers = _IDENTIFIER.findall(text)
    twice = sorted({identifier for identifier in identifiers if identifiers.count(identifier) > 1})
    if twice:
        raise BrokenLinkError(
            f"the report has these identifiers twice, rename one of each: {', '.join(twice)}"
        )
    broken = sorted(set(_INTERNAL_LINK.findall(text)) - set(identifiers))
    if broken:
        raise BrokenLinkError(
            f"the report links to places it does not have: {', '.join(broken)}; "
            "correct the link or add the claim, step or figure"
        )
