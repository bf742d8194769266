"""Claims of section 5.2.1 on the driven loop: its output, its spectrum, the drive's amplitude."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from report.chapters.chapter_5.claims.driven_open_loop import (
    harmonic_in_open_loop,
    line_part,
    open_loop,
    open_loop_repeats,
    size_part,
)
from report.claim import Impact
from report.evidence import Evidence
from report.numbers.time_stepping import lines_in_steps, steps
from report.parts import assertion, close, small
from report.record import Record, claim, text
from report.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, LARGE_GAP

SOURCE = "report/numbers/drive_amplitudes.py"
UNALTERED = 0.05
"""Share by which an amplitude may change and still be called unaltered."""


@claim("txt-5.2.1-open-loop-output", source=SOURCE, impact=Impact.DOWNSTREAM)
def output(known: Evidence) -> Record:
    opened, closed = open_loop(known), known.motion.closed.reference.from_rest
    orders = [int(order) + 2 for order in np.argsort(-opened.harmonics[2:])[:3]]
    yield size_part(known, "size of the output")
    yield assertion(
        "sub-oscillations",
        "the output holds oscillations on top of that of the drive",
        opened.harmonics[orders[0]] > 1e-3 * opened.harmonics[1],
        ", ".join(f"{1e6 * opened.harmonics[order]:.1f} µm at {100 * order} Hz" for order in orders),
        method="harmonics of the settled open loop",
        second=harmonic_in_open_loop(known, orders[0]),
    )
    yield text("""
        Behind backlash of 40 µm the open loop passes a drive of 1.5 mm nearly unchanged, with harmonics of
        [[ ripple | f0 ]] µm that are hardly seen in it. The loop with the output fed back has [[ base | f2 ]]
        mm at 100 Hz and on it the limit cycle with [[ line | f2 ]] mm: the output that the text describes.
        What was simulated as open loop is, by its numbers, the closed loop with a reference. That the printed
        ±1 mm correspond to the drive's amplitude is not so either: it is 1.5 mm.

        Figures 5.11 and 5.12b then say nothing on the open loop, nor on the experiment.
    """).given(ripple=1e6 * opened.ripple, base=1e3 * closed.base, line=1e3 * closed.line)


@claim("txt-5.2.1-open-loop-peak", source=SOURCE, impact=Impact.DOWNSTREAM)
def peak(known: Evidence) -> Record:
    in_open_loop, closed = open_loop(known).harmonics[1], known.motion.closed.reference.from_rest.base
    yield line_part(known, "line at the limit cycle's frequency")
    yield assertion(
        "line at the drive's frequency",
        "the driven spectrum has a line at 100 Hz that the closed loop alone has not",
        closed > 0,
        f"{1e3 * in_open_loop:.2f} mm in the open loop, {1e3 * closed:.2f} mm with the output fed back",
        method="exact simulation",
        second=harmonic_in_open_loop(known, 1),
    )
    yield text("""
        Without feedback there is no limit cycle: a stable linear system behind play ends with the drive's
        period, whatever its start, and play adds odd harmonics only. Two lines, at 100 Hz and near 733 Hz,
        are what the same two blocks give when the output is subtracted from the drive. With both channels of
        the pin that loop would not show the second one either: a drive of 1.5 mm puts the limit cycle out.

        That a limit cycle may be evaluated in the open loop as well does not follow; chapter 7 and the
        reading of the experiment's peaks use it.
    """)


@claim("txt-5.2.1-drive-amplitude", source=SOURCE, impact=Impact.DOWNSTREAM)
def drive_amplitude(known: Evidence) -> Record:
    orbit, runs = known.orbits.friction.stable, known.motion.closed.reference.from_limit_cycle
    lines = [run.line for run in runs]
    references = [steps(run.amplitude, DRIVE_FREQUENCY) for run in runs]
    frequencies = [run.frequency if run.line else orbit.frequency for run in runs]
    in_steps = lines_in_steps(orbit, LARGE_GAP, references, frequencies)
    seen = [f"{1e6 * run.line:.1f} µm" if run.line else "none" for run in runs]
    yield assertion(
        "open loop",
        "there is a limit cycle under the drive",
        max(mode.eigenvalue.real for mode in known.numbers.modes) >= 0,
        "what is seen repeats with the drive; see the harmonics in figure E.2",
        method="periodic input of a stable linear system",
        second=open_loop_repeats(known),
    )
    statement = "the drive's amplitude does not alter that of the limit cycle"
    method = "exact simulation, started on the limit cycle"
    means = "steps of 20 µs, in which a drive of 15 mm puts it out too"
    yield assertion(
        "loop with a reference, the five amplitudes of figure E.2",
        statement,
        _unaltered(lines),
        "; ".join(f"{1e3 * run.amplitude:g} mm: {line}" for run, line in zip(runs, seen, strict=True)),
        method=method,
        second=small(means, in_steps[3] / lines[0], 0.01),
    )
    means = "steps of 20 µs, with SciPy's matrix exponential"
    yield assertion(
        "the same, up to 1.5 mm",
        statement,
        _unaltered(lines[:3]),
        f"it falls by {100 * (1 - lines[2] / lines[0]):.1f} %",
        method=method,
        second=close(means, in_steps[2], lines[2], 0.005),
    )
    yield text("""
        In the open loop there is no limit cycle. Where the drive is a reference of the closed loop, it hardly
        alters the limit cycle up to 1.5 mm, [[ gaps | f1 ]] gaps, and puts it out altogether at 15 mm. A
        drive smaller than half of the gap cannot start it from rest either.

        The conclusion of chapter 7 holds for weak drives of a closed loop, not for the trimmer's.
    """).given(gaps=DRIVE_AMPLITUDE / LARGE_GAP)


def _unaltered(lines: Sequence[float]) -> bool:
    return max(lines) - min(lines) < UNALTERED * max(lines)
