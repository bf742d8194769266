"""Outputs of a periodic motion: peak to peak and harmonics of the drive."""

from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.motion.course import Course
from trimmer.motion.extremes import extremes
from trimmer.motion.flow import Flow
from trimmer.motion.fourier import fourier
from trimmer.motion.signals import read
from trimmer.showing.shown import Shown

HARMONICS = 15


@dataclass(frozen=True, eq=False, repr=False)
class OutputMeasure(Shown):
    """What an output does over a period, in its unit.

    Attributes:
        advance: Shift over the period, which is taken off evenly before it is measured.
        peak_to_peak: Largest less smallest value.
        harmonics: Amplitudes a_n of a_n cos(n omega t + phase), n = 1 ... 15, omega that of the drive, or of
            the motion without a drive.
        unit: The unit, empty for a number.
    """

    advance: float
    peak_to_peak: float
    harmonics: Reals
    unit: str = "m"

    def _told(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        return f"{self.peak_to_peak:.6g}{unit} peak to peak, {len(self.harmonics)} harmonics"


def output_measures(flow: Flow, course: Course) -> dict[str, OutputMeasure]:
    """Return the measures of all outputs by name.

    Args:
        flow: What moves.
        course: Its motion over a whole number of drive periods, after which it repeats, in the frame that
            advances with it; without a drive over its own period.
    """
    nodes, found = course.nodes, {}
    omega = course.modes.system.layout.omega or 2.0 * np.pi / course.duration
    for name, output in flow.outputs.items():
        lowest, highest = extremes(course, output.signal)
        amplitudes = fourier(course, read(course, [output], nodes.rows, nodes.states), omega, HARMONICS)
        advance = output.speed * course.duration
        found[name] = OutputMeasure(advance, highest - lowest, np.abs(amplitudes[:, 0]), output.unit)
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
    displacements = nodes.states[:, : len(layout.coordinates)]
    mean = nodes.weights @ displacements / course.duration
    waves = fourier(course, displacements, layout.omega / periods, count)
    return np.column_stack([mean, waves.T])
