"""Claims of section 5.2.5 on the limit cycle and the peaks with 0.6 N of friction."""

import math
from fractions import Fraction

from report.chapters.chapter_5.claims.section_5_2_4 import at_the_merger
from report.chapters.second_ways import NEWTON
from report.judging.claim import ClaimPart, Confirmation
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, equal, made_here, repeated, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.equivalent_nonlinearity import FORCE, EquivalentNumbers, NewtonSolution
from report.numbers.evidence import Evidence
from report.numbers.independent import limit_cycles
from report.numbers.listed_functions import equivalent_listing
from report.numbers.released_bodies import RECORD
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, RELEASED_PEAKS, SMALL_GAP
from trimmer import LimitCycle, response_at

PRINTED = "737.514"
LINE_18 = "line 18 of Listing A.6 is used for the friction term"
BY_LISTING = "all solutions of harmonic balance with the listing's function"
ONE_LIMIT_CYCLE = "one limit cycle with 0.6 N of friction and a gap of 4e-6 m"
DIFFERENCE = "0.5705 %, difference of 737.514 Hz to friction-controlled backlash"
"""Things that are printed in more than one place."""
DIED_OUT = 1e-9  # Share of the start that may be left of a motion that has died out


@claim("txt-5.2.5-difference")
def difference(_: Evidence) -> Record:
    percent = 100 * abs(737.514 - 733.33) / 733.33
    in_fractions = float(100 * (Fraction("737.514") / Fraction("733.33") - 1))
    second = close("exact fractions", in_fractions, percent)
    yield digits("arithmetic", "0.5705", percent, "%", second=second, item=DIFFERENCE)
    yield text("""
        The quotient of the two printed frequencies is right. The first of them comes from the [wrong friction
        term](#txt-5.2.5-coulomb-term).
    """)


def intersections_part(numbers: EquivalentNumbers) -> ClaimPart:
    """Return the part on the number of limit cycles, which the figure and the text share."""
    found, in_place = len(numbers.over_stiffness), numbers.in_place.limit_cycles(FORCE / SMALL_GAP)
    return digits(
        "limit cycles with 0.6 N of friction",
        "1",
        found,
        second=equal("friction between cutter and guard in its own place", in_place, found),
        slip=repeated(LINE_18, len(numbers.listing)),
        item=ONE_LIMIT_CYCLE,
    )


def frequency_part(numbers: EquivalentNumbers) -> ClaimPart:
    """Return the part on the frequency as the listings give it, which the figure and the text share."""
    (cycle,), (less_force,) = numbers.rounded, numbers.rounded_less_force
    _, by_newton = limit_cycles.equivalent_as_listed(cycle, FORCE, SMALL_GAP, DRIVE_OMEGA)
    slip = (
        "0.15 N, the force of figure 5.21, is used instead of 0.6 N, and the last digit is cut off; or the "
        "solver stopped early"
    )
    return digits(
        "frequency by Listings A.6 and A.9",
        PRINTED,
        cycle.frequency,
        "Hz",
        second=close(NEWTON, by_newton, cycle.omega),
        slip=made_here(slip, math.floor(1000 * less_force.frequency) / 1000),
        item="737.514 Hz, limit cycle predicted with 0.6 N of friction",
        severity=Severity.SLIP,
        certainty=Certainty.READING,
    )


def by_listing_a6(solution: LimitCycle | NewtonSolution, turning: float) -> complex:
    """Return N of Listing A.6 at a solution, with an angular frequency (rad/s) in its friction term."""
    return equivalent_listing(solution.amplitude, FORCE, SMALL_GAP, turning)


def loop_closes(known: Evidence, turning: float, element: complex) -> Confirmation:
    """Confirm a solution by the loop, with its angular frequency (rad/s) and the element's value there."""
    response = complex(response_at(known.numbers.displacement_only, turning))
    return close("$NG$ at that amplitude and frequency", element * response, -1)


@claim("txt-5.2.5-prediction")
def prediction(known: Evidence) -> Record:
    numbers = known.cycles.equivalent
    (rounded,), (listing,) = numbers.rounded, numbers.listing
    yield intersections_part(numbers)
    yield frequency_part(numbers)
    yield text(f"""
        With the right friction term there is no limit cycle at {FORCE} N: friction between cutter and guard
        ends it at {numbers.force_of_merger:.4f} N for this gap. The printed one comes from line 18 of Listing
        A.6, whose [friction term](#txt-5.2.5-coulomb-term) feeds the oscillation; the listings give
        {rounded.frequency:.3f} Hz. The printed last digits can be read in two ways. They come out with 0.15
        N, the force of figure 5.21, and the last one cut off; or the solver stopped early, as `fsolve` of
        Octave, with its usual tolerance, calls 736.589 to 737.517 Hz solved, depending on where it starts.
        Equation 5.14, which the text names as what is drawn, gives {numbers.as_printed.frequency:.0f} Hz.

        The comparison with 733.33 Hz, figures 5.23 and 5.24 and the peak of 736.993 Hz that is taken for this
        limit cycle lose their ground. Its amplitude of {1e3 * listing.amplitude:.1f} mm, which the text does
        not give, would have shown it.
    """)


