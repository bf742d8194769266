"""The records of all chapters: found by looking through the modules, put in the order of the inventory."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from pkgutil import walk_packages
from typing import TypeVar

from report.building.thesis import THESIS
from report.document.subject import Subject
from report.judging.claim import Statement
from report.judging.figure import FigureRecord
from report.judging.record import ClaimRecord
from report.judging.text import RecordError


class ClaimIdError(RecordError):
    """An id that the inventory does not know, that two records of one kind share, or that has no claim."""


@dataclass(frozen=True)
class Records:
    """All claims and figures."""

    # Those of each module, by its name, in the order in which they stand in it
    claims: Mapping[str, tuple[ClaimRecord, ...]]
    figures: tuple[FigureRecord, ...]  # In the order of the inventory

    @property
    def by_id(self) -> dict[str, ClaimRecord]:
        """The claims by their ids."""
        return {record.id: record for group in self.claims.values() for record in group}


def collect(inventory: Mapping[str, Statement], subject: Subject = THESIS) -> Records:
    """Import all modules that judge a text and return the records that they make.

    Raises:
        ClaimIdError: if the inventory lacks an id, if one stands twice, or if a statement has no claim.
    """
    found = list(_found(subject.claims))
    judged = [(module, record) for module, record in found if isinstance(record, ClaimRecord)]
    claims = by_id(judged, inventory, subject)
    drawn = [(module, record) for module, record in found if isinstance(record, FigureRecord)]
    figures = by_id(drawn, inventory, subject)
    if lacking := [claim_id for claim_id in inventory if claim_id not in claims]:
        raise ClaimIdError(
            f"{', '.join(lacking)}: in the inventory, but without a record; write one in "
            f"{subject.records} (of two functions with one name only the second is left)"
        )
    groups: dict[str, list[ClaimRecord]] = {}
    for module, record in judged:
        groups.setdefault(module, []).append(record)
    return Records(
        {module: tuple(group) for module, group in groups.items()},
        tuple(figures[claim_id] for claim_id in inventory if claim_id in figures),
    )


AnyRecord = ClaimRecord | FigureRecord
Record = TypeVar("Record", ClaimRecord, FigureRecord)


def _found(package: str) -> Iterator[tuple[str, AnyRecord]]:
    """Yield each record with the module that makes it; one that is imported elsewhere only once."""
    seen: set[int] = set()
    for module in walk_packages(import_module(package).__path__, f"{package}."):
        for value in vars(import_module(module.name)).values():
            if isinstance(value, AnyRecord) and id(value) not in seen:
                seen.add(id(value))
                yield module.name, value


def by_id(
    found: Iterable[tuple[str, Record]], inventory: Mapping[str, Statement], subject: Subject = THESIS
) -> dict[str, Record]:
    """Return records of one kind, each given with the name of its module, by their ids.

    Raises:
        ClaimIdError: naming id and modules, if the inventory lacks an id or two records share one.
    """
    records: dict[str, Record] = {}
    homes: dict[str, str] = {}
    for module, record in found:
        if record.id not in inventory:
            raise ClaimIdError(
                f"{subject.file_of(module)}: {record.id} is not in the inventory; add a line to "
                f"{subject.inventory}"
            )
        if record.id in records:
            raise ClaimIdError(
                f"{record.id} stands twice, in {subject.file_of(homes[record.id])} and "
                f"{subject.file_of(module)}; keep one"
            )
        records[record.id], homes[record.id] = record, module
    return records
