"""The thesis's loop after an impulse: which strength makes it oscillate (section 5.2.1).

Gap and impulse times one factor give the motion times that factor, so all depends on impulse over gap, in s:
the impulse is displacement of the pin (m) over time (s), and the model has a gap of one metre.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import control
import numpy as np
from scipy.integrate import solve_ivp

from trimmer import ClosedLoop, FrictionBacklash, simulate
from trimmer.arrays import Reals

GAPS = (1e-8, 2e-8, 3e-8)  # Gaps of figure 5.7, m
SHOWN = (1e-11, 4e-12)  # Impulses after which those are shown, m s
LONGEST = 0.16  # Length of a run that is shown, s
ABOVE, CHECKED = 1.05, 0.008
"""Impulse over the threshold, and time (s), for which the events are counted twice."""
LOWEST, HIGHEST = 1e-6, 1e3  # Range of impulses over gap that is tried, s
PER_DECADE = 2
DURATION = 0.7
"""Length of a run of the range, s: the largest impulse takes 0.5 s to die down to the limit cycle."""
SHORT = 0.04  # Length of a run that finds the threshold, s: 22 periods of the unstable limit cycle
WINDOW = 0.005  # End of a run in which an event shows that the motion goes on, s: more than two periods
ACCURACY: Final[dict[str, float]] = {"rtol": 1e-9, "atol": 1e-12, "max_step": 2e-5}
"""Of the integration; with longer steps (s) it steps over short contacts."""
HALVINGS = 40


@dataclass(frozen=True, eq=False)
class GapRun:
    """The loop with one of the thesis's gaps after an impulse."""

    gap: float  # m
    impulse: float  # m s
    times: Reals  # s
    output: Reals  # y, m
    amplitude: float  # Half of peak to peak at the end, m


@dataclass(frozen=True, eq=False)
class ImpulseNumbers:
    """What impulses do."""

    # The gaps of figure 5.7, each with the impulses ``SHOWN``, by impulse and then gap
    runs: tuple[GapRun, ...]
    impulses: Reals  # Impulse over gap, s, in rising order
    goes_on: tuple[bool, ...]  # Whether the motion still crosses the gap in the end
    threshold: float  # The impulse over gap that parts those that die out from those that go on, s
    peak: float  # Largest |y| in gaps after an impulse of a thousand thresholds, over that impulse, 1/s
    # Events within ``CHECKED`` after an impulse of ``ABOVE`` thresholds, and the same by SciPy
    counted: tuple[int, int]

    @property
    def one_threshold(self) -> bool:
        """Whether each impulse of the range dies out below the threshold and goes on above it."""
        return all(
            lasts == (impulse > self.threshold)
            for impulse, lasts in zip(self.impulses, self.goes_on, strict=True)
        )


def solve_impulses(system: control.StateSpace) -> ImpulseNumbers:
    """Simulate the range of impulses and find the threshold; ``system`` is the thesis's G."""
    loop = ClosedLoop(system, FrictionBacklash(1.0))
    count = round(PER_DECADE * math.log10(HIGHEST / LOWEST)) + 1
    impulses = np.geomspace(LOWEST, HIGHEST, count)
    goes_on = tuple(_goes_on(loop, impulse, DURATION) for impulse in impulses)
    first = goes_on.index(True)
    threshold = _threshold(loop, float(impulses[first - 1]), float(impulses[first]))
    strong = simulate(loop, SHORT, impulse=1e3 * threshold)
    peak = float(np.abs(strong.output(np.linspace(0, SHORT, 20_001))).max()) / (1e3 * threshold)
    return ImpulseNumbers(
        runs=tuple(_with_gap(system, gap, impulse) for impulse in SHOWN for gap in GAPS),
        impulses=impulses,
        goes_on=goes_on,
        threshold=threshold,
        peak=peak,
        counted=(
            len(simulate(loop, CHECKED, impulse=ABOVE * threshold).events),
            events_by_integration(system, ABOVE * threshold, CHECKED),
        ),
    )


def _with_gap(system: control.StateSpace, gap: float, impulse: float) -> GapRun:
    motion = simulate(ClosedLoop(system, FrictionBacklash(gap)), LONGEST, impulse=impulse)
    times = np.linspace(0, LONGEST, 16_001)
    output = motion.output(times)
    return GapRun(gap, impulse, times, output, float(np.ptp(output[times > LONGEST - 2 * WINDOW])) / 2)


def _goes_on(loop: ClosedLoop, impulse: float, duration: float) -> bool:
    log = simulate(loop, duration, impulse=impulse).log
    return bool(log.start[-1] > duration - WINDOW)


def _threshold(loop: ClosedLoop, low: float, high: float) -> float:
    for _ in range(HALVINGS):
        middle = math.sqrt(low * high)
        low, high = (low, middle) if _goes_on(loop, middle, SHORT) else (middle, high)
    return high


def events_by_integration(system: control.StateSpace, impulse: float, duration: float) -> int:
    """Count the events of G with a gap of one metre by SciPy's DOP853 with terminal events.

    The impulse is over the gap, s; the duration is in s.
    """
    A, B, C = system.A, system.B[:, 0], system.C[0]

    def rate(_: float, x: Reals, side: int, bridge: float) -> Reals:
        return np.asarray(A @ x + B * (-C @ x - side / 2 if side else bridge))

    def leaving(time: float, x: Reals, side: int, bridge: float) -> float:
        return float(-side * (C @ rate(time, x, side, bridge)))

    def meeting(side: int) -> Callable[..., float]:
        return lambda _, x, __, bridge: float(0.5 + side * (C @ x + bridge))

    events = [_falling(function) for function in (leaving, meeting(1), meeting(-1))]
    state, time, bridge, side, count = impulse * B, 0.0, 0.0, 0, 0
    while time < duration:
        run = solve_ivp(
            *(rate, (time, duration), state, "DOP853"),
            events=events[:1] if side else events[1:],
            args=(side, bridge),
            **ACCURACY,
        )
        time, state = float(run.t[-1]), run.y[:, -1]
        if run.status == 1:
            count += 1
            if side:
                bridge, side = float(-C @ state) - side / 2, 0
            else:
                side = 1 if run.t_events[0].size else -1
    return count


def _falling(function: Callable[..., float]) -> Callable[..., float]:
    """Mark a function as an event that ends the integration where it falls to zero."""
    function.terminal, function.direction = True, -1  # type: ignore[attr-defined]
    return function
