"""A wrong derivation or number of ours is noticed: the derived side is corrupted, and claims must say so.

Noticed means that two independent ways to the same thing contradict each other, or that a verdict changes.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from types import ModuleType

import pytest

from report.chapters.appendix_d import claims as appendix_d
from report.chapters.chapter_2.claims import section_2_2_1 as section_2_2_1_lagrangian
from report.chapters.chapter_2.claims import section_2_2_2
from report.chapters.chapter_5.claims import section_5_1_3, section_5_2_2
from report.chapters.chapter_5.claims import section_5_2_1_predictions as section_5_2_1
from report.claim import ContradictionError, judge
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import Pair
from report.numbers.linear_numbers import solve_linear


@dataclass(frozen=True)
class Corruption:
    """What is made wrong, and a claim that must notice it."""

    corrupt: Callable[[Evidence], Evidence]
    section: ModuleType
    claim: str


def _derivation(**changes: Callable[[Evidence], object]) -> Callable[[Evidence], Evidence]:
    def corrupt(evidence: Evidence) -> Evidence:
        wrong = {name: change(evidence) for name, change in changes.items()}
        return replace(evidence, derivation=replace(evidence.derivation, **wrong))

    return corrupt


def _other_stiffness(evidence: Evidence) -> Evidence:
    parameters = replace(evidence.numbers.parameters, k2=30.1e3)
    return replace(evidence, numbers=solve_linear(evidence.derivation, parameters))


def _other_denominator(evidence: Evidence) -> Evidence:
    first, second, *others = evidence.numbers.denominator
    wrong = (first, second * 1001 / 1000, *others)
    return replace(evidence, numbers=replace(evidence.numbers, denominator=wrong))


def _opposite_feedback(evidence: Evidence) -> Evidence:
    wrong = -evidence.numbers.displacement_only
    return replace(evidence, numbers=replace(evidence.numbers, displacement_only=wrong))


def _modes_in_another_order(evidence: Evidence) -> Evidence:
    first, *others = evidence.numbers.modes
    return replace(evidence, numbers=replace(evidence.numbers, modes=(*others, first)))


def _twice_the_amplitude(evidence: Evidence) -> Evidence:
    pair: Pair = evidence.cycles.friction
    wrong = replace(pair, stable=replace(pair.stable, amplitude=2 * pair.stable.amplitude))
    return replace(evidence, cycles=replace(evidence.cycles, friction=wrong))


def _a_thousandth_in_frequency(evidence: Evidence) -> Evidence:
    pair: Pair = evidence.cycles.inertia
    wrong = replace(pair, stable=replace(pair.stable, omega=1.001 * pair.stable.omega))
    return replace(evidence, cycles=replace(evidence.cycles, inertia=wrong))


CORRUPTIONS = {
    "potential energy with the wrong sign": Corruption(
        _derivation(potential_energy=lambda known: -known.derivation.potential_energy),
        section_2_2_1_lagrangian,
        "eq-2.5",
    ),
    "kinetic energy with the wrong sign": Corruption(
        _derivation(kinetic_energy=lambda known: -known.derivation.kinetic_energy),
        section_2_2_1_lagrangian,
        "eq-2.4",
    ),
    "dissipation without its half": Corruption(
        _derivation(rayleigh_function=lambda known: 2 * known.derivation.rayleigh_function),
        section_2_2_1_lagrangian,
        "eq-2.7",
    ),
    "accelerations with the wrong sign": Corruption(
        _derivation(accelerations=lambda known: tuple(-each for each in known.derivation.accelerations)),
        appendix_d,
        "eq-D.5",
    ),
    "another stiffness of the bridge": Corruption(_other_stiffness, section_5_1_3, "eq-5.2"),
    "a coefficient off by a thousandth": Corruption(_other_denominator, section_5_1_3, "eq-5.2"),
    "feedback with the wrong sign": Corruption(_opposite_feedback, section_2_2_2, "eq-2.16"),
    "modes in another order": Corruption(_modes_in_another_order, section_5_1_3, "txt-5.1.3-first-resonance"),
    "twice the amplitude": Corruption(_twice_the_amplitude, section_5_2_1, "txt-5.2.1-prediction"),
    "a thousandth in frequency": Corruption(
        _a_thousandth_in_frequency, section_5_2_2, "txt-5.2.2-prediction"
    ),
}


def _verdicts(corruption: Corruption, evidence: Evidence, inventory) -> tuple[str, ...]:
    (claim,) = (claim for claim in corruption.section.claims(evidence) if claim.id == corruption.claim)
    try:
        return tuple(part.verdict.value for part in judge(claim, inventory[claim.id]).parts)
    except ContradictionError:
        return ("contradiction",)


@pytest.mark.parametrize("name", CORRUPTIONS)
def test_a_corrupted_derivation_is_noticed(name, evidence, inventory):
    corruption = CORRUPTIONS[name]
    sound = _verdicts(corruption, evidence, inventory)
    assert sound != ("contradiction",)
    assert _verdicts(corruption, corruption.corrupt(evidence), inventory) != sound
