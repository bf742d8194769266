"""One plateau of a sweep: some drive periods at one value, of which the second half is measured."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.hybrid.stretch import Ending, Instant
from trimmer.maps.settle import RETURNING, beside, on_orbit, recurrence, strobed_sizes
from trimmer.motion.course import Course
from trimmer.motion.flow import Flow
from trimmer.motion.measures import Measures, OutputMeasures
from trimmer.motion.signals import read
from trimmer.response.results.response import MotionKind
from trimmer.response.settling.recurrence import NEAR, has_returned
from trimmer.response.settling.settling import orbit_near

ORDERS = 10  # Multiples of the drive up to which a spectrum goes
SAMPLES = 64  # Samples of a drive period, for the spectrum
SEGMENT = 32  # Drive periods of a spectrum, at most
STEADY = 1e-9  # Share of its size by which a state may miss its return and yet repeat


@dataclass(frozen=True, eq=False)
class Plateau:
    """What moves at one value of a sweep."""

    kind: MotionKind  # Kind of motion over the second half
    periods: int | None  # Drive periods after which it repeats; None if it does not, or rests
    measured: int  # Drive periods that were measured; 0 if the motion ended before
    # What each output does, its advance over the period, or a drive period where there is none; none if the
    # motion ended before
    outputs: Mapping[str, OutputMeasures]
    # Amplitudes of each output at even steps from 0 to ``ORDERS`` times the drive, with a Hann window,
    # (lines,); none without a drive
    spectra: Mapping[str, Reals]
    impact_speed: float  # Largest speed at which sides of contacts meet, m/s; 0 without impacts
    ending: Ending  # Why the motion ends
    period: float | None = None  # Time after which it repeats, s; None if it does not, or rests


def dwell(flow: Flow, begin: Instant, periods: int, before: int = 0) -> tuple[Plateau, Instant]:
    """Go on for some drive periods, at least 2; returns what was measured, and where the motion ends.

    What grew for some periods before, at other values, must go on to grow in proportion to all of its age.

    Where it repeats to ``STEADY`` over the second half, the last period stands for all. So it does where it
    repeats but for an advance, to which all that is left of the start would add up.
    """
    half = periods // 2
    first = flow.strobe(begin, periods - half)
    second = flow.strobe(first.end, half) if first.ending is Ending.REACHED_END else first
    if second.ending is not Ending.REACHED_END:
        kind = MotionKind.DIVERGING if second.ending is Ending.DIVERGED else MotionKind.UNDECIDED
        return Plateau(kind, None, 0, {}, {}, 0.0, second.ending), second.end
    states = flow.reduced(np.concatenate([first.states, second.states[1:]]))
    found = _repeating(flow, states, second.end, half)
    kind, count = found or (beside(flow, states, first.end, second.end, half, before).kind, None)
    repeats = count or 1
    apart = abs(states[-1 - half + repeats :] - states[-1 - half : -repeats]) / strobed_sizes(states)
    advances = count is not None and flow.shifts > 0
    measured = repeats if advances or apart.max() < STEADY else half - half % repeats
    start = first.end if measured == half else flow.strobe(first.end, half - measured).end
    course = flow.course(start, measured)
    speed = float(flow.impact_speeds(course).max(initial=0.0))
    flow, course = flow.travelling(course)
    outputs = {
        name: replace(each, advance=each.advance * repeats / measured)
        for name, each in Measures(course, flow, repeats, measured).outputs.items()
    }
    spectra = dict(zip(outputs, _spectra(flow, course, measured, min(half, SEGMENT)).T, strict=True))
    period = count and count * flow.period
    return Plateau(kind, count, measured, outputs, spectra, speed, course.ending, period), second.end


def _repeating(flow: Flow, states: Reals, end: Instant, half: int) -> tuple[MotionKind, int | None] | None:
    """Return the kind of a motion that repeats, and after how many drive periods; None if it does not.

    It is periodic if an exact orbit is near that is stable, or on which it is to rounding: what is left of
    the start may still be dying out.
    """
    count, difference = recurrence(states[-1 - half :])
    orbit = orbit_near(flow, end.state, end, count) if difference < RETURNING else None
    if orbit is not None:
        apart = abs(states[-1] - flow.reduced(orbit.instant.state)) / orbit.sizes
        neutral = orbit.neutral and has_returned(states, orbit.sizes, orbit.periods)
        if apart.max() < NEAR and (orbit.stable or neutral):
            kind = on_orbit(orbit, len(states) - 1).kind
            return kind, None if kind is MotionKind.REST else orbit.period_count
    return None


def _spectra(flow: Flow, course: Course, measured: int, segment: int) -> Reals:
    """Return amplitudes over orders of all outputs, (lines, outputs); a line at one has its own height.

    Args:
        flow: What moves.
        course: Its motion.
        measured: Drive periods that this lasts.
        segment: Drive periods of the spectrum; a motion that lasts less repeats.
    """
    seen, count = min(measured, segment), segment * SAMPLES
    times = course.duration * (1.0 - seen / measured * (1.0 - np.arange(seen * SAMPLES) / (seen * SAMPLES)))
    samples = read(course, flow.outputs.values(), *course.at(times))
    samples = np.resize(samples - samples.mean(axis=0), (count, samples.shape[1]))
    window = 1.0 - np.cos(2 * np.pi * np.arange(count) / count)
    waves = np.fft.rfft(samples * window[:, None], axis=0)
    return np.asarray(2.0 * abs(waves[: ORDERS * segment + 1]) / count)
