"""Both limit cycles of the thesis's trimmer, beside python-control's `describing_function_response`.

Run it with `python benchmarks/limit_cycles.py`. Both take turns in one process, so that a busy computer slows
both; in its turn ours runs several times, as the first call after the peer finds cold caches (its time is
printed too). Errors are relative, in amplitude, against a root found with 40 digits from the balance of
forces.
"""

import statistics
import sys
import time
from argparse import ArgumentParser
from collections.abc import Callable
from itertools import chain
from pathlib import Path

import control
import mpmath
import numpy as np

from benchmarks.calibration import sentence
from trimmer.balance.solve import harmonic_balance, limit_cycles
from trimmer.elements import FrictionBacklash, ViscousBacklash
from trimmer.linear.model import InputChannels, pin_model
from trimmer.parameters import TrimmerParameters

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from tests.trimmer.trimmers import exact_response

GAP = 4e-5
LOOP = pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)
GUESSES = ((1.897, 3478.0), (0.1203, 4609.0))
ROUNDS = 15
CALLS = 20  # Calls of each of our functions in a round
LOOPS = iter([(1.0 + 1e-15 * number) * LOOP for number in range(1, 2 + ROUNDS * CALLS)])
"""For each call one that was not seen before."""
TARGET = 3e-3
TARGET_RATIO = 1 / 50


def own() -> list[float]:
    """Return the two amplitudes that `limit_cycles` finds."""
    return [cycle.amplitude for cycle in limit_cycles(LOOP, FrictionBacklash(GAP))]


def unseen() -> list[float]:
    """Return those of a loop that differs by a rounding from all before, so that it is factored again."""
    return [cycle.amplitude for cycle in limit_cycles(next(LOOPS), FrictionBacklash(GAP))]


def peer() -> list[float]:
    """Return the two amplitudes that python-control finds on a grid of 200 amplitudes and 500 frequencies."""
    response = control.describing_function_response(
        LOOP,
        control.friction_backlash_nonlinearity(GAP),
        np.geomspace(0.5001 * GAP, 100 * GAP, 200),
        np.geomspace(1e3, 1e4, 500),
        refine=False,
    )
    return sorted(float(amplitude) for amplitude, _ in response.intersections)


def certified() -> list[float]:
    """Return them with a certificate and the winding number that checks it."""
    return [cycle.amplitude for cycle in harmonic_balance(LOOP, FrictionBacklash(GAP)).limit_cycles]


def viscous() -> list[float]:
    """Return the amplitudes with a load whose N depends on frequency; the peer has nothing like it."""
    return [cycle.amplitude for cycle in limit_cycles(LOOP, ViscousBacklash(GAP, 1e-3))]


def exact(guess: tuple[float, float]) -> mpmath.mpf:
    """Return the amplitude next to a guess of (gap/amplitude, omega), to 30 digits."""
    with mpmath.workdps(40):

        def balance(u: mpmath.mpf, omega: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
            c = 1 - u
            real = (mpmath.pi / 2 + mpmath.asin(c) + c * mpmath.sqrt(1 - c**2)) / mpmath.pi
            excess = 1 + mpmath.mpc(real, -u * (2 - u) / mpmath.pi) * exact_response(omega)
            return excess.real, excess.imag

        u, _ = mpmath.findroot(balance, guess, tol=1e-25)
        return mpmath.mpf(GAP) / u


def seconds(function: Callable[[], list[float]], calls: int) -> list[float]:
    """Return how long each of some calls takes, in s."""
    times = []
    for _ in range(calls):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return times


def largest_error(amplitudes: list[float], references: list[mpmath.mpf]) -> float:
    """Return the largest relative error; infinite if the number of limit cycles is wrong."""
    if len(amplitudes) != len(references):
        return float("inf")
    return max(float(abs(found / true - 1)) for found, true in zip(amplitudes, references, strict=True))


def main() -> None:
    """Print times, their ratio and errors."""
    print(sentence())
    references = [exact(guess) for guess in GUESSES]
    turns = {own: CALLS, peer: 1, unseen: CALLS, certified: CALLS, viscous: CALLS}
    for function in turns:
        function()
    rounds = [[seconds(function, calls) for function, calls in turns.items()] for _ in range(ROUNDS)]
    columns = list(zip(*rounds, strict=True))
    mine, theirs, new, with_check, with_load = (statistics.median(chain(*column)) for column in columns)
    first = statistics.median(times[0] for times in columns[0])
    print(f"limit_cycles                 {mine * 1e3:9.2f} ms  (target {TARGET * 1e3:g} ms)")
    print(f"  first call after the peer  {first * 1e3:9.2f} ms")
    print(f"  of a system not seen before {new * 1e3:8.2f} ms")
    print(f"describing_function_response {theirs * 1e3:9.2f} ms")
    print(f"ratio                        {mine / theirs:9.4f}     (target {TARGET_RATIO:g})")
    print(f"harmonic_balance             {with_check * 1e3:9.2f} ms  (with the winding number)")
    print(f"limit_cycles, viscous load   {with_load * 1e3:9.2f} ms")
    print(f"relative error, ours         {largest_error(own(), references):9.1e}     (target 1e-11)")
    print(f"relative error, theirs       {largest_error(peer(), references):9.1e}")


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    main()
