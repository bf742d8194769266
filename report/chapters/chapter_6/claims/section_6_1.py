"""Claim of section 6.1 on which kinds of backlash are piecewise linear."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.backlash import (
    GAMMA,
    free_flight,
    friction_waveform,
    general_waveform,
    inertia_waveform,
)
from derivations.symbols import A
from derivations.waveform import THETA, Waveform
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.evidence import Evidence
from trimmer.balance.leakage import harmonic_leakage
from trimmer.elements.element import Element
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash
from trimmer.elements.viscous_backlash import ViscousBacklash

GAP_HERE, TIME_CONSTANT = 0.2, 1.0
"""Gap over amplitude, and M/D in s, for which the numeric elements are looked at."""
BEFORE_TURNING = -0.1
"""Phase at which the load is in contact, before the pin moves fastest or the load is let go, rad."""
LET_GO, STEP = math.pi / 4 + 0.05, 0.1
"""Phase shortly after the load is let go, and step, rad."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    friction, inertia = _third_harmonics(evidence)
    return (
        Claim(
            id="txt-6.1-piecewise",
            parts=(
                *(
                    Part(
                        f"friction-controlled, {side} contact: slope of output against input",
                        SameExpression(sympy.Integer(1), slope, left=r"\frac{dy}{dx}"),
                    )
                    for side, slope in zip(
                        ("first", "second"), _slopes_in_contact(friction_waveform()), strict=True
                    )
                ),
                _not_linear_in_contact("inertia-controlled", inertia_waveform(), InertiaBacklash(GAP_HERE)),
                _not_linear_in_contact(
                    "viscous-controlled", general_waveform(), ViscousBacklash(GAP_HERE, TIME_CONSTANT)
                ),
                _not_linear_in_flight(),
            ),
            explanation=(
                "Friction-controlled backlash is piecewise linear, as the text says, and so are the other "
                "two: in contact the load follows the pin with slope one whatever it weighs, and only the "
                "flight differs. A describing function needs no piecewise linear element, only a periodic "
                "output; how good it is depends on the harmonics that come back, and these are alike: at the "
                f"stable limit cycle the third is {100 * inertia:.2f} % of the fundamental for inertia-, "
                f"{100 * friction:.2f} % for friction-controlled backlash."
            ),
            consequence="Linearity is no reason for preferring the friction-controlled kind.",
            impact=Impact.LOCAL,
            source="derivations/backlash.py",
        ),
    )


def _third_harmonics(evidence: Evidence) -> tuple[float, float]:
    """Return the third harmonic that comes back, over the fundamental, at both stable limit cycles."""
    system, cycles = evidence.numbers.displacement_only, evidence.cycles
    (friction,) = harmonic_leakage(system, FrictionBacklash(1.0), cycles.friction.stable, (3,))
    (inertia,) = harmonic_leakage(system, InertiaBacklash(1.0), cycles.inertia.stable, (3,))
    return friction, inertia


def _slopes_in_contact(wave: Waveform) -> list[sympy.Expr]:
    """Return dy/dx of the pieces in which the load follows the pin."""
    pin = A * sympy.sin(THETA)
    following = [
        segment.value for segment in wave.segments if sympy.expand(segment.value, trig=True).has(pin)
    ]
    return [sympy.simplify(value.diff(THETA) / pin.diff(THETA)) for value in following]


def _not_linear_in_contact(name: str, wave: Waveform, element: Element) -> Part:
    slopes = _slopes_in_contact(wave)
    return Part(
        f"{name}, in contact",
        Assertion(
            statement="output against input is not linear",
            derived=slopes != [1, 1],
            evidence=f"its slope is {' and '.join(map(str, slopes))} in the two contacts of a period",
            method="slopes of the derived waveform where it follows the pin",
        ),
        Confirmation(
            "the numeric element at two phases just before the pin turns round",
            CloseNumbers(_slope(element, BEFORE_TURNING), 1.0),
        ),
    )


def _slope(element: Element, phase: float) -> float:
    """Return the slope of output against input near a phase (rad), for a pin of amplitude and rad/s one."""
    phases = phase + np.array([0.0, 1e-3])
    return float(np.diff(element.waveform(phases, 1.0, 1.0))[0] / np.diff(np.sin(phases))[0])


def _not_linear_in_flight() -> Part:
    flight = free_flight()
    phases = LET_GO + STEP * np.arange(3)
    first, second = np.diff(ViscousBacklash(GAP_HERE, TIME_CONSTANT).waveform(phases, 1.0, 1.0))
    law = sympy.simplify(GAMMA * flight.diff(THETA, 2) + flight.diff(THETA))
    return Part(
        "in flight, with inertia and friction",
        Assertion(
            statement="the motion follows no linear law",
            derived=law != 0,
            evidence="the derived flight satisfies $M\\ddot y + D\\dot y = 0$ exactly",
            method="the derived flight put into that equation",
        ),
        Confirmation(
            "equal steps of the numeric element's flight, whose lengths fall as $e^{-Dt/M}$",
            CloseNumbers(float(second / first), math.exp(-STEP), 1e-9),
        ),
    )
