"""Claims of section 5.2.1 on domain, loci and library (equations 5.4 to 5.6)."""

from __future__ import annotations

import math

import control
import sympy

from derivations.backlash import GAP, friction_waveform
from derivations.symbols import A
from derivations.waveform import THETA, describing_function
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.printed import power_of
from report.comparisons.quadrature import coefficient
from report.evidence import Evidence
from trimmer.elements.friction_backlash import FrictionBacklash

SOURCE = "trimmer/elements/friction_backlash.py"
b = sympy.Symbol("b", positive=True)
LIBRARY = control.friction_backlash_nonlinearity(1.0)


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (
        _domain(evidence),
        _proportionality(),
        _external_input(),
        _locus_directions(),
        _library(),
    )


def _domain(evidence: Evidence) -> Claim:
    element = FrictionBacklash(1.0)
    edge = 1.0 / float(element.domain(1.0))
    above = element.describing_function(1.001 * edge)
    return Claim(
        id="eq-5.4",
        parts=(
            Part(
                "edge of the domain over the gap $b$ of this section",
                PrintedDigits("1.0", edge),
                Confirmation("the contact angle exists", CloseNumbers(_edge_of_contact(), edge)),
                Slip("b is taken for half of the gap, as in section 2.3.4", 2 * edge, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "In section 2.3.4 $b$ is half of the gap and the condition is right. In this section, its "
            "listings and its tables $b$ is the whole gap, and the pin reaches the bridge as soon as $A > "
            f"b/2$ (a thousandth above that the real part of $N$ is {power_of(float(above.real), 1)}). Table "
            f"5.1 itself has a limit cycle at $A = {evidence.cycles.friction.unstable.amplitude:.3f}\\,b$, "
            "where equation 5.4 says there is none."
        ),
        consequence=(
            "Half of the range of amplitudes with contact below $b$ is declared empty; the second limit "
            "cycle lies in it."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _edge_of_contact() -> float:
    amplitude = sympy.Symbol("a", positive=True)
    return float(sympy.solve(sympy.Eq(1 - 1 / amplitude, -1), amplitude)[0])


def _proportionality() -> Claim:
    function = describing_function(friction_waveform(), A)
    large = sympy.limit(function.subs(GAP, 1), A, sympy.oo)
    quotients = [complex((function * A / GAP).subs({GAP: 1, A: ratio})) for ratio in (1, 10)]
    return Claim(
        id="eq-5.5",
        parts=(
            Part(
                "",
                Assertion(
                    statement="$N$ is proportional to $b/A$, so $-1/N$ is proportional to $-A/b$",
                    derived=abs(quotients[0] - quotients[1]) < 1e-9,
                    evidence=(
                        f"$NA/b$ is {abs(quotients[0]):.2f} in size at $A = b$ and {abs(quotients[1]):.2f} "
                        f"at $A = 10b$; for large amplitudes $N \\to {sympy.latex(large)}$"
                    ),
                    method="the derived describing function at two amplitudes, and its limit",
                ),
                Confirmation(
                    "python-control's describing function at $A = 10b$",
                    CloseNumbers(10 * LIBRARY.describing_function(10.0), quotients[1]),
                ),
            ),
        ),
        explanation=(
            "$N$ is a function of $b/A$ and not a multiple of it. It tends to one, not to zero, when $b/A$ "
            "does. The proportion printed is that of a relay. Nor does what the text draws from it follow: "
            "$-A/b$ comes closer to zero as $b$ grows, where $-1/N$ at a given amplitude moves away from it."
        ),
        consequence=(
            "The text concludes from it that a larger gap moves the curve until it meets $G$ a second time. "
            "The curve as a whole does not depend on the gap at all; only the amplitudes along it do."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _external_input() -> Claim:
    time = sympy.Symbol("t", real=True)
    printed = sympy.Rational("0.0015") * sympy.sin(200 * sympy.pi * time)
    derived = sympy.im(sympy.Rational("0.0015") * sympy.exp(2 * sympy.pi * 100 * sympy.I * time))
    return Claim(
        id="eq-5.6",
        parts=(Part("", SameExpression(printed, derived, left=sympy.Symbol("r"))),),
        explanation=(
            "Equation 2.1 with an eccentricity of 1.5 mm and 100 turns a second. The motor of the experiment "
            "turned faster, see the places where its frequency is quoted."
        ),
        source="report/chapters/chapter_5/claims/section_5_2_1_measures.py",
    )


def _by_the_library(amplitude: float, inverse: complex) -> Confirmation:
    """Confirm -1/N at an amplitude, in gaps."""
    theirs = -1 / LIBRARY.describing_function(amplitude)
    return Confirmation("python-control's describing function there", CloseNumbers(theirs, inverse, 1e-6))


def _locus_directions() -> Claim:
    element = FrictionBacklash(1.0)
    far = complex(-1 / element.describing_function(1e6))
    near = [complex(-1 / element.describing_function(0.5 * (1 + step))) for step in (1e-2, 1e-4)]
    return Claim(
        id="txt-5.2.1-locus-directions",
        parts=(
            Part(
                "with growing amplitude",
                Assertion(
                    statement="$-1/N$ tends to $-1$",
                    derived=abs(far + 1) < 1e-4,
                    evidence=f"at $A = 10^6 b$ it is $-1$ to {power_of(abs(far + 1))}",
                    method="the describing function at large amplitude",
                ),
                _by_the_library(1e6, far),
            ),
            Part(
                "with growing gap at fixed amplitude",
                Assertion(
                    statement="$-1/N$ tends to $(-\\infty, -\\infty j)$",
                    derived=near[1].real < near[0].real < 0 and near[1].imag < near[0].imag < 0,
                    evidence=(
                        f"it runs from {near[0].real:.0f} {near[0].imag:+.0f} j to {near[1].real:.0f} "
                        f"{near[1].imag:+.0f} j as the gap comes from 1 % to 0.01 % below twice the amplitude"
                    ),
                    method="the describing function near the edge of the dead band",
                ),
                _by_the_library(0.5 * (1 + 1e-4), near[1]),
            ),
        ),
        explanation=(
            "Both directions are right. They are one and the same motion along one curve, whose parameter is "
            "$b/A$."
        ),
        source=SOURCE,
    )


def _library() -> Claim:
    saturated = control.saturation_nonlinearity(1.0).describing_function(2.0)
    names = [
        name
        for name in (
            "friction_backlash_nonlinearity",
            "relay_hysteresis_nonlinearity",
            "saturation_nonlinearity",
        )
        if hasattr(control, name)
    ]
    return Claim(
        id="txt-5.2.1-second-implementation",
        parts=(
            _agreement(),
            Part(
                "what the library holds",
                Assertion(
                    statement="it holds no other describing function",
                    derived=len(names) == 1,
                    evidence=f"it has {', '.join(f'`{name}`' for name in names)}",
                    method="names in the installed python-control",
                ),
                Confirmation(
                    "that of saturation, called for twice its bound",
                    CloseNumbers(saturated, 2 / math.pi * (math.asin(0.5) + 0.5 * math.sqrt(0.75))),
                ),
            ),
        ),
        explanation=(
            "The two implementations agree, with the total gap as parameter in both. The library has had "
            "saturation and a relay with hysteresis from the start as well, the latter with zero hysteresis "
            "being the thesis's Coulomb friction."
        ),
        consequence="A check of the friction listing against the library would have been possible.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _agreement() -> Part:
    ours = FrictionBacklash(1.0)
    distance = max(
        abs(complex(ours.describing_function(a)) - LIBRARY.describing_function(a))
        for a in (0.51, 0.7, 1.0, 4.0, 90.0)
    )
    values = {A: sympy.Integer(4), GAP: sympy.Integer(1)}
    wave = friction_waveform()
    sine, cosine = (coefficient(wave, weight(THETA), values) for weight in (sympy.sin, sympy.cos))
    return Part(
        "agreement",
        Assertion(
            statement="the library's describing function of backlash agrees with the listing's",
            derived=distance < 1e-12,
            evidence=(
                f"they differ by {power_of(distance)} at most, at five amplitudes from 0.51 to 90 gaps"
            ),
            method="python-control evaluated beside ours",
        ),
        Confirmation(
            "quadrature of the waveform at four gaps",
            CloseNumbers((sine + 1j * cosine) / 4, LIBRARY.describing_function(4.0)),
        ),
    )
