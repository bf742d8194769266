"""Listings A.7 and A.8, backlash over time, repeated line by line, and the same outputs by other means."""

import math
from typing import Final

import control
import numpy as np
import sympy
from scipy.optimize import brentq

from derivations.elements.backlash import CONTACT, inertia_contact_ratio
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, LISTED_CONTACT, LISTED_OFFSET, TIMED_GAP, TURN
from trimmer import InertiaBacklash
from trimmer.arrays import Reals

PERIOD: Final = TURN / DRIVE_OMEGA
PERIODS, POINTS = 20, 4000
"""Periods, and points of each, over which Listing A.8 and the right waveform are compared."""
SAMPLES: Final = 2003
"""Samples of a period in figures 4.1 to 4.3, none of which is an instant at which Listing A.8 has no line."""
GAPS: Final = (0.0, 2e-4, 4e-4, 8e-4, 16e-4)  # Gaps of our figure 4.3, m; those of the thesis are not given


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


def inertia_block(pin: Reals, time: Reals, gap: float = TIMED_GAP) -> Reals:
    """Return what Listing A.8 returns for its arguments u and t, with another gap in its second line."""
    t = np.mod(time, PERIOD)
    contact, offset = float(LISTED_CONTACT), float(LISTED_OFFSET)
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
    right = InertiaBacklash(TIMED_GAP).waveform(omega * times, DRIVE_AMPLITUDE, omega)
    return float(np.abs(inertia_block_on_a_sine(times, omega) - right).max()) / TIMED_GAP


def contact_angle(gap_over_amplitude: float) -> float:
    """Return the phase of the flight of a load without friction, rad, by the derived contact equation."""
    ratio = sympy.lambdify(CONTACT, inertia_contact_ratio() - gap_over_amplitude)
    return float(brentq(ratio, 0.1, math.pi))


def contact_time() -> float:
    """Return the same for the constants of Listing A.8, s."""
    return contact_angle(TIMED_GAP / DRIVE_AMPLITUDE) / DRIVE_OMEGA


def phases(samples: int = SAMPLES) -> Reals:
    """Return the phases of two periods of the pin, rad."""
    return TURN * np.arange(2 * samples) / samples


def pins(samples: int = SAMPLES) -> Reals:
    """Return the displacements of the pin in two periods of the sine of figure 4.1, m."""
    return np.asarray(DRIVE_AMPLITUDE * np.sin(phases(samples)))


def own_block(samples: int = SAMPLES) -> Reals:
    """Return the output of Listing A.7 for this sine from rest, m."""
    load, outputs = 0.0, []
    for pin in pins(samples):
        load = friction_block(float(pin), TIMED_GAP, load)
        outputs.append(load)
    return np.array(outputs)


def built_in_block(samples: int = SAMPLES) -> Reals:
    """Return the output of python-control's backlash for this sine from rest, m."""
    block = control.friction_backlash_nonlinearity(TIMED_GAP)
    return np.array([block(float(pin)) for pin in pins(samples)])


def listing_a8() -> Reals:
    """Return the output of Listing A.8 for its own drive, m."""
    return inertia_block(pins(), phases() / DRIVE_OMEGA)


def exact_inertia(gap: float) -> Reals:
    """Return the derived waveform of a load without friction, m; the pin itself without gap."""
    return InertiaBacklash(gap).waveform(phases(), DRIVE_AMPLITUDE) if gap else pins()
