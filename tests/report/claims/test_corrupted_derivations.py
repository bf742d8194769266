"""A wrong derivation or number of ours is noticed: the derived side is corrupted, and claims must say so.

Noticed means that two independent ways to the same thing contradict each other, or that a verdict changes.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import pytest

from report.judging.judge import ContradictionError, judge
from report.judging.record import ClaimRecord
from report.numbers.evidence import Evidence
from report.numbers.limit_cycle_numbers import Pair
from report.numbers.linear_numbers import solve_linear
from tests.report.claims.graded import graded


@dataclass(frozen=True)
class Corruption:
    """What is made wrong, and a claim that must notice it."""

    corrupt: Callable[[Evidence], Evidence]
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
        _derivation(potential_energy=lambda known: -known.derivation.potential_energy), "eq-2.5"
    ),
    "kinetic energy with the wrong sign": Corruption(
        _derivation(kinetic_energy=lambda known: -known.derivation.kinetic_energy), "eq-2.4"
    ),
    "dissipation without its half": Corruption(
        _derivation(rayleigh_function=lambda known: 2 * known.derivation.rayleigh_function), "eq-2.7"
    ),
    "accelerations with the wrong sign": Corruption(
        _derivation(accelerations=lambda known: tuple(-each for each in known.derivation.accelerations)),
        "eq-D.5",
    ),
    "another stiffness of the bridge": Corruption(_other_stiffness, "eq-5.2"),
    "a coefficient off by a thousandth": Corruption(_other_denominator, "eq-5.2"),
    "feedback with the wrong sign": Corruption(_opposite_feedback, "eq-2.16"),
    "modes in another order": Corruption(_modes_in_another_order, "txt-5.1.3-first-resonance"),
    "twice the amplitude": Corruption(_twice_the_amplitude, "txt-5.2.1-prediction"),
    "a thousandth in frequency": Corruption(_a_thousandth_in_frequency, "txt-5.2.2-prediction"),
}


def _verdicts(record: ClaimRecord, evidence: Evidence, inventory) -> tuple[str, ...]:
    try:
        finding = judge(record.claim(evidence), graded(inventory[record.id]))
    except ContradictionError:
        return ("contradiction",)
    return tuple(part.verdict.value for part in finding.parts)


@pytest.mark.parametrize("name", CORRUPTIONS)
def test_a_corrupted_derivation_is_noticed(name, evidence, inventory, records):
    corruption = CORRUPTIONS[name]
    record = records.by_id[corruption.claim]
    sound = _verdicts(record, evidence, inventory)
    assert sound != ("contradiction",)
    assert _verdicts(record, corruption.corrupt(evidence), inventory) != sound
