"""Claims of section 3.1 on the resolution of the measured spectra, and on the bins of tables 3.1 and 3.2."""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from fractions import Fraction

import numpy as np
import sympy

from report.chapters.chapter_3.claims.measured_peaks import (
    BIN,
    DURATION,
    FRAMES,
    FRAMES_OF_TABLES,
    RESOLUTION,
    SAMPLE_RATE,
    on_a_bin,
    tabulated,
)
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.expression import SameExpression
from report.evidence import Evidence

SOURCE = "report/chapters/chapter_3/claims/measured_peaks.py"
FEWEST, MOST = 1000, 4000
"""Numbers of samples, at 20 kHz, among which a grid for the tables is sought."""
HALF_DIGIT = 0.0005 * (1 + 1e-9)
"""Half a unit of the last printed place, Hz."""


def claims(_: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_resolution_formula(), _resolution(), _bins())


def _numpy_bin(samples: int) -> float:
    """Return the distance of bins as NumPy has it, Hz."""
    frequencies = np.fft.rfftfreq(samples, 1 / float(SAMPLE_RATE))
    return float(frequencies[1] - frequencies[0])


def _resolution_formula() -> Claim:
    rate, samples = sympy.symbols("F_s N", positive=True)
    frequency = sympy.Symbol("f", positive=True)
    turns = frequency * samples / rate
    (derived,) = sympy.solve(sympy.Eq(turns, 1), frequency)
    return Claim(
        id="eq-3.1",
        parts=(
            Part(
                "",
                SameExpression(rate / samples, derived, left=r"\Delta f"),
                Confirmation(
                    "NumPy's bins for 2000 samples at 20 kHz",
                    CloseNumbers(
                        _numpy_bin(int(FRAMES)),
                        float(derived.subs({rate: int(SAMPLE_RATE), samples: int(FRAMES)})),
                    ),
                ),
            ),
        ),
        explanation=(
            "The lowest sine that repeats with the record turns once in $N$ samples, and the bins are its "
            "multiples. It is the distance of bins; the frequency of a single peak can be found better than "
            "that, two peaks less than a bin or two apart cannot be told apart."
        ),
        source=SOURCE,
    )


def _resolution() -> Claim:
    frames = Fraction(SAMPLE_RATE) * Fraction(DURATION)
    return Claim(
        id="txt-3.1-resolution",
        parts=(
            Part(
                "frames in 0.1 s at 20 kHz",
                PrintedDigits(FRAMES, frames),
                Confirmation(
                    "a count of the instants before 0.1 s",
                    CloseNumbers(len(range(0, 100_000, 50)), float(frames)),
                ),
            ),
            Part(
                "resolution",
                PrintedDigits(RESOLUTION, Fraction(SAMPLE_RATE) / int(FRAMES), "Hz"),
                Confirmation("NumPy's bins", CloseNumbers(_numpy_bin(int(FRAMES)), 1 / float(DURATION))),
            ),
        ),
        explanation=(
            "Both are right, and the resolution is one over the time of the record. The tables that follow "
            f"have bins of {float(BIN):.3f} Hz, so one frame more was used: 0 to 0.1 s with both ends."
        ),
        source=SOURCE,
    )


def _grids(cells: Sequence[str]) -> list[int]:
    """Return the numbers of samples with a bin at every frequency (Hz, three decimals)."""
    samples = np.arange(FEWEST, MOST)
    frequencies = np.array(cells, dtype=float)[:, np.newaxis]
    spacing = float(SAMPLE_RATE) / samples
    miss = np.abs(np.round(frequencies / spacing) * spacing - frequencies)
    return [int(each) for each in samples[(miss <= HALF_DIGIT).all(axis=0)]]


def _listed_by_numpy(cells: Sequence[str], samples: int) -> int:
    """Count the frequencies (Hz, three decimals) that stand among NumPy's bins to every digit."""
    bins = {f"{each:.3f}" for each in np.fft.rfftfreq(samples, 1 / float(SAMPLE_RATE))}
    return sum(cell in bins for cell in cells)


def _bins() -> Claim:
    cells = tabulated()
    stated = [cell for cell in cells if on_a_bin(cell, int(FRAMES))]
    return Claim(
        id="txt-3.1-bins",
        parts=(
            Part(
                "with the stated 2000 frames",
                Assertion(
                    statement="the tabulated peaks are bins of 10 Hz",
                    derived=len(stated) == len(cells),
                    evidence=f"{len(stated)} of {len(cells)} are; bins of 2000 frames are multiples of 10 Hz",
                    method="each printed frequency against the nearest bin",
                ),
                Confirmation(
                    "the remainders of the printed decimals on division by ten",
                    CloseNumbers(1 + sum(Decimal(cell) % 10 == 0 for cell in cells), 1 + len(stated)),
                ),
            ),
            _any_frames(cells),
        ),
        explanation=(
            f"The peaks are multiples of 20000/{FRAMES_OF_TABLES} = {float(BIN):.4f} Hz, the bins of one "
            "frame more than stated; three cells are not and are misprints. The three decimals are those of "
            "the bins: each peak is known to half a bin, 5 Hz."
        ),
        consequence=(
            "The drive's frequency is not measured to a millihertz, and differences of 10 Hz between "
            "measurements mean one bin."
        ),
        impact=Impact.LOCAL,
        source=SOURCE,
    )


def _any_frames(cells: Sequence[str]) -> Part:
    misfits = [cell for cell in cells if not on_a_bin(cell)]
    others = [cell for cell in cells if cell not in misfits]
    grids, whole = _grids(others), _grids(cells)
    return Part(
        "with any number of frames",
        Assertion(
            statement="the tabulated peaks are bins of one spectrum",
            derived=len(whole) > 0,
            evidence=(
                f"{len(others)} of {len(cells)} are, to every digit, with "
                f"{' or '.join(map(str, grids))} frames and with no other number between {FEWEST} "
                f"and {MOST}; {', '.join(sorted(set(misfits)))} are bins of none of these"
            ),
            method="each printed frequency against the nearest bin, for every number of frames",
        ),
        Confirmation(
            f"NumPy's bins for {grids[0]} frames, rounded to three decimals",
            CloseNumbers(_listed_by_numpy(cells, grids[0]), len(others)),
        ),
    )
