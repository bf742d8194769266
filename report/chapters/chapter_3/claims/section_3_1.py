"""Claims of section 3.1: resolution and bins of the measured spectra, and the sign of the output."""

from decimal import Decimal
from fractions import Fraction

from derivations import assumed
from derivations.state_space import output_row
from derivations.symbols import coordinates, velocities
from report.chapters.chapter_2.claims.trimmer_printed import output_matrix
from report.chapters.chapter_3.claims.measured_peaks import BIN, on_a_bin, tabulated
from report.judging.comparisons.printed import total
from report.judging.parts import assertion, close, digits, equal, expression, made_here, repeated, same, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.evidence import Evidence
from report.numbers.independent.loci import gains_where_phases_match
from report.numbers.independent.spectrum_bins import bins, fitting_samples
from report.numbers.proven import solutions_are_proven
from report.numbers.thesis import LARGE_GAP, SAMPLE_RATE
from trimmer import FrictionBacklash, limit_cycles

DURATION, RESOLUTION, FRAMES = "0.1", "10", "2000"  # Of the experiment's record, as printed: s, Hz, frames
STATED_FRAMES = int(FRAMES)
LENGTH = "2000 frames, length of the experiment's record"
OUTPUT = "y = x4 - x2, output map of section 3.1"
FEWEST, MOST = 1000, 4000  # Numbers of samples, at 20 kHz, among which a grid for the tables is sought


@claim("eq-3.1")
def distance_of_bins(_: Evidence) -> Record:
    rate, samples, frequency = assumed.positive("F_s N f")
    turns = frequency * samples / rate
    # The turns in a record are proportional to the frequency, and the lowest sine turns once.
    derived = frequency / turns
    stated = float(derived.subs({rate: SAMPLE_RATE, samples: STATED_FRAMES}))
    second = close("NumPy's bins for 2000 samples at 20 kHz", bins(STATED_FRAMES, SAMPLE_RATE)[1], stated)
    yield expression("", rate / samples, derived, left=r"\Delta f", second=second)
    yield text(r"""
        The lowest sine that repeats with the record turns once in $N$ samples, and the bins are its
        multiples. $\Delta f$ is the distance of bins: two peaks closer than a bin or two cannot be told
        apart, while a single peak can be placed better than that.
    """)


@claim("txt-3.1-resolution")
def resolution(_: Evidence) -> Record:
    frames = SAMPLE_RATE * Fraction(DURATION)
    second = equal("a count of the instants before 0.1 s", len(range(0, 100_000, 50)), frames)
    yield digits("frames in 0.1 s at 20 kHz", FRAMES, frames, second=second, item=LENGTH)
    second = close("NumPy's bins", bins(STATED_FRAMES, SAMPLE_RATE)[1], 1 / float(DURATION))
    yield digits("resolution", RESOLUTION, Fraction(SAMPLE_RATE, STATED_FRAMES), "Hz", second=second)
    yield text("""
        Both are right, and the resolution is one over the time of the record. The tables of section 3.2 hold
        one frame more, see [their bins](#txt-3.1-bins).
    """)


@claim("txt-3.1-bins")
def bins_of_the_tables(_: Evidence) -> Record:
    cells = tabulated()
    whole = [cell for cell in cells if on_a_bin(cell)]
    (frames,) = fitting_samples(whole, SAMPLE_RATE, FEWEST, MOST)
    by_numpy = {f"{each:.3f}" for each in bins(frames, SAMPLE_RATE)}
    rounded = f"NumPy's bins for {frames} frames, which {len(whole)} of the {len(cells)} cells are"
    yield digits(
        "frames whose bins the tables hold",
        FRAMES,
        frames,
        slip=repeated("the last frame, at the end of the time, is not counted", frames - 1),
        second=equal(rounded, sum(cell in by_numpy for cell in cells), len(whole)),
        item=LENGTH,
    )
    tens = sum(Decimal(cell) % 10 == 0 for cell in cells)
    misfits = ", ".join(sorted(set(cells) - set(whole)))
    yield text(f"""
        {len(whole)} of the {len(cells)} frequencies in tables 3.1 and 3.2 are, to every digit, multiples of
        {float(BIN):.4f} Hz, the bins of {frames} frames. {tens or "None"} is a multiple of {RESOLUTION} Hz,
        as the bins of {FRAMES} frames are. So the record seems to hold both of its ends, 0 and {DURATION} s.
        The others, {misfits}, are judged at [table 3.1](#tab-3.1) and [table 3.2](#tab-3.2).

        None: the resolution is {RESOLUTION} Hz either way. The three decimals are those of the bins, and each
        peak is known to half a bin.
    """)


@claim("txt-3.1-output-sign")
def sign_of_the_output(known: Evidence) -> Record:
    states = (*coordinates, *velocities)
    derived, listed = (
        sum(entry * state for entry, state in zip(row, states, strict=True))
        for row in (output_row(of=1, relative_to=3, size=len(coordinates)), output_matrix())
    )
    printed = total(coordinates[3], -coordinates[1])
    second = same("the matrix $C$ of equation 2.14 times the state", listed, derived)
    slip = made_here("the sign is turned", -derived)
    yield expression(
        "output map of the state space",
        printed,
        derived,
        left="y",
        second=second,
        slip=slip,
        printed_form="y = x_4 - x_2",
        derived_form="y = x_2 - x_4",
        item=OUTPUT,
        severity=Severity.SLIP,
    )
    plant = known.numbers.displacement_only
    right, turned = (limit_cycles(sign * plant, FrictionBacklash(1.0)) for sign in (1, -1))
    low, high = loop_gains_where_phases_match(known)
    solutions = f"{len(turned) or 'no'} solution"
    gain = f"the loop's gain, {low:.2f} to {high:.2f} wherever backlash undoes the lead of $G$"
    yield assertion(
        "in the loop of figure 2.5",
        "with the output of section 3.1 there are the limit cycles of section 5.2",
        len(turned) == len(right),
        f"harmonic balance has {solutions} with $x_4 - x_2$ and {len(right)} with $x_2 - x_4$",
        method="all solutions of harmonic balance for either sign",
        second=so(gain, not low <= 1 <= high),
        item=OUTPUT,
        severity=Severity.SLIP,
        certainty=Certainty.READING,
    )
    yield text(f"""
        Section 3.1 gives the output map as $x_4 - x_2$; equation 2.14 and Listing A.1 have $x_2 - x_4$. Read
        as a slip of the pen it has no effect: a measured spectrum does not see the sign, and chapter 5
        computes with the other one. This reading is the likelier one, as the sentence is about what the
        camera measures, and the card is graded by it. Read as the output of the loop it leaves no limit cycle
        with Listing A.1: backlash only lags, so with the sign turned $G$ would have to lead, which it does by
        little and with too large a gain.
        {solutions_are_proven("thesis-turned-sign", -plant, LARGE_GAP, turned)}

        Nothing in a trimmer leads from the output back to the pin, so neither sign is that of the device. The
        predicted limit cycles rest on this choice.
    """)


def loop_gains_where_phases_match(evidence: Evidence) -> tuple[float, float]:
    """Return the least and the largest |N G| where G leads by what backlash lags."""
    return gains_where_phases_match(evidence.numbers.displacement_only)
