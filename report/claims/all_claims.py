"""All claims that are judged so far, checked against the inventory."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping

from report.claim import Claim, Entry
from report.claims import (
    appendix_a,
    appendix_a_9,
    appendix_a_10,
    appendix_a_captions,
    appendix_a_elements,
    appendix_a_names,
    appendix_a_search,
    appendix_a_time_domain,
    appendix_d,
    appendix_e,
    chapter_4_figures,
    chapter_7_friction,
    chapter_7_input,
    chapter_7_models,
    chapter_7_peaks,
    chapter_7_play,
    chapter_7_resonance,
    chapters_6_and_7,
    figures_1_and_2_2,
    figures_2_3_6,
    figures_2_3_blocks,
    figures_2_3_friction_backlash,
    figures_2_3_heavy_load,
    figures_3_experiment,
    figures_3_simulation,
    figures_5_2,
    figures_5_2_5,
    figures_5_2_harmonic_balance,
    figures_5_2_simulated,
    nomenclature,
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
    section_2_3_scope,
    section_2_4,
    section_3_1,
    section_3_1_output,
    section_3_2,
    section_3_2_tables,
    section_3_3_closed_loop,
    section_3_3_frequency,
    section_3_3_friction,
    section_3_3_open_loop,
    section_4_2,
    section_5_1_1,
    section_5_1_2,
    section_5_1_2_low_pass,
    section_5_1_3,
    section_5_1_3_zeros,
    section_5_2,
    section_5_2_1,
    section_5_2_1_driven,
    section_5_2_1_impulse,
    section_5_2_1_measures,
    section_5_2_1_scaling,
    section_5_2_1_simulated,
    section_5_2_2,
    section_5_2_2_simulated,
    section_5_2_3,
    section_5_2_4,
    section_5_2_4_simulated,
    section_5_2_4_unit,
    section_5_2_5,
    section_5_2_5_simulated,
    section_5_2_references,
    section_6_1,
    section_6_3,
    section_6_scope,
)
from report.evidence import Evidence

SECTIONS = (
    section_2_2_1_lagrangian,
    section_2_2_1_state_space,
    section_2_2_2,
    section_2_2_3,
    section_2_3_method,
    section_2_3_scope,
    section_2_3_4_friction,
    section_2_3_4_inertia,
    section_2_3_4_viscous,
    section_2_3_5,
    section_2_3_6,
    section_2_4,
    section_3_1,
    section_3_1_output,
    section_3_2_tables,
    section_3_2,
    section_3_3_friction,
    section_3_3_open_loop,
    section_3_3_frequency,
    section_3_3_closed_loop,
    section_4_2,
    section_5_1_1,
    section_5_1_2,
    section_5_1_2_low_pass,
    section_5_1_3,
    section_5_1_3_zeros,
    section_5_2,
    section_5_2_1,
    section_5_2_1_scaling,
    section_5_2_1_measures,
    section_5_2_1_impulse,
    section_5_2_1_simulated,
    section_5_2_1_driven,
    section_5_2_2,
    section_5_2_2_simulated,
    section_5_2_3,
    section_5_2_4,
    section_5_2_4_simulated,
    section_5_2_4_unit,
    section_5_2_5,
    section_5_2_5_simulated,
    section_5_2_references,
    section_6_scope,
    section_6_1,
    section_6_3,
    nomenclature,
    appendix_a,
    appendix_a_10,
    appendix_a_elements,
    appendix_a_names,
    appendix_a_search,
    appendix_a_captions,
    appendix_a_time_domain,
    appendix_a_9,
    appendix_d,
    appendix_e,
    chapters_6_and_7,
    chapter_7_models,
    chapter_7_resonance,
    chapter_7_play,
    chapter_7_friction,
    chapter_7_input,
    chapter_7_peaks,
    figures_1_and_2_2,
    figures_2_3_blocks,
    figures_2_3_friction_backlash,
    figures_2_3_heavy_load,
    figures_2_3_6,
    figures_3_experiment,
    figures_3_simulation,
    chapter_4_figures,
    figures_5_2_harmonic_balance,
    figures_5_2_simulated,
    figures_5_2_5,
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
