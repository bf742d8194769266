"""Claims of appendix A.9: the block of inertia-controlled backlash over time (Listing A.8)."""

from __future__ import annotations

import math

import numpy as np
import sympy
from numpy.typing import NDArray
from scipy.optimize import brentq

from derivations.backlash import CONTACT, GAP, inertia_contact_ratio, inertia_waveform
from derivations.symbols import A
from derivations.waveform import THETA
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.comparisons.printed import product, total
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from trimmer.elements.inertia_backlash import InertiaBacklash

SOURCE = "derivations/backlash.py"
b = sympy.Symbol("b", positive=True)
DRIVE_AMPLITUDE, DRIVE_GAP, DRIVE_OMEGA = 0.0015, 0.0004, 200 * math.pi
PERIOD = 2 * math.pi / DRIVE_OMEGA
PRINTED_CONTACT, PRINTED_OFFSET = "0.00190662", "0.0049"
PHASES = (0.5, 2.0, 4.0, 5.5)
"""A phase inside of each piece, rad."""
Reals = NDArray[np.float64]


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_inertia(),)


def inertia_block(pin: Reals, time: Reals, gap: float = DRIVE_GAP) -> Reals:
    """Return what Listing A.8 returns for its arguments u and t, with another gap in its second line."""
    t = np.mod(time, PERIOD)
    contact, offset = float(PRINTED_CONTACT), float(PRINTED_OFFSET)
    flight = DRIVE_OMEGA * DRIVE_AMPLITUDE * t
    second = PERIOD / 2
    return np.asarray(
        (flight - gap / 2) * ((t >= 0) & (t < contact))
        + (pin + gap / 2) * ((t > contact) & (t < second))
        + (-flight + offset) * ((t >= second) & (t < second + contact))
        + (pin - gap / 2) * ((t > second + contact) & (t < PERIOD))
    )


