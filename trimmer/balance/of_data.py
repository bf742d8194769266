"""Harmonic balance of a plant that is known at some frequencies alone, and how far off it may be."""

import math
from dataclasses import dataclass

import numpy as np

from trimmer.arrays import Complexes, Reals
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.limit_cycle import Certificate, HarmonicBalance, InterpolationBound, LimitCycle
from trimmer.balance.linear_part import parted
from trimmer.balance.sampled import DECADES, METHOD, found_on_grid
from trimmer.balance.stability import cycles_of
from trimmer.balance.uniqueness import cross
from trimmer.errors import FrequencyRangeError, LinearElementError
from trimmer.linear.measured_response import MeasuredResponse
from trimmer.loops.measured_loop import MeasuredLoop
from trimmer.ties import levels

EVEN = 201  # Places in equal ratios at which cells of the search begin, beside the points of the data
MOST_POINTS = 2000  # Cells along the frequency that are searched at once


@dataclass(frozen=True, eq=False)
class MeasuredInverse:
    """1/G of data over x = ln omega, as the search asks for it."""

    data: MeasuredResponse

    def value(self, x: Reals) -> Complexes:
        """Return 1/G at x of shape (n,)."""
        return np.asarray(np.exp(-self.data.logarithm(x)[0]))

    def value_and_slope(self, x: Reals) -> tuple[Complexes, Complexes]:
        """Return 1/G and its derivative by x at x of shape (n,)."""
        logarithm, slope = self.data.logarithm(x)
        inverse = np.exp(-logarithm)
        return np.asarray(inverse), np.asarray(-inverse * slope)


def balance_of_data(loop: MeasuredLoop, omega_range: tuple[float, float] | None) -> HarmonicBalance:
    """Predict limit cycles between the points of data, never beyond them, and without a certificate."""
    data, element = loop.system, loop.element
    if parted(element)[1] is None:
        raise LinearElementError(f"{element!r} is linear: nothing sets the amplitude of a limit cycle")
    lowest, highest = omega_range or data.ends
    if lowest < data.ends[0] or highest > data.ends[1]:
        raise FrequencyRangeError(
            f"omega_range {lowest:.6g} to {highest:.6g} rad/s goes beyond the data, {data.ends[0]:.6g} to "
            f"{data.ends[1]:.6g} rad/s; nothing is known of the plant there"
        )
    ends = math.log(lowest), math.log(highest)
    x = np.union1d(np.linspace(*ends, EVEN), np.clip(np.log(data.omega), *ends))
    inverse, curve = MeasuredInverse(data), ElementCurve(element)
    found = [
        found_on_grid(inverse, curve, x[first : first + MOST_POINTS + 1])
        for first in range(0, x.size - 1, MOST_POINTS)
    ]
    u, at = (np.concatenate([getattr(each, name) for each in found]) for name in ("u", "x"))
    order = np.lexsort((-u, levels(np.exp(at))))
    cycles, bounds = _cycles(inverse, curve, u[order], at[order])
    certificate = Certificate(
        method=METHOD,
        omegas=(lowest, highest),
        outside_excluded=False,
        boxes=sum(each.examined for each in found),
        undecided=(),
        smallest_gain=0.0,
        winding_number=None,
        index_sum=sum(cycle.index for cycle in cycles),
        zero_on_axis=False,
        unproven=_unproven(loop),
    )
    return HarmonicBalance(cycles, certificate, loop, bounds)


def _cycles(
    inverse: MeasuredInverse, curve: ElementCurve, u: Reals, x: Reals
) -> tuple[tuple[LimitCycle, ...], tuple[InterpolationBound, ...]]:
    if not u.size:
        return (), ()
    value, slope = inverse.value_and_slope(x)
    gain, by_u, gain_by_x = curve.expansion(u, x)
    by_x = slope + gain_by_x
    amplitudes, omegas, errors = curve.amplitude(u), np.exp(x), inverse.data.error(x)
    # A change of 1/G by |error/G| at most moves u and x so far at most, to first order.
    moved = errors * np.abs(value) / np.abs(cross(by_u, by_x))
    residuals, none = np.abs(1.0 + gain / value), np.zeros(u.size, dtype=np.int64)
    cycles = cycles_of(amplitudes, omegas, residuals, (by_u, np.asarray(by_x)), none)
    by_amplitude, by_omega = amplitudes * moved * np.abs(by_x) / u, omegas * moved * np.abs(by_u)
    each = zip(errors.tolist(), by_amplitude.tolist(), by_omega.tolist(), strict=True)
    return cycles, tuple(InterpolationBound(*one) for one in each)


def _unproven(loop: MeasuredLoop) -> tuple[str, ...]:
    scale = loop.element.amplitude_scale
    return (
        "frequency-response data have no certificate, so limit cycles may be missing from the list",
        *loop.system.doubts,
        f"amplitudes from {scale * 10.0**-DECADES:.3g} to {scale * 10.0**DECADES:.3g} were searched on a "
        "grid",
        "whether limit cycles are stable is told by Loeb's criterion alone: other poles of the loop are not "
        "in the data",
    )
