"""Claims of section 2.3.5 and figure 2.12: Coulomb friction and its describing function (2.48 to 2.52)."""

import numpy as np
import sympy

from derivations import assumed
from derivations.elements.friction import FORCE, friction_waveform, relay_waveform
from derivations.elements.waveform import THETA, segment_integral
from derivations.elements.waveform import describing_function as derived_function
from derivations.symbols import A
from report.chapters.second_ways import by_quadrature
from report.judging.comparisons.expression import SameExpression
from report.judging.comparisons.printed import product, total
from report.judging.parts import assertion, close, expression, lost_in_the_copy, made_here
from report.judging.record import Record, claim, text
from report.judging.text import one_line
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.symbolic import zeros_in_turn
from report.numbers.independent.waveforms import coefficient, quadrature_gain
from trimmer import CoulombFriction, Relay

SINE, COSINE = sympy.sin(THETA), sympy.cos(THETA)
VALUES = {FORCE: sympy.Rational(3, 5), A: sympy.Rational(7, 4)}
SPEED = assumed.real("v")
RELAY, FRICTION = relay_waveform(), friction_waveform()
HALVES = one_line(
    r"""
    b_1 = \frac{1}{\pi} \int_0^\pi F_c \sin(\omega t)\,d(\omega t) + \frac{1}{\pi} \int_\pi^{2\pi} -F_c
    \sin(\omega t)\,d(\omega t)
    """
)
"""The first line of equation 2.51."""
CHOICE_ITEM = "all sinusoidal inputs lead to one function, Coulomb friction"
LOCUS_ITEM = "−1/N strictly real and negative, Coulomb friction"
"""Printed things that two parts judge, one for each reading."""


@claim("eq-2.48")
def law(_: Evidence) -> Record:
    yield expression(
        "power lost by a body that feels $-F$",
        FORCE * sympy.sign(SPEED) * SPEED,
        FORCE * sympy.Abs(SPEED),
        printed_form=r"F(\dot x) = F_c \operatorname{sign}(\dot x)",
        derived_form=r"F(\dot x)\,\dot x = F_c |\dot x| \ge 0",
    )
    yield text(r"""
        A force of constant size against the motion takes the power $F_c|\dot x|$, so the printed law
        dissipates. It is the force that the body exerts; on the body acts its negative.
    """)


@claim("eq-2.49")
def pieces(_: Evidence) -> Record:
    printed = sympy.Piecewise((FORCE, SPEED > 0), (0, sympy.Eq(SPEED, 0)), (-FORCE, True))
    for relation, value in ((">", 2), ("=", 0), ("<", -3)):
        label = rf"$\dot x {relation} 0$"
        yield expression(label, printed.subs(SPEED, value), FORCE * sympy.sign(value), "F")
    yield text("""
        The three cases are those of the sign function. At rest a real contact carries any force up to $F_c$,
        not zero. A describing function does not see the difference; a simulation does.
    """)


@claim("fig-2.12")
def friction_as_relay(_: Evidence) -> Record:
    switching = {segment.start % (2 * sympy.pi) for segment in FRICTION.segments}
    levels = {segment.value for segment in FRICTION.segments}
    angles = ", ".join(sympy.latex(each) for each in sorted(switching))
    phases = np.linspace(0.1, 6.2, 40)
    relay = Relay(1.0).waveform(phases + np.pi / 2, 1.0)
    overlap = float(np.dot(relay, CoulombFriction(1.0).waveform(phases, 1.0)))
    means = "a relay with the velocity as its input, sampled over a period"
    work = sympy.pi * A * FRICTION.cosine_coefficient()
    yield assertion(
        "",
        "friction is a relay that switches where the velocity changes its sign",
        (switching == zeros_in_turn(COSINE, THETA), levels == {FORCE, -FORCE}),
        rf"""
        under $A\sin\theta$ the force is $\pm F_c$ and switches where the velocity is zero, at $\theta =
        {angles}$; in a period it takes the work ${sympy.latex(work)}$
        """,
        method="levels and limits of the derived waveform",
        second=close(means, overlap, float(phases.size)),
    )
    yield text("""
        The force has two levels and follows the sign of the velocity, as the text says. Over the displacement
        the same force is not a relay's step but a rectangle with the area $4F_cA$. So it matters which of the
        two is called the input.
    """)


@claim("eq-2.50")
def cosine_coefficient(_: Evidence) -> Record:
    halves = (r"\int_0^\pi F_c", r"\int_\pi^{2\pi} -F_c")
    for half, shown, segment in zip(("first", "second"), halves, RELAY.segments, strict=True):
        label, form = f"integral over the {half} half", rf"{shown} \cos(\omega t)\,d(\omega t) = 0"
        yield expression(label, sympy.Integer(0), segment_integral(segment, COSINE), form=form)
    derived = RELAY.cosine_coefficient()
    second = by_quadrature(derived, coefficient(RELAY, COSINE, VALUES), VALUES)
    yield expression("$a_1$, switched by its own input", sympy.Integer(0), derived, "a_{1}", second=second)
    yield text(r"""
        This is right for a relay that its own sinusoidal input switches; for friction that input is the
        velocity. With the displacement as input the output is switched a quarter period earlier. Then $b_1 =
        0$ and $a_1 = 4F_c/\pi$, see [the choice of input](#txt-2.3.5-input-choice).
    """)


