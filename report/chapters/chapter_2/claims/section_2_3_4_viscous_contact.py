"""Claims of section 2.3.4 on separation and contact of viscous-controlled backlash (2.44 to 2.46)."""

from __future__ import annotations

import sympy

from derivations.backlash import (
    CONTACT,
    GAMMA,
    GAP,
    SEPARATION,
    free_flight,
    separation_angle,
)
from derivations.dimensions import FORCE, LENGTH, MASS, TIME, dimension_of
from derivations.symbols import DIMENSIONS, A, omega
from derivations.waveform import THETA
from report.chapters.chapter_2.claims.section_2_3_4_viscous import ROOT, SINE, SOURCE, gap_over_amplitude
from report.claim import Claim, Confirmation, Impact, Mathematics, Part, Slip, Verdict
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product
from report.evidence import Evidence

LOAD_MASS, LOAD_DAMPING = sympy.symbols("M D", positive=True)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_separation(), _ratio(), _contact_equation())


def _separation() -> Claim:
    force_balance = sympy.cos(THETA) - GAMMA * sympy.sin(THETA)
    return Claim(
        id="eq-2.44",
        parts=(
            Part(
                "",
                SameExpression(sympy.atan(1 / GAMMA), separation_angle(), left=sympy.Symbol("phi_s")),
                Confirmation(
                    "the force of the wall at that phase",
                    SameExpression(
                        sympy.simplify(force_balance.subs(THETA, separation_angle())), sympy.Integer(0)
                    ),
                ),
            ),
        ),
        explanation=(
            "While the bridge follows the pin the wall has to push with $D\\dot y + M\\ddot y$, which "
            "reaches zero at the printed phase. It is the phase of zero force; equal velocities, which the "
            "text gives as the reason, hold during the whole contact."
        ),
        source=SOURCE,
    )


def _ratio() -> Claim:
    printed = LOAD_MASS / LOAD_DAMPING * omega
    position = sympy.Function("y")
    time = sympy.Symbol("t", real=True)
    equation = LOAD_MASS * position(time).diff(time, 2) + LOAD_DAMPING * position(time).diff(time)
    in_phase = equation.subs(position(time), position(omega * time)).doit().subs(omega * time, THETA).doit()
    second, first = (in_phase.coeff(position(THETA).diff(THETA, order)) for order in (2, 1))
    units = DIMENSIONS | {LOAD_MASS: MASS, LOAD_DAMPING: FORCE * TIME / LENGTH}
    dimension = dimension_of(printed, units)
    return Claim(
        id="eq-2.45",
        parts=(Part("", SameExpression(printed, second / first, left=GAMMA)),),
        explanation=(
            "With the phase as variable $M\\ddot y + D\\dot y = 0$ becomes $\\gamma y'' + y' = 0$ with the "
            f"printed ratio. Its unit is {dimension}: a pure number."
        ),
        source=SOURCE,
    )


def _contact_equation() -> Claim:
    flight = product(GAMMA**2 / ROOT, sympy.exp((sympy.atan(1 / GAMMA) - CONTACT) / GAMMA))
    printed_gap = sympy.sqrt(1 - GAMMA**2) - SINE - flight
    slip = ROOT - SINE - flight
    derived = gap_over_amplitude()
    meeting = (free_flight() - A * sympy.sin(THETA)).subs(
        {THETA: CONTACT, SEPARATION: separation_angle(), GAP: GAMMA * 0}
    )
    right = sympy.sin(CONTACT) + flight
    return Claim(
        id="eq-2.46",
        parts=(
            Part(
                "solved for $b/A$",
                SameExpression(printed_gap, derived, left=r"\frac{b}{A}", assume=sympy.Lt(GAMMA, 1)),
                Confirmation(
                    "the distance between flight and pin", SameExpression(sympy.simplify(meeting / A), slip)
                ),
                Slip(
                    "the sign under the root is minus instead of plus",
                    derived - ROOT + sympy.sqrt(1 - GAMMA**2),
                    Verdict.ERRATUM,
                ),
                Mathematics(rf"\sqrt{{1 - \gamma^2}} - \frac{{b}}{{A}} = {sympy.latex(right)}"),
                Mathematics(rf"\sqrt{{1 + \gamma^2}} - \frac{{b}}{{A}} = {sympy.latex(right)}"),
            ),
        ),
        explanation=(
            "The sum $\\sin\\phi_s + \\gamma\\cos\\phi_s$ of the flight is $\\sqrt{1 + \\gamma^2}$; printed "
            "is $\\sqrt{1 - \\gamma^2}$. For $\\gamma > 1$ the printed root is imaginary, and no real "
            "contact angle exists."
        ),
        consequence=(
            "Listing A.5 has the same sign, and section 5.2.3 evaluates it for $1 < \\gamma < 3/2$: every "
            "viscous contour drawn there rests on complex contact angles."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )
