"""Claims of section 2.3.4, appendix B.1 and figures 2.7 to 2.9 on friction-controlled backlash.

The thesis's b is half of the total gap in these places.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import sympy

from derivations.elements.backlash import GAP, friction_waveform, limits
from derivations.elements.waveform import THETA, Segment, Waveform, segment_integral
from derivations.symbols import A, omega
from report.chapters.second_ways import by_quadrature
from report.claim import Confirmation, Impact, Part
from report.comparisons.printed import product, total
from report.evidence import Evidence
from report.numbers.independent.load_in_play import boundaries, outputs_at, traced
from report.numbers.independent.symbolic import first_root
from report.numbers.independent.waveforms import Values, coefficient, integral
from report.parts import assertion, close, digits, equal, expression, made_here, same, so
from report.record import Record, claim, text
from trimmer import FrictionBacklash, ViscousBacklash

SOURCE = "derivations/elements/backlash.py"
b = sympy.Symbol("b", positive=True)
REACHED = sympy.Gt(A, b)
VALUES = {A: sympy.Rational(17, 10), b: sympy.Rational(3, 7)}
WAVEFORM = friction_waveform(2 * b)
RESTING, FALLING, _, RISING = WAVEFORM.segments
CONTACT = sympy.asin(1 - 2 * b / A)
LINES = ("first", "second", "third", "fourth")
SINE, COSINE = sympy.sin(THETA), sympy.cos(THETA)
INPUT = A * SINE
EXCHANGED = "the signs of the two constant pieces are exchanged"
TRACING = "an input traced through the characteristic step by step"
HALF_GAP = 0.3
"""Half gap over amplitude of the traced input."""
STEP_ERROR = 1e-3


@claim("fig-2.7", source=SOURCE, lines=(415, 422), paragraph=2)
def motor_and_load(_: Evidence) -> Record:
    least, without_mass = first_root(RESTING.value, A), limits(sympy.Integer(0)).flight
    by_domain = 2.0 / float(FrictionBacklash(2.0).domain())
    means = "the domain of the describing function, gap over amplitude below two"
    second = close(means, float(least.subs(b, 1)), by_domain)
    yield expression("amplitude up to which the load is not moved", b, least, A, second=second)
    yield expression(
        "velocity of a load without mass that is let go",
        sympy.Integer(0),
        without_mass.diff(sympy.Symbol("tau", positive=True)),
        r"\dot y",
        second=same("the place where the pin turns round", without_mass.subs(GAP, 2 * b), RESTING.value),
    )
    yield text(r"""
        The bound is right with $b$ as half of the clearance, as this part of the text uses it; where $b$ is
        the whole of it, as from inertia-controlled backlash on, it is $b/2$. That such a load stays where it
        is let go is the limit $M/D \to 0$ of the general one. Of the conditions that the text then gives for
        the other limit, $D = 0$ is meant: $M \ne 0$ alone is also the general case. The drawing was not at
        hand; it is drawn again from the text.
    """)


@claim("fig-2.8", source=SOURCE, lines=(422, 437), paragraph=2)
def characteristic(_: Evidence) -> Record:
    position = sympy.Symbol("x")
    first_contact = first_root(RISING.value.subs(INPUT, position), position)
    restarted, stopped = (sympy.simplify(INPUT.subs(THETA, each.start)) for each in (FALLING, RESTING))
    swept = sympy.Add(*(segment_integral(each, INPUT.diff(THETA)) for each in WAVEFORM.segments))
    heights = [segment.position(segment.start) for segment in WAVEFORM.segments]
    yield expression("segment OA, its length", b, first_contact)
    yield expression("segment AB, its slope", sympy.Integer(1), slope(RISING))
    yield expression("segment BC, its length", 2 * b, stopped - restarted, assume=REACHED)
    yield expression(
        r"area that EBCD runs round counter-clockwise, $2b \cdot 2(A - b)$",
        product(2 * b, 2 * (A - b)),
        sympy.simplify(-swept),
        assume=REACHED,
        second=same(
            "the quadrature part of the describing function",
            -sympy.pi * A * WAVEFORM.cosine_coefficient(),
            -swept,
        ),
    )
    yield assertion(
        "heights of B, C, D and E",
        "the heights of B, C, D and E depend on the amplitude",
        all(height.diff(A) != 0 for height in heights),
        rf"they are $\pm({sympy.latex(heights[0])})$",
        method="derivative of each height by the amplitude",
        second=close(TRACING, float(traced(HALF_GAP)[1].max()), 1 - HALF_GAP, STEP_ERROR),
    )
    passed = 0.2
    angle = np.arcsin(passed)
    by_element = FrictionBacklash(2 * HALF_GAP).waveform([angle, np.pi - angle], 1.0)
    by_steps = outputs_at(HALF_GAP, passed)
    derived, found = (len({round(float(each), 2) for each in outputs}) for outputs in (by_element, by_steps))
    second = equal(TRACING, found, derived)
    yield digits("outputs for one input, on one closed path", "2", derived, second=second)
    yield text("""
        Each segment of the path follows from mechanics as the text describes it, with $b$ as half of the
        clearance. The two outputs for one input belong to one closed path; over all amplitudes every output
        between $x - b$ and $x + b$ is possible.
    """)


@claim("fig-2.9", source=SOURCE, lines=(445, 452), paragraph=7)
def input_characteristic_output(_: Evidence) -> Record:
    values = {A: 1, b: sympy.Rational(HALF_GAP).limit_denominator(10)}
    printed = (sympy.pi / 2, sympy.pi - CONTACT, 3 * sympy.pi / 2, 2 * sympy.pi - CONTACT)
    starts = boundaries(HALF_GAP)
    for name, phase, segment, start in zip(LINES, printed, WAVEFORM.segments, starts, strict=True):
        second = close(TRACING, start, float(segment.start.subs(values)), STEP_ERROR)
        label = f"start of the {name} region"
        yield expression(label, phase, segment.start, r"\omega t", assume=REACHED, second=second)
    form = "k = 1"
    for name, segment in (("falling", FALLING), ("rising", RISING)):
        label = f"slope of the {name} side"
        yield expression(label, sympy.Integer(1), slope(segment), form=form)
    yield expression("gap to overcome", 2 * b, sympy.simplify(FALLING.value - RISING.value))
    yield text("""
        Tracing the input through the characteristic gives an output of four regions that begin where the text
        says; the redrawn figure joins the points that belong together. What the text then reads off for the
        two resting regions has its signs exchanged: see equation 2.36.
    """)


def slope(segment: Segment) -> sympy.Expr:
    """Return dy/dx along a segment."""
    return sympy.cancel(segment.value.diff(THETA) / INPUT.diff(THETA))


def continuous(waveform: Waveform, index: int, values: Values) -> Confirmation:
    """Confirm a piece of a waveform: it begins where the piece before it ends."""
    segment, before = waveform.segments[index], waveform.segments[index - 1]
    end, start = before.position(before.end), segment.position(segment.start)
    second, first = (complex(each.subs(values).evalf(20)) for each in (end, start))
    return close("continuity at the start of the piece", second, first)


@claim("eq-2.36", source=SOURCE, impact=Impact.LOCAL, lines=(447, 447), paragraph=7)
def waveform(_: Evidence) -> Record:
    printed = (-(A - b), total(INPUT, b), A - b, total(INPUT, -b))
    for index, (line, value, segment) in enumerate(zip(LINES, printed, WAVEFORM.segments, strict=True)):
        second, slip = continuous(WAVEFORM, index, VALUES), made_here(EXCHANGED, -segment.value)
        yield expression(f"{line} piece", value, segment.value, "y", assume=REACHED, second=second, slip=slip)
    yield text(r"""
        After its peak at $\omega t = \pi/2$ the pin lets go and the bridge stays where it is, at $+(A - b)$;
        after the trough it stays at $-(A - b)$. The printed signs are exchanged, so the output would jump by
        $[[ jump | latex ]]$ at the start of contact, and the bridge would leave the gap. The moving pieces
        and all limits are right.

        The same signs stand in the integrals of equation 2.37, whose values are nevertheless those of the
        right waveform; the describing function is not touched.
    """).given(jump=2 * (A - b))


@claim("txt-2.3.4-first-segment-value", source=SOURCE, impact=Impact.LOCAL, lines=(445, 445), paragraph=7)
def first_segment(_: Evidence) -> Record:
    second = continuous(WAVEFORM, 0, VALUES)
    slip = made_here("the sign is that of the third piece", -RESTING.value)
    yield expression("", -(A - b), RESTING.value, assume=REACHED, second=second, slip=slip)
    yield text("""
        Figure 2.9's first piece follows the pin's peak, where the bridge is at its highest, $+(A - b)$. The
        text gives it a minus sign, and the third piece a plus sign.

        Equation 2.36 repeats it.
    """)


@claim("txt-2.3.4-contact-angle", source=SOURCE, lines=(454, 454), paragraph=8)
def contact_angle(_: Evidence) -> Record:
    sine = sympy.Symbol("s", real=True)
    derived = sympy.asin(first_root(A * sine + b - (A - b), sine))
    yield expression("", CONTACT, derived, r"\gamma", assume=REACHED)
    yield text(r"""
        The bridge, at rest at $A - b$, is met by the other side of the pin where $A\sin\omega t + b = A - b$;
        that is at $\pi - \gamma$ with the printed $\gamma$. Here $b$ is half of the total gap.
    """)


@claim("txt-2.3.4-friction-frequency-independent", source=SOURCE, lines=(492, 492), paragraph=13)
def frequency_independent(_: Evidence) -> Record:
    coefficients = (WAVEFORM.cosine_coefficient(), WAVEFORM.sine_coefficient())
    free = set().union(*(each.free_symbols for each in coefficients))
    nearly_without_inertia, slow, fast = 1e-9, 10.0, 1e4
    element = ViscousBacklash(1.0, nearly_without_inertia)
    change = abs(complex(element.describing_function(2.0, fast) - element.describing_function(2.0, slow)))
    means = "the general element with a load of $M/D$ = 1 ns, at 10 and at 10 000 rad/s"
    yield assertion(
        "",
        "the describing function does not depend on frequency",
        omega not in free and free == {A, b},
        "contact angle and output depend on the phase alone, so amplitude and gap are all that is left",
        method="symbols of the derived coefficients",
        second=so(means, change < nearly_without_inertia * fast),
    )
    yield text("""
        Without inertia the bridge's position depends on the path of the pin and not on how fast it is run
        through.
    """)


def printed_sine_terms() -> tuple[sympy.Expr, ...]:
    """Return the terms in the bracket that equations 2.40, 2.41, 2.59 and 5.14 share."""
    ratio = total(2 * b / A, sympy.Integer(-1))
    root = sympy.sqrt(total(sympy.Integer(1), product(-1, sympy.Pow(ratio, 2))))
    return sympy.pi / 2, product(-1, sympy.asin(ratio, evaluate=False)), product(-1, ratio, root)


def integrals(
    weight: sympy.Expr, held: sympy.Expr, moving: sympy.Expr, *, exchanged: bool = False
) -> Iterator[Part]:
    """Yield the parts on integrand and value of each piece, with the values of a held and a moving one."""
    rest, rest_below = product(A - b, weight), product(-1, A - b, weight)
    if exchanged:
        rest, rest_below = rest_below, rest
    falling, rising = (product(total(INPUT, half), weight) for half in (b, -b))
    printed = zip((rest, falling, rest_below, rising), (held, moving) * 2, strict=True)
    for line, (integrand, value), segment in zip(LINES, printed, WAVEFORM.segments, strict=True):
        derived, middle = segment.value * weight, float(((segment.start + segment.end) / 2).subs(VALUES))
        (output,) = FrictionBacklash(2 * float(VALUES[b])).waveform(np.array([middle]), float(VALUES[A]))
        by_element, in_symbols = (
            float(each.subs({**VALUES, THETA: middle})) for each in (float(output) * weight, derived)
        )
        yield expression(
            f"{line} integrand",
            integrand,
            derived,
            assume=REACHED,
            second=close("the numeric element in the middle of the piece", by_element, in_symbols),
            slip=made_here(EXCHANGED, -derived),
        )
        area = sympy.simplify(segment_integral(segment, weight))
        second = by_quadrature(area, integral(segment, weight, VALUES), VALUES)
        yield expression(f"{line} value", value, area, assume=REACHED, second=second)


@claim("eq-2.37", source=SOURCE, impact=Impact.LOCAL, lines=(456, 461), paragraph=8)
def cosine_integrals(_: Evidence) -> Record:
    yield from integrals(COSINE, 2 * b * (b - A) / A, sympy.Integer(0), exchanged=True)
    yield text("""
        The first and the third integrand have the exchanged signs of equation 2.36. The values under the
        braces are those of the right integrands, so two lines do not give what is printed below them;
        appendix B.1 has the right signs.

        None: the coefficient in equation 2.38 uses the values.
    """)


@claim("eq-B.1", source=SOURCE, lines=(1758, 1763))
def appendix_integrals(_: Evidence) -> Record:
    yield from integrals(COSINE, 2 * b * (b - A) / A, sympy.Integer(0))
    yield text("Integrands and values are right, with the signs that equation 2.37 has exchanged.")


@claim("eq-2.39", source=SOURCE, lines=(472, 477), paragraph=10)
def sine_integrals(_: Evidence) -> Record:
    root = sympy.sqrt(b * (A - b) / A**2)
    yield from integrals(
        SINE, 2 * (A - b) * root, A / 4 * (-4 * root + 2 * sympy.asin(1 - 2 * b / A) + sympy.pi)
    )
    yield text("""
        All four integrands and values are right. The signs of the constant pieces are the right ones here,
        other than in equations 2.36 and 2.37.
    """)


def cosine_part(label: str) -> Part:
    """Return the part on a1."""
    derived = sympy.simplify(WAVEFORM.cosine_coefficient())
    second = by_quadrature(derived, coefficient(WAVEFORM, COSINE, VALUES), VALUES)
    printed = 4 * b / sympy.pi * (b / A - 1)
    return expression(label, printed, derived, "a_{1}", assume=REACHED, second=second)


def sine_part(label: str) -> Part:
    """Return the part on b1."""
    derived = sympy.simplify(WAVEFORM.sine_coefficient())
    second = by_quadrature(derived, coefficient(WAVEFORM, SINE, VALUES), VALUES)
    printed = product(A / sympy.pi, total(*printed_sine_terms()))
    return expression(label, printed, derived, "b_{1}", assume=REACHED, second=second)


@claim("eq-2.38", source=SOURCE, lines=(465, 468), paragraph=9)
def cosine_coefficient(_: Evidence) -> Record:
    yield cosine_part("")
    yield text("""
        The coefficient of the right waveform, with $b$ half of the total gap. It is negative for $A > b$.
    """)


appendix_coefficient = claim("eq-B.2", source=SOURCE, lines=(1767, 1770), paragraph=1)(
    cosine_coefficient.items
)


@claim("eq-2.40", source=SOURCE, lines=(481, 481), paragraph=11)
def sine_coefficient(_: Evidence) -> Record:
    yield sine_part("")
    yield text("The coefficient of the right waveform, with $b$ half of the total gap.")


@claim("eq-2.41", source=SOURCE, lines=(485, 488), paragraph=12)
def describing_function(_: Evidence) -> Record:
    yield cosine_part("$a_1$")
    yield sine_part("$b_1$")
    yield text("""
        Both coefficients are right when $b$ is half of the total gap, as here. The listings use the same
        letter for the total gap; whoever mixes the two is wrong by a factor of two in the amplitude.
    """)
