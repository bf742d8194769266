"""Claims of section 2.3.4 and figure 2.10 on inertia-controlled backlash. Here b is the total gap."""

import control
import sympy

from derivations import assumed
from derivations.elements.backlash import (
    CONTACT,
    GAP,
    friction_waveform,
    inertia_contact_ratio,
    inertia_waveform,
    limits,
)
from derivations.elements.waveform import THETA, simplified_describing_function
from derivations.symbols import A, omega, t
from report.chapters.chapter_2.claims.section_2_3_4_friction import LINES, SINE, continuous
from report.chapters.second_ways import by_quadrature
from report.judging.comparisons.printed import product, total
from report.judging.parts import assertion, expression, made_here, matrix, same, so
from report.judging.record import Record, claim, text
from report.judging.text import one_line
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.waveforms import quadrature_gain, sampled_gain
from trimmer import InertiaBacklash

b = assumed.positive("b")
WAVEFORM, IN_GAP = inertia_waveform(b), inertia_waveform()
VELOCITY_ITEM = "Aω cos(ωnπ) = Aω, velocity at the separation of inertia-controlled backlash"
THIRD_PIECE_ITEM = "third piece without b/2, output of inertia-controlled backlash"
"""Printed things that several parts or claims judge."""
PIECES = (
    r"\omega At - \frac{b}{2}",
    r"u(t) + \frac{b}{2}",
    r"\omega A\cos\left(\omega\frac{T}{2}\right)\left(t - \frac{T}{2}\right)",
    r"u(t) - \frac{b}{2}",
)
LIMITS = ("0", r"\phi", r"\frac{T}{2}", r"\frac{T}{2} + \phi", "T")
"""Pieces and limits of equation 2.42 as printed, as TeX."""
AMPLITUDES = (0.51, 0.7, 1.0, 4.0, 90.0)
"""Amplitudes in gaps at which the signs are tried, both kinds of backlash in contact."""
FUNCTION_FORM = r"""
    N(A) = \frac{1}{\pi}(\pi + 2\sin(\phi_1) - \phi_1 - \sin(\phi_1)\cos(\phi_1))
    - j\frac{1}{\pi}(1 - \cos(\phi_1))^2
    """
ANGLE = sympy.Rational(8, 5)


@claim("fig-2.10")
def characteristic(_: Evidence) -> Record:
    flying, following, flying_back, following_back = WAVEFORM.segments
    start = same("the start of the flight", flying.start, sympy.Integer(0))
    back = same("the start of the flight back", flying_back.start, sympy.pi)
    derived = limits(sympy.oo).separation
    yield expression("phase of the first separation", sympy.Integer(0), derived, r"\omega t", second=start)
    yield expression("phase of the second separation", sympy.pi, derived + sympy.pi, r"\omega t", second=back)
    apart = following.value - following_back.value
    yield expression("distance of the two sides of the characteristic", b, apart)
    yield text(r"""
        The load separates where the pin is fastest, at $\omega t = n\pi$, and meets the other side of the
        characteristic after its free flight.
    """)


@claim("txt-2.3.4-separation-velocity")
def separation_velocity(_: Evidence) -> Record:
    velocity = (A * sympy.sin(omega * t)).diff(t)
    for n in (0, 1):
        derived = velocity.subs(t, n * sympy.pi / omega)
        second = same("the slope of the flight", IN_GAP.segments[2 * n].value.diff(THETA) * omega, derived)
        slip = made_here("the sign of cos nπ is lost", derived * (-1) ** n)
        sure = Certainty.READING if n else None
        label = f"velocity at the separation $n = {n}$"
        yield expression(
            label, A * omega, derived, "u'", second=second, slip=slip, item=VELOCITY_ITEM, certainty=sure
        )
    slip = made_here("the phase nπ is put in the place of the time", velocity.subs(t, sympy.pi))
    yield expression(
        "its form, for $n = 1$",
        A * omega * sympy.cos(omega * sympy.pi),
        derived,
        "u'",
        second=second,
        slip=slip,
        item=VELOCITY_ITEM,
        printed_form=r"u'(n\pi) = A\omega\cos(\omega n\pi)",
        derived_form=r"u' = A\omega\cos(n\pi)",
    )
    yield text(r"""
        The load flies at the pin's velocity at the separation, $u' = A\omega\cos(n\pi)$. The text gives
        $A\omega$ for every $n$. Read as a velocity, that is wrong for odd $n$, where the pin moves the
        other way; read as a speed, it is right. The form $\cos(\omega n\pi)$ puts a phase where a time
        belongs.

        None: the third piece of [equation 2.42](#eq-2.42) has the factor $\cos(\omega T/2) = -1$.
    """)


