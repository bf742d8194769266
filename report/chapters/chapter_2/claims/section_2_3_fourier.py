"""Claims of section 2.3.3 on the Fourier series of the output and its first harmonic (2.28 to 2.33)."""

from __future__ import annotations

import sympy

from derivations.waveform import THETA, Segment, Waveform
from report.chapters.chapter_2.claims.section_2_3_method import (
    COSINE_PART,
    SINE_PART,
    SOURCE,
    modulus_and_angle,
)
from report.claim import Claim, Mathematics, Part
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.evidence import Evidence

MEAN, COSINES, SINES = sympy.Symbol("a_0"), sympy.symbols("a_1:3"), sympy.symbols("b_1:3")


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _fourier_series(),
        _fourier_coefficients(),
        _fundamental_coefficients(),
        _first_harmonic(),
        _magnitude(),
        _phase(),
    )


def _series() -> sympy.Expr:
    harmonics = (
        a * sympy.cos(n * THETA) + b * sympy.sin(n * THETA)
        for n, (a, b) in enumerate(zip(COSINES, SINES, strict=True), start=1)
    )
    return total(MEAN / 2, *harmonics)


def _over_period(signal: sympy.Expr) -> Waveform:
    return Waveform((Segment(-sympy.pi, sympy.pi, signal),))


def _fourier_series() -> Claim:
    wave = _over_period(_series())
    rebuilt = wave.cosine_coefficient(0) / 2 + sympy.Add(
        *(
            wave.cosine_coefficient(n) * sympy.cos(n * THETA)
            + wave.sine_coefficient(n) * sympy.sin(n * THETA)
            for n in (1, 2)
        )
    )
    form = Mathematics(r"y = \frac{a_0}{2} + \sum_{n=1}^\infty (a_n \cos n\omega t + b_n \sin n\omega t)")
    return Claim(
        id="eq-2.28",
        parts=(
            Part(
                "up to $n = 2$",
                SameExpression(_series(), sympy.expand(rebuilt)),
                printed_form=form,
                derived_form=form,
            ),
        ),
        explanation=(
            "A signal of two harmonics is rebuilt from its coefficients by the printed series, with half "
            "of $a_0$."
        ),
        source=SOURCE,
    )


def _fourier_coefficients() -> Claim:
    wave = _over_period(_series())
    rows = (
        ("$a_0$", wave.cosine_coefficient(0), MEAN),
        *((f"$a_{n}$", wave.cosine_coefficient(n), COSINES[n - 1]) for n in (1, 2)),
        *((f"$b_{n}$", wave.sine_coefficient(n), SINES[n - 1]) for n in (1, 2)),
    )
    return Claim(
        id="eq-2.29",
        parts=tuple(
            Part(label, SameExpression(sympy.expand(integral), symbol)) for label, integral, symbol in rows
        ),
        explanation=(
            "The printed integrals, over a signal of two harmonics, give back each of its coefficients."
        ),
        source=SOURCE,
    )


def _fundamental_coefficients() -> Claim:
    wave = _over_period(_series())
    return Claim(
        id="eq-2.30",
        parts=(
            Part("$a_1$", SameExpression(sympy.expand(wave.cosine_coefficient()), COSINES[0])),
            Part("$b_1$", SameExpression(sympy.expand(wave.sine_coefficient()), SINES[0])),
        ),
        explanation="Equation 2.29 for $n = 1$.",
        source=SOURCE,
    )


def _first_harmonic() -> Claim:
    modulus, angle = modulus_and_angle()
    shifted = sympy.expand_trig(modulus * sympy.sin(THETA + angle))
    printed = total(COSINE_PART * sympy.cos(THETA), SINE_PART * sympy.sin(THETA))
    return Claim(
        id="eq-2.31",
        parts=(
            Part(
                "with $M$ and $\\phi$ of equations 2.32 and 2.33",
                SameExpression(printed, sympy.simplify(shifted)),
                derived_form=Mathematics(r"M \sin(\omega t + \phi)"),
            ),
        ),
        explanation=(
            "The sum of cosine and sine is one sine with the printed magnitude and phase, for $b_1 > 0$."
        ),
        source=SOURCE,
    )


def _magnitude() -> Claim:
    modulus, _ = modulus_and_angle()
    phasor = SINE_PART + sympy.I * COSINE_PART
    return Claim(
        id="eq-2.32",
        parts=(Part("", SameExpression(modulus, sympy.Abs(phasor), left=sympy.Symbol("M"))),),
        explanation="The magnitude of $b_1 + ja_1$.",
        source=SOURCE,
    )


def _phase() -> Claim:
    _, angle = modulus_and_angle()
    derived = sympy.atan2(COSINE_PART, SINE_PART)
    return Claim(
        id="eq-2.33",
        parts=(Part("for $b_1 > 0$", SameExpression(angle, derived, left=sympy.Symbol("phi"))),),
        explanation=(
            "The angle of $b_1 + ja_1$ as long as $b_1 > 0$, as for every backlash. The arctangent of a "
            "ratio loses the quadrant: for $b_1 < 0$ it is off by half a turn, and Coulomb friction driven "
            "by a displacement has $b_1 = 0$."
        ),
        source=SOURCE,
    )
