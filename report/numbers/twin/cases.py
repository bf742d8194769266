"""Single motions of the twin: what they settle to, their lines, and one stretch of them to look at."""

from dataclasses import dataclass
from typing import Final, cast

import numpy as np

from report.numbers.independent.twin_motion import PlayedTrimmer, integrated
from report.numbers.record import harmonics
from report.numbers.thesis import DRIVE_AMPLITUDE, TURN
from report.numbers.twin.mechanism import BLADE, BRIDGE, CUTTER, FREQUENCY, MOTOR, STROKE, twin
from trimmer import Mechanism, MechanismMotion, MotionKind, OrbitNotFoundError, TrimmerParameters, respond
from trimmer.arrays import Reals
from trimmer.contact.flow import MechanismFlow
from trimmer.motion.course import Course
from trimmer.motion.measures import Measures
from trimmer.response.results.response import SettledMotion
from trimmer.response.statistics.estimate import Estimate

SHOWN: Final = 3  # Drive periods of the stretch
PHASES: Final = 2048  # Samples of a drive period in it
RECORD: Final = 220  # Drive periods over which a motion is measured that does not repeat: 2 s at 110 Hz
RECORD_PHASES: Final = 128  # Samples of a drive period for its spectrum
HIGHEST_ORDER: Final = 12
AWAY: Final = 0.1  # Distance from a harmonic, in orders, beyond which the window lets nothing of it pass
MOST_WAITED: Final = 600  # Drive periods to wait for a motion to settle


@dataclass(frozen=True, eq=False)
class MotionStretch:
    """``SHOWN`` drive periods of a motion, ``PHASES`` samples each from where the pin passes 0 upwards."""

    stroke: Reals  # Displacement of the cutter relative to the guard, m
    tension: Reals  # Force of the bridge on the cutter, N; its reaction acts on the motor


@dataclass(frozen=True, eq=False)
class TwinCase:
    """What the twin settles to from rest."""

    gap: float  # Total clearance, m
    force: float  # Friction, N
    frequency: float  # Of the drive, Hz
    kind: MotionKind  # Kind of motion
    period_count: int  # Drive periods after which it repeats; 0 if it does not
    waited: int  # Drive periods until it had settled
    largest_multiplier: float  # Largest modulus of the Floquet multipliers; NaN if it does not repeat
    lyapunov: Estimate  # Largest Lyapunov exponent per drive period
    peak_to_peak: float  # Of the stroke, m
    # Of the stroke by rising order of the drive: order, amplitude, m; (n, 2). Of a motion that does not
    # repeat the harmonics alone, of its mean over many drive periods.
    lines: Reals
    # motor, cutter: Root of the mean square acceleration, m/s²
    motor: float
    cutter: float
    impacts: float  # Contacts made per drive period
    impact_speed: float  # Largest speed of an impact, m/s
    largest_force: float  # Largest force of the bridge, N
    contact_share: float  # Share of the time in contact
    wear: float  # Power lost to the blade's friction, W
    # Displacement of the bridge relative to the motor, m, sampled ``PHASES`` times a drive period from where
    # the pin passes 0 upwards, until it repeats, or over ``RECORD`` drive periods
    bridge: Reals
    stretch: MotionStretch  # Some drive periods of it
    # Order of the drive, amplitude, m, (n, 2), with a Hann window over ``RECORD`` drive periods; empty if it
    # repeats
    spectrum: Reals

    @property
    def highest_between(self) -> float:
        """Highest amplitude of the spectrum at least ``AWAY`` orders from every harmonic, m."""
        orders, amplitudes = self.spectrum.T
        return float(amplitudes[abs(orders - np.round(orders)) >= AWAY].max())

    def line(self, order: float) -> float:
        """Return the amplitude of the line nearest to an order of the drive, m."""
        return float(self.lines[abs(self.lines[:, 0] - order).argmin(), 1])


@dataclass(frozen=True)
class Independent:
    """The same periodic motion integrated by another method from its first state on."""

    miss: float  # Largest distance of the end from the start, over the largest size of each state
    peak_to_peak: float  # Of the stroke on the samples, m
    lines: Reals  # Amplitudes at p/k of the drive, p = 1, 2, ..., m


@dataclass(frozen=True)
class Followed:
    """A settled motion over whole drive periods, with what measures it."""

    motion: SettledMotion
    flow: MechanismFlow
    course: Course
    periods: int
    period_count: int

    @property
    def measures(self) -> Measures:
        """Its measures."""
        return Measures(self.course, self.flow, max(self.period_count, 1), self.periods)