@claim("eq-2.42")
def waveform(_: Evidence) -> Record:
    half = b / 2
    printed = (
        total(A * THETA, -half),
        total(A * SINE, half),
        product(-A, THETA - sympy.pi),
        total(A * SINE, -half),
    )
    values = {CONTACT: ANGLE, A: 1, b: inertia_contact_ratio().subs(CONTACT, ANGLE)}
    for index, (line, value, segment) in enumerate(zip(LINES, printed, WAVEFORM.segments, strict=True)):
        slip = made_here("the offset b/2 at the start of the piece is lost", segment.value - half)
        second = continuous(WAVEFORM, index, values)
        offset = r" + \frac{b}{2}" if line == "third" else ""
        yield expression(
            f"{line} piece",
            value,
            segment.value,
            second=second,
            slip=slip,
            printed_form=piece_form(index, PIECES[index]),
            derived_form=piece_form(index, PIECES[index] + offset),
            item=THIRD_PIECE_ITEM if offset else "",
        )
    limits_printed = (0, CONTACT, sympy.pi, sympy.pi + CONTACT, 2 * sympy.pi)
    yield matrix(
        r"limits of the pieces, read as phases with $\omega T = 2\pi$",
        sympy.ImmutableMatrix([[*limits_printed]]),
        sympy.ImmutableMatrix([[*(each.start for each in WAVEFORM.segments), WAVEFORM.segments[-1].end]]),
        form=r",\quad ".join(LIMITS),
    )
    yield text(r"""
        The third piece begins where the bridge separates at $\omega t = \pi$, at $+b/2$. Printed, it begins
        at zero: the output would jump by $b/2$ twice a period and no longer be odd. The limits mix phases and
        times, since $\phi$ is an angle and $t$ a time; read as phases they are right.

        None: Listing A.8 adds the constant $\pi A + b/2$, which contains the offset, and the describing
        function in [equation 2.43](#eq-2.43) is that of the right waveform.
    """)


def piece_form(index: int, value: str) -> str:
    """Return TeX of a piece of equation 2.42 with its interval, counted from zero."""
    start, end = LIMITS[index : index + 2]
    return rf"y(t) = {value} \quad\text{{if}}\quad {start} \le t < {end}"


@claim("txt-2.3.4-inertia-contact-equation")
def contact_equation(_: Evidence) -> Record:
    flying, following = WAVEFORM.segments[:2]
    meeting = sympy.expand((flying.value - following.value).subs(THETA, CONTACT) / A)
    limit = limits(sympy.oo).ratio.subs(assumed.positive("tau"), CONTACT) - b / A
    means = "the limit of the general element for M/D to infinity"
    second = same(means, limit, meeting)
    form = r"\phi - \sin(\phi) - \frac{b}{A} = 0"
    yield expression("", CONTACT - sympy.sin(CONTACT) - b / A, meeting, second=second, form=form)
    yield text(r"""
        Flight and falling wall meet where the printed expression is zero. It is Kepler's equation for
        eccentricity one, and has no solution in elementary functions, as the text says. Since its slope
        $1 - \cos\phi$ is positive, it has exactly one root for $0 < b/A < \pi$.
    """)


@claim("eq-2.43")
def describing_function(_: Evidence) -> Record:
    sine, cosine, ratio = sympy.sin(CONTACT), sympy.cos(CONTACT), inertia_contact_ratio()
    real = total(sympy.pi, 2 * sine, -CONTACT, product(-1, sine, cosine))
    imaginary = product(-1, sympy.I / sympy.pi * (1 - cosine) ** 2)
    derived = simplified_describing_function(IN_GAP, A, (GAP, A * ratio))
    values = {A: sympy.Integer(1), CONTACT: ANGLE, GAP: ratio.subs(CONTACT, ANGLE)}
    yield expression(
        "",
        total(product(1 / sympy.pi, real), imaginary),
        derived,
        form=one_line(FUNCTION_FORM),
        second=by_quadrature(derived, quadrature_gain(IN_GAP, A, values), values),
    )
    yield text(r"""
        It is the describing function of the right waveform, with $b$ the total gap. It holds as long as the
        bridge is in contact for a part of each half period, that is for $b/A < \pi$.
    """)


@claim("txt-2.3.4-imaginary-signs")
def imaginary_signs(_: Evidence) -> Record:
    inertia = simplified_describing_function(IN_GAP, A, (GAP, A * inertia_contact_ratio()))
    turned = sympy.expand_complex(inertia).as_real_imag()[1]
    square = -((1 - sympy.cos(CONTACT)) ** 2) / sympy.pi
    lags = tuple(sampled_gain(InertiaBacklash(1.0), each, 1.0).imag < 0 for each in AMPLITUDES)
    yield assertion(
        "inertia-controlled backlash",
        "the imaginary part is negative",
        sympy.simplify(turned - square) == 0,
        rf"it is ${sympy.latex(square)}$, negative for every $0 < \phi_c \le \pi$",
        method="the derived coefficient as minus a square",
        certainty=Certainty.PROVEN,
        second=so(f"the sampled waveform at {len(AMPLITUDES)} amplitudes", lags),
    )
    friction = sympy.factor(friction_waveform().cosine_coefficient() / A)
    # An amplitude above half the gap, so that the sign shows.
    beyond = sympy.factor(friction.subs(A, GAP / 2 + assumed.positive("d")))
    library = control.friction_backlash_nonlinearity(1.0)
    negative = tuple(library.describing_function(each).imag < 0 for each in AMPLITUDES)
    yield assertion(
        "friction-controlled backlash",
        "the imaginary part is positive",
        beyond.is_negative is not True,
        f"""
        it is ${sympy.latex(friction)}$ with the total gap $g$, negative for every $A > g/2$, and
        ${sympy.latex(friction.subs(GAP, A))}$ where it is largest in size
        """,
        method="sign of the derived coefficient over the whole domain",
        certainty=Certainty.READING,
        second=so(f"python-control's describing function at {len(AMPLITUDES)} amplitudes", negative),
    )
    yield text(r"""
        Both imaginary parts are negative: a load that lags behind the pin delays the output, whatever moves
        it. The thesis's own $a_1 = (4b/\pi)(b/A - 1)$ is negative for every $A > b$. If the sign in front of
        the $j$ is meant, as [equations 2.43](#eq-2.43) and [2.59](#eq-2.59) write it, the sentence is true of
        the notation and says nothing of the value.

        None on numbers: the listings have the right sign.
    """)
