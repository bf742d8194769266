"""Claims of section 5.2.3 on the element itself: separation, limits, contours (equation 5.9)."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.backlash import GAMMA, limits, separation_angle
from derivations.element_steps import contours, general_backlash, slopes
from derivations.element_steps.limits import step as limits_step
from derivations.identity import UnprovenError
from derivations.proven_step import ProvenStep
from report.claim import Claim, Confirmation, Part
from report.comparisons.assertion import Assertion
from report.comparisons.expression import SameExpression
from report.evidence import Evidence
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash

GAMMAS = (0.01, 0.1, 0.3, 1.0, 1.25, 1.5, 3.0, 10.0, 100.0)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_separation(), _limits(), _contours())


def _separation() -> Claim:
    mass, damping, omega = sympy.symbols("M D omega", positive=True)
    derived = separation_angle().subs(GAMMA, mass * omega / damping)
    return Claim(
        id="eq-5.9",
        parts=(
            Part(
                "", SameExpression(sympy.atan(damping / (mass * omega)), derived, left=sympy.Symbol("phi_s"))
            ),
        ),
        explanation=(
            "Equation 2.44 with $\\gamma = M\\omega/D$ put in. A higher frequency gives an earlier "
            "separation, as the text says."
        ),
        source="derivations/backlash.py",
    )


def _limits() -> Claim:
    delay = sympy.Symbol("tau", positive=True)
    friction, inertia = limits(sympy.Integer(0)), limits(sympy.oo)
    return Claim(
        id="txt-5.2.3-limits",
        parts=(
            Part(
                "$\\gamma \\to 0$, contact",
                SameExpression(1 - sympy.cos(delay), friction.ratio, left=r"\frac{b}{A}"),
            ),
            Part(
                "$\\gamma \\to \\infty$, contact",
                SameExpression(delay - sympy.sin(delay), inertia.ratio, left=r"\frac{b}{A}"),
            ),
        ),
        explanation=(
            "Separation, flight and contact of the general element tend to those of friction-controlled "
            "backlash for $\\gamma \\to 0$ and of inertia-controlled for $\\gamma \\to \\infty$; $\\tau$ is "
            "the phase of flight. The figure shows it, the limits prove it."
        ),
        source="derivations/backlash.py",
    )


def _between(gamma: float) -> bool:
    """Return whether the contour of N for one γ stays in the region between those of the two limits."""
    from matplotlib.path import Path

    ratios = np.linspace(1e-4, 1, 3000)
    friction = FrictionBacklash(1.0).describing_function(1 / (ratios * 1.9999))
    inertia = InertiaBacklash(1.0).describing_function(1 / (ratios * (math.pi - 1e-6)))
    outline = np.concatenate([friction, inertia[::-1]])
    element = ViscousBacklash(1.0, gamma)
    contour = element.describing_function(
        1 / (np.linspace(0.02, 0.999, 200) * float(element.domain(1.0))), 1.0
    )
    inside = Path(np.column_stack([outline.real, outline.imag])).contains_points(
        np.column_stack([contour.real, contour.imag]), radius=1e-5
    )
    return bool(inside.all())


def _proven(*steps: ProvenStep) -> bool:
    """Return whether every equation of the steps is proven."""
    try:
        for step in steps:
            step.tell()
    except UnprovenError:
        return False
    return True


def _contours() -> Claim:
    proven = _proven(general_backlash.describing_function(), limits_step(), slopes.step(), contours.step())
    statement = "every viscous contour lies between those of friction and inertia"
    return Claim(
        id="txt-5.2.3-contours-bounded",
        parts=(
            Part(
                "for every $\\gamma$",
                Assertion(
                    statement=statement,
                    derived=proven,
                    evidence=(
                        "$N$ as a map of $b/A$ and $\\gamma$ has a Jacobian without zeros, and takes the "
                        "edge of its domain to the two contours and a piece of the imaginary axis"
                    ),
                    method="proof in the derivation of the describing functions",
                ),
                Confirmation(
                    "200 points of each of nine contours, $\\gamma$ from 0.01 to 100",
                    Assertion(
                        statement=statement,
                        derived=all(_between(gamma) for gamma in GAMMAS),
                        evidence="they lie in the region that the two limits enclose",
                        method="contours of $N$, computed",
                    ),
                ),
            ),
        ),
        explanation=(
            "It is so for every $\\gamma$, with the right contact equation. The contours that the thesis "
            "drew, for $1 < \\gamma < 3/2$, come from complex contact angles and could not show it. Besides, "
            "each point between the two limits belongs to one $b/A$ and one $\\gamma$ only."
        ),
        source="derivations/element_steps/contours.py",
    )
