"""Claim of section 5.2.4 on the unit of the friction force, which the section gives twice."""

from __future__ import annotations

import sympy

from derivations.dimensions import FORCE, LENGTH, NUMBER, dimension_of
from derivations.symbols import DIMENSIONS, k2, m2
from report.claim import Claim, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.second_ways import second_way
from report.evidence import Evidence

PRINTED_UNITS = {
    "figure 5.18": "-",
    "figure 5.19": "-",
    "figure 5.20": "-",
    "figures 5.22 and 5.23": "-",
    "the bound of 1.0": "N",
}
"""Unit that stands behind F_c, each place."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    beside = dimension_of(k2 * sympy.Symbol("u"), {**DIMENSIONS, sympy.Symbol("u"): LENGTH})
    inertia = dimension_of(m2 * sympy.Symbol("a"), {**DIMENSIONS, sympy.Symbol("a"): FORCE / DIMENSIONS[m2]})
    return (
        Claim(
            id="txt-5.2.4-force-unit",
            parts=(
                Part(
                    "",
                    Assertion(
                        statement="$F_c$ is a number without unit, as behind 0.015, 1.5 and 0.6",
                        derived=beside == NUMBER,
                        evidence=(
                            f"in equation 3.2 it stands beside $k_2u$, in {beside}; "
                            + ", ".join(f"[{unit}] in {place}" for place, unit in PRINTED_UNITS.items())
                        ),
                        method="dimension check of equation 3.2",
                    ),
                    second_way(f"$m_2\\ddot q_2$ in the same equation, in {inertia}", inertia == FORCE),
                ),
            ),
            explanation=(
                "A Coulomb force is in newtons, as section 3.3 and the bound of 1.0 N have it; the captions "
                "and sections 5.2.4 and 5.2.5 write [-]. Neither is what a loop with $G$ as its linear part "
                "holds: the relay's output enters it as a displacement of the pin, so 0.015 is 15 mm of pin "
                "travel, ten times the eccentricity."
            ),
            consequence=(
                "The advice that friction below 1.0 N may be neglected compares newtons with an amplitude "
                "that was found for metres at the pin."
            ),
            impact=Impact.DOWNSTREAM,
            source="derivations/dimensions.py",
        ),
    )
