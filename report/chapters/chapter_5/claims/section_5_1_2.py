"""Claims of section 5.1.2 on the frequency response: locus, filtering, cutoff (figures 5.2 and 5.3)."""

import math

import control
import numpy as np

from report.chapters.second_ways import EXACTLY
from report.judging.claim import ClaimPart
from report.judging.parts import assertion, close, digits, equal, made_here, repeated, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent import linear_trimmer
from report.numbers.independent.exact_response import gain, gain_crossing, gain_ratio
from report.numbers.linear_numbers import LinearNumbers
from report.numbers.thesis import DRIVE_OMEGA, LIMIT_CYCLE_OMEGA, MEASURED_DRIVE_FREQUENCY, TURN
from trimmer import resonance_peaks
from trimmer.linear import (
    asymptotic_roll_off,
    bandwidth_crossings,
    encirclements,
    filtering_ratio,
    gain_crossings,
    local_slope,
)

MUCH_SMALLER = 0.1
HARMONICS = range(2, 40)
CLEAR = 2.0  # Gain above which a peak is clearly visible
ROLL_OFF_FROM = 4700.0  # Angular frequency above which the slope of the gain is examined, rad/s
HIGH_OMEGA = 1e8


def no_encirclement_part(numbers: LinearNumbers) -> ClaimPart:
    system = numbers.displacement_only
    turns = encirclements(system, -1.0)
    second = equal("python-control's Nyquist count", control.nyquist_response(system).count, turns)
    item = "0 encirclements of -1 by the Nyquist locus"
    return digits("encirclements of $-1$", "0", turns, second=second, item=item)


@claim("txt-5.1.2-nyquist")
def nyquist(known: Evidence) -> Record:
    unstable = control.tf([0.5], [1, -1])
    silent = encirclements(unstable, -1.0) == 0
    open_loop_stable = all(pole.real < 0 for pole in unstable.poles())
    means = "python-control's Nyquist count of it, zero, and its response to an impulse, which grows"
    yield no_encirclement_part(known.numbers)
    yield assertion(
        "the conclusion drawn",
        "a locus that does not encircle $-1$ shows that the open loop is stable",
        not silent or open_loop_stable,
        """
        $0.5/(s - 1)$ does not encircle $-1$ and is unstable. The count gives unstable poles of the closed
        loop, and needs those of the open loop to be known
        """,
        method="counterexample",
        second=so(
            means,
            (control.nyquist_response(unstable).count == 0, linear_trimmer.impulse_response_grows(unstable)),
        ),
        certainty=Certainty.PROVEN,
    )
    yield text("""
        The count is right, the conclusion is not. The open loop has no unstable pole, as its eigenvalues
        show; without an encirclement it is then the closed loop with unit gain that is stable.

        None, since the open loop is stable by equation 5.2. The right conclusion matters later: unit gain
        is the limit of a small gap, so the trimmer without play is stable in the thesis's loop.
    """)


@claim("fig-5.3")
def nyquist_locus(known: Evidence) -> Record:
    yield no_encirclement_part(known.numbers)
    yield text("""
        The redrawn locus passes close by $-1$ and does not go round it, as the text reads from it. It meets
        the real axis on the positive side only, so every positive gain would leave the loop stable.
    """)


@claim("txt-5.1.2-filtering")
def filtering(known: Evidence) -> Record:
    numbers, system = known.numbers, known.numbers.displacement_only
    measured = TURN * MEASURED_DRIVE_FREQUENCY
    third = float(filtering_ratio(system, LIMIT_CYCLE_OMEGA, 3))
    fifth = float(filtering_ratio(system, DRIVE_OMEGA, 5))
    item = "the filtering hypothesis is satisfied"
    every = linear_trimmer.highest_unfiltered(system, HARMONICS)
    yield assertion(
        f"at the predicted limit cycle, {LIMIT_CYCLE_OMEGA} rad/s",
        f"every odd harmonic is passed at most {MUCH_SMALLER:g} times as well",
        third <= MUCH_SMALLER,
        rf"$|G(3j\omega)|/|G(j\omega)| = {third:.4f}$, higher ones less",
        method="frequency response",
        second=close(EXACTLY, gain_ratio(numbers, LIMIT_CYCLE_OMEGA, 3), third),
        item=item,
    )
    odd = linear_trimmer.highest_unfiltered(system, range(3, 40, 2))
    yield assertion(
        "at every frequency, as equation 2.26 asks",
        r"$|G(j\omega)| \gg |G(jn\omega)|$ for $n = 2, 3, \dots$",
        every == 0.0,
        f"""
        below {every:.1f} Hz some harmonic passes better than the fundamental (odd ones: below {odd:.1f} Hz);
        at the drive's 100 Hz the fifth passes {fifth:.2f} times better
        """,
        method=f"search over 10 Hz to 2 kHz, harmonics up to {HARMONICS[-1]}",
        second=close(EXACTLY, gain_ratio(numbers, DRIVE_OMEGA, 5), fifth),
        item=item,
        certainty=Certainty.READING,
    )
    second = float(filtering_ratio(system, LIMIT_CYCLE_OMEGA, 2))
    fifth_measured = float(filtering_ratio(system, measured, 5))
    highest = max(resonance_peaks(system), key=lambda peak: peak.magnitude).omega / TURN
    yield text(f"""
        The text does not say at which frequency. Where the limit cycle is predicted, the hypothesis holds:
        the third harmonic passes {third:.3f} times as well as the fundamental, the second {second:.3f} times.
        At every frequency it does not: at 100 Hz the fifth harmonic passes {fifth:.1f} times better than the
        drive itself. In this model, whose parameters are not those of the measured trimmer (table C.1 is not
        given), it would be {fifth_measured:.0f} times at the measured {MEASURED_DRIVE_FREQUENCY} Hz.

        Predictions of limit cycles near {LIMIT_CYCLE_OMEGA / TURN:.0f} Hz keep their basis. A describing
        function must not be used at the drive's frequency. In driven spectra a harmonic near {highest:.0f} Hz
        stands out without any limit cycle.
    """)


