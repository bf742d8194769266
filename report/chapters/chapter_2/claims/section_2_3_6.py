"""Claims of section 2.3.6 and figures 2.13 and 2.14: harmonic balance solved, and its stable solutions."""

import math

import control
import numpy as np
import sympy

from derivations import assumed
from report.judging.claim import ClaimPart
from report.judging.comparisons.digits import CloseNumbers
from report.judging.comparisons.printed import product, total
from report.judging.parts import assertion, close, digits, equal, expression, made_here, part
from report.judging.record import Record, claim, text
from report.judging.shown import Words
from report.judging.text import one_line
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent.loci import decays, feedback_poles
from report.numbers.independent.symbolic import first_root
from report.numbers.listed_functions import friction_listing
from report.numbers.textbook_loops import (
    backlash_history,
    backlash_loop,
    encirclements_of,
    graphical_intersections,
    growing_poles,
    relay_loop,
)
from trimmer import FrictionBacklash, response_at

REAL_N, IMAGINARY_N, REAL_G, IMAGINARY_G = assumed.real("N_r N_i G_r G_i")
LOOP = sympy.expand((REAL_N + sympy.I * IMAGINARY_N) * (REAL_G + sympy.I * IMAGINARY_G))
POINT = {REAL_N: 0.3, IMAGINARY_N: -1.7, REAL_G: 2.1, IMAGINARY_G: 0.9}
AT_POINT = complex(POINT[REAL_N], POINT[IMAGINARY_N]) * complex(POINT[REAL_G], POINT[IMAGINARY_G])
REAL_FORM = one_line(
    r"""
    \mathrm{Re}(N(A, \omega))\mathrm{Re}(G(j, \omega)) - \mathrm{Im}(N(A, \omega))\mathrm{Im}(G(j, \omega))
    """
)
"""The left side of equation 2.53 as printed."""
EXAMPLE = "$7/(s + 1)^3$ with friction-controlled backlash"
STEP = 1.02  # Factor between the amplitude of a limit cycle and those of the operating points beside it
DRAWN = 1e-5  # Relative difference allowed between a number read from 400 drawn points and the solution
SETTLED = 0.01
"""Relative difference allowed between a simulated and a predicted amplitude: the harmonics' share."""


@claim("eq-2.53")
def real_part(_: Evidence) -> Record:
    printed = total(product(REAL_N, REAL_G), product(-1, IMAGINARY_N, IMAGINARY_G))
    derived = sympy.re(LOOP)
    second = close("complex numbers", AT_POINT.real, complex(derived.subs(POINT)))
    yield expression("", printed, derived, second=second, form=f"{REAL_FORM} = -1")
    yield text(r"It is the real part of $NG = -1$. For $G(j\omega)$ the line writes $G(j, \omega)$.")


def imaginary_form(first: str) -> str:
    """Return equation 2.54 with the real or the imaginary part of N in its first product."""
    gain, linear = r"(N(A, \omega))", r"(G(j, \omega))"
    products = (
        rf"\mathrm{{{of_gain}}}{gain}\mathrm{{{of_linear}}}{linear}"
        for of_gain, of_linear in ((first, "Im"), ("Im", "Re"))
    )
    return " + ".join(products) + " = 0"


@claim("eq-2.54")
def imaginary_part(_: Evidence) -> Record:
    printed = total(product(IMAGINARY_N, IMAGINARY_G), product(IMAGINARY_N, REAL_G))
    derived = sympy.im(LOOP)
    slip = "the first factor is the imaginary part of N instead of the real one"
    slipped = derived - REAL_N * IMAGINARY_G + IMAGINARY_N * IMAGINARY_G
    yield expression(
        "",
        printed,
        derived,
        second=close("complex numbers", AT_POINT.imag, complex(derived.subs(POINT))),
        slip=made_here(slip, slipped),
        printed_form=imaginary_form("Im"),
        derived_form=imaginary_form("Re"),
    )
    yield text(r"""
        The first product has the imaginary part of $N$ where the real one belongs. As printed the amplitude
        drops out: for $\mathrm{Im}N \ne 0$ the line asks for $\mathrm{Re}G = -\mathrm{Im}G$, whatever the
        nonlinearity.

        None: [Listing A.9](#lst-A.9), lines 23 to 26, has the right form.
    """)


