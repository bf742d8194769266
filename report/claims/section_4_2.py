"""Claims of section 4.2 on the blocks of backlash in the simulation, and on γ and the separation angle."""

from __future__ import annotations

import math

import numpy as np
import sympy
from scipy.integrate import solve_ivp

from derivations.backlash import (
    CONTACT,
    GAMMA,
    inertia_contact_ratio,
    inertia_waveform,
    separation_angle,
)
from derivations.dimensions import FORCE, LENGTH, MASS, TIME, dimension_of
from derivations.symbols import DIMENSIONS, A, omega
from derivations.waveform import THETA
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.claims.appendix_a_time_domain import (
    DRIVE_AMPLITUDE,
    DRIVE_GAP,
    DRIVE_OMEGA,
    PERIOD,
    friction_block,
    friction_parts,
    inertia_block,
)
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.evidence import Evidence
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash

SOURCE = "derivations/backlash.py"
b = sympy.Symbol("b", positive=True)
LOAD_MASS, LOAD_DAMPING = sympy.symbols("M D", positive=True)
RATIO = 1 / 99
PRINTED_GAMMA = 634.6652
SAMPLES = 3997
"""Samples of a period, where a block is run over time."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_blocks(), _zero_gap(), _roles(), _gamma(), _separation())


def _blocks() -> Claim:
    return Claim(
        id="txt-4.2.1-block-equivalence",
        parts=(*friction_parts("Listing A.7, "), _on_a_sine()),
        explanation=(
            "The built-in block keeps its output while the input moves inside of the dead band and follows "
            "it at half of the band outside; the block itself was not at hand, python-control's was. Listing "
            "A.7 does the same for any input, so the two agree from equal starts, not on the sine of figure "
            "4.1 alone. The text says that the listing has equation 2.36; it has the right waveform, and the "
            "equation has two signs wrong."
        ),
        source=SOURCE,
    )


def _on_a_sine() -> Part:
    phase = 2 * math.pi * np.arange(2 * SAMPLES) / SAMPLES
    load, outputs = 0.0, []
    for pin in DRIVE_AMPLITUDE * np.sin(phase):
        load = friction_block(float(pin), DRIVE_GAP, load)
        outputs.append(load)
    waveform = FrictionBacklash(DRIVE_GAP).waveform(phase[SAMPLES:], DRIVE_AMPLITUDE)
    distance = float(np.abs(np.array(outputs[SAMPLES:]) - waveform).max())
    between_samples = DRIVE_AMPLITUDE * (1 - math.cos(math.pi / SAMPLES))
    return Part(
        "second period of a sine of 1.5 mm, $b$ = 0.4 mm",
        Assertion(
            statement="the output is that of backlash without inertia",
            derived=distance <= between_samples * (1 + 1e-6),
            evidence=(
                f"it is off by {1e9 * distance:.2f} nm at most, no more than what {SAMPLES} samples a period "
                f"may miss at the peak of the input, {1e9 * between_samples:.2f} nm"
            ),
            method="the listing, run over two periods, against the derived waveform",
        ),
    )


def _zero_gap() -> Claim:
    contact = inertia_waveform(b).segments[1].value
    grown = sympy.diff(inertia_contact_ratio(), CONTACT)
    phase = np.linspace(0, 2 * math.pi, 400, endpoint=False)
    pin = DRIVE_AMPLITUDE * np.sin(phase)
    left = float(np.abs(inertia_block(pin, phase / DRIVE_OMEGA, 0.0) - pin).max())
    return Claim(
        id="txt-4.2.2-zero-gap",
        parts=(
            Part(
                "flight",
                Assertion(
                    statement="without a gap there is no flight",
                    derived=inertia_contact_ratio().subs(CONTACT, 0) == 0
                    and bool(sympy.simplify(grown - 2 * sympy.sin(CONTACT / 2) ** 2) == 0),
                    evidence=(
                        "$b/A = \\phi - \\sin\\phi$ is zero for $\\phi = 0$ and rises from there on, since "
                        "its slope is $2\\sin^2(\\phi/2)$"
                    ),
                    method="the derived contact equation and its slope",
                ),
            ),
            Part(
                "contact, which is left",
                SameExpression(A * sympy.sin(THETA), contact.subs(b, 0), left=sympy.Symbol("y")),
                Confirmation(
                    "the element's waveform for a gap of a millionth of the amplitude",
                    CloseNumbers(_with_hardly_a_gap(), math.sin(2.0), 1e-5),
                ),
            ),
        ),
        explanation=(
            "Between walls a gap apart the load is never farther than $b/2$ from the pin, so without a gap "
            "the output is the input. Listing A.8 gives it only if the constants of lines 8 and 12 are "
            "computed again for each gap: with line 2 alone set to zero its output is off by "
            f"{1e3 * left:.2f} mm."
        ),
        source=SOURCE,
    )


def _with_hardly_a_gap() -> float:
    """Return the output over the amplitude at a phase of two radians."""
    wave = InertiaBacklash(1e-6 * DRIVE_AMPLITUDE).waveform(np.array([2.0]), DRIVE_AMPLITUDE, DRIVE_OMEGA)
    return float(wave[0]) / DRIVE_AMPLITUDE


def _roles() -> Claim:
    time = sympy.Symbol("t", positive=True)
    speed = sympy.Function("v")
    flight = sympy.Eq(LOAD_MASS * speed(time).diff(time) + LOAD_DAMPING * speed(time), 0)
    free = sympy.dsolve(flight, speed(time), ics={speed(0): 1}).rhs
    without_inertia = sympy.limit(free, LOAD_MASS, 0, "+")
    return Claim(
        id="txt-4.2.3-roles",
        parts=(
            Part(
                "$D$ as the amount of inertia, $M$ as the amount of friction",
                Assertion(
                    statement="the load keeps its speed longer with a larger $D$ or a smaller $M$",
                    derived=free.diff(LOAD_DAMPING).is_positive is True
                    and free.diff(LOAD_MASS).is_negative is True,
                    evidence=f"a load in free flight has $v/v_0 = {sympy.latex(free)}$",
                    method="sign of the derivatives of the solution of $M\\dot v + Dv = 0$",
                ),
            ),
            Part(
                "$D = 0$ is inertia-controlled: the load flies on with the speed it has",
                SameExpression(sympy.Integer(1), free.subs(LOAD_DAMPING, 0), left=r"\frac{v}{v_0}"),
            ),
            Part(
                "$M = 0$ is friction-controlled: the load stops at once",
                SameExpression(sympy.Integer(0), without_inertia, left=r"\frac{v}{v_0}"),
            ),
        ),
        explanation=(
            "$M$ is the inertia and $D$ the friction; the sentence has them exchanged. The next sentence, on "
            "what is left for $D = 0$ and for $M = 0$, is right and contradicts it."
        ),
        consequence="Read by the first sentence, an identified ratio $M/D$ would be taken for its inverse.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _gamma() -> Claim:
    gamma = RATIO * 2 * math.pi * 100
    units = DIMENSIONS | {LOAD_MASS: MASS, LOAD_DAMPING: FORCE * TIME / LENGTH}
    unit = dimension_of(LOAD_MASS / LOAD_DAMPING * omega, units)
    return Claim(
        id="txt-4.2.3-gamma",
        parts=(
            Part(
                "value",
                PrintedDigits("634.6652", gamma),
                Confirmation(
                    "the decay of a free load over a radian of the drive, integrated numerically",
                    CloseNumbers(-1 / math.log(_speed_left(RATIO, 1 / DRIVE_OMEGA)), gamma, 1e-9),
                ),
                Slip("1/0.99 is put in for 1/99", 2 * math.pi * 100 / 0.99, Verdict.ERRATUM),
            ),
            Part(
                "unit",
                Assertion(
                    statement="$\\gamma$ is a frequency, in hertz",
                    derived=unit == TIME**-1,
                    evidence=f"$M/D$ is a time and $\\omega$ its inverse: the unit is {unit}",
                    method="dimension check of equation 2.45",
                ),
            ),
        ),
        explanation=(
            f"With the ratio that is printed $\\gamma = 200\\pi/99 = {gamma:.4f}$, a pure number. The value "
            "that is printed is a hundred times as large and comes out with $M/D = 1/0.99$."
        ),
        consequence=(
            "The separation angle that follows belongs to a load that is nearly without friction; with 1/99 "
            "it is a hundred times larger."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _speed_left(ratio: float, time: float) -> float:
    """Return v/v0 of a free load after a time (s) for M/D (s), by numeric integration."""
    run = solve_ivp(lambda _, speed: -speed / ratio, (0, time), [1.0], rtol=1e-12, atol=1e-14)
    return float(run.y[0, -1])


def _separation() -> Claim:
    def angle(gamma: float) -> float:
        return float(separation_angle().subs(GAMMA, gamma))

    right = angle(RATIO * 2 * math.pi * 100)
    as_time = angle(PRINTED_GAMMA) * PERIOD / (2 * math.pi)
    return Claim(
        id="txt-4.2.3-separation-angle",
        parts=(
            Part(
                "arithmetic, from 634.6652",
                PrintedDigits("0.0016", angle(PRINTED_GAMMA), "rad"),
                Confirmation(
                    "the angle of $\\gamma + j$",
                    CloseNumbers(float(np.angle(PRINTED_GAMMA + 1j)), angle(PRINTED_GAMMA)),
                ),
            ),
            Part(
                "for $M/D = 1/99$ at 100 Hz",
                PrintedDigits("0.0016", right, "rad"),
                Confirmation(
                    "the angle of $\\gamma + j$",
                    CloseNumbers(float(np.angle(RATIO * DRIVE_OMEGA + 1j)), right),
                ),
                Slip("the value printed for gamma is used", angle(PRINTED_GAMMA), Verdict.EXPLAINED),
            ),
            Part(
                "unit",
                Assertion(
                    statement="0.0016 is a time, in seconds",
                    derived=PrintedDigits("0.0016", as_time).compare().agrees,
                    evidence=(
                        "the arctangent is an angle in radians; at 100 Hz that angle takes "
                        f"{1e6 * as_time:.2f} µs"
                    ),
                    method="angle over angular frequency",
                ),
            ),
        ),
        explanation=(
            f"The arctangent is right for the printed $\\gamma$. For the stated ratio it is {right:.4f} rad, "
            f"or {math.degrees(right):.2f} degrees, and it is an angle, not a time."
        ),
        consequence="None on later numbers: the section computes no waveform from it.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )
