"""Sixth question: how unpleasant it is."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.future_work.marked import marked
from report.judging.parts import close, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.future_work.felt import CALM, CALM_FORCE, FELT, FORCES, SPEED
from report.numbers.independent.harmonics import BY_THE_PIN, displacements
from report.numbers.thesis import DRIVE_AMPLITUDE
from report.pages.drawing.style import LINES, panels
from report.twin.observation import Observed, SectionRecord, observation
from trimmer import TrimmerParameters
from trimmer.thesis import TrimmerBody

NUMBERS: Final = "report/numbers/future_work/felt.py"
ACTION, DAY = 2.5, 8.0
"""Daily exposure from which directive 2002/44/EC asks for action, m/s², and the hours that it refers to."""
USE: Final = 1 / 6
"""A long use of a trimmer in a day, hours."""
TABLE: Final = {100.0: 0.160, 10**2.1: 0.127}
"""Factors of ISO 5349-1:2001, table A.2, by the exact centre frequency of the third octave, Hz."""
OF_TABLE: Final = 0.01
SMALL: Final = 60e-6
TITLE: Final = "Friction is felt, and 150 Hz more than 110 Hz; small play is not."
MICRO: Final = 1e6


def cells(force: float) -> list[list[Any]]:
    """Return speed, gap, friction, kind, weighted and plain rms of the cells with one friction."""
    return [row for row in FELT.read()["map"] if row[2] == force]


def points_of(rows: list[list[Any]]) -> list[tuple[float, float, str]]:
    """Return gap in micrometres, weighted acceleration, and kind of motion of each cell."""
    return [(MICRO * row[1], row[4], row[3]) for row in rows]


def weighted_by_hand() -> float:
    """Return the weighted rms of the housing without play and friction, m/s², from matrices and table."""
    parameters, omega = TrimmerParameters.thesis(), 2 * np.pi * SPEED
    spring = (parameters.k2 + 1j * omega * parameters.c2) * DRIVE_AMPLITUDE
    moved = displacements(parameters, omega, spring * BY_THE_PIN)[TrimmerBody.HOUSING.index]
    factor = np.exp(np.interp(np.log(SPEED), np.log(list(TABLE)), np.log(list(TABLE.values()))))
    return float(abs(moved) * omega**2 / np.sqrt(2) * factor)


@observation("future-felt-answer", source=NUMBERS, title=TITLE)
def answer(_: Evidence) -> Observed:
    every = FELT.read()["map"]
    worst = max(every, key=lambda row: row[4])
    still, rubbing = cells(0.0)[0][4], cells(FORCES[-1])[0][4]
    added = max(row[4] / cells(force)[0][4] for force in FORCES for row in cells(force) if row[1] <= SMALL)
    beyond = max(every, key=lambda row: row[4] / cells(row[2])[0][4])
    calm, usual = FELT.read()["calm"], cells(CALM_FORCE)
    yield text(f"""
        Weighted as ISO 5349-1 does for the hand, the housing of the trimmer driven at {SPEED:.0f} Hz has
        {still:.2f} m/s² without play and friction. {FORCES[-1]:.0f} N of friction make it {rubbing:.2f} m/s²;
        play up to {MICRO * SMALL:.0f} µm adds at most {added - 1:.0%} at any friction. Larger play can make
        it {beyond[4] / cells(beyond[2])[0][4]:.1f} times as large, at {MICRO * beyond[1]:.0f} µm with
        {beyond[2]:g} N. The largest of {len(every)} cells is {worst[4]:.1f} m/s², with
        {MICRO * worst[1]:.0f} µm and {worst[2]:g} N.
        The action value of {ACTION} m/s² over {DAY:.0f} hours is {ACTION * np.sqrt(DAY / USE):.0f} m/s² for
        {60 * USE:.0f} minutes a day: no cell comes near. {CALM:.0f} Hz, where the motor is calm, is felt
        more than {SPEED:.0f} Hz: {calm[0][4]:.2f} against {usual[0][4]:.2f} m/s² without play and with
        {CALM_FORCE} N.
    """)
    yield so("friction counts for more than small play", rubbing / still > added)
    yield so("the action value for a long use", worst[4] < 0.2 * ACTION * np.sqrt(DAY / USE))
    yield so("both speeds at each gap", tuple(a[4] > b[4] for a, b in zip(calm, usual, strict=True)))


@figure("future-felt")
def drawing(_: Evidence) -> Figure:
    """Draw the weighted acceleration over the gap: by friction, and at two speeds."""
    drawn, (friction, speed) = panels(3.2, 1, 2, sharey=True)
    for force, line in zip(FORCES, (*LINES, *LINES), strict=False):
        marked(friction, points_of(cells(force)), f"{force:g} N", line)
    friction.set(xlabel="gap [µm]", ylabel="weighted [m/s²]", title=f"at {SPEED:.0f} Hz", ylim=(0, 4.6))
    friction.legend(loc="upper left", ncols=2)
    for rows, label, line in zip(
        (cells(CALM_FORCE), FELT.read()["calm"]), (SPEED, CALM), LINES, strict=False
    ):
        marked(speed, points_of(rows), f"{label:.0f} Hz", line)
    speed.set(xlabel="gap [µm]", title=f"with {CALM_FORCE} N")
    speed.legend(loc="upper left")
    return drawn


@observation("future-felt-how", source=NUMBERS, title="How it was computed.")
def how(_: Evidence) -> Observed:
    yield text("""
        From rest to the exact periodic motion, or to one that does not repeat and is watched for some drive
        periods; the acceleration of the housing is weighted by $W_h$ line by line up to 3 kHz, and the root
        of the sum of squares taken.
    """)
    yield close(
        "without play and friction: matrices written by hand, and the standard's table between its lines",
        cells(0.0)[0][4],
        weighted_by_hand(),
        OF_TABLE,
    )


@observation("future-felt-limits", source=NUMBERS, title="Limits.")
def limits(known: Evidence) -> Observed:
    p = known.numbers.parameters
    yield text(f"""
        No hand holds this housing: the numbers of the models of ISO 10068 could not be read, and none was
        made up. With {1e3 * p.m3:.0f} g in Listing A.1 the housing is far lighter
        than any hand, so a hand will change what is felt. One direction of three is
        modelled. $W_h$ weighs the risk of injury, not how unpleasant a vibration is. Friction is between
        cutter and guard alone.
    """)
    yield so("mass of the housing against that of the others", p.m3 < min(p.m1, p.m4))


SECTION: Final = SectionRecord("future-felt", "How it feels", (answer, drawing, how, limits))
