"""Each stable periodic motion that brute force finds in a random loop is in the answer."""

from __future__ import annotations

import pytest

from tests.trimmer.orbits.random_loops import random_loop, stable_amplitudes
from trimmer import OrbitSearch, Simulations, periodic_orbits

COUNT = 60
WITH_ORBIT = (3, 9, 12, 14, 18, 24, 27, 40)
"""Loops in which brute force finds an orbit, and that take less than a second each: the fast part."""


def missed(number: int) -> tuple[list[float], list[float]]:
    """Return the amplitudes that brute force finds, and those of them that the answer lacks."""
    loop = random_loop(number)
    expected = stable_amplitudes(loop)
    orbits = periodic_orbits(loop.system, loop.element, search=OrbitSearch(Simulations.ALWAYS))
    found = [orbit.amplitude for orbit in orbits]
    return expected, [each for each in expected if all(abs(other / each - 1) > 1e-3 for other in found)]


@pytest.mark.parametrize("number", WITH_ORBIT)
def test_no_stable_orbit_is_missed(number: int) -> None:
    expected, lacking = missed(number)
    assert expected
    assert lacking == []


@pytest.mark.slow
@pytest.mark.parametrize("number", range(COUNT))
def test_no_stable_orbit_is_missed_in_any(number: int) -> None:
    assert missed(number)[1] == []
