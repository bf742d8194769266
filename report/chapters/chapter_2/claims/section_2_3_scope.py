"""Claims of section 2.3 on what the method is for: Van der Pol's oscillator, and what N depends on."""

from __future__ import annotations

import numpy as np
import sympy
from scipy.integrate import solve_ivp

from derivations.backlash import GAMMA, separation_angle
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.expression import SameExpression
from report.evidence import Evidence
from trimmer.elements.viscous_backlash import ViscousBacklash

PARAMETER, POSITION, VELOCITY = sympy.symbols("alpha x v", real=True)
ACCELERATION = -PARAMETER * (POSITION**2 - 1) * VELOCITY - POSITION
"""Van der Pol's equation x'' + α (x² − 1) x' + x = 0."""
DAMPING = 1.0
TIME_CONSTANT = 1e-3
AMPLITUDE = 2.0
OMEGAS = (200 * np.pi, 4609.5)
"""Angular frequencies of the drive and near the limit cycle, rad/s."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_van_der_pol(), _amplitude_only())


def _van_der_pol() -> Claim:
    return Claim(
        id="txt-2.3.2-van-der-pol",
        parts=(_without_damping(), _elliptic()),
        explanation=(
            "For $\\alpha = 0$ nothing is dissipated: every orbit is closed and none is a limit cycle by the "
            "thesis's own definition, so the condition is $\\alpha > 0$. And an ellipse over position and "
            "velocity is a sinusoid, the very shape that the method assumes. Van der Pol's limit cycle is "
            f"nearly that for small $\\alpha$, and leaves it as $\\alpha$ grows: at $\\alpha = "
            f"{DAMPING:.0f}$ the third harmonic of the position has {100 * _third_harmonic():.0f} % of the "
            "first."
        ),
        consequence=(
            "None on numbers. The caution is right and section 6.1 repeats it; its example is the other end, "
            "large $\\alpha$."
        ),
        impact=Impact.LOCAL,
        source="report/chapters/chapter_2/claims/section_2_3_scope.py",
    )


def _without_damping() -> Part:
    gained = sympy.expand(VELOCITY * (ACCELERATION + POSITION))
    time, radius = sympy.symbols("t r", positive=True)
    circle = radius * sympy.cos(time)
    residual = circle.diff(time, 2) - ACCELERATION.subs(
        {PARAMETER: 0, POSITION: circle, VELOCITY: circle.diff(time)}
    )
    return Part(
        "$\\alpha = 0$",
        Assertion(
            statement="there is a limit cycle, to which other motions tend",
            derived=gained.subs(PARAMETER, 0) != 0,
            evidence=(
                f"$(x^2 + \\dot x^2)/2$ changes by ${sympy.latex(gained)}$, $v = \\dot x$, and for "
                "$\\alpha = 0$ not at all: every motion keeps its amplitude"
            ),
            method="balance of energy",
        ),
        Confirmation(
            "a circle of any radius solves the equation", SameExpression(residual, sympy.Integer(0))
        ),
    )


def _elliptic() -> Part:
    time, radius, turning = sympy.symbols("t A omega", positive=True)
    sine = radius * sympy.sin(turning * time)
    ellipse = (sine / radius) ** 2 + (sine.diff(time) / (radius * turning)) ** 2
    conserved = sympy.simplify(ellipse) == 1
    return Part(
        "the elliptic shape",
        Assertion(
            statement="a limit cycle of elliptic shape is not a sinusoid",
            derived=not conserved,
            evidence="$x = A\\sin\\omega t$ satisfies $(x/A)^2 + (\\dot x/(A\\omega))^2 = 1$, an ellipse",
            method="the sinusoid put into the equation of an ellipse",
        ),
        Confirmation("simplification to one", SameExpression(sympy.expand_trig(ellipse), sympy.Integer(1))),
    )


def _third_harmonic() -> float:
    """Return the third harmonic of Van der Pol's limit cycle, as a share of the first."""
    flow = sympy.lambdify((PARAMETER, POSITION, VELOCITY), ACCELERATION)

    def upwards(_: float, state: np.ndarray) -> float:
        return float(state[0])

    upwards.direction = 1  # type: ignore[attr-defined]
    settled = solve_ivp(
        lambda _, state: [state[1], flow(DAMPING, *state)],
        (0, 60),
        [2.0, 0.0],
        events=upwards,
        dense_output=True,
        rtol=1e-8,
        atol=1e-10,
    )
    start, end = settled.t_events[0][-2:]
    period = settled.sol(np.linspace(start, end, 512, endpoint=False))[0]
    lines = np.abs(np.fft.rfft(period))
    return float(lines[3] / lines[1])


def _amplitude_only() -> Claim:
    element = ViscousBacklash(1.0, TIME_CONSTANT)
    values = [complex(element.describing_function(AMPLITUDE, omega)) for omega in OMEGAS]
    statement = "the describing functions of backlash and of Coulomb friction depend on the amplitude alone"
    separation = separation_angle()
    return Claim(
        id="txt-2.3.3-amplitude-only",
        parts=(
            Part(
                "",
                Assertion(
                    statement=statement,
                    derived=abs(values[0] - values[1]) < 1e-9,
                    evidence=(
                        f"a load with $M/D$ of 1 ms has {values[0].real:.3f} {values[0].imag:+.3f} j at "
                        f"{OMEGAS[0]:.0f} rad/s and {values[1].real:.3f} {values[1].imag:+.3f} j at "
                        f"{OMEGAS[1]:.0f} rad/s, with two gaps of amplitude"
                    ),
                    method="the describing function of viscous-controlled backlash at two frequencies",
                ),
                Confirmation(
                    "the derived phase of separation",
                    Assertion(
                        statement=statement,
                        derived=GAMMA not in separation.free_symbols,
                        asserted=False,
                        evidence=f"the bridge separates at ${sympy.latex(separation)}$",
                        method="it contains $\\gamma = M\\omega/D$",
                    ),
                ),
            ),
        ),
        explanation=(
            "True of friction-controlled and inertia-controlled backlash and of a relay. Viscous-controlled "
            "backlash, the general case, depends on $\\gamma = M\\omega/D$ too, as section 2.3.4 itself "
            "says, and so does friction as section 5.2.5 writes it."
        ),
        consequence=(
            "For a load with inertia and friction one curve does not serve all frequencies; equation 2.55 is "
            "to be used and not 2.56."
        ),
        impact=Impact.LOCAL,
        source="derivations/backlash.py",
    )
