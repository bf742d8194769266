"""Claims on figures 5.5, 5.10, 5.15 and 5.16, which show -1/N with G."""

from __future__ import annotations

import math
import warnings

import control
import numpy as np

from report.claim import Claim, Confirmation, Impact, Part, Slip, Uncheckable, Verdict, Words
from report.claims.appendix_a_elements import friction_listing
from report.claims.figures_5_2_simulated import larger_gap_parts
from report.claims.second_ways import by_waveform
from report.claims.section_5_2_1 import LARGE_GAP
from report.claims.section_5_2_1_scaling import PLOT_OFFSET
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.evidence import Evidence
from report.numbers.viscous_listing import intersections, listing_contour
from trimmer import frequency_response
from trimmer.balance.leakage import harmonic_leakage
from trimmer.balance.solve import limit_cycles
from trimmer.elements.element import Element
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash

SOURCE = "trimmer/balance/solve.py"
TURN = 2 * math.pi
LIBRARY_GAP = 1e-4
LIBRARY_GRID = np.linspace(LIBRARY_GAP / 2 + PLOT_OFFSET, 0.0025, 50)
LIBRARY_OMEGA = np.geomspace(1e3, 1e4, 300)
THICK_BAND = (4.6e3, 5.38e3)
HARMONICS = range(3, 40, 2)
GAMMAS = (1.05, 1.25, 1.45)
LINE_6 = "line 6 of Listing A.5 has the wrong sign under its root, so that contact angles are complex"
STABLE_SIDE = TURN * 600
"""Angular frequency, rad/s, above which G is on the outer circle on its way to -1."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _second_implementation(evidence),
        _larger_gap(evidence),
        _higher_harmonics(evidence),
        _viscous(evidence),
    )


def _second_implementation(evidence: Evidence) -> Claim:
    (second, _), (first, omega) = _found_by_library(evidence)
    stable = evidence.cycles.friction_listing.stable
    return Claim(
        id="fig-5.5",
        parts=(
            _curves_of_both(),
            Part(
                "the outer intersection",
                Assertion(
                    statement="the library finds its amplitude and frequency by itself",
                    derived=abs(first / LIBRARY_GAP / stable.amplitude - 1) < 0.01
                    and abs(omega / stable.omega - 1) < 0.001,
                    evidence=(
                        f"it gives {1e3 * first:.3f} mm at {omega / TURN:.1f} Hz; right for its coefficients "
                        f"is {1e3 * LIBRARY_GAP * stable.amplitude:.3f} mm at {stable.frequency:.1f} Hz"
                    ),
                    method="python-control, run on the coefficients of Listing A.9",
                ),
            ),
        ),
        explanation=(
            "Listing and library agree to rounding where they are drawn, so the formula is right; inside of "
            "the dead band, which is not drawn, the library returns zero and the listing numbers without "
            "meaning. The numbers of figure 5.5b are not in the text. The library interpolates on the grid "
            f"it is given: on {LIBRARY_GRID.size} equal steps of the range of Listing A.9 it finds the outer "
            f"limit cycle to {100 * abs(first / LIBRARY_GAP / stable.amplitude - 1):.1f} %, and gives the "
            f"inner one an amplitude of {1e3 * second:.0f} mm."
        ),
        source="trimmer/elements/friction_backlash.py",
    )


def _curves_of_both() -> Part:
    library = control.friction_backlash_nonlinearity(LIBRARY_GAP)
    distance = max(
        abs(friction_listing(a, LIBRARY_GAP) / library.describing_function(a) - 1) for a in LIBRARY_GRID
    )
    return Part(
        "the two curves",
        Assertion(
            statement="the listing's $-1/N$ and the library's are the same",
            derived=distance < 1e-12,
            evidence=f"they differ by {distance:.0e} of their size at most",
            method=f"both evaluated at {LIBRARY_GRID.size} amplitudes of the range of Listing A.9",
        ),
    )


def _found_by_library(evidence: Evidence) -> list[tuple[float, float]]:
    """Return amplitude (m) and ω (rad/s) of what python-control finds, in order of frequency."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it says that it could not refine one of them
        found = control.describing_function_response(
            evidence.cycles.listing,
            control.friction_backlash_nonlinearity(LIBRARY_GAP),
            LIBRARY_GRID,
            LIBRARY_OMEGA,
        )
    return sorted(found.intersections, key=lambda point: point[1])


def _larger_gap(evidence: Evidence) -> Claim:
    return Claim(
        id="fig-5.10",
        parts=(*_intersections_of_larger_gap(evidence), *larger_gap_parts(evidence)),
        explanation=(
            "Both intersections are there, the outer one stable. They lie at the same two points of the "
            "locus as for every other gap; figure 5.8, for a tenth of this gap, shows one only because its "
            "curve begins at a fixed distance above $b/2$. The oscillation of part b goes on in the exact "
            "loop too. Amplitudes and frequencies are judged with table 5.1 and with the text on this gap."
        ),
        source=SOURCE,
    )


def _intersections_of_larger_gap(evidence: Evidence) -> tuple[Part, ...]:
    """Return the parts on the left half of the figure, which harmonic balance decides."""
    exact = limit_cycles(evidence.numbers.displacement_only, FrictionBacklash(LARGE_GAP))
    listing = limit_cycles(evidence.cycles.listing, FrictionBacklash(LARGE_GAP))
    inner, outer = exact
    return (
        Part(
            "a: intersections",
            PrintedDigits("2", len(exact)),
            Confirmation("the coefficients of Listing A.9", CloseNumbers(len(listing), len(exact))),
        ),
        Part(
            "a: stability",
            Assertion(
                statement="the outer one is stable, the inner one unstable",
                derived=outer.stable and not inner.stable,
                evidence=(
                    f"{1e6 * inner.amplitude:.2f} µm at {inner.frequency:.2f} Hz is unstable, "
                    f"{1e6 * outer.amplitude:.1f} µm at {outer.frequency:.2f} Hz stable"
                ),
                method="Loeb's criterion, from analytic derivatives of both curves",
            ),
        ),
    )


