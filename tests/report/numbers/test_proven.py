"""What cards say of kept proofs: a sentence where the numbers are theirs, no report where they are not."""

from __future__ import annotations

from dataclasses import replace

import pytest

from report.numbers.proven import OtherNumbersError, cycle_is_proven, orbit_is_proven, solutions_are_proven

CYCLES = "thesis-limit-cycles"


def test_a_list_is_said_to_be_proven_only_where_the_proof_has_its_numbers(evidence):
    plant, pair = evidence.numbers.displacement_only, evidence.cycles.friction
    cycles = [pair.unstable, pair.stable]
    assert "has 2 solutions and no other" in solutions_are_proven(CYCLES, plant, 4e-5, cycles)
    assert "has no solution" in solutions_are_proven("thesis-turned-sign", -plant, 4e-5, [])
    moved = [pair.unstable, replace(pair.stable, omega=pair.stable.omega * (1 + 1e-7))]
    wrong = [(plant, 4e-5, cycles[:1]), (plant, 4e-6, cycles), (-plant, 4e-5, cycles), (plant, 4e-5, moved)]
    for arguments in wrong:
        with pytest.raises(OtherNumbersError, match="prove what the card says, and keep that"):
            solutions_are_proven(CYCLES, *arguments)


def test_an_orbit_is_said_to_be_proven_only_where_the_proof_has_its_period(evidence):
    pair = evidence.orbits.friction
    assert "exists and is stable" in orbit_is_proven("thesis-stable-orbit", pair.stable)
    assert "exists and is unstable" in orbit_is_proven("thesis-unstable-orbit", pair.unstable)
    with pytest.raises(OtherNumbersError, match="another period"):
        orbit_is_proven("thesis-stable-orbit", pair.unstable)


@pytest.mark.parametrize(
    ("force", "gap", "frequency"), [(1.65, 2e-4, 710.7), (1.6, 4e-5, 710.7), (1.6, 2e-4, 712.0)]
)
def test_a_cycle_with_friction_is_that_of_its_proof(force, gap, frequency):
    told = cycle_is_proven("thesis-friction-orbit", 1.6, 2e-4, 710.74, 1.65)
    assert told.endswith("that none is left with 1.65 N is computed, not proven.")
    with pytest.raises(OtherNumbersError):
        cycle_is_proven("thesis-friction-orbit", force, gap, frequency, 1.65)
