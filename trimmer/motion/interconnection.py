"""A linear system whose inputs are the outputs of switched components, and whose outputs are their inputs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.motion.errors import IllPosedLoopError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from trimmer.motion.component import Component
    from trimmer.motion.drive import Drive

    Reals = NDArray[np.float64]

NEGLIGIBLE = 1e-12
"""A product of a row and a column below this share of the product of their moduli is rounding."""


@dataclass(frozen=True, eq=False)
class Interconnection:
    """x' = A x + B v, with the output v_k of component k and its input e = C x + D v + drive_gain * drive.

    Attributes:
        A: n x n.
        B: n x m for m components.
        C: m x n.
        D: m x m.
        drive_gain: m numbers: how the drive adds to each input.
        components: The m components.
        labels: Their names, for events.
        drive: The motion that drives, or None.
        element_factors: The first components make up the nonlinear element; its output is the sum of theirs
            with these factors.
    """

    A: Reals
    B: Reals
    C: Reals
    D: Reals
    drive_gain: Reals
    components: tuple[Component, ...]
    labels: tuple[str, ...]
    drive: Drive | None
    element_factors: tuple[float, ...]

    def __post_init__(self) -> None:
        for k, (component, label) in enumerate(zip(self.components, self.labels, strict=True)):
            jumping = [j for j, other in enumerate(self.components) if other.output_jumps or j == k]
            if self.D[k, jumping].any():
                raise IllPosedLoopError(
                    f"{label}: an output acts on its input at once; the system must be strictly proper"
                )
            if component.continuous_rates and any(acts(self.C[k], self.B[:, j]) for j in jumping):
                raise IllPosedLoopError(
                    f"{label}: an output acts on the rate of its input at once; friction of a displacement "
                    "needs two more poles than zeros between force and displacement"
                )

    @property
    def order(self) -> int:
        """Number of states of the linear system."""
        return int(self.A.shape[0])


def acts(row: Reals, column: Reals) -> bool:
    """Tell whether a product of a row and a column is more than rounding."""
    return effect(row, column) != 0.0


def effect(row: Reals, column: Reals) -> float:
    """Return a product of a row and a column, relative to the sum of the moduli; 0 if it is rounding."""
    terms = row * (column / abs(column).max(initial=np.finfo(float).tiny))
    total, size = float(terms.sum()), float(abs(terms).sum())
    return total / size if abs(total) > NEGLIGIBLE * size else 0.0
