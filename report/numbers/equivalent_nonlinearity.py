"""Predictions of section 5.2.5, with each form that the equivalent nonlinearity has in the thesis.

Listing A.6 adds -(j/w) 4 F_c/(π A) to friction-controlled backlash, with w frozen at the drive's frequency;
equation 5.14 prints something else; with the right operator the term is +j 4 F_c/(π A), and has to be divided
by a stiffness, such as k2, before it is added to a number. The gap is that of the listing: the total one.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import control
import mpmath

from report.numbers.friction_in_place import FrictionBranch, friction_branch
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.thesis import DRIVE_OMEGA, LARGER_GAP, SMALL_GAP, TURN
from trimmer import CoulombFriction, LimitCycle, limit_cycles, response_at
from trimmer.elements import Element
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.linear import InputChannels

FORCE = 0.6  # Friction force of figure 5.23, N; its gap is ``SMALL_GAP``
OTHER_FORCE = 0.15  # Friction force of figure 5.21, N; its gap is ``LARGER_GAP``
FORCES = (0.0006, 0.006, 0.06, 0.6)
START_OF_EQUATION = (0.06, 23e3)
"""A (m) and ω (rad/s) near the one solution of equation 5.14 that a search over both has found."""


@dataclass(frozen=True)
class NewtonSolution:
    """A solution found by Newton's method: amplitude in m, angular frequency in rad/s."""

    amplitude: float
    omega: float

    @property
    def frequency(self) -> float:
        """Frequency of the solution, Hz."""
        return self.omega / TURN


@dataclass(frozen=True)
class EquivalentNumbers:
    """Predictions, in the thesis's loop where nothing else is said.

    ``rounded`` has Listing A.6 with the coefficients of Listing A.9, ``rounded_less_force`` besides the force
    of figure 5.21, ``other_gap`` its force and gap. ``listing`` has exact coefficients, ``by_force`` one
    stable limit cycle for each of ``FORCES``. ``as_printed`` is equation 5.14, ``sign_turned`` the listing
    with the other sign of its term, ``over_stiffness`` the right term over k2, ``in_place`` friction between
    cutter and guard; ``..._both_channels`` is the loop with the pin's velocity too.
    """

    rounded: tuple[LimitCycle, ...]
    rounded_less_force: tuple[LimitCycle, ...]
    listing: tuple[LimitCycle, ...]
    other_gap: tuple[LimitCycle, ...]
    by_force: tuple[LimitCycle, ...]
    as_printed: NewtonSolution
    sign_turned: tuple[LimitCycle, ...]
    over_stiffness: tuple[LimitCycle, ...]
    over_stiffness_both_channels: tuple[LimitCycle, ...]
    in_place: FrictionBranch
    in_place_both_channels: FrictionBranch

    @property
    def force_of_merger(self) -> float:
        """Largest force between cutter and guard with a limit cycle, for the gap of figure 5.23, N."""
        return SMALL_GAP * self.in_place.merger.force_per_gap


def listing_element(force: float, gap: float = SMALL_GAP, omega: float = DRIVE_OMEGA) -> Element:
    """Return what Listing A.6 computes, above the edge of its dead band."""
    return FrictionBacklash(gap) - CoulombFriction(force / omega)


def right_element(force: float, stiffness: float, gap: float = SMALL_GAP) -> Element:
    """Return backlash with friction as a stiffness, over a stiffness in N/m."""
    return FrictionBacklash(gap) + CoulombFriction(force / stiffness)


def printed_function(amplitude: float, force: float, gap: float = SMALL_GAP) -> complex:
    """Evaluate equation 5.14 as it is printed, with the gap put in for its b."""
    c = 2 * gap / amplitude - 1
    real = math.pi / 2 - math.asin(c) - c * math.sqrt(1 - c**2)
    imaginary = 4 * gap / math.pi * (gap / amplitude - 1) - 4 * force / (DRIVE_OMEGA * amplitude * math.pi)
    return complex(real, imaginary) / amplitude


def solve_equivalent(
    numbers: LinearNumbers,
    rounded: control.TransferFunction,
    ends: tuple[LimitCycle, LimitCycle],
    ends_both: tuple[LimitCycle, LimitCycle],
) -> EquivalentNumbers:
    """Solve each variant; ``ends`` are the unstable and stable limit cycle without friction, per gap."""
    system, both, k2 = numbers.displacement_only, numbers.both_channels, numbers.parameters.k2
    by_force = (limit_cycles(system, listing_element(force)) for force in FORCES)
    channels = InputChannels.DISPLACEMENT_ONLY, InputChannels.DISPLACEMENT_AND_VELOCITY
    in_place, in_place_both = (
        friction_branch(numbers.parameters, channel, *pair)
        for channel, pair in zip(channels, (ends, ends_both), strict=True)
    )
    return EquivalentNumbers(
        rounded=limit_cycles(rounded, listing_element(FORCE)),
        rounded_less_force=limit_cycles(rounded, listing_element(OTHER_FORCE)),
        listing=limit_cycles(system, listing_element(FORCE)),
        other_gap=limit_cycles(system, listing_element(OTHER_FORCE, LARGER_GAP)),
        by_force=tuple(cycle for cycles in by_force for cycle in cycles if cycle.stable),
        as_printed=_newton(system, lambda a, _: printed_function(a, FORCE), *START_OF_EQUATION),
        sign_turned=limit_cycles(system, right_element(FORCE, DRIVE_OMEGA)),
        over_stiffness=limit_cycles(system, right_element(FORCE, k2)),
        over_stiffness_both_channels=limit_cycles(both, right_element(FORCE, k2)),
        in_place=in_place,
        in_place_both_channels=in_place_both,
    )


def _newton(
    system: control.TransferFunction,
    element: Callable[[float, float], complex],
    amplitude: float,
    omega: float,
) -> NewtonSolution:
    """Solve 1 + N(A, ω) G(jω) = 0 near a point, by the secant form of Newton's method in ln A and ln ω."""

    def residual(log_amplitude: float, log_omega: float) -> tuple[float, float]:
        a, w = amplitude * math.exp(log_amplitude), omega * math.exp(log_omega)
        loop = 1 + element(a, w) * complex(response_at(system, w))
        return loop.real, loop.imag

    log_amplitude, log_omega = mpmath.findroot(residual, (0, 0))
    return NewtonSolution(amplitude * math.exp(log_amplitude), omega * math.exp(log_omega))
