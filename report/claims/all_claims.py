"""All claims that are judged so far, checked against the inventory."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping

from report.claim import Claim, Entry
from report.claims import (
    appendix_a,
    appendix_a_10,
    appendix_a_elements,
    appendix_d,
    chapters_6_and_7,
    figures_5_2,
    section_2_2_1_lagrangian,
    section_2_2_1_state_space,
    section_2_2_2,
    section_2_2_3,
    section_2_3_4_friction,
    section_2_3_4_inertia,
    section_2_3_4_viscous,
    section_2_3_5,
    section_2_3_6,
    section_2_3_method,
    section_2_4,
    section_5_1_1,
    section_5_1_2,
    section_5_1_2_low_pass,
    section_5_1_3,
    section_5_2_1,
    section_5_2_1_measures,
    section_5_2_2,
    section_5_2_3,
    section_5_2_4,
)
from report.evidence import Evidence

SECTIONS = (
    section_2_2_1_lagrangian,
    section_2_2_1_state_space,
    section_2_2_2,
    section_2_2_3,
    section_2_3_method,
    section_2_3_4_friction,
    section_2_3_4_inertia,
    section_2_3_4_viscous,
    section_2_3_5,
    section_2_3_6,
    section_2_4,
    section_5_1_1,
    section_5_1_2,
    section_5_1_2_low_pass,
    section_5_1_3,
    section_5_2_1,
    section_5_2_1_measures,
    section_5_2_2,
    section_5_2_3,
    section_5_2_4,
    appendix_a,
    appendix_a_10,
    appendix_a_elements,
    appendix_d,
    chapters_6_and_7,
    figures_5_2,
)


class ClaimIdError(ValueError):
    """An id that the inventory does not know, or that two claims share."""


def all_claims(evidence: Evidence, inventory: Mapping[str, Entry]) -> tuple[Claim, ...]:
    """Return every claim, in the order of the inventory.

    Raises:
        ClaimIdError: if an id is unknown or stands twice.
    """
    claims = [claim for section in SECTIONS for claim in section.claims(evidence)]
    require_known_once((claim.id for claim in claims), inventory)
    order = {claim_id: place for place, claim_id in enumerate(inventory)}
    return tuple(sorted(claims, key=lambda claim: order[claim.id]))


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
