"""Claims of sections 2.3.1 and 2.3.2 and figure 2.5: harmonic balance and what it assumes."""

import control
import numpy as np
import sympy

from derivations import assumed
from report.chapters.second_ways import EXACTLY
from report.judging.comparisons.printed import product, total
from report.judging.parts import assertion, close, expression, same
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.exact_response import gain_ratio
from report.numbers.independent.examples import van_der_pol_third_harmonic
from report.numbers.textbook_loops import relay_loop
from report.numbers.thesis import LIMIT_CYCLE_OMEGA
from trimmer.linear import filtering_ratio

LINEAR, NONLINEAR, SIGNAL = sympy.symbols("G N Y")
MUCH_LESS = 0.2  # Share of the fundamental below which a harmonic is called much less
LOOP_FORM = r"N(A, \omega)G(j\omega) + 1"


@claim("fig-2.5")
def closed_loop(_: Evidence) -> Record:
    # Rows: e = r - y, u = N e, y = G u, for the signals (e, u, y).
    blocks = sympy.Matrix([[1, 0, 1], [-NONLINEAR, 1, 0], [0, -LINEAR, 1]])
    plant, constant, point = relay_loop().plant, 0.7, 0.3 + 1.1j
    closed = control.feedback(constant * plant, 1)
    through_poles = complex(np.polyval(closed.den[0][0], point) / np.polyval(plant.den[0][0], point))
    means = "the closed loop of python-control with a constant in the place of $N$"
    yield expression(
        "what has to be zero for an oscillation without reference",
        total(product(NONLINEAR, LINEAR), sympy.Integer(1)),
        blocks.det(),
        form=LOOP_FORM,
        second=close(means, 1 + constant * complex(plant(point)), through_poles),
    )
    yield text("""
        With $r = 0$ the signals of the loop are the solutions of three homogeneous equations, and differ from
        zero only if their determinant $1 + NG$ is zero. The amplitude is that at the input of $N$.
    """)


@claim("eq-2.25")
def harmonic_balance(_: Evidence) -> Record:
    loop = sympy.expand((SIGNAL - LINEAR * (-NONLINEAR * SIGNAL)) / SIGNAL)
    yield expression("", total(NONLINEAR * LINEAR, 1), loop, form=f"{LOOP_FORM} = 0")
    yield text("""
        Round the loop with negative feedback a sinusoid $Y$ comes back as $-NGY$. It sustains itself with a
        nonzero amplitude exactly if $1 + NG = 0$.
    """)


@claim("eq-2.26")
def filtering_hypothesis(known: Evidence) -> Record:
    at, system = LIMIT_CYCLE_OMEGA, known.numbers.displacement_only
    second, third, *others = (float(filtering_ratio(system, at, n)) for n in range(2, 20))
    exact = gain_ratio(known.numbers, at, 3)
    yield assertion(
        "at the predicted limit cycle",
        "the linear part passes every harmonic much less well than the fundamental",
        max(second, third, *others) < MUCH_LESS,
        f"at {at} rad/s the second is passed {second:.3f}, the third {third:.3f} times as well",
        method="frequency response at the harmonics",
        second=close(EXACTLY, exact, third),
        printed_form=r"|G(j\omega)| \gg |G(jn\omega)|, \quad n = 2, 3, \dots",
    )
    yield text("""
        This is the usual condition, tried here at the predicted limit cycle. It is stricter than needed,
        since an odd nonlinearity makes no even harmonics. What counts is the ratio times the size of the
        nonlinearity's own harmonic. Where else it is met is judged at section 5.1.2.
    """)


@claim("txt-2.3.2-van-der-pol")
def van_der_pol(_: Evidence) -> Record:
    alpha, position, velocity = assumed.real("alpha x v")
    acceleration = -alpha * (position**2 - 1) * velocity - position
    gained = sympy.expand(velocity * (acceleration + position))
    time, radius, turning = assumed.positive("t A omega")
    circle = radius * sympy.cos(time)
    undamped = acceleration.subs({alpha: 0, position: circle, velocity: circle.diff(time)})
    yield assertion(
        r"$\alpha = 0$",
        "there is a limit cycle, to which other motions tend",
        gained.subs(alpha, 0) != 0,
        rf"""
        with $v = \dot x$ the energy $(x^2 + v^2)/2$ changes at the rate ${sympy.latex(gained)}$, for $\alpha
        = 0$ not at all: every motion keeps its amplitude
        """,
        method="balance of energy",
        certainty=Certainty.PROVEN,
        second=same(
            "circles of any radius, which solve the equation",
            circle.diff(time, 2) - undamped,
            sympy.Integer(0),
        ),
    )
    sine = radius * sympy.sin(turning * time)
    ellipse = (sine / radius) ** 2 + (sine.diff(time) / (radius * turning)) ** 2
    yield assertion(
        "the elliptic shape, read as an ellipse",
        "a limit cycle of elliptic shape is not a sinusoid",
        sympy.simplify(ellipse) != 1,
        r"$x = A\sin\omega t$ satisfies $(x/A)^2 + (\dot x/(A\omega))^2 = 1$, an ellipse",
        method="the sinusoid put into the equation of an ellipse",
        certainty=Certainty.READING,
        second=same(
            "the sum of the squares of sine and cosine", sympy.expand_trig(ellipse), sympy.Integer(1)
        ),
    )
    damping = 1.0
    third = 100 * van_der_pol_third_harmonic(damping)
    yield text(rf"""
        The condition is $\alpha > 0$: for $\alpha = 0$ every orbit is closed, and none is a limit cycle by
        the thesis's own definition. An ellipse over position and velocity is a sinusoid, the very shape that
        the method assumes. If any distorted oval is meant, the sentence is right: at $\alpha = {damping:.0f}$
        the third harmonic of the position has {third:.0f} % of the first.

        None: the caution is right, and no number rests on the example.
    """)
