"""Claims on figures 5.15 and 5.16, which show -1/N with G for a load with inertia."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import control
import numpy as np

from report.chapters.chapter_5.claims.figures_5_2_harmonic_balance import TURN
from report.claim import Claim, Confirmation, Impact, Part, Slip, Uncheckable, Verdict, Words
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.second_ways import by_waveform, sampled_gain, second_way
from report.evidence import Evidence
from report.numbers.viscous_listing import intersections, listing_contour
from trimmer import frequency_response
from trimmer.balance.leakage import harmonic_leakage
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.elements.element import Element
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash

THICK_BAND = (4.6e3, 5.38e3)
HARMONICS = range(3, 40, 2)
GAMMAS = (1.05, 1.25, 1.45)
LINE_6 = "line 6 of Listing A.5 has the wrong sign under its root, so that contact angles are complex"
STABLE_SIDE = TURN * 600
"""Angular frequency, rad/s, above which G is on the outer circle on its way to -1."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_higher_harmonics(evidence), _viscous(evidence))


def _higher_harmonics(evidence: Evidence) -> Claim:
    return Claim(
        id="fig-5.15",
        parts=(
            _thickness(evidence),
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


def _thickness(evidence: Evidence) -> Part:
    system, cycle = evidence.numbers.displacement_only, evidence.cycles.inertia.stable
    element = InertiaBacklash(1.0)
    returned = sum(harmonic_leakage(system, element, cycle, HARMONICS))
    thickness = returned / abs(complex(element.describing_function(cycle.amplitude)))
    lines = abs(evidence.motion.closed.orbits.inertia.stable.harmonics)
    exact = float(lines[1:].sum() / lines[0])
    distances = [_distance(system, element, omega) for omega in THICK_BAND]
    return Part(
        "from $4.6\\times10^{3}$ to $5.38\\times10^{3}$ rad/s",
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
        second_way(
            f"the exact orbit, whose harmonics have {100 * exact:.2f} % of its fundamental together",
            exact < min(distances),
        ),
    )


def _distance(system: control.TransferFunction, element: Element, omega: float) -> float:
    """Return how far G is from the curve -1/N at an angular frequency."""
    ratios = np.linspace(1e-4, 0.9999, 4000) * float(element.domain(1.0))
    curve = -1 / element.describing_function(1 / ratios)
    return float(np.abs(curve - complex(frequency_response(system, omega))).min())


def _viscous(evidence: Evidence) -> Claim:
    system = evidence.numbers.displacement_only
    found = {gamma: limit_cycles(system, ViscousBacklash(1.0, gamma).at(1.0)) for gamma in GAMMAS}
    repeated = [omega for gamma in GAMMAS for omega in intersections(listing_contour(gamma), system)]
    inner = [cycle.frequency for cycles in found.values() for cycle in cycles if not cycle.stable]
    return Claim(
        id="fig-5.16",
        parts=(
            _outer_circle(system, found, repeated),
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


def _outer_circle(
    system: control.TransferFunction, found: Mapping[float, Sequence[LimitCycle]], repeated: list[float]
) -> Part:
    on_the_outer = [
        (gamma, cycle) for gamma, cycles in found.items() for cycle in cycles if cycle.omega > STABLE_SIDE
    ]
    outer = [cycle for _, cycle in on_the_outer]
    frequencies = [cycle.frequency for cycle in outer]
    return Part(
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
        Confirmation(
            "the first line in the spectrum of the waveform at the last of these points",
            CloseNumbers(-1 / sampled_gain(element, 0.5, 1.0), ends[-1][1], 1e-6),
        ),
    )
