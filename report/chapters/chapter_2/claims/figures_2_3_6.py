"""Claims on graphical harmonic balance and on which limit cycle is stable (figures 2.13 and 2.14)."""

from __future__ import annotations

import math

import control
import numpy as np
import sympy

from report.claim import Claim, Confirmation, Impact, Mathematics, Part, Words
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product
from report.evidence import Evidence
from report.numbers.textbook_loops import (
    Loop,
    backlash_history,
    backlash_loop,
    encirclements_of,
    graphical_intersections,
    growing_poles,
    relay_loop,
)
from trimmer import frequency_response

SOURCE = "report/numbers/textbook_loops.py"
LOOP = "$7/(s + 1)^3$ with friction-controlled backlash"
STEP = 1.02
"""Factor between the amplitude of a limit cycle and those of the operating points beside it."""
DRAWN = 1e-5
"""Relative difference allowed between a number read from 400 drawn points and the solution."""
SETTLED = 0.01
"""Relative difference allowed between a simulated and a predicted amplitude: the harmonics' share."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_graphical_balance(), _two_limit_cycles(), _stability_rule(), _nyquist_premise())


def _graphical_balance() -> Claim:
    loop = relay_loop()
    samples = np.linspace(1.0, 2.0, 400), np.linspace(0.1, 0.4, 400)
    ((frequency, amplitude),) = graphical_intersections(loop, *samples)
    (cycle,) = loop.limit_cycles()
    return Claim(
        id="fig-2.13",
        parts=(
            _same_number("frequency at K, from $G$", frequency, cycle.omega, sympy.sqrt(2)),
            _same_number("amplitude at K, from $-1/N$", amplitude, cycle.amplitude, 2 / (3 * sympy.pi)),
        ),
        explanation=(
            "The figure names no loop; taken is $1/(s(s+1)(s+2))$ with an ideal relay. Reading amplitude and "
            "frequency at the intersection gives what solving the two equations gives, and what the closed "
            "form gives. Where $-1/N$ passes a point twice, as of a relay with a dead zone, a point of "
            "intersection stands for two amplitudes."
        ),
        source=SOURCE,
    )


def _same_number(label: str, read: float, solved: float, exact: sympy.Expr) -> Part:
    return Part(
        label,
        CloseNumbers(read, solved, DRAWN),
        Confirmation(f"the closed form ${sympy.latex(exact)}$", CloseNumbers(float(exact), solved)),
        printed_form=Words(f"read from the curves: {read:.6f}"),
        derived_form=Words(f"solution of $1 + NG = 0$: {solved:.6f}"),
    )


def _two_limit_cycles() -> Claim:
    loop = backlash_loop()
    first, second = loop.limit_cycles()
    _, from_between, _ = backlash_history().amplitudes[-1]
    return Claim(
        id="fig-2.14",
        parts=(
            _operating_point(loop, "$L_1'$, amplitude above $A_1$", "1", STEP * first.amplitude),
            _operating_point(loop, "$L_1''$, amplitude below $A_1$", "0", first.amplitude / STEP),
            _operating_point(loop, "above $A_2$", "0", STEP * second.amplitude),
            _operating_point(loop, "below $A_2$", "1", second.amplitude / STEP),
            Part(
                "order of the amplitudes",
                Assertion(
                    statement="$A_1 \\le A_2$, the curve $-1/N$ entering at $L_1$ and leaving at $L_2$",
                    derived=first.amplitude < second.amplitude,
                    evidence=f"{first.amplitude:.3f} and {second.amplitude:.3f} gaps",
                    method="both solutions of harmonic balance",
                ),
                Confirmation(
                    "a simulation that starts just above the first and goes up to the second",
                    CloseNumbers(float(from_between), second.amplitude, SETTLED),
                ),
            ),
        ),
        explanation=(
            f"The figure names no loop; taken is {LOOP}, which has two limit cycles. The operating points "
            "beside them are encircled or not as the text says, counted by turns of the locus and by growing "
            "poles. With another stable $G$ the same count decides, since along $-1/N$ it changes only where "
            "the curves cross; which of two limit cycles is the way in depends on where $-1/N$ begins."
        ),
        source=SOURCE,
    )


def _operating_point(loop: Loop, label: str, printed: str, amplitude: float) -> Part:
    turns = encirclements_of(loop.plant, complex(loop.inverse_element(amplitude)))
    return Part(
        f"turns of $G$ about the operating point {label}",
        PrintedDigits(printed, turns),
        Confirmation(
            "the poles of the loop with $N$ frozen", CloseNumbers(growing_poles(loop, amplitude), turns)
        ),
    )


def _stability_rule() -> Claim:
    loop = backlash_loop()
    return Claim(
        id="txt-2.3.6-stability-rule",
        parts=(_side_of_the_crossing(loop), *_stable_or_not(loop)),
        explanation=(
            "The rule is right where $G$ has no pole in the right half plane, as the trimmer's: with rising "
            "amplitude $L_1$ goes to the encircled side and grows, $L_2$ goes to the other and shrinks back. "
            "That is Loeb's criterion, and a simulated loop does it. With poles of $G$ in the right half "
            "plane, encircled points can be the stable ones."
        ),
        source="trimmer/balance/stability.py",
    )


def _stable_or_not(loop: Loop) -> tuple[Part, Part]:
    """Return the parts on both limit cycles: Loeb's criterion, and where a simulation goes."""
    first, second = loop.limit_cycles()
    from_below, from_between, from_above = backlash_history().amplitudes[-1]
    unstable = Assertion(
        statement="the first limit cycle is stable",
        derived=first.stable,
        asserted=False,
        evidence=(
            f"of {LOOP}, started a tenth below {first.amplitude:.3f} gaps it ends at {from_below:.2f}, "
            f"started a tenth above it at {from_between:.2f}"
        ),
        method="Loeb's criterion",
    )
    stable = Assertion(
        statement="the second limit cycle is stable",
        derived=second.stable,
        evidence=f"started above it, the same loop comes down to {from_above:.2f} gaps",
        method="Loeb's criterion",
    )
    leaving, arriving = (
        CloseNumbers(float(end), second.amplitude, SETTLED) for end in (from_between, from_above)
    )
    return (
        Part("$L_1$", unstable, Confirmation("a simulation that leaves it for $L_2$", leaving)),
        Part("$L_2$", stable, Confirmation("a simulation that comes down to it", arriving)),
    )


