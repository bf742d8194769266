"""Claims on the figures of section 5.2 that show -1/N with G: 5.5, 5.6, 5.8, 5.10, 5.13, 5.15 to 5.18."""

import control

from report.chapters.chapter_5.claims import section_5_2_1_predictions, section_5_2_2
from report.chapters.chapter_5.claims.section_5_2_1_impulses import EDGE
from report.chapters.chapter_5.claims.section_5_2_1_scaling import SMALLEST_GAP
from report.chapters.chapter_5.claims.section_5_2_3 import band_parts
from report.chapters.chapter_5.claims.section_5_2_4 import crossings_part
from report.chapters.second_ways import LOEB, NEWTON, by_waveform
from report.judging.claim import ClaimPart, Slip
from report.judging.comparisons.printed import power, power_of
from report.judging.parts import assertion, close, digits, equal, made_here, so, uncheckable
from report.judging.record import Record, claim, text
from report.numbers.evidence import Evidence
from report.numbers.independent.limit_cycles import friction_as_listed, inertia_exactly
from report.numbers.independent.loci import LIBRARY_GAP, LIBRARY_GRID, intersections_by_library
from report.numbers.independent.waveforms import sampled_gain
from report.numbers.limit_cycle_numbers import cycles_of_constant_gamma
from report.numbers.listed_functions import friction_listing, intersections, listing_contour
from report.numbers.thesis import LARGE_GAP, PLOT_OFFSET, SMALL_GAP, TURN
from trimmer import FrictionBacklash, InertiaBacklash, ViscousBacklash, limit_cycles

FIRST_LINE = "the first line in the spectrum of the waveform"
PLOTTED = "the locus is plotted from b/2 + $10^{-6}$ m on, as in Listing A.9"
GAMMAS = (1.05, 1.25, 1.45)
LINE_6 = "line 6 of Listing A.5 has the wrong sign under its root, so that contact angles are complex"
STABLE_SIDE = TURN * 600  # Angular frequency, rad/s, above which G is on the outer circle on its way to -1


@claim("fig-5.5")
def second_implementation(known: Evidence) -> Record:
    gain = control.friction_backlash_nonlinearity(LIBRARY_GAP).describing_function
    distance = max(abs(friction_listing(a, LIBRARY_GAP) / gain(a) - 1) for a in LIBRARY_GRID)
    sampled = sampled_gain(FrictionBacklash(LIBRARY_GAP), float(LIBRARY_GRID[-1]), 1.0)
    yield assertion(
        "the two curves",
        "the listing's $-1/N$ and the library's are the same",
        distance < 1e-12,
        f"they differ by {power_of(distance)} of their size at most",
        method=f"both evaluated at {LIBRARY_GRID.size} amplitudes of the range of Listing A.9",
        second=close(f"{FIRST_LINE} at the largest of them", sampled, gain(LIBRARY_GRID[-1]), 1e-6),
    )
    (second, _), (first, omega) = intersections_by_library(known.cycles.listing)
    stable = known.cycles.friction_listing.stable
    by_newton, _ = friction_as_listed(stable)
    error = abs(first / LIBRARY_GAP / stable.amplitude - 1)
    yield assertion(
        "the outer intersection",
        "the library finds its amplitude and frequency by itself",
        (error < 0.01, abs(omega / stable.omega - 1) < 0.001),
        f"""
        it gives {1e3 * first:.3f} mm at {omega / TURN:.1f} Hz; right for its coefficients is
        {1e3 * LIBRARY_GAP * stable.amplitude:.3f} mm at {stable.frequency:.1f} Hz
        """,
        method="python-control, run on the coefficients of Listing A.9",
        second=close(NEWTON, first / LIBRARY_GAP, by_newton, 0.01),
    )
    yield text(f"""
        Listing and library agree to rounding where they are drawn, so the formula is right. The numbers of
        figure 5.5b are not in the text. The library interpolates on the grid it is given: on
        {LIBRARY_GRID.size} equal steps of the range of Listing A.9 it finds the outer limit cycle to
        {100 * error:.1f} %, and gives the inner one an amplitude of {1e3 * second:.0f} mm.
    """)


def intersections_part(
    known: Evidence, gap: str, printed: str, item: str, slip: Slip | None = None, what: str = "intersections"
) -> ClaimPart:
    """Return the part on how often the locus for a gap meets G."""
    element = FrictionBacklash(float(gap))
    found = limit_cycles(known.cycles.listing, element)
    exact = limit_cycles(known.numbers.displacement_only, element)
    return digits(
        f"{what} for $b$ = {power(gap)} m",
        printed,
        len(found),
        second=equal("the exact coefficients", len(exact), len(found)),
        slip=slip,
        item=item,
    )