@claim("txt-2.3.6-roles")
def roles(known: Evidence) -> Record:
    yield expression(
        "a real $N$, as of a relay",
        IMAGINARY_G,
        sympy.im(LOOP.subs(IMAGINARY_N, 0)) / REAL_N,
        printed_form=Words("the imaginary equation, free of $N$"),
    )
    cycle = known.cycles.friction.stable
    linear = complex(response_at(known.numbers.displacement_only, cycle.omega))
    doubled = 2 * cycle.amplitude
    left = (complex(FrictionBacklash(1.0).describing_function(doubled)) * linear).imag
    by_listing = (friction_listing(doubled, 1.0) * linear).imag
    yield assertion(
        "a complex $N$, as of backlash",
        "the imaginary equation alone gives the frequency",
        abs(left) < 1e-9,
        rf"""
        at the predicted {cycle.frequency:.2f} Hz it is met at an amplitude of {cycle.amplitude:.2f} gaps; at
        twice that $\mathrm{{Im}}\,NG = {left:.4f}$
        """,
        method="the imaginary part at two amplitudes",
        certainty=Certainty.READING,
        second=close("the formula of Listing A.3", by_listing, left),
    )
    yield text(r"""
        For a real $N$ the imaginary equation is $\mathrm{Im}\,G = 0$ and gives the frequency, the real one
        the amplitude. Backlash has a complex $N$, and then amplitude and frequency stand in both equations.
        Read as two equations for two unknowns, as the sentence begins, the statement is right; read as one
        equation for each unknown it is not.

        None here: [Listing A.9](#lst-A.9) solves both together. [Chapter 7](#txt-7-input-frequency) takes the
        statement in the second way and is judged there.
    """)


def solved_for_plant(arguments: str) -> ClaimPart:
    """Return the part on the condition of harmonic balance solved for G, with the arguments of N."""
    linear, nonlinear = sympy.symbols("G N")
    form = rf"G(j\omega) = -\frac{{1}}{{N({arguments})}}"
    return expression("", -1 / nonlinear, first_root(1 + nonlinear * linear, linear), form=form)


@claim("eq-2.55")
def family_of_curves(_: Evidence) -> Record:
    yield solved_for_plant(r"A, \omega")
    yield text("""
        It is the condition of harmonic balance, solved for $G$. For a describing function of two variables
        the right side is a family of curves, one for each frequency. Only a point of equal frequency on both
        curves counts.
    """)


@claim("eq-2.56")
def one_curve(_: Evidence) -> Record:
    yield solved_for_plant("A")
    yield text("""
        As [equation 2.55](#eq-2.55): without dependence on frequency one curve serves all frequencies.
        Coulomb friction is of this kind for either choice of its input. The text below the equation plots
        $N(A)$; $-1/N(A)$ is meant.
    """)


@claim("fig-2.13")
def graphical_balance(_: Evidence) -> Record:
    loop = relay_loop()
    samples = np.linspace(1.0, 2.0, 400), np.linspace(0.1, 0.4, 400)
    ((frequency, amplitude),) = graphical_intersections(loop, *samples)
    (cycle,) = loop.limit_cycles()
    for what, curve, read, solved, exact in (
        ("frequency", "$G$", frequency, cycle.omega, sympy.sqrt(2)),
        ("amplitude", "$-1/N$", amplitude, cycle.amplitude, 2 / (3 * sympy.pi)),
    ):
        yield part(
            f"{what} at K",
            CloseNumbers(read, solved, DRAWN),
            second=close(f"the closed form ${sympy.latex(exact)}$", float(exact), solved),
            printed_form=Words(f"the {what} of the limit cycle is that of {curve} at the intersection"),
            derived_form=Words(f"read there {read:.6f}, solution of $1 + NG = 0$ {solved:.6f}"),
        )
    yield text("""
        The text names no loop, so $1/(s(s+1)(s+2))$ with an ideal relay is taken. Amplitude and frequency
        read at the intersection are those of the two equations, and of the closed form. Where $-1/N$ passes a
        point twice, as that of a relay with a dead zone does, the point stands for two amplitudes.
    """)


@claim("fig-2.14")
def two_limit_cycles(_: Evidence) -> Record:
    loop = backlash_loop()
    first, second = (cycle.amplitude for cycle in loop.limit_cycles())
    for point, printed, amplitude in (
        ("$L_1'$, amplitude above $A_1$", "1", STEP * first),
        ("$L_1''$, amplitude below $A_1$", "0", first / STEP),
        ("above $A_2$", "0", STEP * second),
        ("below $A_2$", "1", second / STEP),
    ):
        turns = encirclements_of(loop.plant, complex(loop.inverse_element(amplitude)))
        growing = equal("the poles of the loop with $N$ frozen", growing_poles(loop, amplitude), turns)
        yield digits(f"turns of $G$ about the operating point {point}", printed, turns, second=growing)
    _, from_between, _ = backlash_history().amplitudes[-1]
    means = "a simulation that starts just above the first and goes up to the second"
    yield assertion(
        "order of the amplitudes",
        r"$A_1 \le A_2$, the curve $-1/N$ entering at $L_1$ and leaving at $L_2$",
        first < second,
        f"{first:.3f} and {second:.3f} gaps",
        method="both solutions of harmonic balance",
        second=close(means, float(from_between), second, SETTLED),
    )
    yield text(f"""
        The text names no loop, so {EXAMPLE} is taken, which has two limit cycles. The operating points beside
        them are encircled or not as the text says, counted by turns of the locus and by growing poles. With
        another stable $G$ the same count decides, since along $-1/N$ it changes only where the curves cross.
    """)


