"""Claim of section 6.3 on whether friction holds the driving bridge, as friction-controlled backlash asks."""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY

LARGEST_FORCE = 1.0
"""Bound of the Coulomb force in sections 3.3, 5.2.4 and 5.2.5, N."""
OMEGA = 2 * math.pi * DRIVE_FREQUENCY
LARGER_GAP, PLAY_OF_EXPERIMENT = 4e-5, 2e-4
"""Gaps of sections 5.2.1 and 3.2, m."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    mass = evidence.numbers.parameters.m2
    own = mass * LARGER_GAP * evidence.cycles.friction.stable.amplitude
    at_the_cycle = own * evidence.cycles.friction.stable.omega**2
    return (
        Claim(
            id="txt-6.3-friction-dominates",
            parts=(
                _force_needed(mass),
                _let_go(mass),
            ),
            explanation=(
                "Sections 2.3.4, 5.2.1 and 6.3 take friction for dominant because the spring presses hard; "
                "none gives a number, and 6.3 says that there is no evidence. With the thesis's own mass, "
                "drive and bound the load's inertia is the larger force, and at the predicted limit cycle "
                f"for {1e6 * LARGER_GAP:.0f} µm it is {at_the_cycle:.0f} N. So neither limit holds; the "
                "general backlash is the one to use."
            ),
            consequence=(
                "The recommendation of chapter 7 may rest on ease, not on physics. Its frequency suffers "
                "little, 733.6 to 750.6 Hz between the limits; its amplitude by a third."
            ),
            impact=Impact.DOWNSTREAM,
            source="report/chapters/chapter_6/claims/section_6_3.py",
        ),
    )


def _let_go(mass: float) -> Part:
    ahead, seconds = _flight(mass)
    return Part(
        "a load of 3 g with 1.0 N of friction, let go by the pin",
        Assertion(
            statement="it stays within the gap until the pin comes back for it",
            derived=ahead < PLAY_OF_EXPERIMENT,
            evidence=(
                f"it would run {1e3 * ahead:.2f} mm ahead of the pin before it stops, so it "
                f"crosses the gap of {1e6 * LARGER_GAP:.0f} µm, and one of "
                f"{1e6 * PLAY_OF_EXPERIMENT:.0f} µm too"
            ),
            method="deceleration by a constant force, beside the pin's sine",
        ),
        Confirmation(
            "SciPy's integration of the flight",
            CloseNumbers(_integrated(mass, seconds), ahead, 1e-6),
        ),
    )


def _force_needed(mass: float) -> Part:
    needed = mass * DRIVE_AMPLITUDE * OMEGA**2
    return Part(
        "force that holds the load when the pin turns back",
        Assertion(
            statement="friction exceeds the load's inertia, so that the load stops with the pin",
            derived=needed < LARGEST_FORCE,
            evidence=(
                f"$m_2A\\omega^2$ is {needed:.2f} N under the drive, 3 g at 1.5 mm and 100 Hz; "
                f"friction is assumed below {LARGEST_FORCE:.1f} N"
            ),
            method="the thesis's mass, drive and bound of the force",
        ),
        Confirmation(
            "second differences of the pin's sampled motion",
            CloseNumbers(mass * _largest_acceleration(), needed, 1e-5),
        ),
    )


def _flight(mass: float) -> tuple[float, float]:
    """Return how far ahead of the pin the load comes to rest, m, and when after it was let go, s.

    The pin A sin ωt lets it go where its own deceleration exceeds that by friction.
    """
    deceleration = LARGEST_FORCE / mass
    phase = math.asin(deceleration / (DRIVE_AMPLITUDE * OMEGA**2))
    velocity = DRIVE_AMPLITUDE * OMEGA * math.cos(phase)
    seconds = velocity / deceleration
    travelled = velocity**2 / (2 * deceleration)
    pin = DRIVE_AMPLITUDE * (math.sin(phase + OMEGA * seconds) - math.sin(phase))
    return travelled - pin, seconds


def _integrated(mass: float, seconds: float) -> float:
    """Return the same distance by integrating both motions."""
    deceleration = LARGEST_FORCE / mass
    phase = math.asin(deceleration / (DRIVE_AMPLITUDE * OMEGA**2))
    velocity = DRIVE_AMPLITUDE * OMEGA * math.cos(phase)
    flight = solve_ivp(
        lambda t, state: [state[1] - DRIVE_AMPLITUDE * OMEGA * math.cos(phase + OMEGA * t), -deceleration],
        (0, seconds),
        [0.0, velocity],
        rtol=1e-10,
        atol=1e-14,
    )
    return float(flight.y[0, -1])


def _largest_acceleration() -> float:
    """Return the pin's largest acceleration by second differences over a period, m/s²."""
    step = 1e-6
    times = np.arange(0, 1 / DRIVE_FREQUENCY, step)
    return float(np.abs(np.diff(DRIVE_AMPLITUDE * np.sin(OMEGA * times), 2)).max()) / step**2
