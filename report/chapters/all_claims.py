"""All claims and figures of the chapters, in the order of the inventory."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from types import ModuleType

from report.claim import Claim, Entry
from report.evidence import Evidence
from report.record import ClaimRecord, modules, records

SECTIONS = tuple(
    module
    for module in modules()
    if callable(getattr(module, "claims", None)) or records(module, ClaimRecord)
)


def claims_of(module: ModuleType, known: Evidence) -> tuple[Claim, ...]:
    """Return the claims that a module makes."""
    if callable(getattr(module, "claims", None)):
        made: tuple[Claim, ...] = module.claims(known)
        return made
    return tuple(record.claim(known) for record in records(module, ClaimRecord))


class ClaimIdError(ValueError):
    """An id that the inventory does not know, or that two claims share."""


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
