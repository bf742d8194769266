"""What the claims of a folder say, tried before pages are made of it: a fault is told with file and claim."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Final

from report.building.folder import FolderError
from report.document.document import Document
from report.judging.finding import Finding
from report.judging.shown import Mathematics, Words
from report.pages.links import BrokenLinkError
from report.pages.pandoc import PandocError, read, write
from report.rendering.markdown import to_markdown

_LINK: Final = re.compile(r"\]\(#([^)\s]+)\)")


def require_readable(path: Path, document: Document) -> None:
    """Check the links and formulas of all claims of a folder.

    Raises:
        FolderError: naming file and claim, if a link leads nowhere or pandoc cannot read a formula.
    """
    captions = {figure.id: figure.caption for figure in document.figures}
    said = [(each, "\n\n".join((*_said(each), captions.get(each.id, "")))) for each in document.findings]
    broken = _broken_links(document)
    for finding, words in said:
        if lost := [place for place in _LINK.findall(words) if place in broken]:
            raise FolderError(
                f"{path / finding.source}: the claim {finding.id} links to #{lost[0]}, a place that the "
                "report does not have; name a claim of the inventory, or leave the link out"
            )
    if _complaint("\n\n".join(words for _, words in said)):  # one call of pandoc where nothing is wrong
        for finding, words in said:
            if complaint := _complaint(words):
                raise FolderError(
                    f"{path / finding.source}: the claim {finding.id} has a formula that cannot be read: "
                    f"{complaint}; mend its LaTeX"
                )


def _said(finding: Finding) -> Iterator[str]:
    """Yield what a finding holds of Markdown, and its formulas."""
    yield from (finding.explanation, finding.consequence)
    for side in (side for part in finding.parts for side in (part.printed, part.derived)):
        match side:
            case Mathematics(latex):
                yield f"${latex}$"
            case Words(text):
                yield text


def _broken_links(document: Document) -> tuple[str, ...]:
    try:
        to_markdown(document)
    except BrokenLinkError as error:
        return error.places
    return ()


def _complaint(markdown: str) -> str:
    """Return the first line of what pandoc says against a text, or nothing."""
    try:
        write(read(markdown), "html", ["--mathml"])
    except PandocError as error:
        return str(error).partition("\n")[0]
    return ""
