"""Claims of section 5.2.1 on the driven loop: its output, its spectrum, the drive's amplitude.

Figures 5.11, 5.12 and 5.14, appendix E and chapter 7 share parts and second ways on the open loop.
"""

from collections.abc import Sequence

import numpy as np

from report.judging.claim import ClaimPart, Confirmation
from report.judging.parts import assertion, close, made_here, small, so
from report.judging.record import Record, claim, text
from report.judging.verdict import Certainty
from report.numbers.drive_amplitudes import SAMPLES, AmplitudeRun
from report.numbers.evidence import Evidence
from report.numbers.independent.harmonics import harmonic_behind
from report.numbers.record import change
from report.numbers.thesis import DRIVE_AMPLITUDE, DRIVE_FREQUENCY, DRIVE_OMEGA, LARGE_GAP
from report.numbers.time_stepping import lines_in_steps, steps
from trimmer import FrictionBacklash

LOOP_CLOSED = "the output is fed back: the loop of figure 2.5 with the drive as its reference, e = r - y"
PRINTED_SIZE = 1.0  # Printed size of the output, mm
ABOUT = 0.1  # Share by which an approximate size may be off
REPEATS = 1e-6  # Share of the output by which two periods that are alike may differ
NEAR = 2.0  # Distance from the limit cycle's frequency at which a line may still be said to be at it, Hz
UNALTERED = 0.05  # Share by which an amplitude may change and still be called unaltered


def open_loop(known: Evidence) -> AmplitudeRun:
    """Return the settled open loop of the section."""
    return next(run for run in known.motion.drive_amplitudes if run.amplitude == DRIVE_AMPLITUDE)


def open_loop_harmonic(
    known: Evidence, order: int, amplitude: float = DRIVE_AMPLITUDE, omega: float = DRIVE_OMEGA
) -> float:
    """Return the amplitude of a harmonic of the open loop without simulation, m, for a drive (m, rad/s)."""
    element = FrictionBacklash(LARGE_GAP)
    return harmonic_behind(known.numbers.displacement_only, element, amplitude, omega, order)


def harmonic_in_open_loop(known: Evidence, order: int) -> Confirmation:
    """Confirm a harmonic of the settled open loop without simulation."""
    by_balance, simulated = open_loop_harmonic(known, order), open_loop(known).harmonics[order]
    means = f"harmonic {order} by describing function and frequency response"
    return close(means, by_balance, float(simulated), 1e-4)


def open_loop_repeats(known: Evidence) -> Confirmation:
    """Confirm by simulation that the open loop ends with the period of its drive."""
    runs = known.motion.drive_amplitudes
    periods = [(run.output[:SAMPLES], run.output[SAMPLES:]) for run in runs]
    return so(
        f"exact simulation with {len(runs)} drives, of which the last two periods are alike",
        tuple(change(first, second) <= REPEATS for first, second in periods),
    )


def size_part(known: Evidence, label: str) -> ClaimPart:
    """Return the part on the size of the output, which the open loop exceeds and the closed one has."""
    opened, base = 1e3 * float(np.abs(open_loop(known).output).max()), 1e3 * open_loop(known).harmonics[1]
    closed = 1e3 * known.motion.closed.reference.from_rest.largest
    about = ABOUT * PRINTED_SIZE
    by_closed = abs(closed - PRINTED_SIZE) < about
    return assertion(
        label,
        "the base oscillation behind the open loop goes from about -0.001 to 0.001 m",
        min(abs(size - PRINTED_SIZE) for size in (opened, base)) < about,
        f"""
        the base oscillation goes to ±{base:.3f} mm and the whole output to ±{opened:.3f} mm; the whole output
        of the loop with the drive as reference goes to ±{closed:.3f} mm
        """,
        method="exact simulation, 1.5 mm at 100 Hz, gap 40 µm: open loop settled, closed loop from rest",
        second=harmonic_in_open_loop(known, 1),
        slip=made_here(LOOP_CLOSED, by_closed),
        item="-0.001 to 0.001 m, output of the open loop",
        certainty=Certainty.READING,
    )


