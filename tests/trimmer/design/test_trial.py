"""What is measured of a trial, and trials that fail."""

import math
from dataclasses import replace

import pytest

from tests.trimmer.design.made import oscillator, oscillator_amplitude
from trimmer import Friction, Mechanism, MotionKind
from trimmer.design import Measure, MeasureOfPart, Target
from trimmer.design.trials.trial import TrialWork, all_measures
from trimmer.examples import example_text

STROKE, PERIOD = MeasureOfPart(Measure.STROKE, "block"), MeasureOfPart(Measure.PERIOD, "")


def test_all_that_a_mechanism_has_can_be_asked() -> None:
    mechanism = Mechanism.from_toml_text(example_text("thesis-play"))
    frictions = {**mechanism.frictions, "none": Friction(("ground", "motor"), 0.0)}
    asked = all_measures(replace(mechanism, frictions=frictions))
    assert [(each.measure, each.part) for each in asked if each.measure is not Measure.RMS_ACCELERATION] == [
        (Measure.STROKE, "stroke"),
        (Measure.IMPACT_SPEED, "bridge"),
        (Measure.WEAR_POWER, "blade"),
        (Measure.PERIOD, ""),
    ]
    bodies = [each.part for each in asked if each.measure is Measure.RMS_ACCELERATION]
    assert bodies == list(mechanism.bodies)
    stop = Mechanism.from_toml_text(example_text("oscillator-stop"))
    assert MeasureOfPart(Measure.IMPACT_SPEED, "stop") in all_measures(stop)
    free = Mechanism.from_toml_text(example_text("block-on-belt"))
    assert PERIOD not in all_measures(free)


def test_a_trial_is_the_motion_of_the_changed_mechanism() -> None:
    work = TrialWork(oscillator(), ("links.spring.stiffness", "frequency"), (PERIOD, STROKE), 200)
    trial = work((8e3, 21.0))
    assert (trial.values, trial.kind, trial.period_count) == ((8e3, 21.0), MotionKind.PERIODIC, 1)
    assert [each for each, _ in trial.measures] == [PERIOD, STROKE]
    assert trial.value(Measure.PERIOD, "") == 1.0
    assert trial.value(Measure.STROKE, "block") == pytest.approx(
        2 * oscillator_amplitude(21.0, 8e3), rel=1e-9
    )


def test_a_trial_that_no_mechanism_can_have_has_failed() -> None:
    trial = TrialWork(oscillator(), ("bodies.block.mass",), (STROKE, PERIOD), 200)((-1.0,))
    assert (trial.values, trial.kind, trial.period_count) == ((-1.0,), None, None)
    assert [each for each, _ in trial.measures] == [STROKE, PERIOD]
    assert all(math.isnan(value) for _, value in trial.measures)
    assert not trial.meets((Target("stroke_at_least", Measure.STROKE, "block", 0.0),))
