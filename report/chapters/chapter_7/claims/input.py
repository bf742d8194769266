"""Claims of chapter 7 on the drive's amplitude, and on what shows of a limit cycle in the output."""

import numpy as np

from report.chapters.chapter_3.claims.section_3_3_open_loop import SUBHARMONICS
from report.chapters.chapter_5.claims.section_5_2_1_driven import (
    REPEATS,
    line_part,
    open_loop,
    open_loop_harmonic,
    open_loop_repeats,
)
from report.judging.comparisons.printed import power_of
from report.judging.parts import assertion, close
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty, Severity
from report.numbers.drive_amplitudes import SAMPLES
from report.numbers.evidence import Evidence
from report.numbers.record import change, line_amplitudes
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, LARGE_GAP
from trimmer import FrictionBacklash

DRIVE_AMPLITUDES = (0.0005, DRIVE_AMPLITUDE, 0.003)
FIFTH = 5
SIMULATED = "exact simulation with 1.5 mm and 100 Hz"
BY_RESPONSE = "fifth harmonic of the derived element times the response of $G$"


@claim("txt-7-input-amplitude")
def input_amplitude(known: Evidence) -> Record:
    decay = max(mode.eigenvalue.real for mode in known.numbers.modes)
    fifth = [open_loop_harmonic(known, FIFTH, amplitude) for amplitude in DRIVE_AMPLITUDES]
    yield assertion(
        "what oscillates in open loop",
        "besides the drive and its harmonics a limit cycle goes on",
        decay >= 0,
        rf"""
        the backlash repeats with the drive's period, and behind it every free motion of the linear part
        decays as $e^{{{decay:.1f}\,t}}$ or faster
        """,
        method="periodic input of a stable linear system",
        second=open_loop_repeats(known),
        item="the open loop shows the limit cycle of the closed loop",
        severity=Severity.CONCLUSION,
        certainty=Certainty.PROVEN,
    )
    below = FrictionBacklash(LARGE_GAP).describing_function(0.49 * LARGE_GAP)
    outputs = ", ".join(f"{1e6 * each:.2f} µm" for each in fifth)
    inputs = ", ".join(f"{1e3 * each:.1f} mm" for each in DRIVE_AMPLITUDES)
    yield assertion(
        "what it depends on",
        "the amplitude of the input has no effect on the oscillation that is left",
        [max(fifth) / min(fifth) < 1.001, bool(np.isfinite(below))] == [True, True],
        f"""
        for a gap of {1e6 * LARGE_GAP:.0f} µm the fifth harmonic of the output is {outputs} for inputs of
        {inputs}; below half of the gap there is no output at all
        """,
        method=BY_RESPONSE,
        second=close(SIMULATED, open_loop(known).harmonics[FIFTH], fifth[1], 1e-4),
        item="the drive's amplitude does not alter the limit cycle",
        severity=Severity.RESULT,
    )
    yield text(f"""
        In open loop nothing is fed back, so there is no limit cycle that could keep its amplitude: what is
        seen are harmonics of the drive. An input much larger than the gap leaves nearly a square wave of half
        the gap behind the play, whatever its amplitude. From {f"{1e3 * DRIVE_AMPLITUDES[1]:g}"} to
        {f"{1e3 * DRIVE_AMPLITUDES[2]:g}"} mm the fifth harmonic grows by
        {100 * (fifth[2] / fifth[1] - 1):.1f} %, which is easily taken for nothing.

        The answer holds as an approximation for wide strokes, and not for a limit cycle. On a limit cycle
        under a drive in closed loop see [the drive's amplitude](#txt-5.2.1-drive-amplitude).
    """)


@claim("txt-7-subharmonics")
def subharmonics(known: Evidence) -> Record:
    run, orbit = open_loop(known), known.orbits.friction.stable
    first, second = run.output[:SAMPLES], run.output[SAMPLES:]
    between_periods = change(first, second)
    fifth = open_loop_harmonic(known, FIFTH)
    by_response = "the fifth harmonic by describing function and frequency response"
    half = float(line_amplitudes(run.output)[1]) / run.harmonics[1]
    yield assertion(
        "open loop: what the peaks are",
        "they are subharmonics of the drive",
        between_periods > REPEATS,
        f"""
        two periods differ by {power_of(between_periods)} of the output, and at half of the
        {DRIVE_FREQUENCY:.0f} Hz there are {power_of(half)} of the first harmonic; the lines are at three,
        five and seven times the drive
        """,
        method="exact simulation; two periods of the settled open loop",
        second=close(by_response, fifth, run.harmonics[FIFTH], 1e-4),
        item=SUBHARMONICS,
        severity=Severity.SLIP,
    )
    yield line_part(known, "a limit cycle on top of the drive's oscillation, in open loop")
    largest = 100 * abs(orbit.harmonics[2] / orbit.harmonics[0])
    elsewhere = "a motion that starts elsewhere, 0.1 % outside of the unstable orbit, and ends on it"
    yield assertion(
        "closed loop without input",
        "the limit cycle is the only oscillation that stays",
        orbit.stable,
        f"every disturbance of it decays; its own harmonics stay with it, the largest with {largest:.2f} %",
        method="Floquet multipliers of the exact orbit",
        second=close(elsewhere, known.orbits.left_by[1], orbit.amplitude, 1e-5),
    )
    yield text("""
        The peaks that are meant lie at multiples of the drive: they are harmonics, not subharmonics. A
        subharmonic, at a fraction of the drive's frequency, needs a motion with several times its period,
        which a stable linear system behind play does not have. A limit cycle on top of the driven oscillation
        shows where the output is fed back to the pin, not in open loop.

        In a spectrum of this open loop no peak can be that of a limit cycle: what is no harmonic is a free
        vibration that has not died out.
    """)