@claim("fig-5.2")
def bode_plot(known: Evidence) -> Record:
    numbers = known.numbers
    peaks = resonance_peaks(numbers.displacement_only)
    clear = [peak for peak in peaks if peak.magnitude > CLEAR]
    on_grid = linear_trimmer.peaks_on_grid(numbers.numerator, numbers.denominator, CLEAR)
    second = equal("the gain on a grid of 0.5 rad/s", on_grid, len(clear))
    label = "peaks that are clearly visible (more than twice the pin's motion)"
    yield digits(label, "2", len(clear), second=second)
    yield text(f"""
        The redrawn plot shows the two clear peaks, at {clear[0].omega:.1f} and {clear[1].omega:.1f} rad/s,
        and two faint ones, at {peaks[0].omega:.1f} and {peaks[1].omega:.1f} rad/s, on either side of a
        shallow valley. What the text reads from it about slope and cutoff is judged under those statements.
    """)


@claim("txt-5.1.2-cutoff")
def cutoff(known: Evidence) -> Record:
    numbers = known.numbers
    unity = gain_crossings(numbers.displacement_only)[-1]
    first, *_, last = bandwidth_crossings(numbers.displacement_only)
    level = float(gain(numbers, 0)) * 10 ** (-3 / 20)
    slip = repeated("the highest frequency with |G| = 1 (0 dB) is taken", unity)
    item, root = "4.6329e+03 rad/s, cutoff frequency", "a root search on exact coefficients"
    readings = (
        ("as the highest frequency with $|G| = 1$", unity, 1.0, None),
        ("as the highest frequency 3 dB below the static gain", last, level, slip),
    )
    for label, omega, height, wrong in readings:
        second = close(root, gain_crossing(numbers, height, omega), omega)
        yield digits(label, "4.6329e+03", omega, "rad/s", second=second, slip=wrong, item=item)
    yield text(f"""
        The printed number is the highest frequency at which $|G| = 1$; above it the output is smaller than
        the input. As a rule the cutoff is where the gain is 3 dB below its static value. That is so first at
        {first:.1f} rad/s, in the valley between two resonances, and last at {last:.1f} rad/s.

        The number is not used again. It lies {100 * (unity / LIMIT_CYCLE_OMEGA - 1):.1f} % above the
        predicted limit cycle, and not by accident: where the play is small beside the amplitude, $|N|$ and so
        $|G|$ are close to one.
    """)


@claim("txt-5.1.2-roll-off")
def roll_off(known: Evidence) -> Record:
    numbers = known.numbers
    slope = asymptotic_roll_off(numbers.displacement_only)
    chord = 20 * math.log10(gain_ratio(numbers, 1e3, 10))
    steepness = local_slope(numbers.displacement_only, np.geomspace(ROLL_OFF_FROM, HIGH_OMEGA, 4000))
    far = 20 * math.log10(gain_ratio(numbers, HIGH_OMEGA, 10))
    misread = "the fall over the decade from $10^{3}$ to $10^{4}$ rad/s is read as the slope"
    second = close("the slope of the exact gain at $10^{8}$ rad/s", far, slope, 1e-6)
    item = "order 1 and -20 dB per decade, roll-off of the transfer function"
    slip = made_here(misread, chord)
    yield digits("roll-off", "-20", slope, "dB/decade", second=second, slip=slip, item=item)
    degrees = len(numbers.denominator) - len(numbers.numerator)
    second = equal("the degrees of the polynomials", degrees, -slope / 20)
    slip = made_here(misread, -chord / 20)
    yield digits("filter order", "1", -slope / 20, second=second, slip=slip, item=item)
    with_velocity = asymptotic_roll_off(numbers.both_channels)
    corner = numbers.parameters.k2 / numbers.parameters.c2
    yield text(f"""
        The transfer function has two poles more than zeros, so in the end the gain falls by {-slope:.0f} dB
        per decade. Above {ROLL_OFF_FROM:.0f} rad/s it falls nowhere by less than
        {-float(steepness.max()):.1f}. From $10^3$ to $10^4$ rad/s the curve as a whole drops by {-chord:.1f}
        dB, which may have been read as the slope.

        The linear part filters better than the thesis says; section 6.2 calls it on the edge of filtering,
        for its order of 1. With the pin's velocity as second input the slope is {with_velocity:.0f} dB per
        decade, but only far above {corner:.0f} rad/s.
    """)