def line_part(known: Evidence, label: str) -> ClaimPart:
    """Return the part on the line at the limit cycle's frequency, which only the closed loop has."""
    opened, closed = open_loop(known), known.motion.closed.reference.from_rest
    cycle = known.orbits.friction.stable
    order = round(cycle.frequency / DRIVE_FREQUENCY)
    nearest = DRIVE_FREQUENCY * order
    decay = max(mode.eigenvalue.real for mode in known.numbers.modes)
    return assertion(
        label,
        "the open loop has a line at the frequency of the limit cycle",
        decay >= 0 or abs(nearest - cycle.frequency) < NEAR,
        rf"""
        backlash repeats with the drive, and behind it every free motion decays as $e^{{{decay:.0f}\,t}}$ or
        faster: what stays are multiples of 100 Hz, the nearest at {nearest:.0f} Hz with
        {1e6 * opened.harmonics[order]:.1f} µm. With the drive as reference there is one at
        {closed.frequency:.2f} Hz with {1e6 * closed.line:.0f} µm
        """,
        method="periodic input of a stable linear system; exact simulation",
        second=harmonic_in_open_loop(known, order),
        slip=made_here(LOOP_CLOSED, abs(closed.frequency - cycle.frequency) < NEAR),
        item="the open loop shows the limit cycle of the closed loop",
        certainty=Certainty.PROVEN,
    )


@claim("txt-5.2.1-open-loop-output")
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
    yield text(f"""
        Behind backlash of 40 µm the open loop passes a drive of 1.5 mm nearly unchanged, with harmonics of
        {1e6 * opened.ripple:.0f} µm that hardly show in it. The loop with the output fed back has
        {1e3 * closed.base:.2f} mm at 100 Hz and on it the limit cycle with {1e3 * closed.line:.2f} mm, so its
        whole output goes to about the printed ±1 mm. But the text takes ±1 mm for the base and says that it
        corresponds to the drive; read as a rough 1.5 mm, it is that of the open loop. The second line of the
        spectrum, [at the limit cycle](#txt-5.2.1-open-loop-peak), speaks for the loop with a reference.
        Figure C.5, which would decide it, was not at hand.

        If the loop has a reference, figures 5.11 and 5.12b say nothing on the open loop, nor on the
        experiment.
    """)


@claim("txt-5.2.1-open-loop-peak")
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
    line = known.motion.closed.reference.from_rest.frequency
    yield text(f"""
        Without feedback there is no limit cycle: a stable linear system behind play ends with the drive's
        period, whatever its start, and play adds odd harmonics only. The same two blocks give two lines, at
        100 Hz and near {line:.0f} Hz, when the output is subtracted from the drive. If figure C.5, which was
        not at hand, shows that feedback, the lines are right and the name open loop is wrong.

        In neither case does it follow that a limit cycle may be evaluated in the open loop as well. Chapter 7
        and the reading of the experiment's peaks use it.
    """)


@claim("txt-5.2.1-drive-amplitude")
def drive_amplitude(known: Evidence) -> Record:
    orbit, runs = known.orbits.friction.stable, known.motion.closed.reference.from_limit_cycle
    lines = [run.line for run in runs]
    references = [steps(run.amplitude, DRIVE_FREQUENCY) for run in runs]
    frequencies = [run.frequency if run.line else orbit.frequency for run in runs]
    in_steps = lines_in_steps(orbit, LARGE_GAP, references, frequencies)
    seen = [f"{1e6 * run.line:.1f} µm" if run.line else "none" for run in runs]
    item = "the drive's amplitude does not alter the limit cycle"
    yield assertion(
        "open loop",
        "there is a limit cycle under the drive",
        max(mode.eigenvalue.real for mode in known.numbers.modes) >= 0,
        "what is seen repeats with the drive; see the harmonics in figure E.2",
        method="periodic input of a stable linear system",
        second=open_loop_repeats(known),
        item=item,
        certainty=Certainty.PROVEN,
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
        item=item,
        certainty=Certainty.READING,
    )
    means = "steps of 20 µs, with SciPy's matrix exponential"
    yield assertion(
        "the same, up to 1.5 mm",
        statement,
        _unaltered(lines[:3]),
        f"it falls by {100 * (1 - lines[2] / lines[0]):.1f} %",
        method=method,
        second=close(means, in_steps[2], lines[2], 0.005),
        item=item,
        certainty=Certainty.READING,
    )
    yield text(f"""
        Read as it stands, for the open loop, there is no limit cycle that could keep its amplitude. Read for
        the closed loop with the drive as reference, the statement holds up to 1.5 mm,
        {DRIVE_AMPLITUDE / LARGE_GAP:.1f} gaps; a drive of 15 mm puts the limit cycle out. A drive smaller
        than half of the gap cannot start it from rest.

        The conclusion of chapter 7 holds for weak drives of a closed loop, not for the trimmer's.
    """)


def _unaltered(lines: Sequence[float]) -> bool:
    return max(lines) - min(lines) < UNALTERED * max(lines)
