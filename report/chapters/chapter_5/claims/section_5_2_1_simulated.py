"""Claims of section 5.2.1 on the simulated closed loop: limit cycle, record, ten times the gap."""

import math
from fractions import Fraction

import numpy as np

from report.chapters.second_ways import TWO_DURATIONS
from report.judging.claim import ClaimPart
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, made_here, repeated, so
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.exact_orbits import ExactOrbits
from report.numbers.record import Record as Samples
from report.numbers.thesis import LARGE_GAP, SMALL_GAP

STATED = Samples(0.1, 1_000_231)  # The record of section 5.2.1
ONE_SECOND = Samples(1.0, 1_000_231)  # As many samples over a second, so that bins are 1 Hz apart
THIRD_OF_A_SECOND = Samples(0.3, 1_000_231)
"""A record whose bin nearest to the exact frequency has the printed digits; its length is not given."""
PEAK = "734.00"
SIMULATED_AMPLITUDE = "3.2995e-5 m, simulated amplitude for 4e-6 m"  # Thing that is printed for two gaps


def peak_part(orbits: ExactOrbits, label: str) -> ClaimPart:
    """Return the part on the peak of figure 5.9b."""
    exact = orbits.friction.stable.frequency
    second = close(TWO_DURATIONS, orbits.friction_by_durations[1], exact)
    name = "the nearest bin of a spectrum over one second is read, of which bins are 1 Hz apart"
    slip, item = repeated(name, ONE_SECOND.nearest(exact)), "734.00 Hz, simulated frequency for 4e-6 m"
    return digits(label, PEAK, exact, "Hz", second=second, slip=slip, item=item)


def amplitude_part(orbits: ExactOrbits, label: str, printed: str, gap: float) -> ClaimPart:
    """Return the part on a simulated amplitude."""
    exact = gap * orbits.friction.stable.amplitude
    second = close(TWO_DURATIONS, gap * orbits.friction_by_durations[0], exact)
    return digits(label, printed, exact, "m", second=second, item=SIMULATED_AMPLITUDE)


@claim("txt-5.2.1-simulated-amplitude")
def amplitude(known: Evidence) -> Record:
    orbits = known.orbits
    half = (3.303e-5 - -3.2961e-5) / 2
    in_fractions = float((Fraction("3.303e-5") + Fraction("3.2961e-5")) / 2)
    exact = SMALL_GAP * orbits.friction.stable.amplitude
    second = close("exact fractions", in_fractions, half)
    label, item = "half of the difference of the readings", SIMULATED_AMPLITUDE
    yield digits(label, "3.2995e-05", half, "m", second=second, item=item)
    yield amplitude_part(orbits, "amplitude of the limit cycle", "3.2995e-05", SMALL_GAP)
    rounded = SMALL_GAP * orbits.friction_listing.stable.amplitude
    yield text(f"""
        Half of the distance of the two readings is right. The exact limit cycle has {power_of(exact, 4)} m,
        {100 * (exact / half - 1):.2f} % more; with the rounded coefficients of Listing A.9 it has
        {power_of(rounded, 4)} m. It reaches equally far both ways. The unequal readings therefore hold
        something else too: steps of the solver, or a start that had not died out.

        The error of the prediction is smaller than the section finds.
    """)


@claim("txt-5.2.1-amplitude-error")
def amplitude_error(known: Evidence) -> Record:
    predicted, exact = known.cycles.friction.stable.amplitude, known.orbits.friction.stable.amplitude
    quotient = abs(3.3138e-5 - 3.2995e-5) / 3.2995e-5
    in_fractions = float(Fraction("3.3138e-5") / Fraction("3.2995e-5") - 1)
    second = close("exact fractions", in_fractions, quotient)
    yield digits("", "0.4334", 100 * quotient, "%", second=second)
    yield text(f"""
        The quotient of the printed numbers is right. Prediction and exact limit cycle of the same loop differ
        by only {100 * (predicted / exact - 1):.2f} %; the rest is the reading of the simulation.
    """)


@claim("txt-5.2.1-simulated-frequency")
def frequency(known: Evidence) -> Record:
    orbits = known.orbits
    exact = orbits.friction.stable.frequency
    yield peak_part(orbits, "frequency of the limit cycle")
    yield text(f"""
        The exact limit cycle has {exact:.3f} Hz, and {orbits.friction_listing.stable.frequency:.3f} Hz with
        the rounded coefficients of Listing A.9. The printed number is the nearest line of a spectrum over one
        second. In a spectrum with lines 10 Hz apart, as the section has it, the nearest one is at
        {STATED.nearest(exact):.2f} Hz.

        The quoted prediction error is only the bin width of the spectrum.
    """)


