"""Claims of section 2.3.4, appendix B.2 and figure 2.11 on viscous-controlled backlash (2.44 to 2.47)."""

from functools import cache

import numpy as np
import sympy

from derivations import assumed
from derivations.dimensions import FORCE, LENGTH, MASS, TIME, dimension_of
from derivations.elements.backlash import (
    CONTACT,
    GAMMA,
    GAP,
    SEPARATION,
    contact_ratio,
    free_flight,
    general_waveform,
    separation_angle,
)
from derivations.elements.waveform import THETA, describing_function
from derivations.symbols import DIMENSIONS, A, omega
from report.chapters.second_ways import by_quadrature
from report.judging.claim import ClaimPart
from report.judging.comparisons.digits import CloseNumbers
from report.judging.comparisons.expression import SameExpression
from report.judging.comparisons.printed import product, total
from report.judging.parts import close, expression, lost_in_the_copy, made_here, part, same, so
from report.judging.record import Record, claim, text
from report.judging.shown import Words
from report.judging.text import one_line
from report.numbers.evidence import Evidence
from report.numbers.independent.load_in_play import contact_after_flight, contact_by_equation, zero_of_force
from report.numbers.independent.waveforms import Values, quadrature_gain
from trimmer import ViscousBacklash

SINE, COSINE = sympy.sin(CONTACT), sympy.cos(CONTACT)
ROOT = sympy.sqrt(1 + GAMMA**2)
# A flight has to last: contact after separation, within half a turn.
VALUES = {GAMMA: sympy.Rational(5, 4), CONTACT: sympy.Rational(9, 4)}
IN_PHASE = one_line(
    r"""
    n_p = \frac{2\gamma^2}{\pi(1+\gamma^2)} \left(\frac{1+\gamma^2}{2\gamma^2} (\phi_s - \phi_c + \pi +
    \sin\phi_c \cos\phi_c) + \frac{1}{2\gamma} + \frac{1}{\gamma} \left(\frac{b}{A} - \sqrt{1+\gamma^2}\right)
    \left(\frac{1}{\gamma} \cos\phi_c - \sin\phi_c\right) - \frac{1}{\gamma} \sin^2\phi_c - \sin\phi_c
    \cos\phi_c\right)
    """
)
FACTOR = r"\frac{-2\gamma^2}{\pi(1+\gamma^2)}"
BEHIND = r"1 + \frac{1}{2\gamma^2} + \frac{1-\gamma^2}{2\gamma^2} \sin^2\phi_c"
LEFT_OUT = one_line(
    r"""
    \frac{1}{\gamma} \left(\frac{b}{A} - \sqrt{1+\gamma^2}\right) \left(\frac{1}{\gamma} \sin\phi_c +
    \cos\phi_c\right) + \frac{1}{\gamma} \sin\phi_c \cos\phi_c
    """
)
"""The terms of n_q behind the factor in equation B.4, and those that its bracket leaves out."""
QUADRATURE = rf"n_q = {FACTOR} \left({BEHIND} + {LEFT_OUT}\right)"
RIGHT_SIDE = one_line(
    r"""
    \sin(\phi_c) + \frac{\gamma^2 e^{(1/\gamma)(\tan^{-1} 1/\gamma - \phi_c)}}{\sqrt{1 + \gamma^2}}
    """
)
"""The right side of equation 2.46 as printed."""
LOAD, PLAY = 1.7, 0.6  # M omega / D and gap over amplitude for which the flight is integrated numerically


@cache
def general_describing_function() -> sympy.Expr:
    """Return N of the general element as a function of γ and the contact angle alone."""
    function = describing_function(general_waveform(), A).subs(GAP, A * contact_ratio())
    return sympy.expand(function).subs(SEPARATION, separation_angle())


def gap_over_amplitude() -> sympy.Expr:
    """Return b/A from the derived contact equation."""
    return contact_ratio().subs(SEPARATION, separation_angle())


def flight_lasts() -> sympy.Basic:
    """Return that contact comes after separation, within half a turn."""
    angle = separation_angle()
    return sympy.And(sympy.Gt(CONTACT, angle), sympy.Lt(CONTACT, angle + sympy.pi))


def point() -> Values:
    """Return values of all symbols that belong together."""
    angle = separation_angle().subs(VALUES)
    ratio = contact_ratio().subs(SEPARATION, angle).subs(VALUES)
    return {**VALUES, A: sympy.Integer(1), SEPARATION: angle, GAP: ratio}


@cache
def numeric() -> complex:
    """Return N at that point by quadrature."""
    return quadrature_gain(general_waveform(), A, point())


