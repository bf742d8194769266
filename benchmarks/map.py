"""A map of the thesis's twin over play and friction, beside SciPy's `solve_ivp`; run `python benchmarks/map.py`.

The map is 100 x 100 cells of up to 300 drive periods each (`--cells N` for N x N), on two processes. Half of
it is measured too: twice the cells are to take twice the time. Memory is that of the process that keeps the
results. The peer follows one of the motions for some drive periods with DOP853 at 1e-10 and terminal events,
and its time is scaled to the drive periods of the map; it tells no kind and measures nothing.
"""

from __future__ import annotations

import argparse
import resource
import time
from collections import Counter
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.calibration import sentence
from trimmer.arrays import Reals
from trimmer.maps.kinds import MotionKind
from trimmer.maps.motion_map import motion_map
from trimmer.maps.result import MotionMap
from trimmer.maps.runner import ProcessRunner
from trimmer.mechanism.mechanism import Mechanism

TWIN = Mechanism.from_toml(Path(__file__).parents[1] / "examples" / "thesis-play.toml")
CELLS = 100
PROCESSES = 2
TARGET = 90.0
"""s for 100 x 100 cells, where the calibration loop takes what is its reference."""
PEER_PERIODS = 3


def own(columns: int, rows: int) -> tuple[float, MotionMap]:
    """Make a map; return the time, s, and the map."""
    values = {
        "plays.bridge.gap": np.linspace(0.0, 0.5e-3, columns),
        "frictions.blade.force": np.linspace(0.0, 4.0, rows),
    }
    start = time.perf_counter()
    result = motion_map(TWIN, values, runner=ProcessRunner(PROCESSES), quiet=True)
    return time.perf_counter() - start, result


def peer() -> float:
    """Follow the twin with a truncated contact and sliding friction; return the time of a drive period, s."""
    gap, stiffness, damping, force = 40e-6, 30e3, 0.4, 0.5
    omega, amplitude = 2 * np.pi * 110.0, 1.5e-3
    masses = np.array([0.035, 0.003, 0.005, 0.030])
    links = [(-1, 0, 200e3, 3.5), (-1, 2, 150e3, 1.0), (2, 3, 100e3, 4.0), (2, 1, 1e3, 0.0)]

    def stretch(moment: float, state: Reals) -> tuple[float, float]:
        pin = state[0] + amplitude * np.sin(omega * moment)
        pin_rate = state[4] + amplitude * omega * np.cos(omega * moment)
        return pin - state[1], pin_rate - state[5]

    def rate(moment: float, state: Reals, side: int, direction: int) -> Reals:
        forces = np.zeros(4)
        for start, end, spring, damper in links:
            relative = state[end] - (state[start] if start >= 0 else 0.0)
            speed = state[4 + end] - (state[4 + start] if start >= 0 else 0.0)
            pull = spring * relative + damper * speed
            forces[end] -= pull
            if start >= 0:
                forces[start] += pull
        if side:
            distance, speed = stretch(moment, state)
            pull = stiffness * (distance - side * gap / 2) + damping * speed
            forces[1] += pull
            forces[0] -= pull
        forces[1] -= direction * force
        forces[3] += direction * force
        return np.concatenate([state[4:], forces / masses])

    def meets(sign: int):  # type: ignore[no-untyped-def]
        def event(moment: float, state: Reals, side: int, direction: int) -> float:
            return gap / 2 - sign * stretch(moment, state)[0]

        event.terminal, event.direction = True, -1
        return event

    def parts(moment: float, state: Reals, side: int, direction: int) -> float:
        distance, speed = stretch(moment, state)
        return side * (stiffness * (distance - side * gap / 2) + damping * speed)

    def turns(moment: float, state: Reals, side: int, direction: int) -> float:
        return direction * (state[5] - state[7])

    parts.terminal, parts.direction = True, -1  # type: ignore[attr-defined]
    turns.terminal, turns.direction = True, -1  # type: ignore[attr-defined]
    moment, state, side, direction = 0.0, np.zeros(8), 0, 1
    duration = PEER_PERIODS / 110.0
    start = time.perf_counter()
    while moment < duration:
        events = [turns, parts] if side else [turns, meets(1), meets(-1)]
        ended = solve_ivp(
            rate,
            (moment, duration),
            state,
            "DOP853",
            events=events,
            args=(side, direction),
            rtol=1e-10,
            atol=1e-14,
        )
        moment, state = float(ended.t[-1]), ended.y[:, -1]
        if ended.t_events[0].size:
            direction = -direction
        elif side:
            side = 0
        elif ended.status == 1:
            side = 1 if ended.t_events[1].size else -1
        moment = np.nextafter(moment, np.inf)
    return (time.perf_counter() - start) / PEER_PERIODS


def main() -> None:
    """Print times, their ratio, memory, and what was found."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--cells", type=int, default=CELLS)
    cells = parser.parse_args().cells
    print(sentence())
    own(4, 4)  # compiles, or reads what was compiled
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    half, _ = own(cells, cells // 2)
    whole, result = own(cells, cells)
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    count = cells * cells
    theirs = peer() * int(result.periods.sum())
    target = TARGET * count / CELLS**2
    print(f"map of {cells} x {cells} cells      {whole:9.1f} s  (target {target:g} s, {PROCESSES} processes)")
    print(f"  a cell, one process      {1e3 * PROCESSES * whole / count:9.2f} ms")
    print(f"  half of the cells        {half:9.1f} s, the whole takes {whole / half:.2f} times as long")
    print(
        f"  memory beside the start  {(after - before) / 1024:9.1f} MB, {(after - before) / count:.2f} kB a cell"
    )
    print(
        f"solve_ivp, as many periods {theirs:9.0f} s in one process, {theirs / PROCESSES / whole:.0f} times ours"
    )
    kinds = Counter(
        f"period {k}" if kind is MotionKind.PERIODIC else kind.value
        for kind, k in zip(result.kind.ravel(), result.period_count.ravel(), strict=True)
    )
    print(", ".join(f"{name} {number / count:.1%}" for name, number in kinds.most_common(8)))
    print(sentence())


if __name__ == "__main__":
    main()