@claim("fig-5.6")
def tiny_gaps(known: Evidence) -> Record:
    for gap in ("1e-8", "2e-8"):
        yield intersections_part(known, gap, "0", SMALLEST_GAP, what="limit cycles")
    found, listed = (
        limit_cycles(system, FrictionBacklash(3e-8))
        for system in (known.numbers.displacement_only, known.cycles.listing)
    )
    yield assertion(
        r"for $b$ = $3\times10^{-8}$ m",
        "the curves clearly intersect",
        any(cycle.stable for cycle in found),
        f"{len(found)} times, once at a stable limit cycle of {1e9 * found[-1].amplitude:.0f} nm",
        method="all solutions of harmonic balance for that gap",
        second=equal("the coefficients of Listing A.9", len(listed), len(found)),
    )
    start = 1e9 * EDGE * known.cycles.friction_listing.stable.amplitude
    yield text(rf"""
        All three gaps have two intersections, at the same two points of the locus: the whole curve is the
        same, only the amplitudes along it change. What the figure shows depends on where the plotted
        amplitudes begin. A curve that begins at {start:.0f} nm touches for $2\times10^{{-8}}$ m and shows
        what the text describes; one that begins as in Listing A.9 shows none of the three.

        The threshold of $2\times10^{{-8}}$ m in section 5.2.1 and chapter 6 is read from this figure.
    """)


@claim("fig-5.8")
def one_intersection(known: Evidence) -> Record:
    stable, unstable = known.cycles.friction_listing.stable, known.cycles.friction_listing.unstable
    start = SMALL_GAP / 2 + PLOT_OFFSET
    plotted = sum(SMALL_GAP * cycle.amplitude >= start for cycle in (unstable, stable))
    item, slip = section_5_2_1_predictions.SECOND_ONLY_LATER, made_here(PLOTTED, plotted)
    yield intersections_part(known, "4e-6", "1", item, slip)
    yield text(f"""
        There are two, as for every gap. The second lies at {1e6 * SMALL_GAP * unstable.amplitude:.2f} µm. The
        curve that Listing A.9 plots begins at {1e6 * start:.2f} µm, so the figure shows the first one only.

        It makes the second limit cycle of figure 5.10 look like an effect of the larger gap.
    """)


@claim("fig-5.10")
def larger_gap(known: Evidence) -> Record:
    found = inner, outer = limit_cycles(known.numbers.displacement_only, FrictionBacklash(LARGE_GAP))
    rounded = limit_cycles(known.cycles.listing, FrictionBacklash(LARGE_GAP))
    unstable, stable = known.orbits.friction.unstable, known.orbits.friction.stable
    small, large = 1e6 * inner.amplitude, 1e6 * outer.amplitude
    size, low, high = 1e6 * LARGE_GAP * stable.amplitude, inner.frequency, outer.frequency
    second = equal("the coefficients of Listing A.9", len(rounded), len(found))
    yield digits("a: intersections", "2", len(found), second=second)
    as_exact = (stable.stable, not unstable.stable)
    yield assertion(
        "a: stability",
        "the outer one is stable, the inner one unstable",
        (outer.stable, not inner.stable),
        f"{small:.2f} µm at {low:.2f} Hz is unstable, {large:.1f} µm at {high:.2f} Hz stable",
        method=LOEB,
        second=so("the Floquet multipliers of the exact orbits", as_exact),
    )
    means = "a motion that starts 0.1 % outside of the unstable orbit and ends on this one"
    yield assertion(
        "b: time response",
        "an oscillation sustains itself",
        stable.stable,
        f"{size:.2f} µm at {stable.frequency:.2f} Hz; the motion is that of figure 5.9, ten times as large",
        method="Floquet multipliers of the exact orbit",
        second=close(means, known.orbits.left_by[1], stable.amplitude, 1e-5),
    )
    yield text("""
        Both intersections are there, the outer one stable, as for every other gap; [figure 5.8](#fig-5.8)
        leaves the inner one out. The oscillation of part b goes on in the exact loop too. Amplitudes and
        frequencies are judged at [table 5.1](#tab-5.1) and at the [text on this
        gap](#txt-5.2.1-simulated-4e-5).
    """)


