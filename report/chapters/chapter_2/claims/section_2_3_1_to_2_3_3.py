"""Claims of sections 2.3.1 to 2.3.3 and figures 2.5 and 2.6: harmonic balance and describing function."""

from __future__ import annotations

import control
import numpy as np
import sympy

from derivations.elements.backlash import GAMMA, separation_angle
from derivations.elements.waveform import THETA, Segment, Waveform
from derivations.symbols import A, omega, t
from report.chapters.second_ways import EXACTLY
from report.claim import Certainty, Confirmation, Impact, Part, Severity
from report.comparisons.assertion import Assertion
from report.comparisons.printed import product, total
from report.evidence import Evidence
from report.numbers.independent.exact_response import gain_ratio
from report.numbers.independent.examples import van_der_pol_third_harmonic
from report.numbers.independent.waveforms import sampled_gain
from report.numbers.textbook_loops import relay_loop
from report.parts import assertion, close, expression, made_here, same
from report.record import Record, claim, text
from report.thesis import DRIVE_OMEGA, LIMIT_CYCLE_OMEGA
from trimmer import FrictionBacklash, ViscousBacklash, filtering_ratio

SOURCE = "report/chapters/chapter_2/claims/section_2_3_1_to_2_3_3.py"
LINEAR, NONLINEAR, SIGNAL = sympy.symbols("G N Y")
COSINE_PART, SINE_PART = sympy.Symbol("a_1", real=True), sympy.Symbol("b_1", positive=True)
MODULUS, ANGLE = sympy.sqrt(COSINE_PART**2 + SINE_PART**2), sympy.atan(COSINE_PART / SINE_PART)
"""Magnitude and phase of the first harmonic, equations 2.32 and 2.33."""
MEAN, COSINES, SINES = sympy.Symbol("a_0"), sympy.symbols("a_1:3"), sympy.symbols("b_1:3")
HARMONICS = [
    a * sympy.cos(n * THETA) + b * sympy.sin(n * THETA)
    for n, a, b in zip((1, 2), COSINES, SINES, strict=True)
]
SERIES = total(MEAN / 2, *HARMONICS)
WAVE = Waveform((Segment(-sympy.pi, sympy.pi, SERIES),))
"""A signal of two harmonics."""
MUCH_LESS = 0.2
"""Share of the fundamental below which a harmonic is called much less."""
LOOP_FORM = r"N(A, \omega)G(j\omega) + 1"


@claim("fig-2.5", source=SOURCE, lines=(314, 314), paragraph=3)
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


@claim("eq-2.25", source=SOURCE, lines=(318, 318), paragraph=3)
def harmonic_balance(_: Evidence) -> Record:
    loop = sympy.expand((SIGNAL - LINEAR * (-NONLINEAR * SIGNAL)) / SIGNAL)
    yield expression("", total(NONLINEAR * LINEAR, 1), loop, form=f"{LOOP_FORM} = 0")
    yield text("""
        Round the loop with negative feedback a sinusoid $Y$ comes back as $-NGY$. It sustains itself with a
        nonzero amplitude exactly if $1 + NG = 0$.
    """)


@claim("eq-2.26", source="trimmer/linear/low_pass.py", lines=(352, 352), paragraph=10)
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


