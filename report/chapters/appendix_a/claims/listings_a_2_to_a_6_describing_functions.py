"""Claims of appendices A.3 to A.7 and A.11 on listings of describing functions (A.2 to A.6 and A.10)."""

import sympy

from derivations import assumed
from derivations.elements.backlash import (
    CONTACT,
    GAMMA,
    GAP,
    SEPARATION,
    contact_ratio,
    friction_waveform,
    inertia_contact_ratio,
    inertia_waveform,
    separation_angle,
)
from derivations.elements.friction import FORCE, relay_waveform
from derivations.elements.friction import friction_waveform as coulomb_waveform
from derivations.elements.waveform import describing_function, simplified_describing_function
from derivations.latex import latex
from derivations.symbols import A, omega
from report.chapters.chapter_2.claims import section_2_3_4_viscous as viscous
from report.chapters.second_ways import REPEATED, by_quadrature
from report.judging.claim import ClaimPart
from report.judging.parts import assertion, close, expression, made_here, repeated, same
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.load_in_play import contact_angle_by_bisection
from report.numbers.independent.waveforms import quadrature_gain
from report.numbers.listed_functions import friction_listing, inertia_formula, inertia_listing

REACHED = sympy.Gt(A, GAP / 2)
FORMULA_FORM = r"""
N = 0.5 + \frac{1}{\pi}\left(1 - \frac{b}{A}\right)\sqrt{1 - \left(1 - \frac{b}{A}\right)^2}
+ \frac{1}{\pi}\sin^{-1}\left(1 - \frac{b}{A}\right)
- \frac{j}{\pi}\left(1 - \left(1 - \frac{b}{A}\right)^2\right)
""".strip().replace("\n", " ")
"""N in the order of the listings; Listing A.6 calls the gap D."""
NESTED = r"\sin(\phi_c) + \beta"
INERTIA_FORM = rf"""
N = \frac{{1}}{{\pi}}\left(\pi + 2\sin({NESTED}) - \phi_c - \sin({NESTED})\cos({NESTED})\right)
- \frac{{j}}{{\pi}}\left(1 - \cos({NESTED})\right)^2
""".strip().replace("\n", " ")
"""N in the order of Listing A.4, with its Beta."""
FLIGHT_FORM = r"\frac{\gamma^2 e^{\frac{1}{\gamma}(\tan^{-1}(1/\gamma) - \phi_c)}}{\sqrt{1 + \gamma^2}}"


def friction_expression() -> sympy.Expr:
    """Return N of Listings A.2, A.3 and, but for friction, A.6, with the gap for its b."""
    ratio = 1 - GAP / A
    real = sympy.Rational(1, 2) + ratio * sympy.sqrt(1 - ratio**2) / sympy.pi + sympy.asin(ratio) / sympy.pi
    return real - sympy.I * (1 - ratio**2) / sympy.pi


def formula_part() -> ClaimPart:
    """Return the part on the formula of friction-controlled backlash."""
    waveform, values = friction_waveform(), {A: sympy.Rational(17, 10), GAP: sympy.Rational(6, 7)}
    derived = simplified_describing_function(waveform, A)
    return expression(
        "formula, with $b$ the total gap",
        friction_expression(),
        derived,
        assume=REACHED,
        second=by_quadrature(derived, quadrature_gain(waveform, A, values), values),
        printed_form=FORMULA_FORM,
        derived_form=f"N = {latex(derived.subs(GAP, assumed.positive('b')))}",
        item="formula of N in Listings A.2, A.3 and A.6",
    )


def guard_part() -> ClaimPart:
    """Return the part on lines 5 and 6, which set N to zero where the amplitude is small."""
    inside = friction_listing(0.25, 1.0)
    return assertion(
        "amplitudes inside the dead band",
        "the function returns zero where the pin does not reach the bridge",
        abs(inside) < 1e-12,
        f"""
        the zeros of line 6 are overwritten by line 12; at a quarter of the gap the value is {inside.real:.2f}
        {inside.imag:+.2f} j
        """,
        method=REPEATED,
        second=close(
            "the square root of a negative number",
            complex(friction_expression().subs({A: 0.25, GAP: 1.0})),
            inside,
        ),
        item="zeros for small amplitudes in Listings A.2 and A.3",
    )


@claim("lst-A.2")
def first_version(_: Evidence) -> Record:
    yield formula_part()
    yield guard_part()
    yield text("""
        The formula is right when $b$ is the total gap; equations 2.36 to 2.41 use half of it for the same
        letter. The guard of line 6 asks for $A < b$ where $A < b/2$ is meant, and has no effect. The names
        `N.re` and `N.im` of this listing are [judged apart](#txt-A.3-names).

        None on figures, whose plots start above $b/2$. A search that strays below gets complex numbers that
        mean nothing.
    """)


@claim("lst-A.3")
def second_version(_: Evidence) -> Record:
    yield formula_part()
    yield guard_part()
    yield text("""
        As at [Listing A.2](#lst-A.2): the formula is right, and the guard has no effect. The text before it
        describes another function, with an input wave and a previous output: Listing A.7.

        No figure is affected.
    """)


