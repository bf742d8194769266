"""Claims of section 5.1.2 on the low-pass filter: cutoff, roll-off, filtering hypothesis, Bode plot."""

from __future__ import annotations

import math

import control
import numpy as np
from scipy.optimize import brentq

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.claims.exact_response import gain, gain_crossing
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY, LinearNumbers
from trimmer import (
    asymptotic_roll_off,
    bandwidth_crossings,
    filtering_ratio,
    gain_crossings,
    local_slope,
    resonance_peaks,
)

SOURCE = "trimmer/low_pass.py"
LIMIT_CYCLE_OMEGA = 4607.7
"""Angular frequency of the limit cycle that table 5.1 predicts at 733.33 Hz, rad/s."""
MUCH_SMALLER = 0.1
ROLL_OFF_FROM = 4700.0
"""Angular frequency above which the slope of the gain is examined, rad/s."""
HARMONICS = range(2, 40)
SEARCHED = np.linspace(10, 2000, 8000) * 2 * math.pi
HIGH_OMEGA = 1e8


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    numbers = evidence.numbers
    return (_cutoff(numbers), _roll_off(numbers), _filtering(numbers), _bode_plot(numbers))


def _cutoff(numbers: LinearNumbers) -> Claim:
    system = numbers.displacement_only
    unity = gain_crossings(system)[-1]
    crossings = bandwidth_crossings(system)
    level = float(gain(numbers, 0)) * 10 ** (-3 / 20)
    slip = Slip("the highest frequency with |G| = 1 (0 dB) is taken", unity, Verdict.EXPLAINED)
    labels = {"first -3 dB frequency": crossings[0], "last -3 dB frequency": crossings[-1]}
    return Claim(
        id="txt-5.1.2-cutoff",
        parts=tuple(
            Part(
                label,
                PrintedDigits("4.6329e+03", omega, "rad/s"),
                Confirmation(
                    "a root search on exact coefficients",
                    CloseNumbers(gain_crossing(numbers, level, omega), omega),
                ),
                slip,
            )
            for label, omega in labels.items()
        ),
        explanation=(
            f"The printed number is the highest frequency at which $|G| = 1$, {unity:.2f} rad/s, not a "
            "cutoff. The cutoff is where the gain is 3 dB below its static value: first at "
            f"{crossings[0]:.1f} rad/s, in the valley between two resonances, and for good at "
            f"{crossings[-1]:.1f} rad/s, beyond the last one."
        ),
        consequence=(
            f"The number is not used again. It lies {100 * (unity / LIMIT_CYCLE_OMEGA - 1):.1f} % above the "
            "predicted limit cycle, and not by accident: where the play is small beside the amplitude, $|N|$ "
            "and so $|G|$ are close to one."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _roll_off(numbers: LinearNumbers) -> Claim:
    system = numbers.displacement_only
    slope = asymptotic_roll_off(system)
    order = -slope / 20
    chord = 20 * math.log10(float(gain(numbers, 1e4) / gain(numbers, 1e3)))
    least_steep = float(local_slope(system, np.geomspace(ROLL_OFF_FROM, HIGH_OMEGA, 4000)).max())
    both = numbers.both_channels
    corner = numbers.parameters.k2 / numbers.parameters.c2
    far = Confirmation(
        "the slope of the exact gain at 1e8 rad/s",
        CloseNumbers(
            20 * math.log10(float(gain(numbers, 10 * HIGH_OMEGA) / gain(numbers, HIGH_OMEGA))), slope, 1e-6
        ),
    )
    return Claim(
        id="txt-5.1.2-roll-off",
        parts=(
            Part(
                "roll-off",
                PrintedDigits("-20", slope, "dB/decade"),
                far,
                Slip(
                    "the fall over the decade from 1e3 to 1e4 rad/s is read as the slope",
                    chord,
                    Verdict.ERRATUM,
                ),
            ),
            Part(
                "filter order",
                PrintedDigits("1", order),
                Confirmation(
                    "the degrees of the polynomials",
                    CloseNumbers(len(numbers.denominator) - len(numbers.numerator), order),
                ),
                Slip(
                    "the fall over the decade from 1e3 to 1e4 rad/s is read as the slope",
                    -chord / 20,
                    Verdict.ERRATUM,
                ),
            ),
        ),
        explanation=(
            f"There are two poles more than zeros, so the gain falls by {-slope:.0f} dB per decade in the "
            f"end, and above {ROLL_OFF_FROM:.0f} rad/s nowhere by less than {-least_steep:.1f}. From $10^3$ "
            f"to $10^4$ rad/s the curve as a whole drops by {-chord:.1f} dB, which may have been read as the "
            "slope."
        ),
        consequence=(
            "The linear part filters better than the thesis says: section 6.2 calls it on the edge of "
            "filtering, with order 1. With the pin's velocity as second input the slope is "
            f"{asymptotic_roll_off(both):.0f} dB per decade, but only far above {corner:.0f} rad/s."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def highest_unfiltered(system: control.TransferFunction, harmonics: range) -> float:
    """Return the highest frequency, Hz, at which some harmonic passes at least as well as the fundamental."""
    highest = 0.0
    for harmonic in harmonics:
        excess = filtering_ratio(system, SEARCHED, harmonic) - 1
        above = np.flatnonzero(excess >= 0)
        if above.size and above[-1] + 1 < SEARCHED.size:
            bracket = SEARCHED[above[-1]], SEARCHED[above[-1] + 1]
            root = brentq(lambda omega, n=harmonic: float(filtering_ratio(system, omega, n)) - 1, *bracket)
            highest = max(highest, root / (2 * math.pi))
    return highest


def _exact_ratio(numbers: LinearNumbers, omega: float, harmonic: int) -> float:
    return float(gain(numbers, harmonic * omega) / gain(numbers, omega))


def _filtering(numbers: LinearNumbers) -> Claim:
    system = numbers.displacement_only
    third, second = (float(filtering_ratio(system, LIMIT_CYCLE_OMEGA, n)) for n in (3, 2))
    every, odd = highest_unfiltered(system, HARMONICS), highest_unfiltered(system, range(3, 40, 2))
    fifth = {
        frequency: float(filtering_ratio(system, 2 * math.pi * frequency, 5))
        for frequency in (DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY)
    }
    highest_peak = max(resonance_peaks(system), key=lambda peak: peak.magnitude).omega / (2 * math.pi)
    measured = 2 * math.pi * MEASURED_DRIVE_FREQUENCY
    exact_fifth = _exact_ratio(numbers, measured, 5)
    exact_third = _exact_ratio(numbers, LIMIT_CYCLE_OMEGA, 3)
    return Claim(
        id="txt-5.1.2-filtering",
        parts=(
            Part(
                f"at the predicted limit cycle, {LIMIT_CYCLE_OMEGA} rad/s",
                Assertion(
                    statement=f"every odd harmonic is passed at most {MUCH_SMALLER:g} times as well",
                    derived=third <= MUCH_SMALLER,
                    evidence=f"$|G(3j\\omega)|/|G(j\\omega)| = {third:.4f}$, higher ones less",
                    method="frequency response",
                ),
                Confirmation("exact coefficients, 40 digits", CloseNumbers(exact_third, third)),
            ),
            Part(
                "at every frequency, as equation 2.26 asks",
                Assertion(
                    statement="$|G(j\\omega)| \\gg |G(jn\\omega)|$ for $n = 2, 3, \\dots$",
                    derived=every == 0.0,
                    evidence=(
                        f"below {every:.1f} Hz some harmonic passes better than the fundamental (odd ones: "
                        f"below {odd:.1f} Hz); at {MEASURED_DRIVE_FREQUENCY} Hz the fifth passes "
                        f"{fifth[MEASURED_DRIVE_FREQUENCY]:.2f} times better"
                    ),
                    method=f"search over 10 Hz to 2 kHz, harmonics up to {HARMONICS[-1]}",
                ),
                Confirmation(
                    "exact coefficients, 40 digits",
                    CloseNumbers(exact_fifth, fifth[MEASURED_DRIVE_FREQUENCY]),
                ),
            ),
        ),
        explanation=(
            "Whether the hypothesis holds depends on the frequency. At the predicted limit cycle it does: "
            f"the third harmonic passes {third:.3f} times as well as the fundamental, the second "
            f"{second:.3f} times. At the drive it does not: at {DRIVE_FREQUENCY:.0f} Hz the fifth harmonic "
            f"passes {fifth[DRIVE_FREQUENCY]:.1f} times better than the drive itself. At the measured "
            f"{MEASURED_DRIVE_FREQUENCY} Hz it would be {fifth[MEASURED_DRIVE_FREQUENCY]:.0f} times, as it "
            f"falls on the resonance at {highest_peak:.1f} Hz; the parameters of the measured trimmer "
            "(table C.1) are not given."
        ),
        consequence=(
            "Predictions of limit cycles near 733 Hz keep their basis. A describing function must not be "
            "used for the motion at the drive's frequency, and in driven spectra harmonics of the drive near "
            f"{highest_peak:.0f} Hz stand out without any limit cycle."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _bode_plot(numbers: LinearNumbers) -> Claim:
    peaks = resonance_peaks(numbers.displacement_only)
    clear = [peak for peak in peaks if peak.magnitude > 2]
    return Claim(
        id="fig-5.2",
        parts=(
            Part(
                "peaks that are clearly visible (more than twice the pin's motion)",
                PrintedDigits("2", len(clear)),
                Confirmation(
                    "the gain on a grid of 0.5 rad/s",
                    CloseNumbers(_peaks_on_grid(numbers), len(clear)),
                ),
            ),
        ),
        explanation=(
            f"The redrawn plot shows the two clear peaks, at {clear[0].omega:.1f} and {clear[1].omega:.1f} "
            f"rad/s, and two faint ones, at {peaks[0].omega:.1f} and {peaks[1].omega:.1f} rad/s, on either "
            "side of a shallow valley. What the text reads from it about slope and cutoff is judged under "
            "those statements."
        ),
        source="trimmer/extrema.py",
    )


def _peaks_on_grid(numbers: LinearNumbers) -> float:
    omega = np.arange(100, 10000, 0.5)
    magnitude = np.abs(np.polyval(list(map(float, numbers.numerator)), 1j * omega))
    magnitude /= np.abs(np.polyval(list(map(float, numbers.denominator)), 1j * omega))
    inner = magnitude[1:-1]
    return float(np.sum((inner > magnitude[:-2]) & (inner > magnitude[2:]) & (inner > 2)))
