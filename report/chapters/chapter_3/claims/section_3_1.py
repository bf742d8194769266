"""Claims of section 3.1: resolution and bins of the measured spectra, and the sign of the output."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction

import sympy

from derivations.state_space import output_row
from derivations.symbols import coordinates, velocities
from report.chapters.chapter_2.claims.trimmer_printed import output_matrix
from report.chapters.chapter_3.claims.measured_peaks import BIN, on_a_bin, tabulated
from report.claim import Impact
from report.comparisons.printed import total
from report.evidence import Evidence
from report.numbers.independent.loci import gains_where_phases_match
from report.numbers.independent.spectrum_bins import bins, fitting_samples
from report.parts import assertion, close, digits, equal, expression, made_here, same, so
from report.record import Record, claim, text
from report.thesis import SAMPLE_RATE
from trimmer import FrictionBacklash, limit_cycles

SOURCE = "report/chapters/chapter_3/claims/measured_peaks.py"
DURATION, RESOLUTION, FRAMES = "0.1", "10", "2000"
"""Of the experiment's record, as printed: s, Hz, frames."""
STATED_FRAMES = int(FRAMES)
FEWEST, MOST = 1000, 4000
"""Numbers of samples, at 20 kHz, among which a grid for the tables is sought."""


@claim("eq-3.1", source=SOURCE)
def distance_of_bins(_: Evidence) -> Record:
    rate, samples, frequency = sympy.symbols("F_s N f", positive=True)
    turns = frequency * samples / rate
    # The turns in a record are proportional to the frequency, and the lowest sine turns once.
    derived = frequency / turns
    stated = float(derived.subs({rate: SAMPLE_RATE, samples: STATED_FRAMES}))
    second = close("NumPy's bins for 2000 samples at 20 kHz", bins(STATED_FRAMES, SAMPLE_RATE)[1], stated)
    yield expression("", rate / samples, derived, left=r"\Delta f", second=second)
    yield text("""
        The lowest sine that repeats with the record turns once in $N$ samples, and the bins are its
        multiples. It is the distance of bins; the frequency of a single peak can be found better than that,
        two peaks less than a bin or two apart cannot be told apart.
    """)


@claim("txt-3.1-resolution", source=SOURCE)
def resolution(_: Evidence) -> Record:
    frames = SAMPLE_RATE * Fraction(DURATION)
    second = equal("a count of the instants before 0.1 s", len(range(0, 100_000, 50)), frames)
    yield digits("frames in 0.1 s at 20 kHz", FRAMES, frames, second=second)
    second = close("NumPy's bins", bins(STATED_FRAMES, SAMPLE_RATE)[1], 1 / float(DURATION))
    yield digits("resolution", RESOLUTION, Fraction(SAMPLE_RATE, STATED_FRAMES), "Hz", second=second)
    yield text("""
        Both are right, and the resolution is one over the time of the record. The tables that follow have
        bins of [[ spacing | f3 ]] Hz, so one frame more was used: 0 to 0.1 s with both ends.
    """).given(spacing=float(BIN))


@claim("txt-3.1-bins", source=SOURCE, impact=Impact.LOCAL)
def bins_of_the_tables(_: Evidence) -> Record:
    cells = tabulated()
    stated = [cell for cell in cells if on_a_bin(cell, STATED_FRAMES)]
    remainders = "the remainders of the printed decimals on division by ten"
    yield assertion(
        "with the stated 2000 frames",
        "the tabulated peaks are bins of 10 Hz",
        len(stated) == len(cells),
        f"{len(stated)} of {len(cells)} are; bins of 2000 frames are multiples of 10 Hz",
        method="each printed frequency against the nearest bin",
        second=equal(remainders, sum(Decimal(cell) % 10 == 0 for cell in cells), len(stated)),
    )
    others = [cell for cell in cells if on_a_bin(cell)]
    grids = fitting_samples(others, SAMPLE_RATE, FEWEST, MOST)
    by_numpy = {f"{each:.3f}" for each in bins(grids[0], SAMPLE_RATE)}
    fitting = f"{len(others)} of {len(cells)} are, to every digit, with {' or '.join(map(str, grids))}"
    no_other = f"no other number between {FEWEST} and {MOST}"
    misfits = ", ".join(sorted(set(cells) - set(others)))
    rounded = f"NumPy's bins for {grids[0]} frames, rounded to three decimals"
    yield assertion(
        "with any number of frames",
        "the tabulated peaks are bins of one spectrum",
        len(fitting_samples(cells, SAMPLE_RATE, FEWEST, MOST)) > 0,
        f"{fitting} frames and with {no_other}; {misfits} are bins of none of these",
        method="each printed frequency against the nearest bin, for every number of frames",
        second=equal(rounded, sum(cell in by_numpy for cell in cells), len(others)),
    )
    yield text("""
        The peaks are multiples of 20000/2001 = [[ spacing | f4 ]] Hz, the bins of one frame more than stated;
        three cells are not and are misprints. The three decimals are those of the bins: each peak is known to
        half a bin, 5 Hz.

        The drive's frequency is not measured to a millihertz, and differences of 10 Hz between measurements
        mean one bin.
    """).given(spacing=float(BIN))


@claim("txt-3.1-output-sign", source="trimmer/balance/solve.py", impact=Impact.DOWNSTREAM)
def sign_of_the_output(known: Evidence) -> Record:
    states = (*coordinates, *velocities)
    derived, listed = (
        sum(entry * state for entry, state in zip(row, states, strict=True))
        for row in (output_row(of=1, relative_to=3, size=len(coordinates)), output_matrix())
    )
    printed = total(coordinates[3], -coordinates[1])
    second = same("the matrix $C$ of equation 2.14 times the state", listed, derived)
    slip = made_here("the sign is turned", -derived)
    yield expression("output map of the state space", printed, derived, left="y", second=second, slip=slip)
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
    )
    yield text("""
        Section 3.1 says that the output map is $x_4 - x_2$; equation 2.14 and Listing A.1 have $x_2 - x_4$. A
        measured spectrum does not see the sign. A closed loop does: backlash only lags, so with the sign
        turned $G$ would have to lead, which it does by little and with too large a gain.

        A loop that is built with the output of section 3.1 has no limit cycle at all. Nothing in a trimmer
        leads from the output back to the pin, so neither sign is that of the device: the predicted limit
        cycles rest on this choice.
    """)


def loop_gains_where_phases_match(evidence: Evidence) -> tuple[float, float]:
    """Return the least and the largest |N G| where G leads by what backlash lags."""
    return gains_where_phases_match(evidence.numbers.displacement_only)
