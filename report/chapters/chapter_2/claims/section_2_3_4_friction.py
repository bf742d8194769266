"""Claims of section 2.3.4 and figures 2.7 to 2.9: motion of friction-controlled backlash (2.36).

The thesis's b is half of the total gap in these places.
"""

import numpy as np
import sympy

from derivations import assumed
from derivations.elements.backlash import GAP, friction_waveform, limits
from derivations.elements.waveform import THETA, Segment, Waveform, segment_integral
from derivations.symbols import A, omega
from report.judging.claim import Confirmation
from report.judging.comparisons.printed import total
from report.judging.parts import assertion, close, digits, equal, expression, made_here, matrix, same, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.load_in_play import boundaries, outputs_at, traced
from report.numbers.independent.symbolic import first_root
from report.numbers.independent.waveforms import Values
from trimmer import FrictionBacklash, ViscousBacklash

b = assumed.positive("b")
REACHED = sympy.Gt(A, b)
VALUES = {A: sympy.Rational(17, 10), b: sympy.Rational(3, 7)}
WAVEFORM = friction_waveform(2 * b)
RESTING, FALLING, RESTING_BELOW, RISING = WAVEFORM.segments
CONTACT = sympy.asin(1 - 2 * b / A)
LINES = ("first", "second", "third", "fourth")
SINE, COSINE = sympy.sin(THETA), sympy.cos(THETA)
INPUT = A * SINE
EXCHANGED = "the signs of the two resting pieces are exchanged"
RESTING_ITEM = "signs of the two resting pieces, backlashed output"  # The printed thing that two claims judge
LIMITS = (r"\frac{\pi}{2}", r"\pi - \gamma", r"\frac{3\pi}{2}", r"2\pi - \gamma", r"\frac{5\pi}{2}")
MOVING = r"A\sin(\omega t) + b", r"A\sin(\omega t) - b"
"""The limits of the pieces of equation 2.36, and its second and fourth piece, as TeX."""
TRACING = "an input traced through the characteristic step by step"
HALF_GAP = 0.3  # Half gap over amplitude of the traced input
STEP_ERROR = 1e-3


@claim("fig-2.7")
def motor_and_load(_: Evidence) -> Record:
    least, without_mass = first_root(RESTING.value, A), limits(sympy.Integer(0)).flight
    by_domain = 2.0 / float(FrictionBacklash(2.0).domain())
    means = "the domain of the describing function, gap over amplitude below two"
    second = close(means, float(least.subs(b, 1)), by_domain)
    yield expression("amplitude up to which the load is not moved", b, least, A, second=second)
    yield expression(
        "velocity of a load without mass that is let go",
        sympy.Integer(0),
        without_mass.diff(assumed.positive("tau")),
        r"\dot y",
        second=same("the place where the pin turns round", without_mass.subs(GAP, 2 * b), RESTING.value),
    )
    yield text(r"""
        The bound is right with $b$ as half of the clearance, as this part of the text uses it. From
        inertia-controlled backlash on, $b$ is the whole clearance and the bound $b/2$. A load without mass
        stays where it is let go, as does any load in the limit $M/D \to 0$. For the other limit the text
        gives $D = 0$ or $M \ne 0$; the first is meant, since $M \ne 0$ holds in general too.
    """)


