"""First question: friction that is compensated."""

from typing import Any, Final

import numpy as np
from matplotlib.figure import Figure

from report.data.figures import figure
from report.future_work.marked import marked
from report.judging.parts import close, so
from report.judging.record import text
from report.numbers.evidence import Evidence
from report.numbers.future_work.compensation import COMPENSATION, FRICTION, GAP, HIGHEST, PUSHES, TOO_MUCH
from report.numbers.independent.loop_with_friction import cycles_at
from report.pages.drawing.style import BLACK, LINES, panels
from report.twin.observation import Observed, SectionRecord, observation
from trimmer.arrays import Reals

NUMBERS: Final = "report/numbers/future_work/compensation.py"
HALF: Final = 0.5
MICRO: Final = 1e6
ALIKE: Final = 1e-4  # Of amplitudes, which depend steeply on the frequency that is kept
EVERY: Final = 4
WAYS: Final = {"exact": "exactly", "pin": "by the pin's velocity"}


def of_cycles(known: Evidence) -> tuple[Reals, Reals, Reals, np.ndarray[Any, np.dtype[np.bool_]]]:
    """Return share compensated, frequency, Hz, amplitude in gaps and stability of the exact limit cycles."""
    frequency, amplitude, force = np.array(COMPENSATION.read()["cycles"]).T
    return 1 - force * GAP / FRICTION, frequency, amplitude, frequency > known.twin.loop.largest.frequency


def amplitudes_at(known: Evidence, share: float) -> tuple[float, float]:
    """Return the amplitudes in gaps of the stable and the unstable limit cycle with a share compensated."""
    shares, _, amplitude, stable = of_cycles(known)
    pairs = ((shares[chosen], amplitude[chosen]) for chosen in (stable, ~stable))
    first, second = (float(np.interp(share, at[np.argsort(at)], of[np.argsort(at)])) for at, of in pairs)
    return first, second


def fold(known: Evidence) -> float:
    """Return the share from which on there are limit cycles."""
    return 1 - known.twin.loop.largest.force_per_gap * GAP / FRICTION


def in_twin(way: str) -> list[list[Any]]:
    """Return the rows of the twin that is compensated in a way."""
    return [row for row in COMPENSATION.read()["twin"] if row[1] == way]


def released(share: float) -> list[tuple[float, float]]:
    """Return frequency, Hz, and amplitude in gaps of what motions become that begin with ``PUSHES``."""
    return [(row[2], row[3]) for row in COMPENSATION.read()["released"] if row[0] == share]


@observation("future-compensation-answer", source=NUMBERS, title="Friction does hide limit cycles.")
def answer(known: Evidence) -> Observed:
    least, (half, small), full = fold(known), amplitudes_at(known, HALF), known.orbits.friction
    (low, shaken), _ = released(TOO_MUCH[0])
    exact = in_twin("exact")
    of_gap = [MICRO * GAP * each.amplitude for each in (full.stable, full.unstable)]
    yield text(f"""
        With the {MICRO * GAP:.0f} µm of section 6.4 and {FRICTION:.0f} N the thesis's loop has no limit
        cycle. Two come back when {least:.1%} of the friction is compensated. With half of it compensated
        there is a stable one of {MICRO * GAP * half:.0f} µm and an unstable one of
        {MICRO * GAP * small:.0f} µm, with all of it they have {of_gap[0]:.0f} and {of_gap[1]:.0f} µm. With
        more than all of it compensated, rest is unstable as well: {TOO_MUCH[0] - 1:.0%} too much makes the
        loop hum at {low:.0f} Hz with {MICRO * GAP * shaken:.0f} µm, and {TOO_MUCH[1] - 1:.0%} too much
        drives it from a slight push to the large limit cycle.

        The driven trimmer has no limit cycle that could come back. There less friction makes the motion
        chaotic and the motor calmer: {exact[0][5]:.0f} m/s² without, {exact[-1][5]:.0f} m/s² with full
        compensation.
    """)
    yield so("no limit cycle without compensation, two with half of it", (0 < least < HALF, small < half))
    small_push, large_push = released(TOO_MUCH[1])
    yield so(
        f"motions of 2 s that begin with {PUSHES[0]:g} and {PUSHES[1]:g} m/s, {TOO_MUCH[1] - 1:.0%} too much",
        (abs(small_push[1] / large_push[1] - 1) < ALIKE, shaken < full.unstable.amplitude),
    )
    yield so("kinds of motion of the twin", (exact[0][2], exact[-1][2]) == ("periodic", "chaotic"))


