"""Claims of section 5.2.1 on the simulated closed loop: amplitude, frequency, errors, record."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from report.chapters.chapter_5.claims.section_5_2_1 import ROUNDED, SMALL_GAP
from report.claim import Impact, Part
from report.evidence import Evidence
from report.numbers.exact_orbits import ExactOrbits
from report.numbers.record import Record as Samples
from report.parts import assertion, close, digits, made_here, repeated
from report.record import Record, claim, text
from report.text import filled

SOURCE = "report/numbers/exact_orbits.py"
STATED = Samples(0.1, 1_000_231)
"""The record of section 5.2.1."""
ONE_SECOND = Samples(1.0, 1_000_231)
"""As many samples over a second, so that bins are 1 Hz apart."""
PEAK = "734.00"
SECOND_WAY = "the state at the impact and two durations, solved for with SciPy's matrix exponential"


def peak_part(orbits: ExactOrbits, label: str) -> Part:
    """Return the part on the peak of figure 5.9b."""
    exact = orbits.friction.stable.frequency
    slip = "the nearest bin of a spectrum over one second is read, of which bins are 1 Hz apart"
    return digits(
        label,
        PEAK,
        exact,
        "Hz",
        second=close(SECOND_WAY, orbits.friction_by_durations[1], exact),
        slip=repeated(slip, ONE_SECOND.nearest(exact)),
    )


def amplitude_part(orbits: ExactOrbits, label: str, printed: str, gap: float) -> Part:
    """Return the part on a simulated amplitude."""
    exact = gap * orbits.friction.stable.amplitude
    second = close(SECOND_WAY, gap * orbits.friction_by_durations[0], exact)
    return digits(label, printed, exact, "m", second=second)


@claim("txt-5.2.1-simulated-amplitude", source=SOURCE, impact=Impact.LOCAL)
def amplitude(known: Evidence) -> Record:
    orbits = known.orbits
    half = (3.303e-5 - -3.2961e-5) / 2
    in_fractions = float((Fraction("3.303e-5") + Fraction("3.2961e-5")) / 2)
    exact = SMALL_GAP * orbits.friction.stable.amplitude
    yield digits(
        "half of the difference of the readings",
        "3.2995e-05",
        half,
        "m",
        second=close("exact fractions", in_fractions, half),
    )
    yield amplitude_part(orbits, "amplitude of the limit cycle", "3.2995e-05", SMALL_GAP)
    yield text(
        """
        Half of peak to peak of the two readings is [[ half | power6 ]] m, printed without its last digit. The
        exact limit cycle has [[ exact | power4 ]] m, [[ more | f2 ]] % more; with the rounded coefficients of
        Listing A.9 it has [[ rounded | power4 ]] m. It reaches equally far both ways, so the unequal readings
        hold something else too: steps of the solver, or a start that had not died out.

        The error of the prediction is smaller than the section finds.
        """,
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
    yield digits(
        "arithmetic", "0.4334", 100 * quotient, "%", second=close("exact fractions", in_fractions, quotient)
    )
    yield digits(
        "error of the prediction", "0.4334", error, "%", second=close(SECOND_WAY, second, error, 1e-6)
    )
    yield text(
        """
        The quotient of the printed numbers is right. Prediction and exact limit cycle of one and the same
        loop differ by [[ error | f2 ]] %: the describing function is better here than its comparison with a
        simulation. It is not so everywhere; the unstable limit cycle of inertia-controlled backlash it puts
        [[ other | f0 ]] % too high.

        The prediction is better than the section finds.
        """,
        error=error,
        other=100 * other,
    )


@claim("txt-5.2.1-simulated-frequency", source=SOURCE, impact=Impact.LOCAL)
def frequency(known: Evidence) -> Record:
    orbits = known.orbits
    exact = orbits.friction.stable.frequency
    yield peak_part(orbits, "frequency of the limit cycle")
    yield text(
        """
        The exact limit cycle has [[ exact | f3 ]] Hz ([[ rounded | f3 ]] Hz with the rounded coefficients,
        [[ both | f3 ]] Hz with both channels of the pin). A whole number of hertz is what a spectrum over one
        second shows: 734 Hz, or 733 Hz with rounded coefficients, which is the number that the printed error
        of 0.046 % belongs to. In bins of 10 Hz, as the section has them, it would be [[ coarse | f2 ]] Hz.

        The error of the prediction that is taken from it is that of reading a bin.
        """,
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
    read = ONE_SECOND.nearest(orbits.friction_listing.stable.frequency)
    yield digits(
        "arithmetic",
        "0.046",
        quoted,
        "%",
        second=close("the difference of logarithms", 100 * math.log(734.00 / 733.34), quoted, 1e-3),
        slip=made_here(
            "733.00 Hz is used for the simulated frequency, printed as 734.00",
            100 * abs(listing - 733.00) / 733.00,
        ),
    )
    yield digits(
        "error of the prediction",
        "0.046",
        error,
        "%",
        second=close(SECOND_WAY, second, error, 1e-6),
        slip=repeated(
            f"{ROUNDED}, and the simulated frequency is the nearest bin of 1 Hz", 100 * (listing / read - 1)
        ),
    )
    yield text(
        """
        From the two printed frequencies the error is [[ quoted | f3 ]] %, twice what is printed; with a
        simulated 733.00 Hz, which the text does not have, it is the printed 0.046 %. That is the bin in which
        the loop with rounded coefficients shows. The error of the prediction itself is [[ error | f4 ]] %.

        The agreement in frequency is better than a bin can show.
        """,
        quoted=quoted,
        error=error,
    )


@claim("txt-5.2.1-sampling", source="report/numbers/record.py")
def sampling(_: Evidence) -> Record:
    quotient = 10002300 / 1000231
    second = close("one over the time of 0.1 s", 1 / 0.1, quotient, 1e-5)
    yield digits("frequency resolution", "10", quotient, "Hz", second=second)
    yield text(
        """
        The quotient is right and equals one over the sampled time, so ten million samples a second add
        nothing to the resolution. Figure 5.9b does not have it: see the statement on the width of its peak.
        """
    )


@claim("txt-5.2.1-peak-width", source="report/numbers/record.py", impact=Impact.LOCAL)
def peak_width(known: Evidence) -> Record:
    peak = float(PEAK)
    nearest = STATED.nearest(peak)
    bins = np.fft.rfftfreq(STATED.samples, STATED.duration / (STATED.samples - 1))
    yield assertion(
        f"the peak at {PEAK} Hz",
        "it is a line of a spectrum whose lines are 10 Hz apart",
        abs(nearest - peak) < 0.005,
        filled(
            "the nearest line is at [[ nearest | f2 ]] Hz; one second has a line at [[ fine | f2 ]] Hz",
            nearest=nearest,
            fine=ONE_SECOND.nearest(peak),
        ),
        method="multiples of the sample rate over the number of samples",
        second=close("NumPy's bins", float(bins[np.argmin(np.abs(bins - peak))]), nearest),
    )
    yield text(
        """
        No line of such a spectrum lies within 3 Hz of 734 Hz, and a peak placed between lines would be at
        [[ exact | f2 ]] Hz. The spectrum of the figure is one over a second.

        The width of the peak is a tenth of what the text says.
        """,
        exact=known.orbits.friction.stable.frequency,
    )
