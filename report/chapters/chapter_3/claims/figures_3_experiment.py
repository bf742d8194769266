"""Claims on figures 3.1 to 3.5, the measured motions and their spectra."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from report.chapters.chapter_3.claims.driven_harmonics import confirm_friction, confirm_play
from report.chapters.chapter_3.claims.measured_peaks import TABLE_2
from report.chapters.chapter_3.claims.section_3_2 import RAW_DATA
from report.chapters.chapter_6.claims.chapters_6_and_7 import GAPS_QUOTED
from report.claim import Claim, Confirmation, Part, Uncheckable, Words
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers, PrintedDigits
from report.comparisons.second_ways import second_way
from report.evidence import Evidence
from report.numbers.driven_motion import FORCES, GAP, SAMPLE_RATE, DrivenRun
from report.numbers.impedance import BY_FRICTION, BY_THE_PIN, displacements
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, MEASURED_DRIVE_FREQUENCY
from report.numbers.record import line_amplitudes
from trimmer import Body, TrimmerParameters
from trimmer.elements.friction_backlash import FrictionBacklash

Reals = NDArray[np.float64]

SOURCE = "report/numbers/driven_motion.py"
METHOD = (
    "exact simulation with the parameters of Listing A.1, 109.945 Hz and 1.5 mm, three forces of friction"
)
PRINTED_GAP, PRINTED_GAP_IN_CAPTION = "200e-6", "200"
SETTLED = int(0.1 * SAMPLE_RATE)
"""Samples at the end of a run, when the start has died out: as many as the experiment recorded."""
PHASES = 2**13
HIGHEST = 200
"""Order below which harmonics are added up for a bound; they fall off with its square."""
LOWEST_SHOWN, HIGHEST_SHOWN = 200.0, 1000.0
"""Range of figure 3.5, Hz."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    without, with_play = ([evidence.motion.driven.run(gap, force) for force in FORCES] for gap in (0.0, GAP))
    return (
        _motions("fig-3.1", "without play", without, evidence.numbers.parameters),
        _first_spectrum(evidence, without),
        _motions("fig-3.3", "with play", with_play, evidence.numbers.parameters),
        _second_spectrum(evidence, without, with_play),
        _enlarged(),
    )


def _curves(what: str) -> Uncheckable:
    return Uncheckable(what, Words("curves of three measurements"), RAW_DATA)


def _bound(parameters: TrimmerParameters, gap: float, force: float) -> float:
    """Return what guard over cutter is below, whatever the friction does within its bounds.

    No harmonic of a force that stays below F is above 4F/π. The harmonics of the guard are added up, and
    those of the cutter taken from the first one that the pin makes.
    """
    guard = cutter = 0.0
    lines = _lines_of_the_pin(gap)
    for order in range(1, HIGHEST, 2):
        omega = 2 * math.pi * order * MEASURED_DRIVE_FREQUENCY
        spring = (parameters.k2 + 1j * omega * parameters.c2) * lines[order]
        by_pin = abs(displacements(parameters, omega, spring * BY_THE_PIN))
        by_friction = abs(displacements(parameters, omega, 4 * force / math.pi * BY_FRICTION))
        guard += float((by_pin + by_friction)[Body.GUARD.index])
        own = float(by_pin[Body.CUTTER.index])
        cutter += (own if order == 1 else -own) - float(by_friction[Body.CUTTER.index])
    return guard / cutter


def _lines_of_the_pin(gap: float) -> Reals:
    """Return the amplitudes of the harmonics of the pin behind its play, m."""
    phases = 2 * math.pi * np.arange(PHASES) / PHASES
    pin = FrictionBacklash(gap).waveform(phases, DRIVE_AMPLITUDE) if gap else DRIVE_AMPLITUDE * np.sin(phases)
    return line_amplitudes(pin)