@claim("fig-2.8")
def characteristic(_: Evidence) -> Record:
    position = sympy.Symbol("x")
    first_contact = first_root(RISING.value.subs(INPUT, position), position)
    restarted, stopped = (sympy.simplify(INPUT.subs(THETA, each.start)) for each in (FALLING, RESTING))
    swept = sympy.Add(*(segment_integral(each, INPUT.diff(THETA)) for each in WAVEFORM.segments))
    heights = [segment.position(segment.start) for segment in WAVEFORM.segments]
    yield expression("segment OA, its length", b, first_contact)
    yield expression("segment AB, its slope", sympy.Integer(1), slope(RISING))
    yield expression("segment BC, its length", 2 * b, stopped - restarted, assume=REACHED)
    yield assertion(
        "path EBCD",
        "the path is closed",
        (not any(WAVEFORM.jumps()), sympy.simplify(swept + 4 * b * (A - b)) == 0),
        r"each piece begins where the one before it ends; the area within is $2b \cdot 2(A - b)$",
        method="values at the ends of the pieces",
        certainty=Certainty.PROVEN,
        second=same(
            "the quadrature part of the describing function",
            -sympy.pi * A * WAVEFORM.cosine_coefficient(),
            2 * b * 2 * (A - b),
        ),
    )
    yield assertion(
        "heights of B, C, D and E",
        "the heights of B, C, D and E depend on the amplitude",
        tuple(height.diff(A) != 0 for height in heights),
        rf"they are $\pm({sympy.latex(heights[0])})$",
        method="derivative of each height by the amplitude",
        certainty=Certainty.PROVEN,
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
        clearance. The two outputs for one input belong to one closed path. Over all amplitudes every output
        between $x - b$ and $x + b$ is possible.
    """)


@claim("fig-2.9")
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
        says. The redrawn figure joins the points that belong together. What the text reads off for the two
        resting regions has its signs exchanged, [see equation 2.36](#eq-2.36).
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


@claim("eq-2.36")
def waveform(_: Evidence) -> Record:
    rising, falling = MOVING
    printed = (-(A - b), total(INPUT, b), A - b, total(INPUT, -b))
    forms = ("-(A - b)", "A - b"), (rising, rising), ("A - b", "-(A - b)"), (falling, falling)
    pieces = zip(LINES, printed, WAVEFORM.segments, forms, strict=True)
    for index, (line, value, segment, shown) in enumerate(pieces):
        printed_form, derived_form = (piece_form(index, each) for each in shown)
        yield expression(
            f"{line} piece",
            value,
            segment.value,
            assume=REACHED,
            second=continuous(WAVEFORM, index, VALUES),
            slip=made_here(EXCHANGED, -segment.value),
            printed_form=printed_form,
            derived_form=derived_form,
            item=RESTING_ITEM if segment in (RESTING, RESTING_BELOW) else "",
        )
    limits_printed = (sympy.pi / 2, sympy.pi - CONTACT, 3 * sympy.pi / 2, 2 * sympy.pi - CONTACT)
    yield matrix(
        "limits of the pieces",
        sympy.ImmutableMatrix([[*limits_printed, 5 * sympy.pi / 2]]),
        sympy.ImmutableMatrix([[*(each.start for each in WAVEFORM.segments), RISING.end]]),
        form=r",\quad ".join(LIMITS),
    )
    yield text(rf"""
        After its peak at $\omega t = \pi/2$ the pin lets go and the bridge stays where it is, at $+(A - b)$.
        After the trough it stays at $-(A - b)$. The printed signs are exchanged, so the output would jump by
        ${sympy.latex(2 * (A - b))}$ at the start of contact, and the bridge would leave the gap.

        No result is affected: the integrals of [equation 2.37](#eq-2.37) repeat the signs, but their values
        are those of the right waveform. So the describing function is not touched.
    """)


def piece_form(index: int, value: str) -> str:
    """Return TeX of a piece of equation 2.36 with its interval, counted from zero."""
    start, end = LIMITS[index : index + 2]
    return rf"y = {value} \quad\text{{if}}\quad {start} < \omega t \le {end}"


@claim("txt-2.3.4-first-segment-value")
def first_segment(_: Evidence) -> Record:
    second = continuous(WAVEFORM, 0, VALUES)
    slip = made_here("the sign is that of the third piece", -RESTING.value)
    yield expression(
        "",
        -(A - b),
        RESTING.value,
        assume=REACHED,
        second=second,
        slip=slip,
        printed_form="-(A - b)",
        derived_form="A - b",
        item=RESTING_ITEM,
    )
    yield text("""
        As at [equation 2.36](#eq-2.36), in words: the first piece follows the pin's peak, where the bridge
        rests at its highest, at $+(A - b)$. The text gives it a minus sign, and the third piece a plus sign.

        No result is affected.
    """)


@claim("txt-2.3.4-contact-angle")
def contact_angle(_: Evidence) -> Record:
    sine = assumed.real("s")
    derived = sympy.asin(first_root(A * sine + b - (A - b), sine))
    yield expression("", CONTACT, derived, r"\gamma", assume=REACHED)
    yield text(r"""
        The bridge, at rest at $A - b$, is met by the other side of the pin where $A\sin\omega t + b = A - b$;
        that is at $\pi - \gamma$ with the printed $\gamma$. Here $b$ is half of the total gap, and $\gamma$
        is not the ratio of [equation 2.45](#eq-2.45).
    """)


@claim("txt-2.3.4-friction-frequency-independent")
def frequency_independent(_: Evidence) -> Record:
    coefficients = (WAVEFORM.cosine_coefficient(), WAVEFORM.sine_coefficient())
    free = set().union(*(each.free_symbols for each in coefficients))
    nearly_without_inertia, slow, fast = 1e-9, 10, 10_000
    element = ViscousBacklash(1.0, nearly_without_inertia)
    change = abs(complex(element.describing_function(2.0, fast) - element.describing_function(2.0, slow)))
    load = f"$M/D$ of {1e9 * nearly_without_inertia:.0f} ns"
    means = f"the general element with a load of {load}, at {slow} and at {fast} rad/s"
    yield assertion(
        "",
        "the describing function does not depend on frequency",
        (omega not in free, free == {A, b}),
        "contact angle and output depend on the phase alone, so amplitude and gap are all that is left",
        method="symbols of the derived coefficients",
        second=so(means, change < nearly_without_inertia * fast),
    )
    yield text("""
        Without inertia the bridge's position depends on the path of the pin, and not on how fast the pin goes
        along it.
    """)
