"""Claims of section 5.2.1 on predictions for friction-controlled backlash (tables 5.1 and 5.2)."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from report.chapters.second_ways import LOEB, NEWTON, by_floquet, by_waveform
from report.judging.claim import ClaimPart, Confirmation
from report.judging.comparisons.printed import power, power_of
from report.judging.parts import assertion, close, digits, made_here, repeated
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence
from report.numbers.independent.limit_cycles import friction_exactly
from report.numbers.proven import orbit_is_proven, solutions_are_proven
from report.numbers.thesis import LARGE_GAP, PLOT_OFFSET, ROUNDED, SMALL_GAP
from trimmer import FrictionBacklash, LimitCycle, limit_cycles

SCALING = "scaling of the describing function in the gap"
TINY_GAP = 2e-11
FREQUENCY = "733.33 Hz, limit cycle predicted for friction-controlled backlash"
AMPLITUDE = "3.3138e-5 m, amplitude predicted for friction-controlled backlash"
SECOND_AMPLITUDE = "2.1089e-5 m, second limit cycle of friction-controlled backlash"
SECOND_ONLY_LATER = "a single limit cycle for 4e-6 m, a second one for a larger gap"
"""Things that are printed in more than one place."""
TABLE_5_2 = {
    **{"1e-4": "0.00083", "2e-4": "0.0017", "3e-4": "0.0025", "4e-4": "0.0033", "5e-4": "0.0041"},
    **{"6e-4": "0.0050", "7e-4": "0.0058", "8e-4": "0.0066", "9e-4": "0.0075", "1e-3": "0.0083"},
}
"""Amplitude for each gap, m."""


@dataclass(frozen=True)
class Predicted:
    """A limit cycle with exact coefficients, with those of Listing A.9, and the first in a second way.

    The latter as amplitude over gap, and angular frequency in rad/s.
    """

    exact: LimitCycle
    listing: LimitCycle
    ratio: float
    omega: float


def predicted(known: Evidence) -> tuple[Predicted, Predicted]:
    """Return the unstable and the stable limit cycle for a gap of one metre."""
    exact, listing = known.cycles.friction, known.cycles.friction_listing
    unstable, stable = (
        Predicted(cycle, rounded, *friction_exactly(known.numbers, cycle))
        for cycle, rounded in ((exact.unstable, listing.unstable), (exact.stable, listing.stable))
    )
    return unstable, stable


def amplitude_part(label: str, printed: str, gap: float, of: Predicted, item: str) -> ClaimPart:
    derived = gap * of.exact.amplitude
    second, slip = close(NEWTON, gap * of.ratio, derived), repeated(ROUNDED, gap * of.listing.amplitude)
    return digits(label, printed, derived, "m", second=second, slip=slip, item=item)


def all_parts(
    prefix: str, gap: float, of: Predicted, printed: tuple[str, str, str], item: str
) -> Iterator[ClaimPart]:
    """Yield the parts on amplitude (m), angular frequency and frequency, which are printed in this order.

    ``item`` is that of the amplitude; the two frequencies are one printed thing wherever they stand.
    """
    exact, listing = of.exact, of.listing
    amplitude, omega, frequency = printed
    second = close(NEWTON, of.omega, exact.omega)
    yield amplitude_part(f"{prefix}amplitude", amplitude, gap, of, item)
    label, slip = f"{prefix}angular frequency", repeated(ROUNDED, listing.omega)
    yield digits(label, omega, exact.omega, "rad/s", second=second, slip=slip, item=FREQUENCY)
    label, slip = f"{prefix}frequency", repeated(ROUNDED, listing.frequency)
    yield digits(label, frequency, exact.frequency, "Hz", second=second, slip=slip, item=FREQUENCY)


def second_frequency(label: str, unstable: Predicted) -> ClaimPart:
    """Return the part on the frequency of the second limit cycle, printed with one digit wrong."""
    exact, listed = unstable.exact, f"{unstable.listing.frequency:.2f}"
    name = f"{ROUNDED}, and the second digit is written 3 instead of 5"
    slip = made_here(name, float(f"{listed[0]}3{listed[2:]}"))
    second = close(NEWTON, unstable.omega, exact.omega)
    item = "533.22 Hz, second limit cycle of friction-controlled backlash"
    return digits(label, "533.22", exact.frequency, "Hz", second=second, slip=slip, item=item)


@claim("txt-5.2.1-prediction")
def prediction(known: Evidence) -> Record:
    _, stable = predicted(known)
    right, listing, both = stable.exact, stable.listing, known.cycles.friction_both_channels.stable
    yield from all_parts("", SMALL_GAP, stable, ("3.3138e-05", "4.6077e+03", "733.3"), AMPLITUDE)
    shift = 100 * (listing.amplitude / right.amplitude - 1)
    less = 100 * (1 - both.amplitude / right.amplitude)
    yield text(f"""
        The printed numbers come out with the coefficients that Listing A.9 rounds to four digits. With exact
        ones the prediction is $A = {1e6 * SMALL_GAP * right.amplitude:.4f}$ µm at {right.frequency:.2f} Hz.
        Rounding moves the amplitude by as much as {shift:.2f} %, because the loop passes close to $-1$.

        Every prediction of section 5.2.1 carries this small shift. The velocity of the pin, which the loop
        leaves out, weighs far more: with it the amplitude is {1e6 * SMALL_GAP * both.amplitude:.2f} µm,
        {less:.0f} % less, at {both.frequency:.2f} Hz.
    """)


@claim("txt-5.2.1-stable")
def stability(known: Evidence) -> Record:
    cycle, orbit = known.cycles.friction.stable, known.orbits.friction.stable
    largest = abs(orbit.nontrivial_multipliers).max()
    statement, item = "the predicted limit cycle is stable", "the limit cycle near 733 Hz is stable"
    criterion = f"Loeb's criterion at {cycle.frequency:.2f} Hz"
    outward = "a motion that starts 0.1 % outside the unstable orbit ends on it"
    floquet = by_floquet([orbit], stable=True)
    label, holds = "by the describing function", bool(cycle.stable)
    yield assertion(label, statement, holds, criterion, method=LOEB, second=floquet, item=item)
    yield assertion(
        "in the exact loop",
        statement,
        orbit.stable,
        f"""
        no disturbance keeps more than {largest:.4f} of itself over a period of the orbit at
        {orbit.frequency:.2f} Hz
        """,
        method="Floquet multipliers of the exact orbit",
        second=close(outward, known.orbits.left_by[1], orbit.amplitude, 1e-5),
        item=item,
    )
    yield text(f"""
        A larger amplitude moves $-1/N$ out of the locus, so the oscillation shrinks again; a smaller one
        grows. That is the thesis's own argument on the describing function, and the multipliers of the exact
        limit cycle agree. Disturbances decay slowly, at {-math.log(largest) / orbit.period:.0f}/s.
        {orbit_is_proven("thesis-stable-orbit", orbit)}
    """)


@claim("txt-5.2.1-second-limit-cycle")
def second_limit_cycle(known: Evidence) -> Record:
    unstable, _ = predicted(known)
    right, cycles = unstable.exact, known.cycles
    yield amplitude_part("amplitude", "2.1089e-5", LARGE_GAP, unstable, SECOND_AMPLITUDE)
    yield second_frequency("frequency", unstable)
    second = by_floquet([known.orbits.friction.unstable], stable=False)
    holds = not right.stable
    yield assertion("stability", "it is unstable", holds, "Loeb's criterion", method=LOEB, second=second)
    yield assertion(
        "when it appears",
        "it is there only when the gap is large enough",
        len(limit_cycles(cycles.listing, FrictionBacklash(TINY_GAP))) < 2,
        rf"it has $A = {right.amplitude:.4f}\,b$ for every gap, since $N$ depends on $b/A$ alone",
        method=SCALING,
        second=at_the_tiny_gap(known, right),
        item=SECOND_ONLY_LATER,
        severity=Severity.RESULT,
        certainty=Certainty.PROVEN,
    )
    yield text(rf"""
        Scaling gap and amplitude by one factor changes nothing in $1 + NG = 0$, so both limit cycles exist
        for every gap or for none. The second one lies just above the edge of the dead band, $A = b/2$.
        Listing A.9 plots the curve from $b/2 + 10^{{-6}}$ m on, and so shows it only for gaps above
        {power_of(PLOT_OFFSET / (right.amplitude - 0.5), 1)} m: for $4\times10^{{-5}}$ m, but not for
        $4\times10^{{-6}}$ m. {orbit_is_proven("thesis-unstable-orbit", known.orbits.friction.unstable)}

        A trimmer with a small gap has the same two limit cycles as one with a large gap, in proportion. The
        unstable one is a threshold: what starts below it decays.
    """)


@claim("tab-5.1")
def two_limit_cycles(known: Evidence) -> Record:
    unstable, stable = predicted(known)
    listed = stable.listing.frequency
    name = f"{ROUNDED}, and the {listed:.4f} Hz that follow are cut off, not rounded"
    slip = repeated(name, math.floor(100 * listed) / 100)
    second = close(NEWTON, stable.omega, stable.exact.omega)
    yield amplitude_part("first: amplitude", "3.3138e-4", LARGE_GAP, stable, AMPLITUDE)
    label, derived = "first: frequency", stable.exact.frequency
    plant = known.numbers.displacement_only
    yield digits(label, "733.33", derived, "Hz", second=second, slip=slip, item=FREQUENCY)
    yield amplitude_part("second: amplitude", "2.1089e-5", LARGE_GAP, unstable, SECOND_AMPLITUDE)
    yield second_frequency("second: frequency", unstable)
    yield text(f"""
        With the coefficients of Listing A.9 the second limit cycle lies at {unstable.listing.frequency:.2f}
        Hz, with exact ones at {unstable.exact.frequency:.2f} Hz; the printed 533.22 Hz has one digit wrong,
        here and in the text. The other cells come out with the rounded coefficients. For 733.33 Hz a number
        was cut off as well; the section's percent error has it rounded, as 733.34 Hz.
        {solutions_are_proven("thesis-limit-cycles", plant, LARGE_GAP, [unstable.exact, stable.exact])}

        None: the comparisons of the section rest on the first limit cycle.
    """)


@claim("tab-5.2")
def ten_gaps(known: Evidence) -> Record:
    _, stable = predicted(known)
    for gap, printed in TABLE_5_2.items():
        item = f"{printed} m, amplitude for b = {gap} m in table 5.2"
        yield from all_parts(f"$b$ = {power(gap)} m, ", float(gap), stable, (printed, "4.6e3", "733"), item)
    yield text(rf"""
        Every amplitude is {stable.exact.amplitude:.4f} times the gap and every frequency
        {stable.exact.frequency:.2f} Hz, in any row. With the rounded coefficients of Listing A.9 they are
        {stable.listing.amplitude:.4f} gaps and {stable.listing.frequency:.2f} Hz, which gives all printed
        cells. With exact ones the amplitudes for $5\times10^{{-4}}$ m and $8\times10^{{-4}}$ m and the
        frequencies round to another last digit.

        None beyond the last digit. The ten rows hold one result, since only the scale changes.
    """)


def at_the_tiny_gap(known: Evidence, cycle: LimitCycle) -> Confirmation:
    """Confirm that a limit cycle, scaled down, is one of a tiny gap: by the waveform, sampled there."""
    scaled = replace(cycle, amplitude=cycle.amplitude * TINY_GAP)
    return by_waveform(known.numbers.displacement_only, [(FrictionBacklash(TINY_GAP), scaled)])
