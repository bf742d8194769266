"""Findings of every verdict, with everything that is hard to show."""

from collections.abc import Iterable

import sympy

from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.shown import Mathematics, Number, Shown, Words
from report.judging.verdict import Impact, Severity, Verdict
from tests.report.rendering.sample_formulas import CASES, DOTS, SPECIAL, long_coefficient, state_matrix


def part(
    verdict: Verdict,
    printed: Shown,
    derived: Shown,
    label: str = "",
    slip: str = "",
    method: str = "simplification",
    severity: Severity = Severity.RESULT,
    item: str = "",
) -> JudgedPart:
    """Return a judged part with its fields in the order they are written here."""
    item = item or f"{label}: {printed} and {derived}"
    severity = severity if verdict.is_wrong else Severity.NONE
    return JudgedPart(label, verdict, printed, derived, method, slip, item=item, severity=severity)


def finding(
    id: str,
    kind: Kind,
    section: str,
    title: str,
    parts: Iterable[JudgedPart],
    explanation: str,
    consequence: str = "",
    impact: Impact = Impact.NONE,
    source: str = "derivations/mechanism.py",
    lines: tuple[int, int] | None = None,
    paragraph: int | None = None,
) -> Finding:
    """Return a finding with the worst verdict of its parts."""
    parts = tuple(parts)
    worst = max((p.verdict for p in parts), key=lambda verdict: verdict.rank)
    return Finding(
        id, kind, section, title, worst, explanation, consequence, impact, source, parts, lines, paragraph
    )


def chapter_two() -> tuple[Finding, ...]:
    """Return findings that are hard to set."""
    matrix = sympy.latex(state_matrix())
    wrong = matrix.replace("- k_{1} - k_{2}", "- k_{1} + k_{2}")
    integrals = [
        part(Verdict.REPRODUCED, Mathematics(r"\frac{A}{4}"), Mathematics(r"\frac{A}{4}"), "first line"),
        part(
            Verdict.ERRATUM,
            Mathematics(r"\frac{b^{2} - 2 A b}{A}"),
            Mathematics(r"- \frac{b^{2} - 2 A b}{2 A}"),
            "second line",
            "the factor one half of the integral is lost",
            "simplification; confirmed by quadrature with 30 digits",
        ),
        part(
            Verdict.EXPLAINED,
            Number("-1.05e-3", "m"),
            Number("-1.0496e-3", "m"),
            "third line",
            "the coefficient is rounded to three digits",
        ),
    ]
    return (
        finding(
            "eq-2.8",
            Kind.EQUATION,
            "2.2.1",
            f"velocity of the pin {SPECIAL}",
            [
                part(
                    Verdict.REPRODUCED,
                    Mathematics(r"\dot{u} = \omega \hat{u} \cos{\left(\omega t \right)}"),
                    Mathematics(r"\dot{u} = \omega \hat{u} \cos{\left(\omega t \right)}"),
                )
            ],
            r"The derivative of $u = \hat{u} \sin(\omega t)$ is right; see [equation 2.12](#eq-2.12).",
            lines=(3, 5),
            paragraph=4,
        ),
        finding(
            "eq-2.9",
            Kind.EQUATION,
            "2.2.1",
            "equations of motion",
            [
                part(
                    Verdict.ERRATUM,
                    Mathematics(DOTS.replace("+ k_{1}", "- k_{1}")),
                    Mathematics(DOTS),
                    "first mass",
                    "a sign is turned",
                ),
                part(
                    Verdict.REPRODUCED,
                    Mathematics(r"m_{2} \ddot{q}_{2} = 0"),
                    Mathematics(r"m_{2} \ddot{q}_{2} = 0"),
                    "second mass",
                ),
            ],
            r"The spring force $k_1 (q_1 - q_2)$ has the wrong sign, so that $\ddot{q}_1$ grows.",
            r"The A-matrix inherits it; poles move by $\frac{\Delta\omega}{\omega} = 3\,\%$.",
            Impact.DOWNSTREAM,
        ),
        finding(
            "eq-2.12",
            Kind.EQUATION,
            "2.2.1",
            "A-matrix",
            [
                part(
                    Verdict.ERRATUM,
                    Mathematics(f"A = {wrong}"),
                    Mathematics(f"A = {matrix}"),
                    severity=Severity.CONCLUSION,
                )
            ],
            "One entry has a minus where the model gives a plus.",
            "Listing A.1 uses the right one.",
            Impact.LOCAL,
        ),
        finding(
            "eq-2.37",
            Kind.EQUATION,
            "2.3.4",
            "integrals, each with its printed value",
            integrals,
            r"The second line lacks $\tfrac{1}{2}$, as $\frac{4 b}{\pi A} \left(\frac{b}{A} - 1\right)$.",
        ),
        finding(
            "fig-2.3",
            Kind.FIGURE,
            "2",
            "linear system",
            [
                part(
                    Verdict.REPRODUCED,
                    Words("a block $G(s)$ between $u$ and $y$"),
                    Words("a block $G(s)$ between $u$ and $y$"),
                    method="compared by eye",
                )
            ],
            "The figure follows from the text.",
        ),
        finding(
            "eq-2.36",
            Kind.EQUATION,
            "2.3.4",
            "waveform",
            [
                part(
                    Verdict.EXPLAINED,
                    Mathematics(CASES),
                    Mathematics(CASES.replace("- b", r"- \frac{g}{2}").replace("+ b", r"+ \frac{g}{2}")),
                    slip="the symbol b is half the gap here",
                    severity=Severity.SLIP,
                )
            ],
            "The waveform is right if $b$ is read as half the gap.",
            impact=Impact.NOTATION,
        ),
    )


