"""Claims of section 4.2.3 on the load of viscous-controlled backlash, on gamma and the separation angle."""

from __future__ import annotations

import math

import numpy as np
import sympy
from scipy.integrate import solve_ivp

from derivations.backlash import (
    GAMMA,
    separation_angle,
)
from derivations.dimensions import FORCE, LENGTH, MASS, TIME, dimension_of
from derivations.symbols import DIMENSIONS, omega
from report.chapters.appendix_a.claims.time_domain import DRIVE_OMEGA, PERIOD
from report.chapters.chapter_4.claims.section_4_2 import SOURCE
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.second_ways import second_way
from report.evidence import Evidence

LOAD_MASS, LOAD_DAMPING = sympy.symbols("M D", positive=True)
RATIO = 1 / 99
PRINTED_GAMMA = 634.6652


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_roles(), _gamma(), _separation())


def _roles() -> Claim:
    time = sympy.Symbol("t", positive=True)
    speed = sympy.Function("v")
    flight = sympy.Eq(LOAD_MASS * speed(time).diff(time) + LOAD_DAMPING * speed(time), 0)
    free = sympy.dsolve(flight, speed(time), ics={speed(0): 1}).rhs
    without_inertia = sympy.limit(free, LOAD_MASS, 0, "+")
    return Claim(
        id="txt-4.2.3-roles",
        parts=(
            Part(
                "$D$ as the amount of inertia, $M$ as the amount of friction",
                Assertion(
                    statement="the load keeps its speed longer with a larger $D$ or a smaller $M$",
                    derived=free.diff(LOAD_DAMPING).is_positive is True
                    and free.diff(LOAD_MASS).is_negative is True,
                    evidence=f"a load in free flight has $v/v_0 = {sympy.latex(free)}$",
                    method="sign of the derivatives of the solution of $M\\dot v + Dv = 0$",
                ),
                second_way(
                    "numeric integration, by which twice the $M$ leaves more speed and twice the $D$ less",
                    _speed_left(RATIO / 2, RATIO) < _speed_left(RATIO, RATIO) < _speed_left(2 * RATIO, RATIO),
                ),
            ),
            Part(
                "$D = 0$ is inertia-controlled: the load flies on with the speed it has",
                SameExpression(sympy.Integer(1), free.subs(LOAD_DAMPING, 0), left=r"\frac{v}{v_0}"),
            ),
            Part(
                "$M = 0$ is friction-controlled: the load stops at once",
                SameExpression(sympy.Integer(0), without_inertia, left=r"\frac{v}{v_0}"),
            ),
        ),
        explanation=(
            "$M$ is the inertia and $D$ the friction; the sentence has them exchanged. The next sentence, on "
            "what is left for $D = 0$ and for $M = 0$, is right and contradicts it."
        ),
        consequence="Read by the first sentence, an identified ratio $M/D$ would be taken for its inverse.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _gamma() -> Claim:
    gamma = RATIO * 2 * math.pi * 100
    units = DIMENSIONS | {LOAD_MASS: MASS, LOAD_DAMPING: FORCE * TIME / LENGTH}
    unit = dimension_of(LOAD_MASS / LOAD_DAMPING * omega, units)
    return Claim(
        id="txt-4.2.3-gamma",
        parts=(
            Part(
                "value",
                PrintedDigits("634.6652", gamma),
                Confirmation(
                    "the decay of a free load over a radian of the drive, integrated numerically",
                    CloseNumbers(-1 / math.log(_speed_left(RATIO, 1 / DRIVE_OMEGA)), gamma, 1e-9),
                ),
                Slip("1/0.99 is put in for 1/99", 2 * math.pi * 100 / 0.99, Verdict.ERRATUM),
            ),
            Part(
                "unit",
                Assertion(
                    statement="$\\gamma$ is a frequency, in hertz",
                    derived=unit == TIME**-1,
                    evidence=f"$M/D$ is a time and $\\omega$ its inverse: the unit is {unit}",
                    method="dimension check of equation 2.45",
                ),
                Confirmation(
                    "its value in milliseconds, which is that in seconds",
                    CloseNumbers((1000 * RATIO) * (DRIVE_OMEGA / 1000), gamma),
                ),
            ),
        ),
        explanation=(
            f"With the ratio that is printed $\\gamma = 200\\pi/99 = {gamma:.4f}$, a pure number. The value "
            "that is printed is a hundred times as large and comes out with $M/D = 1/0.99$."
        ),
        consequence=(
            "The separation angle that follows belongs to a load that is nearly without friction; with 1/99 "
            "it is a hundred times larger."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _speed_left(ratio: float, time: float) -> float:
    """Return v/v0 of a free load after a time (s) for M/D (s), by numeric integration."""
    run = solve_ivp(lambda _, speed: -speed / ratio, (0, time), [1.0], rtol=1e-12, atol=1e-14)
    return float(run.y[0, -1])


def _angle(gamma: float) -> float:
    """Return the separation angle, rad."""
    return float(separation_angle().subs(GAMMA, gamma))


def _separation() -> Claim:
    right = _angle(RATIO * 2 * math.pi * 100)
    return Claim(
        id="txt-4.2.3-separation-angle",
        parts=(
            Part(
                "arithmetic, from 634.6652",
                PrintedDigits("0.0016", _angle(PRINTED_GAMMA), "rad"),
                Confirmation(
                    "the angle of $\\gamma + j$",
                    CloseNumbers(float(np.angle(PRINTED_GAMMA + 1j)), _angle(PRINTED_GAMMA)),
                ),
            ),
            Part(
                "for $M/D = 1/99$ at 100 Hz",
                PrintedDigits("0.0016", right, "rad"),
                Confirmation(
                    "the angle of $\\gamma + j$",
                    CloseNumbers(float(np.angle(RATIO * DRIVE_OMEGA + 1j)), right),
                ),
                Slip("the value printed for gamma is used", _angle(PRINTED_GAMMA), Verdict.EXPLAINED),
            ),
            _unit_of_the_angle(),
        ),
        explanation=(
            f"The arctangent is right for the printed $\\gamma$. For the stated ratio it is {right:.4f} rad, "
            f"or {math.degrees(right):.2f} degrees, and it is an angle, not a time."
        ),
        consequence="None on later numbers: the section computes no waveform from it.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _unit_of_the_angle() -> Part:
    as_time = _angle(PRINTED_GAMMA) * PERIOD / (2 * math.pi)
    return Part(
        "unit",
        Assertion(
            statement="0.0016 is a time, in seconds",
            derived=PrintedDigits("0.0016", as_time).compare().agrees,
            evidence=(
                f"the arctangent is an angle in radians; at 100 Hz that angle takes {1e6 * as_time:.2f} µs"
            ),
            method="angle over angular frequency",
        ),
        Confirmation(
            "the share of a turn, of the period of 10 ms",
            CloseNumbers(math.degrees(_angle(PRINTED_GAMMA)) / 360 / 100, as_time),
        ),
    )
