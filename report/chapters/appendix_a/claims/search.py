"""Claims of appendices A.2 and A.10 on the two inputs, and on what the search for intersections solves."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from derivations.symbols import c2
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.second_ways import by_waveform
from report.evidence import Evidence
from report.numbers.exact_response import gain
from report.numbers.linear_numbers import DRIVE_FREQUENCY
from trimmer import frequency_response, linear_model
from trimmer.balance.solve import limit_cycles
from trimmer.elements.viscous_backlash import ViscousBacklash

TIME_CONSTANT = 1e-3
"""Load time constant M/D of the example, s."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_two_columns(evidence), _two_systems(evidence), _other_functions(evidence))


def _two_columns(evidence: Evidence) -> Claim:
    velocity = evidence.derivation.space.b[:, 1].subs(c2, 0)
    dissipation = evidence.derivation.rayleigh_function.subs(c2, 0)
    without = linear_model(replace(evidence.numbers.parameters, c2=0.0))
    return Claim(
        id="txt-A.2-two-columns",
        parts=(
            Part(
                "",
                Assertion(
                    statement="a second input, of velocity, follows from the system's dissipation",
                    derived=dissipation == 0 or not velocity.is_zero_matrix,
                    evidence=(
                        "with $c_2 = 0$ the second column is zero, while $c_1$, $c_3$ and $c_4$ go on to "
                        "dissipate"
                    ),
                    method="derived input matrix and dissipation function",
                ),
                Confirmation(
                    "the numeric model without $c_2$",
                    CloseNumbers(1 + float(np.abs(np.asarray(without.B)[:, 1]).max()), 1.0),
                ),
            ),
        ),
        explanation=(
            "One damper alone brings the pin's velocity in, $c_2$ between pin and bridge; the other three "
            "do not. The two columns belong to displacement and velocity of the pin, which are one motion, "
            "not to relative motions of the trimmer, as the text calls them."
        ),
        consequence="To drop the second column, as line 58 of Listing A.1 does, leaves out $c_2$ at the pin.",
        impact=Impact.NOTATION,
        source="derivations/state_space.py",
    )


def _two_systems(evidence: Evidence) -> Claim:
    cycle = evidence.cycles.friction_listing.stable
    drawn, searched = (
        complex(frequency_response(system, cycle.omega))
        for system in (evidence.numbers.displacement_only, evidence.cycles.listing)
    )
    right = evidence.cycles.friction.stable
    return Claim(
        id="txt-A.10-two-systems",
        parts=(
            Part(
                "line 13, `nyquist(G(1))`, and lines 18 to 20, `G_1`",
                Assertion(
                    statement="the intersection is searched on the curve that is drawn",
                    derived=abs(drawn - searched) < 1e-6,
                    evidence=(
                        f"at {cycle.omega:.1f} rad/s the two responses are {abs(drawn - searched):.4f} "
                        f"apart, where $G$ is {abs(searched + 1):.3f} away from $-1$"
                    ),
                    method="both transfer functions at the intersection that is found",
                ),
                Confirmation(
                    "the drawn one from exact coefficients, 40 digits",
                    CloseNumbers(float(gain(evidence.numbers, cycle.omega)), abs(drawn)),
                ),
            ),
        ),
        explanation=(
            "Drawn is the transfer function of Listing A.1, searched the one typed in with four digits. On "
            f"the page they look alike, and so near to $-1$ they are not: the amplitude is "
            f"{100 * (cycle.amplitude / right.amplitude - 1):.2f} % off. With `evalfr(G, s)` for `G_1` the "
            "listing would find the intersection that it shows."
        ),
        consequence="Every predicted amplitude of section 5.2.1 carries this difference.",
        impact=Impact.DOWNSTREAM,
        source="report/numbers/limit_cycle_numbers.py",
    )


def _other_functions(evidence: Evidence) -> Claim:
    system, element = evidence.numbers.displacement_only, ViscousBacklash(1.0, TIME_CONSTANT)
    frozen = max(
        limit_cycles(system, element, frozen_omega=2 * math.pi * DRIVE_FREQUENCY),
        key=lambda cycle: cycle.frequency,
    )
    found = max(limit_cycles(system, element), key=lambda cycle: cycle.frequency)
    return Claim(
        id="txt-A.10-other-functions",
        parts=(
            Part(
                "a function of amplitude and frequency in line 8",
                Assertion(
                    statement="the search then solves the condition for harmonic balance as well",
                    derived=abs(frozen.frequency - found.frequency) < 0.01,
                    evidence=(
                        f"with $M/D$ of 1 ms and $\\omega$ set to the drive's it gives "
                        f"{frozen.frequency:.1f} Hz; with the limit cycle's own $\\omega$ in $N$ it is "
                        f"{found.frequency:.1f} Hz"
                    ),
                    method="all solutions of harmonic balance, with and without a fixed frequency in $N$",
                ),
                by_waveform(system, [(element, found)]),
            ),
        ),
        explanation=(
            "Line 8 passes the amplitude alone. For Listings A.4 and A.10 that argument would have to be "
            "$b/A$, and those of A.5 and A.6 take a frequency too, which the line fixes beforehand while the "
            "search varies it in $G$. The two agree by chance only, unless $N$ is free of frequency."
        ),
        consequence=(
            "Contours for a fixed frequency (sections 5.2.3 and 5.2.5) may be drawn, but an intersection on "
            "them counts only at that frequency."
        ),
        impact=Impact.LOCAL,
        source="trimmer/balance/solve.py",
    )
