"""``fit``: numbers of a mechanism or a loop from a measured steady motion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from trimmer.arguments import real_number, require_instance, require_instances, whole_number
from trimmer.errors import FitError
from trimmer.fitting.doubted_drive import doubts_of
from trimmer.fitting.judgement import judge
from trimmer.fitting.measured import SMALLEST_NOISE, measure_lines
from trimmer.fitting.minimum import nearby_minimum
from trimmer.fitting.misfit import Misfit
from trimmer.fitting.model import SETTLED_WITHIN, Model
from trimmer.fitting.profile import MisfitProfile, ProfileSide
from trimmer.fitting.result import Fit, FittedNumber
from trimmer.fitting.search import AGREES, search
from trimmer.fitting.stray import in_words
from trimmer.fitting.unknowns import REACH, unknowns_of
from trimmer.fitting.weak import weak_directions
from trimmer.mechanism.mechanism import Mechanism
from trimmer.messages import near_or_all
from trimmer.progress import progress_bar
from trimmer.response.flows import called, flow_of, require_subject
from trimmer.signals.faults import faults
from trimmer.signals.quantity import MotionQuantity, quantity_of
from trimmer.signals.signal import Signal, SignalError

if TYPE_CHECKING:
    from trimmer.arrays import Reals
    from trimmer.fitting.measured import MeasuredLines
    from trimmer.fitting.misfit import Fitted
    from trimmer.fitting.search import FitSearch
    from trimmer.fitting.unknowns import Unknown
    from trimmer.loops.loops import Loop
    from trimmer.motion.subject import Subject

OTHER_FREQUENCY = 1e-4  # Relative difference from which the measured drive is told to be another one
MOST_RESTARTS = 4  # How often the fit begins anew where a profile has met a better one
AT_END = 0.98  # Share of the reach of a coordinate from which on it is told to be at its end
OPPOSITE = 0.5  # Share of chi-square below which the opposite sign of the measurement is told to fit better


@dataclass(frozen=True)
class FitSettings:
    """How numbers are fitted.

    Attributes:
        starts: Number of starts; those after the first are random.
        spread: Factor by which numbers differ from their start at most in these.
        seed: Of the random starts.
        confidence: Probability with which an interval is to hold the true number.
    """

    starts: int = 5
    spread: float = 2.0
    seed: int = 0
    confidence: float = 0.95

    def __post_init__(self) -> None:
        whole_number("starts", self.starts, 1)
        whole_number("seed", self.seed, 0)
        if not 1 < real_number("spread", self.spread) <= 100:
            raise FitError(f"spread is {self.spread!r}: it must be above 1, and 100 at most")
        if not 0 < real_number("confidence", self.confidence) < 1:
            raise FitError(f"confidence is {self.confidence!r}: it must be between 0 and 1")


def fit(
    mechanism: Mechanism | Loop,
    measured: Mapping[str, Signal],
    free: Sequence[str] = (),
    *,
    drive_frequency: float | None = None,
    settings: FitSettings | None = None,
) -> Fit:
    """Fit numbers of a mechanism or a loop to a measured steady motion of one or several of its outputs.

    The squares of the differences of all lines of the drive are least, each weighed with the noise that is
    seen between the lines; that is a fit of the waveform averaged over the drive periods. The simulated
    motion is the exact periodic one, stable, in the quantity that was measured. When the measurement began
    within the drive's period is not known, and is fitted too. Noise is taken to be Gaussian and stationary;
    means are not compared, because sensors have offsets.

    Of what vibrates by itself, without a drive, the period is a datum too: it is held against that of the
    orbit, with the deviation to which the record tells it. A loop begins with an orbit that is searched for
    (``periodic_orbits``), a mechanism with what it settles to from its start.

    Args:
        mechanism: The mechanism or loop with the numbers from which the fit begins.
        measured: The record of each output that was measured: displacement, velocity or acceleration. An
            output of a loop that has no unit may be measured without one; its name is as in ``outputs`` of a
            motion: ``output``, ``element_input``, ``element_output``.
        free: Dotted places of the numbers to fit; by default gap, stiffness and damping of each play and the
            force of each friction, or all numbers of a loop's element and frictions.
        drive_frequency: That of the drive in the measurement, or of the vibration without one, Hz; looked
            for near that of the mechanism if not given.
        settings: How is fitted.

    Raises:
        OrbitNotFoundError: if nothing repeats by itself.
        FitError: if nothing can be fitted: no such output, no number, or no start at which the
            motion repeats as the measured one does.
        SignalError: if the measurement cannot be used: no motion, no drive in it, too short.
        MechanismError, LoopError: if there is no such number.
        WrongTypeError: if an argument is of another type.
    """
    settings = settings or FitSettings()
    require_subject(mechanism)
    require_instance("settings", settings, FitSettings, "a trimmer.fitting.FitSettings")
    free = require_instances("free", free, str, "a dotted place")
    _check(mechanism, measured)
    if drive_frequency is not None and not 0 < real_number("drive_frequency", drive_frequency, "Hz") < np.inf:
        raise SignalError(f"drive_frequency is {drive_frequency!r}: it must be positive and finite")
    unknowns = unknowns_of(mechanism, free)
    units = {name: each.unit for name, each in flow_of(mechanism).outputs.items()}
    plain = {name: unit for name, unit in units.items() if quantity_of(unit) is MotionQuantity.OTHER}
    lines = measure_lines(measured, _near(mechanism), drive_frequency, plain, mechanism.frequency is None)
    if lines.by_itself and lines.period_count > 1:
        raise FitError(
            f"the record repeats after {lines.period_count} periods of {lines.frequency:.6g} Hz; say with "
            f"which frequency it repeats: {lines.frequency / lines.period_count:.6g} Hz (--drive)"
        )
    if len(unknowns) + 1 >= 2 * lines.lines.size:
        raise FitError(
            f"{len(unknowns)} numbers cannot be fitted to {lines.lines.size} lines; fit fewer (--free)"
        )
    driven = mechanism if lines.by_itself else mechanism.with_value("frequency", lines.frequency)
    count = len(lines.lines)
    own = (0 if name in plain else quantity_of(units[name]).derivatives for name in lines.outputs)
    derivatives = tuple(np.subtract(lines.derivatives, tuple(own)).tolist())
    model = Model(driven, unknowns, lines.outputs, derivatives, lines.period_count, count)
    misfit = Misfit(lines, model)
    searched = search(misfit, settings.starts, settings.spread, settings.seed)
    if searched is None:
        raise FitError(_nothing_found(misfit, settings))
    return _result(mechanism, misfit, searched, settings)


def _near(subject: Subject) -> float:
    """Return the frequency near which that of the measurement is looked for, Hz."""
    if subject.frequency is not None:
        return subject.frequency
    from trimmer.response.by_itself.orbit_by_itself import orbit_by_itself

    return 1.0 / orbit_by_itself(flow_of(subject)).period


def _check(subject: Subject, measured: Mapping[str, Signal]) -> None:
    """Check that a mechanism or loop has the outputs that were measured."""
    require_instance("measured", measured, Mapping, "signals by the names of outputs")
    what = called(subject)
    if not measured:
        raise FitError("nothing was measured: give the signal of one output at least")
    for name, signal in measured.items():
        require_instance(f"the signal of {name}", signal, Signal, "a trimmer.Signal")
        if name not in (outputs := flow_of(subject).outputs):
            raise FitError(f"the {what} has no output {name!r}; {near_or_all(name, outputs)}")


def _nothing_found(misfit: Misfit, settings: FitSettings) -> str:
    from trimmer.response.settling.settling import orbit_from_rest

    subject = misfit.model.subject
    if misfit.model.by_itself:
        return (
            f"no start leads to a stable motion of the {called(subject)} that repeats by itself: begin with "
            "other numbers (--set), or with more starts (--starts)"
        )
    orbit = orbit_from_rest(subject, SETTLED_WITHIN)
    does = f"repeats after {in_words(orbit.period_count)}" if orbit else "does not repeat"
    where = "its start" if settings.starts == 1 else f"all {settings.starts} starts"
    doubts = "".join(f"; {each}" for each in doubts_of(misfit.measured))
    return (
        f"the measured motion repeats after {in_words(misfit.measured.period_count)}, but from {where} "
        f"that of the {called(subject)} does not; with the numbers of {_source(subject)} it {does}: "
        f"begin with other numbers (--set), or with more starts (--starts){doubts}"
    )


def _result(subject: Subject, misfit: Misfit, searched: FitSearch, settings: FitSettings) -> Fit:
    from scipy.stats import f as distribution

    measured, unknowns = misfit.measured, misfit.model.unknowns
    allowed = float(distribution.ppf(settings.confidence, 1, measured.freedom))
    best, jacobian, sides = _profiled(misfit, searched.best, allowed)
    if best.chi_square < searched.best.chi_square - AGREES:
        came_to = (searched.best.chi_square,) * searched.agreeing
        searched = replace(searched, agreeing=0, elsewhere=(*came_to, *searched.elsewhere))
    searched = replace(searched, best=best)
    numbers = tuple(
        _number(unknown, float(at), *each)
        for unknown, at, each in zip(unknowns, best.coordinates, sides, strict=True)
    )
    angle = best.angle % (2 * np.pi)
    return Fit(
        subject=misfit.model.subject_at(best.coordinates),
        before=subject,
        numbers=numbers,
        confidence=settings.confidence,
        measured=measured,
        simulated=best.lines,
        shift=(2 * np.pi - angle) / (2 * np.pi) * measured.period_count / measured.frequency,
        orbit=best.motion.orbit,
        searched=searched,
        judgement=judge(measured, best, len(unknowns), called(subject)),
        weak=weak_directions(unknowns, jacobian, allowed),
        notes=tuple(_notes(subject, misfit, best)),
    )


def _profiled(
    misfit: Misfit, best: Fitted, allowed: float
) -> tuple[Fitted, Reals, list[tuple[ProfileSide, ProfileSide]]]:
    """Return the fit, its derivative, and both sides of each profile; anew where one meets a better fit."""
    count = len(best.coordinates)
    sides: list[tuple[ProfileSide, ProfileSide]] = []
    for _ in range(MOST_RESTARTS):
        jacobian, better = misfit.jacobian(best), None
        sides = []
        for place in progress_bar(range(count), "intervals"):
            profile = MisfitProfile(misfit, best, jacobian, place, allowed)
            sides.append((profile.side(-1.0), profile.side(1.0)))
            better = next((each.better for each in sides[-1] if each.better is not None), None)
            if better is not None:
                break
        if better is None:
            return best, jacobian, sides
        best = nearby_minimum(misfit, better, np.ones(count, dtype=bool))
    unknown = [ProfileSide(None, float(at), better=best) for at in best.coordinates]
    return best, misfit.jacobian(best), list(zip(unknown, unknown, strict=True))


def _number(unknown: Unknown, at: float, lower: ProfileSide, upper: ProfileSide) -> FittedNumber:
    ends = [None if side.end is None else unknown.value(side.end) for side in (lower, upper)]
    notes = [_open(unknown, side, word) for side, word in ((lower, "lower"), (upper, "upper"))]
    return FittedNumber(
        unknown.place,
        unknown.unit,
        unknown.start,
        unknown.value(at),
        ends[0],
        ends[1],
        unknown.value(lower.reached),
        unknown.value(upper.reached),
        notes[0],
        notes[1],
    )


def _open(unknown: Unknown, side: ProfileSide, word: str) -> str:
    """Return why an end of an interval is open; empty if it is not."""
    if side.end is not None:
        return ""
    if side.better is not None:
        return f"the {word} end is not known, because better fits were met on the way; try more starts"
    reached = f"{unknown.value(side.reached):.4g} {unknown.unit}".rstrip()
    if side.lost:
        return f"the {word} end is open: beyond {reached} no stable motion of this kind that fits was found"
    return f"the {word} end is open: {reached} fits within the noise too, and no end was found up to there"


def _notes(subject: Subject, misfit: Misfit, best: Fitted) -> Iterator[str]:
    measured = misfit.measured
    apart = 0.0 if subject.frequency is None else measured.frequency / subject.frequency - 1.0
    if subject.frequency is not None and abs(apart) > OTHER_FREQUENCY:
        yield (
            f"the measured drive, {measured.frequency:.8g} Hz, is {100 * apart:+.3g} % off that of "
            f"{_source(subject)}, {subject.frequency:.8g} Hz; the motion was simulated at the measured one"
        )
    for name, signal in measured.signals.items():
        before = f"{name}: " if len(measured.signals) > 1 else ""
        yield from (f"{before}{fault.sentence}" for fault in faults(signal))
    if measured.noiseless:
        yield (
            "hardly any noise is seen between the lines, so that it was taken to be "
            f"{SMALLEST_NOISE:g} of the largest line: the intervals say what such noise would leave open"
        )
    if misfit.opposite(best) < OPPOSITE * best.chi_square:
        yield (
            "with the opposite sign of the measurement the fit would be better: is the sensor mounted the "
            "other way round (--scale -1)?"
        )
    for unknown, at in zip(misfit.model.unknowns, best.coordinates, strict=True):
        if abs(at) > AT_END * unknown.reach:
            there = f"{unknown.value(float(at)):.4g} {unknown.unit}".rstrip()
            yield (
                f"{unknown.place}: {there} is at the end of what was "
                f"searched, a factor of {REACH:g} from its start"
            )
    yield from doubts_of(measured)
    yield from _kind(measured, best)


def _source(subject: Subject) -> str:
    """Return where the numbers stand with which a fit begins."""
    return "the file" if isinstance(subject, Mechanism) else "the loop"


def _kind(measured: MeasuredLines, best: Fitted) -> Iterator[str]:
    orbit = best.motion.orbit
    if orbit.period_count != measured.period_count:
        yield (
            f"the measured motion repeats after {in_words(measured.period_count)}, the fitted one after "
            f"{in_words(orbit.period_count)}: no start led to a motion of the measured kind"
        )
