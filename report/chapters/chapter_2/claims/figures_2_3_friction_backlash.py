"""Claims on the figures of friction-controlled backlash (figures 2.7 to 2.9). Here b is half of the gap."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import sympy

from derivations.backlash import GAP, friction_waveform, limits
from derivations.symbols import A
from derivations.waveform import THETA, Segment, segment_integral
from report.claim import Claim, Confirmation, Mathematics, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product
from report.evidence import Evidence
from trimmer.elements.friction_backlash import FrictionBacklash

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Reals = NDArray[np.float64]

SOURCE = "derivations/backlash.py"
TRACING = "an input traced through the characteristic step by step"
b = sympy.Symbol("b", positive=True)
WAVEFORM = friction_waveform(2 * b)
RESTING, FALLING, RESTING_BELOW, RISING = WAVEFORM.segments
REACHED = sympy.Gt(A, b)
INPUT = A * sympy.sin(THETA)
HALF_GAP = 0.3
"""Half gap over amplitude of the traced input."""
STEPS = 20_000
"""Steps per period of the traced input."""
STEP_ERROR = 1e-3


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_motor_and_load(), _characteristic(), _input_characteristic_output())


@cache
def _traced() -> tuple[Reals, Reals]:
    """Trace a sine of amplitude one, from the middle of the gap: phases of its second period, and outputs.

    The output stays unless the input is half a gap away and pushes it.
    """
    phases = 2 * np.pi / STEPS * np.arange(1.25 * STEPS)
    output, outputs = 0.0, []
    for position in np.sin(phases).tolist():
        output = min(max(output, position - HALF_GAP), position + HALF_GAP)
        outputs.append(output)
    start = STEPS // 4
    return phases[start:], np.array(outputs[start:])


def _boundaries() -> Reals:
    """Return the phases at which the traced output comes to rest or starts to move, in one period."""
    phases, outputs = _traced()
    moving = np.diff(outputs) != 0
    return np.append(phases[0], phases[1:-1][moving[1:] != moving[:-1]])


def _motor_and_load() -> Claim:
    (least,) = sympy.solve(RESTING.value, A)
    largest_ratio = float(FrictionBacklash(2.0).domain())
    without_mass = limits(sympy.Integer(0)).flight
    delay = sympy.Symbol("tau", positive=True)
    return Claim(
        id="fig-2.7",
        parts=(
            Part(
                "amplitude up to which the load is not moved",
                SameExpression(b, least, left=A),
                Confirmation(
                    "the domain of the describing function, gap over amplitude below two",
                    CloseNumbers(float(least.subs(b, 1)), 2.0 / largest_ratio),
                ),
            ),
            Part(
                "velocity of a load without mass that is let go",
                SameExpression(sympy.Integer(0), without_mass.diff(delay), left=r"\dot y"),
                Confirmation(
                    "the place where the pin turns round",
                    SameExpression(without_mass.subs(GAP, 2 * b), RESTING.value),
                ),
            ),
        ),
        explanation=(
            "The bound is right with $b$ as half of the clearance, as this part of the text uses it; where "
            "$b$ is the whole of it, as from inertia-controlled backlash on, it is $b/2$. That such a load "
            "stays where it is let go is the limit $M/D \\to 0$ of the general one. Of the conditions that "
            "the text then gives for the other limit, $D = 0$ is meant: $M \\ne 0$ alone is also the general "
            "case. The drawing was not at hand; it is drawn again from the text."
        ),
        source=SOURCE,
    )


def _slope(segment: Segment) -> sympy.Expr:
    """Return dy/dx along a segment."""
    return sympy.cancel(segment.value.diff(THETA) / INPUT.diff(THETA))


def _input_at(phase: sympy.Expr) -> sympy.Expr:
    return sympy.simplify(INPUT.subs(THETA, phase))


def _characteristic() -> Claim:
    first_contact = sympy.solve(RISING.value.subs(INPUT, sympy.Symbol("x")), sympy.Symbol("x"))[0]
    width = _input_at(RESTING.start) - _input_at(FALLING.start)
    swept = sympy.Add(*(segment_integral(each, INPUT.diff(THETA)) for each in WAVEFORM.segments))
    heights = [segment.value.subs(THETA, segment.start) for segment in WAVEFORM.segments]
    return Claim(
        id="fig-2.8",
        parts=(
            Part("segment OA, its length", SameExpression(b, first_contact)),
            Part("segment AB, its slope", SameExpression(sympy.Integer(1), _slope(RISING))),
            Part("segment BC, its length", SameExpression(2 * b, width, assume=REACHED)),
            Part(
                "area that EBCD runs round counter-clockwise, $2b \\cdot 2(A - b)$",
                SameExpression(product(2 * b, 2 * (A - b)), sympy.simplify(-swept), assume=REACHED),
                Confirmation(
                    "the quadrature part of the describing function",
                    SameExpression(-sympy.pi * A * WAVEFORM.cosine_coefficient(), -swept),
                ),
            ),
            Part(
                "heights of B, C, D and E",
                Assertion(
                    statement="the heights of B, C, D and E depend on the amplitude",
                    derived=all(height.diff(A) != 0 for height in heights),
                    evidence=f"they are $\\pm({sympy.latex(heights[0])})$",
                    method="derivative of each height by the amplitude",
                ),
                Confirmation(TRACING, CloseNumbers(float(_traced()[1].max()), 1 - HALF_GAP, STEP_ERROR)),
            ),
            _two_outputs(),
        ),
        explanation=(
            "Each segment of the path follows from mechanics as the text describes it, with $b$ as half of "
            "the clearance. The two outputs for one input belong to one closed path; over all amplitudes "
            "every output between $x - b$ and $x + b$ is possible."
        ),
        source=SOURCE,
    )


def _two_outputs() -> Part:
    position = 0.2
    phases, outputs = _traced()
    passing = np.flatnonzero(np.diff(np.sign(np.sin(phases) - position)))
    traced = len({round(float(each), 2) for each in outputs[passing]})
    angle = np.arcsin(position)
    element = FrictionBacklash(2 * HALF_GAP)
    derived = len({round(float(each), 2) for each in element.waveform([angle, np.pi - angle], 1.0)})
    return Part(
        "outputs for one input, on one closed path",
        PrintedDigits("2", derived),
        Confirmation(TRACING, CloseNumbers(traced, derived)),
    )


def _input_characteristic_output() -> Claim:
    gamma = sympy.asin(1 - 2 * b / A)
    values = {A: 1, b: sympy.Rational(HALF_GAP).limit_denominator(10)}
    printed = (sympy.pi / 2, sympy.pi - gamma, 3 * sympy.pi / 2, 2 * sympy.pi - gamma)
    names = ("first", "second", "third", "fourth")
    boundaries = _boundaries()
    starts = tuple(
        Part(
            f"start of the {name} region",
            SameExpression(phase, segment.start, left=r"\omega t", assume=REACHED),
            Confirmation(TRACING, CloseNumbers(traced, float(segment.start.subs(values)), STEP_ERROR)),
        )
        for name, phase, segment, traced in zip(names, printed, WAVEFORM.segments, boundaries, strict=True)
    )
    form = Mathematics("k = 1")
    slopes = tuple(
        Part(
            f"slope of the {name} side",
            SameExpression(sympy.Integer(1), _slope(segment)),
            printed_form=form,
            derived_form=form,
        )
        for name, segment in (("falling", FALLING), ("rising", RISING))
    )
    apart = sympy.simplify(FALLING.value - RISING.value)
    return Claim(
        id="fig-2.9",
        parts=(*starts, *slopes, Part("gap to overcome", SameExpression(2 * b, apart))),
        explanation=(
            "Tracing the input through the characteristic gives an output of four regions that begin where "
            "the text says; the redrawn figure joins the points that belong together. What the text then "
            "reads off for the two resting regions has its signs exchanged: see equation 2.36."
        ),
        source=SOURCE,
    )
