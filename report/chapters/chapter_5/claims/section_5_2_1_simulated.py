"""Claims of section 5.2.1 on the simulated closed loop: limit cycle, record, impulses, ten times the gap."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from report.chapters.second_ways import TWO_DURATIONS
from report.claim import Impact, Part
from report.comparisons.printed import power_of
from report.evidence import Evidence
from report.numbers.exact_orbits import ExactOrbits
from report.numbers.impulse_response import ABOVE, CHECKED
from report.numbers.record import Record as Samples
from report.parts import assertion, close, digits, equal, made_here, repeated, so
from report.record import Record, claim, text
from report.thesis import LARGE_GAP, ROUNDED, SMALL_GAP
from trimmer import FrictionBacklash, limit_cycles

SOURCE = "report/numbers/exact_orbits.py"
STATED = Samples(0.1, 1_000_231)
"""The record of section 5.2.1."""
ONE_SECOND = Samples(1.0, 1_000_231)
"""As many samples over a second, so that bins are 1 Hz apart."""
THIRD_OF_A_SECOND = Samples(0.3, 1_000_231)
"""A record whose bin nearest to the exact frequency has the printed digits; its length is not given."""
PEAK = "734.00"
EDGE = 2e-8
"""Gap that the section takes for the smallest with a limit cycle, m."""


def peak_part(orbits: ExactOrbits, label: str) -> Part:
    """Return the part on the peak of figure 5.9b."""
    exact = orbits.friction.stable.frequency
    second = close(TWO_DURATIONS, orbits.friction_by_durations[1], exact)
    name = "the nearest bin of a spectrum over one second is read, of which bins are 1 Hz apart"
    return digits(label, PEAK, exact, "Hz", second=second, slip=repeated(name, ONE_SECOND.nearest(exact)))


def amplitude_part(orbits: ExactOrbits, label: str, printed: str, gap: float) -> Part:
    """Return the part on a simulated amplitude."""
    exact = gap * orbits.friction.stable.amplitude
    second = close(TWO_DURATIONS, gap * orbits.friction_by_durations[0], exact)
    return digits(label, printed, exact, "m", second=second)


@claim("txt-5.2.1-simulated-amplitude", source=SOURCE, impact=Impact.LOCAL)
def amplitude(known: Evidence) -> Record:
    orbits = known.orbits
    half = (3.303e-5 - -3.2961e-5) / 2
    in_fractions = float((Fraction("3.303e-5") + Fraction("3.2961e-5")) / 2)
    exact = SMALL_GAP * orbits.friction.stable.amplitude
    second = close("exact fractions", in_fractions, half)
    yield digits("half of the difference of the readings", "3.2995e-05", half, "m", second=second)
    yield amplitude_part(orbits, "amplitude of the limit cycle", "3.2995e-05", SMALL_GAP)
    yield text("""
        Half of peak to peak of the two readings is [[ half | power6 ]] m, printed without its last digit. The
        exact limit cycle has [[ exact | power4 ]] m, [[ more | f2 ]] % more; with the rounded coefficients of
        Listing A.9 it has [[ rounded | power4 ]] m. It reaches equally far both ways, so the unequal readings
        hold something else too: steps of the solver, or a start that had not died out.

        The error of the prediction is smaller than the section finds.
    """).given(
        half=half,
        exact=exact,
        more=100 * (exact / half - 1),
        rounded=SMALL_GAP * orbits.friction_listing.stable.amplitude,
    )


@claim("txt-5.2.1-amplitude-error", source=SOURCE, impact=Impact.LOCAL)
def amplitude_error(known: Evidence) -> Record:
    orbits, predicted = known.orbits, known.cycles.friction.stable.amplitude
    exact = orbits.friction.stable.amplitude
    error, second = (100 * (predicted / each - 1) for each in (exact, orbits.friction_by_durations[0]))
    quotient = abs(3.3138e-5 - 3.2995e-5) / 3.2995e-5
    in_fractions = float(Fraction("3.3138e-5") / Fraction("3.2995e-5") - 1)
    other = known.cycles.inertia.unstable.amplitude / orbits.inertia.unstable.amplitude - 1
    by_fractions = close("exact fractions", in_fractions, quotient)
    yield digits("arithmetic", "0.4334", 100 * quotient, "%", second=by_fractions)
    by_durations = close(TWO_DURATIONS, second, error, 1e-6)
    yield digits("error of the prediction", "0.4334", error, "%", second=by_durations)
    yield text("""
        The quotient of the printed numbers is right. Prediction and exact limit cycle of one and the same
        loop differ by [[ error | f2 ]] %: the describing function is better here than its comparison with a
        simulation. It is not so everywhere; the unstable limit cycle of inertia-controlled backlash it puts
        [[ other | f0 ]] % too high.

        The prediction is better than the section finds.
    """).given(error=error, other=100 * other)


@claim("txt-5.2.1-simulated-frequency", source=SOURCE, impact=Impact.LOCAL)
def frequency(known: Evidence) -> Record:
    orbits = known.orbits
    exact = orbits.friction.stable.frequency
    yield peak_part(orbits, "frequency of the limit cycle")
    yield text("""
        The exact limit cycle has [[ exact | f3 ]] Hz ([[ rounded | f3 ]] Hz with the rounded coefficients,
        [[ both | f3 ]] Hz with both channels of the pin). A whole number of hertz is what a spectrum over one
        second shows: 734 Hz, or 733 Hz with rounded coefficients, which is the number that the printed error
        of 0.046 % belongs to. In bins of 10 Hz, as the section has them, it would be [[ coarse | f2 ]] Hz.

        The error of the prediction that is taken from it is that of reading a bin.
    """).given(
        exact=exact,
        rounded=orbits.friction_listing.stable.frequency,
        both=orbits.friction_both_channels.stable.frequency,
        coarse=STATED.nearest(exact),
    )


@claim("txt-5.2.1-frequency-error", source=SOURCE, impact=Impact.LOCAL)
def frequency_error(known: Evidence) -> Record:
    orbits, cycles = known.orbits, known.cycles
    listing = cycles.friction_listing.stable.frequency
    quoted = 100 * abs(733.34 - 734.00) / 734.00
    error, second = (
        100 * (cycles.friction.stable.frequency / each - 1)
        for each in (orbits.friction.stable.frequency, orbits.friction_by_durations[1])
    )
    by_logarithms = close("the difference of logarithms", 100 * math.log(734.00 / 733.34), quoted, 1e-3)
    name = "733.00 Hz is used for the simulated frequency, printed as 734.00"
    slip = made_here(name, 100 * abs(listing - 733.00) / 733.00)
    yield digits("arithmetic", "0.046", quoted, "%", second=by_logarithms, slip=slip)
    by_durations = close(TWO_DURATIONS, second, error, 1e-6)
    name = f"{ROUNDED}, and the simulated frequency is the nearest bin of 1 Hz"
    slip = repeated(name, 100 * (listing / ONE_SECOND.nearest(orbits.friction_listing.stable.frequency) - 1))
    yield digits("error of the prediction", "0.046", error, "%", second=by_durations, slip=slip)
    yield text("""
        From the two printed frequencies the error is [[ quoted | f3 ]] %, twice what is printed; with a
        simulated 733.00 Hz, which the text does not have, it is the printed 0.046 %. That is the bin in which
        the loop with rounded coefficients shows. The error of the prediction itself is [[ error | f4 ]] %.

        The agreement in frequency is better than a bin can show.
    """).given(quoted=quoted, error=error)


@claim("txt-5.2.1-sampling", source="report/numbers/record.py")
def sampling(_: Evidence) -> Record:
    quotient = 10002300 / 1000231
    second = close("one over the time of 0.1 s", 1 / 0.1, quotient, 1e-5)
    yield digits("frequency resolution", "10", quotient, "Hz", second=second)
    yield text("""
        The quotient is right and equals one over the sampled time, so ten million samples a second add
        nothing to the resolution. Figure 5.9b does not have it: see the statement on the width of its peak.
    """)


@claim("txt-5.2.1-peak-width", source="report/numbers/record.py", impact=Impact.LOCAL)
def peak_width(known: Evidence) -> Record:
    peak = float(PEAK)
    nearest, fine = (samples.nearest(peak) for samples in (STATED, ONE_SECOND))
    bins = np.fft.rfftfreq(STATED.samples, STATED.duration / (STATED.samples - 1))
    yield assertion(
        f"the peak at {PEAK} Hz",
        "it is a line of a spectrum whose lines are 10 Hz apart",
        abs(nearest - peak) < 0.005,
        f"the nearest line is at {nearest:.2f} Hz; one second has a line at {fine:.2f} Hz",
        method="multiples of the sample rate over the number of samples",
        second=close("NumPy's bins", float(bins[np.argmin(np.abs(bins - peak))]), nearest),
    )
    yield text("""
        No line of such a spectrum lies within 3 Hz of 734 Hz, and a peak placed between lines would be at
        [[ exact | f2 ]] Hz. The spectrum of the figure is one over a second.

        The width of the peak is a tenth of what the text says.
    """).given(exact=known.orbits.friction.stable.frequency)


@claim("txt-5.2.1-touching", source="trimmer/balance/solve.py", impact=Impact.DOWNSTREAM)
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
        The section predicts none for $2\times10^{-8}$ m, sees a small oscillation in the simulation, and
        concludes that the two agree. They do, but only because the prediction is another one: the curves of
        this gap are those of every gap and cross twice.

        The agreement that is found speaks for the method and against the threshold.
    """)


