"""Claims of sections 2.3.1 to 2.3.3: harmonic balance and describing function (2.25 to 2.27, 2.34, 2.35)."""

from __future__ import annotations

import sympy

from derivations.symbols import A, omega, t
from report.claim import Claim, Confirmation, Impact, Mathematics, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.evidence import Evidence
from report.numbers.exact_response import gain
from trimmer import filtering_ratio

SOURCE = "report/chapters/chapter_2/claims/section_2_3_method.py"
LIMIT_CYCLE_OMEGA = 4607.7
COSINE_PART = sympy.Symbol("a_1", real=True)
SINE_PART = sympy.Symbol("b_1", positive=True)


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _harmonic_balance(),
        _filtering_hypothesis(evidence),
        _sinusoid("eq-2.27"),
        _sinusoid("txt-2.3.3-df-definition"),
        _ratio_of_signals(),
        _describing_function(),
    )


def _harmonic_balance() -> Claim:
    linear, nonlinear, signal = sympy.symbols("G N Y")
    loop = sympy.expand((signal - linear * (-nonlinear * signal)) / signal)
    return Claim(
        id="eq-2.25",
        parts=(Part("", SameExpression(total(nonlinear * linear, 1), loop)),),
        explanation=(
            "Round the loop with negative feedback a sinusoid $Y$ comes back as $-NGY$. It sustains itself "
            "with a nonzero amplitude exactly if $1 + NG = 0$."
        ),
        source=SOURCE,
    )


def _filtering_hypothesis(evidence: Evidence) -> Claim:
    numbers = evidence.numbers
    system = numbers.displacement_only
    third = 3 * LIMIT_CYCLE_OMEGA
    ratios = [float(filtering_ratio(system, LIMIT_CYCLE_OMEGA, n)) for n in range(2, 20)]
    return Claim(
        id="eq-2.26",
        parts=(
            Part(
                "at the predicted limit cycle",
                Assertion(
                    statement="the linear part passes every harmonic less than the fundamental",
                    derived=max(ratios) < 1,
                    evidence=(
                        f"at {LIMIT_CYCLE_OMEGA} rad/s the second is passed {ratios[0]:.3f}, the third "
                        f"{ratios[1]:.3f} times as well"
                    ),
                    method="frequency response at the harmonics",
                ),
                Confirmation(
                    "exact coefficients, 40 digits",
                    CloseNumbers(float(gain(numbers, third) / gain(numbers, third / 3)), ratios[1]),
                ),
                printed_form=Mathematics(r"|G(j\omega)| \gg |G(jn\omega)|, \quad n = 2, 3, \dots"),
            ),
        ),
        explanation=(
            "As a condition this is the usual one. It is stricter than needed: a nonlinearity that is odd "
            "makes no even harmonics, and what counts is the ratio times the nonlinearity's own harmonic. "
            "Whether it is met depends on the frequency; see section 5.1.2."
        ),
        source="trimmer/low_pass.py",
    )


def _sinusoid(claim_id: str) -> Claim:
    exponential = A * sympy.exp(sympy.I * omega * t)
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "$A\\sin(\\omega t) = Ae^{j\\omega t}$",
                SameExpression(exponential, A * sympy.sin(omega * t), left=sympy.Symbol("u")),
                Confirmation(
                    "Euler's formula", SameExpression(sympy.im(exponential), A * sympy.sin(omega * t))
                ),
                Slip("the imaginary part is not taken", exponential, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "A real sine is not a complex exponential: it is its imaginary part, $A\\sin\\omega t = "
            "\\mathrm{Im}\\,Ae^{j\\omega t}$. What is meant is the phasor that stands for the sine."
        ),
        consequence="None: the ratio of phasors in equation 2.35 is right.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def modulus_and_angle() -> tuple[sympy.Expr, sympy.Expr]:
    """Return magnitude and phase of the first harmonic, equations 2.32 and 2.33."""
    return sympy.sqrt(COSINE_PART**2 + SINE_PART**2), sympy.atan(COSINE_PART / SINE_PART)


def _ratio_of_signals() -> Claim:
    modulus, angle = sympy.symbols("M phi", positive=True)
    printed = modulus * sympy.sin(omega * t + angle) / (A * sympy.sin(omega * t))
    derived = modulus / A * sympy.exp(sympy.I * angle)
    values = {modulus: 1, A: 1, angle: sympy.pi / 3, omega: 1}
    early, late = (complex(printed.subs(values).subs(t, instant)) for instant in (sympy.Rational(1, 2), 1))
    phasors = modulus * sympy.exp(sympy.I * (omega * t + angle)) / (A * sympy.exp(sympy.I * omega * t))
    return Claim(
        id="eq-2.34",
        parts=(
            Part(
                "",
                SameExpression(printed, derived, left=sympy.Symbol("N")),
                Confirmation("the ratio of the phasors", SameExpression(sympy.simplify(phasors), derived)),
                Slip(
                    "the ratio of the signals is taken, not that of their phasors", printed, Verdict.ERRATUM
                ),
            ),
        ),
        explanation=(
            f"The ratio of two sines depends on time (for $\\phi = 60$ degrees it is {early.real:.2f} at "
            f"$\\omega t = 0.5$ and {late.real:.2f} at $\\omega t = 1$) and is infinite at every zero of the "
            "input. The describing function is the ratio of the phasors, a complex constant."
        ),
        consequence="None: equation 2.35 takes the ratio of the phasors.",
        impact=Impact.NOTATION,
        source=SOURCE,
    )


def _describing_function() -> Claim:
    modulus, angle = modulus_and_angle()
    printed = (SINE_PART + sympy.I * COSINE_PART) / A
    derived = modulus / A * sympy.exp(sympy.I * angle)
    point = {A: 2, COSINE_PART: -0.7, SINE_PART: 1.3}
    return Claim(
        id="eq-2.35",
        parts=(
            Part(
                "",
                SameExpression(
                    printed, sympy.simplify(sympy.expand_complex(derived)), left=sympy.Symbol("N")
                ),
                Confirmation(
                    "numbers", CloseNumbers(complex(printed.subs(point)), complex(derived.subs(point)))
                ),
            ),
        ),
        explanation=(
            "Output phasor over input phasor, for the convention that $a$ goes with the cosine and $b$ with "
            "the sine."
        ),
        source=SOURCE,
    )