def inertia_parts() -> tuple[ClaimPart, ClaimPart]:
    """Return the parts on the listing of inertia-controlled backlash, which is printed twice."""
    ratio = inertia_contact_ratio()
    nested = sympy.sin(CONTACT) + ratio
    real = sympy.pi + 2 * sympy.sin(nested) - CONTACT - sympy.sin(nested) * sympy.cos(nested)
    printed = real / sympy.pi - sympy.I * (1 - sympy.cos(nested)) ** 2 / sympy.pi
    derived = simplified_describing_function(inertia_waveform(), A, (GAP, A * ratio))
    one, two, angle = inertia_listing(1.0, 1.0), inertia_listing(1.0, 2.0), contact_angle_by_bisection(1.0)
    formula = expression(
        r"with $w = 1$, where $\beta = \phi_c - \sin\phi_c$",
        printed,
        derived,
        left="N",
        second=close("the listing, repeated, at Beta = 1", one, complex(derived.subs(CONTACT, angle))),
        printed_form=INERTIA_FORM,
        item="formula of N in Listings A.4 and A.10",
    )
    by_half = "its formula at half of the contact angle, the root of line 3 for $w = 2$"
    argument = assertion(
        "with another $w$",
        "the function still returns the describing function",
        abs(two - one) < 1e-9,
        f"""
        at Beta = 1 it returns {one.real:.4f} {one.imag:+.4f} j for $w = 1$ and {two.real:.4f} {two.imag:+.4f}
        j for $w = 2$
        """,
        method=REPEATED,
        second=close(by_half, inertia_formula(angle / 2, 1.0), two),
        item="argument w of Listings A.4 and A.10",
        certainty=Certainty.READING,
    )
    return formula, argument


@claim("lst-A.4")
def inertia_controlled(_: Evidence) -> Record:
    yield from inertia_parts()
    yield text("""
        Line 3 scales the unknown by $w$, so its root is the contact angle divided by $w$, which the formula
        then takes for the angle itself. Called with $w = 1$ the listing is right; called with an angular
        frequency, as its comment suggests, it is wrong, since this describing function has no frequency.

        With which $w$ figure 5.13 was drawn is not said. The [prediction near 5120
        rad/s](#txt-5.2.2-prediction) tells.
    """)


@claim("lst-A.5")
def viscous_controlled(_: Evidence) -> Record:
    root, wrong_root = sympy.sqrt(1 + GAMMA**2), sympy.sqrt(1 - GAMMA**2)
    flight = GAMMA**2 / root * sympy.exp((separation_angle() - CONTACT) / GAMMA)
    derived = contact_ratio().subs(SEPARATION, separation_angle())
    general = viscous.general_describing_function()
    yield expression(
        "line 6, contact angle",
        wrong_root - sympy.sin(CONTACT) - flight,
        derived,
        assume=sympy.Lt(GAMMA, 1),
        printed_form=rf"\sqrt{{1 - \gamma^2}} - \beta = \sin\phi_c + {FLIGHT_FORM}",
        derived_form=rf"\sqrt{{1 + \gamma^2}} - \beta = \sin\phi_c + {FLIGHT_FORM}",
        second=same("the right form", root - sympy.sin(CONTACT) - flight, derived),
        slip=repeated("equation 2.46 has minus instead of plus under the root", derived - root + wrong_root),
        item="sqrt(1 - gamma^2), contact angle of viscous-controlled backlash",
    )
    yield viscous.in_phase_part("lines 11 to 14, np", general)
    yield viscous.quadrature_part("lines 16 to 19, nq", general)
    yield text(r"""
        Lines 11 to 19 are right, brackets included. Line 6 repeats the sign of [equation 2.46](#eq-2.46), so
        the angle that is put into them is wrong; for $\gamma > 1$ it is complex. The last line is [judged
        apart](#txt-A.6-imaginary-unit).

        The contours of figure 5.16, drawn for $1 < \gamma < 3/2$, and what section 5.2.3 concludes from them,
        rest on this line.
    """)


@claim("lst-A.6")
def equivalent(_: Evidence) -> Record:
    b_1, a_1 = 4 * FORCE / sympy.pi, 0
    printed = -(sympy.I / omega) * (1 / A) * (b_1 + sympy.I * a_1)
    relay = describing_function(relay_waveform(), A)
    derived = sympy.simplify(sympy.I * omega * relay.subs(A, omega * A))
    slip = r"""
        the relay's gain for a displacement is divided by $j\omega$ instead of that for a velocity multiplied
        by it
        """
    second = same(
        "the Fourier coefficients of friction under a displacement",
        describing_function(coulomb_waveform(), A),
        derived,
    )
    yield formula_part()
    yield expression(
        "friction term, lines 13 to 18",
        printed,
        derived,
        second=second,
        slip=made_here(slip, relay / (sympy.I * omega)),
        printed_form=r"-\frac{j}{\omega} \cdot \frac{1}{A} \cdot \frac{4F_c}{\pi}",
        item="-j 4F_c/(omega A pi), friction term of the equivalent nonlinearity",
    )
    yield text(r"""
        The backlash part is that of Listing A.3. The friction part divides by $j\omega$ what has to be
        multiplied by it, and takes the amplitude of the displacement for that of the velocity. The right term
        is $j\,4F_c/(\pi A)$: with the other sign, without a frequency, and in N/m.

        All contours of section 5.2.5 contain it, and with them the limit cycle that chapter 7 gives the model
        with friction. The caption, which calls the listing viscous-controlled, is
        [judged apart](#txt-A.7-captions).
    """)


@claim("lst-A.10")
def inertia_controlled_again(_: Evidence) -> Record:
    yield from inertia_parts()
    yield text("""
        This is Listing A.4 once more, to the letter: right with $w = 1$ and wrong with any other, see
        [Listing A.4](#lst-A.4).

        As there.
    """)
