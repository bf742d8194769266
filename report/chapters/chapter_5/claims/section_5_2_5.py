"""Claims of section 5.2.5 on the limit cycle predicted with friction of 0.6 N and a gap of 4e-6 m."""

from __future__ import annotations

import math

import mpmath
import numpy as np
from scipy.optimize import brentq

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.equivalent_nonlinearity import (
    FORCE,
    GAP,
    OMEGA,
    EquivalentNumbers,
    Point,
    printed_function,
)
from report.numbers.friction_in_place import force_response
from report.numbers.limit_cycle_numbers import DIGITS, LISTING_DENOMINATOR, LISTING_NUMERATOR
from report.numbers.linear_numbers import DRIVE_AMPLITUDE
from trimmer import frequency_response
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.elements.friction_backlash import FrictionBacklash

SOURCE = "report/numbers/equivalent_nonlinearity.py"
PRINTED = "737.514"
LINE_18 = "line 18 of Listing A.6 is used for the friction term"
NEWTON = "Newton's method in 30 digits"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_prediction(evidence), _amplitude(evidence))


def listing_by_newton(near: LimitCycle, force: float, gap: float, omega: float) -> tuple[float, float]:
    """Return A (m) and ω (rad/s) from the formulas of Listing A.6 and the coefficients of Listing A.9."""
    with mpmath.workdps(DIGITS):
        above, below = (
            [mpmath.mpf(c) for c in coefficients] for coefficients in (LISTING_NUMERATOR, LISTING_DENOMINATOR)
        )

        def residual(scaled: mpmath.mpf, turning: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
            amplitude = scaled * near.amplitude
            c = 1 - gap / amplitude
            real = (mpmath.pi / 2 + mpmath.asin(c) + c * mpmath.sqrt(1 - c**2)) / mpmath.pi
            imaginary = -(1 - c**2) / mpmath.pi - 4 * force / (mpmath.pi * amplitude * omega)
            point = mpmath.mpc(0, turning * near.omega)
            linear = mpmath.polyval(above, point) / mpmath.polyval(below, point)
            loop = 1 + mpmath.mpc(real, imaginary) * linear
            return loop.real, loop.imag

        scaled, turning = mpmath.findroot(residual, (1, 1))
        return float(scaled * near.amplitude), float(turning * near.omega)


def intersections_part(numbers: EquivalentNumbers) -> Part:
    """Return the part on the number of limit cycles, which the figure and the text share."""
    return Part(
        "limit cycles with the right friction term, over $k_2$",
        PrintedDigits("1", len(numbers.over_stiffness)),
        Confirmation(
            "friction between cutter and guard in its own place",
            CloseNumbers(numbers.in_place.limit_cycles(FORCE / GAP), len(numbers.over_stiffness)),
        ),
        Slip(LINE_18, len(numbers.listing), Verdict.ERRATUM),
    )


def frequency_part(numbers: EquivalentNumbers) -> Part:
    """Return the part on the frequency as the listings give it, which the figure and the text share."""
    (cycle,), (less_force,) = numbers.rounded, numbers.rounded_less_force
    _, omega = listing_by_newton(cycle, FORCE, GAP, OMEGA)
    return Part(
        "frequency by Listing A.6 with the coefficients of Listing A.9",
        PrintedDigits(PRINTED, cycle.frequency, "Hz"),
        Confirmation(NEWTON, CloseNumbers(omega, cycle.omega)),
        Slip(
            "0.15 N, the force of figure 5.21, is used instead of 0.6 N, and the last digit is cut off",
            math.floor(1000 * less_force.frequency) / 1000,
            Verdict.ERRATUM,
        ),
    )


def _prediction(evidence: Evidence) -> Claim:
    numbers = evidence.cycles.equivalent
    (listing,), (both,) = numbers.listing, numbers.listing_both_channels
    return Claim(
        id="txt-5.2.5-prediction",
        parts=(
            intersections_part(numbers),
            frequency_part(numbers),
            _with_exact_coefficients(evidence),
            _with_own_frequency(evidence),
            _as_printed(evidence),
        ),
        explanation=(
            f"With the right friction term there is no limit cycle at {FORCE} N: friction between cutter and "
            f"guard ends it at {numbers.force_of_merger:.4f} N for this gap. A limit cycle near 737.5 Hz "
            "comes from line 18 of Listing A.6, whose term has the wrong sign and feeds the oscillation "
            f"(with the pin's velocity too {both.frequency:.2f} Hz). The stronger it is, the nearer the "
            "frequency comes to that where the real part of $1/G$ is $-1$, "
            f"{_where_force_does_not_count(evidence):.3f} Hz with the coefficients of Listing A.9, which no "
            "pole of the loop without play has. The printed last digit asks for a fifth to a quarter of the "
            "stated $F_c/(\\omega b)$, as with 0.15 N; what gave it stays open. Equation 5.14 itself, which "
            f"the text names as what is drawn, gives {numbers.as_printed.frequency:.0f} Hz."
        ),
        consequence=(
            "The comparison with 733.33 Hz, figures 5.23 and 5.24 and the peak of 736.993 Hz that is taken "
            f"for this limit cycle lose their ground. Its amplitude of {1e3 * listing.amplitude:.1f} mm, "
            "which the text does not give, would have shown it."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _where_force_does_not_count(evidence: Evidence) -> float:
    """Return the frequency to which Listing A.6 tends with a growing force, with rounded coefficients, Hz."""
    (cycle,) = evidence.cycles.equivalent.rounded
    listing = evidence.cycles.listing

    def real_part(frequency: float) -> float:
        return (1 / complex(frequency_response(listing, 2 * math.pi * frequency))).real + 1

    return float(brentq(real_part, cycle.frequency - 1, cycle.frequency + 1))


def _loop_closes(evidence: Evidence, element: complex, omega: float) -> Confirmation:
    loop = element * complex(frequency_response(evidence.numbers.displacement_only, omega))
    return Confirmation("$NG$ at that amplitude and frequency", CloseNumbers(loop, -1))


def _listing_function(amplitude: float, omega: float) -> complex:
    """Return N of Listing A.6 by its own formulas."""
    c = 1 - GAP / amplitude
    real = (math.pi / 2 + math.asin(c) + c * math.sqrt(1 - c**2)) / math.pi
    return complex(real, -(1 - c**2) / math.pi - 4 * FORCE / (math.pi * amplitude * omega))


def _with_exact_coefficients(evidence: Evidence) -> Part:
    (cycle,) = evidence.cycles.equivalent.listing
    return Part(
        "frequency by Listing A.6 with exact coefficients",
        PrintedDigits(PRINTED, cycle.frequency, "Hz"),
        _loop_closes(evidence, _listing_function(cycle.amplitude, OMEGA), cycle.omega),
    )


def _with_own_frequency(evidence: Evidence) -> Part:
    point: Point = evidence.cycles.equivalent.own_frequency
    return Part(
        "the same, with the loop's frequency in the friction term instead of the drive's",
        PrintedDigits(PRINTED, point.frequency, "Hz"),
        _loop_closes(evidence, _listing_function(point.amplitude, point.omega), point.omega),
    )


def _as_printed(evidence: Evidence) -> Part:
    point = evidence.cycles.equivalent.as_printed
    return Part(
        "frequency by equation 5.14 as printed",
        PrintedDigits(PRINTED, point.frequency, "Hz"),
        _loop_closes(evidence, printed_function(point.amplitude, FORCE), point.omega),
    )


def _amplitude(evidence: Evidence) -> Claim:
    (listing,) = evidence.cycles.equivalent.listing
    return Claim(
        id="txt-5.2.5-amplitude",
        parts=(
            _amplitude_by_listing(evidence),
            _amplitude_in_place(evidence),
        ),
        explanation=(
            "The text gives no amplitude. Its own function gives "
            f"{listing.amplitude / DRIVE_AMPLITUDE:.0f} times the amplitude of the pin, and the more the "
            "stronger the friction is; it is set by the friction term and would be nearly the same without a "
            "gap. The right term acts the other way: friction makes the oscillation smaller and then ends it."
        ),
        consequence=(
            "The section's model contradicts the conclusion of section 3.3 and chapter 7 that friction "
            "suppresses the limit cycle; the right one supports it."
        ),
        impact=Impact.DOWNSTREAM,
        source="report/numbers/friction_in_place.py",
    )


def at_the_merger(evidence: Evidence) -> Confirmation:
    """Confirm the solution with the largest force by solving the equations of motion at its frequency."""
    merger = evidence.cycles.equivalent.in_place.merger
    model = force_response(evidence.numbers.parameters)
    turning = 2j * math.pi * merger.frequency * np.eye(model.nstates) - model.A
    by_force = complex((model.C @ np.linalg.solve(turning, model.B)).item())
    omega = 2 * math.pi * merger.frequency
    by_pin = complex(frequency_response(evidence.numbers.displacement_only, omega))
    backlash = complex(FrictionBacklash(1.0).describing_function(merger.amplitude))
    stiffness = 4j * merger.force_per_gap / (math.pi * merger.amplitude)
    return Confirmation(
        "both responses at the last solution, where the loop closes",
        CloseNumbers(backlash * by_pin + stiffness * by_force, -1.0, 1e-6),
    )


def _amplitude_in_place(evidence: Evidence) -> Part:
    numbers = evidence.cycles.equivalent
    merger = numbers.in_place.merger
    without = GAP * evidence.cycles.friction.stable.amplitude
    return Part(
        "with friction as the stiffness that it is",
        Assertion(
            statement="a limit cycle with another amplitude is left at 0.6 N",
            derived=numbers.in_place.limit_cycles(FORCE / GAP) > 0,
            evidence=(
                f"the amplitude falls from {1e6 * without:.1f} µm to "
                f"{1e6 * GAP * merger.amplitude:.1f} µm at {numbers.force_of_merger:.4f} N; beyond "
                "that force there is no limit cycle"
            ),
            method="all solutions of harmonic balance, friction between cutter and guard",
        ),
        at_the_merger(evidence),
    )


def _amplitude_by_listing(evidence: Evidence) -> Part:
    friction = evidence.cycles.friction.stable
    (listing,) = evidence.cycles.equivalent.listing
    without = GAP * friction.amplitude
    growth = listing.amplitude / without
    return Part(
        "by Listing A.6",
        Assertion(
            statement="the amplitude changes much, the frequency little",
            derived=growth > 10 and abs(listing.frequency / friction.frequency - 1) < 0.01,
            evidence=(
                f"from {1e6 * without:.1f} µm without friction to {1e3 * listing.amplitude:.1f} mm "
                f"at {FORCE} N, {growth:.0f} times; the frequency rises by "
                f"{100 * (listing.frequency / friction.frequency - 1):.2f} %"
            ),
            method="all solutions of harmonic balance with the listing's function",
        ),
        _loop_closes(evidence, _listing_function(listing.amplitude, OMEGA), listing.omega),
    )
