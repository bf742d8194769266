"""The records of all chapters: found by looking through the modules, put in the order of the inventory."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from importlib import import_module
from pkgutil import walk_packages

from report import chapters
from report.claim import Entry
from report.record import ClaimRecord, FigureRecord


class ClaimIdError(ValueError):
    """An id that the inventory does not know, or that two records of one kind share."""


@dataclass(frozen=True)
class Records:
    """All claims and figures.

    Attributes:
        claims: Those of each module, by its name, in the order in which they stand in it.
        figures: In the order of the inventory.
    """

    claims: Mapping[str, tuple[ClaimRecord, ...]]
    figures: tuple[FigureRecord, ...]

    @property
    def by_id(self) -> dict[str, ClaimRecord]:
        """The claims by their ids."""
        return {record.id: record for group in self.claims.values() for record in group}


def collect(inventory: Mapping[str, Entry]) -> Records:
    """Import all modules of the chapters and return the records that they make.

    Raises:
        ClaimIdError: if the inventory lacks an id, or if one stands twice.
    """
    claims, figures = {}, []
    for module in walk_packages(chapters.__path__, f"{chapters.__name__}."):
        values = vars(import_module(module.name)).values()
        if made := tuple(value for value in values if isinstance(value, ClaimRecord)):
            claims[module.name] = made
        figures += [value for value in values if isinstance(value, FigureRecord)]
    require_known_once((record.id for group in claims.values() for record in group), inventory)
    require_known_once((figure.id for figure in figures), inventory)
    place = {claim_id: index for index, claim_id in enumerate(inventory)}
    return Records(claims, tuple(sorted(figures, key=lambda figure: place[figure.id])))


def require_known_once(ids: Iterable[str], inventory: Mapping[str, Entry]) -> None:
    """Raise for an id that the inventory lacks, or that stands twice.

    Raises:
        ClaimIdError: naming the id.
    """
    for claim_id, count in Counter(ids).items():
        if claim_id not in inventory:
            raise ClaimIdError(f"claim {claim_id} is not in the inventory")
        if count > 1:
            raise ClaimIdError(f"claim {claim_id} stands {count} times")