@claim("fig-2.11")
def separation_and_contact(_: Evidence) -> Record:
    before, angle = general_waveform().segments[-1].value, separation_angle()
    label, pin = r"velocity of the load before $\phi_s$, over $\omega$", A * sympy.sin(THETA)
    yield expression(label, pin.diff(THETA), before.diff(THETA), r"\dot y/\omega")
    separation = float(angle.subs(GAMMA, LOAD))
    second = close("a search for the zero of the contact force", zero_of_force(LOAD), separation)
    label = r"phase $\phi_s$ of the separation"
    yield expression(label, sympy.atan(1 / GAMMA), angle, r"\phi_s", second=second)
    found = contact_by_equation(LOAD, PLAY, separation)
    flown = contact_after_flight(LOAD, PLAY, separation)
    # Where the numeric element is at the side of the gap that the pin brings up, just before and at contact.
    phases = np.array([found - 1e-6, found])
    apart = ViscousBacklash(PLAY, LOAD).waveform(phases, 1.0, 1.0) - np.sin(phases) - PLAY / 2
    means = "the numeric element, which touches the other side there and not before"
    yield part(
        rf"phase $\phi_c$ of the next contact, for $\gamma = {LOAD}$ and $b/A = {PLAY}$",
        CloseNumbers(found, flown),
        second=so(means, abs(apart[0]) >= 1e-9 > abs(apart[1])),
        printed_form=Words(r"pin and load meet again at $\phi_c$"),
        derived_form=Words(
            f"the flight, integrated in steps, ends at {flown:.6f}; "
            f"equation 2.46 with its right sign gives {found:.6f}"
        ),
    )
    yield text(r"""
        Pin and load move alike up to $\phi_s$ and meet again at $\phi_c$, as the text reads the figure. At
        $\phi_s$ the contact would have to pull, $\gamma y'' + y' = 0$; equal velocities alone do not give it,
        since they hold during the whole contact. The printed equation for $\phi_c$ has a wrong sign,
        [see equation 2.46](#eq-2.46).
    """)


@claim("eq-2.44")
def separation(_: Evidence) -> Record:
    angle = separation_angle()
    force = sympy.simplify((sympy.cos(THETA) - GAMMA * sympy.sin(THETA)).subs(THETA, angle))
    second = same("the force of the wall at that phase", force, sympy.Integer(0))
    yield expression("", sympy.atan(1 / GAMMA), angle, r"\phi_{s}", second=second)
    yield text(r"""
        While the bridge follows the pin, the wall has to push with $D\dot y + M\ddot y$. That force reaches
        zero at the printed phase. Equal velocities, which the text gives as the reason, hold during the whole
        contact.
    """)


@claim("eq-2.45")
def ratio(_: Evidence) -> Record:
    mass, damping = assumed.positive("M D")
    printed = mass / damping * omega
    position, time = sympy.Function("y"), assumed.real("t")
    equation = mass * position(time).diff(time, 2) + damping * position(time).diff(time)
    in_phase = equation.subs(position(time), position(omega * time)).doit().subs(omega * time, THETA).doit()
    second, first = (in_phase.coeff(position(THETA).diff(THETA, order)) for order in (2, 1))
    yield expression("", printed, second / first, form=r"\gamma = \frac{M}{D} \omega")
    unit = dimension_of(printed, DIMENSIONS | {mass: MASS, damping: FORCE * TIME / LENGTH})
    yield text(rf"""
        With the phase as variable $M\ddot y + D\dot y = 0$ becomes $\gamma y'' + y' = 0$ with the printed
        ratio. It is a pure number, with the unit {unit}.
    """)


@claim("eq-2.46")
def contact_equation(_: Evidence) -> Record:
    flight = product(GAMMA**2 / ROOT, sympy.exp((sympy.atan(1 / GAMMA) - CONTACT) / GAMMA))
    wrong_root = sympy.sqrt(1 - GAMMA**2)
    derived = gap_over_amplitude()
    at_contact = {THETA: CONTACT, SEPARATION: separation_angle(), GAP: 0}
    meeting = sympy.simplify((free_flight() - A * sympy.sin(THETA)).subs(at_contact) / A)
    yield expression(
        "",
        wrong_root - SINE - flight,
        derived,
        assume=sympy.Lt(GAMMA, 1),
        second=same("the distance between flight and pin", meeting, ROOT - SINE - flight),
        slip=made_here("the sign under the root is minus instead of plus", derived - ROOT + wrong_root),
        item="sqrt(1 - gamma^2), contact angle of viscous-controlled backlash",
        printed_form=rf"\sqrt{{1 - \gamma^2}} - \frac{{b}}{{A}} = {RIGHT_SIDE}",
        derived_form=rf"\sqrt{{1 + \gamma^2}} - \frac{{b}}{{A}} = {RIGHT_SIDE}",
    )
    yield text(r"""
        The flight contributes $\sin\phi_s + \gamma\cos\phi_s = \sqrt{1 + \gamma^2}$; printed is $\sqrt{1 -
        \gamma^2}$. For $\gamma > 1$ the printed root is imaginary, so no real contact angle solves the
        equation.

        [Listing A.5](#lst-A.5) has the same sign, and section 5.2.3 evaluates it for $1 < \gamma < 3/2$.
        Every viscous contour drawn there rests on complex contact angles.
    """)