@claim("txt-5.2.1-frequency-error")
def frequency_error(known: Evidence) -> Record:
    predicted, exact = known.cycles.friction.stable.frequency, known.orbits.friction.stable.frequency
    listing = known.cycles.friction_listing.stable.frequency
    quoted = 100 * abs(733.34 - 734.00) / 734.00
    by_logarithms = close("the difference of logarithms", 100 * math.log(734.00 / 733.34), quoted, 1e-3)
    name = "733.00 Hz is used for the simulated frequency, printed as 734.00"
    slip = made_here(name, 100 * abs(listing - 733.00) / 733.00)
    yield digits("", "0.046", quoted, "%", second=by_logarithms, slip=slip)
    yield text(f"""
        From the two printed frequencies the error is {quoted:.3f} %, twice what is printed. The printed
        number comes out with a simulated 733.00 Hz, which the text does not have. In a spectrum over one
        second it is the line nearest to the limit cycle with rounded coefficients.

        None. Prediction and exact limit cycle of the same loop differ by {100 * (predicted / exact - 1):.4f}
        %, less than a line of the spectrum can show.
    """)


@claim("txt-5.2.1-sampling")
def sampling(_: Evidence) -> Record:
    quotient = 10002300 / 1000231
    second = close("one over the time of 0.1 s", 1 / 0.1, quotient, 1e-5)
    yield digits("frequency resolution", "10", quotient, "Hz", second=second)
    yield text("""
        The quotient is right and equals one over the sampled time, so ten million samples a second add
        nothing to the resolution. For figure 5.9b see the [width of its peak](#txt-5.2.1-peak-width).
    """)


@claim("txt-5.2.1-peak-width")
def peak_width(_: Evidence) -> Record:
    peak = float(PEAK)
    nearest, fine = (samples.nearest(peak) for samples in (STATED, ONE_SECOND))
    bins = np.fft.rfftfreq(STATED.samples, STATED.duration / (STATED.samples - 1))
    yield assertion(
        f"the peak at {PEAK} Hz",
        "it is a line of the spectrum with the stated resolution, whose lines are 10 Hz apart",
        abs(nearest - peak) < 0.005,
        f"the nearest line is at {nearest:.2f} Hz; one second has a line at {fine:.2f} Hz",
        method="multiples of the sample rate over the number of samples",
        second=close("NumPy's bins", float(bins[np.argmin(np.abs(bins - peak))]), nearest),
    )
    yield text("""
        No line of a spectrum over 0.1 s lies within 3 Hz of the printed peak; one over a second has a line
        there. Either the record was ten times as long, and the peak a tenth as wide as the text says, or
        zeros were added to it, and the width is as the text says.

        None but for the stated resolution. Which of the two it was, the text does not say.
    """)


@claim("txt-5.2.1-simulated-4e-5")
def larger_gap(known: Evidence) -> Record:
    orbits, (inside, outside) = known.orbits, known.orbits.left_by
    inner, outer = orbits.friction.unstable, orbits.friction.stable
    stable, unstable = (abs(orbit.nontrivial_multipliers).max() for orbit in (outer, inner))
    yield amplitude_part(orbits, "amplitude", "3.2995e-04", LARGE_GAP)
    second = close(TWO_DURATIONS, orbits.friction_by_durations[1], outer.frequency)
    name = "the nearest bin of a spectrum over 0.3 s is read, of which bins are 3.33 Hz apart"
    slip = repeated(name, THIRD_OF_A_SECOND.nearest(outer.frequency))
    item = "733.33 Hz, simulated frequency for 4e-5 m"
    yield digits("frequency", "733.33", outer.frequency, "Hz", second=second, slip=slip, item=item)
    means = "a motion that starts 0.1 % outside of the second one and ends on the first"
    yield assertion(
        "what shows in the settled motion",
        "the first limit cycle shows and the second does not",
        stable < 1 < unstable,
        f"a disturbance changes by {stable:.4f} a period on it, by {unstable:.3f} on the second",
        method="Floquet multipliers of the exact orbits",
        second=close(means, outside, outer.amplitude, 1e-5),
    )
    outward = inner.nontrivial_multipliers[abs(inner.nontrivial_multipliers) > 1]
    means = "its one multiplier outside of the unit circle, real and positive: it is left to either side"
    yield assertion(
        "where a motion goes that leaves the second one with a larger amplitude",
        "it settles on the first",
        outside > inner.amplitude > inside,
        f"started 0.1 % outside it ends at {outside:.4f} gaps; started 0.1 % inside it dies out",
        method="exact simulation of both",
        second=so(means, (len(outward) == 1, outward[0].imag == 0, outward[0].real > 1)),
    )
    yield text(r"""
        Ten times the gap gives ten times the motion at the same frequency, so this simulation repeats [the
        one for a tenth of the gap](#txt-5.2.1-simulated-amplitude). Its frequency is the nearest line of a
        spectrum over 0.3 s, or table 5.1 copied. That only the outer limit cycle shows is right. The text
        follows a motion from the inner one towards larger amplitudes, which ends on the outer one; towards
        smaller amplitudes, which the text does not look at, it dies out.

        The readings change nothing. The inner limit cycle is the edge of what dies out: a weak disturbance
        leaves the loop at rest.
    """)
