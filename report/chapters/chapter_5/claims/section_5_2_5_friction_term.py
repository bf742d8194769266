"""Claims of section 5.2.5 on the describing function of backlash with friction (equation 5.14)."""

from collections.abc import Callable

import sympy

from derivations.elements.friction import FORCE as COULOMB
from derivations.symbols import A, omega
from report.chapters.chapter_2.claims.section_2_4 import printed_backlash_part
from report.chapters.chapter_5.claims.section_5_2_4 import FRICTION, RELAY
from report.judging.claim import ClaimPart, Slip
from report.judging.parts import expression, made_here, repeated, same
from report.judging.record import Record, claim, text
from report.judging.verdict import Severity
from report.numbers.evidence import Evidence

PRINTED_TERM = -sympy.I * 4 * COULOMB / (omega * A * sympy.pi)


def coulomb_part(
    over: sympy.Expr = sympy.S.One, made: Callable[[str, sympy.Expr], Slip] = made_here
) -> ClaimPart:
    """Return the part on the friction term, which equation 5.14 divides by the amplitude once more."""
    by_velocity = sympy.simplify(sympy.I * omega * RELAY.subs(A, omega * A))
    means = r"$j\omega$ times the gain for an amplitude of velocity $\omega A$"
    name = r"the gain for a displacement is divided by $j\omega$"
    form = r"-j\frac{4F_c}{\omega A\pi}"
    return expression(
        "Coulomb term",
        PRINTED_TERM / over,
        FRICTION,
        second=same(means, by_velocity, FRICTION),
        slip=made(name + ", and by $A$" * (over != 1), RELAY / (sympy.I * omega) / over),
        printed_form=form if over == 1 else rf"\frac{{1}}{{A}}\left({form}\right)",
        item="-j 4F_c/(omega A pi), friction term of the equivalent nonlinearity",
        severity=Severity.CONCLUSION,
    )


@claim("eq-5.14")
def equivalent(_: Evidence) -> Record:
    yield printed_backlash_part("backlash term")
    yield coulomb_part(over=A)
    yield text(r"""
        The backlash part lacks the factor $A/\pi$, [as in equation 2.59](#eq-2.59). The friction part has the
        wrong sign and divides by a frequency that drops out, [as derived for it
        alone](#txt-5.2.5-coulomb-term). Here it stands inside a bracket that is divided by $A$ once more.

        Figures 5.21 to 5.24 come from Listing A.6, which has the first part right and the second wrong.
    """)


@claim("txt-5.2.5-coulomb-term")
def coulomb_term(_: Evidence) -> Record:
    yield coulomb_part()
    yield text(r"""
        With $G_g = 1/s$ the factor $1/G_g$ is $j\omega$, not $1/(j\omega)$, and friction sees the amplitude
        $\omega A$ of the velocity. Together that is $j\omega \cdot 4F_c/(\pi\omega A) = j\,4F_c/(\pi A)$:
        positive, without frequency, in N/m. The printed term is in N s/m.

        With the printed sign friction feeds the oscillation that it damps. The factor $1/\omega$ makes it
        weak. No contour of section 5.2.5 with a force stands.
    """)


@claim("txt-5.2.5-omega-limit")
def large_frequency(_: Evidence) -> Record:
    printed, right = (sympy.limit(term, omega, sympy.oo) for term in (PRINTED_TERM, FRICTION))
    yield expression(
        "limit of the Coulomb term",
        printed,
        right,
        second=same(r"the term does not contain $\omega$", FRICTION.diff(omega), sympy.Integer(0)),
        slip=repeated(r"the printed friction term is taken, which is divided by $\omega$", printed),
        printed_form=r"\lim_{\omega\to\infty}\left(\frac{4F_c}{\omega A\pi}\right) = 0",
    )
    yield text("""
        The limit is right for the printed term, which vanishes at high frequency because of its [wrong
        factor](#txt-5.2.5-coulomb-term). The right term does not depend on frequency: friction weighs the
        same at every speed, and less at larger amplitudes.

        Figure 5.21a, and what chapter 7 says about low and high frequency, describe the factor and not
        friction.
    """)


@claim("txt-5.2.5-zero-fc")
def without_force(_: Evidence) -> Record:
    yield expression("Coulomb term for $F_c = 0$", sympy.Integer(0), FRICTION.subs(COULOMB, 0))
    yield text("""
        Without force the friction term is zero in either form, and friction-controlled backlash is left. The
        shorter path comes from the range of amplitudes that was drawn.
    """)
