"""Claims of section 6.1: which nonlinearities have a describing function, which are piecewise linear."""

import math

import numpy as np
import sympy

from derivations.elements import backlash
from derivations.elements.waveform import THETA, Segment, Waveform, describing_function
from derivations.symbols import A
from report.judging.parts import assertion, close, expression
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.evidence import Evidence
from report.numbers.independent import examples
from trimmer import FrictionBacklash, InertiaBacklash, ViscousBacklash, harmonic_leakage

GAP_HERE, TIME_CONSTANT = 0.2, 1.0
"""Gap over amplitude, and M/D in s, for which the numeric elements are looked at."""
IN_CONTACT = -0.1 + np.array([0.0, 1e-3])
"""Phases at which the load is in contact, before the pin moves fastest or the load is let go, rad."""
WELL_PREDICTED = 0.05
"""Share by which a predicted frequency may be off and still show that the method applies."""


@claim("txt-6.1-piecewise")
def piecewise_linear(known: Evidence) -> Record:
    for side, slope in zip(("first", "second"), slopes_in_contact(backlash.friction_waveform()), strict=True):
        label = f"friction-controlled, {side} contact: slope of output against input"
        item = "friction-controlled backlash is piecewise linear"
        yield expression(label, sympy.Integer(1), slope, r"\frac{dy}{dx}", item=item)
    viscous = ViscousBacklash(GAP_HERE, TIME_CONSTANT)
    for name, wave, element in (
        ("inertia-controlled", backlash.inertia_waveform(), InertiaBacklash(GAP_HERE)),
        ("viscous-controlled", backlash.general_waveform(), viscous),
    ):
        slopes = slopes_in_contact(wave)
        rise = np.diff(element.waveform(IN_CONTACT, 1.0, 1.0)) / np.diff(np.sin(IN_CONTACT))
        yield assertion(
            f"{name}, in contact",
            "output against input is not linear",
            slopes != [1, 1],
            f"its slope is {' and '.join(map(str, slopes))} in the two contacts of a period",
            method="slopes of the derived waveform where it follows the pin",
            second=close("the numeric element at two phases just before the pin turns round", rise[0], 1.0),
            item="inertia- and viscous-controlled backlash are not linear in contact",
            certainty=Certainty.READING,
        )
    system, cycles = known.numbers.displacement_only, known.cycles
    (friction,) = harmonic_leakage(system, FrictionBacklash(1.0), cycles.friction.stable, (3,))
    (inertia,) = harmonic_leakage(system, InertiaBacklash(1.0), cycles.inertia.stable, (3,))
    yield text(f"""
        The text finds friction-controlled backlash piecewise linear, and the other two not quite linear in
        contact. Read as it stands, this is wrong: in contact the load follows the pin with slope one,
        whatever it weighs. If contact was written for flight it is right: output against input is curved
        there. The text takes from it that the describing function applies less well. That depends on the
        harmonics that come back, and these are alike: at the stable limit cycle the third is
        {100 * inertia:.2f} % of the fundamental for inertia-, {100 * friction:.2f} % for friction-controlled
        backlash.

        Linearity is no reason for preferring the friction-controlled kind.
    """)


def slopes_in_contact(wave: Waveform) -> list[sympy.Expr]:
    """Return dy/dx of the pieces in which the load follows the pin."""
    pin = A * sympy.sin(THETA)
    values = [segment.value for segment in wave.segments]
    following = [value for value in values if sympy.expand(value, trig=True).has(pin)]
    return [sympy.simplify(value.diff(THETA) / pin.diff(THETA)) for value in following]


@claim("txt-6.1-hard-nonlinearities")
def hard_nonlinearities(_: Evidence) -> Record:
    period = Segment(sympy.Integer(0), 2 * sympy.pi, (A * sympy.sin(THETA)) ** 3)
    gain = describing_function(Waveform((period,)), A)
    at_one = float(gain.subs(A, 1))
    predicted, exact = math.sqrt(at_one), examples.cubic_frequency()
    yield assertion(
        "",
        "a describing function can be derived only for hard nonlinearities",
        abs(predicted / exact - 1) > WELL_PREDICTED,
        rf"""
        the smooth $y = x^3$ has $N = {sympy.latex(gain)}$; for $\ddot x + x^3 = 0$ it predicts
        {predicted:.4f} rad/s at $A = 1$, where {exact:.4f} rad/s is exact
        """,
        method="Fourier integral of a smooth odd nonlinearity",
        second=close("quadrature", examples.cubic_gain(), at_one),
    )
    yield text("""
        The derivation in section 2.3.3 asks for an output of the input's period; a corner or a jump does not
        enter. The harmonics of a smooth nonlinearity fall off faster with their number, so the method is no
        worse there.

        None for backlash. A refined model of the trimmer may treat smooth springs and friction that grows
        with speed in the same way.
    """)
