"""Second question: what the higher harmonics change."""

from __future__ import annotations

from typing import Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.judging.comparisons.printed import power_of
from report.judging.parts import close, small, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.future_work.harmonics import ELEMENTS, HARMONICS, ORDERS
from report.pages.drawing.style import panels
from report.twin.observation import Observed, SectionRecord, observation
from trimmer import FrictionBacklash
from trimmer.arrays import Reals

NUMBERS: Final = "report/numbers/future_work/harmonics.py"
SHOWN: Final = (1, 3, 5, 7, 9)
BAND: Final = 1.5
"""Width of the band about a prediction, in changes that the third harmonic makes."""
PHASES: Final = 2**14
LINES_CLOSE: Final = 1e-6
"""Accuracy of sums over ``PHASES`` points of a waveform with corners."""
ALIKE: Final = 1e-6


def of(name: str, stable: bool) -> Reals:
    """Return order, frequency, Hz, and amplitude in gaps of the solutions for one limit cycle, (n, 3).

    The first row is the exact orbit, as order 0.
    """
    rows = HARMONICS.read()["solutions"]
    return np.array([row[2:] for row in rows if row[0] == name and row[1] is stable])


CYCLES: Final = tuple((name, stable) for name in ELEMENTS for stable in (True, False))


def errors(name: str, stable: bool) -> Reals:
    """Return order and relative errors of frequency and amplitude, (n, 3)."""
    exact, *solved = of(name, stable)
    return np.array([[order, *(abs(found / exact[1:] - 1))] for order, *found in solved])


def shares_of_band() -> Reals:
    """Return errors of first-harmonic predictions over the changes by the third harmonic, (4, 2)."""
    tables = (of(*each) for each in CYCLES)
    return np.array(
        [abs((first - exact) / (first - third))[1:] for exact, first, third, *_ in map(list, tables)]
    )


@observation(
    "future-harmonics-answer", source=NUMBERS, title="They change little, and the third says how much."
)
def answer(_: Evidence) -> Observed:
    exact, first, third, *_rest = of("friction", True)
    band = BAND * abs(third - first)
    largest = float(errors("inertia", False)[0, 2])
    ninth = max(float(errors(*each)[SHOWN.index(9), 1]) for each in CYCLES)
    yield text(f"""
        The describing function puts the stable limit cycle with friction-controlled play at {first[1]:.2f} Hz
        and {first[2]:.3f} gaps; with the third harmonic in the balance it is {third[1]:.2f} Hz and
        {third[2]:.3f} gaps, and the exact orbit is at {exact[1]:.2f} Hz and {exact[2]:.3f} gaps. A band of
        {BAND} times the change by the third harmonic on either side, here {first[1]:.2f} ± {band[1]:.2f} Hz
        and {first[2]:.3f} ± {band[2]:.3f} gaps, holds the exact values of all four limit cycles. The
        describing function errs most, by {largest:.0%}, in the amplitude of the unstable one with
        inertia-controlled play. With harmonics up to the ninth the relative error of all frequencies is at
        most {power_of(ninth)}.
    """)
    yield so("frequency and amplitude of four exact orbits lie in the bands", shares_of_band().max() < BAND)


@figure("future-harmonics")
def drawing(_: Evidence) -> Figure:
    """Draw the describing functions over the amplitude, and the errors over the order."""
    drawn, (functions, convergence) = panels(3.2, 1, 2)
    amplitudes = 0.5 + np.geomspace(1e-3, 30, 400)
    for order in SHOWN:
        gains = FrictionBacklash(1.0).describing_function(amplitudes, 1.0, order)
        functions.loglog(amplitudes, abs(np.asarray(gains)), label=f"{order}")
    functions.set(xlabel="amplitude [gaps]", ylabel="gain", title="of the harmonics", ylim=(1e-5, 2))
    functions.legend(loc="lower right", ncols=2)
    for name, stable in CYCLES:
        table = errors(name, stable)
        marker = {"friction": "o", "inertia": "s"}[name]
        label = f"{name}, {'stable' if stable else 'unstable'}"
        look = {"marker": marker, "markersize": 4, "markerfacecolor": None if stable else "white"}
        convergence.loglog(table[:, 0], np.maximum(table[:, 2], 1e-9), label=label, **look)
    convergence.set(xlabel="highest harmonic", ylabel="relative error", title="of the amplitude")
    convergence.set_xticks(ORDERS, [str(order) if order not in (9, 31) else "" for order in ORDERS])
    convergence.minorticks_off()
    convergence.legend(loc="lower left")
    return drawn


@observation("future-harmonics-how", source=NUMBERS, title="How it was computed.")
def how(known: Evidence) -> Observed:
    yield text("""
        Left, the gains $|N_n|$ from the pin's sine to the harmonics of order $n$ behind friction-controlled
        play, the higher-order describing functions of Nuij, Bosgra and Steinbuch; even ones are zero, as the
        play is odd. Right, $c_n + G(jn\\omega) U_n(c) = 0$ is solved for all odd $n$ up to an order, where
        $U_n$ is the harmonic behind the play of the whole input, not of its first harmonic alone; the exact
        orbits are found by shooting.
    """)
    gap = FrictionBacklash(1.0)
    lines = np.fft.rfft(gap.waveform(2 * np.pi * np.arange(PHASES) / PHASES, 2.0)) * 2j / PHASES / 2.0
    apart = max(abs(complex(gap.describing_function(2.0, 1.0, order)) - lines[order]) for order in SHOWN)
    yield small("gains for two gaps, summed over the waveform", float(apart), LINES_CLOSE)
    amplitude, frequency = known.orbits.friction_by_durations
    last = of("friction", True)[-1]
    yield close("harmonics up to the 41st against durations of contact and flight", last[1], frequency, ALIKE)
    yield close("the same for the amplitude", last[2], amplitude, ALIKE)


@observation("future-harmonics-limits", source=NUMBERS, title="Limits.")
def limits(_: Evidence) -> Observed:
    yield text("""
        The band is an estimate, not a bound: it was held against these four limit cycles only. It says
        nothing of limit cycles that the describing function does not predict at all, nor of those with even
        harmonics. Amplitudes here are per gap, so that all gaps are answered at once; friction between cutter
        and guard is left out.
    """)
    yield so("the third harmonic alone leaves an error", shares_of_band().max() > 1)


SECTION: Final = SectionRecord("future-harmonics", "Higher harmonics", (answer, drawing, how, limits))
