"""Listings A.3, A.7 and A.8 of backlash, repeated line by line."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from report.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, TURN

Reals = NDArray[np.float64]

DRIVE_GAP: Final = 0.0004
"""Gap of Listing A.8 and of figures 4.1 and 4.2, m."""
PERIOD: Final = TURN / DRIVE_OMEGA
PRINTED_CONTACT, PRINTED_OFFSET = "0.00190662", "0.0049"
"""Lines 8 and 12 of Listing A.8: s, m."""


def friction_listing(amplitude: complex, width: float) -> complex:
    """Return what Listing A.3 returns: its last line overwrites the zeros that its sixth line has set."""
    ratio = np.complex128(1 - width / amplitude)
    real = 0.5 + ratio * np.sqrt(1 - ratio**2) / np.pi + np.arcsin(ratio) / np.pi
    return complex(real - 1j * (1 - ratio**2) / np.pi)


def friction_block(pin: float, gap: float, load: float) -> float:
    """Return what Listing A.7 returns for its arguments e, D_size and u_prev."""
    if pin - load > gap / 2:
        return pin - gap / 2
    if pin - load < -gap / 2:
        return pin + gap / 2
    return load


def inertia_block(pin: Reals, time: Reals, gap: float = DRIVE_GAP) -> Reals:
    """Return what Listing A.8 returns for its arguments u and t, with another gap in its second line."""
    t = np.mod(time, PERIOD)
    contact, offset = float(PRINTED_CONTACT), float(PRINTED_OFFSET)
    flight = DRIVE_OMEGA * DRIVE_AMPLITUDE * t
    second = PERIOD / 2
    return np.asarray(
        (flight - gap / 2) * ((t >= 0) & (t < contact))
        + (pin + gap / 2) * ((t > contact) & (t < second))
        + (-flight + offset) * ((t >= second) & (t < second + contact))
        + (pin - gap / 2) * ((t > second + contact) & (t < PERIOD))
    )
