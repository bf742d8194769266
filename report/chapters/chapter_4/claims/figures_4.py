"""Claims on figures 4.1 to 4.3, the blocks of backlash under a sine."""

from __future__ import annotations

import math

import control
import numpy as np
from numpy.typing import NDArray

from derivations.backlash import CONTACT, inertia_contact_ratio
from report.chapters.appendix_a.claims.friction_block import friction_block
from report.chapters.appendix_a.claims.time_domain import (
    DRIVE_AMPLITUDE,
    DRIVE_GAP,
    DRIVE_OMEGA,
    PRINTED_OFFSET,
    inertia_block,
)
from report.claim import Claim, Confirmation, Part, Uncheckable, Words
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.printed import power_of
from report.evidence import Evidence
from trimmer.elements.friction_backlash import FrictionBacklash
from trimmer.elements.inertia_backlash import InertiaBacklash

Reals = NDArray[np.float64]

SAMPLES = 2003
"""Samples of a period, none of which is an instant at which Listing A.8 applies no line."""
ROUNDING = 1e-15
VISIBLE = 0.01
"""Share of the amplitude that a line in a figure hides."""
GAPS = (0.0, 2e-4, 4e-4, 8e-4, 16e-4)
"""Gaps of our figure 4.3, m; those of the thesis are not given."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_two_blocks(), _inertia_block(), _gaps())


def phases() -> Reals:
    """Return the phases of two periods of the pin, rad."""
    return 2 * math.pi * np.arange(2 * SAMPLES) / SAMPLES


def own_block() -> Reals:
    """Return the output of Listing A.7 for the sine of figure 4.1 from rest, m."""
    load, outputs = 0.0, []
    for pin in DRIVE_AMPLITUDE * np.sin(phases()):
        load = friction_block(float(pin), DRIVE_GAP, load)
        outputs.append(load)
    return np.array(outputs)


def built_in_block() -> Reals:
    """Return the output of python-control's backlash for the same sine from rest, m."""
    block = control.friction_backlash_nonlinearity(DRIVE_GAP)
    return np.array([block(float(pin)) for pin in DRIVE_AMPLITUDE * np.sin(phases())])


def listing_a8() -> Reals:
    """Return the output of Listing A.8 for its own drive, m."""
    pin = DRIVE_AMPLITUDE * np.sin(phases())
    return inertia_block(pin, phases() / DRIVE_OMEGA)


def exact_inertia(gap: float) -> Reals:
    """Return the derived waveform of a load without friction, m; the pin itself without gap."""
    if gap == 0:
        return DRIVE_AMPLITUDE * np.sin(phases())
    return InertiaBacklash(gap).waveform(phases(), DRIVE_AMPLITUDE)


def _two_blocks() -> Claim:
    distance = float(np.abs(own_block() - built_in_block()).max())
    settled = FrictionBacklash(DRIVE_GAP).waveform(phases()[SAMPLES:], DRIVE_AMPLITUDE)
    return Claim(
        id="fig-4.1",
        parts=(
            Part(
                "built-in and own block, $b$ = 0.0004 m",
                Assertion(
                    statement="the two outputs are the same",
                    derived=distance <= ROUNDING,
                    evidence=f"over two periods from rest they differ by {distance:.1g} m at most",
                    method="Listing A.7 and python-control's backlash, sample by sample, on a sine of 1.5 mm",
                ),
                Confirmation(
                    "the derived waveform in the second period",
                    CloseNumbers(float(np.ptp(own_block()[SAMPLES:])), float(np.ptp(settled)), 1e-5),
                ),
            ),
        ),
        explanation=(
            "The blocks agree from the start on, not only when settled; Simulink's own block is taken to be "
            "what its description says, which python-control's is too. Why they agree for any input is shown "
            "at Listing A.7."
        ),
        source="report/chapters/appendix_a/claims/time_domain.py",
    )


def _inertia_block() -> Claim:
    distance = float(np.abs(listing_a8() - exact_inertia(DRIVE_GAP)).max())
    return Claim(
        id="fig-4.2",
        parts=(
            Part(
                "output of Listing A.8 for its own drive",
                Assertion(
                    statement="it behaves as figure 2.10",
                    derived=distance < VISIBLE * DRIVE_AMPLITUDE,
                    evidence=(
                        f"it is off the derived waveform by {1e6 * distance:.1f} µm at most, "
                        f"{100 * distance / DRIVE_AMPLITUDE:.1f} % of the amplitude"
                    ),
                    method="the listing, repeated line by line, against the derived waveform",
                ),
                Confirmation(
                    "what the constant of line 12 lacks of $\\pi A + b/2$",
                    CloseNumbers(
                        math.pi * DRIVE_AMPLITUDE + DRIVE_GAP / 2 - float(PRINTED_OFFSET), distance, 1e-6
                    ),
                ),
            ),
        ),
        explanation=(
            "To the width of a line the figure is right. The deviation is the jump from the rounded constant "
            "in line 12 of Listing A.8. The block would show the same waveform for any other input, because "
            "its flight is a function of time alone."
        ),
        source="report/chapters/appendix_a/claims/time_domain.py",
    )


def _gaps() -> Claim:
    phase = 2 * math.pi * np.arange(SAMPLES) / SAMPLES
    small = InertiaBacklash(1e-9 * DRIVE_AMPLITUDE).waveform(phase, DRIVE_AMPLITUDE)
    distance = float(np.abs(small - DRIVE_AMPLITUDE * np.sin(phase)).max())
    gain = InertiaBacklash(1e-9 * DRIVE_AMPLITUDE).describing_function(DRIVE_AMPLITUDE)
    rises = [float(inertia_contact_ratio().subs(CONTACT, angle)) for angle in (0.0, 1.0, 2.0, 3.0)]
    return Claim(
        id="fig-4.3",
        parts=(
            Part(
                "$b$ = 0",
                Assertion(
                    statement="the output is the input",
                    derived=distance <= 1e-9 * DRIVE_AMPLITUDE and rises[0] == 0,
                    evidence=(
                        "the flight lasts for $\\phi$ with $b/A = \\phi - \\sin\\phi$, so it vanishes with "
                        "the gap; at $b = 10^{-9}A$ output and input differ by "
                        f"{power_of(distance / DRIVE_AMPLITUDE)} A"
                    ),
                    method="the derived waveform for a vanishing gap",
                ),
                Confirmation("its describing function, which is one", CloseNumbers(complex(gain), 1.0, 1e-8)),
            ),
            Uncheckable(
                "the other curves",
                Words("Inertia-controlled wave characteristics for a variety of backlash widths"),
                "the gaps that were drawn, and whether the constants of Listing A.8 were computed for each",
            ),
        ),
        explanation=(
            "What is said of $b = 0$ is right. The constants in lines 8 and 12 of Listing A.8 hold for a gap "
            "of 0.4 mm only; for other gaps the figure is right if they were replaced each time, as they are "
            "in the figure drawn here."
        ),
        source="derivations/backlash.py",
    )