def _side_of_the_crossing(loop: Loop) -> Part:
    """Return the part that proves the rule: Loeb's determinant tells the side to which -1/N crosses G.

    N and G and their slopes by amplitude and by frequency are any complex numbers with N G = -1.
    """
    parts = sympy.symbols("N_r N_i p q r s", real=True)
    gain, gain_slope, linear_slope = (
        real + sympy.I * imaginary for real, imaginary in zip(parts[::2], parts[1::2], strict=True)
    )
    balance_by_amplitude, balance_by_frequency = -gain_slope / gain, gain * linear_slope
    loeb = sympy.im(sympy.expand_complex(sympy.conjugate(balance_by_amplitude) * balance_by_frequency))
    crossing = sympy.im(sympy.expand_complex(sympy.conjugate(linear_slope) * gain_slope / gain**2))
    cycle = loop.limit_cycles()[0]
    return Part(
        "stable if $-1/N(A)$ crosses to the left of $G(j\\omega)$ with rising amplitude",
        SameExpression(product(sympy.Abs(gain) ** 2, crossing), loeb),
        Confirmation(
            "the angle of the crossing in the example",
            CloseNumbers(_sine(loop), math.sin(cycle.crossing_angle), 1e-6),
        ),
        printed_form=Mathematics(r"|N|^2\,\operatorname{Im}\left(\overline{G_\omega}\,(-1/N)_A\right) > 0"),
        derived_form=Mathematics(r"X_A Y_\omega - X_\omega Y_A > 0"),
    )


def _sine(loop: Loop) -> float:
    """Return the sine of the angle between the two curves at the first limit cycle, by small differences."""
    cycle, small = loop.limit_cycles()[0], 1e-6
    around = np.array([1 - small, 1 + small])
    locus = complex(np.diff(frequency_response(loop.plant, cycle.omega * around))[0])
    inverse = complex(np.diff(loop.inverse_element(cycle.amplitude * around))[0])
    return abs((locus.conjugate() * inverse).imag) / abs(locus * inverse)


def _nyquist_premise() -> Claim:
    loop = backlash_loop()
    first, _ = loop.limit_cycles()
    growing = growing_poles(loop, STEP * first.amplitude)
    linear = control.tf([10], [1, 3, 3, 1])
    closed = control.feedback(linear, 1).poles()
    both_open_stable = bool((loop.plant.poles().real < 0).all() and (linear.poles().real < 0).all())
    return Claim(
        id="txt-2.3.6-nyquist-premise",
        parts=(
            Part(
                "",
                Assertion(
                    statement="an open loop can be stable only if the closed loop is",
                    derived=not (both_open_stable and growing > 0 and bool((closed.real > 0).any())),
                    evidence=(
                        f"the open loop at $L_1'$ of figure 2.14 is stable, the closed one has {growing} "
                        f"growing pole; $10/(s + 1)^3$ with unit feedback has poles at "
                        f"${closed.real.max():.3f} \\pm {abs(closed.imag).max():.3f}j$"
                    ),
                    method="counterexamples, by their poles",
                ),
                Confirmation(
                    "turns of the locus about $-1$, one for each growing pole",
                    CloseNumbers(encirclements_of(linear, -1.0), int((closed.real > 0).sum())),
                ),
            ),
        ),
        explanation=(
            "The sentence has the two loops exchanged: the Nyquist criterion takes the poles of the open "
            "loop as known and tells the stability of the closed one. Read as it stands it says that a "
            "stable $G$ asks for a stable loop; then no operating point could grow, and there were no "
            "unstable limit cycle."
        ),
        consequence=(
            "None: the rule for $L_1$ and $L_2$ that follows uses only that $G$ is stable. Section 5.1.2 "
            "draws its conclusion from the locus in the same wrong direction."
        ),
        impact=Impact.NOTATION,
        source=SOURCE,
    )
