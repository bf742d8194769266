"""What claims are judged with: the symbolic derivation and the numbers that were solved from it."""

from __future__ import annotations

from dataclasses import dataclass

from derivations.laplace import GeneralSystem, TransformedSystem, general_system, transform
from derivations.linear_trimmer import LinearTrimmer, derive_linear_trimmer
from report.linear_numbers import LinearNumbers, solve_linear
from trimmer import TrimmerParameters


@dataclass(frozen=True)
class Evidence:
    """Derivation and numbers of the linear trimmer, and a general system solved in the Laplace domain."""

    derivation: LinearTrimmer
    general: GeneralSystem
    transformed: TransformedSystem
    numbers: LinearNumbers


def gather() -> Evidence:
    """Derive and solve everything that the claims need."""
    derivation = derive_linear_trimmer()
    general = general_system()
    return Evidence(
        derivation, general, transform(general), solve_linear(derivation, TrimmerParameters.thesis())
    )
