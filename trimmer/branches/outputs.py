"""Outputs of a periodic motion: peak to peak and harmonics of the drive."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.response.extremes import extremes
from trimmer.response.fourier import fourier
from trimmer.response.motion_signals import output_rows, output_speeds, steady
from trimmer.showing.shown import Shown

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.contact.flow import Course
    from trimmer.mechanism.mechanism import Mechanism

HARMONICS = 15


@dataclass(frozen=True, eq=False, repr=False)
class OutputMeasure(Shown):
    """What a displacement does over a period.

    Attributes:
        advance: Shift over the period, m, which is taken off evenly before it is measured.
        peak_to_peak: m.
        harmonics: Amplitudes a_n, m, of a_n cos(n omega t + phase), n = 1 ... 15, omega that of the drive, or
            of the motion without a drive.
    """

    advance: float
    peak_to_peak: float
    harmonics: Reals

    def _told(self) -> str:
        return f"{self.peak_to_peak:.6g} m peak to peak, {len(self.harmonics)} harmonics"


def output_measures(mechanism: Mechanism, course: Course) -> dict[str, OutputMeasure]:
    """Return the measures of all outputs by name.

    Args:
        mechanism: The mechanism.
        course: Its motion over a whole number of drive periods, after which it repeats, in the frame that
            advances with it; without a drive over its own period.
    """
    layout, found = course.modes.system.layout, {}
    speeds = output_speeds(mechanism, layout)
    omega = layout.omega or 2.0 * np.pi / course.duration
    for name, row in output_rows(mechanism, layout).items():
        lowest, highest = extremes(course, steady(row))
        amplitudes = fourier(course, (course.nodes.states @ row)[:, None], omega, HARMONICS)
        advance = speeds[name] * course.duration
        found[name] = OutputMeasure(advance, highest - lowest, np.abs(amplitudes[:, 0]))
    return found


def body_coefficients(course: Course, periods: int, count: int) -> Complexes:
    """Return c_n, n = 0 ... count, of the displacements Re Σ c_n exp(i n omega t / periods) of the bodies.

    Args:
        course: The motion over a number of drive periods, after which it repeats.
        periods: That number.
        count: Number of multiples.

    Returns:
        Coefficients, m, shape (bodies, count + 1).
    """
    layout, nodes = course.modes.system.layout, course.nodes
    displacements = nodes.states[:, : len(layout.bodies)]
    mean = nodes.weights @ displacements / course.duration
    waves = fourier(course, displacements, layout.omega / periods, count)
    return np.column_stack([mean, waves.T])
