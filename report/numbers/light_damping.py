"""The trimmer of figure 5.4: very light damping, and the sum of all displacements as output."""

from __future__ import annotations

from dataclasses import replace

import control
import numpy as np

from trimmer import TrimmerParameters
from trimmer.generated import linear_trimmer

DAMPING_FACTOR = 1e-3


def lightly_damped(parameters: TrimmerParameters) -> TrimmerParameters:
    """Return the same trimmer with a thousandth of its damping; the thesis does not give its own factor."""
    dampings = {name: DAMPING_FACTOR * getattr(parameters, name) for name in ("c1", "c2", "c3", "c4")}
    return replace(parameters, **dampings)


def sum_of_displacements(parameters: TrimmerParameters) -> control.TransferFunction:
    """Return the transfer function from pin displacement to q1 + q2 + q3 + q4 (thesis, equation 5.3)."""
    values = parameters.values()
    numerator = np.sum(linear_trimmer.displacement_numerators(*values), axis=0)
    return control.tf(numerator, np.array(linear_trimmer.characteristic_polynomial(*values)))
