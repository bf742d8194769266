"""Limit cycles as text for people and as JSON for machines."""

import math
from collections.abc import Sequence
from typing import Any

from trimmer.balance.feasible_frequencies import FeasibleBand
from trimmer.balance.identification import Identification, IdentifiedTimeConstant, TimeConstantInterval
from trimmer.balance.leakage import HARMONICS, harmonic_leakage
from trimmer.balance.limit_cycle import Certificate, HarmonicBalance, LimitCycle
from trimmer.command_line.json_values import document, picked
from trimmer.command_line.table import table
from trimmer.loops.loops import ClosedLoop
from trimmer.loops.measured_loop import MeasuredLoop


def certificate_as_text(certificate: Certificate) -> list[str]:
    """Return lines on the range that was searched, rad/s, and on the regions that are undecided."""
    lowest, highest = certificate.omegas
    others = "none is missing there" if certificate.complete else "there may be others"
    outside = "; none exist outside" if certificate.outside_excluded else ""
    return [
        f"searched from {lowest:.6g} to {highest:.6g} rad/s: {others}{outside}",
        *(
            f"undecided: {_range(region.omegas)} rad/s, amplitude {_range(region.amplitudes)}"
            for region in certificate.undecided
        ),
        *certificate.other_doubts,
    ]


def certificate_as_json(certificate: Certificate) -> dict[str, object]:
    """Return a certificate as entries of JSON, in SI units."""
    names = ("smallest_gain", "winding_number", "winding_omegas", "index_sum", "zero_on_axis", "doubts")
    return {
        **picked(certificate, "method", "omegas", "outside_excluded", "complete", "boxes"),
        "undecided": [picked(region, "amplitudes", "omegas") for region in certificate.undecided],
        **picked(certificate, *names),
    }


def _range(ends: tuple[float, float]) -> str:
    return f"{ends[0]:.9g} to {ends[1]:.9g}"


_HEADS = ("amplitude", "rad/s", "Hz", "stable", "angle, deg", *(f"harmonic {n}" for n in HARMONICS))


def as_text(loop: ClosedLoop | MeasuredLoop, balance: HarmonicBalance) -> str:
    """Return limit cycles as a table, followed by the certificate.

    Amplitudes are in the unit of the element's input, frequencies in rad/s and Hz, angles in degrees.
    """
    rows = [
        (*_cycle_row(cycle), *(_ratio(ratio) for ratio in harmonic_leakage(loop.system, loop.element, cycle)))
        for cycle in balance.limit_cycles
    ]
    lines = [f"Limit cycles of {loop.element!r}", *table(_HEADS, rows)]
    lines += [
        f"between the data: amplitude +-{bound.amplitude:.2g}, +-{bound.omega:.2g} rad/s, if G is off by "
        f"{bound.response:.2g} at most"
        for bound in balance.bounds
    ]
    lines += certificate_as_text(balance.certificate)
    if any(cycle.near_tangency for cycle in balance.limit_cycles):
        lines.append(
            "an angle below 5 degrees: the curves nearly touch, so existence and stability are uncertain"
        )
    return "\n".join(lines)


def as_json(loop: ClosedLoop | MeasuredLoop, balance: HarmonicBalance) -> str:
    """Return limit cycles as JSON: full precision, SI units."""
    content = {
        "element": repr(loop.element),
        "limit_cycles": [
            {
                **_cycle(cycle),
                "harmonic_leakage": dict(
                    zip(map(str, HARMONICS), harmonic_leakage(loop.system, loop.element, cycle), strict=True)
                ),
                **({"bound": vars(balance.bounds[place])} if balance.bounds else {}),
            }
            for place, cycle in enumerate(balance.limit_cycles)
        ],
        "certificate": certificate_as_json(balance.certificate),
    }
    return document(content)


def identified_as_text(identified: Identification) -> str:
    """Return time constants, s, as a table, followed by their intervals and by the feasible frequencies."""
    lines = ["no M/D gives a limit cycle at this frequency"]
    if identified.time_constants:
        lines = ["Time constants M/D", *_table_of(identified.time_constants)]
    spread = identified.frequency_uncertainty
    if spread > 0:
        around = f"{identified.frequency:.9g} +- {spread:.3g} Hz"
        lines += [f"M/D within {around}: {_interval(each)}" for each in identified.intervals]
        if not identified.intervals:
            lines.append(f"no M/D gives a limit cycle within {around}")
    lines += [f"feasible: {_band(band)}" for band in identified.bands]
    if not identified.bands:
        lines.append("feasible: no frequency; no M/D gives a limit cycle at all")
    if identified.nearest is not None:
        away = identified.nearest.limit_cycle.frequency - identified.frequency
        lines += [f"The nearest limit cycle, {away:+.3g} Hz from there", *_table_of((identified.nearest,))]
    return "\n".join(lines)


def identified_as_json(identified: Identification) -> str:
    """Return what was identified as JSON; an infinite M/D, which is inertia-controlled backlash, is null."""
    nearest = identified.nearest
    content = {
        **picked(identified, "frequency", "frequency_uncertainty"),
        "time_constants": [_time_constant(each) for each in identified.time_constants],
        "intervals": [picked(each, "lowest", "highest", "frequencies") for each in identified.intervals],
        "bands": [
            {
                "frequencies": band.frequencies,
                "time_constants": [end.time_constant for end in (band.lower, band.upper)],
            }
            for band in identified.bands
        ],
        "nearest": None if nearest is None else _time_constant(nearest),
    }
    return document(content)


def _table_of(found: Sequence[IdentifiedTimeConstant]) -> list[str]:
    rows = [(f"{each.time_constant:.6g}", *_cycle_row(each.limit_cycle)) for each in found]
    return table(("M/D, s", *_HEADS[:5]), rows)


def _time_constant(each: IdentifiedTimeConstant) -> dict[str, Any]:
    return {"time_constant": each.time_constant, "limit_cycle": _cycle(each.limit_cycle)}


def _interval(interval: TimeConstantInterval) -> str:
    low, high = interval.frequencies
    return f"{interval.lowest:.6g} to {interval.highest:.6g} s ({low:.9g} to {high:.9g} Hz)"


def _band(band: FeasibleBand) -> str:
    low, high = band.frequencies
    ends = " to ".join(
        "no end" if math.isnan(end.time_constant) else f"{end.time_constant:.6g} s"
        for end in (band.lower, band.upper)
    )
    return f"{low:.9g} to {high:.9g} Hz, with M/D from {ends}"


def _cycle(cycle: LimitCycle) -> dict[str, Any]:
    names = ("amplitude", "omega", "frequency", "stable", "residual", "crossing_angle", "near_tangency")
    return picked(cycle, *names, "other_unstable_poles")


def _ratio(value: float) -> str:
    """Return a ratio of harmonics; none beyond the ends of data."""
    return "-" if math.isnan(value) else f"{value:.3g}"


def _cycle_row(cycle: LimitCycle) -> tuple[str, ...]:
    numbers = (cycle.amplitude, cycle.omega, cycle.frequency)
    stable = "yes" if cycle.stable else "no"
    return (*(f"{number:.6g}" for number in numbers), stable, f"{math.degrees(cycle.crossing_angle):.3g}")
