"""Claims of appendix A.10 on the search for intersections (Listing A.9), its grid and its coefficients."""

from fractions import Fraction

from report.chapters.second_ways import NEWTON, by_waveform
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close, digits, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.exact_response import gain
from report.numbers.independent.limit_cycles import friction_as_listed
from report.numbers.thesis import (
    DRIVE_OMEGA,
    LARGE_GAP,
    LISTING_DENOMINATOR,
    LISTING_NUMERATOR,
    PLOT_OFFSET,
    SMALL_GAP,
)
from trimmer import ViscousBacklash, limit_cycles, response_at

GRID_END, GRID_POINTS = 0.0025, 10000  # Last amplitude that line 9 plots, m, and how many it plots
LINE_OF_SEARCH, LINE_OF_START = 23, 31
TIME_CONSTANT = 1e-3  # Load time constant M/D of the example, s


@claim("lst-A.9")
def search(known: Evidence) -> Record:
    cycle = known.cycles.friction_listing.stable
    amplitude, omega = friction_as_listed(cycle)
    label = "the two equations of lines 23 to 26, at their solution: amplitude over gap"
    second = close(NEWTON, amplitude, cycle.amplitude)
    yield digits(label, "8.2845", cycle.amplitude, second=second)
    yield assertion(
        "order of the lines",
        "the start of the search is defined before it is used",
        LINE_OF_START < LINE_OF_SEARCH,
        f"line {LINE_OF_SEARCH} uses `x0`, line {LINE_OF_START} defines it",
        method="read in the printed lines",
    )
    yield text(rf"""
        Real and imaginary part of the condition are right here, unlike [equation 2.54](#eq-2.54), and the
        search converges to the thesis's numbers: $3.3138\cdot 10^{{-4}}/(4\cdot 10^{{-5}}) = 8.2845$ at
        {omega:.1f} rad/s. Run from an empty workspace it stops, because the start is defined after the
        search. It finds one solution for each start, and nothing tells whether there are more.

        None once the lines are exchanged. Two starts give the two limit cycles of table 5.1; a search for all
        of them finds no third.
    """)


@claim("txt-A.10-grid")
def grid(known: Evidence) -> Record:
    pair, listed = known.cycles.friction, known.cycles.friction_listing
    unstable = pair.unstable.amplitude
    begins = LARGE_GAP / 2 + PLOT_OFFSET
    yield assertion(
        "for the gap of line 5",
        "the plotted locus $-1/N$ shows both limit cycles",
        begins < unstable * LARGE_GAP < pair.stable.amplitude * LARGE_GAP < GRID_END,
        f"""
        it runs from {1e6 * begins:.1f} to {1e6 * GRID_END:.0f} µm, they are at
        {1e6 * LARGE_GAP * unstable:.1f} and {1e6 * LARGE_GAP * pair.stable.amplitude:.0f} µm
        """,
        method="arithmetic on the grid of line 9",
        second=so(
            "the two amplitudes by the rounded coefficients of lines 18 to 20",
            (begins < listed.unstable.amplitude * LARGE_GAP, listed.stable.amplitude * LARGE_GAP < GRID_END),
        ),
    )
    smallest = PLOT_OFFSET / (unstable - 0.5)
    at_the_start = "the amplitude where the plot begins, at that gap"
    yield assertion(
        "for the smaller gaps of figures 5.6 and 5.8, if they are drawn with it",
        "it shows both as well",
        smallest < SMALL_GAP,
        rf"""
        it starts at $b/2 + 10^{{-6}}$ m, so the second limit cycle, at ${unstable:.4f}\,b$, is on it only for
        gaps above {power_of(smallest, 1)} m
        """,
        method="arithmetic on the grid of line 9",
        second=close(at_the_start, smallest / 2 + PLOT_OFFSET, smallest * unstable),
        certainty=Certainty.READING,
    )
    step = 1e6 * (GRID_END - begins) / (GRID_POINTS - 1)
    yield text(f"""
        For the gap of the listing the plot is right. But the grid is absolute, in steps of {step:.2f} µm from
        a start that does not follow the gap, while the curve depends on $b/A$ alone: for a small gap the plot
        holds the end of the curve near $-1$ and nothing else, and for gaps above
        {power_of(GRID_END / pair.stable.amplitude, 1)} m it ends before the stable limit cycle.

        A limit cycle that seems to appear as the gap grows, see [the threshold](#txt-5.2.1-threshold), comes
        into the plotted range; it was there before.
    """)


