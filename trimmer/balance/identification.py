"""The load's time constant M/D behind a backlash, from the frequency of a measured limit cycle."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from operator import attrgetter

import control
import numpy as np
from scipy.optimize import minimize_scalar

from trimmer.arguments import positive_number, real_number
from trimmer.arrays import Reals
from trimmer.balance.bounded import solve_bounded
from trimmer.balance.element_curve import ElementCurve, GainTable
from trimmer.balance.exclusion import EquationInBox
from trimmer.balance.feasible_frequencies import FeasibleBand, feasible_bands
from trimmer.balance.inverse_response import ConstantResponse, InverseResponse
from trimmer.balance.limit_cycle import IN_UNIT_OF_INPUT, LimitCycle
from trimmer.balance.loop import LoopEquation, inverse_response
from trimmer.balance.search import find_all
from trimmer.balance.stability import limit_cycles_at
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.showing.drawn import Drawn
from trimmer.showing.shown import Shown, ShownFields, Tabular
from trimmer.showing.table import Table, attributes

GAMMA_RANGE = (1e-8, 1e8)
"""omega M/D that is searched; beyond it, no measured frequency distinguishes the load from a friction- or
inertia-controlled one."""

LIMIT_TOLERANCE = 1e-7
"""|1 + N G| below which a frequency counts as that of friction- or inertia-controlled backlash itself."""

_LIMITS = 65  # Limits of the intervals of ln(omega M/D) to begin with

_SAMPLES = 400

_STEPS = 8

_FREQUENCIES = 17  # Frequencies of a measured range at which M/D is found, to see where it turns

_BESIDE = 1e-6  # How far inside a band, relative, a limit cycle is sought that exists up to its end only


@dataclass(frozen=True, repr=False)
class IdentifiedTimeConstant(Shown):
    """A time constant that gives a limit cycle at the measured frequency.

    Attributes:
        time_constant: M/D, s; 0 for friction-controlled, infinite for inertia-controlled backlash.
        limit_cycle: The limit cycle, at the measured frequency.
    """

    time_constant: float
    limit_cycle: LimitCycle

    @property
    def amplitude(self) -> float:
        """Amplitude of the limit cycle, half of peak to peak at the backlash, in the unit of the gap."""
        return self.limit_cycle.amplitude

    @property
    def stable(self) -> bool:
        """Whether that limit cycle is stable."""
        return self.limit_cycle.stable

    def _told(self) -> str:
        kind = "stable" if self.stable else "unstable"
        at = f"{self.limit_cycle.frequency:.6g} Hz"
        return f"M/D {self.time_constant:.6g} s, amplitude {self.amplitude:.6g}, {at}, {kind}"


@dataclass(frozen=True)
class TimeConstantInterval(ShownFields):
    """The time constants that give a limit cycle within a range of frequencies.

    Attributes:
        lowest: Smallest M/D, s; 0 for friction-controlled backlash.
        highest: Largest M/D, s; infinite for inertia-controlled backlash.
        frequencies: Lowest and highest frequency, Hz: the part of the measured range that is feasible.
    """

    lowest: float
    highest: float
    frequencies: tuple[float, float]


@dataclass(frozen=True, repr=False)
class Identification(Tabular, Drawn):
    """What a measured frequency tells of the load.

    ``plot`` draws M/D over the frequency of the limit cycle, with what was measured and what it gives.

    Attributes:
        frequency: Measured frequency, Hz.
        frequency_uncertainty: How far off it may be, either way, Hz.
        time_constants: Those that give a limit cycle at the very frequency, in rising order; empty if it lies
            outside all bands.
        intervals: Time constants that give one within the uncertainty, an interval for each band that it
            meets. Empty if it meets none.
        bands: All frequencies at which some M/D gives a limit cycle.
        nearest: With the limit cycle that is nearest in frequency, if the measured frequency lies outside all
            bands; None if it does not, or there is no limit cycle with any M/D.
        gap: Total clearance, m.
    """

    frequency: float
    frequency_uncertainty: float
    time_constants: tuple[IdentifiedTimeConstant, ...]
    intervals: tuple[TimeConstantInterval, ...]
    bands: tuple[FeasibleBand, ...]
    nearest: IdentifiedTimeConstant | None
    gap: float
    _response: InverseResponse = field(compare=False)

    def limit_cycles_with(self, time_constant: float) -> tuple[LimitCycle, ...]:
        """Find the limit cycles with a load of another M/D, s, by rising frequency.

        Raises:
            WrongTypeError: if it is no number.
            ValueError: if it is negative or NaN.
        """
        curve = ElementCurve(ViscousBacklash(self.gap, time_constant))
        found = solve_bounded(self._response, curve, None).result
        return limit_cycles_at(LoopEquation(self._response, curve), found.u, found.x)

    def _told(self) -> str:
        return f"{self.frequency:.9g} Hz; {self.message}"

    def _table(self) -> Table:
        cycle = attributes(
            amplitude=IN_UNIT_OF_INPUT, omega="rad/s", frequency="Hz", stable="", crossing_angle="rad"
        )
        of_cycle = (replace(each, of=attrgetter(f"limit_cycle.{each.name}")) for each in cycle)
        columns = (*attributes(time_constant="s"), *of_cycle)
        return Table("Time constants M/D of the load", self.time_constants, columns)

    @property
    def success(self) -> bool:
        """Whether some M/D gives a limit cycle within the uncertainty of the frequency."""
        return bool(self.intervals)

    @property
    def message(self) -> str:
        """What came out, in words."""
        if self.success:
            ranges = (f"{each.lowest:.6g} to {each.highest:.6g} s" for each in self.intervals)
            return f"M/D within the uncertainty: {', '.join(ranges)}"
        if self.nearest is None:
            return "no M/D gives a limit cycle at any frequency"
        return (
            "no M/D gives a limit cycle within the uncertainty; the nearest one has "
            f"{self.nearest.limit_cycle.frequency:.9g} Hz with M/D = {self.nearest.time_constant:.6g} s"
        )


def identify_time_constant(
    system: control.lti.LTI, gap: float, frequency: float, *, frequency_uncertainty: float = 0.0
) -> Identification:
    """Find all M/D >= 0 for which a limit cycle has a given frequency (equation 5.11 of the thesis).

    Solves 1 + N(gap/A, omega M/D) G(j omega) = 0 for gap/A and M/D with the search of
    ``trimmer.balance.search``, so that none is missed. The gap scales the amplitude only.

    Whatever the load, a limit cycle has a frequency in certain bands only, so one that is measured a little
    wrong may fit no load at all. The bands are given, and with an uncertainty an interval of M/D.

    Args:
        system: G, a rational, proper, continuous-time system with one input and one output.
        gap: Total clearance, > 0, m.
        frequency: Frequency of the limit cycle, Hz.
        frequency_uncertainty: How far the frequency may be off, either way, Hz; >= 0 and less than the
            frequency. Of a spectrum it is about half a bin, or better where a peak is placed between bins.

    Returns:
        Time constants, intervals of them, and the frequencies that are feasible.

    Raises:
        UnsupportedSystemError: if G is not such a system.
        WrongTypeError: if a number is none.
        ValueError: if the gap or the frequency is not positive and finite, or the uncertainty out of its
            range.
    """
    response = inverse_response(system)
    frequency = positive_number("frequency", frequency, "Hz")
    spread = real_number("frequency_uncertainty", frequency_uncertainty, "Hz")
    if not 0 <= spread < frequency:
        raise ValueError(
            f"frequency_uncertainty must be zero or positive and less than the frequency, {frequency!r} Hz, "
            f"not {frequency_uncertainty!r}"
        )

    def at(trial: float) -> tuple[IdentifiedTimeConstant, ...]:
        return _time_constants(response, gap, trial)

    found = at(frequency)
    bands = feasible_bands(system, gap, lambda trial: bool(at(trial)))
    return Identification(
        frequency=frequency,
        frequency_uncertainty=spread,
        time_constants=found,
        intervals=tuple(_intervals(at, bands, frequency - spread, frequency + spread)),
        bands=bands,
        nearest=None if found else _nearest(at, bands, frequency),
        gap=float(gap),
        _response=response,
    )


def _intervals(
    at: Callable[[float], Sequence[IdentifiedTimeConstant]],
    bands: Sequence[FeasibleBand],
    lowest: float,
    highest: float,
) -> Iterator[TimeConstantInterval]:
    """Yield for each band the range of M/D between two frequencies, Hz, as far as they lie in the band."""

    def value(frequency: float) -> float:
        return next((each.time_constant for each in at(frequency)), math.nan)

    for band in bands:
        low, high = max(lowest, band.lower.frequency), min(highest, band.upper.frequency)
        if low > high:
            continue
        ends = [end.time_constant for end in (band.lower, band.upper) if lowest <= end.frequency <= highest]
        frequencies = np.unique(np.linspace(low, high, _FREQUENCIES))
        values = [value(each) for each in frequencies.tolist()]
        found = [each for each in (*ends, *values) if not math.isnan(each)]
        found += [value(turning) for turning in _turning_points(value, frequencies.tolist(), values)]
        if found:
            yield TimeConstantInterval(min(found), max(found), (low, high))


def _turning_points(
    value: Callable[[float], float], frequencies: Sequence[float], values: Sequence[float]
) -> Iterator[float]:
    """Yield the frequencies at which a value has an extremum between samples."""
    for place in range(1, len(values) - 1):
        before, here, after = values[place - 1 : place + 2]
        sign = int(here < min(before, after)) - int(here > max(before, after))
        if sign:
            bounds = frequencies[place - 1], frequencies[place + 1]
            yield float(
                minimize_scalar(
                    lambda trial, sign=sign: sign * value(trial), bounds=bounds, method="bounded"
                ).x
            )


def _nearest(
    at: Callable[[float], Sequence[IdentifiedTimeConstant]], bands: Sequence[FeasibleBand], frequency: float
) -> IdentifiedTimeConstant | None:
    """Find the limit cycle whose frequency is nearest to one that lies outside all bands."""
    sides = [(band.lower, band) for band in bands] + [(band.upper, band) for band in bands]
    if not sides:
        return None
    end, band = min(sides, key=lambda side: abs(side[0].frequency - frequency))
    if end.limit_cycle is not None:
        return IdentifiedTimeConstant(end.time_constant, end.limit_cycle)
    # Where the pin only just touches the load there is no limit cycle yet, but right beside it there is.
    other = band.upper if end is band.lower else band.lower
    away = min(_BESIDE * end.frequency, 0.5 * abs(other.frequency - end.frequency))
    inside = end.frequency + (away if end is band.lower else -away)
    return next(iter(at(inside)), None)


def _time_constants(
    response: InverseResponse, gap: float, frequency: float
) -> tuple[IdentifiedTimeConstant, ...]:
    """Find all M/D >= 0 for which a limit cycle has a frequency, Hz."""
    omega = 2.0 * math.pi * frequency
    inverse = complex(response.value(np.array([math.log(omega)]))[0])
    # With a time constant of 1 s, x = ln omega of the element is ln gamma.
    curve = ElementCurve(ViscousBacklash(gap, 1.0))
    table = GainTable.of(curve, np.linspace(math.log(GAMMA_RANGE[0]), math.log(GAMMA_RANGE[1]), _LIMITS))
    result = find_all(EquationInBox(ConstantResponse(inverse), curve, table, 0.0))
    found = [
        _identified(response, gap, math.exp(x) / omega, u, omega)
        for u, x in zip(result.u.tolist(), result.x.tolist(), strict=True)
    ]
    for time_constant in (0.0, math.inf):
        found += [
            _identified(response, gap, time_constant, u, omega)
            for u in _at_limit(ViscousBacklash(gap, time_constant), inverse, omega).tolist()
        ]
    return tuple(sorted(found, key=lambda each: (each.time_constant, each.amplitude)))


def _at_limit(element: ViscousBacklash, inverse: complex, omega: float) -> Reals:
    """Find u with N(u) + inverse = 0 to the tolerance, by the Gauss-Newton method from the nearest sample."""
    frozen = element.at(omega)
    curve = ElementCurve(frozen)  # at one omega N is the same at all x, so that u will do for x
    samples = float(frozen.domain()) * (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    u = samples[[np.argmin(np.abs(curve.value(samples, samples) + inverse))]]
    for _ in range(_STEPS):
        gain, slope, _ = curve.expansion(u, u)
        u = u - ((gain + inverse) * slope.conj()).real / np.abs(slope) ** 2
    with np.errstate(invalid="ignore"):
        return u[np.abs(curve.value(u, u) / inverse + 1.0) <= LIMIT_TOLERANCE]


def _identified(
    response: InverseResponse, gap: float, time_constant: float, u: float, omega: float
) -> IdentifiedTimeConstant:
    curve = ElementCurve(ViscousBacklash(gap, time_constant))
    (cycle,) = limit_cycles_at(LoopEquation(response, curve), np.array([u]), np.array([math.log(omega)]))
    return IdentifiedTimeConstant(time_constant, cycle)
