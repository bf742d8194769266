"""Claims of section 5.2.1 on the simulated closed loop: amplitude, frequency, errors, record."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.claims.printed import power_of
from report.claims.section_5_2_1 import ROUNDED, SMALL_GAP
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.exact_orbits import ExactOrbits
from report.numbers.record import Record

SOURCE = "report/numbers/exact_orbits.py"
STATED = Record(0.1, 1_000_231)
"""The record of section 5.2.1."""
ONE_SECOND = Record(1.0, 1_000_231)
"""As many samples over a second, so that bins are 1 Hz apart."""
PEAK = "734.00"
SECOND_WAY = "the state at the impact and two durations, solved for with SciPy's matrix exponential"


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    orbits = evidence.motion.closed.orbits
    return (
        _amplitude(orbits),
        _amplitude_error(evidence),
        _frequency(orbits),
        _frequency_error(evidence),
        _record(),
        _width_of_peak(orbits),
    )


def peak_part(orbits: ExactOrbits, label: str) -> Part:
    """Return the part on the peak of figure 5.9b."""
    exact = orbits.friction.stable.frequency
    return Part(
        label,
        PrintedDigits(PEAK, exact, "Hz"),
        Confirmation(SECOND_WAY, CloseNumbers(orbits.friction_by_durations[1], exact)),
        Slip(
            "the nearest bin of a spectrum over one second is read, of which bins are 1 Hz apart",
            ONE_SECOND.nearest(exact),
            Verdict.EXPLAINED,
        ),
    )


def amplitude_part(orbits: ExactOrbits, label: str, printed: str, gap: float) -> Part:
    """Return the part on a simulated amplitude."""
    exact = gap * orbits.friction.stable.amplitude
    return Part(
        label,
        PrintedDigits(printed, exact, "m"),
        Confirmation(SECOND_WAY, CloseNumbers(gap * orbits.friction_by_durations[0], exact)),
    )


def _amplitude(orbits: ExactOrbits) -> Claim:
    half = (3.303e-5 - -3.2961e-5) / 2
    exact, rounded = (
        SMALL_GAP * pair.stable.amplitude for pair in (orbits.friction, orbits.friction_listing)
    )
    return Claim(
        id="txt-5.2.1-simulated-amplitude",
        parts=(
            Part(
                "half of the difference of the readings",
                PrintedDigits("3.2995e-05", half, "m"),
                Confirmation(
                    "exact fractions",
                    CloseNumbers(float((Fraction("3.303e-5") + Fraction("3.2961e-5")) / 2), half),
                ),
            ),
            amplitude_part(orbits, "amplitude of the limit cycle", "3.2995e-05", SMALL_GAP),
        ),
        explanation=(
            f"Half of peak to peak of the two readings is {power_of(half, 6)} m, printed without its last "
            f"digit. The exact limit cycle has {power_of(exact, 4)} m, {100 * (exact / half - 1):.2f} % "
            f"more; with the rounded coefficients of Listing A.9 it has {power_of(rounded, 4)} m. It reaches "
            "equally far both ways, so the unequal readings hold something else too: steps of the solver, or "
            "a start that had not died out."
        ),
        consequence="The error of the prediction is smaller than the section finds.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _amplitude_error(evidence: Evidence) -> Claim:
    orbits = evidence.motion.closed.orbits
    predicted, exact = evidence.cycles.friction.stable.amplitude, orbits.friction.stable.amplitude
    error, second = (100 * (predicted / each - 1) for each in (exact, orbits.friction_by_durations[0]))
    quotient = abs(3.3138e-5 - 3.2995e-5) / 3.2995e-5
    other = evidence.cycles.inertia.unstable.amplitude / orbits.inertia.unstable.amplitude - 1
    return Claim(
        id="txt-5.2.1-amplitude-error",
        parts=(
            Part(
                "arithmetic",
                PrintedDigits("0.4334", 100 * quotient, "%"),
                Confirmation(
                    "exact fractions",
                    CloseNumbers(float(Fraction("3.3138e-5") / Fraction("3.2995e-5") - 1), quotient),
                ),
            ),
            Part(
                "error of the prediction",
                PrintedDigits("0.4334", error, "%"),
                Confirmation(SECOND_WAY, CloseNumbers(second, error, 1e-6)),
            ),
        ),
        explanation=(
            "The quotient of the printed numbers is right. Prediction and exact limit cycle of one and the "
            f"same loop differ by {error:.2f} %: the describing function is better here than its "
            "comparison with a simulation. It is not so everywhere; the unstable limit cycle of "
            f"inertia-controlled backlash it puts {100 * other:.0f} % too high."
        ),
        consequence="The prediction is better than the section finds.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _frequency(orbits: ExactOrbits) -> Claim:
    exact, rounded, both = (
        pair.stable.frequency
        for pair in (orbits.friction, orbits.friction_listing, orbits.friction_both_channels)
    )
    return Claim(
        id="txt-5.2.1-simulated-frequency",
        parts=(peak_part(orbits, "frequency of the limit cycle"),),
        explanation=(
            f"The exact limit cycle has {exact:.3f} Hz ({rounded:.3f} Hz with the rounded coefficients, "
            f"{both:.3f} Hz with both channels of the pin). A whole number of hertz is what a spectrum over "
            "one second shows: 734 Hz, or 733 Hz with rounded coefficients, which is the number that the "
            "printed error of 0.046 % belongs to. In bins of 10 Hz, as the section has them, it would be "
            f"{STATED.nearest(exact):.2f} Hz."
        ),
        consequence="The error of the prediction that is taken from it is that of reading a bin.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _frequency_error(evidence: Evidence) -> Claim:
    orbits, cycles = evidence.motion.closed.orbits, evidence.cycles
    predicted = cycles.friction_listing.stable.frequency
    quoted = 100 * abs(733.34 - 734.00) / 734.00
    other = 100 * abs(predicted - 733.00) / 733.00
    errors = [
        100 * (cycles.friction.stable.frequency / each - 1)
        for each in (orbits.friction.stable.frequency, orbits.friction_by_durations[1])
    ]
    return Claim(
        id="txt-5.2.1-frequency-error",
        parts=(
            Part(
                "arithmetic",
                PrintedDigits("0.046", quoted, "%"),
                Confirmation(
                    "the difference of logarithms",
                    CloseNumbers(100 * math.log(734.00 / 733.34), quoted, 1e-3),
                ),
                Slip(
                    "733.00 Hz is used for the simulated frequency, printed as 734.00",
                    other,
                    Verdict.ERRATUM,
                ),
            ),
            _error_itself(orbits, predicted, errors),
        ),
        explanation=(
            f"From the two printed frequencies the error is {quoted:.3f} %, twice what is printed; with a "
            "simulated 733.00 Hz, which the text does not have, it is the printed 0.046 %. That is the bin "
            "in which the loop with rounded coefficients shows. The error of the prediction itself is "
            f"{errors[0]:.4f} %."
        ),
        consequence="The agreement in frequency is better than a bin can show.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _error_itself(orbits: ExactOrbits, predicted: float, errors: list[float]) -> Part:
    bin_read = ONE_SECOND.nearest(orbits.friction_listing.stable.frequency)
    return Part(
        "error of the prediction",
        PrintedDigits("0.046", errors[0], "%"),
        Confirmation(SECOND_WAY, CloseNumbers(errors[1], errors[0], 1e-6)),
        Slip(
            f"{ROUNDED}, and the simulated frequency is the nearest bin of 1 Hz",
            100 * (predicted / bin_read - 1),
            Verdict.EXPLAINED,
        ),
    )


def _numpy_bin(record: Record, frequency: float) -> float:
    """Return the bin nearest to a frequency as NumPy has it, Hz."""
    bins = np.fft.rfftfreq(record.samples, record.duration / (record.samples - 1))
    return float(bins[np.argmin(np.abs(bins - frequency))])


def _record() -> Claim:
    quotient = 10002300 / 1000231
    return Claim(
        id="txt-5.2.1-sampling",
        parts=(
            Part(
                "frequency resolution",
                PrintedDigits("10", quotient, "Hz"),
                Confirmation("one over the time of 0.1 s", CloseNumbers(1 / 0.1, quotient, 1e-5)),
            ),
        ),
        explanation=(
            "The quotient is right and equals one over the sampled time, so ten million samples a second add "
            "nothing to the resolution. Figure 5.9b does not have it: see the statement on the width of its "
            "peak."
        ),
        source="report/numbers/record.py",
    )


def _width_of_peak(orbits: ExactOrbits) -> Claim:
    peak = float(PEAK)
    nearest = STATED.nearest(peak)
    return Claim(
        id="txt-5.2.1-peak-width",
        parts=(
            Part(
                f"the peak at {PEAK} Hz",
                Assertion(
                    statement="it is a line of a spectrum whose lines are 10 Hz apart",
                    derived=abs(nearest - peak) < 0.005,
                    evidence=(
                        f"the nearest line is at {nearest:.2f} Hz; one second has a line at "
                        f"{ONE_SECOND.nearest(peak):.2f} Hz"
                    ),
                    method="multiples of the sample rate over the number of samples",
                ),
                Confirmation("NumPy's bins", CloseNumbers(_numpy_bin(STATED, peak), nearest)),
            ),
        ),
        explanation=(
            "No line of such a spectrum lies within 3 Hz of 734 Hz, and a peak placed between lines would be "
            f"at {orbits.friction.stable.frequency:.2f} Hz. The spectrum of the figure is one over a second."
        ),
        consequence="The width of the peak is a tenth of what the text says.",
        impact=Impact.LOCAL,
        source="report/numbers/record.py",
    )