def followed(mechanism: Mechanism) -> Followed:
    """Return what a mechanism settles to from rest.

    Raises:
        OrbitNotFoundError: if the motion cannot be followed.
    """
    motion = respond(mechanism, most_periods=MOST_WAITED).motion
    if motion.orbit is not None:
        count = motion.orbit.period_count
        flow = cast("MechanismFlow", motion.orbit.flow)
        return Followed(motion, flow, motion.orbit.course, count, count)
    if motion.window is None:
        raise OrbitNotFoundError(motion.message)
    flow = cast("MechanismFlow", motion.window.flow)
    return Followed(motion, flow, flow.course(motion.window.end, RECORD), RECORD, 0)


def twin_case(gap: float, force: float, frequency: float = FREQUENCY) -> TwinCase:
    """Follow the twin with a gap, m, friction, N, and drive, Hz, from rest until it has settled.

    Raises:
        OrbitNotFoundError: if the motion cannot be followed.
    """
    found = followed(twin(gap, force, frequency))
    motion, measures = found.motion, found.measures
    output, contact = measures.outputs[STROKE], measures.contacts[BRIDGE]
    lines = np.array([(number / count, size) for number, count, size in output.lines])
    return TwinCase(
        gap=gap,
        force=force,
        frequency=frequency,
        kind=motion.kind,
        period_count=found.period_count,
        waited=motion.drive_periods,
        largest_multiplier=float("nan") if motion.orbit is None else float(abs(motion.orbit.multipliers[0])),
        lyapunov=motion.lyapunov or Estimate(float("nan"), float("nan")),
        peak_to_peak=output.peak_to_peak,
        lines=lines,
        motor=measures.rms_acceleration[MOTOR],
        cutter=measures.rms_acceleration[CUTTER],
        impacts=contact.impacts,
        impact_speed=contact.impact_speed,
        largest_force=contact.largest_force or 0.0,
        contact_share=contact.share,
        wear=measures.frictions[BLADE].power if BLADE in measures.frictions else 0.0,
        bridge=_bridge(found),
        stretch=_stretch(found),
        spectrum=_spectrum(found) if motion.orbit is None else np.empty((0, 2)),
    )


def independent(gap: float, force: float) -> Independent:
    """Integrate the periodic motion that the twin settles to by the Runge-Kutta method, from its first state.

    Raises:
        OrbitNotFoundError: if the twin does not settle to a periodic motion.
        ArithmeticError: if the integration fails.
    """
    found = followed(twin(gap, force))
    orbit = found.motion.orbit
    if orbit is None:
        raise OrbitNotFoundError("what does not repeat cannot be held against itself a period later")
    count = found.period_count
    times = np.arange(PHASES * count + 1) / (PHASES * FREQUENCY)
    trimmer = PlayedTrimmer(TrimmerParameters.thesis(), gap, force, DRIVE_AMPLITUDE, TURN * FREQUENCY)
    states = integrated(trimmer, orbit.instant.state, times)
    stroke = states[1] - states[3]
    return Independent(
        miss=float((abs(states[:, -1] - states[:, 0]) / abs(states).max(axis=1)).max()),
        peak_to_peak=float(np.ptp(stroke)),
        lines=harmonics(stroke[:-1])[1:],
    )


def _bridge(found: Followed) -> Reals:
    """Return where the bridge is relative to the motor, m, at each sample of the motion."""
    motion = MechanismMotion(found.flow, found.course)
    times = found.flow.period * np.arange(found.periods * PHASES) / PHASES
    spring = motion.states(times)[found.flow.names.index(BRIDGE)]
    place: Reals = motion.displacement(CUTTER, times) + spring - motion.displacement(MOTOR, times)
    return place


def _stretch(found: Followed) -> MotionStretch:
    """Return ``SHOWN`` drive periods, repeated if the motion is shorter."""
    motion = MechanismMotion(found.flow, found.course)
    taken = min(found.periods, SHOWN)
    times = found.flow.period * np.arange(taken * PHASES) / PHASES
    signals = (motion.output(STROKE, times), motion.contact_force(BRIDGE, times))
    return MotionStretch(*(np.resize(each, SHOWN * PHASES) for each in signals))


def _spectrum(found: Followed) -> Reals:
    """Return order and amplitude of each bin of a motion that does not repeat."""
    count = found.periods * RECORD_PHASES
    times = found.flow.period * np.arange(count) / RECORD_PHASES
    stroke = MechanismMotion(found.flow, found.course).output(STROKE, times)
    window = np.hanning(count + 1)[:-1]
    amplitudes = 2 * abs(np.fft.rfft((stroke - stroke.mean()) * window)) / window.sum()
    orders = np.arange(len(amplitudes)) / found.periods
    kept = orders <= HIGHEST_ORDER
    return np.column_stack([orders[kept], amplitudes[kept]])
