"""Special points by ball arithmetic: period doublings to six digits, and what is not covered is said."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from trimmer import FollowedBranch, FollowSettings, Mechanism, SpecialKind, follow
from trimmer.branches.special import SpecialPoint

pytest.importorskip("flint")
from trimmer.proof import check_proof, prove_special_point

TURN = 2.0 * math.pi
MACHINE = Mechanism.from_toml(Path(__file__).parents[3] / "examples" / "oscillator-stop.toml")
DOUBLING = 5.5567187941
"""rad/s, of the example of pyHarm in tests/trimmer/branches/published.py."""


@pytest.fixture(scope="module")
def branch() -> FollowedBranch:
    settings = FollowSettings(switches=0, quiet=True, largest_step=0.02)
    return follow(MACHINE, "frequency", 5.553 / TURN, 5.56 / TURN, settings=settings)


@pytest.fixture(scope="module")
def doubling(branch: FollowedBranch) -> SpecialPoint:
    return next(each for each in branch.special if each.kind is SpecialKind.PERIOD_DOUBLING)


def test_a_period_doubling_is_proven(branch: FollowedBranch, doubling: SpecialPoint, tmp_path: Path) -> None:
    proof = prove_special_point(MACHINE, branch, doubling)
    assert (proof.verdict, proof.reason) == ("proven", "")
    assert doubling.value * TURN == pytest.approx(DOUBLING, rel=1e-9)
    assert proof.theorem.endswith(f"a period-doubling within 1e-06, relative, of {doubling.value!r}.")
    proof.write(tmp_path / "doubling.json")
    assert check_proof(tmp_path / "doubling.json") == proof


@pytest.mark.parametrize("factor", [1 + 3e-6, 1 - 3e-6])
def test_one_that_was_moved_is_refuted(branch: FollowedBranch, doubling: SpecialPoint, factor: float) -> None:
    moved = replace(doubling, value=doubling.value * factor)
    proof = prove_special_point(MACHINE, branch, moved)
    assert (proof.verdict, proof.theorem) == ("refuted", "")
    assert "no multiplier passes -1" in proof.reason


def test_other_kinds_are_undecided_or_refuted(branch: FollowedBranch, doubling: SpecialPoint) -> None:
    for kind in (SpecialKind.FOLD, SpecialKind.GRAZING, SpecialKind.TORUS):
        proof = prove_special_point(MACHINE, branch, replace(doubling, kind=kind))
        assert proof.verdict == "undecided"
        assert "is not covered" in proof.reason
    other = prove_special_point(MACHINE, branch, replace(doubling, kind=SpecialKind.SYMMETRY_BREAKING))
    assert other.verdict == "refuted"
