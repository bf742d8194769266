"""Making the report on a design: look at it, draw, render, write."""

import hashlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from report.cache.content_key import digest_of_packages
from report.cache.libraries import libraries
from report.cache.stage_store import StageStore
from report.design.report import DesignReport
from report.pages.formats import Format, Paper
from trimmer.deadline import NEVER, Deadline
from trimmer.design import Design, DesignFile, DesignSettings
from trimmer.design.parameter_studies.keeping import Keeper
from trimmer.design.study import Study, Told
from trimmer.runners.runner import Runner


class DesignInterruptedError(KeyboardInterrupt):
    """The work on a design was interrupted; the message says how to go on."""


MOST_PRINTED = 12
"""Coordinates of a mechanism up to which its equations are printed: those of 24 fill 30 pages."""
CACHE = ".kept"  # Folder beside the report in which each step is kept as soon as it is done


@dataclass(frozen=True)
class ReportPlace:
    """Where a report is written."""

    directory: Path  # Its folder
    stem: str  # Name of its files without their ends

    @property
    def store(self) -> StageStore:
        """Where steps are kept."""
        return StageStore(self.directory / CACHE)

    @property
    def log(self) -> Path:
        """Where it is written what was done when."""
        return self.directory / f"{self.stem}.log"

    def file(self, form: Format) -> Path:
        """Return the file of a form."""
        return self.directory / f"{self.stem}.{form.value}"


def keeper_of(file: DesignFile, store: StageStore) -> Keeper:
    """Return who keeps the steps of a design: by program, libraries, mechanism and how it begins."""
    depends = (digest_of_packages(("derivations", "trimmer")), libraries(), file.mechanism.to_toml())
    return Keeper(store, hashlib.sha256(repr(depends).encode()).hexdigest())


def looked_at(
    file: DesignFile,
    settings: DesignSettings,
    runner: Runner,
    store: StageStore,
    told: Told,
    deadline: Deadline = NEVER,
    *,
    short: bool = False,
) -> Design:
    """Look at a design, from what is kept of it on.

    Raises:
        DesignInterruptedError: after an interrupt.
        FileWriteError: if nothing can be kept there.
    """
    store.prepare()
    study = Study(file, settings, runner, keeper_of(file, store), told, deadline)
    with going_on_from(store):
        return study.short() if short else study.whole()


@contextmanager
def going_on_from(store: StageStore) -> Iterator[None]:
    """Say after an interrupt that what is done is kept.

    Raises:
        DesignInterruptedError: after an interrupt.
    """
    try:
        yield
    except KeyboardInterrupt:
        raise DesignInterruptedError(
            f"interrupted; what is done is kept in {store.folder}, and the same call goes on from there"
        ) from None


def report_on(design: Design, store: StageStore, date: str) -> DesignReport:
    """Return the report on a design as made on a day (ISO date), with its equations and pictures."""
    from report.design.equations import equations_of
    from report.design.origin import origin_of
    from report.design.pictures import pictures
    from report.design.report import DesignReport
    from report.pages.escaping import shown_characters

    mechanism = design.file.mechanism
    keeper = keeper_of(design.file, store)
    printed = len(mechanism.coordinates) <= MOST_PRINTED
    equations = keeper.made("equations", (), lambda: equations_of(mechanism)) if printed else None
    title = shown_characters(mechanism.title or design.file.name)
    return DesignReport(title, pictures(design), origin_of([design.file], date), design, equations)


def files_of(report: DesignReport, formats: frozenset[Format], paper: Paper) -> Mapping[Format, str | bytes]:
    """Return the contents of the files of a report."""
    from report.design.markdown import to_markdown
    from report.design.render import rendered

    return rendered(report, to_markdown(report), formats, paper)
