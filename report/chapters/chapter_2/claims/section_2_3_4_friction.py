"""Claims of section 2.3.4 on the waveform of friction-controlled backlash (equation 2.36).

The thesis's b is half of the total gap in these places.
"""

from __future__ import annotations

import sympy

from derivations.backlash import friction_waveform
from derivations.symbols import A, omega
from derivations.waveform import THETA, Segment
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.printed import total
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from trimmer.elements.viscous_backlash import ViscousBacklash

SOURCE = "derivations/backlash.py"
b = sympy.Symbol("b", positive=True)
REACHED = sympy.Gt(A, b)
VALUES = {A: sympy.Rational(17, 10), b: sympy.Rational(3, 7)}
WAVEFORM = friction_waveform(2 * b)
CONTACT = sympy.asin(1 - 2 * b / A)
NEARLY_WITHOUT_INERTIA = 1e-9
"""M/D of a load that inertia hardly moves, s."""
LINES = ("first", "second", "third", "fourth")
SINE, COSINE = sympy.sin(THETA), sympy.cos(THETA)


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_waveform(), _first_segment(), _contact_angle(), _frequency_independent())


def _waveform() -> Claim:
    printed = (-(A - b), total(A * SINE, b), A - b, total(A * SINE, -b))
    slip = "the signs of the two constant pieces are exchanged"
    jump = 2 * (A - b)
    return Claim(
        id="eq-2.36",
        parts=tuple(
            Part(
                f"{line} piece",
                SameExpression(value, segment.value, left=sympy.Symbol("y"), assume=REACHED),
                _stays_within_the_gap(segment),
                Slip(slip, -segment.value, Verdict.ERRATUM),
            )
            for line, value, segment in zip(LINES, printed, WAVEFORM.segments, strict=True)
        ),
        explanation=(
            "After its peak at $\\omega t = \\pi/2$ the pin lets go and the bridge stays where it is, at "
            "$+(A - b)$; after the trough it stays at $-(A - b)$. The printed signs are exchanged, so the "
            f"output would jump by ${sympy.latex(jump)}$ at the start of contact, and the bridge would leave "
            "the gap. The moving pieces and all limits are right."
        ),
        consequence=(
            "The same signs stand in the integrals of equation 2.37, whose values are nevertheless those of "
            "the right waveform; the describing function is not touched."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _stays_within_the_gap(segment: Segment) -> Confirmation:
    """Confirm a piece: it begins where the piece before it ends."""
    index = WAVEFORM.segments.index(segment)
    before = WAVEFORM.segments[index - 1]
    end, start = (
        complex(piece.value.subs(THETA, phase).subs(VALUES).evalf(20))
        for piece, phase in ((before, before.end), (segment, segment.start))
    )
    return Confirmation("continuity at the start of the piece", CloseNumbers(end, start))


def _first_segment() -> Claim:
    derived = WAVEFORM.segments[0].value
    return Claim(
        id="txt-2.3.4-first-segment-value",
        parts=(
            Part(
                "",
                SameExpression(-(A - b), derived, assume=REACHED),
                _stays_within_the_gap(WAVEFORM.segments[0]),
                Slip("the sign is that of the third piece", -derived, Verdict.ERRATUM),
            ),
        ),
        explanation=(
            "Figure 2.9's first piece follows the pin's peak, where the bridge is at its highest, $+(A - "
            "b)$. The text gives it a minus sign, and the third piece a plus sign."
        ),
        consequence="Equation 2.36 repeats it.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _contact_angle() -> Claim:
    meeting = sympy.Symbol("s", real=True)
    derived = sympy.asin(sympy.solve(A * meeting + b - (A - b), meeting)[0])
    return Claim(
        id="txt-2.3.4-contact-angle",
        parts=(Part("", SameExpression(CONTACT, derived, left=sympy.Symbol("gamma"), assume=REACHED)),),
        explanation=(
            "The bridge, at rest at $A - b$, is met by the other side of the pin where $A\\sin\\omega t + b "
            "= A - b$; that is at $\\pi - \\gamma$ with the printed $\\gamma$. Here $b$ is half of the total "
            "gap."
        ),
        source=SOURCE,
    )


def _frequency_independent() -> Claim:
    coefficients = (WAVEFORM.cosine_coefficient(), WAVEFORM.sine_coefficient())
    free = set().union(*(each.free_symbols for each in coefficients))
    element, fast_omega = ViscousBacklash(1.0, NEARLY_WITHOUT_INERTIA), 1e4
    slow, fast = (element.describing_function(2.0, omega) for omega in (10.0, fast_omega))
    return Claim(
        id="txt-2.3.4-friction-frequency-independent",
        parts=(
            Part(
                "",
                Assertion(
                    statement="the describing function does not depend on frequency",
                    derived=omega not in free and free == {A, b},
                    evidence=(
                        "contact angle and output depend on the phase alone, so amplitude and gap are all "
                        "that is left"
                    ),
                    method="symbols of the derived coefficients",
                ),
                second_way(
                    "the general element with a load of $M/D$ = 1 ns, at 10 and at 10 000 rad/s",
                    abs(complex(slow) - complex(fast)) < NEARLY_WITHOUT_INERTIA * fast_omega,
                ),
            ),
        ),
        explanation=(
            "Without inertia the bridge's position depends on the path of the pin and not on how fast it is "
            "run through."
        ),
        source=SOURCE,
    )