@claim("txt-5.2.5-amplitude")
def amplitude(known: Evidence) -> Record:
    numbers, friction = known.cycles.equivalent, known.cycles.friction.stable
    (listing,) = numbers.listing
    without = SMALL_GAP * friction.amplitude
    growth, shift = listing.amplitude / without, listing.frequency / friction.frequency - 1
    yield assertion(
        "by Listing A.6",
        "the amplitude changes much, the frequency little",
        (growth > 10, abs(shift) < 0.01),
        f"""
        from {1e6 * without:.1f} µm without friction to {1e3 * listing.amplitude:.1f} mm at {FORCE} N,
        {growth:.0f} times; the frequency rises by {100 * shift:.2f} %
        """,
        method=BY_LISTING,
        second=loop_closes(known, listing.omega, by_listing_a6(listing, DRIVE_OMEGA)),
    )
    last = 1e6 * SMALL_GAP * numbers.in_place.merger.amplitude
    yield assertion(
        "with the right friction term",
        "a limit cycle with another amplitude is left at 0.6 N",
        numbers.in_place.limit_cycles(FORCE / SMALL_GAP) > 0,
        f"""
        the amplitude falls from {1e6 * without:.1f} µm to {last:.1f} µm at {numbers.force_of_merger:.4f} N;
        beyond that force there is no limit cycle
        """,
        method="all solutions of harmonic balance, friction between cutter and guard",
        second=at_the_merger(known),
        slip=repeated(LINE_18, len(numbers.listing) > 0),
        item=ONE_LIMIT_CYCLE,
    )
    yield text(f"""
        The text says that the amplitude has changed much, and gives none. Its own function makes it
        {listing.amplitude / DRIVE_AMPLITUDE:.0f} times that of the pin, and larger still with more friction.
        The right term acts the other way: friction makes the oscillation smaller and then ends it.

        The section's model contradicts the conclusion of section 3.3 and chapter 7 that friction suppresses
        the limit cycle; the right one supports it.
    """)


def peak_parts(known: Evidence, prefix: str = "") -> tuple[ClaimPart, ...]:
    """Return a part for each peak, and one on what the highest of them is."""
    numbers, branch = known.motion.closed.released_bodies, known.cycles.equivalent.in_place
    read = [RECORD.frequency(number) for number in numbers.runs[0].peaks]
    parts = []
    for number, printed, frequency, mode in zip((1, 2, 3), RELEASED_PEAKS, read, numbers.modes, strict=False):
        label = f"{prefix}peak {number} of {RECORD.duration:.0f} s, all bodies released alike"
        second = close(f"natural mode {number} of the loop without play and friction", mode, frequency, 2e-3)
        shown = f"{frequency:.3f}"
        slip = made_here("the last two digits are exchanged", float(shown[:-2] + shown[-1] + shown[-2]))
        item = f"{printed} Hz, peak of the spectrum with 0.6 N of friction"
        severity = Severity.SLIP
        parts.append(
            digits(label, printed, frequency, "Hz", second=second, slip=slip, item=item, severity=severity)
        )
    left = max(run.left / run.displacement for run in numbers.runs)
    reading = assertion(
        f"{prefix}what the peak at {RELEASED_PEAKS[2]} Hz is",
        f"with {FORCE} N of friction the loop has a limit cycle, which shows there",
        left > DIED_OUT,
        f"""
        the motion dies out: at the end of the record less than {power_of(DIED_OUT)} of the start is left.
        With a gap of 4 µm a limit cycle lasts up to {known.cycles.equivalent.force_of_merger:.3f} N;
        the peak is the third natural mode of the loop, {numbers.modes[2]:.2f} Hz
        """,
        method="exact simulation with true stick",
        second=so("harmonic balance over all forces", branch.limit_cycles(FORCE / SMALL_GAP) == 0),
        item="736.993 Hz, peak read as the limit cycle with 0.6 N of friction",
        severity=Severity.RESULT,
    )
    return (*parts, reading)


@claim("txt-5.2.5-fft")
def peaks(known: Evidence) -> Record:
    numbers = known.motion.closed.released_bodies
    modes, (_, second, third) = numbers.modes, map(float, RELEASED_PEAKS)
    apart = abs(2 * second - third) / RECORD.bin_width
    yield from peak_parts(known)
    yield assertion(
        f"what the peak at {RELEASED_PEAKS[1]} Hz is",
        f"it is a harmonic of the one at {RELEASED_PEAKS[2]} Hz",
        apart < 1,
        f"""
        twice {RELEASED_PEAKS[1]} Hz is {apart:.0f} bins away from {RELEASED_PEAKS[2]} Hz; harmonics lie
        above, and odd elements make odd ones. It is the second natural mode, {modes[1]:.2f} Hz
        """,
        method="the printed frequencies and bins",
        second=close("the natural modes of the loop", modes[1], second, 2e-3),
    )
    yield text(f"""
        All three are free vibrations of the closed loop without play and friction, at {modes[0]:.2f},
        {modes[1]:.2f} and {modes[2]:.2f} Hz, each in its line of a spectrum over one second; in the first
        number two digits are exchanged. The start is not given. With all four bodies displaced alike, by
        {numbers.runs[0].displacement:g} to {numbers.runs[-1].displacement:g} m, which is our guess, these are
        the three largest peaks. A start so much larger than the gap leaves nothing of play or friction in
        them.

        That 736.993 Hz agrees with the predicted 737.514 Hz is no evidence for the equivalent nonlinearity:
        both are nearly the frequency at which $G$ passes by $-1$.
    """)
