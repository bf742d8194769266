"""No result depends on where time begins: branches under shifted phases of all drives."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.branches.bouncing_ball import ball, damping, fold, resting, thrown
from trimmer import FollowSettings, SpecialKind, follow
from trimmer.mechanism.parts import ContactLaw

QUIET = FollowSettings(quiet=True)


@pytest.mark.parametrize("stiffness", [1e6, 1e8])
@pytest.mark.parametrize("phase", [0.0, 3.0])
def test_a_fold_is_passed_wherever_the_ball_meets_the_table(stiffness: float, phase: float) -> None:
    """At the fold the ball meets the table where that is fastest: at t = 0, if the phase is 0."""
    found = follow(
        ball(stiffness, phase), "pins.table.amplitude", 0.6, 0.3, state=thrown(phase), settings=QUIET
    )
    (point,) = found.special
    assert point.kind is SpecialKind.FOLD
    assert point.value == pytest.approx(fold(stiffness), rel=1e-9)
    assert found.success
    assert found.points[0].stable
    assert not found.points[-1].stable
    # States are those at t = 0, wherever the orbits of the branch begin.
    for orbit in found.points[::20]:
        flow = found.map.flow(orbit.value)
        end = flow.course(flow.at(orbit.state), 1).end
        assert np.allclose(end.state, orbit.state, rtol=1e-6, atol=1e-7)


@pytest.mark.parametrize("law", ContactLaw)
@pytest.mark.parametrize("phase", [0.0, 3.0])
def test_a_ball_at_rest_on_the_table_lifts_off(law: ContactLaw, phase: float) -> None:
    """The force, g + A |k + i c| / |k - 1 + i c| cos, falls to zero; where it may pull, r does."""
    stiffness = 1e6
    rate = 1j * damping(stiffness)
    pressing = stiffness if law is ContactLaw.PULLING else stiffness + rate
    wanted = abs(stiffness - 1.0 + rate) / abs(pressing)
    settings = FollowSettings(quiet=True, switches=0)
    begin = resting(stiffness, phase, 0.97)
    found = follow(
        ball(stiffness, phase, 0.97, law),
        "pins.table.amplitude",
        0.97,
        1.000009,
        state=[*begin, *([math.sin(phase) * 0.97 - begin[0]] if law is ContactLaw.RELAXING else [])],
        settings=settings,
    )
    assert found.success
    first = found.special[0]
    assert (first.kind, first.parts) == (SpecialKind.GRAZING, ("contact",))
    assert first.note == "contact: contact on the upper side, +1, where it lifts off for a moment"
    # Rounding of a displacement of about 1 m changes the force by some 1e6 N/m times 1e-16 m.
    assert first.value == pytest.approx(wanted, abs=1e-9)
    assert found.points[0].events_per_period == 0
    assert found.points[-1].events_per_period > 0
