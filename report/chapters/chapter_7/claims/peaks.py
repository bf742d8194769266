"""Claim of chapter 7 on subharmonics, and on where a limit cycle shows."""

from __future__ import annotations

from report.chapters.chapter_5.claims.driven_open_loop import REPEATS, line_part, open_loop
from report.chapters.chapter_7.claims.input import harmonic_of_output
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.comparisons.printed import power_of
from report.evidence import Evidence
from report.numbers.drive_amplitudes import SAMPLES
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from report.numbers.record import line_amplitudes

FIFTH = 5


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claim."""
    return (_subharmonics(evidence),)


def _subharmonics(evidence: Evidence) -> Claim:
    orbit = evidence.motion.closed.orbits.friction.stable
    return Claim(
        id="txt-7-subharmonics",
        parts=(
            _below_the_drive(evidence),
            line_part(evidence, "a limit cycle on top of the drive's oscillation, in open loop"),
            Part(
                "closed loop without input",
                Assertion(
                    statement="the limit cycle is the only oscillation that stays",
                    derived=orbit.stable,
                    evidence=(
                        "every disturbance of it decays; its own harmonics stay with it, the largest with "
                        f"{100 * abs(orbit.harmonics[2] / orbit.harmonics[0]):.2f} %"
                    ),
                    method="Floquet multipliers of the exact orbit",
                ),
                Confirmation(
                    "a motion that starts elsewhere, 0.1 % outside of the unstable orbit, and ends on it",
                    CloseNumbers(evidence.motion.closed.orbits.left_by[1], orbit.amplitude, 1e-5),
                ),
            ),
        ),
        explanation=(
            "The peaks that are meant lie at multiples of the drive: they are harmonics, not subharmonics. A "
            "subharmonic, at a fraction of the drive's frequency, would need a motion with several times its "
            "period, which a stable linear system behind play does not have. A limit cycle on top of the "
            "driven oscillation shows where the output is fed back to the pin, not in open loop."
        ),
        consequence=(
            "In a spectrum of the open loop no peak has to be sorted out as a limit cycle: what is no "
            "harmonic is a free vibration that has not died out."
        ),
        impact=Impact.LOCAL,
        source="report/numbers/drive_amplitudes.py",
    )


def _fifth(evidence: Evidence) -> float:
    return harmonic_of_output(evidence, DRIVE_AMPLITUDE, DRIVE_FREQUENCY, FIFTH)


def _below_the_drive(evidence: Evidence) -> Part:
    run = open_loop(evidence)
    first, second = run.output[:SAMPLES], run.output[SAMPLES:]
    change = float(abs(second - first).max() / abs(second).max())
    half = float(line_amplitudes(run.output)[1])
    return Part(
        "open loop: what the peaks are",
        Assertion(
            statement="they are subharmonics of the drive",
            derived=change > REPEATS,
            evidence=(
                f"two periods differ by {power_of(change)} of the output, and at half of the "
                f"{DRIVE_FREQUENCY:.0f} Hz there are {power_of(half / run.harmonics[1])} of the first "
                "harmonic; the lines are at three, five and seven times the drive"
            ),
            method="exact simulation; two periods of the settled open loop",
        ),
        Confirmation(
            "the fifth harmonic by describing function and frequency response",
            CloseNumbers(_fifth(evidence), float(run.harmonics[FIFTH]), 1e-4),
        ),
    )
