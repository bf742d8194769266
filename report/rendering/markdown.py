"""Document to pandoc Markdown: one content for all outputs."""

import functools
from collections.abc import Mapping
from typing import Any

from jinja2 import Environment, Template

from report.data.bibliography import cited, works
from report.document.document import Document
from report.judging.finding import Finding
from report.judging.shown import Mathematics, Number, Shown, Words
from report.judging.verdict import Grade, grade
from report.pages import escaping
from report.pages.displayed import code_block, formula
from report.pages.environment import MarkdownEnvironment
from report.pages.escaping import Markdown, markdown
from report.pages.formulas.latex import width
from report.pages.formulas.line_breaking import fit
from report.pages.links import BrokenLinkError, check_links
from report.rendering import errata, outline, summary
from report.rendering.pictures import spread_picture
from report.rendering.selection import without_links_to
from report.rendering.sources import identifier, sources

FULL_LINE = 40.0  # Width of a displayed formula's line, in em
HALF_LINE = 15.0  # Width of a formula in a table that holds printed and derived side by side, in em
HALF_LINE_OF_WORDS = 110
"""Most characters of words in such a table; longer ones are easier to read over the full width."""
MANY_PARTS = 6
"""From so many parts on words may be half as long again: one below the other, the parts would fill a page."""
ERRATA_LINE = 15.0  # Width of a line of a formula on the errata sheet, in em
WORKS = "bibliography"  # The piece with the works that all others cite
REPORT = (
    *("opening", "citing", "advice", "roots", "balance", "answers", "twin"),
    *("future_work", "derived", WORKS, "certificate"),
)
"""Pieces of the report to be read, in their order; then come the cards."""
CARDS = ("method",)  # Pieces before the cards of the chapters
BACK = ("programs", "explorable", "spread", "derivation", "nomenclature", "errata")
"""Pieces that follow the chapters."""
ARCHIVE = "octave.zip"  # Name of the archive of the corrected listings


def to_markdown(document: Document) -> dict[str, str]:
    """Return the report as pandoc Markdown, in named pieces that each stand alone and follow each other.

    First those of ``REPORT``, then those of the cards: each of the two is a PDF, both together are the page.

    Raises:
        BrokenLinkError: if two places share an identifier, or a link, an answer, a corrected
            result or a step of the derivation names a place or a claim that the report does not have, or
            a finding a source file that is not there.
        ValueError: if an equation is empty or holds a dollar sign.
    """
    _check_claims(document)
    content: dict[str, Any] = {
        "document": document,
        "findings": {finding.id: finding for finding in document.findings},
        "figures": {figure.id: figure for figure in document.figures},
        "titles": {step.id: step.title for step in document.steps},
        "program_of": {program.claim: program.name for program in document.programs},
        "counts": summary.count_table(document),
        "errata": errata.by_severity(errata.errata(document)),
    }
    template = _environment().get_template
    own = (*REPORT, *CARDS, *BACK)
    written = {name: template(f"{name}.md.j2").render(content) for name in own if name != WORKS}
    sections = _sections(document, template("section.md.j2"), content)
    citing = "".join((*written.values(), *sections.values()))
    content["works"] = [work for work in works() if f"(#ref-{work.name})" in citing]
    written[WORKS] = template(f"{WORKS}.md.j2").render(content)
    pieces = (
        {name: written[name] for name in (*REPORT, *CARDS)}
        | sections
        | {name: written[name] for name in BACK}
    )
    linked = {name: without_links_to(piece, document.omitted) for name, piece in pieces.items()}
    check_links("\n".join(linked.values()), [source.identifier for source in sources(document)])
    return linked


