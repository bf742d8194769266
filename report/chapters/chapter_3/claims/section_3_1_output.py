"""Claim of section 3.1 on the sign of the output, cutter relative to guard."""

from __future__ import annotations

import control
import numpy as np
from numpy.typing import NDArray

from derivations.state_space import output_row
from derivations.symbols import coordinates, velocities
from report.chapters.chapter_2.claims.trimmer_printed import output_matrix
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.evidence import Evidence
from trimmer import frequency_response
from trimmer.balance.solve import limit_cycles
from trimmer.elements.friction_backlash import FrictionBacklash

Reals = NDArray[np.float64]

OMEGAS = np.linspace(1.0, 2e4, 20_001)
"""Angular frequencies at which the phase is looked at, rad/s: far beyond the last natural mode."""
AMPLITUDES = np.geomspace(0.5001, 1e7, 4_000)
"""Amplitudes over the gap, from the edge of the dead band to where the gap no longer matters."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_sign(evidence),)


def _sign(evidence: Evidence) -> Claim:
    right, turned = (
        limit_cycles(sign * evidence.numbers.displacement_only, FrictionBacklash(1.0)) for sign in (1, -1)
    )
    low, high = loop_gains_where_phases_match(evidence)
    return Claim(
        id="txt-3.1-output-sign",
        parts=(
            _printed(),
            Part(
                "in the loop of figure 2.5",
                Assertion(
                    statement="with the output of section 3.1 there are the limit cycles of section 5.2",
                    derived=len(turned) == len(right),
                    evidence=(
                        f"harmonic balance has {len(turned) or 'no'} solution with $x_4 - x_2$ and "
                        f"{len(right)} with $x_2 - x_4$"
                    ),
                    method="all solutions of harmonic balance for either sign",
                ),
                Confirmation(
                    f"the loop's gain, {low:.2f} to {high:.2f} wherever backlash undoes the lead of $G$",
                    Assertion(
                        statement="$N G$ passes through 1",
                        derived=low <= 1 <= high,
                        evidence=f"it has {low:.2f} to {high:.2f} where it is real",
                        method="python-control's describing function at the matching phases",
                        asserted=False,
                    ),
                ),
            ),
        ),
        explanation=(
            "Section 3.1 says that the output map is $x_4 - x_2$; equation 2.14 and Listing A.1 have $x_2 - "
            "x_4$. A measured spectrum does not see the sign. A closed loop does: backlash only lags, so "
            "with the sign turned $G$ would have to lead, which it does by little and with too large a gain."
        ),
        consequence=(
            "A loop that is built with the output of section 3.1 has no limit cycle at all. Nothing in a "
            "trimmer leads from the output back to the pin, so neither sign is that of the device: the "
            "predicted limit cycles rest on this choice."
        ),
        impact=Impact.DOWNSTREAM,
        source="trimmer/balance/solve.py",
    )


def _printed() -> Part:
    states = (*coordinates, *velocities)
    derived, listed = (
        sum(entry * state for entry, state in zip(row, states, strict=True))
        for row in (output_row(of=1, relative_to=3, size=len(coordinates)), output_matrix())
    )
    return Part(
        "output map of the state space",
        SameExpression(total(coordinates[3], -coordinates[1]), derived, left="y"),
        Confirmation("the matrix $C$ of equation 2.14 times the state", SameExpression(listed, derived)),
        Slip("the sign is turned", -derived, Verdict.ERRATUM),
    )


def loop_gains_where_phases_match(evidence: Evidence) -> tuple[float, float]:
    """Return the least and the largest |N G| over all frequencies where G leads by what backlash lags."""
    library = control.friction_backlash_nonlinearity(1.0)
    lag = np.array([-np.angle(library.describing_function(float(each))) for each in AMPLITUDES])
    response = np.asarray(frequency_response(evidence.numbers.displacement_only, OMEGAS))
    response = response[np.angle(response) > 0]
    matching: Reals = np.interp(np.angle(response), lag[::-1], AMPLITUDES[::-1])
    gains = [
        abs(value * library.describing_function(float(amplitude)))
        for value, amplitude in zip(response, matching, strict=True)
    ]
    return float(min(gains)), float(max(gains))