@claim("fig-5.13")
def inertia(known: Evidence) -> Record:
    system, stable = known.numbers.displacement_only, known.cycles.inertia.stable
    found, scaled = (limit_cycles(system, InertiaBacklash(gap)) for gap in (1.0, 1e-3))
    _, omega = inertia_exactly(known.numbers, stable)
    below_two, scaled_below_two = (
        sum(gap / cycle.amplitude <= 2 for cycle in cycles) for gap, cycles in ((1.0, found), (1e-3, scaled))
    )
    second = equal("the gap scaled by a thousand", scaled_below_two, below_two)
    yield digits(r"intersections for $\beta$ up to 2", "1", below_two, second=second)
    label, second = "angular frequency of the stable one", close(NEWTON, omega, stable.omega)
    yield digits(label, "5.12e3", stable.omega, "rad/s", second=second, item=section_5_2_2.FREQUENCY)
    yield text(rf"""
        Within the range that the section gives, $\beta$ up to 2, the curve of equation 2.43 meets the locus
        once, at {stable.omega:.0f} rad/s; it meets it once more [beyond that range](#txt-5.2.2-beta-range).
        What was drawn to give 5120 rad/s could not be found.

        See the [prediction](#txt-5.2.2-prediction) in section 5.2.2 and the band of [equation
        5.10](#eq-5.10).
    """)


@claim("fig-5.15")
def higher_harmonics(_: Evidence) -> Record:
    yield uncheckable(
        "the drawn thickness",
        "a curve with a ball of some radius around it",
        """
        the radius that was drawn; the footnote calls the figure an example that does not belong to the actual
        harmonics
        """,
    )
    yield text("""
        Footnote 10 calls the figure an example that does not belong to the actual harmonics. What these do is
        judged at [equation 5.8](#eq-5.8): they move the curve by far less. Nor would they open a band: with
        more harmonics there are as many more equations as unknowns, so that each limit cycle moves and stays
        one point.
    """)


@claim("fig-5.16")
def viscous(known: Evidence) -> Record:
    system = known.numbers.displacement_only
    listing = [omega for gamma in GAMMAS for omega in intersections(listing_contour(gamma), system)]
    balanced = {gamma: cycles_of_constant_gamma(system, gamma) for gamma in GAMMAS}
    found = [(gamma, cycle) for gamma, cycles in balanced.items() for cycle in cycles]
    on_outer = [(gamma, cycle) for gamma, cycle in found if cycle.omega > STABLE_SIDE]
    outer = [(ViscousBacklash(1.0, gamma / cycle.omega), cycle) for gamma, cycle in on_outer]
    inner = [cycle.frequency for _, cycle in found if not cycle.stable]
    high = [cycle.frequency for _, cycle in outer]
    yield assertion(
        rf"for $\gamma$ = {', '.join(map(str, GAMMAS))}",
        "no viscous contour meets the outer circle near $-1$",
        not outer,
        f"each meets it once, at {min(high):.1f} to {max(high):.1f} Hz, and the limit cycle there is stable",
        method=r"all solutions of harmonic balance for a constant $\gamma$",
        second=by_waveform(system, outer),
        slip=made_here(LINE_6, max(listing) < STABLE_SIDE),
    )
    loads = [ViscousBacklash(1.0, gamma) for gamma in GAMMAS]
    starts, ends = (
        [complex(-1 / load.describing_function(1 / ratio, 1.0)) for load in loads] for ratio in (1e-3, 2.0)
    )
    runs = zip(starts, ends, strict=True)
    to_the_right = tuple(abs(start + 1) < 0.01 < (end - start).real for start, end in runs)
    sampled = -1 / sampled_gain(loads[-1], 0.5, 1.0)
    yield assertion(
        r"with growing $\beta = b/A$",
        "the contours run from $-1$ to the right",
        to_the_right,
        rf"at $\beta = 2$ they are at {', '.join(f'${end.real:.2f} {end.imag:+.2f}j$' for end in ends)}",
        method="right describing function at both ends of the range",
        second=close(f"{FIRST_LINE} at the last of these points", sampled, ends[-1], 1e-6),
    )
    yield text(f"""
        Viscous contours begin at $-1$, as those of friction and inertia do, and cross the outer circle
        between theirs. Listing A.5 repeated, with its complex angles, gives contours that begin away from
        $-1$, run to the right and meet $G$ at {min(listing) / TURN:.0f} to {max(listing) / TURN:.0f} Hz only;
        that is what the text describes. The right contours meet the inner circle too, at {min(inner):.1f} to
        {max(inner):.1f} Hz, and are unstable there.

        The text concludes that every viscous limit cycle is unstable and moves to another element's. Each
        load has a stable one of its own. The band of section 5.2.3 holds all the same.
    """)


@claim("fig-5.17")
def band(known: Evidence) -> Record:
    yield from band_parts(known)
    yield text(f"""
        The arrow ends at the two limits of the load. The upper one is wrong: it is
        {known.cycles.inertia.stable.frequency:.1f} Hz, [as at equation 5.10](#eq-5.10). The band between them
        is as the section says, and narrower.

        See equation 5.10.
    """)


@claim("fig-5.18")
def coulomb(known: Evidence) -> Record:
    yield crossings_part(known)
    yield text("""
        The locus and the negative real axis do not meet, as the text reads from the figure. For friction the
        curve to draw is the positive imaginary axis, which the locus does not meet either.
    """)