@claim("eq-2.51")
def sine_coefficient(_: Evidence) -> Record:
    printed = total(-sympy.cos(sympy.pi, evaluate=False), -sympy.cos(0, evaluate=False))
    primitive = sympy.integrate(SINE, THETA)
    bracket = primitive.subs(THETA, sympy.pi) - primitive.subs(THETA, 0)
    numeric, derived = coefficient(RELAY, SINE, VALUES), RELAY.sine_coefficient()
    whole = by_quadrature(derived, numeric, VALUES)
    yield expression("first line, both halves", halves_as_printed(), derived, second=whole, form=HALVES)
    restored = total(-sympy.cos(sympy.pi, evaluate=False), product(-1, -sympy.cos(0, evaluate=False)))
    yield expression(
        "second line, the bracket",
        printed.doit(),
        bracket,
        second=by_quadrature(bracket, 2.0 * numeric / float(4 * VALUES[FORCE] / sympy.pi), VALUES),
        copy_fault=lost_in_the_copy(
            "one of the two minus signs before cos(0)", SameExpression(restored.doit(), bracket)
        ),
        printed_form=r"[-\cos(\pi) - \cos(0)]",
        derived_form=r"[-\cos(\pi) - (-\cos(0))]",
    )
    yield expression("third line, $b_1$", 4 * FORCE / sympy.pi, derived, "b_{1}", second=whole)
    yield text("""
        As copied, the bracket of the second line is zero. The lower limit has to be subtracted, and two minus
        signs then stand before $\\cos(0)$; the copy has one. The third line is right, as it follows from the
        bracket with both.
    """)


def halves_as_printed() -> sympy.Expr:
    """Return the first line of equation 2.51."""
    integrals = (
        sympy.Integral(level * SINE, (THETA, start, start + sympy.pi))
        for level, start in ((FORCE, 0), (-FORCE, sympy.pi))
    )
    return sympy.Add(*(integral.doit() / sympy.pi for integral in integrals))


@claim("eq-2.52")
def describing_function(_: Evidence) -> Record:
    derived = derived_function(RELAY, A)
    second = by_quadrature(derived, quadrature_gain(RELAY, A, VALUES), VALUES)
    label = "switched by its own input of amplitude $A$"
    form = r"N(A) = \frac{4F_c}{A\pi}"
    yield expression(label, 4 * FORCE / (A * sympy.pi), derived, second=second, form=form)
    yield text("""
        It is the describing function of an ideal relay. For friction the input is the velocity, so $A$ is an
        amplitude of velocity here, and the unit is N s/m. Section 5.2.4 uses it with an amplitude of
        displacement.
    """)


@claim("txt-2.3.5-input-choice")
def input_choice(_: Evidence) -> Record:
    by_velocity, by_displacement = derived_function(RELAY, A), derived_function(FRICTION, A)
    yield expression(
        "the velocity as input, a cosine in place of a sine",
        by_velocity,
        # Switched by a cosine the output is that of friction, and the input's phasor j times as large.
        by_displacement / sympy.I,
        "N",
        second=by_quadrature(by_velocity, quadrature_gain(RELAY, A, VALUES), VALUES),
        item=CHOICE_ITEM,
    )
    yield expression(
        "the displacement as input",
        by_velocity,
        by_displacement,
        "N",
        second=by_quadrature(by_displacement, quadrature_gain(FRICTION, A, VALUES), VALUES),
        slip=made_here("the phase between velocity and displacement is dropped", by_velocity),
        item=CHOICE_ITEM,
    )
    yield text(r"""
        If the input is the velocity, the footnote is right: it does not matter which sinusoid the velocity
        is. If it is the displacement, as the sentence before and section 5.2.4 suggest, it is wrong. Friction
        follows the velocity, which leads the displacement by a quarter period, so $N = j\,4F_c/(\pi A)$: the
        same size, turned by 90 degrees. A factor cannot turn a phase back.

        Section 5.2.4 puts the real value into a loop whose signal is a displacement. That makes friction a
        switching spring, which stores energy, where it is a damper, which takes it.
    """)


@claim("txt-2.3.5-coulomb-locus")
def locus(_: Evidence) -> Record:
    relay, friction = (sympy.simplify(-1 / derived_function(each, A)) for each in (RELAY, FRICTION))
    statement = "$-1/N$ lies on the negative real axis"
    method = "sign of the derived expression for every positive amplitude"
    yield assertion(
        "in a loop whose signal is the velocity",
        statement,
        relay.is_negative is True,
        f"$-1/N = {sympy.latex(relay)}$",
        method=method,
        second=by_quadrature(relay, -1 / quadrature_gain(RELAY, A, VALUES), VALUES),
        certainty=Certainty.PROVEN,
        item=LOCUS_ITEM,
    )
    amplitude, force = float(VALUES[A]), float(VALUES[FORCE])
    turned = -np.pi * amplitude / (4j * force)
    yield assertion(
        "in a loop whose signal is the displacement",
        statement,
        friction.is_negative is True,
        r"$-1/N = j\,\pi A/(4F_c)$ lies on the positive imaginary axis",
        method=method,
        second=close("$1/j = -j$", complex(friction.subs(VALUES)), turned),
        certainty=Certainty.READING,
        item=LOCUS_ITEM,
    )
    yield text("""
        For the input of [equation 2.52](#eq-2.52), the velocity, the statement is right. In a loop whose
        signal is the displacement, as the thesis's is, the locus is the positive imaginary axis, and another
        crossing is to be looked for. The section does not say which loop it has in mind.

        Section 5.2.4 looks at the negative real axis in the loop of the displacement; its conclusion is
        [judged there](#txt-5.2.4-no-crossing).
    """)
