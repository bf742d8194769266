"""Random loops with integrators and large gains against brute force."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.balance.brute_force import check_limit_cycles, random_loop
from trimmer import ClosedLoop, harmonic_balance

CHUNKS, LOOPS = 50, 50


def check(seed: tuple[int, int], loops: int) -> None:
    """Hold the limit cycles of random loops against brute force, wherever the search says it is complete."""
    random = np.random.default_rng(seed)
    compared = 0
    for _ in range(loops):
        loop = random_loop(random)
        balance = harmonic_balance(ClosedLoop(loop.system, loop.element))
        if balance.certificate.complete:
            lowest, highest = balance.certificate.omegas
            check_limit_cycles(loop, balance.limit_cycles, (0.5 * lowest, 2.0 * highest))
            compared += 1
    assert compared >= 0.9 * loops


def test_some_loops() -> None:
    check((11, 0), 6)


@pytest.mark.slow
@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_2500_loops(chunk: int) -> None:
    check((2500, chunk), LOOPS)
