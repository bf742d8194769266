"""Claims of section 5.2.1 on the driven loop: its output, its spectrum, the drive's amplitude."""

from __future__ import annotations

import numpy as np

from report.chapters.chapter_5.claims.driven_open_loop import (
    harmonic_in_open_loop,
    line_part,
    open_loop,
    open_loop_repeats,
    size_part,
)
from report.claim import Claim, Confirmation, Impact, Part
from report.comparisons.assertion import Assertion
from report.comparisons.digits import CloseNumbers
from report.evidence import Evidence
from report.numbers.linear_numbers import DRIVE_AMPLITUDE, DRIVE_FREQUENCY
from report.numbers.reference_loop import GAP, ReferenceNumbers
from report.numbers.time_stepping import lines_in_steps, steps

SOURCE = "report/numbers/reference_loop.py"
UNALTERED = 0.05
"""Share by which an amplitude may change and still be called unaltered."""


def claims(evidence: Evidence) -> tuple[Claim, ...]:
    """Return the claims in thesis order."""
    return (_output(evidence), _peak(evidence), _amplitude(evidence))


def _output(evidence: Evidence) -> Claim:
    opened, closed = open_loop(evidence), evidence.motion.closed.reference.from_rest
    orders = np.argsort(-opened.harmonics[2:])[:3] + 2
    return Claim(
        id="txt-5.2.1-open-loop-output",
        parts=(
            size_part(evidence, "size of the output"),
            Part(
                "sub-oscillations",
                Assertion(
                    statement="the output holds oscillations on top of that of the drive",
                    derived=bool(opened.harmonics[orders[0]] > 1e-3 * opened.harmonics[1]),
                    evidence=", ".join(
                        f"{1e6 * opened.harmonics[order]:.1f} µm at {100 * order} Hz" for order in orders
                    ),
                    method="harmonics of the settled open loop",
                ),
                harmonic_in_open_loop(evidence, int(orders[0])),
            ),
        ),
        explanation=(
            "Behind backlash of 40 µm the open loop passes a drive of 1.5 mm nearly unchanged, with "
            f"harmonics of {1e6 * opened.ripple:.0f} µm that are hardly seen in it. The loop with the output "
            f"fed back has {1e3 * closed.base:.2f} mm at 100 Hz and on it the limit cycle with "
            f"{1e3 * closed.line:.2f} mm: the output that the text describes. What was simulated as open "
            "loop is, by its numbers, the closed loop with a reference. That the printed ±1 mm correspond to "
            "the drive's amplitude is not so either: it is 1.5 mm."
        ),
        consequence="Figures 5.11 and 5.12b then say nothing on the open loop, nor on the experiment.",
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _peak(evidence: Evidence) -> Claim:
    reference = evidence.motion.closed.reference
    return Claim(
        id="txt-5.2.1-open-loop-peak",
        parts=(
            line_part(evidence, "line at the limit cycle's frequency"),
            Part(
                "line at the drive's frequency",
                Assertion(
                    statement="the driven spectrum has a line at 100 Hz that the closed loop alone has not",
                    derived=reference.from_rest.base > 0,
                    evidence=(
                        f"{1e3 * open_loop(evidence).harmonics[1]:.2f} mm in the open loop, "
                        f"{1e3 * reference.from_rest.base:.2f} mm with the output fed back"
                    ),
                    method="exact simulation",
                ),
                harmonic_in_open_loop(evidence, 1),
            ),
        ),
        explanation=(
            "Without feedback there is no limit cycle: a stable linear system behind play ends with the "
            "drive's period, whatever its start, and play adds odd harmonics only. Two lines, at 100 Hz and "
            "near 733 Hz, are what the same two blocks give when the output is subtracted from the drive. "
            "With both channels of the pin that loop would not show the second one either: a drive of 1.5 mm "
            "puts the limit cycle out."
        ),
        consequence=(
            "That a limit cycle may be evaluated in the open loop as well does not follow; chapter 7 and the "
            "reading of the experiment's peaks use it."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _amplitude(evidence: Evidence) -> Claim:
    reference = evidence.motion.closed.reference
    lines = [run.line for run in reference.from_limit_cycle]
    in_steps = _lines_in_steps(evidence)
    return Claim(
        id="txt-5.2.1-drive-amplitude",
        parts=(
            Part(
                "open loop",
                Assertion(
                    statement="there is a limit cycle under the drive",
                    derived=max(mode.eigenvalue.real for mode in evidence.numbers.modes) >= 0,
                    evidence="what is seen repeats with the drive; see the harmonics in figure E.2",
                    method="periodic input of a stable linear system",
                ),
                open_loop_repeats(evidence),
            ),
            _five_amplitudes(reference, lines, in_steps),
            Part(
                "the same, up to 1.5 mm",
                Assertion(
                    statement="the drive's amplitude does not alter that of the limit cycle",
                    derived=_unaltered(lines[:3]),
                    evidence=f"it falls by {100 * (1 - lines[2] / lines[0]):.1f} %",
                    method="exact simulation, started on the limit cycle",
                ),
                Confirmation(
                    "steps of 20 µs, with SciPy's matrix exponential",
                    CloseNumbers(in_steps[2], lines[2], 0.005),
                ),
            ),
        ),
        explanation=(
            "In the open loop there is no limit cycle. Where the drive is a reference of the closed loop, it "
            f"hardly alters the limit cycle up to 1.5 mm, {DRIVE_AMPLITUDE / GAP:.1f} gaps, and "
            "puts it out altogether at 15 mm. A drive smaller than half of the gap cannot start it from rest "
            "either."
        ),
        consequence=(
            "The conclusion of chapter 7 holds for weak drives of a closed loop, not for the trimmer's."
        ),
        impact=Impact.DOWNSTREAM,
        source=SOURCE,
    )


def _five_amplitudes(reference: ReferenceNumbers, lines: list[float], in_steps: list[float]) -> Part:
    return Part(
        "loop with a reference, the five amplitudes of figure E.2",
        Assertion(
            statement="the drive's amplitude does not alter that of the limit cycle",
            derived=_unaltered(lines),
            evidence=_listed(reference),
            method="exact simulation, started on the limit cycle",
        ),
        Confirmation(
            "steps of 20 µs, in which a drive of 15 mm puts it out too",
            CloseNumbers(1 + in_steps[3] / lines[0], 1.0, 0.01),
        ),
    )


def _lines_in_steps(evidence: Evidence) -> list[float]:
    """Return the line of the limit cycle for each amplitude of the reference, m, followed in fixed steps."""
    orbit, runs = (
        evidence.motion.closed.orbits.friction.stable,
        evidence.motion.closed.reference.from_limit_cycle,
    )
    frequencies = [run.frequency if run.line else orbit.frequency for run in runs]
    references = [steps(run.amplitude, DRIVE_FREQUENCY) for run in runs]
    return [float(each) for each in lines_in_steps(orbit, GAP, references, frequencies)]


def _unaltered(lines: list[float]) -> bool:
    return max(lines) - min(lines) < UNALTERED * max(lines)


def _listed(reference: ReferenceNumbers) -> str:
    return "; ".join(
        f"{1e3 * run.amplitude:g} mm: " + (f"{1e6 * run.line:.1f} µm" if run.line else "none")
        for run in reference.from_limit_cycle
    )
