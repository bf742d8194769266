"""Measure describing functions beside SymPy's ``nsolve``, which stands in for the thesis's ``vpasolve``.

Both find contact angles of viscous-controlled backlash, for gamma between 0.01 and 100 and g/A up to 2, in
one run and taking turns; the angles are compared first.
"""

import statistics
import time
from argparse import ArgumentParser
from collections.abc import Callable

import numpy as np
import sympy

from benchmarks.calibration import sentence
from trimmer import FrictionBacklash, InertiaBacklash, ViscousBacklash
from trimmer.arrays import Reals

VALUES = 1_000_000
PEER_VALUES = 20
RUNS = 5
TARGET = 1.0  # Upper limit for ``VALUES`` viscous-controlled values on one core, s


def processor_time(action: Callable[[], object]) -> float:
    """Return the processor time of an action, s, all threads together."""
    start = time.process_time()
    action()
    return time.process_time() - start


def points() -> tuple[Reals, Reals]:
    """Return amplitudes, for a gap of 1, and gammas."""
    random = np.random.default_rng(1)
    return 1.0 / random.uniform(0.01, 1.99, VALUES), 10.0 ** random.uniform(-2, 2, VALUES)


def contact_angles(amplitudes: Reals, gammas: Reals) -> list[float]:
    """Solve the contact equation with ``nsolve``, for one angle after the other."""
    angle, gap_by_amplitude, gamma = sympy.symbols("angle gap_by_amplitude gamma", positive=True)
    separation = sympy.atan(1 / gamma)
    flight = gamma * (1 - sympy.exp((separation - angle) / gamma)) * sympy.cos(separation)
    equation = sympy.sin(separation) + flight - sympy.sin(angle) - gap_by_amplitude
    return [
        float(sympy.nsolve(equation.subs({gap_by_amplitude: 1 / amplitude, gamma: value}), angle, 2.5))
        for amplitude, value in zip(amplitudes.tolist(), gammas.tolist(), strict=True)
    ]


def compare(amplitudes: Reals, gammas: Reals) -> None:
    """Check that both find the same angles; ours is the phase of dN/du = (2/π) exp(-j angle).

    Raises:
        AssertionError: if they do not.
    """
    slopes = ViscousBacklash(1.0, 1.0).derivatives(amplitudes, gammas).by_u
    np.testing.assert_allclose(
        -np.angle(slopes) % (2 * np.pi), contact_angles(amplitudes, gammas), rtol=1e-12
    )


def main() -> None:
    """Print the table."""
    print(sentence())
    amplitudes, gammas = points()
    compare(amplitudes[:PEER_VALUES], gammas[:PEER_VALUES])
    own: dict[str, list[float]] = {}
    peers = []
    for _ in range(RUNS):
        for element in (FrictionBacklash(1.0), InertiaBacklash(1.0), ViscousBacklash(1.0, 1.0)):
            seconds = processor_time(lambda element=element: element.describing_function(amplitudes, gammas))
            own.setdefault(type(element).__name__, []).append(seconds / VALUES)
        angles = processor_time(lambda: contact_angles(amplitudes[:PEER_VALUES], gammas[:PEER_VALUES]))
        peers.append(angles / PEER_VALUES)
    peer = statistics.median(peers)
    print(f"one value, median of {RUNS} runs of {VALUES} values (SymPy: {PEER_VALUES})")
    for name, times in own.items():
        each = statistics.median(times)
        print(f"{name:<17} {each * 1e6:8.3f} µs   SymPy nsolve / this {peer / each:10.0f}")
    print(f"{'SymPy nsolve':<17} {peer * 1e6:8.0f} µs")
    million = statistics.median(own["ViscousBacklash"]) * VALUES
    print(f"{VALUES} viscous-controlled values: {million:.2f} s on one core, target {TARGET:g} s")


if __name__ == "__main__":
    ArgumentParser(description=__doc__).parse_args()
    main()
