"""Where a design has no slope, no neighbouring orbit, no settled trial or no motion at all, and says so."""

from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.design.made import motion, oscillator, oscillator_amplitude
from trimmer import Friction, Mechanism, MotionKind, SerialRunner, Stop, forced_orbit
from trimmer.deadline import NEVER
from trimmer.design import DesignSettings, Measure, MeasureOfPart, Target
from trimmer.design.motions import motions_from_starts
from trimmer.design.trials.remedy_search import remedies
from trimmer.design.trials.sensitivity import sensitivities
from trimmer.design.trials.trial import TrialWork
from trimmer.runners.timed import TimedRunner

STROKE = MeasureOfPart(Measure.STROKE, "block")
SETTINGS = DesignSettings(starts=1, seed=5, most_periods=300, cell_periods=200, trials=2)


def test_beside_a_grazing_impact_slopes_are_not_smooth() -> None:
    """A wall 0.06 % beyond the amplitude is met where the force grows by 0.1 %, and not by 0.05 %."""
    gap = oscillator_amplitude() * 1.0006
    made = replace(oscillator(), stops={"wall": Stop(("block", "ground"), 9e4, 200.0, gap)})
    orbit = forced_orbit(made, settling=300)
    found = sensitivities(made, motion(state=orbit.instant.state))
    assert found.failed == ()
    slopes = {each.place: each.of(STROKE) for each in found.entries}
    assert all(slopes.values())
    force, wall = slopes["forces.shaker.amplitude"], slopes["stops.wall.gap"]
    assert (force.value, force.smooth) == (pytest.approx(1.0, rel=1e-6), False)  # type: ignore[union-attr]
    assert (wall.value, wall.smooth) == (pytest.approx(0.0, abs=1e-9), False)  # type: ignore[union-attr]
    far = made.with_value("stops.wall.gap", 2.0 * gap)
    calm = sensitivities(far, motion(state=orbit.instant.state)).entries
    assert all(each.of(STROKE).smooth for each in calm)  # type: ignore[union-attr]


def test_numbers_at_the_end_of_their_range_have_no_slopes() -> None:
    """Friction at rest is not less than sliding: neither may the one grow alone nor the other fall."""
    made = replace(oscillator(), frictions={"floor": Friction(("ground", "block"), 0.5, 0.5)})
    first = motions_from_starts(made, SETTINGS).first
    assert first is not None
    found = sensitivities(made, first)
    assert found.failed == ("frictions.floor.force", "frictions.floor.static")
    assert "forces.shaker.amplitude" in [each.place for each in found.entries]


def undamped() -> Mechanism:
    """An oscillator driven at its natural frequency, which grows without end."""
    made = oscillator().with_value("links.spring.stiffness", 0.5 * (2 * np.pi * 20.0) ** 2)
    return made.with_value("links.spring.damping", 0.0)


def test_a_trial_that_does_not_settle_is_told_and_is_no_remedy() -> None:
    trial = TrialWork(undamped(), ("bodies.block.mass",), (STROKE,), 200)((0.5,))
    assert (trial.kind, trial.period_count) == (MotionKind.DIVERGING, None)
    more = Target("stroke_at_least", Measure.STROKE, "block", 0.1)
    assert trial.value(Measure.STROKE, "block") > 0.2  # so far, and not for long
    assert not trial.meets((more,))
    found = remedies(undamped(), (more,), (more,), None, (), SETTINGS, TimedRunner(SerialRunner(), NEVER))
    assert found.found == ()


def test_motions_that_cannot_be_followed_are_lost() -> None:
    found = motions_from_starts(undamped(), SETTINGS)
    assert (found.lost, found.first_failed, found.first, found.found) == (1, True, None, ())
    assert found.message.startswith("It diverges: the drive or a constant force meets what nothing holds")
    damped = motions_from_starts(oscillator(), SETTINGS)
    assert (damped.lost, damped.first_failed, len(damped.found)) == (0, False, 1)
