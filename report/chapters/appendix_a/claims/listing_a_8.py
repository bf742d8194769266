"""Claims of appendix A.9 on the constants and the frequency of Listing A.8."""

from __future__ import annotations

import math

import numpy as np
import sympy

from derivations.backlash import inertia_waveform
from derivations.symbols import A
from derivations.waveform import THETA
from report.chapters.appendix_a.claims.time_domain import (
    DRIVE_AMPLITUDE,
    DRIVE_GAP,
    DRIVE_OMEGA,
    PHASES,
    PRINTED_CONTACT,
    PRINTED_OFFSET,
    b,
    contact_time,
    inertia_block,
)
from report.claim import Claim, Confirmation, Impact, Part, Slip, Verdict
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product, total
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from trimmer.elements.inertia_backlash import InertiaBacklash

SOURCE = "trimmer/elements/inertia_backlash.py"
IN_TEXT = "109.845"
TURN = 2 * math.pi
PIECES = ("first", "second", "third", "fourth")
EQUATION = (
    total(A * THETA, -b / 2),
    total(A * sympy.sin(THETA), b / 2),
    product(-A, THETA - sympy.pi),
    total(A * sympy.sin(THETA), -b / 2),
)
"""Right sides of equation 2.42."""
ROUNDED_CONSTANT = 0.02
"""Share by which the two digits of line 12's constant may move the output at that phase."""
CLOSE = 0.01
"""Share of the gap by which the block may differ from the waveform that it stands for."""
PERIODS, POINTS = 20, 4000
"""Periods, and points of each, over which block and waveform are compared."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_constants(), _equation(), _frequency())


def _equation() -> Claim:
    """The listing's pieces are those of the derived waveform, see Listing A.8."""
    pieces = [segment.value for segment in inertia_waveform(b).segments]
    return Claim(
        id="txt-A.9-equation",
        parts=tuple(
            Part(
                f"line {line} against the {name} piece, $\\theta = \\omega t$",
                SameExpression(printed, piece, left="y"),
                Confirmation("the listing, repeated, inside of the piece", _as_listed(piece, phase)),
                Slip("equation 2.42 lacks the offset b/2", piece - b / 2, Verdict.ERRATUM),
            )
            for line, name, printed, piece, phase in zip(
                range(10, 14), PIECES, EQUATION, pieces, PHASES, strict=True
            )
        ),
        explanation=(
            "The text says that the code gives equation 2.42. Three of its pieces do; line 12 contains the "
            "offset $b/2$ that the equation has lost, so on the way back the code lies half a gap above it. "
            "The code is right, up to the digits of its constant."
        ),
        consequence=(
            "Whoever writes the block anew from the equation gets an output that jumps by half a gap, 0.2 mm "
            "here, twice a period."
        ),
        impact=Impact.LOCAL,
        source="derivations/backlash.py",
    )


def _as_listed(piece: sympy.Expr, phase: float) -> CloseNumbers:
    """Return the listing's output at a phase (rad) beside a piece there; its constant has two digits."""
    time = np.array([phase / DRIVE_OMEGA])
    (listed,) = inertia_block(DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * time), time)
    value = piece.subs({THETA: phase, A: DRIVE_AMPLITUDE, b: DRIVE_GAP})
    return CloseNumbers(float(listed), float(value), ROUNDED_CONSTANT)


def contact_angle() -> float:
    """Return the contact angle by bisection of b/A = phi - sin(phi), rad."""
    low, high = 0.0, math.pi
    for _ in range(60):
        middle = (low + high) / 2
        ratio = middle - math.sin(middle)
        low, high = (middle, high) if ratio < DRIVE_GAP / DRIVE_AMPLITUDE else (low, middle)
    return low


