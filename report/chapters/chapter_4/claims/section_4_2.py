"""Claims of sections 4.2.1 and 4.2.2 on the blocks of backlash in the simulation."""

from __future__ import annotations

import math

import control
import numpy as np
import sympy
from numpy.typing import NDArray
from scipy.optimize import brentq

from derivations.backlash import (
    CONTACT,
    inertia_contact_ratio,
    inertia_waveform,
)
from derivations.symbols import A
from derivations.waveform import THETA
from report.chapters.appendix_a.claims.friction_block import friction_block, friction_parts
from report.chapters.appendix_a.claims.time_domain import (
    DRIVE_AMPLITUDE,
    DRIVE_GAP,
    DRIVE_OMEGA,
    inertia_block,
)
from report.claim import Claim, Confirmation, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.expression import SameExpression
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash

Reals = NDArray[np.float64]
SOURCE = "derivations/backlash.py"
b = sympy.Symbol("b", positive=True)
SAMPLES = 3997
"""Samples of a period, where a block is run over time."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_blocks(), _zero_gap())


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
    pins = DRIVE_AMPLITUDE * np.sin(phase)
    for pin in pins:
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
        Confirmation(
            "python-control's backlash, run over the same two periods",
            CloseNumbers(1 + _run_in_the_library(pins)[SAMPLES], 1 + outputs[SAMPLES], 1e-12),
        ),
    )


def _run_in_the_library(pins: Reals) -> list[float]:
    """Return the output of python-control's backlash for each position of the pin, m."""
    block = control.friction_backlash_nonlinearity(DRIVE_GAP)
    return [float(block(pin)) for pin in pins]


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
                second_way(
                    "the root of the contact equation for a gap of $10^{-9}A$, a flight below 0.002 rad",
                    brentq(lambda angle: angle - math.sin(angle) - 1e-9, 0.0, 1.0) < 0.002,
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