@figure("future-compensation")
def drawing(known: Evidence) -> Figure:
    """Draw limit cycles of the loop, and the motor's acceleration in the twin, over what is compensated."""
    drawn, (loop, motor) = panels(3.2, 1, 2)
    shares, _, amplitude, stable = of_cycles(known)
    for chosen, look, label in ((stable, "-", "stable"), (~stable, ":", "unstable")):
        loop.semilogy(100 * shares[chosen], amplitude[chosen], color=BLACK, linestyle=look, label=label)
    balance = known.cycles.equivalent.in_place
    for side in (balance.stable, balance.unstable):
        at = 100 * (1 - side.force_per_gap[::EVERY] * GAP / FRICTION)
        loop.plot(at, side.amplitude[::EVERY], "x", color=BLACK, markersize=4, linestyle="none")
    for stays, face in ((True, BLACK), (False, "white")):
        rows = [row for row in COMPENSATION.read()["too much"] if row[3] is stays]
        at = np.array([[100 * row[0], row[2]] for row in rows]).T
        loop.plot(*at, "o", color=BLACK, markersize=4, markerfacecolor=face)
    loop.set(xlabel="compensated [%]", ylabel="amplitude [gaps]", title="the loop")
    loop.set(xlim=(0, 130), ylim=(0.2, 20))
    loop.legend(loc="upper left")
    for (way, words), line in zip(WAYS.items(), LINES, strict=False):
        rows = in_twin(way)
        marked(motor, [(100 * row[0], row[5], row[2]) for row in rows], words, line)
    motor.set(xlabel="compensated [%]", ylabel="motor [m/s²]", title="the driven trimmer", ylim=(0, None))
    motor.legend(loc="upper right")
    return drawn


@observation("future-compensation-how", source=NUMBERS, title="How it was computed.")
def how(known: Evidence) -> Observed:
    predicted = 1 - known.cycles.equivalent.in_place.merger.force_per_gap * GAP / FRICTION
    yield text(f"""
        If a share $s$ is compensated, friction of $(1 - s) F$ is left between cutter and guard. With $s$
        above one it turns into a push along the velocity. Curves: linear equations from one turn of the pin
        to the next; dots: exact orbits by shooting; crosses: harmonic balance with play and friction each in
        its place, which puts the first limit cycle at {predicted:.1%}. In the twin at 110 Hz either friction
        is lowered as such, or a force $s F$ with the sign of the pin's velocity acts on cutter and guard,
        with its odd harmonics up to the {HIGHEST}th.
    """)
    rows = [row for row in COMPENSATION.read()["too much"] if row[3]]
    for (share, _, amplitude, _), again in zip(
        rows, cycles_at(known.numbers.parameters, [row[1] for row in rows]), strict=True
    ):
        yield close(f"amplitude with {share - 1:.0%} too much, both ways", amplitude, again.amplitude, ALIKE)
    yield close(
        "largest friction, on the curve and by minimisation",
        1 - min(of_cycles(known)[0]),
        1 - fold(known),
        1e-3,
    )


@observation("future-compensation-limits", source=NUMBERS, title="Limits.")
def limits(known: Evidence) -> Observed:
    pin, exact = in_twin("pin"), in_twin("exact")
    at_half = [rows[len(exact) // 2][5] for rows in (pin, exact)]
    yield text(f"""
        Nothing drives the loop, so a feed-forward from a reference has nothing to go by there: the curves are
        those of a compensation that measures the velocity without delay. A trimmer has no actuator between
        cutter and guard; the motor would have to do it through the play. With the pin's velocity in place of
        the blade's the twin keeps much of the effect, {at_half[0]:.0f} for {at_half[1]:.0f} m/s² with half of
        the friction compensated, but the motions between {exact[5][0]:.0%} and {exact[7][0]:.0%} differ in
        kind. Motions with too much compensation were followed for 2 s; the orbit of the hum is unstable, so
        it may not last. The twin began at rest.
    """)
    kinds = [[row[2] for row in rows[5:8]] for rows in (pin, exact)]
    yield so("kinds of motion of both ways in the twin", kinds[0] != kinds[1])


SECTION: Final = SectionRecord("future-compensation", "Friction compensated", (answer, drawing, how, limits))
