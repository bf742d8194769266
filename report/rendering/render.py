"""Writing a report in all its forms."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from report.document import Document
from report.rendering.html import to_html
from report.rendering.json import to_json
from report.rendering.markdown import to_markdown
from report.rendering.pdf import to_pdf
from trimmer.files import write_whole


@dataclass(frozen=True)
class RenderedFiles:
    """Where the report was written."""

    html: Path
    pdf: Path
    claims: Path


def render(document: Document, directory: Path) -> RenderedFiles:
    """Write the report as ``report.html``, ``report.pdf`` and ``claims.json``.

    All three are made before the first is written, so that a failure leaves the files of the last build.

    Raises:
        BrokenLinkError: if a link inside the report leads nowhere or two places share an identifier.
        PandocError: if pandoc cannot read the text or its mathematics.
        TypesettingError: if the PDF cannot be set, for instance because a formula does not fit the page.
        FileWriteError: if a file cannot be written.
    """
    markdown = to_markdown(document)
    files = RenderedFiles(directory / "report.html", directory / "report.pdf", directory / "claims.json")
    with ThreadPoolExecutor() as pool:  # pandoc and Typst do the work, outside the interpreter's lock
        html = pool.submit(to_html, document, markdown)
        pdf = pool.submit(to_pdf, document, markdown)
        contents: dict[Path, str | bytes] = {
            files.html: html.result(),
            files.pdf: pdf.result(),
            files.claims: to_json(document),
        }
    for path, content in contents.items():
        write_whole(path, content)
    return files
