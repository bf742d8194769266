"""Limit cycles that harmonic balance predicts for the thesis's trimmer, solved once."""

from dataclasses import dataclass

import control
import numpy as np
from scipy.optimize import minimize_scalar

from report.numbers.equivalent_nonlinearity import EquivalentNumbers, solve_equivalent
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.thesis import LISTING_DENOMINATOR, LISTING_NUMERATOR
from trimmer import FrictionBacklash, InertiaBacklash, LimitCycle, ViscousBacklash, limit_cycles

TIME_CONSTANTS = tuple(float(each) for each in np.geomspace(1e-6, 1.0, 9))
"""Load time constants M/D between the friction- and the inertia-controlled limit, s."""


@dataclass(frozen=True)
class Pair:
    """The unstable and the stable limit cycle of a gap of one metre, so that amplitudes are per gap."""

    unstable: LimitCycle
    stable: LimitCycle


@dataclass(frozen=True)
class LimitCycleNumbers:
    """Predictions for a gap of one metre; amplitudes go with the gap, frequencies do not depend on it.

    ``friction`` and ``inertia`` belong to the thesis's loop (pin displacement only), ``..._both_channels`` to
    the loop with the pin's velocity too, ``friction_listing`` to the rounded coefficients of Listing A.9.
    ``viscous`` holds all limit cycles for each of ``TIME_CONSTANTS`` in the thesis's loop,
    ``largest_viscous`` the stable one of the load that makes it largest. ``equivalent`` is about backlash and
    friction together, for the gaps and forces of section 5.2.5.
    """

    listing: control.TransferFunction
    friction: Pair
    friction_listing: Pair
    friction_both_channels: Pair
    inertia: Pair
    inertia_both_channels: Pair
    viscous: tuple[tuple[LimitCycle, ...], ...]
    largest_viscous: LimitCycle
    equivalent: EquivalentNumbers


def solve_limit_cycles(numbers: LinearNumbers) -> LimitCycleNumbers:
    """Solve harmonic balance for each kind of backlash."""
    listing = control.tf(*(list(map(float, each)) for each in (LISTING_NUMERATOR, LISTING_DENOMINATOR)))
    thesis, both = numbers.displacement_only, numbers.both_channels
    friction, inertia = FrictionBacklash(1.0), InertiaBacklash(1.0)
    by_friction, by_friction_both = _pair(thesis, friction), _pair(both, friction)
    viscous = tuple(_viscous(thesis, time_constant) for time_constant in TIME_CONSTANTS)
    return LimitCycleNumbers(
        listing=listing,
        friction=by_friction,
        friction_listing=_pair(listing, friction),
        friction_both_channels=by_friction_both,
        inertia=_pair(thesis, inertia),
        inertia_both_channels=_pair(both, inertia),
        viscous=viscous,
        largest_viscous=_largest(thesis, viscous),
        equivalent=solve_equivalent(
            numbers,
            listing,
            (by_friction.unstable, by_friction.stable),
            (by_friction_both.unstable, by_friction_both.stable),
        ),
    )


def _viscous(system: control.TransferFunction, time_constant: float) -> tuple[LimitCycle, ...]:
    return limit_cycles(system, ViscousBacklash(1.0, time_constant))


def _largest(system: control.TransferFunction, viscous: tuple[tuple[LimitCycle, ...], ...]) -> LimitCycle:
    """Return the stable limit cycle of largest amplitude over all loads, next to the largest of some."""

    def stable(exponent: float) -> LimitCycle:
        (cycle,) = (each for each in _viscous(system, 10.0**exponent) if each.stable)
        return cycle

    amplitudes = [max(cycle.amplitude for cycle in each if cycle.stable) for each in viscous]
    exponents, place = np.log10(TIME_CONSTANTS), int(np.argmax(amplitudes))
    best = minimize_scalar(
        lambda exponent: -stable(exponent).amplitude,
        bounds=(exponents[place - 1], exponents[place + 1]),
        method="bounded",
        options={"xatol": 1e-4},
    )
    return stable(best.x)


def _pair(system: control.TransferFunction, element: FrictionBacklash | InertiaBacklash) -> Pair:
    unstable, stable = sorted(limit_cycles(system, element), key=lambda cycle: cycle.stable)
    return Pair(unstable, stable)


def cycles_of_constant_gamma(system: control.lti.LTI, gamma: float) -> tuple[LimitCycle, LimitCycle]:
    """Return the limit cycles of viscous-controlled backlash if M ω / D did not depend on ω (figure 5.16).

    The unstable and the stable one, in order of frequency, for a gap of one metre.
    """
    inner, outer = limit_cycles(system, ViscousBacklash(1.0, gamma).at(1.0))
    return inner, outer
