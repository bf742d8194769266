"""Judging a folder: its modules are imported and run, since whoever calls for it wrote them."""

import importlib
import sys
import traceback
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from mmap import mmap
from pathlib import Path
from types import ModuleType
from typing import Any, Final

from report.building import background
from report.building.assemble import chapters_of
from report.building.collect import ClaimIdError, Records, collect
from report.building.folder import PACKAGE, FolderError, JudgedFolder
from report.building.progress import Progress
from report.building.readable import require_readable
from report.cache.stage_store import StageStore
from report.document.document import Document
from report.judging.claim import Statement
from report.judging.finding import Finding
from report.judging.judge import ContradictionError, UngradedError, judge
from report.judging.record import ClaimRecord
from report.judging.text import RecordError
from report.pages.figure import Figure
from report.pages.provenance import provenance

EVIDENCE: Final = "evidence"
"""Module whose ``gather``, if there is one, solves what all claims and figures are given."""
NOTE: Final = 4096  # Bytes of the note on what is under way


def folder_content(folder: JudgedFolder, progress: Progress, _: StageStore) -> Document:
    """Judge every statement of a folder and draw its figures; nothing is kept for the next time.

    Its Python runs in a forked process, where there are any, so that an end of that process is noticed.

    Raises:
        FolderError: naming file, line or claim, and what to do, if its Python cannot be used.
    """
    with mmap(-1, NOTE) as note:
        try:
            (done,) = background.run([lambda: _content(folder, progress, note)])
        except background.BackgroundError as error:
            where = note[:].rstrip(bytes(1)).decode(errors="replace")
            raise FolderError(
                f"{where} ended the whole process, by os._exit or a crash; mend it there"
            ) from error
    document, progress.times[:] = done.result
    return document


def _content(
    folder: JudgedFolder, progress: Progress, note: mmap
) -> tuple[Document, list[tuple[str, float]]]:
    """Return the document, and the times of its stages; the note says what is under way."""
    with _imported_from(folder.path):
        with _told(folder, note, str(folder.path), "importing the modules"):
            records = collect(folder.inventory, folder.subject)
        inventory = _with_sources(folder, records)
        known = _gathered(folder, note)
        found = {
            finding.id: finding
            for group in progress.run(
                "judge",
                list(records.claims),
                lambda module: _judged(folder, note, records.claims[module], inventory, known),
            )
            for finding in group
        }
        figures = progress.run("draw", records.figures, lambda record: _drawn(folder, note, record, known))
    findings = tuple(found[claim_id] for claim_id in inventory)
    document = Document(
        subject=folder.subject,
        chapters=chapters_of(folder.subject, findings, inventory),
        statements_in_thesis=len(inventory),
        derivation=(),
        figures=figures,
        nomenclature=(),
        parameters=(),
        provenance=provenance(),
        text_copy=folder.text,
        sections=folder.sections,
    )
    require_readable(folder.path, document)
    return document, progress.times


def _with_sources(folder: JudgedFolder, records: Records) -> dict[str, Statement]:
    """Say of each statement which file judges it, where the inventory does not."""
    files = {
        record.id: f"{module.removeprefix(f'{PACKAGE}.').replace('.', '/')}.py"
        for module, group in records.claims.items()
        for record in group
    }
    return {
        claim_id: replace(entry, source=entry.source or files[claim_id])
        for claim_id, entry in folder.inventory.items()
    }


def _gathered(folder: JudgedFolder, note: mmap) -> Any:
    if not (folder.path / f"{EVIDENCE}.py").is_file():
        return None
    gather = getattr(importlib.import_module(f"{PACKAGE}.{EVIDENCE}"), "gather", None)
    if gather is None:
        return None
    with _told(folder, note, str(folder.path / f"{EVIDENCE}.py"), "gather()"):
        return gather()


def _judged(
    folder: JudgedFolder,
    note: mmap,
    records: Sequence[ClaimRecord],
    inventory: Mapping[str, Statement],
    known: Any,
) -> list[Finding]:
    findings = []
    for record in records:
        where = str(folder.path / inventory[record.id].source)
        with _told(folder, note, where, f"the claim {record.id}"):
            findings.append(judge(record.claim(known), inventory[record.id]))
    return findings


def _drawn(folder: JudgedFolder, note: mmap, record: Any, known: Any) -> Figure:
    with _told(folder, note, folder.subject.file_of(record.draw.__module__), f"the figure {record.id}"):
        figure: Figure = record.finished(known)
        return figure


@contextmanager
def _imported_from(path: Path) -> Iterator[None]:
    """Let the modules of a folder be imported as those of a package, and forget them afterwards."""
    package = ModuleType(PACKAGE)
    package.__path__ = [str(path.absolute())]
    _forget()
    sys.modules[PACKAGE] = package
    importlib.invalidate_caches()
    try:
        yield
    finally:
        _forget()


def _forget() -> None:
    for name in [name for name in sys.modules if name == PACKAGE or name.startswith(f"{PACKAGE}.")]:
        del sys.modules[name]


@contextmanager
def _told(folder: JudgedFolder, note: mmap, where: str, doing: str) -> Iterator[None]:
    """Say where in the folder something is wrong, and what to do.

    Raises:
        FolderError: in place of whatever the folder's Python raises.
    """
    note[:] = f"{where}: {doing}".encode()[:NOTE].ljust(NOTE, bytes(1))
    try:
        yield
    except ClaimIdError as error:
        raise FolderError(str(error)) from error
    except RecordError as error:
        raise FolderError(f"{where}: {error}") from error
    except UngradedError as error:
        raise FolderError(
            f"{where}: {error}; write conclusion, result or slip into the column severity of "
            f"{folder.subject.inventory}"
        ) from error
    except ContradictionError as error:
        raise FolderError(
            f"{where}: {error}; nothing is judged until both agree: mend one of them"
        ) from error
    except (Exception, SystemExit) as error:
        raise FolderError(
            f"{_line(error, folder.path) or where}: {doing} ended with {type(error).__name__}: {error}; "
            "mend it there"
        ) from error


def _line(error: BaseException, path: Path) -> str:
    """Return file and line of the folder where an error came from, if it did."""
    if isinstance(error, SyntaxError) and error.filename:
        return f"{path / Path(error.filename).name}, line {error.lineno}"
    inside = [
        frame
        for frame in traceback.extract_tb(error.__traceback__)
        if Path(frame.filename).parent == path.absolute()
    ]
    return f"{path / Path(inside[-1].filename).name}, line {inside[-1].lineno}" if inside else ""
