"""Claims on the figures of section 5.2 that show simulations: 5.7, 5.9, 5.11, 5.12, 5.14, 5.19 and 5.20."""

import math

from report.chapters.chapter_5.claims import section_5_2_4
from report.chapters.chapter_5.claims.section_5_2_1_driven import REPEATS, line_part, open_loop, size_part
from report.chapters.chapter_5.claims.section_5_2_1_impulses import one_impulse_part
from report.chapters.chapter_5.claims.section_5_2_1_simulated import peak_part as peak_of_friction
from report.chapters.chapter_5.claims.section_5_2_2_simulated import peak_parts as peaks_of_inertia
from report.chapters.second_ways import TWO_DURATIONS, by_harmonics
from report.judging.claim import Confirmation
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, repeated, so
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent.relay_and_friction import SETTLED_AFTER, difference_of_last_periods
from report.numbers.relay_loop import VISCOUS
from report.numbers.thesis import RELAY_LEVEL, ROUNDED, SMALL_GAP
from trimmer import FrictionBacklash, harmonic_leakage

STANDS_OUT = 0.01  # Share of the largest line below which another does not show beside it
UNIT = 1e-8  # Unit of the last digit of the reading 3.303e-5, m
BY_COEFFICIENTS = "Fourier coefficients of the exact orbit"


@claim("fig-5.7")
def three_gaps(known: Evidence) -> Record:
    runs = known.motion.closed.impulses.runs
    strong = [run for run in runs if run.impulse == runs[0].impulse]
    sizes = [run.amplitude / run.gap for run in strong]
    exact = known.orbits.friction.stable.amplitude
    yield one_impulse_part(known)
    amplitudes = " and ".join(f"{1e9 * run.amplitude:.1f} nm" for run in strong[1:])
    yield assertion(
        r"for $2\times10^{-8}$ and $3\times10^{-8}$ m",
        "a very small oscillation goes on, and a larger one",
        (strong[1].amplitude < strong[2].amplitude, min(sizes) > 1),
        f"after {power_of(strong[0].impulse)} m s it is {amplitudes}, {sizes[0]:.3f} gaps each",
        method="exact simulation of the three gaps with one impulse",
        second=close("the exact orbit, by shooting", exact, sizes[0], 1e-4),
    )
    yield text(r"""
        After one impulse the three panels can only be one curve at three scales; if one of them dies out, it
        is that of the largest gap. A first panel without oscillation takes another impulse, or a scale on
        which the smallest of 1 : 2 : 3 does not show; see the [text on this
        simulation](#txt-5.2.1-impulse-1e-8).

        The threshold of $2\times10^{-8}$ m has no support in simulation.
    """)


def others_by_balance(known: Evidence) -> Confirmation:
    """Confirm by the element's harmonics that none stands out beside the first."""
    cycle = known.cycles.friction.stable
    largest = max(harmonic_leakage(known.numbers.displacement_only, FrictionBacklash(1.0), cycle))
    means = f"the element's harmonics times the response, at most {100 * largest:.2f} %"
    return so(means, largest < STANDS_OUT)


@claim("fig-5.9")
def small_gap(known: Evidence) -> Record:
    orbits = known.orbits
    exact, rounded = (
        SMALL_GAP * pair.stable.amplitude for pair in (orbits.friction, orbits.friction_listing)
    )
    sizes = abs(orbits.friction.stable.harmonics)
    second = close(TWO_DURATIONS, SMALL_GAP * orbits.friction_by_durations[0], exact)
    slip = repeated(f"{ROUNDED}, and the last digit is cut off", UNIT * math.floor(rounded / UNIT))
    yield digits("a: upper reading", "3.303e-5", exact, "m", second=second, slip=slip)
    yield digits("a: lower reading", "-3.2961e-5", -exact, "m", second=second)
    yield peak_of_friction(orbits, "b: peak")
    yield assertion(
        "b: number of peaks",
        "a single peak stands out",
        bool(sizes[1:].max() < STANDS_OUT * sizes[0]),
        f"the next one, the third harmonic, has {100 * sizes[2] / sizes[0]:.2f} % of the first",
        method=BY_COEFFICIENTS,
        second=others_by_balance(known),
    )
    yield text(f"""
        The exact oscillation is its own mirror image half a period later, so both readings should be
        {power_of(exact, 4)} m. The upper one is what rounded coefficients give, {power_of(rounded, 4)} m, cut
        after four digits. The lower one is {100 * (1 - 3.2961e-5 / 3.303e-5):.1f} % smaller: it misses the
        peak, or the motion had not settled. That one line stands out is right, since this limit cycle is
        nearly a sine.

        The amplitude of the simulation is {100 * (exact / 3.29955e-5 - 1):.1f} % off, more than the
        prediction that it tests.
    """)