def _motions(claim_id: str, case: str, runs: list[DrivenRun], parameters: TrimmerParameters) -> Claim:
    shares = [
        float(np.ptp(run.guard[settled]) / np.ptp(run.cutter[settled]))
        for run in runs
        for settled in (run.last(SETTLED),)
    ]
    bounds = [_bound(parameters, run.gap, run.force) for run in runs]
    return Claim(
        id=claim_id,
        parts=(
            Part(
                "cutter and guard",
                Assertion(
                    statement="the cutter moves more than the guard",
                    derived=max(shares) < 1,
                    evidence=f"the guard moves {100 * min(shares):.1f} to {100 * max(shares):.1f} % as far",
                    method=METHOD,
                ),
                second_way(
                    f"a bound from harmonics, {100 * max(bounds):.0f} %, for any friction up to these forces",
                    max(bounds) < 1,
                ),
            ),
            _curves("measured motions"),
        ),
        explanation=(
            f"The model {case} moves as the text describes. The recorded curves cannot be checked, and the "
            "figure drawn here has the parameters of Listing A.1, not those of the experiment's trimmer."
        ),
        source=SOURCE,
    )


def _largest(run: DrivenRun) -> list[int]:
    """Return the orders of the three largest harmonics."""
    return sorted(range(1, run.harmonics.size), key=lambda order: -run.harmonics[order])[:3]


def _first_spectrum(evidence: Evidence, runs: list[DrivenRun]) -> Claim:
    run = runs[1]
    return Claim(
        id="fig-3.2",
        parts=(
            Part(
                "peaks",
                Assertion(
                    statement="the three dominant peaks are the first, third and fifth harmonic",
                    derived=all(set(_largest(each)) == {1, 3, 5} for each in runs),
                    evidence=(
                        f"with {run.force} N {1e6 * run.harmonics[1]:.0f}, {1e6 * run.harmonics[3]:.0f} and "
                        f"{1e6 * run.harmonics[5]:.0f} µm; the next, the seventh, has "
                        f"{1e6 * run.harmonics[7]:.1f} µm"
                    ),
                    method=METHOD,
                ),
                confirm_friction(evidence),
            ),
            _curves("measured spectra"),
        ),
        explanation=(
            "The model with friction alone has these three as its largest peaks too, for each of the forces "
            "of section 3.3. The measured spectra cannot be checked; their peaks are those of table 3.1."
        ),
        source=SOURCE,
    )


def _second_spectrum(evidence: Evidence, without: list[DrivenRun], with_play: list[DrivenRun]) -> Claim:
    growth = [
        float(play.harmonics[order] / none.harmonics[order])
        for none, play in zip(without, with_play, strict=True)
        for order in (3, 5, 7)
    ]
    return Claim(
        id="fig-3.4",
        parts=(
            Part(
                "gap in the caption, from $200\\times10^{-6}$ m",
                PrintedDigits(PRINTED_GAP_IN_CAPTION, 1e6 * float(PRINTED_GAP), "µm"),
                Confirmation(
                    "chapter 6, which quotes the gap again",
                    CloseNumbers(float(GAPS_QUOTED["chapter 6"]), float(PRINTED_GAP)),
                ),
            ),
            Part(
                "harmonics",
                Assertion(
                    statement="with play the higher harmonics are larger than without",
                    derived=min(growth) > 1,
                    evidence=(
                        f"third, fifth and seventh by factors of {min(growth):.1f} to {max(growth):.1f}, "
                        "for the same friction"
                    ),
                    method=METHOD,
                ),
                confirm_play(evidence, GAP),
            ),
            _curves("measured spectra"),
        ),
        explanation=(
            "Play of 0.2 mm raises the odd harmonics in the model. It adds no even ones, which table 3.2 "
            "lists as measured, see section 3.3."
        ),
        source=SOURCE,
    )


def _enlarged() -> Claim:
    frequencies = [float(cell) for row in TABLE_2.values() for cell in row[1:]]
    return Claim(
        id="fig-3.5",
        parts=(
            Part(
                "range of frequencies",
                Assertion(
                    statement="200 to 1000 Hz shows every tabulated harmonic but the first",
                    derived=min(frequencies) >= LOWEST_SHOWN and max(frequencies) <= HIGHEST_SHOWN,
                    evidence=f"they lie between {min(frequencies):.3f} and {max(frequencies):.3f} Hz",
                    method="read in table 3.2",
                ),
            ),
            _curves("measured spectra"),
        ),
        explanation=(
            "The range fits the table. The sixth to ninth harmonic would lie in it as well, but are not "
            "tabulated; what was measured of them cannot be checked."
        ),
        source="report/chapters/chapter_3/claims/measured_peaks.py",
    )
