"""Claims on the figures of section 5.2 that show -1/N with G: 5.5, 5.6, 5.8, 5.10, 5.13, 5.15 to 5.18."""

from __future__ import annotations

import control

from report.chapters.chapter_5.claims.section_5_2_3 import band_parts
from report.chapters.second_ways import LOEB, NEWTON, by_grid, by_waveform
from report.claim import Impact, Part
from report.comparisons.printed import power, power_of
from report.evidence import Evidence
from report.numbers.independent.limit_cycles import friction_as_listed, inertia_exactly
from report.numbers.independent.loci import (
    LIBRARY_GAP,
    LIBRARY_GRID,
    distance_from_curve,
    intersections_by_library,
)
from report.numbers.independent.waveforms import sampled_gain
from report.numbers.limit_cycle_numbers import cycles_of_constant_gamma
from report.numbers.listed_functions import friction_listing, intersections, listing_contour
from report.parts import assertion, close, digits, equal, made_here, so, uncheckable
from report.record import Record, claim, text
from report.thesis import LARGE_GAP, PLOT_OFFSET, TURN
from trimmer import (
    FrictionBacklash,
    InertiaBacklash,
    ViscousBacklash,
    harmonic_leakage,
    limit_cycles,
    real_axis_crossings,
)

SOURCE = "trimmer/balance/solve.py"
FIRST_LINE = "the first line in the spectrum of the waveform"
PLOTTED = "the locus is plotted from b/2 + $10^{-6}$ m on, as in Listing A.9"
THICK_BAND = (4.6e3, 5.38e3)
HARMONICS = range(3, 40, 2)
GAMMAS = (1.05, 1.25, 1.45)
LINE_6 = "line 6 of Listing A.5 has the wrong sign under its root, so that contact angles are complex"
STABLE_SIDE = TURN * 600
"""Angular frequency, rad/s, above which G is on the outer circle on its way to -1."""


@claim("fig-5.5", source="trimmer/elements/friction_backlash.py")
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
        error < 0.01 and abs(omega / stable.omega - 1) < 0.001,
        """
        it gives [[ first | f3 ]] mm at [[ frequency | f1 ]] Hz; right for its coefficients is
        [[ right | f3 ]] mm at [[ stable.frequency | f1 ]] Hz
        """,
        numbers={
            "first": 1e3 * first,
            "frequency": omega / TURN,
            "right": 1e3 * LIBRARY_GAP * stable.amplitude,
            "stable": stable,
        },
        method="python-control, run on the coefficients of Listing A.9",
        second=close(NEWTON, first / LIBRARY_GAP, by_newton, 0.01),
    )
    yield text("""
        Listing and library agree to rounding where they are drawn, so the formula is right; inside of the
        dead band, which is not drawn, the library returns zero and the listing numbers without meaning. The
        numbers of figure 5.5b are not in the text. The library interpolates on the grid it is given: on
        [[ steps ]] equal steps of the range of Listing A.9 it finds the outer limit cycle to [[ error | f1 ]]
        %, and gives the inner one an amplitude of [[ inner | f0 ]] mm.
    """).given(steps=LIBRARY_GRID.size, error=100 * error, inner=1e3 * second)


def intersections_part(known: Evidence, gap: str, printed: str) -> Part:
    """Return the part on how often the locus for a gap meets G."""
    element = FrictionBacklash(float(gap))
    found = limit_cycles(known.cycles.listing, element)
    exact = limit_cycles(known.numbers.displacement_only, element)
    plotted = sum(cycle.amplitude >= float(gap) / 2 + PLOT_OFFSET for cycle in found)
    return digits(
        f"intersections for $b$ = {power(gap)} m",
        printed,
        len(found),
        second=equal("the exact coefficients", len(exact), len(found)),
        slip=made_here(PLOTTED, plotted),
    )


