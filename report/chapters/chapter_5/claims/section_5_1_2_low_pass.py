"""Claims of section 5.1.2 on the filtering hypothesis and the Bode plot (figure 5.2)."""

from __future__ import annotations

import math

import control
import numpy as np
from scipy.optimize import brentq

from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.exact_response import gain
from report.numbers.linear_numbers import DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY, LinearNumbers
from trimmer import (
    filtering_ratio,
    resonance_peaks,
)

SOURCE = "trimmer/low_pass.py"
LIMIT_CYCLE_OMEGA = 4607.7
"""Angular frequency of the limit cycle that table 5.1 predicts at 733.33 Hz, rad/s."""
MUCH_SMALLER = 0.1
HARMONICS = range(2, 40)
SEARCHED = np.linspace(10, 2000, 8000) * 2 * math.pi


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_filtering(evidence.numbers), _bode_plot(evidence.numbers))


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
    fifth = {
        frequency: float(filtering_ratio(system, 2 * math.pi * frequency, 5))
        for frequency in (DRIVE_FREQUENCY, MEASURED_DRIVE_FREQUENCY)
    }
    highest_peak = max(resonance_peaks(system), key=lambda peak: peak.magnitude).omega / (2 * math.pi)
    return Claim(
        id="txt-5.1.2-filtering",
        parts=(
            _at_the_limit_cycle(numbers, third),
            _at_every_frequency(numbers, fifth),
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


def _at_every_frequency(numbers: LinearNumbers, fifth: dict[float, float]) -> Part:
    system = numbers.displacement_only
    every, odd = highest_unfiltered(system, HARMONICS), highest_unfiltered(system, range(3, 40, 2))
    measured = 2 * math.pi * MEASURED_DRIVE_FREQUENCY
    exact_fifth = _exact_ratio(numbers, measured, 5)
    return Part(
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
    )


def _at_the_limit_cycle(numbers: LinearNumbers, third: float) -> Part:
    exact_third = _exact_ratio(numbers, LIMIT_CYCLE_OMEGA, 3)
    return Part(
        f"at the predicted limit cycle, {LIMIT_CYCLE_OMEGA} rad/s",
        Assertion(
            statement=f"every odd harmonic is passed at most {MUCH_SMALLER:g} times as well",
            derived=third <= MUCH_SMALLER,
            evidence=f"$|G(3j\\omega)|/|G(j\\omega)| = {third:.4f}$, higher ones less",
            method="frequency response",
        ),
        Confirmation("exact coefficients, 40 digits", CloseNumbers(exact_third, third)),
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
