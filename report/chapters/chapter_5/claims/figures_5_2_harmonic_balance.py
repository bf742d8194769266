"""Claims on figures 5.5 and 5.10, which show -1/N of friction-controlled backlash with G."""

from __future__ import annotations

import math
import warnings

import control
import numpy as np

from report.chapters.appendix_a.claims.elements import friction_listing
from report.chapters.chapter_5.claims.figures_5_2_simulated import larger_gap_parts
from report.chapters.chapter_5.claims.section_5_2_1 import LARGE_GAP
from report.chapters.chapter_5.claims.section_5_2_1_scaling import PLOT_OFFSET
from report.claim import Claim, Confirmation, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.printed import power_of
from report.comparisons.second_ways import sampled_gain, second_way
from report.evidence import Evidence
from report.numbers.limit_cycle_numbers import LISTING_DENOMINATOR, LISTING_NUMERATOR, friction_by_newton
from trimmer.balance.solve import limit_cycles
from trimmer.elements.friction_backlash import FrictionBacklash

SOURCE = "trimmer/balance/solve.py"
TURN = 2 * math.pi
LIBRARY_GAP = 1e-4
LIBRARY_GRID = np.linspace(LIBRARY_GAP / 2 + PLOT_OFFSET, 0.0025, 50)
LIBRARY_OMEGA = np.geomspace(1e3, 1e4, 300)


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_second_implementation(evidence), _larger_gap(evidence))


def _second_implementation(evidence: Evidence) -> Claim:
    (second, _), (first, omega) = _found_by_library(evidence)
    stable = evidence.cycles.friction_listing.stable
    by_newton, _ = friction_by_newton(LISTING_NUMERATOR, LISTING_DENOMINATOR, stable)
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
                Confirmation(
                    "Newton's method in 30 digits", CloseNumbers(first / LIBRARY_GAP, by_newton, 0.01)
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
            evidence=f"they differ by {power_of(distance)} of their size at most",
            method=f"both evaluated at {LIBRARY_GRID.size} amplitudes of the range of Listing A.9",
        ),
        Confirmation(
            "the first line in the spectrum of the waveform at the largest of them",
            CloseNumbers(
                sampled_gain(FrictionBacklash(LIBRARY_GAP), float(LIBRARY_GRID[-1]), 1.0),
                library.describing_function(LIBRARY_GRID[-1]),
                1e-6,
            ),
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
    orbits = evidence.motion.closed.orbits.friction
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
            second_way(
                "the Floquet multipliers of the exact orbits",
                orbits.stable.stable and not orbits.unstable.stable,
            ),
        ),
    )
