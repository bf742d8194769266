"""Each stable periodic motion that brute force finds in a random loop is in the answer."""

import pytest

from tests.quick import quick
from tests.trimmer.orbits.brute_force import sustained
from tests.trimmer.orbits.random_loops import random_loop, stable_amplitudes
from trimmer import ClosedLoop, OrbitSearch, periodic_orbits
from trimmer.orbits import Simulations

CHUNKS, PLANTS = 50, 10
WITH_ORBIT = (3, 9, 12, 14, 18, 24, 27, 40)
"""Loops in which brute force finds an orbit, and that take less than a second each: the fast part."""
ALWAYS = OrbitSearch(Simulations.ALWAYS)


@pytest.mark.parametrize("number", quick(WITH_ORBIT, 4))
def test_no_stable_orbit_is_missed(number: int) -> None:
    loop = random_loop(number)
    expected = stable_amplitudes(loop)
    found = [each.amplitude for each in periodic_orbits(ClosedLoop(loop.system, loop.element), search=ALWAYS)]
    assert expected
    assert all(any(abs(other / each - 1) < 1e-3 for other in found) for each in expected)


@pytest.mark.slow
def test_brute_force_finds_motions() -> None:
    for number, amplitude in ((3, 0.0881), (14, 0.2134), (20, 0.06851), (27, 0.3438)):
        motions = list(sustained(random_loop(number), []))
        assert any(motion.fine == pytest.approx(amplitude, rel=1e-2) for motion in motions)


@pytest.mark.slow
@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_no_stable_orbit_is_missed_in_500_plants(chunk: int) -> None:
    for number in range(PLANTS * chunk, PLANTS * (chunk + 1)):
        loop = random_loop(number)
        orbits = periodic_orbits(ClosedLoop(loop.system, loop.element), search=ALWAYS)
        for motion in sustained(loop, [orbit.amplitude for orbit in orbits]):
            assert motion.known, (number, motion)