@claim("fig-5.11")
def driven_response(known: Evidence) -> Record:
    closed = known.motion.closed.reference.from_rest
    yield size_part(known, "output of the linear block")
    yield text(f"""
        The text describes ±1 mm with an oscillation on top. The whole output of the loop with the drive as
        its reference is of that size: {1e3 * closed.base:.2f} mm at 100 Hz and {1e3 * closed.line:.2f} mm at
        {closed.frequency:.1f} Hz. Behind an open loop the output is the drive, with harmonics of
        {1e6 * open_loop(known).ripple:.0f} µm. Read as a rough 1.5 mm, which the text says it corresponds to,
        the base is that of the open loop; see the [text on this figure](#txt-5.2.1-open-loop-output).

        In the first reading it is no picture of the driven trimmer, whose output is not fed back to the pin.
    """)


@claim("fig-5.12")
def driven_spectrum(known: Evidence) -> Record:
    sizes = abs(known.orbits.friction.stable.harmonics)
    others = float(sizes[1:].max() / sizes[0])
    yield assertion(
        "a: closed loop",
        "one line stands out, that of the limit cycle",
        others < STANDS_OUT,
        f"all others have less than {100 * others:.2f} % of it",
        method=BY_COEFFICIENTS,
        second=others_by_balance(known),
    )
    yield line_part(known, "b: the second line of the driven loop")
    yield text("""
        Part a is right. Part b is called open loop, but its second line, at the limit cycle's frequency,
        needs the output to be fed back. That the gaps of the two parts differ by a factor of ten changes
        nothing in frequency.

        The text concludes from this figure that the two configurations are equivalent. They are not.
    """)


@claim("fig-5.14")
def inertia(known: Evidence) -> Record:
    read, size = known.motion.closed.timed_block.largest_other_line
    yield from peaks_of_inertia(known)
    yield text(f"""
        As for friction-controlled backlash, what is printed belongs to a closed loop with the drive as
        reference, here with the block of Listing A.8 in it. Beside multiples of 100 Hz its largest line
        stands at {read:.1f} Hz, with {1e6 * size:.0f} µm. The open loop has no such line.

        See the [peak at 659 Hz](#txt-5.2.2-open-loop-659) in section 5.2.2.
    """)


@claim("fig-5.19")
def relay(known: Evidence) -> Record:
    decay = max(mode.eigenvalue.real for mode in known.numbers.modes)
    means = f"exact simulation, whose last two of {SETTLED_AFTER} periods are alike"
    difference = difference_of_last_periods(known.numbers.parameters, RELAY_LEVEL)
    yield section_5_2_4.relay_part(known.motion.closed.relay, "relay of 0.015 in the loop")
    yield assertion(
        "in open loop, as the caption has it",
        "an oscillation besides the drive's harmonics goes on",
        decay >= 0,
        rf"""
        a relay turns a sine into a square wave of the same period, and behind it free motions decay as
        $e^{{{decay:.0f}\,t}}$ or faster
        """,
        method="periodic input of a stable linear system",
        second=so(means, difference < REPEATS),
        item=section_5_2_4.OSCILLATION,
    )
    yield text("""
        The caption says open loop, the text says feedback; neither has a limit cycle. Behind a relay in open
        loop stand odd multiples of the drive. In the loop the relay oscillates ever faster with ever smaller
        swings, so a simulation ends with what its step or tolerance leaves.

        See the [high frequency](#txt-5.2.4-high-frequency) in section 5.2.4.
    """)


@claim("fig-5.20")
def relay_and_viscous(known: Evidence) -> Record:
    numbers = known.motion.closed.relay
    viscous = numbers.with_viscous
    item = "an oscillation of high frequency with Coulomb and viscous friction"
    yield section_5_2_4.candidates_part(
        viscous,
        "the block on the output, as a relay with a gain of 0.1",
        "a periodic oscillation goes on",
        by_harmonics(known.numbers.displacement_only, viscous.frequencies, VISCOUS),
        item,
    )
    yield section_5_2_4.friction_part(numbers, "the block on the output's velocity, as friction", item)
    yield text("""
        The text does not say which signal enters the block. On the output it is a relay with a small gain,
        and there is no periodic motion with two switchings. On the output's velocity it is friction, and the
        loop sticks or creeps to rest. A lasting high frequency is again the simulation's own.

        The second simulation does not confirm the first.
    """)
