"""Claim of appendix A on what captions, headings and texts call the listings."""

from __future__ import annotations

import math

import control
import numpy as np

from derivations.backlash import GAMMA
from derivations.friction import FORCE
from report.chapters.appendix_a.claims.friction_block import FRICTION_LINES, friction_block
from report.chapters.appendix_a.claims.listing_a_8 import ROUNDED_CONSTANT
from report.chapters.appendix_a.claims.time_domain import (
    DRIVE_AMPLITUDE,
    DRIVE_GAP,
    DRIVE_OMEGA,
    PERIOD,
    inertia_block,
)
from report.chapters.chapter_5.claims.figures_5_2_5 import LISTING
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.evidence import Evidence
from trimmer.elements.inertia_backlash import InertiaBacklash

FRICTION_FUNCTION = "function N = backlash_describing_func_2(A, b)"
"""First line of Listings A.2 and A.3."""
CALL = "N = @(A) backlash_describing_func_2(A, b)"
"""Line 8 of Listing A.9."""
METHOD = "the listing, repeated line by line"


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_captions(),)


def _captions() -> Claim:
    return Claim(
        id="txt-A.7-captions",
        parts=(_viscous(), _friction_in_time(), _inertia_in_time(), _description(), _heading()),
        explanation=(
            "Three captions, a heading and a text name another function than the one that stands there. "
            "Listing A.6 is the equivalent nonlinearity; A.7 and A.8 are blocks over time and no describing "
            "functions; the text of A.4 describes A.7; under the heading of A.10 stands "
            "friction-controlled backlash, which section 5.2.1 tells the reader to put there."
        ),
        consequence=(
            "Whoever takes a listing by its caption solves with friction instead of a heavy load, or puts a "
            "displacement where a gain belongs."
        ),
        impact=Impact.NOTATION,
        source="report/chapters/appendix_a/claims/captions.py",
    )


def _viscous() -> Part:
    names = ", ".join(sorted(str(symbol) for symbol in LISTING.free_symbols))
    return Part(
        "caption of Listing A.6",
        Assertion(
            statement="it is the describing function of viscous-controlled backlash",
            derived=GAMMA in LISTING.free_symbols and FORCE not in LISTING.free_symbols,
            evidence=f"it depends on {names}, so on a force of friction, and on no $M/D$",
            method="read in the listing: the names in its formula",
        ),
    )


def _friction_in_time() -> Part:
    once, twice = (friction_block(scale * 0.7, scale * 0.4, scale * 0.1) for scale in (1.0, 2.0))
    library = control.friction_backlash_nonlinearity(0.4)
    library.center = 0.1
    return Part(
        "caption of Listing A.7",
        Assertion(
            statement="it is a describing function",
            derived=math.isclose(once, twice),
            evidence=(
                "with all displacements doubled its result doubles, so it is a displacement; a describing "
                "function, a ratio, stays"
            ),
            method=METHOD,
        ),
        Confirmation(
            "python-control's backlash, whose output it is", CloseNumbers(float(library(0.7)), once)
        ),
    )


def _inertia_in_time() -> Part:
    times = np.array([0.3, 0.4]) * PERIOD
    right = InertiaBacklash(DRIVE_GAP).waveform(DRIVE_OMEGA * times, DRIVE_AMPLITUDE)
    outputs = 1e3 * inertia_block(np.asarray(DRIVE_AMPLITUDE * np.sin(DRIVE_OMEGA * times)), times)
    return Part(
        "caption of Listing A.8",
        Assertion(
            statement="it is a describing function",
            derived=math.isclose(*outputs),
            evidence=(
                f"for one amplitude and frequency it returns {outputs[0]:.2f} and {outputs[1]:.2f} mm at two "
                "instants"
            ),
            method=METHOD,
        ),
        Confirmation(
            "the waveform of inertia-controlled backlash, which has the first of them then",
            CloseNumbers(1e3 * float(right[0]), outputs[0], ROUNDED_CONSTANT),
        ),
    )


def _description() -> Part:
    described = ("e", "D_size", "u_prev")
    listed, other = (line[line.index("(") :].strip("()") for line in (FRICTION_FUNCTION, FRICTION_LINES[0]))
    return Part(
        "text of A.4",
        Assertion(
            statement="Listing A.3 takes the input wave, the dead band and the previous output",
            derived=listed.split(", ") == list(described),
            evidence=f"it takes {listed}; these three are the arguments of Listing A.7, {other}",
            method="read in the first lines of the two listings",
        ),
    )


def _heading() -> Part:
    return Part(
        "heading of A.10",
        Assertion(
            statement="its code is for Coulomb friction",
            derived="friction" in CALL.lower(),
            evidence=f"line 8 calls `{CALL.split()[-2].split('(')[0]}`, the function of Listing A.3",
            method="read in line 8 of Listing A.9",
        ),
    )
