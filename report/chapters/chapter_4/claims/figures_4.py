"""Claims on figures 4.1 to 4.3, the blocks of backlash under a sine."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from derivations.backlash import CONTACT, inertia_contact_ratio
from report.chapters.appendix_a.claims.friction_block import friction_block
from report.chapters.appendix_a.claims.time_domain import (
    DRIVE_GAP,
    PRINTED_OFFSET,
    inertia_block,
)
from report.evidence import Evidence
from report.numbers.independent.blocks_in_steps import stepped, stepped_by_library
from report.parts import assertion, close, uncheckable
from report.record import Record, claim, text
from report.text import filled
from report.thesis import DRIVE_AMPLITUDE, DRIVE_OMEGA, TURN
from trimmer import FrictionBacklash, InertiaBacklash

Reals = NDArray[np.float64]

BLOCKS = "report/chapters/appendix_a/claims/time_domain.py"
SAMPLES = 2003
"""Samples of a period, none of which is an instant at which Listing A.8 applies no line."""
ROUNDING = 1e-15
VISIBLE = 0.01
"""Share of the amplitude that a line in a figure hides."""
VANISHING = 1e-9 * DRIVE_AMPLITUDE
GAPS = (0.0, 2e-4, 4e-4, 8e-4, 16e-4)
"""Gaps of our figure 4.3, m; those of the thesis are not given."""


def phases(samples: int = SAMPLES) -> Reals:
    """Return the phases of two periods of the pin, rad."""
    return TURN * np.arange(2 * samples) / samples


def own_block(samples: int = SAMPLES) -> Reals:
    """Return the output of Listing A.7 for the sine of figure 4.1 from rest, m."""
    return stepped(friction_block, DRIVE_AMPLITUDE * np.sin(phases(samples)), DRIVE_GAP)


def built_in_block(samples: int = SAMPLES) -> Reals:
    """Return the output of python-control's backlash for the same sine from rest, m."""
    return stepped_by_library(DRIVE_AMPLITUDE * np.sin(phases(samples)), DRIVE_GAP)


def listing_a8() -> Reals:
    """Return the output of Listing A.8 for its own drive, m."""
    return inertia_block(DRIVE_AMPLITUDE * np.sin(phases()), phases() / DRIVE_OMEGA)


def exact_inertia(gap: float) -> Reals:
    """Return the derived waveform of a load without friction, m; the pin itself without gap."""
    if gap == 0:
        return DRIVE_AMPLITUDE * np.sin(phases())
    return InertiaBacklash(gap).waveform(phases(), DRIVE_AMPLITUDE)


@claim("fig-4.1", source=BLOCKS)
def two_blocks(_: Evidence) -> Record:
    distance = float(np.abs(own_block() - built_in_block()).max())
    own, settled = own_block()[SAMPLES:], FrictionBacklash(DRIVE_GAP).waveform(phases(), DRIVE_AMPLITUDE)
    waveform = "the derived waveform in the second period"
    yield assertion(
        "built-in and own block, $b$ = 0.0004 m",
        "the two outputs are the same",
        distance <= ROUNDING,
        f"over two periods from rest they differ by {distance:.1g} m at most",
        method="Listing A.7 and python-control's backlash, sample by sample, on a sine of 1.5 mm",
        second=close(waveform, float(np.ptp(own)), float(np.ptp(settled[SAMPLES:])), 1e-5),
    )
    yield text(
        """
        The blocks agree from the start on, not only when settled; Simulink's own block is taken to be what
        its description says, which python-control's is too. Why they agree for any input is shown at Listing
        A.7.
        """
    )


@claim("fig-4.2", source=BLOCKS)
def block_with_inertia(_: Evidence) -> Record:
    distance = float(np.abs(listing_a8() - exact_inertia(DRIVE_GAP)).max())
    lacking = math.pi * DRIVE_AMPLITUDE + DRIVE_GAP / 2 - float(PRINTED_OFFSET)
    constant = r"what the constant of line 12 lacks of $\pi A + b/2$"
    yield assertion(
        "output of Listing A.8 for its own drive",
        "it behaves as figure 2.10",
        distance < VISIBLE * DRIVE_AMPLITUDE,
        filled(
            """
            it is off the derived waveform by [[ micrometres | f1 ]] µm at most, [[ share | f1 ]] % of the
            amplitude
            """,
            micrometres=1e6 * distance,
            share=100 * distance / DRIVE_AMPLITUDE,
        ),
        method="the listing, repeated line by line, against the derived waveform",
        second=close(constant, lacking, distance, 1e-6),
    )
    yield text(
        """
        To the width of a line the figure is right. The deviation is the jump from the rounded constant in
        line 12 of Listing A.8. The block would show the same waveform for any other input, because its flight
        is a function of time alone.
        """
    )


@claim("fig-4.3", source="derivations/backlash.py")
def gaps(_: Evidence) -> Record:
    phase, element = phases()[:SAMPLES], InertiaBacklash(VANISHING)
    small = element.waveform(phase, DRIVE_AMPLITUDE)
    distance = float(np.abs(small - DRIVE_AMPLITUDE * np.sin(phase)).max())
    gain = complex(element.describing_function(DRIVE_AMPLITUDE))
    yield assertion(
        "$b$ = 0",
        "the output is the input",
        distance <= VANISHING and inertia_contact_ratio().subs(CONTACT, 0) == 0,
        filled(
            r"""
            the flight lasts for $\phi$ with $b/A = \phi - \sin\phi$, so it vanishes with the gap; at $b =
            10^{-9}A$ output and input differ by [[ distance | power0 ]] A
            """,
            distance=distance / DRIVE_AMPLITUDE,
        ),
        method="the derived waveform for a vanishing gap",
        second=close("its describing function, which is one", gain, 1.0, 1e-8),
    )
    yield uncheckable(
        "the other curves",
        "Inertia-controlled wave characteristics for a variety of backlash widths",
        "the gaps that were drawn, and whether the constants of Listing A.8 were computed for each",
    )
    yield text(
        """
        What is said of $b = 0$ is right. The constants in lines 8 and 12 of Listing A.8 hold for a gap of 0.4
        mm only; for other gaps the figure is right if they were replaced each time, as they are in the figure
        drawn here.
        """
    )
