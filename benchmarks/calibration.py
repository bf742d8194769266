"""A fixed loop of Python and NumPy, whose time stands beside every absolute figure.

Machines differ by a factor of two and more, and one machine by as much from hour to hour. An absolute target
holds where the loop takes ``REFERENCE``; elsewhere it is to be scaled. Run it with
`python benchmarks/calibration.py`.
"""

import sys
import time
from argparse import ArgumentParser

import numpy as np

REFERENCE = 0.024  # Time of the loop, s, on the machine on which the targets were set, in its fast phases
ROUNDS = 7


def loop() -> float:
    """Do the same work of every kind that the project does: bytecode, small arrays, matrices, transforms."""
    total = 0.0
    for number in range(200_000):
        total += number * 0.5 if number & 1 else -number * 0.25
    small, matrix = np.arange(9.0), np.arange(10_000.0).reshape(100, 100) / 10_000.0
    for _ in range(5_000):
        small = np.abs(small * 0.5 + 1.0)
    for _ in range(40):
        matrix = np.tanh(matrix @ matrix / 100.0 + 0.1)
    samples = np.sin(np.arange(2**17) * 0.1)
    return total + float(small.sum() + matrix.sum() + np.sort(samples)[0] + abs(np.fft.rfft(samples)).max())


def calibration() -> float:
    """Return the shortest time of some rounds, s."""
    times = []
    for _ in range(ROUNDS):
        started = time.perf_counter()
        loop()
        times.append(time.perf_counter() - started)
    return min(times)


def sentence() -> str:
    """Return how long the loop takes here, for the head of a table of times."""
    taken = calibration()
    return (
        f"calibration loop: {1e3 * taken:.1f} ms, {taken / REFERENCE:.2f} times the "
        f"{1e3 * REFERENCE:.1f} ms for which absolute targets hold"
    )


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    print(sentence())
    sys.exit(0)