def _higher_harmonics(evidence: Evidence) -> Claim:
    system, cycle = evidence.numbers.displacement_only, evidence.cycles.inertia.stable
    element = InertiaBacklash(1.0)
    returned = sum(harmonic_leakage(system, element, cycle, HARMONICS))
    thickness = returned / abs(complex(element.describing_function(cycle.amplitude)))
    distances = [_distance(system, element, omega) for omega in THICK_BAND]
    return Claim(
        id="fig-5.15",
        parts=(
            Part(
                "from 4.6e3 to 5.38e3 rad/s",
                Assertion(
                    statement="harmonics make the curve thick enough to meet $G$ over this band",
                    derived=max(distances) <= thickness,
                    evidence=(
                        f"at the ends $G$ is {distances[0]:.3f} and {distances[1]:.3f} away from the curve; "
                        f"all harmonics that come back together are {100 * returned:.2f} % of the "
                        f"fundamental, a thickness of {thickness:.4f}"
                    ),
                    method=f"harmonics 3 to {HARMONICS[-1]} of the element, each with the response of $G$",
                ),
            ),
            Uncheckable(
                "the drawn thickness",
                Words("a curve with a ball of some radius around it"),
                "the radius that was drawn; the footnote calls the figure an example that does not belong to "
                "the actual harmonics",
            ),
        ),
        explanation=(
            "What the element's harmonics do in the loop can be computed and is small: the filtering "
            "hypothesis holds at this limit cycle. Nor would they open a band: with more harmonics there are "
            "as many more equations as unknowns, so that each limit cycle moves, and stays one point. A "
            "limit cycle is isolated by its definition."
        ),
        consequence=(
            "Equation 5.8 and the explanation of the 23 % in section 5.2.2 are without ground. Section 6.2 "
            "refers to this figure for what higher harmonics may do."
        ),
        impact=Impact.DOWNSTREAM,
        source="trimmer/balance/leakage.py",
    )


def _distance(system: control.TransferFunction, element: Element, omega: float) -> float:
    """Return how far G is from the curve -1/N at an angular frequency."""
    ratios = np.linspace(1e-4, 0.9999, 4000) * float(element.domain(1.0))
    curve = -1 / element.describing_function(1 / ratios)
    return float(np.abs(curve - complex(frequency_response(system, omega))).min())


def _viscous(evidence: Evidence) -> Claim:
    system = evidence.numbers.displacement_only
    found = {gamma: limit_cycles(system, ViscousBacklash(1.0, gamma).at(1.0)) for gamma in GAMMAS}
    on_the_outer = [
        (gamma, cycle) for gamma, cycles in found.items() for cycle in cycles if cycle.omega > STABLE_SIDE
    ]
    outer = [cycle for _, cycle in on_the_outer]
    repeated = [omega for gamma in GAMMAS for omega in intersections(listing_contour(gamma), system)]
    frequencies = [cycle.frequency for cycle in outer]
    inner = [cycle.frequency for cycles in found.values() for cycle in cycles if not cycle.stable]
    return Claim(
        id="fig-5.16",
        parts=(
            Part(
                f"for $\\gamma$ = {', '.join(map(str, GAMMAS))}",
                Assertion(
                    statement="no viscous contour meets the outer circle near $-1$",
                    derived=not outer,
                    evidence=(
                        f"each meets it once, at {min(frequencies):.1f} to {max(frequencies):.1f} Hz, and "
                        "the limit cycle there is stable"
                    ),
                    method="all solutions of harmonic balance for a constant $\\gamma$",
                ),
                by_waveform(
                    system, [(ViscousBacklash(1.0, gamma / each.omega), each) for gamma, each in on_the_outer]
                ),
                slip=Slip(LINE_6, max(repeated) < STABLE_SIDE, Verdict.ERRATUM),
            ),
            _direction(),
        ),
        explanation=(
            "Viscous contours begin at $-1$, as those of friction and inertia do, and cross the outer circle "
            "between theirs. Listing A.5 repeated, with its complex angles, gives contours that begin away "
            f"from $-1$, run to the right and meet $G$ at {min(repeated) / TURN:.0f} to "
            f"{max(repeated) / TURN:.0f} Hz only: that is what the text describes. The right contours "
            f"meet the inner circle too, at {min(inner):.1f} to {max(inner):.1f} Hz, and are unstable there."
        ),
        consequence=(
            "What is drawn from it, that all viscous limit cycles are unstable and merge with others, falls. "
            "The band of section 5.2.3 holds by the right contours, each of which has a stable limit cycle "
            "of its own."
        ),
        impact=Impact.DOWNSTREAM,
        source="report/numbers/viscous_listing.py",
    )


def _direction() -> Part:
    ends = []
    for gamma in GAMMAS:
        element = ViscousBacklash(1.0, gamma)
        ends.append([complex(-1 / element.describing_function(1 / ratio, 1.0)) for ratio in (1e-3, 2.0)])
    return Part(
        "with growing $\\beta = b/A$",
        Assertion(
            statement="the contours run from $-1$ to the right",
            derived=all(abs(start + 1) < 0.01 and end.real > start.real for start, end in ends),
            evidence="at $\\beta = 2$ they are at "
            + ", ".join(f"${end.real:.2f} {end.imag:+.2f}j$" for _, end in ends),
            method="right describing function at both ends of the range",
        ),
    )