def chapter_five() -> tuple[Finding, ...]:
    """Return findings with numbers, a long sum, and one that cannot be checked."""
    long = long_coefficient()
    return (
        finding(
            "tab-5.1",
            Kind.TABLE,
            "5.1.1",
            "coefficients",
            [
                part(
                    Verdict.ERRATUM,
                    Mathematics(long.replace("m_{4}", "m_{3}", 1)),
                    Mathematics(long),
                    "fourth coefficient",
                    "an index is mistyped",
                ),
                part(
                    Verdict.REPRODUCED,
                    Number("488", "Hz"),
                    Number("488.2", "Hz"),
                    "frequency",
                    method="every printed digit",
                    item="488 Hz",
                ),
            ],
            "The coefficient is a sum of many products.",
        ),
        finding(
            "eq-5.1",
            Kind.EQUATION,
            "5.1.1",
            "numerator",
            [part(Verdict.COPY, Number("707.6"), Number("7.076e7"), slip="the sign of the power is lost")],
            "The copy has no power of ten where the coefficient needs one.",
            lines=(7, 7),
        ),
        finding(
            "txt-5.2.1-impulse-1e-8",
            Kind.STATEMENT,
            "5.2.1",
            "an impulse of 1e-8 starts no limit cycle",
            [
                part(
                    Verdict.NOT_CHECKABLE,
                    Words("“an impulse of 1e-8 does not lead to a limit cycle”"),
                    Words("the width of the impulse and the solver's step"),
                    method="not checked",
                )
            ],
            "Whether the motion reaches the limit cycle depends on the energy of the impulse.",
        ),
        finding(
            "txt-5.1.2-roll-off",
            Kind.STATEMENT,
            "5.1.2",
            "roll-off of −60 dB per decade",
            [part(Verdict.ERRATUM, Number("-60", "dB/decade"), Number("-40", "dB/decade"))],
            "The numerator has degree 5, the denominator 7.",
            source="trimmer/linear/low_pass.py",
            lines=(9, 10),
            paragraph=2,
        ),
        finding(
            "fig-5.1",
            Kind.FIGURE,
            "5",
            "locus of the open loop",
            [part(Verdict.REPRODUCED, Words("a locus"), Words("a locus"), "locus", method="compared by eye")],
            "The figure follows from the text.",
        ),
        finding(
            "fig-5.2",
            Kind.FIGURE,
            "5",
            "spectrum of the output",
            [
                part(Verdict.ERRATUM, Number("545", "Hz"), Number("550", "Hz"), "peak"),
                part(Verdict.REPRODUCED, Number("488", "Hz"), Number("488", "Hz"), "again", item="488 Hz"),
            ],
            "The peak is the fifth harmonic of the drive, not a mode.",
        ),
    )


def appendix_a() -> tuple[Finding, ...]:
    """Return the finding on a listing, which belongs to no section of the appendix."""
    return (
        finding(
            "lst-A.1",
            Kind.LISTING,
            "A",
            "matrices of the trimmer",
            [
                part(Verdict.ERRATUM, Words("`G = G1`"), Words("`G = G1 + s*G2`"), "line 58"),
                part(Verdict.REPRODUCED, Words("`k5 = 7;`"), Words("`k5 = 7;`"), "line 12"),
            ],
            "The listing keeps one of two responses: `sys(1, 1)`.",
            "The loop of section 5.2 lacks the velocity of the pin.",
            Impact.DOWNSTREAM,
            lines=(1190, 1199),
        ),
    )
