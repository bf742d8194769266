"""Blocks of backlash, run sample by sample."""

from __future__ import annotations

from collections.abc import Callable

import control
import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]


def stepped(block: Callable[[float, float, float], float], pins: Reals, gap: float) -> Reals:
    """Return the loads (m) that a block leaves from rest, called with pin, gap and its last load (m)."""
    load, loads = 0.0, []
    for pin in pins:
        load = block(float(pin), gap, load)
        loads.append(load)
    return np.array(loads)


def stepped_by_library(pins: Reals, gap: float) -> Reals:
    """Return the output of python-control's backlash from rest for each position of the pin (m), m."""
    block = control.friction_backlash_nonlinearity(gap)
    return np.array([block(float(pin)) for pin in pins])
