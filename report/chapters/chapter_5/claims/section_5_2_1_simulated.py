"""Claims of section 5.2.1 on the simulated closed loop: limit cycle, record, impulses, ten times the gap."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from report.chapters.chapter_5.claims.section_5_2_1_predictions import SMALLEST_GAP
from report.chapters.second_ways import TWO_DURATIONS
from report.claim import Certainty, Impact, Part, Severity
from report.comparisons.printed import power_of
from report.evidence import Evidence
from report.numbers.exact_orbits import ExactOrbits
from report.numbers.impulse_response import ABOVE, CHECKED
from report.numbers.record import Record as Samples
from report.parts import assertion, close, digits, equal, made_here, repeated, so
from report.record import Record, claim, text
from report.thesis import LARGE_GAP, SMALL_GAP
from trimmer import FrictionBacklash, limit_cycles

SOURCE = "report/numbers/exact_orbits.py"
STATED = Samples(0.1, 1_000_231)
"""The record of section 5.2.1."""
ONE_SECOND = Samples(1.0, 1_000_231)
"""As many samples over a second, so that bins are 1 Hz apart."""
THIRD_OF_A_SECOND = Samples(0.3, 1_000_231)
"""A record whose bin nearest to the exact frequency has the printed digits; its length is not given."""
PEAK = "734.00"
SIMULATED_AMPLITUDE = "3.2995e-5 m, simulated amplitude for 4e-6 m"
NO_OSCILLATION = "no oscillation for 1e-8 m and oscillation for 3e-8 m, simulated closed loop"
"""Things that are printed in more than one place."""
EDGE = 2e-8
"""Gap that the section takes for the smallest with a limit cycle, m."""


def peak_part(orbits: ExactOrbits, label: str) -> Part:
    """Return the part on the peak of figure 5.9b."""
    exact = orbits.friction.stable.frequency
    second = close(TWO_DURATIONS, orbits.friction_by_durations[1], exact)
    name = "the nearest bin of a spectrum over one second is read, of which bins are 1 Hz apart"
    slip, item = repeated(name, ONE_SECOND.nearest(exact)), "734.00 Hz, simulated frequency for 4e-6 m"
    return digits(label, PEAK, exact, "Hz", second=second, slip=slip, item=item)


def amplitude_part(orbits: ExactOrbits, label: str, printed: str, gap: float) -> Part:
    """Return the part on a simulated amplitude."""
    exact = gap * orbits.friction.stable.amplitude
    second = close(TWO_DURATIONS, gap * orbits.friction_by_durations[0], exact)
    return digits(label, printed, exact, "m", second=second, item=SIMULATED_AMPLITUDE)


@claim(
    "txt-5.2.1-simulated-amplitude",
    source=SOURCE,
    impact=Impact.LOCAL,
    lines=(1018, 1022),
    paragraph=8,
    severity=Severity.SLIP,
)
def amplitude(known: Evidence) -> Record:
    orbits = known.orbits
    half = (3.303e-5 - -3.2961e-5) / 2
    in_fractions = float((Fraction("3.303e-5") + Fraction("3.2961e-5")) / 2)
    exact = SMALL_GAP * orbits.friction.stable.amplitude
    second = close("exact fractions", in_fractions, half)
    label, item = "half of the difference of the readings", SIMULATED_AMPLITUDE
    yield digits(label, "3.2995e-05", half, "m", second=second, item=item)
    yield amplitude_part(orbits, "amplitude of the limit cycle", "3.2995e-05", SMALL_GAP)
    yield text("""
        Half of the distance of the two readings is right. The exact limit cycle has [[ exact | power4 ]] m,
        [[ more | f2 ]] % more; with the rounded coefficients of Listing A.9 it has [[ rounded | power4 ]] m.
        It reaches equally far both ways. The unequal readings therefore hold something else too: steps of the
        solver, or a start that had not died out.

        The error of the prediction is smaller than the section finds.
    """).given(
        exact=exact,
        more=100 * (exact / half - 1),
        rounded=SMALL_GAP * orbits.friction_listing.stable.amplitude,
    )


@claim("txt-5.2.1-amplitude-error", source=SOURCE, lines=(1035, 1037), paragraph=9)
def amplitude_error(known: Evidence) -> Record:
    predicted, exact = known.cycles.friction.stable.amplitude, known.orbits.friction.stable.amplitude
    quotient = abs(3.3138e-5 - 3.2995e-5) / 3.2995e-5
    in_fractions = float(Fraction("3.3138e-5") / Fraction("3.2995e-5") - 1)
    second = close("exact fractions", in_fractions, quotient)
    yield digits("", "0.4334", 100 * quotient, "%", second=second)
    yield text("""
        The quotient of the printed numbers is right. Prediction and exact limit cycle of the same loop differ
        by only [[ error | f2 ]] %; the rest is the reading of the simulation.
    """).given(error=100 * (predicted / exact - 1))


@claim(
    "txt-5.2.1-simulated-frequency",
    source=SOURCE,
    impact=Impact.LOCAL,
    lines=(1041, 1041),
    paragraph=11,
    severity=Severity.SLIP,
)
def frequency(known: Evidence) -> Record:
    orbits = known.orbits
    exact = orbits.friction.stable.frequency
    yield peak_part(orbits, "frequency of the limit cycle")
    yield text("""
        The exact limit cycle has [[ exact | f3 ]] Hz, and [[ rounded | f3 ]] Hz with the rounded coefficients
        of Listing A.9. The printed number is the nearest line of a spectrum over one second. In a spectrum
        with lines 10 Hz apart, as the section has it, the nearest one is at [[ coarse | f2 ]] Hz.

        The quoted prediction error is only the bin width of the spectrum.
    """).given(
        exact=exact,
        rounded=orbits.friction_listing.stable.frequency,
        coarse=STATED.nearest(exact),
    )


@claim(
    "txt-5.2.1-frequency-error",
    source=SOURCE,
    impact=Impact.LOCAL,
    lines=(1041, 1043),
    paragraph=11,
    severity=Severity.SLIP,
)
def frequency_error(known: Evidence) -> Record:
    predicted, exact = known.cycles.friction.stable.frequency, known.orbits.friction.stable.frequency
    listing = known.cycles.friction_listing.stable.frequency
    quoted = 100 * abs(733.34 - 734.00) / 734.00
    by_logarithms = close("the difference of logarithms", 100 * math.log(734.00 / 733.34), quoted, 1e-3)
    name = "733.00 Hz is used for the simulated frequency, printed as 734.00"
    slip = made_here(name, 100 * abs(listing - 733.00) / 733.00)
    yield digits("", "0.046", quoted, "%", second=by_logarithms, slip=slip)
    yield text("""
        From the two printed frequencies the error is [[ quoted | f3 ]] %, twice what is printed. The printed
        number comes out with a simulated 733.00 Hz, which the text does not have. In a spectrum over one
        second it is the line nearest to the limit cycle with rounded coefficients.

        None. Prediction and exact limit cycle of the same loop differ by [[ error | f4 ]] %, less
        than a line of the spectrum can show.
    """).given(quoted=quoted, error=100 * (predicted / exact - 1))


@claim("txt-5.2.1-sampling", source="report/numbers/record.py", lines=(1052, 1054), paragraph=12)
def sampling(_: Evidence) -> Record:
    quotient = 10002300 / 1000231
    second = close("one over the time of 0.1 s", 1 / 0.1, quotient, 1e-5)
    yield digits("frequency resolution", "10", quotient, "Hz", second=second)
    yield text("""
        The quotient is right and equals one over the sampled time, so ten million samples a second add
        nothing to the resolution. For figure 5.9b see the [width of its peak](#txt-5.2.1-peak-width).
    """)


@claim(
    "txt-5.2.1-peak-width",
    source="report/numbers/record.py",
    impact=Impact.LOCAL,
    lines=(1045, 1054),
    paragraph=12,
    severity=Severity.SLIP,
    certainty=Certainty.READING,
)
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


@claim(
    "txt-5.2.1-touching",
    source="trimmer/balance/solve.py",
    impact=Impact.DOWNSTREAM,
    lines=(1007, 1016),
    paragraph=6,
    severity=Severity.CONCLUSION,
)
def touching(known: Evidence) -> Record:
    element = FrictionBacklash(EDGE)
    predicted, listed = (
        limit_cycles(system, element) for system in (known.numbers.displacement_only, known.cycles.listing)
    )
    stable = max(predicted, key=lambda cycle: cycle.amplitude)
    yield assertion(
        r"the curves for $2\times10^{-8}$ m",
        "they just touch, so that no limit cycle is predicted",
        all(cycle.near_tangency for cycle in predicted),
        """
        they cross [[ times ]] times, at [[ angle | f0 ]] degrees for the stable one, with
        [[ amplitude | f1 ]] nm
        """,
        numbers={
            "times": len(predicted),
            "angle": math.degrees(stable.crossing_angle),
            "amplitude": 1e9 * stable.amplitude,
        },
        method="all solutions of harmonic balance for that gap",
        second=equal("the coefficients of Listing A.9", len(listed), len(predicted)),
        item=SMALLEST_GAP,
    )
    simulated = max(run.amplitude for run in known.motion.closed.impulses.runs if run.gap == EDGE)
    exact = EDGE * known.orbits.friction.stable.amplitude
    yield assertion(
        "the small oscillation that is simulated",
        "it agrees with what harmonic balance gives",
        abs(simulated / stable.amplitude - 1) < 0.01,
        f"{1e9 * simulated:.1f} nm, beside {1e9 * stable.amplitude:.1f} nm",
        method="exact simulation, struck hard enough",
        second=close("the exact orbit, by shooting", exact, simulated, 1e-4),
    )
    yield text(r"""
        The section predicts no limit cycle for $2\times10^{-8}$ m, sees a small oscillation in the
        simulation, and concludes that the two agree. Harmonic balance does agree with the simulation, because
        it predicts that oscillation: the curves of this gap are those of every gap and cross twice.

        The agreement that is found speaks for the method and against the threshold.
    """)


def one_impulse_part(known: Evidence) -> Part:
    """Return the part on one impulse for several gaps."""
    numbers = known.motion.closed.impulses
    means = f"events in the first {1e3 * CHECKED:.0f} ms after {ABOVE} thresholds, by SciPy's DOP853"
    return assertion(
        "with one impulse for all gaps",
        r"there is one after which the loop dies out for $10^{-8}$ m and goes on for $3\times10^{-8}$ m",
        not numbers.one_threshold,
        r"""
        impulse over gap alone decides: of [[ count ]] impulses over nine decades those below
        [[ threshold | f2 ]] µs die out and those above go on, so $10^{-8}$ m goes on wherever
        $3\times10^{-8}$ m does
        """,
        numbers={"count": len(numbers.impulses), "threshold": 1e6 * numbers.threshold},
        method="scaling of the model; exact simulation over the whole range",
        second=equal(means, *numbers.counted),
        item=NO_OSCILLATION,
        certainty=Certainty.READING,
    )


@claim(
    "txt-5.2.1-impulse-1e-8",
    source="report/numbers/impulse_response.py",
    impact=Impact.DOWNSTREAM,
    lines=(1016, 1016),
    paragraph=7,
    severity=Severity.CONCLUSION,
    certainty=Certainty.READING,
)
def impulse(known: Evidence) -> Record:
    numbers = known.motion.closed.impulses
    strongest = max(run.impulse for run in numbers.runs)
    smallest, middle, largest = (run for run in numbers.runs if run.impulse == strongest)
    exact = known.orbits.friction.stable.amplitude * smallest.gap
    yield one_impulse_part(known)
    yield assertion(
        r"what is left for $10^{-8}$ m after an impulse that $3\times10^{-8}$ m goes on after",
        "no oscillation",
        smallest.amplitude < smallest.gap / 2,
        r"""
        [[ smallest | f1 ]] nm, beside [[ middle | f1 ]] nm for $2\times10^{-8}$ m and [[ largest | f1 ]] nm
        for $3\times10^{-8}$ m
        """,
        numbers={
            "smallest": 1e9 * smallest.amplitude,
            "middle": 1e9 * middle.amplitude,
            "largest": 1e9 * largest.amplitude,
        },
        method=f"exact simulation of the three gaps with {power_of(strongest)} m s",
        second=close("the exact orbit for $10^{-8}$ m, by shooting", exact, smallest.amplitude, 1e-4),
        item=NO_OSCILLATION,
    )
    yield text(r"""
        The text names one impulse input and gives no size. Impulse, gap and motion times one factor are again
        a motion, so with one impulse it is the larger gap that dies out, if any: $3\times10^{-8}$ m does
        below [[ threshold | power2 ]] m s, $10^{-8}$ m below a third of that. Where all go on, they oscillate
        as 1 : 2 : 3 after a first swing of [[ peak | f0 ]]/s times the impulse, beside which the smallest is
        easily not seen. If the impulse was smaller for the smaller gap, any outcome is possible.

        In neither case does the simulation support a threshold in the gap, which chapters 6 and 7 quote. What
        matters is how hard the loop is struck.
    """).given(threshold=3e-8 * numbers.threshold, peak=numbers.peak)


@claim(
    "txt-5.2.1-simulated-4e-5",
    source=SOURCE,
    impact=Impact.LOCAL,
    lines=(1092, 1092),
    paragraph=20,
    severity=Severity.SLIP,
)
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
        second=so(means, len(outward) == 1 and outward[0].imag == 0 and outward[0].real > 1),
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
