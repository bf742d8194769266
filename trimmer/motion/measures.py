"""What outputs, bodies, contacts and frictions do over a motion: integrals and extremes exact to rounding."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.hybrid.system import NOTHING
from trimmer.kept_property import cached_property
from trimmer.motion.course import Course
from trimmer.motion.extremes import extremes
from trimmer.motion.flow import Flow
from trimmer.motion.fourier import fourier
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.motion.signals import along, read

HARMONICS = 20  # Number of harmonics of the drive that are given


@dataclass(frozen=True, eq=False)
class OutputMeasures:
    """What an output does, in its unit.

    Attributes:
        smallest, largest: Its extremes.
        mean: Mean over the motion.
        rms: Root of the mean square about the mean.
        amplitudes: Complex amplitudes at p/k of the drive, p = 1, 2, ...: real part of c exp(i p w t / k).
        period_count: k.
        advance: Shift over the motion, which was taken off evenly before all this was measured.
    """

    smallest: float
    largest: float
    mean: float
    rms: float
    amplitudes: Complexes
    period_count: int
    advance: float = 0.0

    @property
    def peak_to_peak(self) -> float:
        """Largest less smallest."""
        return self.largest - self.smallest

    @property
    def harmonics(self) -> Reals:
        """Amplitudes a_n of a_n cos(n w t + phase) at the multiples of the drive, n = 1, 2, ..."""
        return np.abs(self.amplitudes[self.period_count - 1 :: self.period_count])

    @property
    def phases(self) -> Reals:
        """Their phases, rad."""
        return np.angle(self.amplitudes[self.period_count - 1 :: self.period_count])

    @property
    def subharmonics(self) -> Reals:
        """Amplitudes at 1/k ... (k-1)/k of the drive."""
        return np.abs(self.amplitudes[: self.period_count - 1])

    @property
    def lines(self) -> list[tuple[int, int, float]]:
        """p, k and amplitude of all lines at p/k of the drive."""
        sizes = np.abs(self.amplitudes).tolist()
        return [(place + 1, self.period_count, size) for place, size in enumerate(sizes)]


@dataclass(frozen=True, eq=False)
class Measures:
    """Measures of a motion, each computed when it is asked for.

    Attributes:
        course: The motion, over whole drive periods, or without a drive over one period of its own.
        flow: What moves.
        period_count: Number k of drive periods after which it returns; 1 for a window of one that does not.
        periods: Number of drive periods it spans.
        still: Whether nothing moves in it, so that sizes are rounding, and told as 0.
    """

    course: Course
    flow: Flow
    period_count: int
    periods: int
    still: bool = False

    @cached_property
    def outputs(self) -> Mapping[str, OutputMeasures]:
        """Of each output."""
        outputs = self.flow.outputs
        if not outputs:
            return {}
        nodes, duration = self.course.nodes, self.course.duration
        signals = read(self.course, outputs.values(), nodes.rows, nodes.states)
        means = nodes.weights @ signals / duration
        apart = signals - means
        rms = np.sqrt(nodes.weights @ apart**2 / duration)
        count = self.period_count
        omega = 2 * np.pi * self.periods / (duration * count)
        amplitudes = fourier(self.course, apart, omega, HARMONICS * count)
        moves = np.array([largest > smallest for smallest, largest in self._ranges.values()])
        return {
            name: OutputMeasures(
                *self._ranges[name],
                float(means[place]),
                float(rms[place] * moves[place]),
                amplitudes[:, place] * moves[place],
                count,
                output.speed * duration,
            )
            for place, (name, output) in enumerate(outputs.items())
        }

    @property
    def peak_to_peak(self) -> Mapping[str, float]:
        """Of each output, without the rest of its measures."""
        return {name: largest - smallest for name, (smallest, largest) in self._ranges.items()}

    @cached_property
    def _ranges(self) -> Mapping[str, tuple[float, float]]:
        found = {name: extremes(self.course, each.signal) for name, each in self.flow.outputs.items()}
        return {name: (low, low) for name, (low, _) in found.items()} if self.still else found

    @cached_property
    def rms_acceleration(self) -> Mapping[str, float]:
        """Of each body, m/s²; the acceleration jumps where the force of a contact or a friction does."""
        nodes, signals = self.course.nodes, self.flow.accelerations
        if self.still:
            return dict.fromkeys(signals, 0.0)
        values = {name: along(self.course, each, nodes.rows, nodes.states) for name, each in signals.items()}
        return {
            name: float(np.sqrt(nodes.weights @ a**2 / self.course.duration)) for name, a in values.items()
        }

    @cached_property
    def contacts(self) -> Mapping[str, ContactMeasures]:
        """Of each part that touches."""
        return self.flow.contacts(self.course, self.periods)

    @cached_property
    def frictions(self) -> Mapping[str, FrictionMeasures]:
        """Of each dry friction."""
        found = self.flow.frictions(self.course, self.periods)
        still = {name: replace(each, work=0.0, power=0.0) for name, each in found.items()}
        return still if self.still else found

    @property
    def events_per_period(self) -> float:
        """Number of events per drive period, the mean."""
        return int((self.course.log.kind != NOTHING).sum()) / self.periods