def _inertia() -> Claim:
    return Claim(
        id="lst-A.8",
        parts=(*_pieces(), *_constants(), _continuity(), _instants(), _own_input()),
        explanation=(
            "The four pieces are those of the derived waveform, and the contact time is right to every "
            f"digit. The offset of line 12 is cut to two digits, which makes the output jump by "
            f"{1e6 * -_jump():.1f} µm twice a period. Flight is written as a function of time for one "
            "amplitude, frequency and phase, so the block is right for that one input only; at the instants "
            "of contact no line applies and it returns zero."
        ),
        consequence=(
            "It can stand behind the drive of 100 Hz and 1.5 mm in open loop, as in figures 4.2 and 5.14. In "
            "a closed loop, and at the 109.845 Hz that the text gives, its output means nothing."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _pieces() -> tuple[Part, ...]:
    first, second, third, fourth = inertia_waveform(b).segments
    offset = sympy.pi * A + b / 2
    sine = A * sympy.sin(THETA)
    rows = (
        ("line 10", total(A * THETA, -b / 2), first),
        ("line 11", total(sine, b / 2), second),
        ("line 12, with its constant as $\\pi A + b/2$", total(product(-A, THETA), offset), third),
        ("line 13", total(sine, -b / 2), fourth),
    )
    return tuple(
        Part(
            f"{label}, $\\theta = \\omega t$",
            SameExpression(value, segment.value, left=sympy.Symbol("y")),
            Confirmation("the numeric element at a phase inside", _by_element(segment.value, phase)),
        )
        for (label, value, segment), phase in zip(rows, PHASES, strict=True)
    )


def _by_element(piece: sympy.Expr, phase: float) -> CloseNumbers:
    """Return the numeric element's output at a phase (rad) beside a piece of the waveform there."""
    wave = InertiaBacklash(DRIVE_GAP).waveform(np.array([phase]), DRIVE_AMPLITUDE, DRIVE_OMEGA)
    value = piece.subs({THETA: phase, A: DRIVE_AMPLITUDE, b: DRIVE_GAP})
    return CloseNumbers(float(wave[0]), float(value))


def contact_time() -> float:
    """Return the time from the pin's largest velocity to the impact, for the constants of Listing A.8, s."""
    ratio = sympy.lambdify(CONTACT, inertia_contact_ratio() - DRIVE_GAP / DRIVE_AMPLITUDE)
    return float(brentq(ratio, 0.1, math.pi, xtol=1e-14)) / DRIVE_OMEGA


def _constants() -> tuple[Part, ...]:
    flight = DRIVE_AMPLITUDE * DRIVE_OMEGA * contact_time() - DRIVE_GAP / 2
    wall = DRIVE_AMPLITUDE * math.sin(DRIVE_OMEGA * contact_time()) + DRIVE_GAP / 2
    third = inertia_waveform().segments[2].value
    offset = sympy.expand(third).subs(THETA, 0).subs({A: DRIVE_AMPLITUDE, GAP: DRIVE_GAP})
    return (
        Part(
            "line 8, phi, the time of contact",
            PrintedDigits(PRINTED_CONTACT, contact_time(), "s"),
            Confirmation("flight and wall at that time", CloseNumbers(flight, wall)),
        ),
        Part(
            "line 12, the constant $\\pi A + b/2$",
            PrintedDigits(PRINTED_OFFSET, float(offset), "m"),
            Confirmation(
                "its value $b/2$ above $A \\theta$ half a period on",
                CloseNumbers(DRIVE_GAP / 2 + DRIVE_AMPLITUDE * DRIVE_OMEGA * PERIOD / 2, float(offset)),
            ),
        ),
    )


def _jump() -> float:
    """Return by how much the output jumps at half a period, m."""
    instants = np.array([PERIOD / 2 * (1 - 1e-12), PERIOD / 2])
    before, after = inertia_block(DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * instants), instants)
    return float(after - before)


def _continuity() -> Part:
    return Part(
        "output over time",
        Assertion(
            statement="the output is continuous",
            derived=abs(_jump()) < 1e-9 * DRIVE_GAP,
            evidence=(
                f"at half a period it jumps by {1e6 * _jump():.1f} µm, "
                f"{100 * abs(_jump()) / DRIVE_GAP:.1f} % of the gap, because of the rounded constant"
            ),
            method="the listing, repeated line by line",
        ),
        Confirmation(
            "the printed constant less $\\pi A + b/2$",
            CloseNumbers(float(PRINTED_OFFSET) - math.pi * DRIVE_AMPLITUDE - DRIVE_GAP / 2, _jump(), 1e-6),
        ),
    )


def _instants() -> Part:
    instant = np.array([float(PRINTED_CONTACT)])
    beside = instant + np.array([-1e-9, 1e-9])
    (output,) = inertia_block(DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * instant), instant)
    return Part(
        "conditions of lines 10 to 13",
        Assertion(
            statement="every instant belongs to one of the pieces",
            derived=bool(abs(output) > DRIVE_AMPLITUDE / 2),
            evidence=(
                f"at $t$ = {PRINTED_CONTACT} s, where the pin is at "
                f"{1e3 * DRIVE_AMPLITUDE * math.sin(DRIVE_OMEGA * instant[0]):.2f} mm, the output is "
                f"{output:.0f}: two conditions ask for more and for less, none for equal"
            ),
            method="the listing, repeated line by line",
        ),
        second_way(
            "a nanosecond before and after, where the output is that of flight and of contact",
            min(inertia_block(np.asarray(DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * beside)), beside)) > 0,
        ),
    )


def _own_input() -> Part:
    early = np.array([PERIOD / 8])
    outputs = [float(inertia_block(np.array([pin]), early)[0]) for pin in (0.0, DRIVE_AMPLITUDE)]
    return Part(
        "input",
        Assertion(
            statement="the block takes the input wave from its argument",
            derived=outputs[0] != outputs[1],
            evidence=(
                "in lines 10 and 12 the output is a function of time alone; an eighth of a period after its "
                f"start it is {1e3 * outputs[0]:.3f} mm wherever the pin is"
            ),
            method="the listing, repeated line by line, for two inputs",
        ),
        Confirmation(
            "line 10 by itself, $A\\omega t - b/2$",
            CloseNumbers(DRIVE_AMPLITUDE * math.pi / 4 - DRIVE_GAP / 2, outputs[0]),
        ),
    )
