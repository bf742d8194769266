"""Outputs of the blocks of backlash under the sine of figures 4.1 to 4.3."""

from __future__ import annotations

from typing import Final

import control
import numpy as np

from report.numbers.independent.listed_blocks import DRIVE_GAP, friction_block, inertia_block
from report.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, TURN
from trimmer.arrays import Reals
from trimmer.elements.inertia_backlash import InertiaBacklash

SAMPLES: Final = 2003
"""Samples of a period, none of which is an instant at which Listing A.8 applies no line."""
GAPS: Final = (0.0, 2e-4, 4e-4, 8e-4, 16e-4)
"""Gaps of our figure 4.3, m; those of the thesis are not given."""


def phases(samples: int = SAMPLES) -> Reals:
    """Return the phases of two periods of the pin, rad."""
    return TURN * np.arange(2 * samples) / samples


def own_block(samples: int = SAMPLES) -> Reals:
    """Return the output of Listing A.7 for the sine of figure 4.1 from rest, m."""
    load, outputs = 0.0, []
    for pin in DRIVE_AMPLITUDE * np.sin(phases(samples)):
        load = friction_block(float(pin), DRIVE_GAP, load)
        outputs.append(load)
    return np.array(outputs)


def built_in_block(samples: int = SAMPLES) -> Reals:
    """Return the output of python-control's backlash for the same sine from rest, m."""
    block = control.friction_backlash_nonlinearity(DRIVE_GAP)
    return np.array([block(float(pin)) for pin in DRIVE_AMPLITUDE * np.sin(phases(samples))])


def listing_a8() -> Reals:
    """Return the output of Listing A.8 for its own drive, m."""
    return inertia_block(DRIVE_AMPLITUDE * np.sin(phases()), phases() / DRIVE_OMEGA)


def exact_inertia(gap: float) -> Reals:
    """Return the derived waveform of a load without friction, m; the pin itself without gap."""
    if gap == 0:
        return DRIVE_AMPLITUDE * np.sin(phases())
    return InertiaBacklash(gap).waveform(phases(), DRIVE_AMPLITUDE)
