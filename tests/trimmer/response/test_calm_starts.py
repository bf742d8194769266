"""Orbits with an event at t = 0, which cuts the period where the map of it is not smooth."""

import math

import numpy as np
import pytest

from tests.mechanisms.shifted_phases import differences, shifted, state_at
from tests.quick import examples, quick
from tests.trimmer.branches.bouncing_ball import ball, thrown
from trimmer import ContactLaw, forced_orbit

BESIDE = (0.0, 1e-14, -1e-14, 1e-9, -1e-9, 1e-5, -1e-5)  # Times from an event to t = 0, s


@pytest.mark.parametrize("law", [ContactLaw.PULLING, ContactLaw.RELAXING])
@pytest.mark.parametrize("stiffness", [1e4, 1e8])
def test_an_orbit_is_found_though_an_event_comes_to_its_start(stiffness: float, law: ContactLaw) -> None:
    machine, random = ball(stiffness, 2.0, law=law), np.random.default_rng(1)
    known = forced_orbit(machine, guess=[*thrown(2.0), *[0.0] * (law is ContactLaw.RELAXING)])
    assert known.stable
    for time, _, _ in known.course.events:
        for beside in BESIDE:
            share = (time + beside) / known.period
            later = shifted(machine, share)
            begin = known.course.states(np.array([time + beside]))[0, : len(known.sizes)]
            orbit = forced_orbit(later, guess=begin * (1.0 + 1e-7 * random.normal(size=len(begin))))
            assert orbit.stable
            assert abs(orbit.multipliers[0]) == pytest.approx(abs(known.multipliers[0]), rel=1e-7)
            assert orbit.instant.phase == 0.0
            assert orbit.period == pytest.approx(2.0 * math.pi, rel=1e-14)
            assert orbit.events_per_period == known.events_per_period
            ours, theirs = orbit.measures.rms_acceleration["ball"], known.measures.rms_acceleration["ball"]
            assert ours == pytest.approx(theirs, rel=1e-6)


def test_a_later_clock_sees_the_same_motion() -> None:
    machine = ball(1e4, 0.3)
    share = 0.37
    ours = forced_orbit(machine, guess=thrown(0.3))
    theirs = forced_orbit(shifted(machine, share), guess=state_at(machine, share, np.array(thrown(0.3))))
    later = ours.course.states(np.array([share * ours.period]))[0, :2]
    assert theirs.instant.state == pytest.approx(later, rel=1e-9)


@pytest.mark.parametrize("seed", quick([2, *(each for each in range(24) if each not in (2, 3, 5))], 0))
def test_random_mechanisms_under_a_later_clock_at_all_doors(seed: int) -> None:
    """The machine 3 is at the edge of chaos, which a finite window does not decide; 5 is refused."""
    assert differences(seed, branches=bool(examples(0, 1))) == []
