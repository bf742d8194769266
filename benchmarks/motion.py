"""Motion of the thesis's trimmer in closed loop, beside SciPy's `solve_ivp` with terminal events.

Run it with `python benchmarks/motion.py`. Both take turns in one process, and the best of some rounds counts,
since a busy computer can only add time; before that, fresh processes show what the first call costs, with and
without compiled code in the cache.
"""

import os
import subprocess
import sys
import tempfile
import time
from argparse import ArgumentParser
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.calibration import sentence
from trimmer.arrays import Reals
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.linear.model import InputChannels, pin_model
from trimmer.loops import LoopMotion, TrimmerLoop
from trimmer.loops.simulation import simulate_loop as simulate
from trimmer.parameters import TrimmerParameters

GAP, IMPULSE, DURATION = 4e-5, 1e-6, 0.1
LOOP = TrimmerLoop(
    TrimmerParameters.thesis(), FrictionBacklash(GAP), channels=InputChannels.DISPLACEMENT_ONLY
)
MODEL = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
ROUNDS = 7
SAMPLES = 1_000_000
TARGET_RATIO = 300
TARGET_SAMPLES = 0.1
DURATIONS = (0.1, 0.3, 1.0, 3.0, 10.0)
FIRST_CALL = (
    "import time; start = time.perf_counter(); "
    "from benchmarks.motion import own; imported = time.perf_counter(); "
    "own(); print(imported - start, time.perf_counter() - imported)"
)


def own() -> LoopMotion:
    """Return the motion after an impulse."""
    return simulate(LOOP, DURATION, impulse=IMPULSE)


def peer() -> Reals:
    """Return the times of the same events, as `solve_ivp` finds them: it stops at each and starts again."""
    A, B, C = MODEL.A, MODEL.B[:, 0], MODEL.C[0]
    half_gap, time_now, state, load, side = 0.5 * GAP, 0.0, MODEL.B[:, 0] * IMPULSE, 0.0, 0
    times = []

    def bridge(state: Reals) -> float:
        return -float(C @ state) - side * half_gap if side else load

    def rates(_: float, state: Reals) -> Reals:
        return np.asarray(A @ state + B * bridge(state))

    def upper(_: float, state: Reals) -> float:
        return half_gap + float(C @ state) + load

    def lower(_: float, state: Reals) -> float:
        return half_gap - float(C @ state) - load

    def pushing(_: float, state: Reals) -> float:
        return -side * float(C @ (A @ state))

    for event in (upper, lower, pushing):
        event.terminal, event.direction = True, -1.0  # type: ignore[attr-defined]
    while True:
        event_functions = [pushing] if side else [upper, lower]
        part = solve_ivp(
            rates, (time_now, DURATION), state, method="DOP853", rtol=1e-9, atol=1e-15, events=event_functions
        )
        time_now, state = part.t[-1], part.y[:, -1]
        if part.status != 1:
            return np.array(times)
        times.append(time_now)
        if side:
            load, side = bridge(state), 0
        else:
            side = 1 if part.t_events[0].size else -1


def seconds(function: Callable[[], object]) -> float:
    """Return how long a call takes, in s."""
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def compare() -> int:
    """Check that both find the same events, and return their number.

    Raises:
        AssertionError: if they do not.
    """
    events = own().event_times
    np.testing.assert_allclose(events, peer(), rtol=1e-6)
    return len(events)


def print_first_calls() -> None:
    """Print what the first call costs in a fresh process, first with an empty cache of compiled code."""
    with tempfile.TemporaryDirectory() as cache:
        for name in ("first call, compiling", "first call, from the cache"):
            ended = subprocess.run(
                [sys.executable, "-c", FIRST_CALL],
                cwd=Path(__file__).resolve().parent.parent,
                env={**os.environ, "NUMBA_CACHE_DIR": cache},
                capture_output=True,
                text=True,
                check=True,
            )
            imported, called = map(float, ended.stdout.split())
            print(f"{name:<28} {called:9.2f} s   (after imports of {imported:.2f} s)")


def print_line() -> None:
    """Print the time of longer and longer motions, and the line through them, with equal relative weights."""
    counts, times = [], []
    for duration in DURATIONS:
        count = len(simulate(LOOP, duration, impulse=IMPULSE).event_times)
        rounds = [
            seconds(lambda: simulate(LOOP, duration, impulse=IMPULSE))  # noqa: B023
            for _ in range(ROUNDS)
        ]
        counts.append(count)
        times.append(min(rounds))
        each = times[-1] / count
        print(f"{duration:6.1f} s of motion {count:8} events {each * 1e6:9.2f} µs per event")
    slope, start = np.polyfit(counts, times, 1, w=1.0 / np.array(times))
    deviation = max(abs(np.polyval([slope, start], counts) / times - 1.0))
    print(f"line: {start * 1e3:.2f} ms + {slope * 1e6:.2f} µs per event, right to {deviation:.0%}")


def main() -> None:
    """Print times, ratios and the cost per event."""
    print(sentence())
    print_first_calls()
    count = compare()
    motion, instants = own(), np.linspace(0.0, DURATION, SAMPLES)
    rounds = [
        (
            seconds(own),
            seconds(peer),
            seconds(lambda: motion.state(instants)),
            seconds(lambda: motion.output(instants)),
        )
        for _ in range(ROUNDS)
    ]
    mine, theirs, states, outputs = (min(column) for column in zip(*rounds, strict=True))
    print(f"simulate, {count} events        {mine * 1e3:9.2f} ms")
    print(f"solve_ivp                    {theirs * 1e3:9.2f} ms")
    print(f"ratio                        {theirs / mine:9.0f}      (target {TARGET_RATIO})")
    print(f"8 states at 1e6 instants     {states:9.3f} s   (target {TARGET_SAMPLES:g} s)")
    print(f"output at 1e6 instants       {outputs:9.3f} s   (target {TARGET_SAMPLES:g} s)")
    print_line()


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    main()
