"""Harmonics of an odd element by one integral over half a period."""

import sympy

from derivations.elements.harmonics import (
    HARMONIC,
    antiderivative,
    first_half,
    harmonic_integral,
    odd_harmonic,
)
from derivations.elements.proven_step import Equality, ProvenStep
from derivations.elements.waveform import THETA
from derivations.step import Formula


def step() -> ProvenStep:
    """Return the step on the method that the other steps use (thesis, equations 2.29 and 2.35)."""
    angle = HARMONIC * THETA
    return ProvenStep(
        "df-method",
        "Harmonics of an odd element",
        "The input is $A\\sin\\theta$ with $\\theta = \\omega t$, and the output $y$ repeats with it. "
        "Cosine and sine coefficients come from one complex integral. Every element here is odd, $y(\\theta "
        "+ \\pi) = -y(\\theta)$: the second half of the period adds $-e^{-jn\\pi}$ times the first. So even "
        "harmonics are zero, and for odd $n$ half a period is enough, from any phase $\\theta_0$ on. All "
        "gaps $g$ are total clearances.\n\nIn the steps below waveforms are definitions or follow from "
        "mechanics as told. Every integral has an antiderivative made of powers and exponentials, which is "
        "differentiated back to its integrand. That a waveform is odd is proven segment by segment. Where "
        "$n = 1$ has a line of its own, the line with $n$ holds for odd $n \\ge 3$.",
        (
            Formula(
                r"a_n = \frac{1}{\pi} \int_{0}^{2\pi} y \cos n\theta \, d\theta, \quad "
                r"b_n = \frac{1}{\pi} \int_{0}^{2\pi} y \sin n\theta \, d\theta",
                "2.29",
            ),
            Equality(
                r"\sin n\theta + j \cos n\theta",
                sympy.I * sympy.exp(-sympy.I * angle),
                sympy.sin(angle) + sympy.I * sympy.cos(angle),
            ),
            Formula(
                r"N_n = \frac{b_n + j a_n}{A} = \frac{j}{\pi A} \int_{0}^{2\pi} y\, e^{-jn\theta} \, d\theta",
                "2.35",
            ),
            Formula(
                r"N_n = \frac{j}{\pi A} \left(1 - e^{-jn\pi}\right) "
                r"\int_{\theta_0}^{\theta_0 + \pi} y\, e^{-jn\theta} \, d\theta"
            ),
        ),
        code=(harmonic_integral, antiderivative, first_half, odd_harmonic),
    )