def one_impulse_part(known: Evidence) -> Part:
    """Return the part on one impulse for several gaps."""
    numbers = known.motion.closed.impulses
    means = f"events in the first {1e3 * CHECKED:.0f} ms after {ABOVE} thresholds, by SciPy's DOP853"
    return assertion(
        "one impulse for all gaps",
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
    )


@claim("txt-5.2.1-impulse-1e-8", source="report/numbers/impulse_response.py", impact=Impact.DOWNSTREAM)
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
    )
    yield text(r"""
        Impulse, gap and motion times one factor are again a motion, so with one impulse it is the larger gap
        that dies out, if any: $3\times10^{-8}$ m does below [[ threshold | power2 ]] m s, $10^{-8}$ m below a
        third of that. Printed is the opposite order. Where all go on, they oscillate as 1 : 2 : 3, beside a
        first swing of [[ peak | f0 ]]/s times the impulse; on one scale the smallest is easily not seen.

        The simulation does not support a threshold in the gap, which chapters 6 and 7 quote: what matters is
        how hard the loop is struck.
    """).given(threshold=3e-8 * numbers.threshold, peak=numbers.peak)


@claim("txt-5.2.1-simulated-4e-5", source=SOURCE, impact=Impact.LOCAL)
def larger_gap(known: Evidence) -> Record:
    orbits, (inside, outside) = known.orbits, known.orbits.left_by
    inner, outer = orbits.friction.unstable, orbits.friction.stable
    stable, unstable = (abs(orbit.nontrivial_multipliers).max() for orbit in (outer, inner))
    yield amplitude_part(orbits, "amplitude", "3.2995e-04", LARGE_GAP)
    second = close(TWO_DURATIONS, orbits.friction_by_durations[1], outer.frequency)
    name = "the nearest bin of a spectrum over 0.3 s is read, of which bins are 3.33 Hz apart"
    slip = repeated(name, THIRD_OF_A_SECOND.nearest(outer.frequency))
    yield digits("frequency", "733.33", outer.frequency, "Hz", second=second, slip=slip)
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
        "where a motion goes that leaves the second one",
        "it settles on the first",
        min(inside, outside) > inner.amplitude,
        f"started 0.1 % outside it ends at {outside:.4f} gaps, started 0.1 % inside it dies out",
        method="exact simulation of both",
        second=so(means, len(outward) == 1 and outward[0].imag == 0 and outward[0].real > 1),
    )
    yield text(r"""
        Ten times the gap gives ten times the motion at the same frequency, so this simulation repeats the one
        for $4\times10^{-6}$ m. Its two readings, 734.00 and 733.33 Hz, are the nearest bins of one second and
        of 0.3 s, if 733.33 Hz is not the prediction of table 5.1 copied. The exact multipliers agree that
        only the outer limit cycle shows: [[ stable | f4 ]] per period for it, [[ unstable | f3 ]] for the
        inner one. From the inner one a motion goes out to the other or dies out in the gap, by which side it
        starts on.

        The inner limit cycle is the edge of what dies out: a weak disturbance leaves the loop at rest.
    """).given(stable=stable, unstable=unstable)
