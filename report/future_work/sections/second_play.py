"""Third question: a second play."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.future_work.marked import marked
from report.judging.parts import close, small, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.future_work.second_play import (
    GAP,
    ORDER,
    SEAT_GAPS,
    SECOND_PLAY,
    SLIDER_MASS,
    SPEEDS,
    STIFFER,
    multiplied,
)
from report.pages.drawing.style import BLACK, LINES, panels
from report.twin.observation import Observed, SectionRecord, observation
from trimmer.arrays import Reals

NUMBERS: Final = "report/numbers/future_work/second_play.py"
SAMPLES: Final = 2000
MICRO, MILLI = 1e6, 1e3
FREQUENCIES_ALIKE, AMPLITUDES_ALIKE = 1e-5, 1e-4
"""Of harmonic balance up to ``ORDER`` and exact orbits."""


def in_loop(way: str) -> Reals:
    """Return ratio, frequency (Hz), amplitudes of pin and seat in gaps, (n, 4)."""
    return np.array([[row[0], *row[2:]] for row in SECOND_PLAY.read()["loop"] if row[1] == way])


def in_twin(kind: str, speed: float) -> list[list[Any]]:
    """Return the rows of the twin with a ``seat`` or a ``gear``."""
    rows: list[list[Any]] = SECOND_PLAY.read()[f"{kind} {speed:g} Hz"]
    return rows


def behind_play(wave: Reals, gap: float) -> Reals:
    """Return what friction-controlled play makes of samples, from the middle of its gap."""
    position, followed = 0.0, []
    for value in wave.tolist():
        position = min(max(position, value - gap / 2), value + gap / 2)
        followed.append(position)
    return np.array(followed)


@observation("future-second-answer", source=NUMBERS, title="It changes little.")
def answer(known: Evidence) -> Observed:
    one, exact = known.cycles.friction.stable, known.orbits.friction.stable
    frequency, amplitude = multiplied(0.5, one)
    seats = in_loop("balance")
    (usual, *gears), (calm, *_) = (in_twin("gear", speed) for speed in SPEEDS)
    tight, wide = (in_twin("seat", SPEEDS[0])[at] for at in (0, -1))
    most = max(row[5] for row in gears) / usual[5] - 1
    yield text(f"""
        Two plays with friction, one directly behind the other, act as one play whose gap is the sum of both,
        so the limit cycle keeps its frequency and grows with the sum. Two describing functions multiplied, as
        a cascade suggests, miss that: for two equal plays they give {frequency:.1f} Hz and {amplitude:.2f}
        times the sum in place of {exact.frequency:.1f} Hz and {exact.amplitude:.2f}. Play between guard and
        housing, which section 6.3 leaves out, lowers the loop's {exact.frequency:.2f} Hz to
        {seats[-1, 1]:.2f} Hz and the amplitude by {1 - seats[-1, 2] / exact.amplitude:.1%}; beyond
        {2 * seats[-1, 3]:.2f} of the pin's play the guard no longer reaches the ends of its seat, and nothing
        changes any more.

        In the trimmer driven at {SPEEDS[0]:.0f} Hz with {MICRO * GAP:.0f} µm, a seat with
        {MICRO * wide[0]:.0f} µm shortens the stroke by {1 - wide[4] / tight[4]:.1%}; where a part of the play
        is in a gear before the bridge, the motor's {usual[5]:.0f} m/s² rise by at most {most:.0%}.
    """)
    wave = 3 * np.sin(2 * np.pi * np.arange(SAMPLES) / SAMPLES * 2)
    twice = behind_play(behind_play(wave, 0.7), 0.3)
    yield small(
        "two plays and one play of both, sample by sample", abs(twice - behind_play(wave, 1.0)).max(), 1e-12
    )
    yield so(
        "wide seats are not reached", (float(np.ptp(seats[-2:, 1])) < 1e-6, 2 * seats[-1, 3] < seats[-1, 0])
    )
    yield so(
        "changes of the stroke and of the motor", (0 < 1 - wide[4] / tight[4] < 0.1, most < 0.1, calm[5] > 0)
    )


@figure("future-second")
def drawing(_: Evidence) -> Figure:
    """Draw the loop's frequency over the play of the seat, and the twin's stroke."""
    drawn, (loop, stroke) = panels(3.2, 1, 2)
    balance, exact = in_loop("balance"), in_loop("exact")
    loop.plot(balance[:, 0], balance[:, 1], **LINES[0], label=f"balance up to the {ORDER}th")
    loop.plot(exact[:, 0], exact[:, 1], "o", color=BLACK, linestyle="none", markersize=4, label="exact")
    loop.set(xlabel="play of the seat / of the pin", ylabel="frequency [Hz]", title="the loop")
    loop.ticklabel_format(useOffset=False)
    loop.legend(loc="upper right")
    for speed, line in zip(SPEEDS, LINES, strict=False):
        rows = in_twin("seat", speed)
        points = [(MICRO * row[0], MILLI * row[4], row[2]) for row in rows]
        marked(stroke, points, f"{speed:.0f} Hz", line)
    stroke.set(xlabel="play of the seat [µm]", ylabel="stroke [mm]", title="the driven trimmer")
    stroke.legend(loc="upper left", bbox_to_anchor=(0.0, 0.67))
    return drawn


@observation("future-second-how", source=NUMBERS, title="How it was computed.")
def how(_: Evidence) -> Observed:
    yield text(f"""
        In the loop the guard's spring gets a dead zone: with play at the pin a loop of two elements, solved
        by balance of the odd harmonics up to the {ORDER}th and by shooting. In the twin the seat is a second
        contact with the guard's stiffness and damping. The gear is one too, {STIFFER:.0f} times as stiff as
        the bridge, before a slider of {1e3 * SLIDER_MASS:.1f} g; gear and bridge have {MICRO * GAP:.0f} µm
        together.
    """)
    balance = {row[0]: row for row in in_loop("balance").tolist()}
    for ratio, frequency, amplitude, _ in in_loop("exact").tolist():
        found = balance[ratio]
        yield close(f"frequency with {ratio:g}, balance and exact", found[1], frequency, FREQUENCIES_ALIKE)
        yield close(f"amplitude with {ratio:g}, balance and exact", found[2], amplitude, AMPLITUDES_ALIKE)


@observation("future-second-limits", source=NUMBERS, title="Limits.")
def limits(_: Evidence) -> Observed:
    other = [row for speed in SPEEDS for row in in_twin("seat", speed) if row[2] != "periodic"]
    yield text(f"""
        Size and stiffness of these plays are assumed; the thesis gives none. In the loop only the stable
        limit cycle was found by both ways; the unstable one was not sought. In the twin, from rest,
        {len(other)} of {2 * len(SEAT_GAPS)} seats led to a motion not seen to repeat (open dots), where
        neighbours do. Friction in gear and seat is left out.
    """)
    yield so(
        "one motion for each seat in the loop", len(in_loop("balance")) == len(set(in_loop("balance")[:, 0]))
    )


SECTION: Final = SectionRecord("future-second", "A second play", (answer, drawing, how, limits))
