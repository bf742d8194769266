"""Fifth question: M/D of the load from a measured limit cycle."""

from __future__ import annotations

from typing import Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.judging.parts import small, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.future_work.load import LOAD, MEASURED, RECORDS, SAMPLES, TOLERANCE
from report.numbers.independent.harmonics import BY_THE_PIN, displacements
from report.pages.drawing.style import BLACK, LINES, panels
from report.twin.observation import Observed, SectionRecord, observation
from trimmer import TrimmerParameters, ViscousBacklash
from trimmer.arrays import Reals

NUMBERS: Final = "report/numbers/future_work/load.py"
PHASES: Final = 2**14
EVERY: Final = 9
"""Every so many solutions one is held against sums over the waveform."""
BALANCED: Final = 1e-5
EXAMPLE: Final = 740.0
MILLI: Final = 1e3


def curves(stable: bool) -> Reals:
    """Return M/D, s, frequency, Hz, and amplitude in gaps of stable or unstable limit cycles, (n, 3)."""
    return np.array([row[:3] for row in LOAD.read()["curves"] if row[3] is stable])


def interval(frequency: float, record: float) -> tuple[float, float]:
    """Return lowest and highest M/D, s, for a frequency, Hz, from a record of a length, s."""
    rows = {(at, of): (low, high) for at, of, low, high in LOAD.read()["intervals"]}
    low, high = rows[frequency, record]
    return low, float("inf") if high is None else high


def imbalance(time: float, frequency: float, amplitude: float) -> float:
    """Return |1 + N G| with N summed over the waveform and G from matrices that were written by hand."""
    omega, parameters = 2 * np.pi * frequency, TrimmerParameters.thesis()
    phases = 2 * np.pi * np.arange(PHASES) / PHASES
    wave = ViscousBacklash(1.0, time).waveform(phases, amplitude, omega)
    gain = np.fft.rfft(wave)[1] * 2j / PHASES / amplitude
    moved = displacements(parameters, omega, parameters.k2 * BY_THE_PIN)
    return float(abs(1 + gain * (moved[1] - moved[3])))


@observation(
    "future-load-answer",
    source=NUMBERS,
    title="A frequency tells M/D, but only in a narrow band and from a long record.",
)
def answer(_: Evidence) -> Observed:
    stable = curves(True)
    short, longer = interval(EXAMPLE, RECORDS[0]), interval(EXAMPLE, RECORDS[1])
    ends = np.array(LOAD.read()["shifted"])
    yield text(f"""
        Any M/D gives one stable limit cycle, between {stable[0, 1]:.1f} Hz (friction-controlled) and
        {stable[-1, 1]:.1f} Hz (inertia-controlled), and its frequency rises with M/D all the way. If
        {EXAMPLE:.0f} Hz were measured, a record of {RECORDS[1]:.0f} s would give {MILLI * longer[0]:.2f} to
        {MILLI * longer[1]:.2f} ms; one of {RECORDS[0]:.1f} s, as the thesis has them, {MILLI * short[0]:.2f}
        to {MILLI * short[1]:.2f} ms. The parameters of the trimmer count for more: if each is off by at most
        {TOLERANCE:.0%}, the lower end of the band lies anywhere between {ends[:, 0].min():.0f} and
        {ends[:, 0].max():.0f} Hz, and the same {EXAMPLE:.0f} Hz may then mean nearly any M/D.
    """)
    yield so("the frequencies of the stable limit cycles rise with M/D", tuple(np.diff(stable[:, 1]) > 0))
    width = np.diff(ends).mean()
    yield so("the shift by parameters against the width of the band", np.ptp(ends[:, 0]) > 0.5 * width)


@figure("future-load")
def drawing(_: Evidence) -> Figure:
    """Draw frequency and amplitude over M/D, and intervals of M/D for measured frequencies."""
    drawn, (frequency, amplitude) = panels(3.2, 1, 2)
    stable = curves(True)
    frequency.semilogx(MILLI * stable[:, 0], stable[:, 1], **LINES[0])
    for number, (record, width) in enumerate(zip(RECORDS, (1.0, 2.5, 5.0), strict=True)):
        for at in MEASURED:
            low, high = interval(at, record)
            ends = MILLI * np.clip([low, high], *stable[[0, -1], 0])
            label = f"{record:g} s" if at == MEASURED[0] else None
            frequency.plot(
                ends,
                (at, at),
                color=BLACK,
                linestyle="-",
                linewidth=width,
                alpha=0.35 + 0.3 * number,
                label=label,
            )
    frequency.set(xlabel="M/D [ms]", ylabel="frequency [Hz]", title="stable limit cycle")
    frequency.legend(title="record", loc="upper left")
    amplitude.semilogx(MILLI * stable[:, 0], stable[:, 2], **LINES[0])
    amplitude.set(xlabel="M/D [ms]", ylabel="amplitude [gaps]", title="stable limit cycle", ylim=(0, None))
    return drawn


@observation("future-load-how", source=NUMBERS, title="How it was computed.")
def how(_: Evidence) -> Observed:
    rows = [row[:3] for row in LOAD.read()["curves"][::EVERY]]
    yield text(f"""
        Equation 5.11, $1 + N(A, \\omega M/D) G(j\\omega) = 0$, solved for amplitude and frequency at each M/D
        by a search that misses no solution, and backwards for M/D at the ends of what a frequency leaves
        open, half a bin $1/(2T)$ to either side. {SAMPLES} sets of parameters were drawn for their tolerance.
    """)
    yield small(
        "every ninth solution, with sums over the waveform and matrices written by hand",
        max(imbalance(*row) for row in rows),
        BALANCED,
    )


@observation("future-load-limits", source=NUMBERS, title="What no such measurement can tell.")
def limits(known: Evidence) -> Observed:
    fold, stable, unstable = known.twin.loop.largest.frequency, curves(True), curves(False)
    reach = unstable[:, 1].min(), unstable[:, 1].max()
    yield text(f"""
        M and D apart: only their ratio enters. The gap: no frequency depends on it, and an amplitude tells it
        only once M/D is known. M/D near either end, where the frequency hardly changes: there is a bound and
        no value. The unstable limit cycles, between {reach[0]:.0f} and {reach[1]:.0f} Hz, are not seen. Dry
        friction between cutter and guard lowers the frequency too, down to {fold:.0f} Hz before the limit
        cycle ends; so what lies below {stable[0, 1]:.1f} Hz, as the 733.3 Hz of section 5.2 do, fits friction
        and no M/D. Such a measurement needs the loop of section 5.2, closed by a controller: the driven
        trimmer has no limit cycle to measure.
    """)
    yield so("the frequency at the fold lies below the band", (fold < stable[0, 1], reach[1] < stable[0, 1]))


SECTION: Final = SectionRecord("future-load", "M/D from a measurement", (answer, drawing, how, limits))
