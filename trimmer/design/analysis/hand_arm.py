"""Vibration of what a hand holds, weighted by W_h of ISO 5349-1, as exposure to vibration along one axis.

An impulse of a wall changes a velocity at once. Its acceleration has no mean square, but lines as any other
has, of one size at all frequencies. Weighted they fall.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import quad

from trimmer.arrays import Complexes, Reals
from trimmer.contact.readouts.impacts import speeds_given
from trimmer.motion.course import Course
from trimmer.motion.fourier import fourier

BAND = 10**0.8, 10**3.1  # Corner frequencies of the band limitation f1 and f2, Hz: 6.310 and 1258.9
BAND_QUALITY = 2**-0.5
TRANSITION = 100 / (2 * np.pi)
"""Frequency f3 = f4 of the transition from acceleration to velocity, Hz: 15.915."""
TRANSITION_QUALITY = 0.64
HIGHEST = 3000.0  # Frequency up to which lines are summed, Hz; there the weighting is below a thousandth
MOST_LINES = 1500
DAY = 8.0  # Hours to which a daily exposure A(8) is referred: directive 2002/44/EC, article 3


def hand_arm_weighting(frequency: ArrayLike) -> Complexes:
    """Return the weighting W_h of hand-arm vibration: response to an acceleration, without unit.

    The band limitation is H_b = s² w2² / ((s² + w1 s/Q + w1²)(s² + w2 s/Q + w2²)), the transition
    H_w = (1 + s/w3) / (1 + s/(Q w4) + (s/w4)²).

    Args:
        frequency: Hz, any shape.

    Source: ISO 5349-1:2001, annex A, with the exact parameters of ISO 8041-1:2017, table 1.
    """
    s = 2j * np.pi * np.asarray(frequency, dtype=float)
    first, second = (2 * np.pi * each for each in BAND)
    high_pass = s**2 / (s**2 + first * s / BAND_QUALITY + first**2)
    low_pass = second**2 / (s**2 + second * s / BAND_QUALITY + second**2)
    scaled = s / (2 * np.pi * TRANSITION)
    return np.asarray(high_pass * low_pass * (1 + scaled) / (1 + scaled / TRANSITION_QUALITY + scaled**2))


@dataclass(frozen=True)
class HandArm:
    """The vibration of a body along the modelled axis, as a hand would feel it.

    Attributes:
        weighted: Root of the mean square of the acceleration weighted by W_h, m/s².
        rms: The same without weighting and without the impulses of walls, m/s².
        left_out: Bound on what the frequencies that were left out add to ``weighted``, m/s².
        highest: Frequency up to which it was summed, Hz.
        lines: How many lines were summed; 0 where samples were weighted, as the motion does not repeat.
        frequency, amplitude: The spectrum of the acceleration without weighting, Hz and m/s², (n,) each.
    """

    weighted: float
    rms: float
    left_out: float
    highest: float
    lines: int
    frequency: Reals = field(default_factory=lambda: np.empty(0), compare=False)
    amplitude: Reals = field(default_factory=lambda: np.empty(0), compare=False)

    def hours_to(self, daily: float) -> float:
        """Return the hours a day after which this axis alone reaches a daily exposure A(8), m/s²."""
        return DAY * (daily / self.weighted) ** 2 if self.weighted > 0 else float("inf")


def hand_arm_of_orbit(course: Course, omega: float, rms: Mapping[str, float]) -> Mapping[str, HandArm]:
    """Weight the vibration of each body over a period, line by line, exact to rounding; rms is in m/s²."""
    layout = course.modes.system.layout
    count = min(int(np.ceil(2 * np.pi * HIGHEST / omega)), MOST_LINES)
    weights_of = np.array([layout.weights(name) for name in layout.shaken])
    displacements = course.nodes.states[:, : len(layout.coordinates)] @ weights_of.T
    mean = course.nodes.weights @ displacements / course.duration
    orders = np.arange(1, count + 1)
    frequency = np.asarray(orders * omega / (2 * np.pi), dtype=np.float64)
    waves: Complexes = -fourier(course, displacements - mean, omega, count) * (orders * omega)[:, None] ** 2
    times, given = speeds_given(course, weights_of)
    impulses = 2 / course.duration * np.exp(-1j * omega * np.outer(orders, times)) @ given
    largest_impulses = 2 / course.duration * abs(given).sum(axis=0)
    weights = abs(hand_arm_weighting(frequency))
    beyond, all_beyond = _weights_beyond(frequency[-1].item(), frequency[0].item())
    found = {}
    for body, name in enumerate(layout.shaken):
        lines: Reals = np.abs(waves[:, body])
        rest = max(rms[name] ** 2 - 0.5 * float((abs(waves - impulses)[:, body] ** 2).sum()), 0.0)
        weighted = float(np.sqrt(0.5 * weights**2 @ lines**2))
        above = beyond * np.sqrt(rest) + all_beyond * largest_impulses[body] * 0.5**0.5
        left_out = float(np.hypot(weighted, above)) - weighted
        found[name] = HandArm(weighted, rms[name], left_out, frequency[-1].item(), count, frequency, lines)
    return found


def _weights_beyond(highest: float, spacing: float) -> tuple[float, float]:
    """Return bounds on the largest weighting above a frequency, Hz, and on the root of the sum of squares.

    It rises up to about 12 Hz, and then falls: a sum over lines is at most its integral and its largest.
    """
    largest = float(abs(hand_arm_weighting(np.maximum(np.geomspace(1.0, 100.0, 400), highest))).max())
    integral, _ = quad(lambda frequency: abs(hand_arm_weighting(frequency)) ** 2, highest, np.inf, limit=200)
    return largest, float(np.sqrt(largest**2 + integral / spacing))


def hand_arm_of_samples(course: Course, rms: Mapping[str, float], rate: float) -> Mapping[str, HandArm]:
    """Weight the vibration of each body over a window of what does not repeat; rms is in m/s², rate in Hz.

    The window of Hann takes velocities to accelerations, -∫ v (w exp(-i ω t))' dt, so that impulses count.
    """
    layout, count = course.modes.system.layout, int(course.duration * rate)
    part = (np.arange(count) + 0.5) / count
    taper, slope = np.sin(np.pi * part) ** 2, np.pi / course.duration * np.sin(2 * np.pi * part)
    speeds = course.states(course.duration * part)[:, course.modes.system.machine.velocities]
    gained = (course.end.state - course.begin.state)[course.modes.system.machine.velocities]
    speeds = speeds - speeds.mean(axis=0) - np.outer(part - 0.5, gained)
    frequency = np.asarray(np.fft.rfftfreq(count, course.duration / count), dtype=np.float64)
    weights, near = abs(hand_arm_weighting(frequency)), frequency <= HIGHEST
    found = {}
    for name in layout.shaken:
        speed = speeds @ layout.weights(name)
        waves = 2j * np.pi * frequency * np.fft.rfft(speed * taper) - np.fft.rfft(speed * slope)
        lines = np.asarray(abs(waves), dtype=np.float64)
        weighted = float(np.sqrt(2 * weights**2 @ lines**2 / (count * (taper @ taper))))
        sizes = 2 * lines[near] / taper.sum()
        found[name] = HandArm(weighted, rms[name], float("nan"), rate / 2, 0, frequency[near], sizes)
    return found
