"""What cards say of kept proofs: a sentence where the numbers are theirs, no report where they are not."""

import json
from dataclasses import replace

import pytest

from report.numbers.proven import OtherNumbersError, cycle_is_proven, orbit_is_proven, solutions_are_proven
from report.numbers.twin.closed_loop import thesis_loop
from trimmer import ClosedLoop, FrictionBacklash, periodic_orbits, respond
from trimmer.examples import example_proof
from trimmer.proof import prove_orbit
from trimmer.thesis import TrimmerParameters, pin_model

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


def test_kept_orbits_are_those_of_the_loops_that_cards_name():
    """What a file calls its equations is unchecked; these are set up anew."""
    pytest.importorskip("flint")
    plant = pin_model(TrimmerParameters.thesis(), channels="displacement")
    loop = ClosedLoop(plant, FrictionBacklash(4e-5))
    stable, unstable = periodic_orbits(loop).orbits
    rubbing = respond(thesis_loop(2e-4, 1.6), state={"q1": 3e-3}).motion.orbit
    for name, orbit in (("stable", stable), ("unstable", unstable), ("friction", rubbing)):
        made = modes_of(prove_orbit(orbit.subject, orbit).data)
        kept = modes_of(json.loads(example_proof(f"thesis-{name}-orbit"))["data"])
        assert len(made) == len(kept)
        for mode in kept:
            assert any(other == pytest.approx(mode, rel=1e-12, abs=0.0) for other in made), name


def modes_of(data):
    """Return the numbers of each mode in a row."""
    modes = data["equations"]["modes"]
    return [[number for table in each.values() for row in table for number in row] for each in modes]
