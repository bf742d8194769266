"""What is measured of a trial, and trials that fail."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import contact, friction, oscillator, oscillator_amplitude, output
from trimmer import Mechanism, MotionKind
from trimmer.contact.advance import Ending
from trimmer.contact.flow import ExactFlow
from trimmer.design.targets import Measure, Target
from trimmer.design.trial import WINDOW, Asked, Trial, TrialWork, all_measures, measured
from trimmer.examples import example_text
from trimmer.maps.settle import Settled
from trimmer.mechanism import Friction

STROKE, PERIOD = Asked(Measure.STROKE, "block"), Asked(Measure.PERIOD, "")


def test_each_measure_is_that_of_its_part() -> None:
    measures: Any = SimpleNamespace(
        peak_to_peak={"a": 1.0, "b": 2.0},
        rms_acceleration={"a": 3.0, "b": 4.0},
        contacts={"a": contact(5.0), "b": contact(6.0)},
        frictions={"a": friction(7.0), "b": friction(8.0)},
    )
    wanted = {
        Measure.STROKE: 2.0,
        Measure.RMS_ACCELERATION: 4.0,
        Measure.IMPACT_SPEED: 6.0,
        Measure.WEAR_POWER: 8.0,
    }
    for measure, value in wanted.items():
        assert measured(measures, Asked(measure, "b"), 1) == value
    # A contact without a force, or a friction without one, is in no result.
    assert measured(measures, Asked(Measure.IMPACT_SPEED, "none"), 1) == 0.0
    assert measured(measures, Asked(Measure.WEAR_POWER, "none"), 1) == 0.0
    assert measured(measures, PERIOD, 3) == 3.0
    assert measured(measures, PERIOD, None) == math.inf


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
    assert Asked(Measure.IMPACT_SPEED, "stop") in all_measures(stop)
    free = Mechanism.from_toml_text(example_text("block-on-belt"))
    assert PERIOD not in all_measures(free)


def test_a_trial_meets_targets_only_if_it_meets_all() -> None:
    values = ((STROKE, 2e-3), (PERIOD, 2.0))
    trial = Trial((4e-5,), MotionKind.PERIODIC, 2, values)
    stroke = Target("stroke_at_least", Measure.STROKE, "block", 2e-3)
    period = Target("only_drive_period", Measure.PERIOD, "", 1.0)
    assert trial.value(Measure.PERIOD, "") == 2.0
    assert trial.meets((stroke,))
    assert not trial.meets((stroke, period))
    assert trial.meets(())


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


def test_a_motion_that_has_not_settled_is_measured_over_a_window_after_it() -> None:
    work = TrialWork(oscillator(), (), (STROKE, PERIOD), 2)
    # By the formula: the whole motion is the steady one and a decaying wave, both 0 at rest.
    m, c, k, drive = 0.5, 4.0, 9e3, 2 * np.pi * 20.0
    steady = -7.0j / (k - m * drive**2 + 1j * c * drive)
    own = -c / (2 * m) + 1j * np.sqrt(k / m - (c / (2 * m)) ** 2)
    settled = Settled(MotionKind.UNDECIDED, 2, ExactFlow(oscillator()).rest())
    from_rest = work._measured((), ExactFlow(oscillator()), settled)
    times = np.linspace(0.0, WINDOW / 20.0, 200_001)
    begin = np.array([steady.real, (1j * drive * steady).real])
    rows = np.array([[1.0, 0.0], [own.real, -own.imag]])
    a, b = np.linalg.solve(rows, -begin)
    x = (steady * np.exp(1j * drive * times)).real + ((a + 1j * b) * np.exp(own * times)).real
    assert (from_rest.kind, from_rest.period_count) == (MotionKind.UNDECIDED, None)
    assert from_rest.value(Measure.PERIOD, "") == math.inf
    assert from_rest.value(Measure.STROKE, "block") == pytest.approx(np.ptp(x), rel=1e-6)


def test_a_motion_that_breaks_off_has_failed() -> None:
    flow = ExactFlow(oscillator())
    work = TrialWork(oscillator(), (), (STROKE,), 2)
    broken = Settled(MotionKind.UNDECIDED, 1, flow.rest(), ending=Ending.CHATTERING)
    failed = work._measured((1.0,), flow, broken)
    assert (failed.values, failed.kind, failed.period_count) == ((1.0,), None, None)
    cut: Any = SimpleNamespace(course=lambda begin, periods: SimpleNamespace(ending=Ending.STEP_LIMIT))
    going = Settled(MotionKind.CHAOTIC, 1, flow.rest())
    failed = work._measured((2.0,), cut, going)
    assert (failed.values, failed.kind, failed.period_count) == ((2.0,), None, None)


def test_made_outputs_have_the_measures_that_tests_rely_on() -> None:
    made = output(-1.0, 3.0, [3.0, 4.0j], 2)
    assert (made.peak_to_peak, made.rms) == (4.0, pytest.approx(math.sqrt(12.5)))
