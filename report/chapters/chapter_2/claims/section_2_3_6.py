"""Claims of section 2.3.6: harmonic balance in two equations (equations 2.53 to 2.56)."""

from __future__ import annotations

import sympy

from report.chapters.appendix_a.claims.elements import friction_listing
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict, Words
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product, total
from report.evidence import Evidence
from trimmer import frequency_response
from trimmer.elements.friction_backlash import FrictionBacklash

SOURCE = "report/chapters/chapter_2/claims/section_2_3_6.py"
REAL_N, IMAGINARY_N, REAL_G, IMAGINARY_G = sympy.symbols("N_r N_i G_r G_i", real=True)
LOOP = sympy.expand((REAL_N + sympy.I * IMAGINARY_N) * (REAL_G + sympy.I * IMAGINARY_G))
POINT = {REAL_N: 0.3, IMAGINARY_N: -1.7, REAL_G: 2.1, IMAGINARY_G: 0.9}


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _real_part(),
        _imaginary_part(),
        _roles(evidence),
        _graphical("eq-2.55"),
        _graphical("eq-2.56"),
    )


def _numeric_loop() -> complex:
    return complex(POINT[REAL_N], POINT[IMAGINARY_N]) * complex(POINT[REAL_G], POINT[IMAGINARY_G])


def _real_part() -> Claim:
    printed = total(product(REAL_N, REAL_G), product(-1, IMAGINARY_N, IMAGINARY_G))
    derived = sympy.re(LOOP)
    return Claim(
        id="eq-2.53",
        parts=(
            Part(
                "left side, equal to $-1$",
                SameExpression(printed, derived),
                Confirmation(
                    "complex numbers", CloseNumbers(_numeric_loop().real, complex(derived.subs(POINT)))
                ),
            ),
        ),
        explanation="The real part of $NG$. For $G(j\\omega)$ the line writes $G(j, \\omega)$.",
        source=SOURCE,
    )


def _imaginary_part() -> Claim:
    printed = total(product(IMAGINARY_N, IMAGINARY_G), product(IMAGINARY_N, REAL_G))
    derived = sympy.im(LOOP)
    return Claim(
        id="eq-2.54",
        parts=(
            Part(
                "left side, equal to zero",
                SameExpression(printed, derived),
                Confirmation(
                    "complex numbers", CloseNumbers(_numeric_loop().imag, complex(derived.subs(POINT)))
                ),
                Slip(
                    "the first factor is the imaginary part of N instead of the real one",
                    derived - REAL_N * IMAGINARY_G + IMAGINARY_N * IMAGINARY_G,
                    Verdict.ERRATUM,
                ),
            ),
        ),
        explanation=(
            "The imaginary part of $NG$ is $\\mathrm{Re}N\\,\\mathrm{Im}G + \\mathrm{Im}N\\,\\mathrm{Re}G$. "
            "As printed the amplitude drops out: for $\\mathrm{Im}N \\ne 0$ it asks for $\\mathrm{Re}G = "
            "-\\mathrm{Im}G$, whatever the nonlinearity."
        ),
        consequence="None: Listing A.9, lines 23 to 26, has the right form.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _roles(evidence: Evidence) -> Claim:
    cycle = evidence.cycles.friction.stable
    linear = complex(frequency_response(evidence.numbers.displacement_only, cycle.omega))
    doubled = 2 * cycle.amplitude
    left = (complex(FrictionBacklash(1.0).describing_function(doubled)) * linear).imag
    return Claim(
        id="txt-2.3.6-roles",
        parts=(
            Part(
                "a real $N$, as of a relay",
                SameExpression(IMAGINARY_G, sympy.im(LOOP.subs(IMAGINARY_N, 0)) / REAL_N),
                printed_form=Words("the imaginary equation, free of $N$"),
            ),
            Part(
                "a complex $N$, as of backlash",
                Assertion(
                    statement="the imaginary equation gives the frequency without the amplitude",
                    derived=abs(left) < 1e-9,
                    evidence=(
                        f"at the predicted {cycle.frequency:.2f} Hz it is met at $A = "
                        f"{cycle.amplitude:.2f}\\,b$; at twice that $\\mathrm{{Im}}\\,NG = {left:.4f}$"
                    ),
                    method="the imaginary part at two amplitudes",
                ),
                Confirmation(
                    "the formula of Listing A.3",
                    CloseNumbers((friction_listing(doubled, 1.0) * linear).imag, left),
                ),
            ),
        ),
        explanation=(
            "For a real $N$ the imaginary equation is $\\mathrm{Im}\\,G = 0$ and gives the frequency, the "
            "real one the amplitude. Backlash has a complex $N$; then amplitude and frequency stand in both "
            "equations, which have to be solved together, as Listing A.9 does."
        ),
        consequence=(
            "Chapter 7 says again that the frequency comes from the transfer function alone; it comes from "
            "both, as the different frequencies of the kinds of backlash show."
        ),
        impact=Impact.LOCAL,
        source="trimmer/elements/friction_backlash.py",
    )


def _graphical(claim_id: str) -> Claim:
    linear, nonlinear = sympy.symbols("G N")
    derived = sympy.solve(1 + nonlinear * linear, linear)[0]
    return Claim(
        id=claim_id,
        parts=(Part("", SameExpression(-1 / nonlinear, derived, left=linear)),),
        explanation=(
            "The condition of harmonic balance solved for $G$. "
            + (
                "For a describing function of two variables it is a family of curves, one for each "
                "frequency, and only the point of equal frequency on both curves counts."
                if claim_id == "eq-2.55"
                else "Without dependence on frequency one curve serves all frequencies. Coulomb friction is "
                "of this kind for either choice of its input. The text below it plots $N(A)$; $-1/N(A)$ is "
                "meant."
            )
        ),
        source=SOURCE,
    )