def _check_claims(document: Document) -> None:
    """Check that every claim is there that the document names outside of its chapters."""
    steps = document.steps
    named = {
        **{
            claim: f"step {step.id} of the derivation"
            for step in steps
            for claim in step.claims + step.others
        },
        **{figure.id: "a figure" for figure in document.figures},
        **{claim: "the graph of a slip" for edge in document.spread for claim in (edge.claim, edge.source)},
        **{claim: words for extra in document.extras.values() for claim, words in extra.named.items()},
    }
    for claim in sorted(set(named) - {finding.id for finding in document.findings}):
        raise BrokenLinkError(f"{named[claim]} names the claim {claim}, which the report does not have")


def _sections(document: Document, template: Template, content: Mapping[str, Any]) -> dict[str, str]:
    """Write each section of each chapter as a piece."""
    return {
        f"{chapter.id}-{group.number}": template.render(content, chapter=chapter, group=group, groups=groups)
        for chapter in document.chapters
        for groups in (outline.grouped(chapter, document.sections),)
        for group in groups
    }


def shown(content: Shown, name: str, line: float) -> Markdown:
    """Return one side of a comparison, by its name, as Markdown that fits into a line of some width, em."""
    if isinstance(content, Mathematics):
        return formula(content.latex, name, line)
    return in_line(content, line)


def in_line(content: Shown, line: float) -> Markdown:
    """Return a formula, number or words as Markdown that can stand in a paragraph.

    A formula longer than a line is there twice, broken and unbroken: Typst breaks it better by itself.
    """
    match content:
        case Mathematics(latex):
            unbroken = escaping.checked(latex)
            broken = fit(unbroken, line)
            if broken == unbroken:
                return Markdown(f"${unbroken}$")
            return Markdown(f"[${broken}$]{{.broken}}[${unbroken}$]{{.unbroken}}")
        case Number(digits, unit):
            shown_digits = escaping.digits(digits)
            return markdown(r"[{}\ {}]{{.number}}", shown_digits, unit) if unit else shown_digits
        case Words(text):
            return escaping.prose(text)


def side_by_side(finding: Finding) -> bool:
    """Say whether every printed and derived side is narrow or short enough for half a line."""
    most = HALF_LINE_OF_WORDS * (3 if len(finding.parts) >= MANY_PARTS else 2) // 2
    return all(
        _fits_half_a_line(side, most) for part in finding.parts for side in (part.printed, part.derived)
    )


def _fits_half_a_line(side: Shown, most_characters: int) -> bool:
    match side:
        case Mathematics(latex):
            return width(latex) <= HALF_LINE
        case Words(text):
            return len(text) <= most_characters
        case Number():
            return True


@functools.cache
def _environment() -> Environment:
    environment = MarkdownEnvironment()
    environment.filters.update(
        code_block=code_block,
        code_identifier=identifier,
        grade=grade,
        partly=summary.partly,
        reference=summary.reference,
        short_reference=summary.short_reference,
        methods=summary.methods,
        slips=summary.slips,
        copy_faults=summary.copy_faults,
        sentence=summary.sentence,
        capitalised=summary.capitalised,
        kinds_in_words=summary.kinds_in_words,
        figures_judged=summary.figures_judged,
        command=summary.command,
        build_time=summary.build_time,
        not_to_cite=summary.not_to_cite,
        spread=spread_picture.spread,
        spread_description=spread_picture.description,
    )
    environment.globals.update(
        shown=shown,
        in_line=in_line,
        formula=formula,
        side_by_side=side_by_side,
        place=outline.place,
        grades=tuple(Grade),
        grade_words=summary.GRADES,
        certainties=summary.CERTAINTIES,
        symbols=summary.SYMBOLS,
        partly_words=summary.IN_PART,
        **{each.name: each for each in Grade},
        FULL_LINE=FULL_LINE,
        HALF_LINE=HALF_LINE,
        ERRATA_LINE=ERRATA_LINE,
        ERRATA_HEADINGS=errata.HEADINGS,
        ARCHIVE=ARCHIVE,
        cited=cited,
        SPREAD_PICTURE=spread_picture.NAME,
    )
    return environment