@claim("txt-2.3.6-stability-rule")
def stability_rule(_: Evidence) -> Record:
    yield side_of_the_crossing()
    first, second = backlash_loop().limit_cycles()
    from_below, from_between, from_above = (float(each) for each in backlash_history().amplitudes[-1])
    yield assertion(
        "$L_1$",
        "the first limit cycle is unstable",
        not first.stable,
        f"""
        of {EXAMPLE}, started a tenth below {first.amplitude:.3f} gaps it ends at {from_below:.2f}, started a
        tenth above it at {from_between:.2f}
        """,
        method="Loeb's criterion",
        second=close("a simulation that leaves it for $L_2$", from_between, second.amplitude, SETTLED),
    )
    yield assertion(
        "$L_2$",
        "the second limit cycle is stable",
        second.stable,
        f"started above it, the same loop comes down to {from_above:.2f} gaps",
        method="Loeb's criterion",
        second=close("a simulation that comes down to it", from_above, second.amplitude, SETTLED),
    )
    yield text("""
        The rule is right where $G$ has no pole in the right half plane, as the trimmer has none. With rising
        amplitude $L_1$ goes to the encircled side and grows, $L_2$ goes to the other and shrinks back. That
        is Loeb's criterion, and a simulated loop does it. With poles of $G$ in the right half plane encircled
        points can be the stable ones.
    """)


def side_of_the_crossing() -> ClaimPart:
    """Return the part that proves the rule: Loeb's determinant tells the side to which -1/N crosses G.

    N and G and their slopes by amplitude and by frequency are any complex numbers with N G = -1.
    """
    real, imaginary = assumed.real("N_r p r"), assumed.real("N_i q s")
    gain, gain_slope, linear_slope = (x + sympy.I * y for x, y in zip(real, imaginary, strict=True))
    by_amplitude, by_frequency = -gain_slope / gain, gain * linear_slope
    loeb = sympy.im(sympy.expand_complex(sympy.conjugate(by_amplitude) * by_frequency))
    crossing = sympy.im(sympy.expand_complex(sympy.conjugate(linear_slope) * gain_slope / gain**2))
    loop = backlash_loop()
    cycle, around = loop.limit_cycles()[0], np.array([1 - 1e-6, 1 + 1e-6])
    # Small differences along the two curves give the angle between them.
    locus = complex(np.diff(response_at(loop.plant, cycle.omega * around))[0])
    inverse = complex(np.diff(loop.inverse_element(cycle.amplitude * around))[0])
    sine = abs((locus.conjugate() * inverse).imag) / abs(locus * inverse)
    means = "the angle of the crossing in the example"
    return expression(
        r"stable if $-1/N(A)$ crosses to the left of $G(j\omega)$ with rising amplitude",
        product(sympy.Abs(gain) ** 2, crossing),
        loeb,
        second=close(means, sine, math.sin(cycle.crossing_angle), 1e-6),
        printed_form=r"|N|^2\,\operatorname{Im}\left(\overline{G_\omega}\,(-1/N)_A\right) > 0",
        derived_form=r"X_A Y_\omega - X_\omega Y_A > 0",
    )


@claim("txt-2.3.6-nyquist-premise")
def nyquist_premise(_: Evidence) -> Record:
    loop, linear = backlash_loop(), control.tf([10], [1, 3, 3, 1])
    growing = growing_poles(loop, STEP * loop.limit_cycles()[0].amplitude)
    closed = feedback_poles(linear)
    in_right_half = int((closed.real > 0).sum())
    counterexamples = decays(loop.plant) and decays(linear) and growing > 0 and in_right_half > 0
    means = "turns of the locus about $-1$, one for each growing pole"
    yield assertion(
        "",
        "an open loop can be stable only if the closed loop is",
        not counterexamples,
        rf"""
        the open loop at $L_1'$ of figure 2.14 is stable, the closed one has {growing} growing pole; $10/(s +
        1)^3$ is stable, and with unit feedback has poles at ${closed.real.max():.3f} \pm
        {abs(closed.imag).max():.3f}j$
        """,
        method="counterexamples, by their poles",
        second=equal(means, encirclements_of(linear, -1.0), in_right_half),
    )
    yield text("""
        Neither loop has to be stable for the other to be. The Nyquist criterion takes the poles of the open
        loop as known and tells whether the closed one is stable. As the sentence stands, a stable $G$ would
        need a stable closed loop, and no limit cycle could be unstable.

        None: the rule for $L_1$ and $L_2$ that follows uses only that $G$ is stable.
    """)
