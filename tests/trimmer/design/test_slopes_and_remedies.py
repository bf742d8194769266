"""Slopes against formulas, remedies against motions on both sides of a bound, margins against orbits."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from trimmer import FollowSettings, Mechanism, SerialRunner, forced_orbit
from trimmer.design.design_file import DesignFile
from trimmer.design.found_motion import FoundMotion
from trimmer.design.linear import linear_states
from trimmer.design.paths import path_through
from trimmer.design.remedies import remedies_by
from trimmer.design.sensitivity import sensitivities
from trimmer.design.settings import DesignSettings
from trimmer.design.targets import Measure, Target
from trimmer.design.trial import Asked, TrialWork, all_measures
from trimmer.design.varied_places import Role, varied_places
from trimmer.design.verdict import Judged

STROKE = Asked(Measure.STROKE, "stroke")
QUICK = DesignSettings(starts=2, cell_periods=200)


def test_slopes_of_a_linear_mechanism_are_those_of_its_transfer_function(
    linear_file: DesignFile, linear_motion: FoundMotion
) -> None:
    found = sensitivities(linear_file.mechanism, linear_motion)
    of_stroke = {each.place: each.of(STROKE) for each in found.entries}
    assert of_stroke["pins.pin.amplitude"].value == pytest.approx(1.0, abs=1e-9)
    for place in ("links.bridge.stiffness", "bodies.cutter.mass", "frequency"):
        assert of_stroke[place].value == pytest.approx(slope(linear_file.mechanism, place), rel=1e-4)
        assert of_stroke[place].smooth


def slope(mechanism: Mechanism, place: str) -> float:
    """Return the elasticity of the transfer function's modulus at the drive, by a very small difference."""
    value, step = mechanism.value(place), 1e-5
    sizes = [
        abs(linear_states(mechanism.with_value(place, value * factor))[0].transfer[0].at_drive)
        for factor in (1 - step, 1 + step)
    ]
    return float((sizes[1] - sizes[0]) / (step * sum(sizes)))


def test_the_largest_slope_stands_first(trimmer_file: DesignFile, trimmer_motion: FoundMotion) -> None:
    found = sensitivities(trimmer_file.mechanism, trimmer_motion)
    assert not found.failed
    sizes = [abs(each.of(STROKE).value) for each in found.ranked(STROKE)]
    assert sizes == sorted(sizes, reverse=True)
    wear = found.ranked(Asked(Measure.WEAR_POWER, "blade"))
    assert {each.place for each in wear[:2]} == {"pins.pin.amplitude", "frictions.blade.force"}


def test_a_remedy_meets_the_targets_and_a_smaller_change_does_not(trimmer_file: DesignFile) -> None:
    mechanism = trimmer_file.mechanism
    target = Target("impact_speed_at_most", Measure.IMPACT_SPEED, "bridge", 0.15)
    found, trials = remedies_by(mechanism, "plays.bridge.gap", "m", (target,), QUICK, SerialRunner())
    gap = found[0]
    assert gap.after < gap.before
    assert trials >= 40
    assert gap.trial.meets((target,))
    work = TrialWork(mechanism, (gap.place,), all_measures(mechanism), 200)
    nearer = gap.after + 0.1 * (gap.before - gap.after)
    assert not work((nearer,)).meets((target,))


def test_the_motion_is_stable_within_its_margin_and_not_beyond(
    trimmer_file: DesignFile, trimmer_motion: FoundMotion
) -> None:
    mechanism = trimmer_file.mechanism
    friction = next(each for each in varied_places(mechanism, trimmer_motion) if each.role is Role.FRICTION)
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
    for force in (*np.linspace(0.5, reach * 1.002, 24)[1:], reach * 0.998):
        orbit = forced_orbit(mechanism.with_value(near.place, float(force)), guess=state)
        assert orbit.success
        state = orbit.instant.state
        stable.append(orbit.stable)
    assert all(stable[:-1])
    assert not stable[-1]


def test_margins_of_targets_have_signs() -> None:
    stroke = Target("stroke_at_least", Measure.STROKE, "stroke", 2.0)
    speed = Target("impact_speed_at_most", Measure.IMPACT_SPEED, "bridge", 2.0)
    assert Judged(stroke, 2.5, True).margin == pytest.approx(0.25)
    assert Judged(speed, 2.5, False).margin == pytest.approx(-0.25)
