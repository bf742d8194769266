"""The exact limit cycle of the thesis's trimmer, beside following the motion until it has settled.

Run it with `python benchmarks/orbits.py`. The peer is `scipy.integrate.solve_ivp` (DOP853, rtol 1e-9) on the
smooth pieces of the motion, stopped by terminal events, which is what one does without an exact method. It is
given the same first guess, and its frequency after a number of periods is compared with the exact one. In its
turn ours runs several times, as the first call after the peer finds cold caches; its time is printed too.
"""

import statistics
import time
from argparse import ArgumentParser
from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.calibration import sentence
from trimmer.balance.solve import limit_cycles
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash
from trimmer.linear.model import InputChannels, pin_model
from trimmer.orbits.periodic_orbit import PeriodicOrbit
from trimmer.orbits.periodic_orbits import periodic_orbits
from trimmer.parameters import TrimmerParameters

GAP = 4e-6
LOOP = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
PERIODS = 40
ROUNDS = 5
CALLS = 20  # Calls of ours in a round
TARGET = 2.9e-3


def own() -> PeriodicOrbit:
    """Find the stable orbit with its multipliers from the prediction of harmonic balance."""
    return periodic_orbits(LOOP, FrictionBacklash(GAP), [PREDICTION])[0]


def peer() -> float:
    """Follow the motion for PERIODS periods; return the frequency of the last one, Hz."""
    A, B, C = LOOP.A, LOOP.B[:, 0], LOOP.C[0]
    pin_rate = -C @ A

    def leaves(_: float, state: np.ndarray, bridge: float, side: int) -> float:
        return float(side * (pin_rate @ state))

    def meets(side: int):  # type: ignore[no-untyped-def]
        def clearance(_: float, state: np.ndarray, bridge: float, __: int) -> float:
            return float(GAP / 2 - side * (-C @ state - bridge))

        clearance.terminal, clearance.direction = True, -1
        return clearance

    leaves.terminal, leaves.direction = True, -1
    response = np.linalg.solve(1j * PREDICTION.omega * np.eye(len(A)) - A, B)
    gain = complex(FrictionBacklash(GAP).describing_function(PREDICTION.amplitude))
    state = (response * gain * PREDICTION.amplitude * np.exp(0.1j)).imag
    moment, separations, contact, side, bridge = 0.0, [], True, 1, 0.0
    while len(separations) < 2 * PERIODS:

        def rate(_: float, at: np.ndarray, held: float, pushed: int) -> np.ndarray:
            return A @ at + B * (-C @ at - pushed * GAP / 2 if pushed else held)

        events = [leaves] if contact else [meets(1), meets(-1)]
        ended = solve_ivp(
            rate,
            (moment, moment + 1.0),
            state,
            method="DOP853",
            events=events,
            args=(bridge, side if contact else 0),
            rtol=1e-9,
            atol=1e-18,
        )
        moment, state = float(ended.t[-1]), ended.y[:, -1]
        if contact:
            bridge = float(-C @ state - side * GAP / 2)
            separations.append(moment)
        else:
            side = 1 if ended.t_events[0].size else -1
        contact = not contact
    return 1.0 / (separations[-1] - separations[-3])


PREDICTION = next(cycle for cycle in limit_cycles(LOOP, FrictionBacklash(GAP)) if cycle.stable)


def seconds(function: Callable[[], object]) -> float:
    """Return how long a call takes, in s."""
    start = time.perf_counter()
    function()
    return time.perf_counter() - start


def main() -> None:
    """Print times, their ratio, and how far the peer is from the exact frequency."""
    print(sentence())
    orbit = own()
    mine, first, theirs, frequency = [], [], [], 0.0
    for _ in range(ROUNDS):
        times = [seconds(own) for _ in range(CALLS)]
        mine += times
        first.append(times[0])
        start = time.perf_counter()
        frequency = peer()
        theirs.append(time.perf_counter() - start)
    own_time, peer_time = statistics.median(mine), statistics.median(theirs)
    print(f"periodic_orbits, one orbit   {own_time * 1e3:9.2f} ms  (target {TARGET * 1e3:g} ms)")
    print(f"  first call after the peer  {statistics.median(first) * 1e3:9.2f} ms")
    print(f"solve_ivp, {PERIODS} periods        {peer_time * 1e3:9.2f} ms")
    print(f"ratio                        {own_time / peer_time:9.4f}")
    print(f"frequency, ours              {orbit.frequency:12.6f} Hz, miss of the return {orbit.residual:.1e}")
    print(f"frequency, theirs            {frequency:12.6f} Hz, error {frequency / orbit.frequency - 1:+.1e}")


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    main()