@claim(
    "txt-2.3.2-van-der-pol",
    source=SOURCE,
    impact=Impact.LOCAL,
    severity=Severity.SLIP,
    lines=(326, 326),
    paragraph=1,
)
def van_der_pol(_: Evidence) -> Record:
    alpha, position, velocity = sympy.symbols("alpha x v", real=True)
    acceleration = -alpha * (position**2 - 1) * velocity - position
    gained = sympy.expand(velocity * (acceleration + position))
    time, radius, turning = sympy.symbols("t A omega", positive=True)
    circle = radius * sympy.cos(time)
    undamped = acceleration.subs({alpha: 0, position: circle, velocity: circle.diff(time)})
    yield assertion(
        r"$\alpha = 0$",
        "there is a limit cycle, to which other motions tend",
        gained.subs(alpha, 0) != 0,
        r"""
        with $v = \dot x$ the energy $(x^2 + v^2)/2$ changes at the rate $[[ gained | latex ]]$, for $\alpha =
        0$ not at all: every motion keeps its amplitude
        """,
        numbers={"gained": gained},
        method="balance of energy",
        certainty=Certainty.PROVEN,
        second=same(
            "a circle of any radius solves the equation", circle.diff(time, 2) - undamped, sympy.Integer(0)
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
        second=same("simplification to one", sympy.expand_trig(ellipse), sympy.Integer(1)),
    )
    damping = 1.0
    yield text(r"""
        The condition is $\alpha > 0$: for $\alpha = 0$ every orbit is closed, and none is a limit cycle by
        the thesis's own definition. An ellipse over position and velocity is a sinusoid, the very shape that
        the method assumes. Read as a shape that is merely not round, the sentence is right: at $\alpha =
        [[ damping | f0 ]]$ the third harmonic of the position has [[ third | f0 ]] % of the first, and the
        share grows with $\alpha$.

        None: the caution is right, and no number rests on the example.
    """).given(damping=damping, third=100 * van_der_pol_third_harmonic(damping))


@claim(
    "txt-2.3.3-amplitude-only",
    source="derivations/elements/backlash.py",
    impact=Impact.LOCAL,
    severity=Severity.SLIP,
    lines=(405, 405),
    paragraph=11,
)
def amplitude_only(_: Evidence) -> Record:
    near_limit_cycle, load, amplitude = 4609.5, 1e-3, 2.0
    element, separation = ViscousBacklash(1.0, load), separation_angle()
    driven, cycling = (
        complex(element.describing_function(amplitude, each)) for each in (DRIVE_OMEGA, near_limit_cycle)
    )
    statement = "the describing functions of backlash and of Coulomb friction depend on the amplitude alone"
    independent = Assertion(
        statement=statement,
        derived=GAMMA not in separation.free_symbols,
        asserted=False,
        evidence=f"the bridge separates at ${sympy.latex(separation)}$",
        method=r"it contains $\gamma = M\omega/D$",
    )
    yield assertion(
        "",
        statement,
        abs(driven - cycling) < 1e-9,
        """
        at an amplitude of [[ amplitude | f0 ]] gaps a load with $M/D$ of [[ load | f0 ]] ms has $N =
        [[ a.real | f3 ]] [[ a.imag | signed3 ]]j$ at [[ drive | f0 ]] rad/s and $[[ b.real | f3 ]]
        [[ b.imag | signed3 ]]j$ at [[ near | f0 ]] rad/s
        """,
        numbers={
            "amplitude": amplitude,
            "load": 1e3 * load,
            "a": driven,
            "b": cycling,
            "drive": DRIVE_OMEGA,
            "near": near_limit_cycle,
        },
        method="the describing function of viscous-controlled backlash at two frequencies",
        second=Confirmation("the derived phase of separation", independent),
    )
    yield text(r"""
        This is true of friction-controlled and inertia-controlled backlash and of a relay.
        Viscous-controlled backlash, the general case, depends on $\gamma = M\omega/D$ too, as section 2.3.4
        itself says.

        None: sections 2.3.4 and 2.3.6 put it right. For a load with inertia and friction
        [equation 2.55](#eq-2.55) is to be used and not 2.56.
    """)


@claim("fig-2.6", source=SOURCE, lines=(367, 367), paragraph=1)
def describing_function_block(_: Evidence) -> Record:
    factor = (SINE_PART + sympy.I * COSINE_PART) / A
    output = sympy.im(sympy.expand_complex(factor * A * sympy.exp(sympy.I * THETA)))
    element = FrictionBacklash(0.6)
    sampled, formula = sampled_gain(element, 1.0, 1.0), complex(element.describing_function(1.0))
    yield expression(
        r"output $M\sin(\omega t + \varphi)$ for the input $A\sin\omega t$",
        MODULUS * sympy.sin(THETA + ANGLE),
        output,
        second=close("the first line in the spectrum of a backlash's output", sampled, formula, 1e-6),
    )
    yield text("""
        The block multiplies the phasor of its input by $N$ and gives the first harmonic of the element's
        output. Its frequency is that of the input. The sentence after equation 2.27 speaks once of a shift in
        frequency; amplitude and phase are meant.
    """)


def sinusoid_part() -> Part:
    """Return the part on the sine written as an exponential, which two claims share."""
    exponential, sine = A * sympy.exp(sympy.I * omega * t), A * sympy.sin(omega * t)
    return expression(
        "",
        exponential,
        sine,
        second=same("Euler's formula", sympy.im(exponential), sine),
        slip=made_here("the imaginary part is not taken", exponential),
        item="A sin(ωt) = A e^(jωt), sinusoidal input of the nonlinearity",
        printed_form=r"u(t) = A\sin(\omega t) = Ae^{j\omega t}",
        derived_form=r"u(t) = A\sin(\omega t) = \operatorname{Im} Ae^{j\omega t}",
    )


@claim(
    "eq-2.27",
    source=SOURCE,
    impact=Impact.NOTATION,
    severity=Severity.SLIP,
    certainty=Certainty.READING,
    lines=(371, 371),
    paragraph=2,
)
def sinusoid(_: Evidence) -> Record:
    yield sinusoid_part()
    yield text(r"""
        Read as an equation it is wrong: a real sine is the imaginary part of the exponential, $A\sin\omega t
        = \operatorname{Im} Ae^{j\omega t}$. Read as a phasor that stands for the sine, which is surely
        meant, it is the usual notation.

        None: the ratio of phasors in equation 2.35 is right.
    """)


@claim(
    "txt-2.3.3-df-definition",
    source=SOURCE,
    impact=Impact.NOTATION,
    severity=Severity.SLIP,
    certainty=Certainty.READING,
    lines=(371, 371),
    paragraph=2,
)
def definition(_: Evidence) -> Record:
    yield sinusoid_part()
    yield text("""
        As at [equation 2.27](#eq-2.27): wrong as an equation, usual as a notation for phasors.

        None: the ratio of phasors in equation 2.35 is right.
    """)


@claim("eq-2.28", source=SOURCE, lines=(375, 375), paragraph=3)
def fourier_series(_: Evidence) -> Record:
    harmonics = (
        WAVE.cosine_coefficient(n) * sympy.cos(n * THETA) + WAVE.sine_coefficient(n) * sympy.sin(n * THETA)
        for n in (1, 2)
    )
    rebuilt = WAVE.cosine_coefficient(0) / 2 + sympy.Add(*harmonics)
    form = r"y(t) = \frac{a_0}{2} + \sum_{n=1}^\infty (a_n \cos(n\omega t) + b_n \sin(n\omega t))"
    yield expression("up to $n = 2$", SERIES, sympy.expand(rebuilt), form=form)
    yield text("""
        A signal of two harmonics is rebuilt from its coefficients by the printed series, with half of $a_0$.
    """)


@claim("eq-2.29", source=SOURCE, lines=(379, 379), paragraph=4)
def fourier_coefficients(_: Evidence) -> Record:
    mean = sympy.expand(WAVE.cosine_coefficient(0))
    yield expression("$a_0$", mean, MEAN, form=integral_form("a_0", ""))
    for n, symbol in enumerate(COSINES, start=1):
        form, derived = integral_form("a_n", r" \cos(n\omega t)"), sympy.expand(WAVE.cosine_coefficient(n))
        yield expression(f"$a_n$ for $n = {n}$", derived, symbol, form=form, item="eq-2.29, a_n")
    for n, symbol in enumerate(SINES, start=1):
        form, derived = integral_form("b_n", r" \sin(n\omega t)"), sympy.expand(WAVE.sine_coefficient(n))
        yield expression(f"$b_n$ for $n = {n}$", derived, symbol, form=form, item="eq-2.29, b_n")
    yield text("The printed integrals, over a signal of two harmonics, give back each of its coefficients.")


def integral_form(name: str, weight: str) -> str:
    """Return TeX of an integral of Fourier as printed: what it gives, and the weight of y."""
    return rf"{name} = \frac{{1}}{{\pi}} \int_{{-\pi}}^{{\pi}} y(t){weight} \,d(\omega t)"


@claim("eq-2.30", source=SOURCE, lines=(383, 383), paragraph=5)
def fundamental_coefficients(_: Evidence) -> Record:
    cosine, sine = (sympy.expand(each) for each in (WAVE.cosine_coefficient(), WAVE.sine_coefficient()))
    yield expression("$a_1$", cosine, COSINES[0], form=integral_form("a_1", r" \cos(\omega t)"))
    yield expression("$b_1$", sine, SINES[0], form=integral_form("b_1", r" \sin(\omega t)"))
    yield text("These are the integrals of [equation 2.29](#eq-2.29) for $n = 1$.")


@claim("eq-2.31", source=SOURCE, lines=(387, 387), paragraph=6)
def first_harmonic(_: Evidence) -> Record:
    printed = total(COSINE_PART * sympy.cos(THETA), SINE_PART * sympy.sin(THETA))
    shifted = sympy.simplify(sympy.expand_trig(MODULUS * sympy.sin(THETA + ANGLE)))
    form = r"y(t) \approx a_1\cos(\omega t) + b_1\sin(\omega t) = M\sin(\omega t + \phi)"
    yield expression(r"with $M$ and $\phi$ of equations 2.32 and 2.33", printed, shifted, form=form)
    yield text("The sum of cosine and sine is one sine with the printed magnitude and phase, for $b_1 > 0$.")


@claim("eq-2.32", source=SOURCE, lines=(391, 391), paragraph=7)
def magnitude(_: Evidence) -> Record:
    yield expression("", MODULUS, sympy.Abs(SINE_PART + sympy.I * COSINE_PART), "M")
    yield text("It is the magnitude of $b_1 + ja_1$.")


@claim("eq-2.33", source=SOURCE, lines=(395, 395), paragraph=8)
def phase(_: Evidence) -> Record:
    yield expression("for $b_1 > 0$", ANGLE, sympy.atan2(COSINE_PART, SINE_PART), r"\phi")
    yield text("""
        It is the angle of $b_1 + ja_1$ as long as $b_1 > 0$, as for every backlash. The arctangent of a ratio
        loses the quadrant: for $b_1 < 0$ it is off by half a turn. Coulomb friction driven by a displacement
        has $b_1 = 0$.
    """)


@claim(
    "eq-2.34",
    source=SOURCE,
    impact=Impact.NOTATION,
    severity=Severity.SLIP,
    certainty=Certainty.READING,
    lines=(399, 399),
    paragraph=9,
)
def ratio_of_signals(_: Evidence) -> Record:
    modulus, angle = sympy.symbols("M phi", positive=True)
    printed = modulus * sympy.sin(omega * t + angle) / (A * sympy.sin(omega * t))
    derived = modulus / A * sympy.exp(sympy.I * angle)
    phasors = modulus * sympy.exp(sympy.I * (omega * t + angle)) / (A * sympy.exp(sympy.I * omega * t))
    values = {modulus: 1, A: 1, angle: sympy.pi / 3, omega: 1}
    instants = (sympy.Rational(1, 2), sympy.Integer(1))
    early, late = (float(printed.subs(values).subs(t, instant)) for instant in instants)
    yield expression(
        "",
        printed,
        derived,
        "N",
        second=same("the ratio of the phasors", sympy.simplify(phasors), derived),
        slip=made_here("the ratio of the signals is taken, not that of their phasors", printed),
        printed_form=r"N(A, \omega) = \frac{y(t)}{u(t)} = \frac{M\sin(\omega t + \phi)}{A\sin(\omega t)}",
        derived_form=r"N(A, \omega) = \frac{M}{A} e^{j\phi}",
    )
    yield text(r"""
        Read as it stands, the ratio of two sines depends on time: for $\phi = [[ phase | latex ]]$ it is
        [[ early | f2 ]] at $\omega t = [[ first | latex ]]$ and [[ late | f2 ]] at $\omega t =
        [[ second | latex ]]$. The describing function is the ratio of the phasors, a complex constant. Read
        as phasors, as the next line of the thesis does, the equation is right.

        None: [equation 2.35](#eq-2.35) takes the ratio of the phasors.
    """).given(phase=values[angle], early=early, late=late, first=instants[0], second=instants[1])


@claim("eq-2.35", source=SOURCE, lines=(403, 403), paragraph=10)
def describing_function(_: Evidence) -> Record:
    printed = (SINE_PART + sympy.I * COSINE_PART) / A
    derived = MODULUS / A * sympy.exp(sympy.I * ANGLE)
    point = {A: 2, COSINE_PART: -0.7, SINE_PART: 1.3}
    second = close("numbers", complex(printed.subs(point)), complex(derived.subs(point)))
    ratio = r"\frac{Me^{j(\omega t + \phi)}}{Ae^{j\omega t}}"
    form = rf"N(A, \omega) = {ratio} = \frac{{M}}{{A}} e^{{j\phi}} = \frac{{1}}{{A}} (b_1 + ja_1)"
    yield expression("", printed, sympy.simplify(sympy.expand_complex(derived)), second=second, form=form)
    yield text("""
        It is the output's phasor over the input's, where $a$ goes with the cosine and $b$ with the sine.
    """)
