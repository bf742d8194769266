"""Poles of loops with unit feedback."""

from __future__ import annotations

from typing import TYPE_CHECKING

import control
import numpy as np

if TYPE_CHECKING:
    from trimmer.arrays import Complexes


def decays(plant: control.TransferFunction) -> bool:
    """Return whether all poles of a plant lie in the left half plane."""
    return bool((plant.poles().real < 0).all())


def feedback_poles(plant: control.TransferFunction) -> Complexes:
    """Return the poles of a plant in negative unit feedback, rad/s."""
    return np.asarray(control.feedback(plant, 1).poles())
