"""Slopes against formulas, remedies against motions on both sides of a bound, margins against orbits."""

from __future__ import annotations

import dataclasses

import numpy as np

from trimmer import FollowSettings, forced_orbit
from trimmer.design import DesignFile, DesignSettings, FoundMotion, Measure, MeasureOfPart, NumberRole
from trimmer.design.paths import path_through
from trimmer.design.varied_places import varied_places

STROKE = MeasureOfPart(Measure.STROKE, "stroke")
QUICK = DesignSettings(starts=2, cell_periods=200)


def test_the_motion_is_stable_within_its_margin_and_not_beyond(
    trimmer_file: DesignFile, trimmer_motion: FoundMotion
) -> None:
    mechanism = trimmer_file.mechanism
    friction = next(
        each for each in varied_places(mechanism, trimmer_motion) if each.role is NumberRole.FRICTION
    )
    near = dataclasses.replace(friction, lowest=0.35, highest=0.6)
    path = path_through(mechanism, near, trimmer_motion, FollowSettings().most_points)
    assert path.up is not None
    assert path.up.reaches is None
    assert path.down is not None
    reach = path.down.reaches
    assert reach is not None
    assert 0.35 < reach < 0.5
    state, stable = trimmer_motion.state, []
    # Step by step, since another orbit of the same period is near.
    for force in (*np.linspace(0.5, reach * 1.002, 12)[1:], reach * 0.998):
        orbit = forced_orbit(mechanism.with_value(near.place, float(force)), guess=state)
        assert orbit.success
        state = orbit.instant.state
        stable.append(orbit.stable)
    assert all(stable[:-1])
    assert not stable[-1]
