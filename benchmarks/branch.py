"""A branch of the thesis's trimmer, beside following its motion by a general integrator.

Run it with `python benchmarks/branch.py`. The branch is that of exact periodic motions over the play's gap,
with multipliers and special points. The peer is `scipy.integrate.solve_ivp` (DOP853, rtol 1e-9) on one period
of the smooth part of the mechanism alone, without contact and friction, which is the least that one passage
costs there; shooting for an orbit takes one passage for each state and one more, several times.
"""

import statistics
import time
from argparse import ArgumentParser
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.calibration import sentence
from trimmer.branches import FollowedBranch, FollowSettings
from trimmer.branches.follow import follow
from trimmer.mechanism import Mechanism, linear_matrices

EXAMPLE = Path(__file__).resolve().parent.parent / "examples" / "thesis-play.toml"
TWIN = Mechanism.from_toml(EXAMPLE).with_value("frictions.blade.force", 1.0)
ORBITS = 200
ROUNDS = 5
TARGET = 0.14


def own() -> FollowedBranch:
    """Follow the branch from 40 to 100 um in 200 orbits or so."""
    settings = FollowSettings(largest_step=1.0 / ORBITS, switches=0)
    return follow(TWIN, "plays.bridge.gap", 4e-5, 1e-4, settings=settings)


def peer() -> None:
    """Follow one period of the linear part."""
    matrices, frequency = linear_matrices(TWIN), TWIN.frequency
    assert frequency is not None
    inverse, count = np.linalg.inv(matrices.mass), len(TWIN.bodies)

    def rate(moment: float, state: np.ndarray) -> np.ndarray:
        q, v = np.split(state, 2)
        push = np.zeros(count)
        push[1] = np.sin(2.0 * np.pi * frequency * moment)
        return np.concatenate([v, inverse @ (push - matrices.damping @ v - matrices.stiffness @ q)])

    solve_ivp(rate, (0.0, 1.0 / frequency), np.zeros(2 * count), method="DOP853", rtol=1e-9, atol=1e-15)


def main() -> None:
    """Print times and their ratio."""
    print(sentence())
    own()
    mine, theirs = [], []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        branch = own()
        mine.append(time.perf_counter() - start)
        start = time.perf_counter()
        peer()
        theirs.append(time.perf_counter() - start)
    own_time, peer_time = statistics.median(mine), statistics.median(theirs)
    orbits, shooting = len(branch.points), 3 * 10 * len(branch.points) * peer_time
    print(f"follow, {orbits} orbits         {own_time:9.2f} s  (target {TARGET:g} s for {ORBITS})")
    print(f"  an orbit                   {own_time / orbits * 1e3:9.2f} ms")
    print(f"solve_ivp, one smooth period {peer_time * 1e3:9.2f} ms")
    print(f"  30 of them for each orbit  {shooting:9.2f} s")
    print(f"ratio                        {own_time / shooting:9.4f}")


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    main()