def difference_from_waveform(frequency: float, gap: float = DRIVE_GAP) -> float:
    """Return the largest difference of the listing's output and the right one, over the gap.

    Args:
        frequency: Of the block's input A sin(omega t), Hz; the listing has its own in its lines 4 to 6.
        gap: m.
    """
    times = np.asarray((np.arange(PERIODS * POINTS) + 0.5) / (POINTS * frequency), dtype=np.float64)
    omega = TURN * frequency
    right = InertiaBacklash(gap).waveform(omega * times, DRIVE_AMPLITUDE, omega)
    listed = inertia_block(np.asarray(DRIVE_AMPLITUDE * np.sin(omega * times)), times, gap)
    return float(np.abs(listed - right).max()) / gap


def _constants() -> Claim:
    angle = contact_angle()
    offset = math.pi * DRIVE_AMPLITUDE + DRIVE_GAP / 2
    wave = InertiaBacklash(DRIVE_GAP).waveform(np.array([math.pi + angle / 2]), DRIVE_AMPLITUDE, DRIVE_OMEGA)
    return Claim(
        id="txt-A.9-constants",
        parts=(
            Part(
                "`phi`, the time of contact",
                PrintedDigits(PRINTED_CONTACT, contact_time(), "s"),
                Confirmation("bisection", CloseNumbers(angle / DRIVE_OMEGA, contact_time(), 1e-12)),
            ),
            Part(
                "the constant of line 12, $\\pi A + b/2$",
                PrintedDigits(PRINTED_OFFSET, offset, "m"),
                Confirmation(
                    "the waveform half a flight after half a period",
                    CloseNumbers(float(wave[0]) + DRIVE_AMPLITUDE * (math.pi + angle / 2), offset, 1e-12),
                ),
            ),
        ),
        explanation=(
            f"Both are right to their digits, for 100 Hz: the contact angle is {angle:.5f} rad, and `phi` is "
            "that angle over $\\omega$, in seconds. Two digits are few for the second one: "
            f"{1e3 * offset:.4f} mm is meant, and the {1e6 * (offset - float(PRINTED_OFFSET)):.1f} µm that "
            "are missing make half of each period lower by "
            f"{100 * (offset - float(PRINTED_OFFSET)) / DRIVE_GAP:.0f} % of the gap while the bridge flies, "
            "so the output holds even harmonics that backlash cannot make."
        ),
        source=SOURCE,
    )


def _frequency() -> Claim:
    angle = contact_angle()
    belonging = angle / (TURN * float(PRINTED_CONTACT))
    instants = (0.5 + np.array([0.0, TURN])) / (TURN * float(IN_TEXT))
    earlier, later = inertia_block(np.full(2, DRIVE_AMPLITUDE * math.sin(0.5)), instants)
    own, other = (difference_from_waveform(each) for each in (DRIVE_OMEGA / TURN, float(IN_TEXT)))
    return Claim(
        id="txt-A.9-frequency",
        parts=(
            Part(
                "frequency to which the contact time of line 8 belongs",
                PrintedDigits(IN_TEXT, belonging, "Hz"),
                Confirmation("line 5 of the listing", CloseNumbers(DRIVE_OMEGA / TURN, belonging, 1e-5)),
            ),
            Part(
                f"the listing with an input of {IN_TEXT} Hz",
                Assertion(
                    statement="it gives the waveform of inertia-controlled backlash",
                    derived=other < CLOSE,
                    evidence=(
                        f"within {PERIODS} periods it is off by {other:.1f} gaps; with 100 Hz by {own:.3f} "
                        "gaps"
                    ),
                    method="the listing, repeated line by line, beside the derived waveform",
                ),
                second_way(
                    "its output a whole period of that input later, which is another one",
                    abs(later - earlier) > CLOSE * DRIVE_GAP,
                ),
            ),
        ),
        explanation=(
            "Contact time and period of the listing are those of 100 Hz. With the text's frequency the "
            "pieces run at 100 Hz while the input does not, so the output is periodic with neither and holds "
            "sums and differences of both; the contact time would have to be "
            f"{angle / (TURN * float(IN_TEXT)):.7f} s. Table 3.1 has 109.945 Hz for the same drive."
        ),
        consequence="What was drawn with the listing was drawn for 100 Hz.",
        impact=Impact.LOCAL,
        source=SOURCE,
    )
