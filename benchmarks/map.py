"""A map of the thesis's twin over play and friction, beside SciPy's `solve_ivp`.

Run it with `python benchmarks/map.py`. The map is 100 x 100 cells of up to 300 drive periods each
(`--cells N` for N x N), on two processes. Half of it is measured too: twice the cells are to take twice the
time. Memory is that of the process that keeps the results. The peer follows one of the motions for some
drive periods with DOP853 at 1e-10, contact by terminal events and friction smoothed. Its time is scaled to
the drive periods of the map; it tells no kind and measures nothing.
"""

import argparse
import resource
import time
from collections import Counter
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.calibration import sentence
from trimmer.arrays import Reals
from trimmer.maps.cell_motion import described
from trimmer.maps.motion_map import motion_map
from trimmer.maps.result import MotionMap
from trimmer.mechanism.mechanism import Mechanism
from trimmer.runners.processes import ProcessRunner

TWIN = Mechanism.from_toml(Path(__file__).parents[1] / "examples" / "thesis-play.toml")
CELLS = 100
PROCESSES = 2
TARGET = 40.0  # s for 100 x 100 cells, where the calibration loop takes what is its reference
PEER_PERIODS = 2
GAP, OMEGA = 40e-6, 2 * np.pi * 110.0
MASSES = np.array([0.035, 0.003, 0.005, 0.030])
LINKS = ((-1, 0, 200e3, 3.5), (-1, 2, 150e3, 1.0), (2, 3, 100e3, 4.0), (2, 1, 1e3, 0.0))
"""Bodies at start, -1 for the ground, and end; stiffness, N/m, and damping, N s/m."""
SMOOTHING = 1e-2  # Velocity below which the friction of the peer is smoothed, m/s


def own(columns: int, rows: int) -> tuple[float, MotionMap]:
    """Make a map; return the time, s, and the map."""
    values = {
        "plays.bridge.gap": np.linspace(0.0, 0.5e-3, columns),
        "frictions.blade.force": np.linspace(0.0, 4.0, rows),
    }
    start = time.perf_counter()
    result = motion_map(TWIN, values, runner=ProcessRunner(PROCESSES), quiet=True)
    return time.perf_counter() - start, result


def processor_time() -> float:
    """Return the processor time of this process and of those that it began and that have ended, s."""
    usages = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


def peer_rate(moment: float, state: Reals, side: int) -> Reals:
    """Return the rate of displacements and velocities; dry friction is smoothed, as is usual."""
    forces = np.zeros(4)
    for start, end, stiffness, damping in LINKS:
        apart = state[end] - (state[start] if start >= 0 else 0.0)
        speed = state[4 + end] - (state[4 + start] if start >= 0 else 0.0)
        pull = stiffness * apart + damping * speed
        forces[end] -= pull
        if start >= 0:
            forces[start] += pull
    if side:
        pull = bridge_force(moment, state, side)
        forces[1] += pull
        forces[0] -= pull
    rubbing = 0.5 * np.tanh((state[5] - state[7]) / SMOOTHING)
    forces[1] -= rubbing
    forces[3] += rubbing
    return np.concatenate([state[4:], forces / MASSES])


def distance(moment: float, state: Reals) -> float:
    """Return how far the pin is from the middle of the slot, m."""
    return float(state[0] + 1.5e-3 * np.sin(OMEGA * moment) - state[1])


def bridge_force(moment: float, state: Reals, side: int) -> float:
    """Return the force of the contact on one side, N."""
    speed = state[4] + 1.5e-3 * OMEGA * np.cos(OMEGA * moment) - state[5]
    return float(30e3 * (distance(moment, state) - side * GAP / 2) + 0.4 * speed)


def peer() -> float:
    """Follow the twin for some periods, contact by terminal events; return the time of a period, s."""

    def meets(sign: int):  # type: ignore[no-untyped-def]
        def event(moment: float, state: Reals, side: int) -> float:
            return GAP / 2 - sign * distance(moment, state)

        event.terminal, event.direction = True, -1
        return event

    def parts(moment: float, state: Reals, side: int) -> float:
        return side * bridge_force(moment, state, side)

    parts.terminal, parts.direction = True, -1  # type: ignore[attr-defined]
    moment, state, side = 0.0, np.zeros(8), 0
    duration = 2 * np.pi / OMEGA * PEER_PERIODS
    start = time.perf_counter()
    while moment < duration:
        ended = solve_ivp(
            peer_rate,
            (moment, duration),
            state,
            "DOP853",
            events=[parts] if side else [meets(1), meets(-1)],
            args=(side,),
            rtol=1e-10,
            atol=1e-14,
        )
        moment, state = float(ended.t[-1]), ended.y[:, -1]
        side = 0 if side or ended.status == 0 else 1 if ended.t_events[0].size else -1
    return (time.perf_counter() - start) / PEER_PERIODS


def main() -> None:
    """Print times, their ratio, memory, and what was found."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cells", type=int, default=CELLS, help="cells of each side (default: %(default)s)")
    cells = parser.parse_args().cells
    print(sentence())
    own(4, 4)  # compiles, or reads what was compiled
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    half, _ = own(cells, cells // 2)
    used = processor_time()
    whole, result = own(cells, cells)
    spent = processor_time() - used
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    count = cells * cells
    theirs = peer() * int(result.periods.sum())
    target = TARGET * count / CELLS**2
    memory = (after - before) / 1024
    ratio = theirs / PROCESSES / whole
    print(
        f"map of {cells} x {cells} cells       {whole:8.1f} s  (target {target:g} s, {PROCESSES} processes)"
    )
    print(f"  processor time of a cell  {1e3 * spent / count:8.2f} ms")
    print(f"  half of the cells         {half:8.1f} s, the whole takes {whole / half:.2f} times as long")
    print(f"  memory beside the start   {memory:8.1f} MB, {1024 * memory / count:.2f} kB a cell")
    print(f"solve_ivp, as many periods  {theirs:8.0f} s in one process, in two {ratio:.0f} times ours")
    kinds = Counter(described(cell.motions[0]) for cell in result.cells)
    print(", ".join(f"{name} {number / count:.1%}" for name, number in kinds.most_common(8)))
    print(sentence())


if __name__ == "__main__":
    main()
