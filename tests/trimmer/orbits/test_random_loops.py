"""Each stable periodic motion that long simulations of a random loop end in is in the answer."""

import pytest

from tests.quick import quick
from tests.trimmer.orbits.random_loops import random_loop, stable_amplitudes
from trimmer import ClosedLoop, OrbitSearch, periodic_orbits
from trimmer.orbits import Simulations

LOOPS = 100
WITH_ORBIT = (3, 9, 12, 14, 18, 24, 27, 40)  # Loops that have one
ALWAYS = OrbitSearch(Simulations.ALWAYS)


@pytest.mark.parametrize("number", quick(range(LOOPS), 18))
def test_no_stable_orbit_is_missed(number: int) -> None:
    loop = random_loop(number)
    expected = stable_amplitudes(loop)
    found = [each.amplitude for each in periodic_orbits(ClosedLoop(loop.system, loop.element), search=ALWAYS)]
    assert expected or number not in WITH_ORBIT
    assert all(any(abs(other / each - 1) < 1e-3 for other in found) for each in expected)
