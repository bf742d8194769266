"""Poles of loops with unit feedback."""

from __future__ import annotations

from typing import TYPE_CHECKING

import control
import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def decays(plant: control.TransferFunction) -> bool:
    """Return whether all poles of a plant lie in the left half plane."""
    return bool((plant.poles().real < 0).all())


def feedback_poles(plant: control.TransferFunction) -> NDArray[np.complex128]:
    """Return the poles of a plant in negative unit feedback, rad/s."""
    return np.asarray(control.feedback(plant, 1).poles())
