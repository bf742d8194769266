"""Findings of every verdict, with everything that is hard to show."""

from collections.abc import Iterable

import sympy

from report.judging.claim import Kind
from report.judging.finding import Finding, JudgedPart
from report.judging.shown import Mathematics, Number, Shown, Words
from report.judging.verdict import Impact, Severity, Verdict
from tests.report.rendering.sample_formulas import CASES, DOTS, SPECIAL, long_coefficient, state_matrix

KINDS = {
    "eq": Kind.EQUATION,
    "fig": Kind.FIGURE,
    "lst": Kind.LISTING,
    "tab": Kind.TABLE,
    "txt": Kind.STATEMENT,
}


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


def right(shown: Shown, label: str = "", **rest: str) -> JudgedPart:
    """Return a part that is as printed."""
    return part(Verdict.REPRODUCED, shown, shown, label, **rest)


def wrong(printed: Shown, derived: Shown, *rest: str, severity: Severity = Severity.RESULT) -> JudgedPart:
    """Return a part that is wrong, with label, slip and method."""
    return part(Verdict.ERRATUM, printed, derived, *rest, severity=severity)


def finding(
    id: str,
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
    """Return a finding with the kind that its id says, and the worst verdict of its parts."""
    parts, kind = tuple(parts), KINDS[id.partition("-")[0]]
    worst = max((p.verdict for p in parts), key=lambda verdict: verdict.rank)
    where = (source, parts, lines, paragraph)
    return Finding(id, kind, section, title, worst, explanation, consequence, impact, *where)


def chapter_two() -> tuple[Finding, ...]:
    """Return findings that are hard to set."""
    matrix, sign = sympy.latex(state_matrix()), "the factor one half of the integral is lost"
    turned = matrix.replace("- k_{1} - k_{2}", "- k_{1} + k_{2}")
    half_gap = CASES.replace("- b", r"- \frac{g}{2}").replace("+ b", r"+ \frac{g}{2}")
    product, half = Mathematics(r"\frac{b^{2} - 2 A b}{A}"), Mathematics(r"- \frac{b^{2} - 2 A b}{2 A}")
    rounded = ("third line", "the coefficient is rounded to three digits")
    integrals = [
        right(Mathematics(r"\frac{A}{4}"), "first line"),
        wrong(product, half, "second line", sign, "simplification; confirmed by quadrature with 30 digits"),
        part(Verdict.EXPLAINED, Number("-1.05e-3", "m"), Number("-1.0496e-3", "m"), *rounded),
    ]
    masses = [
        wrong(
            Mathematics(DOTS.replace("+ k_{1}", "- k_{1}")),
            Mathematics(DOTS),
            "first mass",
            "a sign is turned",
        ),
        right(Mathematics(r"m_{2} \ddot{q}_{2} = 0"), "second mass"),
    ]
    entry = wrong(Mathematics(f"A = {turned}"), Mathematics(f"A = {matrix}"), severity=Severity.CONCLUSION)
    waveform = part(
        Verdict.EXPLAINED,
        Mathematics(CASES),
        Mathematics(half_gap),
        slip="the symbol b is half the gap here",
        severity=Severity.SLIP,
    )
    return (
        finding(
            "eq-2.8",
            "2.2.1",
            f"velocity of the pin {SPECIAL}",
            [right(Mathematics(r"\dot{u} = \omega \hat{u} \cos{\left(\omega t \right)}"))],
            r"The derivative of $u = \hat{u} \sin(\omega t)$ is right; see [equation 2.12](#eq-2.12).",
            lines=(3, 5),
            paragraph=4,
        ),
        finding(
            "eq-2.9",
            "2.2.1",
            "equations of motion",
            masses,
            r"The spring force $k_1 (q_1 - q_2)$ has the wrong sign, so that $\ddot{q}_1$ grows.",
            r"The A-matrix inherits it; poles move by $\frac{\Delta\omega}{\omega} = 3\,\%$.",
            Impact.DOWNSTREAM,
        ),
        finding(
            "eq-2.12",
            "2.2.1",
            "A-matrix",
            [entry],
            "One entry has a minus where the model gives a plus.",
            "Listing A.1 uses the right one.",
            Impact.LOCAL,
        ),
        finding(
            "eq-2.37",
            "2.3.4",
            "integrals, each with its printed value",
            integrals,
            r"The second line lacks $\tfrac{1}{2}$, as $\frac{4 b}{\pi A} \left(\frac{b}{A} - 1\right)$.",
        ),
        finding(
            "fig-2.3",
            "2",
            "linear system",
            [right(Words("a block $G(s)$ between $u$ and $y$"), method="compared by eye")],
            "The figure follows from the text.",
        ),
        finding(
            "eq-2.36",
            "2.3.4",
            "waveform",
            [waveform],
            "The waveform is right if $b$ is read as half the gap.",
            impact=Impact.NOTATION,
        ),
    )


def chapter_five() -> tuple[Finding, ...]:
    """Return findings with numbers, a long sum, and one that cannot be checked."""
    long = long_coefficient()
    mistyped = Mathematics(long.replace("m_{4}", "m_{3}", 1))
    impulse = Words("“an impulse of 1e-8 does not lead to a limit cycle”")
    missing = Words("the width of the impulse and the solver's step")
    coefficients = [
        wrong(mistyped, Mathematics(long), "fourth coefficient", "an index is mistyped"),
        part(
            Verdict.REPRODUCED,
            Number("488", "Hz"),
            Number("488.2", "Hz"),
            "frequency",
            method="every printed digit",
            item="488 Hz",
        ),
    ]
    return (
        finding(
            "tab-5.1", "5.1.1", "coefficients", coefficients, "The coefficient is a sum of many products."
        ),
        finding(
            "eq-5.1",
            "5.1.1",
            "numerator",
            [part(Verdict.COPY, Number("707.6"), Number("7.076e7"), slip="the sign of the power is lost")],
            "The copy has no power of ten where the coefficient needs one.",
            lines=(7, 7),
        ),
        finding(
            "txt-5.2.1-impulse-1e-8",
            "5.2.1",
            "an impulse of 1e-8 starts no limit cycle",
            [part(Verdict.NOT_CHECKABLE, impulse, missing, method="not checked")],
            "Whether the motion reaches the limit cycle depends on the energy of the impulse.",
        ),
        finding(
            "txt-5.1.2-roll-off",
            "5.1.2",
            "roll-off of −60 dB per decade",
            [wrong(Number("-60", "dB/decade"), Number("-40", "dB/decade"))],
            "The numerator has degree 5, the denominator 7.",
            source="trimmer/linear/low_pass.py",
            lines=(9, 10),
            paragraph=2,
        ),
        finding(
            "fig-5.1",
            "5",
            "locus of the open loop",
            [right(Words("a locus"), "locus", method="compared by eye")],
            "The figure follows from the text.",
        ),
        finding(
            "fig-5.2",
            "5",
            "spectrum of the output",
            [
                wrong(Number("545", "Hz"), Number("550", "Hz"), "peak"),
                right(Number("488", "Hz"), "again", item="488 Hz"),
            ],
            "The peak is the fifth harmonic of the drive, not a mode.",
        ),
    )


def appendix_a() -> tuple[Finding, ...]:
    """Return the finding on a listing, which belongs to no section of the appendix."""
    lines = [
        wrong(Words("`G = G1`"), Words("`G = G1 + s*G2`"), "line 58"),
        right(Words("`k5 = 7;`"), "line 12"),
    ]
    return (
        finding(
            "lst-A.1",
            "A",
            "matrices of the trimmer",
            lines,
            "The listing keeps one of two responses: `sys(1, 1)`.",
            "The loop of section 5.2 lacks the velocity of the pin.",
            Impact.DOWNSTREAM,
            lines=(1190, 1199),
        ),
    )