@claim("txt-A.10-coefficients")
def coefficients(known: Evidence) -> Record:
    numbers, system = known.numbers, known.cycles.listing
    rows = (
        ("above the bar", LISTING_NUMERATOR, numbers.numerator, system.num[0][0]),
        ("below the bar", LISTING_DENOMINATOR, numbers.denominator, system.den[0][0]),
    )
    for place, *polynomials in rows:
        from_the_constant = zip(*(reversed(polynomial) for polynomial in polynomials), strict=True)
        for power, (printed, exact, used) in enumerate(from_the_constant):
            second = close("the value that the search uses", float(Fraction(exact)), used, 1e-3)
            yield digits(f"{place}, $s^{power}$", printed, exact, second=second)
    right, rounded = known.cycles.friction.stable, known.cycles.friction_listing.stable
    more = 100 * (rounded.amplitude / right.amplitude - 1)
    yield text(f"""
        All sixteen coefficients are the exact ones rounded to four digits; the numerator of [equation
        5.1](#eq-5.1) differs and belongs to another output. The rounding moves the predicted amplitude by
        {more:.2f} % and the frequency by {rounded.frequency - right.frequency:+.2f} Hz.
    """)


@claim("txt-A.10-two-systems")
def two_systems(known: Evidence) -> Record:
    cycle, systems = (
        known.cycles.friction_listing.stable,
        (known.numbers.displacement_only, known.cycles.listing),
    )
    drawn, searched = (complex(response_at(system, cycle.omega)) for system in systems)
    exact = float(gain(known.numbers, cycle.omega))
    yield assertion(
        "line 13, `nyquist(G(1))`, and lines 18 to 20, `G_1`",
        "the intersection is searched on the curve that is drawn",
        abs(drawn - searched) < 1e-6,
        f"""
        at {cycle.omega:.1f} rad/s the two responses are {abs(drawn - searched):.4f} apart, where $G$ is
        {abs(searched + 1):.3f} away from $-1$
        """,
        method="both transfer functions at the intersection that is found",
        second=close("the drawn one from exact coefficients, 40 digits", exact, abs(drawn)),
    )
    off = 100 * (1 - cycle.amplitude / known.cycles.friction.stable.amplitude)
    yield text(f"""
        Drawn is the transfer function of Listing A.1, searched the one typed in with four digits. On the page
        they look alike. Near $-1$ the small difference matters a little: the amplitude that is found is
        {off:.2f} % too small. With `evalfr(G, s)` for `G_1` the listing would find the intersection that it
        shows.

        Every predicted amplitude of section 5.2.1 carries this difference.
    """)


@claim("txt-A.10-other-functions")
def other_functions(known: Evidence) -> Record:
    system, element = known.numbers.displacement_only, ViscousBacklash(1.0, TIME_CONSTANT)
    frozen, found = (
        max(limit_cycles(system, element, frozen_omega=omega), key=lambda cycle: cycle.frequency)
        for omega in (DRIVE_OMEGA, None)
    )
    yield assertion(
        "a function of amplitude and frequency in line 8",
        "the search then solves the condition for harmonic balance as well",
        abs(frozen.frequency - found.frequency) < 0.01,
        rf"""
        with $M/D$ of 1 ms and $\omega$ set to the drive's it gives {frozen.frequency:.1f} Hz; with the limit
        cycle's own $\omega$ in $N$ it is {found.frequency:.1f} Hz
        """,
        method="all solutions of harmonic balance, with and without a fixed frequency in $N$",
        second=by_waveform(system, [(element, found)]),
    )
    yield text("""
        Line 8 passes the amplitude alone. Listings A.4 and A.10 take $b/A$ instead, and those of A.5 and A.6
        a frequency too. If only line 8 is exchanged, as the text says, that frequency is fixed beforehand
        while the search varies the one in $G$; the two agree by chance only. If lines 23 to 26 are meant to
        follow, with the frequency they vary, the search is right.

        Contours for a fixed frequency (sections 5.2.3 and 5.2.5) may be drawn, but an intersection on them
        counts only at that frequency.
    """)
