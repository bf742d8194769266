"""Fourth question: the linear parameters at random."""

from typing import Any, Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.judging.parts import equal, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.future_work.load import response
from report.numbers.future_work.scatter import FACTORS, SAMPLES, SCATTER, drawn
from report.numbers.independent.loci import solutions
from report.pages.drawing.style import BLACK, LINES, panels
from report.twin.observation import Observed, SectionRecord, observation
from trimmer import TrimmerParameters
from trimmer.arrays import Reals

NUMBERS: Final = "report/numbers/future_work/scatter.py"
NARROW, _, WIDE, WIDEST = FACTORS
EVERY: Final = 15
"""Every so many sets of parameters the limit cycles are counted on a grid of frequencies too."""
DAMPED: Final = 0.1  # Damping ratio of the bridge below which the sets are counted by themselves


def rows_of(factor: float) -> list[list[Any]]:
    """Return numbers of all and of stable limit cycles, frequency and amplitude, of each set."""
    rows: list[list[Any]] = SCATTER.read()[f"samples {factor:g}"]
    return rows


def frequencies(factor: float) -> Reals:
    """Return the frequency of the stable limit cycle of each set that has one, Hz."""
    return np.array([row[2] for row in rows_of(factor) if row[1]])


def has_one(factor: float) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Return which sets have a stable limit cycle."""
    return np.array([row[1] > 0 for row in rows_of(factor)])


def of_bridge(parameters: TrimmerParameters) -> tuple[float, float]:
    """Return natural frequency, Hz, and damping ratio of the cutter on the bridge alone."""
    p = parameters
    return float(np.sqrt(p.k2 / p.m2) / (2 * np.pi)), float(p.c2 / (2 * np.sqrt(p.k2 * p.m2)))


def bridges(factor: float) -> Reals:
    """Return these of each set, (n, 2)."""
    return np.array([of_bridge(each) for each in drawn(factor)[1]])


def strongest(factor: float, column: int) -> list[tuple[str, float]]:
    """Return the parameters by falling rank correlation: in column 1 with existence, 2 with frequency."""
    rows = SCATTER.read()[f"ranks {factor:g}"]
    return sorted(((row[0], row[column]) for row in rows), key=lambda each: -abs(each[1]))


@observation(
    "future-scatter-answer", source=NUMBERS, title="Nearly all sets have a limit cycle; the bridge decides."
)
def answer(known: Evidence) -> Observed:
    counts = {factor: int(has_one(factor).sum()) for factor in FACTORS}
    narrow, bridge, one = frequencies(NARROW), bridges(WIDEST), has_one(WIDEST)
    low, high = np.quantile(narrow, [0.05, 0.95])
    (first, by_first), (second, by_second), (_, others), *_rest = strongest(NARROW, 2)
    weak = bridge[:, 1] < DAMPED
    yield text(f"""
        Of {SAMPLES} sets of parameters drawn within {NARROW - 1:.0%} all have exactly one stable limit cycle,
        nine tenths of them between {low:.0f} and {high:.0f} Hz. Within a factor of {WIDE:g} it is
        {counts[WIDE]} of {SAMPLES}, within a factor of {WIDEST:g} {counts[WIDEST]}, and never more than one.
        The frequency follows the bridge's stiffness and the cutter's mass, {first} and {second} (rank
        correlations {by_first:.2f} and {by_second:.2f}; all others at most {abs(others):.2f}). Whether there
        is one is decided by the bridge's damping ratio $c_2 / (2 \\sqrt{{k_2 m_2}})$,
        {of_bridge(known.numbers.parameters)[1]:.1%} in the thesis: none has one above
        {bridge[one, 1].max():.0%}; below {DAMPED:.0%} {int((weak & one).sum())} of {int(weak.sum())} have.
    """)
    stable = {row[1] for factor in FACTORS for row in rows_of(factor)}
    yield equal("stable limit cycles of one set", stable, {0, 1})
    yield so("all sets within the narrowest range have one", counts[NARROW] == SAMPLES)
    yield equal("parameters that decide the frequency", {first, second}, {"k2", "m2"})
    yield equal("parameter that decides whether there is one", strongest(WIDEST, 1)[0][0], "c2")


@figure("future-scatter")
def drawing(known: Evidence) -> Figure:
    """Draw frequencies over the natural frequency of the bridge, and which sets have a limit cycle."""
    drawn_, (frequency, damping) = panels(3.2, 1, 2)
    for factor, line in zip((WIDE, NARROW), LINES, strict=False):
        at = bridges(factor)[has_one(factor), 0]
        look = {"marker": ".", "markersize": 3, "linestyle": "none", "color": line["color"]}
        frequency.loglog(at, frequencies(factor), label=f"times or over {factor:g}", **look)
    ends = np.array([300.0, 1500.0])
    frequency.plot(ends, ends, color=BLACK, linestyle=":", label="natural frequency")
    frequency.set(xlabel="cutter on its bridge [Hz]", ylabel="limit cycle [Hz]", title="frequency")
    frequency.legend(loc="upper left")
    for axis in (frequency.xaxis, frequency.yaxis):
        axis.set_ticks([200, 500, 1000, 2000], ["200", "500", "1000", "2000"])
        axis.set_ticks([], minor=True)
    bridge, one = bridges(WIDEST), has_one(WIDEST)
    edges = np.geomspace(1e-4, 3, 24)
    sides = [100 * bridge[chosen, 1] for chosen in (one, ~one)]
    damping.hist(
        sides,
        bins=100 * edges,
        stacked=True,
        color=[LINES[0]["color"], "white"],
        edgecolor=BLACK,
        linewidth=0.6,
        label=["limit cycle", "none"],
    )
    damping.axvline(100 * of_bridge(known.numbers.parameters)[1], color=BLACK, linestyle="--")
    damping.set(xscale="log", xlabel="damping ratio of the bridge [%]", ylabel="sets", title="existence")
    damping.set_axisbelow(True)
    damping.legend(loc="upper left")
    return drawn_


@observation("future-scatter-how", source=NUMBERS, title="How it was computed.")
def how(_: Evidence) -> Observed:
    yield text(f"""
        All thirteen masses, stiffnesses and dampings were drawn independently, evenly in their logarithm,
        between the value of Listing A.1 divided by a factor and multiplied by it; harmonic balance with
        friction-controlled play by a search that misses no solution. Factors:
        {", ".join(f"{each:g}" for each in FACTORS)}.
    """)
    chosen = drawn(WIDE)[1][::EVERY]
    counted = [solutions(response(each), 0.0) for each in chosen]
    found = [row[0] for row in rows_of(WIDE)[::EVERY]]
    yield equal(f"solutions of every {EVERY}th set on a grid of 40 001 frequencies", counted, found)


@observation("future-scatter-limits", source=NUMBERS, title="Limits.")
def limits(known: Evidence) -> Observed:
    exact, predicted = known.orbits.friction.stable.frequency, known.cycles.friction.stable.frequency
    low, high = frequencies(NARROW).min(), frequencies(NARROW).max()
    yield text(f"""
        The scatter is assumed: the thesis gives no tolerances, and real parameters do not scatter
        independently. These are predictions; for the parameters of the thesis the exact orbit is
        {predicted - exact:.2f} Hz lower, far less than the {high - low:.0f} Hz over which the parameters
        spread it. Only sets without friction and with friction-controlled play were drawn. The driven trimmer
        has no limit cycle with any of them.
    """)
    yield so("error of the prediction against the scatter", abs(predicted - exact) < 0.01 * (high - low))


SECTION: Final = SectionRecord("future-scatter", "Parameters at random", (answer, drawing, how, limits))
