"""The result of a fit: numbers with their intervals, and how well they explain the measurement."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np

from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Tabular, counted
from trimmer.showing.table import Table, attributes

if TYPE_CHECKING:
    from trimmer.arrays import Complexes, Reals
    from trimmer.fitting.judgement import Judgement
    from trimmer.fitting.measured import MeasuredLines
    from trimmer.fitting.search import FitSearch
    from trimmer.fitting.weak import WeakDirection
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.motion.subject import Subject
    from trimmer.response.periodic.orbit import Orbit


@dataclass(frozen=True)
class FittedNumber:
    """A number with its interval.

    Attributes:
        place: Its dotted place.
        unit: SI unit.
        before: What it was.
        value: What it is after the fit.
        lower, upper: Ends of its interval of 95 %; None where it is open.
        lowest, highest: How far the profile was followed to either side and still fitted.
        lower_note, upper_note: Why an end is open, without a full stop; empty where it is not.
    """

    place: str
    unit: str
    before: float
    value: float
    lower: float | None
    upper: float | None
    lowest: float
    highest: float
    lower_note: str = ""
    upper_note: str = ""

    @property
    def sentences(self) -> Iterator[str]:
        """Why the interval is open, if it is."""
        for note in (self.lower_note, self.upper_note):
            if note:
                yield f"{self.place}: {note}"


@dataclass(frozen=True, eq=False, repr=False)
class Fit(Tabular, Drawn):
    """Numbers of a mechanism or a loop fitted to a measured motion.

    ``plot`` draws the first output over a period: averaged measurement and simulation.

    Attributes:
        subject: The mechanism or loop with the fitted numbers, driven at the measured frequency.
        before: The same as it was.
        numbers: The fitted numbers.
        confidence: Probability with which an interval holds the true number, if what moves is right.
        measured: The lines of the measurement.
        simulated: Those of the fitted motion, shifted in time so that both agree best, (m, outputs).
        shift: By how much later a drive period of the simulation begins than the measurement, s.
        orbit: The fitted motion.
        searched: What the starts came to.
        judgement: How well it explains the measurement.
        weak: What the measurement cannot tell apart.
        notes: What else is to be said, in sentences without full stops.
    """

    subject: Subject
    before: Subject
    numbers: tuple[FittedNumber, ...]
    confidence: float
    measured: MeasuredLines
    simulated: Complexes
    shift: float
    orbit: Orbit
    searched: FitSearch
    judgement: Judgement
    weak: tuple[WeakDirection, ...]
    notes: tuple[str, ...]

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism with the fitted numbers, if it is one that was fitted."""
        return cast("Mechanism", self.subject)

    @property
    def period(self) -> float:
        """Time after which the fitted motion repeats, s."""
        return self.measured.period_count / self.measured.frequency

    @property
    def agreement(self) -> str:
        """What the starts came to, as a sentence without a full stop."""
        searched = self.searched
        if not searched.agreeing:
            return "no start came to this fit, which was met on the way to an interval: try more (--starts)"
        if searched.starts == 1:
            return "one start alone was tried, so a better fit elsewhere is not excluded (--starts)"
        told = f"{searched.agreeing} of {searched.starts} starts came to this fit"
        if searched.elsewhere:
            told += (
                f", {len(searched.elsewhere)} to worse ones (chi-square {searched.elsewhere[0]:.4g} or more "
                f"against {self.judgement.chi_square:.4g})"
            )
        if searched.lost:
            told += f", and {searched.lost} began where the motion does not repeat as the measured one does"
        return told

    def waveforms(self, output: str, points: int = 400) -> tuple[Reals, Reals, Reals]:
        """Return times, s, and the lines of both added up over a period, each (points,)."""
        place = self.measured.outputs.index(output)
        times = np.asarray(np.arange(points) * (self.period / points))
        turned = np.exp(2j * np.pi * np.outer(self.measured.frequencies, times))
        lines = self.measured.lines[:, place], self.simulated[:, place]
        return times, (lines[0] @ turned).real, (lines[1] @ turned).real

    def _told(self) -> str:
        return f"{counted(len(self.numbers), 'number')}, {self.judgement.sentences[0]}"

    def _table(self) -> Table:
        columns = attributes(place="", unit="", before="", value="", lower="", upper="")
        return Table("Fitted numbers, in their units", self.numbers, columns)
