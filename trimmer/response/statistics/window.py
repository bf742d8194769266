"""A motion that does not repeat, watched over some drive periods: sums, growth of distances, samples.

Without a drive the mean time of a return stands for its period; rates are per s then.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.motion.course import Course
from trimmer.motion.extremes import extremes
from trimmer.motion.flow import Flow
from trimmer.motion.fourier import fourier
from trimmer.motion.measures import HARMONICS
from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
from trimmer.motion.signals import along, read
from trimmer.response.periodic.pace import pace_of
from trimmer.response.periodic.shooting import sizes_of
from trimmer.response.statistics.estimate import Estimate, mean_of

SAMPLES = 64  # Samples in a drive period, for the spectrum
SEGMENT = 128  # Drive periods of a segment of the spectrum, at most
TOGETHER = 8  # Drive periods that are taken together: a row of each series below
MOST_LINES = 8  # Lines of an output that are looked for whatever they are multiples of
LEAST = 1e-3  # Share of the largest one from which on they count
SEED = 0  # Of the directions of the small distances that are followed
SMALLEST = 1e-16  # Growth of a distance over a row below which it counts as lost


@dataclass(frozen=True, eq=False)
class Watched:
    """What was seen of a motion, in rows of some drive periods each."""

    flow: Flow  # What moves, in the frame that advances evenly with it, if it does
    sizes: Reals  # Scale of each state, (n,)
    begin: Instant  # Where the window begins
    end: Instant  # Where it ends
    ending: Ending  # Why, if it had to
    growth: Reals  # Logarithms of the growth of two distances at right angles, per period, (rows, 2)
    # means, squares: Mean and mean square of each output, (rows, outputs)
    means: Reals
    squares: Reals
    waves: Complexes  # Complex amplitudes of the harmonics, (rows, harmonics, outputs)
    ranges: Reals  # Smallest and largest value of each output, (rows, outputs, 2)
    accelerations: Reals  # Mean square of the acceleration of each body, m²/s⁴, (rows, bodies)
    events: Reals  # Number of events per drive period, (rows,)
    states: Reals  # At the start of each period, (periods, n), shifted so that leaders are at 0
    samples: Reals  # Outputs at equal steps, (steps periods, outputs)
    together: int = TOGETHER  # Drive periods in a row
    steps: int = SAMPLES  # Samples in a drive period
    unit: float = 0.0  # Period of the drive, or what stands for it, s

    @property
    def duration(self) -> float:
        """Its length, s."""
        return self.periods * self.unit

    @property
    def periods(self) -> int:
        """Its length in drive periods."""
        return self.together * len(self.events)

    @cached_property
    def exponents(self) -> tuple[Estimate, ...]:
        """The two largest Lyapunov exponents per drive period; per s without a drive."""
        per = 1.0 if self.flow.period else self.unit
        return tuple(mean_of(series / per) for series in self.growth.T)

    @cached_property
    def rms(self) -> Mapping[str, Estimate]:
        """Root of the mean square of each output about its mean over the window."""
        found = {}
        for place, name in enumerate(self.flow.outputs):
            mean = self.means[:, place].mean()
            square = mean_of(self.squares[:, place] - 2 * mean * self.means[:, place] + mean**2)
            # Of what stands far from zero the difference is rounding.
            found[name] = _root(square, 0.5 * self.peak_to_peak[name])
        return found

    @cached_property
    def output_means(self) -> Mapping[str, Estimate]:
        """Mean of each output."""
        return dict(zip(self.flow.outputs, map(mean_of, self.means.T), strict=True))

    @cached_property
    def advance(self) -> Mapping[str, float]:
        """Shift of each output over a drive period, or in 1 s, without which all else is measured."""
        return {name: each.speed * (self.flow.period or 1.0) for name, each in self.flow.outputs.items()}

    @cached_property
    def harmonics(self) -> Mapping[str, Reals]:
        """Amplitudes of the harmonics of the drive in each output."""
        mean = abs(self.waves.mean(axis=0))
        return {name: mean[:, place] for place, name in enumerate(self.flow.outputs)}

    @cached_property
    def peak_to_peak(self) -> Mapping[str, float]:
        """Largest less smallest value of each output in the window."""
        lowest, highest = self.ranges[..., 0].min(axis=0), self.ranges[..., 1].max(axis=0)
        return dict(zip(self.flow.outputs, (highest - lowest).tolist(), strict=True))

    @cached_property
    def rms_acceleration(self) -> Mapping[str, Estimate]:
        """Root of the mean square of the acceleration of each body, m/s²."""
        found = {}
        for place, name in enumerate(self.flow.accelerations):
            found[name] = _root(mean_of(self.accelerations[:, place]))
        return found

    @property
    def contacts(self) -> Mapping[str, ContactMeasures]:
        """What each part that touches does; the motion is followed once more for it."""
        return self._parts[0]

    @property
    def frictions(self) -> Mapping[str, FrictionMeasures]:
        """What each dry friction does; the motion is followed once more for it."""
        return self._parts[1]

    @cached_property
    def _parts(self) -> tuple[Mapping[str, ContactMeasures], Mapping[str, FrictionMeasures]]:
        flow, together = self.flow, self.together
        rows = [(flow.contacts(row, together), flow.frictions(row, together)) for row in self._rows()]
        contacts, frictions = zip(*rows, strict=True)
        return (
            {name: ContactMeasures.joined([row[name] for row in contacts]) for name in contacts[0]},
            {name: FrictionMeasures.joined([row[name] for row in frictions]) for name in frictions[0]},
        )

    def _rows(self) -> Iterator[Course]:
        instant = self.begin
        for _ in self.events:
            course = _row(self.flow, instant, self.together, self.unit)
            yield course
            instant = course.end

    @cached_property
    def peaks(self) -> Mapping[str, tuple[tuple[float, float], ...]]:
        """Frequency, Hz, and amplitude of the largest lines of each output, of whatever multiples."""
        from trimmer.spectra.peaks import peaks
        from trimmer.spectra.spectrum import amplitude_spectrum

        rate, found = self.steps / self.unit, {}
        for name, series in zip(self.flow.outputs, self.samples.T, strict=True):
            lines = peaks(amplitude_spectrum(series, rate), MOST_LINES, LEAST) if np.ptp(series) else ()
            found[name] = tuple((line.frequency, line.amplitude) for line in lines)
        return found

    @cached_property
    def combinations(self) -> Mapping[str, tuple[float | None, tuple[tuple[int, int] | None, ...]]]:
        """Of each output a second frequency, Hz, and of which sum of the two each of its peaks is the line.

        The first one is that of the drive; None where all are multiples of it, for what is no sum, and
        without a drive, where samples of a controller are all that comes evenly.
        """
        from trimmer.response.statistics.combinations import sums_of

        if not self.flow.period or pace_of(self.flow.subject) > 1:
            return {name: (None, (None,) * len(peaks)) for name, peaks in self.peaks.items()}
        drive, width = 1 / self.unit, 1 / self.duration
        return {name: sums_of(peaks, drive, width) for name, peaks in self.peaks.items()}

    @cached_property
    def spectrum(self) -> tuple[Reals, Mapping[str, Reals]]:
        """Frequencies, Hz, and power density of each output by Welch's method (Hann, half over)."""
        from scipy.signal import welch

        rate = self.steps / self.unit
        length = self.steps * min(SEGMENT * self.together // TOGETHER, self.periods)
        _, density = welch(self.samples, rate, nperseg=length, axis=0)
        outputs = self.flow.outputs
        # Those of ``welch``, which gives none without outputs.
        frequencies = np.asarray(rate * np.fft.rfftfreq(length), dtype=np.float64)
        return frequencies, {name: density[:, place] for place, name in enumerate(outputs)}


def watch(flow: Flow, instant: Instant, periods: int, unit: float = 0.0) -> Watched | None:
    """Follow a motion over a window of drive periods, rounded up to whole rows; None if it ends at once.

    Args:
        flow: What moves.
        instant: Where it is.
        periods: Number of periods.
        unit: What stands for one without a drive, s.
    """
    followed = flow.watched(instant, periods) if flow.period else flow
    return _Window(followed, instant, pace_of(flow.subject), unit).over(periods)


def joined(first: Watched, second: Watched) -> Watched:
    """Return two windows, one after the other, as one."""
    series = ("growth", "means", "squares", "waves", "ranges", "accelerations", "events", "states", "samples")
    both: dict[str, Any] = {
        name: np.concatenate([getattr(first, name), getattr(second, name)]) for name in series
    }
    return replace(first, end=second.end, ending=second.ending, **both)


def _root(square: Estimate, most: float = math.inf) -> Estimate:
    """Return the root of a mean square, which is known to be at most so large."""
    root = min(math.sqrt(max(square.value, 0.0)), most)
    return Estimate(root, min(square.uncertainty / (2 * root), most) if root else 0.0)


def _row(flow: Flow, instant: Instant, together: int, unit: float) -> Course:
    """Return the motion over some periods, or over as many units without a drive."""
    return flow.course(instant, together) if flow.period else flow.timed(instant, together * unit)


class _Window:
    def __init__(self, flow: Flow, instant: Instant, pace: int, unit: float) -> None:
        self.flow, self.instant, self.unit = flow, instant, flow.period or unit
        self.together, self.steps = TOGETHER * pace, max(SAMPLES // pace, 2)
        # Those of samples say little of what moves, and without a drive there are none.
        self.harmonics = (HARMONICS if pace == 1 else 1) if flow.period else 0
        self.outputs = flow.outputs.values()
        self.sizes = np.ones(flow.size)
        directions = np.random.default_rng(SEED).normal(size=(2, flow.size))
        self.distances = np.linalg.qr(flow.reduced(directions).T)[0]
        self.seen: list[tuple[Any, ...]] = []

    def over(self, periods: int) -> Watched | None:
        begin, ending = self.instant, Ending.REACHED_END
        for row in range(-(-periods // self.together)):
            course = _row(self.flow, self.instant, self.together, self.unit)
            ending = course.ending
            if ending is not Ending.REACHED_END:
                break
            if row == 0:
                self.sizes = sizes_of(course)
            self.seen.append(self._of(course))
            self.instant = course.end
        if not self.seen:
            return None
        *columns, states, samples = zip(*self.seen, strict=True)
        series = [*map(np.array, columns), np.concatenate(states), np.concatenate(samples)]
        found = Watched(self.flow, self.sizes, begin, self.instant, ending, *series)  # type: ignore[arg-type]
        return replace(found, together=self.together, steps=self.steps, unit=self.unit)

    def _of(self, course: Course) -> tuple[Any, ...]:
        nodes, duration = course.nodes, course.duration
        signals = read(course, self.outputs, nodes.rows, nodes.states)
        accelerations = [
            nodes.weights @ along(course, signal, nodes.rows, nodes.states) ** 2 / duration
            for signal in self.flow.accelerations.values()
        ]
        count = self.steps * self.together
        rows, sampled = course.at(course.duration * np.arange(count) / count)
        return (
            self._growth(course),
            nodes.weights @ signals / duration,
            nodes.weights @ signals**2 / duration,
            fourier(course, signals, 2 * np.pi * self.together / duration, self.harmonics),
            np.array([extremes(course, each.signal) for each in self.outputs]).reshape(-1, 2),
            np.array(accelerations),
            np.array(len(course.events) / self.together),
            self.flow.reduced(sampled[:: self.steps, : self.flow.size]),
            read(course, self.outputs, rows, sampled),
        )

    def _growth(self, course: Course) -> Reals:
        at_end = self.flow.reduced(course.tangents(self.sizes[:, None] * self.distances).T).T
        at_end /= self.sizes[:, None]
        self.distances, triangle = np.linalg.qr(at_end)
        return np.asarray(np.log(np.maximum(abs(np.diagonal(triangle)), SMALLEST)) / self.together)
