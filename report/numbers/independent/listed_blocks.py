"""Listings A.7 and A.8, backlash over time, repeated line by line for any input."""

from __future__ import annotations

import math

import control
import numpy as np
import sympy
from scipy.optimize import brentq

from derivations.elements.backlash import CONTACT, inertia_contact_ratio
from report.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, TURN
from trimmer.arrays import Reals
from trimmer.elements.inertia_backlash import InertiaBacklash

DRIVE_GAP = 0.0004
"""Gap of Listing A.8, m."""
PERIOD = TURN / DRIVE_OMEGA
PRINTED_CONTACT, PRINTED_OFFSET = "0.00190662", "0.0049"
"""Constants of Listing A.8: time of contact, s, and offset of line 12, m."""
PERIODS, POINTS = 20, 4000
"""Periods, and points of each, over which block and waveform are compared."""


def friction_block(pin: float, gap: float, load: float) -> float:
    """Return what Listing A.7 returns for its arguments e, D_size and u_prev."""
    if pin - load > gap / 2:
        return pin - gap / 2
    if pin - load < -gap / 2:
        return pin + gap / 2
    return load


def friction_by_python_control(pin: float, gap: float, load: float) -> float:
    """Return what python-control's backlash returns for a pin, from where its load has been, m."""
    block = control.friction_backlash_nonlinearity(gap)
    block.center = load
    return float(block(pin))


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


def inertia_block_on_a_sine(time: Reals, omega: float = DRIVE_OMEGA) -> Reals:
    """Return the output of Listing A.8, m, for a sine of its own amplitude and, unless given, frequency."""
    return inertia_block(np.asarray(DRIVE_AMPLITUDE * np.sin(omega * time)), time)


def inertia_difference(frequency: float) -> float:
    """Return the largest difference of Listing A.8's output and the right one, over the gap.

    ``frequency`` is that of the block's input, Hz; the listing has its own in its lines 4 to 6.
    """
    times = np.asarray((np.arange(PERIODS * POINTS) + 0.5) / (POINTS * frequency), dtype=np.float64)
    omega = TURN * frequency
    right = InertiaBacklash(DRIVE_GAP).waveform(omega * times, DRIVE_AMPLITUDE, omega)
    return float(np.abs(inertia_block_on_a_sine(times, omega) - right).max()) / DRIVE_GAP


def contact_time() -> float:
    """Return the time from the pin's largest velocity to the impact, for the constants of Listing A.8, s."""
    ratio = sympy.lambdify(CONTACT, inertia_contact_ratio() - DRIVE_GAP / DRIVE_AMPLITUDE)
    return float(brentq(ratio, 0.1, math.pi, xtol=1e-14)) / DRIVE_OMEGA


def contact_angle(gap_over_amplitude: float) -> float:
    """Return the contact angle by bisection of b/A = phi - sin(phi), rad."""
    low, high = 0.0, math.pi
    for _ in range(60):
        middle = (low + high) / 2
        ratio = middle - math.sin(middle)
        low, high = (middle, high) if ratio < gap_over_amplitude else (low, middle)
    return low
