"""Claims of section 2.3.4 and figure 2.10 on inertia-controlled backlash. Here b is the total gap."""

from __future__ import annotations

import control
import sympy

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
from report.claim import Impact
from report.comparisons.printed import product, total
from report.evidence import Evidence
from report.numbers.independent.waveforms import quadrature_gain
from report.parts import assertion, expression, made_here, same, so
from report.record import Record, claim, text

SOURCE = "derivations/elements/backlash.py"
b = sympy.Symbol("b", positive=True)
WAVEFORM, IN_GAP = inertia_waveform(b), inertia_waveform()
ANGLE = sympy.Rational(8, 5)


@claim("fig-2.10", source=SOURCE, lines=(497, 502), paragraph=14)
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
        characteristic after its free flight, as drawn.
    """)


@claim("txt-2.3.4-separation-velocity", source=SOURCE, impact=Impact.NOTATION, lines=(497, 497), paragraph=14)
def separation_velocity(_: Evidence) -> Record:
    velocity = (A * sympy.sin(omega * t)).diff(t)
    for n in (0, 1):
        derived = velocity.subs(t, n * sympy.pi / omega)
        second = same("the slope of the flight", IN_GAP.segments[2 * n].value.diff(THETA) * omega, derived)
        slip = made_here("the sign of cos nπ is lost", derived * (-1) ** n)
        label = f"velocity at the separation $n = {n}$"
        yield expression(label, A * omega, derived, "u'", second=second, slip=slip)
    label = r"the same for $n = 1$, as $A\omega\cos(\omega n\pi)$"
    slip = made_here("the phase nπ is put in the place of the time", velocity.subs(t, sympy.pi))
    printed = A * omega * sympy.cos(omega * sympy.pi)
    yield expression(label, printed, derived, "u'", second=second, slip=slip)
    yield text(r"""
        The load flies at the pin's velocity at the separation, $u' = A\omega\cos(n\pi)$. The text takes that
        as $A\omega$ for every $n$; for odd $n$ the pin moves the other way. Its $\cos(\omega n\pi)$ puts a
        phase where a time belongs.

        None: the third piece of equation 2.42 has the factor $\cos(\omega T/2) = -1$.
    """)


@claim("eq-2.42", source=SOURCE, impact=Impact.LOCAL, lines=(506, 506), paragraph=14)
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
        label = rf"{line} piece, $\theta = \omega t$"
        yield expression(label, value, segment.value, "y", second=second, slip=slip)
    yield text(r"""
        The third piece begins where the bridge separates at $\omega t = \pi$, at $+b/2$; printed it begins at
        zero, so the output would jump by $b/2$ twice a period and no longer be odd. The limits of the pieces
        mix phases and times: $\phi$ is an angle, $t$ a time.

        None: Listing A.8 adds the constant $\pi A + b/2$, which contains the offset, and the describing
        function in equation 2.43 is that of the right waveform.
    """)


@claim("txt-2.3.4-inertia-contact-equation", source=SOURCE, lines=(508, 512), paragraph=15)
def contact_equation(_: Evidence) -> Record:
    flying, following = WAVEFORM.segments[:2]
    meeting = sympy.expand((flying.value - following.value).subs(THETA, CONTACT) / A)
    limit = limits(sympy.oo).ratio.subs(sympy.Symbol("tau", positive=True), CONTACT) - b / A
    means = "the limit of the general element for M/D to infinity"
    second = same(means, limit, meeting)
    yield expression("", CONTACT - sympy.sin(CONTACT) - b / A, meeting, second=second)
    yield text(r"""
        Flight and falling wall meet where the printed expression is zero. It is Kepler's equation for
        eccentricity one and has no solution in elementary functions, as the text says. It has exactly one
        root for $0 < b/A < \pi$, since its slope $1 - \cos\phi$ is positive.
    """)


@claim("eq-2.43", source=SOURCE, lines=(516, 516), paragraph=16)
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
        "N",
        second=by_quadrature(derived, quadrature_gain(IN_GAP, A, values), values),
    )
    yield text(r"""
        The describing function of the right waveform, with $b$ the total gap. It holds as long as the bridge
        is in contact for a part of each half period, that is for $b/A < \pi$.
    """)


@claim("txt-2.3.4-imaginary-signs", source=SOURCE, impact=Impact.LOCAL, lines=(518, 518), paragraph=17)
def imaginary_signs(_: Evidence) -> Record:
    friction = sympy.simplify(friction_waveform().cosine_coefficient() / A)
    samples = [friction.subs({A: 1, GAP: sympy.Rational(k, 50)}) for k in range(1, 100)]
    library = control.friction_backlash_nonlinearity(1.0)
    negative = all(library.describing_function(each).imag < 0 for each in (0.51, 0.7, 1.0, 4.0, 90.0))
    yield assertion(
        "",
        "the imaginary part is negative for inertia-controlled, positive for friction-controlled backlash",
        all(sample > 0 for sample in samples),
        """
        for friction-controlled backlash it is $[[ derived | latex ]]$, negative for every $A > g/2$, and
        $[[ largest | latex ]]$ where it is largest in size
        """,
        numbers={"derived": sympy.factor(friction), "largest": friction.subs(GAP, A)},
        method="sign of the derived coefficient over the whole domain",
        second=so("python-control's describing function of backlash at five amplitudes", negative),
    )
    yield text(r"""
        Both imaginary parts are negative: a load that lags behind the pin delays the output, whatever moves
        it. The thesis's own $a_1 = (4b/\pi)(b/A - 1)$ is negative for every $A > b$.

        None on numbers; the listings have the right sign. Read as it stands, it would put $-1/N$ above the
        real axis.
    """)