@claim("eq-2.47")
def complex_form(_: Evidence) -> Record:
    derived = general_describing_function()
    printed = sympy.re(derived) + sympy.I * sympy.im(derived)
    form = r"N(A, \omega) = n_p(A, \omega) + j\,n_q(A, \omega)"
    second = by_quadrature(derived, numeric(), point())
    yield expression("", printed, derived, second=second, form=form)
    yield text("""
        $n_p$ is the part in phase with the input, $n_q$ the part ahead of it by a quarter turn, as in
        equation 2.35.
    """)


def in_phase_part(label: str, derived: sympy.Expr) -> ClaimPart:
    """Return the part on n_p, which equation B.3 and Listing A.5 print alike."""
    bracket = total(
        (1 + GAMMA**2) / (2 * GAMMA**2) * (separation_angle() - CONTACT + sympy.pi + SINE * COSINE),
        1 / (2 * GAMMA),
        1 / GAMMA * (gap_over_amplitude() - ROOT) * (COSINE / GAMMA - SINE),
        -(SINE**2) / GAMMA,
        -SINE * COSINE,
    )
    real = sympy.re(derived)
    return expression(
        label,
        2 * GAMMA**2 / (sympy.pi * (1 + GAMMA**2)) * bracket,
        real,
        assume=flight_lasts(),
        second=by_quadrature(real, complex(numeric().real), point()),
        form=IN_PHASE,
    )


def quadrature_terms() -> tuple[sympy.Expr, sympy.Expr, sympy.Expr]:
    """Return the factor of n_q, the terms that equation B.4 puts behind it, and those it leaves out."""
    factor = -2 * GAMMA**2 / (sympy.pi * (1 + GAMMA**2))
    behind = 1 + 1 / (2 * GAMMA**2) + (1 - GAMMA**2) / (2 * GAMMA**2) * SINE**2
    left_out = 1 / GAMMA * (gap_over_amplitude() - ROOT) * (SINE / GAMMA + COSINE) + SINE * COSINE / GAMMA
    return factor, behind, left_out


def quadrature_part(label: str, derived: sympy.Expr) -> ClaimPart:
    """Return the part on n_q as Listing A.5 has it, with the factor before all terms."""
    factor, behind, left_out = quadrature_terms()
    imaginary = sympy.im(derived)
    return expression(
        label,
        factor * (behind + left_out),
        imaginary,
        assume=flight_lasts(),
        second=by_quadrature(imaginary, complex(numeric().imag), point()),
        form=QUADRATURE,
    )


@claim("eq-B.3")
def in_phase(_: Evidence) -> Record:
    yield in_phase_part("with $b/A$ from the contact equation", general_describing_function())
    yield text("""
        With the right contact equation the printed expression is the in-phase part of the derived describing
        function.
    """)


@claim("eq-B.4")
def quadrature(_: Evidence) -> Record:
    factor, behind, left_out = quadrature_terms()
    imaginary = sympy.im(general_describing_function())
    whole = SameExpression(factor * (behind + left_out), imaginary, assume=flight_lasts())
    yield expression(
        "with $b/A$ from the contact equation",
        factor * behind + left_out,
        imaginary,
        assume=flight_lasts(),
        second=by_quadrature(imaginary, complex(numeric().imag), point()),
        copy_fault=lost_in_the_copy("the place where the bracket closes, at the end of the last line", whole),
        printed_form=rf"n_q = {FACTOR} \left({BEHIND}\right) + {LEFT_OUT}",
        derived_form=QUADRATURE,
    )
    yield text(r"""
        In the copy the bracket behind the common factor closes at the end of the first line; it has to hold
        the other two lines as well. A bracket over several lines is easily closed too early, in typesetting
        as in reading a page by machine. With the bracket around everything, as [Listing A.5](#lst-A.5) has
        it, the expression is the derived one.
    """)