@claim("fig-5.6", source=SOURCE, impact=Impact.DOWNSTREAM)
def tiny_gaps(known: Evidence) -> Record:
    for gap, printed in (("1e-8", "0"), ("2e-8", "0"), ("3e-8", "1")):
        yield intersections_part(known, gap, printed)
    yield text(r"""
        All three gaps have two intersections, at the same two points of the locus: the whole curve is the
        same, only the amplitudes along it change. What the figure shows depends on where the plotted
        amplitudes begin; with the start of Listing A.9 none of the three would show any.

        The threshold of $2\times10^{-8}$ m in section 5.2.1 and chapter 6 is read from this figure.
    """)


@claim("fig-5.8", source=SOURCE, impact=Impact.DOWNSTREAM)
def one_intersection(known: Evidence) -> Record:
    yield intersections_part(known, "4e-6", "1")
    yield text("""
        There are two, as for every gap. The second lies at 0.527 times the gap, below the amplitude at which
        the plotted locus begins, so the figure shows the first one only.

        It makes the second limit cycle of figure 5.10 look like an effect of the larger gap.
    """)


@claim("fig-5.10", source=SOURCE)
def larger_gap(known: Evidence) -> Record:
    found = inner, outer = limit_cycles(known.numbers.displacement_only, FrictionBacklash(LARGE_GAP))
    rounded = limit_cycles(known.cycles.listing, FrictionBacklash(LARGE_GAP))
    unstable, stable = known.orbits.friction.unstable, known.orbits.friction.stable
    small, large = 1e6 * inner.amplitude, 1e6 * outer.amplitude
    size, low, high = 1e6 * LARGE_GAP * stable.amplitude, inner.frequency, outer.frequency
    second = equal("the coefficients of Listing A.9", len(rounded), len(found))
    yield digits("a: intersections", "2", len(found), second=second)
    as_exact = stable.stable and not unstable.stable
    yield assertion(
        "a: stability",
        "the outer one is stable, the inner one unstable",
        outer.stable and not inner.stable,
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
        Both intersections are there, the outer one stable. They lie at the same two points of the locus as
        for every other gap; figure 5.8, for a tenth of this gap, shows one only because its curve begins at a
        fixed distance above $b/2$. The oscillation of part b goes on in the exact loop too. Amplitudes and
        frequencies are judged with table 5.1 and with the text on this gap.
    """)


@claim("fig-5.13", source=SOURCE, impact=Impact.DOWNSTREAM)
def inertia(known: Evidence) -> Record:
    system, stable = known.numbers.displacement_only, known.cycles.inertia.stable
    found, scaled = (limit_cycles(system, InertiaBacklash(gap)) for gap in (1.0, 1e-3))
    _, omega = inertia_exactly(known.numbers, stable)
    below_two = sum(1 / cycle.amplitude <= 2 for cycle in found)
    yield digits(
        "intersections",
        "1",
        len(found),
        second=equal("the gap scaled by a thousand", len(scaled), len(found)),
        slip=made_here("the curve is drawn for beta up to 2 only", below_two),
    )
    label, second = "angular frequency of the stable one", close(NEWTON, omega, stable.omega)
    yield digits(label, "5.12e3", stable.omega, "rad/s", second=second)
    yield text(r"""
        Drawn with equation 2.43 the curve meets the locus twice: once at [[ stable.omega | f0 ]] rad/s, and
        once more beyond $\beta = 2$, where the thesis stops. What was drawn to give 5120 rad/s could not be
        found.

        See the prediction in section 5.2.2 and the band of equation 5.10.
    """).given(stable=stable)


@claim("fig-5.15", source="trimmer/balance/leakage.py", impact=Impact.DOWNSTREAM)
def higher_harmonics(known: Evidence) -> Record:
    system, cycle = known.numbers.displacement_only, known.cycles.inertia.stable
    element = InertiaBacklash(1.0)
    returned = sum(harmonic_leakage(system, element, cycle, HARMONICS))
    thickness = returned / abs(complex(element.describing_function(cycle.amplitude)))
    lines = abs(known.orbits.inertia.stable.harmonics)
    exact = float(lines[1:].sum() / lines[0])
    low, high = (distance_from_curve(system, element, omega) for omega in THICK_BAND)
    means = f"the exact orbit, whose harmonics have {100 * exact:.2f} % of its fundamental together"
    yield assertion(
        r"from $4.6\times10^{3}$ to $5.38\times10^{3}$ rad/s",
        "harmonics make the curve thick enough to meet $G$ over this band",
        max(low, high) <= thickness,
        """
        at the ends $G$ is [[ low | f3 ]] and [[ high | f3 ]] away from the curve; all harmonics that come
        back together are [[ returned | f2 ]] % of the fundamental, a thickness of [[ thickness | f4 ]]
        """,
        numbers={"low": low, "high": high, "returned": 100 * returned, "thickness": thickness},
        method=f"harmonics 3 to {HARMONICS[-1]} of the element, each with the response of $G$",
        second=so(means, exact < min(low, high)),
    )
    yield uncheckable(
        "the drawn thickness",
        "a curve with a ball of some radius around it",
        """
        the radius that was drawn; the footnote calls the figure an example that does not belong to the actual
        harmonics
        """,
    )
    yield text("""
        What the element's harmonics do in the loop can be computed and is small: the filtering hypothesis
        holds at this limit cycle. Nor would they open a band: with more harmonics there are as many more
        equations as unknowns, so that each limit cycle moves, and stays one point. A limit cycle is isolated
        by its definition.

        Equation 5.8 and the explanation of the 23 % in section 5.2.2 are without ground. Section 6.2 refers
        to this figure for what higher harmonics may do.
    """)


@claim("fig-5.16", source="report/numbers/listed_functions.py", impact=Impact.DOWNSTREAM)
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
    to_the_right = all(abs(start + 1) < 0.01 and end.real > start.real for start, end in runs)
    sampled = -1 / sampled_gain(loads[-1], 0.5, 1.0)
    yield assertion(
        r"with growing $\beta = b/A$",
        "the contours run from $-1$ to the right",
        to_the_right,
        rf"at $\beta = 2$ they are at {', '.join(f'${end.real:.2f} {end.imag:+.2f}j$' for end in ends)}",
        method="right describing function at both ends of the range",
        second=close(f"{FIRST_LINE} at the last of these points", sampled, ends[-1], 1e-6),
    )
    yield text("""
        Viscous contours begin at $-1$, as those of friction and inertia do, and cross the outer circle
        between theirs. Listing A.5 repeated, with its complex angles, gives contours that begin away from
        $-1$, run to the right and meet $G$ at [[ first | f0 ]] to [[ last | f0 ]] Hz only: that is what the
        text describes. The right contours meet the inner circle too, at [[ low | f1 ]] to [[ high | f1 ]] Hz,
        and are unstable there.

        What is drawn from it, that all viscous limit cycles are unstable and merge with others, falls. The
        band of section 5.2.3 holds by the right contours, each of which has a stable limit cycle of its own.
    """).given(first=min(listing) / TURN, last=max(listing) / TURN, low=min(inner), high=max(inner))


@claim("fig-5.17", source=SOURCE, impact=Impact.DOWNSTREAM)
def band(known: Evidence) -> Record:
    yield from band_parts(known)
    yield text("""
        The arrow ends at the two limits of the load, of which the upper one is wrong: [[ high | f1 ]] Hz. The
        band between them is as the section says, and narrower.

        See equation 5.10.
    """).given(high=known.cycles.inertia.stable.frequency)


@claim("fig-5.18", source="trimmer/linear/crossings.py")
def coulomb(known: Evidence) -> Record:
    system = known.numbers.displacement_only
    negative = sum(crossing.value < 0 for crossing in real_axis_crossings(system))
    second = by_grid(system, negative)
    yield digits("intersections with the negative real axis", "0", negative, second=second)
    yield text("""
        The locus and the negative real axis do not meet, as the text reads from the figure. For friction in
        this loop the curve to draw is the positive imaginary axis, which the locus does not meet either.
    """)
