"""What a mechanism or a loop settles to: the motions that were found, and what is known of each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np

from trimmer.choices import Choice
from trimmer.kept_property import cached_property
from trimmer.response.flows import flow_of
from trimmer.response.statistics.estimate import Estimate
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Shown, Tabular
from trimmer.showing.table import Column, Table, attributes

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from trimmer.arrays import Reals
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.motion.measures import Measures
    from trimmer.motion.part_measures import ContactMeasures, FrictionMeasures
    from trimmer.motion.subject import Subject
    from trimmer.response.periodic.orbit import Orbit
    from trimmer.response.statistics.window import Watched
    from trimmer.response.without_events.linear_lines import LinearLines
    from trimmer.response.without_events.linear_motion import LinearMotion
    from trimmer.response.without_events.rest import Rest


class MotionKind(Choice):
    """What a motion is, as far as the numbers carry it."""

    PERIODIC = "it repeats"
    REST = "it comes to rest"
    TORUS = "it runs on a torus"
    CHAOTIC = "it is chaotic"
    DIVERGING = "it grows without bound"
    UNDECIDED = "it is undecided"

    def described(self, period_count: int | None) -> str:
        """Return what a motion is, in few words, such as ``period 3`` or ``not settled``."""
        match self:
            case MotionKind.PERIODIC:
                return f"period {period_count}"
            case MotionKind.UNDECIDED:
                return "not settled"
            case _:
                return self.word


@dataclass(frozen=True)
class Swings:
    """How far a motion swung that came again, but was not followed until it repeats.

    Attributes:
        since: From when on, s.
        times: How often it came again since then.
        peak_to_peak: Largest less smallest value of each output at its events, in the unit of the output.
    """

    since: float
    times: int
    peak_to_peak: Mapping[str, float]


@dataclass(frozen=True)
class SlowingDown:
    """How a motion slows down for ever.

    Attributes:
        returns: Number of its last returns by which that was seen.
        least: By what factor each of these takes longer than that before, the least one.
        largest: The largest one.
        last: How long the last return takes, s.
    """

    returns: int
    least: float
    largest: float
    last: float


@dataclass(frozen=True, eq=False, repr=False)
class SettledMotion(Shown):
    """A motion that one or several starts settle to.

    Attributes:
        kind: What it is.
        orbit: The exact orbit, if it repeats.
        window: What was seen of it, if it does not repeat.
        drive_periods: Number of drive periods that were followed until this was known, the window included.
        neighbour_agrees: Whether a neighbouring start was found to do the same; None if none was tried.
        message: What it is, in sentences.
        rest: Where it rests, with the forces of all parts, if it comes to rest.
        linear: It in closed form, if no event comes any more.
        starts: How many starts settle to it.
        share: Their share of all starts.
        mirrored: Whether it is the mirror image of the motion before it in the list.
        swings: How far it swung, if it took more steps than are followed.
        slowing: How it slows down for ever, if it does.
    """

    kind: MotionKind
    orbit: Orbit | None
    window: Watched | None
    drive_periods: int
    neighbour_agrees: bool | None
    message: str
    rest: Rest | None = None
    linear: LinearMotion | None = None
    starts: int = 1
    share: float = 1.0
    mirrored: bool = False
    swings: Swings | None = None
    slowing: SlowingDown | None = None

    @property
    def period_count(self) -> int | None:
        """Number of drive periods after which it repeats; None if it does not."""
        return None if self.orbit is None else self.orbit.period_count

    @cached_property
    def lyapunov(self) -> Estimate | None:
        """Largest Lyapunov exponent per drive period, per s without a drive.

        None where no distance is left, and of an orbit without a drive.
        """
        if self._lines is not None and self._lines.motion.flow.period:
            return Estimate(0.0, 0.0)
        if self.window is not None:
            return self.window.exponents[0]
        if self.orbit is None or not self.orbit.periods:
            return None
        largest = float(abs(self.orbit.nontrivial_multipliers).max(initial=0.0))
        return Estimate(float(np.log(largest)) / self.orbit.periods, 0.0) if largest > 0 else None

    @property
    def events_per_period(self) -> float | None:
        """Number of events per drive period, the mean; None if the motion could not be followed."""
        if self.orbit is not None:
            return self.orbit.events_per_period
        if self.linear is not None or self.rest is not None:
            return 0.0
        return None if self.window is None else float(self.window.events.mean())

    @cached_property
    def rms(self) -> Mapping[str, Estimate]:
        """Root of the mean square of each output about its mean; exact if it repeats."""
        if self.measures is not None:
            return {name: Estimate(each.rms, 0.0) for name, each in self.measures.outputs.items()}
        if self._lines is not None:
            return {name: Estimate(value, 0.0) for name, value in self._lines.rms.items()}
        return {} if self.window is None else self.window.rms

    @cached_property
    def peak_to_peak(self) -> Mapping[str, float]:
        """Largest less smallest value of each output; in the window if it does not repeat."""
        if self.measures is not None:
            return {name: each.peak_to_peak for name, each in self.measures.outputs.items()}
        if self._lines is not None:
            return self._lines.peak_to_peak
        return {} if self.window is None else self.window.peak_to_peak

    @cached_property
    def mean(self) -> Mapping[str, float]:
        """Mean of each output, less what it advances by; over the window if it does not repeat."""
        if self.measures is not None:
            return {name: each.mean for name, each in self.measures.outputs.items()}
        if self._lines is not None:
            return self._lines.mean
        means = {} if self.window is None else self.window.output_means
        return {name: each.value for name, each in means.items()}

    @cached_property
    def advance(self) -> Mapping[str, float]:
        """Shift of each output over a period of the motion; if it does not repeat, over a drive period.

        Without a drive that is the shift in a second.
        """
        if self.measures is not None:
            return {name: each.advance for name, each in self.measures.outputs.items()}
        if self._lines is not None:
            return self._lines.advance
        return {} if self.window is None else self.window.advance

    @cached_property
    def harmonics(self) -> Mapping[str, Reals]:
        """Amplitudes of each output at the harmonics of the drive."""
        if self.measures is not None:
            return {name: each.harmonics for name, each in self.measures.outputs.items()}
        if self._lines is not None:
            return self._lines.harmonics
        return {} if self.window is None else self.window.harmonics

    @cached_property
    def rms_acceleration(self) -> Mapping[str, Estimate]:
        """Root of the mean square of the acceleration of each body, m/s²; exact if it repeats."""
        if self.rest is not None:
            return dict.fromkeys(self.rest.flow.accelerations, Estimate(0.0, 0.0))
        found = self.measures or self._lines
        if found is not None:
            return {name: Estimate(value, 0.0) for name, value in found.rms_acceleration.items()}
        return {} if self.window is None else self.window.rms_acceleration

    @property
    def measures(self) -> Measures | None:
        """What outputs, bodies, contacts and frictions do, if it repeats or rests; else None."""
        still = self.orbit or self.rest
        return None if still is None else still.measures

    @property
    def contacts(self) -> Mapping[str, ContactMeasures]:
        """What each part that touches does; in the window if it does not repeat, none without events."""
        found = self.measures or self.window
        return {} if found is None else found.contacts

    @property
    def frictions(self) -> Mapping[str, FrictionMeasures]:
        """What each dry friction does; in the window if it does not repeat, none without events."""
        found = self.measures or self.window
        return {} if found is None else found.frictions

    @cached_property
    def _lines(self) -> LinearLines | None:
        """Exact measures of a linear motion that does not repeat."""
        if self.linear is None or self.measures is not None:
            return None
        from trimmer.response.without_events.linear_lines import LinearLines

        return LinearLines(self.linear)

    def _told(self) -> str:
        return self.message


@dataclass(frozen=True, eq=False, repr=False)
class Response(Tabular, Drawn):
    """What a mechanism or a loop settles to.

    ``plot`` draws the motion of the first start over time, with contact and stick marked; of one that does
    not repeat some periods.

    Attributes:
        subject: What moves.
        motions: The motions found; the first one is that of the first start.
        starts: Number of starts.
        box: Largest displacement, m, and velocity, m/s, of each body in the starts beside the first one; of a
            loop the largest modulus of each state.
        seed: Of the random starts.
    """

    subject: Subject
    motions: tuple[SettledMotion, ...]
    starts: int
    box: Mapping[str, tuple[float, ...]]
    seed: int

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism, if it is one that moves."""
        return cast("Mechanism", self.subject)

    @property
    def motion(self) -> SettledMotion:
        """The motion of the first start."""
        return self.motions[0]

    @property
    def units(self) -> Mapping[str, str]:
        """Unit of each output, empty for a number."""
        return {name: each.unit for name, each in flow_of(self.subject).outputs.items()}

    @property
    def kind(self) -> MotionKind:
        """What the first start settles to."""
        return self.motion.kind

    @property
    def period_count(self) -> int | None:
        """Number of drive periods after which it repeats; None if it does not."""
        return self.motion.period_count

    @property
    def success(self) -> bool:
        """Whether it is known what the first start settles to."""
        return self.kind is not MotionKind.UNDECIDED

    @property
    def message(self) -> str:
        """What the first start settles to, and how many motions were found."""
        return " ".join([self.motion.message, *self._others()])

    def _told(self) -> str:
        return f"{self.subject.title}: {self.message}"

    def _table(self) -> Table:
        outputs = (
            Column(f"outputs.{name}.peak_to_peak", unit, _stroke(name)) for name, unit in self.units.items()
        )
        columns = (*attributes(kind="", period_count="", share="", mirrored="", drive_periods=""), *outputs)
        return Table("Motions that were found", self.motions, columns)

    def _others(self) -> list[str]:
        if self.starts == 1:
            return []
        if len(self.motions) == 1:
            return [_all_of_them(self.motion, self.starts)]
        return [
            f"{self.starts} starts settle to {len(self.motions)} motions; "
            f"{self.motion.share:.0%} of them to this one."
        ]


def _all_of_them(motion: SettledMotion, starts: int) -> str:
    """Say that several starts lead to one motion, and how that is meant."""
    if motion.rest is not None:
        return f"All {starts} starts come to rest{' so' if motion.rest.family else ' there'}."
    if motion.window is not None:
        return f"All {starts} starts lead to motions that agree in their measures, within their errors."
    if motion.kind in (MotionKind.UNDECIDED, MotionKind.DIVERGING):
        return f"So it is with all {starts} starts."
    return f"All {starts} starts settle to it."


def _stroke(name: str) -> Callable[[SettledMotion], float | None]:
    """Return what gives peak to peak of an output, m, of a motion."""
    return lambda motion: motion.peak_to_peak.get(name)
