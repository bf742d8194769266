"""Building the report: its content, taken from the last build if nothing has changed, and its files."""

from __future__ import annotations

import time
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path

from report import content_cache
from report.document import Document
from report.progress import Progress
from report.provenance import provenance
from report.rendering.render import RenderedFiles, render
from trimmer.files import write_whole

LOG = "build.log"


@dataclass(frozen=True)
class Built:
    """Result of a build: its document, the files, the log of the stages' times, and the time it took, s."""

    document: Document
    files: RenderedFiles
    log: Path
    seconds: float


def build(directory: Path) -> Built:
    """Make the report and write it into a folder.

    Nothing is written before everything has been made, so a failure leaves the previous report whole.

    Raises:
        ClaimIdError: if a claim is not in the inventory or stands twice.
        ContradictionError: if two independent derivations disagree.
        FileWriteError: if a file cannot be written.
    """
    started = time.perf_counter()
    progress = Progress()
    write_whole(directory / LOG, "a build is under way, or was interrupted\n")  # fails now, not at the end
    document = _content(directory, progress)
    (files,) = progress.run("render", [document], lambda finished: render(finished, directory))
    log = directory / LOG
    write_whole(log, progress.log())
    return Built(document, files, log, time.perf_counter() - started)


def _content(directory: Path, progress: Progress) -> Document:
    key = content_cache.content_key()
    kept = content_cache.load(directory, key)
    if kept is not None:
        (current,) = progress.run("kept", [kept], lambda content: replace(content, provenance=provenance()))
        return current
    (stages,) = progress.run("load", ["report.stages"], import_module)  # SymPy, SciPy, Matplotlib: seconds
    document: Document = stages.make_document(progress)
    content_cache.store(directory, key, document)
    return document
