"""Building the report: its content, taken from the last build if nothing has changed, and its files."""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path

from report.building.progress import Progress
from report.cache.content_key import content_key
from report.cache.stage_store import StageStore
from report.data.text_copy import read_build_time
from report.document.advice import NAME as ADVICE
from report.document.advice import advice_json
from report.document.document import Document
from report.octave.archive import write_files
from report.pages.formats import Format
from report.pages.provenance import provenance
from report.rendering.render import render
from report.rendering.request import WHOLE_REPORT, Request
from report.rendering.selection import select
from trimmer.files import write_atomically

LOG = "build.log"
CACHE = ".cache"  # Folder of what is kept for the next build, in the report's
CONTENT = "content"
OCTAVE = "octave"  # Folder of the corrected listings, in the report's


Content = Callable[[Progress, StageStore], Document]
"""What makes a document, behind progress bars, with what is kept of the last one."""


@dataclass(frozen=True)
class Built:
    """Result of a build."""

    document: Document
    files: Mapping[Format, Path]
    beside: tuple[Path, ...]  # What was written besides: the advice, the folder of listings, the log of times
    seconds: float


def build(directory: Path, request: Request = WHOLE_REPORT, content: Content | None = None) -> Built:
    """Make the report, or the part of it that is wanted, and write it into a folder.

    ``content`` makes what it shows; without it that is what was found of the thesis. Nothing is written
    before everything has been made, so a failure leaves the previous report whole.

    Raises:
        ClaimIdError: if a claim is not in the inventory or stands twice.
        ContradictionError: if two independent derivations disagree.
        FileWriteError: if a file cannot be written.
        UnknownChapterError: if a chapter is wanted that has no claims.
    """
    started = time.perf_counter()
    progress = Progress()
    write_atomically(
        directory / LOG, "a build is under way, or was interrupted\n"
    )  # fails now, not at the end
    store = StageStore(directory / CACHE)
    document = select((content or _of_the_thesis)(progress, store), request.chapters)
    (files,) = progress.run("render", [document], lambda chosen: render(chosen, directory, request, store))
    write_files(document.programs, directory / OCTAVE)
    listings = [directory / OCTAVE] if document.programs else []
    advised = []
    if document.overview.opening is not None:
        advised = [directory / ADVICE]
        write_atomically(directory / ADVICE, advice_json(document.overview.opening.advice))
    write_atomically(directory / LOG, progress.log())
    beside = (*advised, *listings, directory / LOG)
    return Built(document, files, beside, time.perf_counter() - started)


def _of_the_thesis(progress: Progress, store: StageStore) -> Document:
    key = content_key()
    kept: Document | None = store.load(CONTENT, key)
    if kept is not None:
        (current,) = progress.run("kept", [kept], _with_provenance)
        return current
    (stages,) = progress.run(
        "load", ["report.building.stages"], import_module
    )  # SymPy, SciPy, Matplotlib: seconds
    document: Document = stages.make_document(progress, store)
    store.keep(CONTENT, key, document)
    return document


def _with_provenance(content: Document) -> Document:
    """Say of content that is kept what makes a report of it now."""
    return replace(content, provenance=provenance(read_build_time()))
