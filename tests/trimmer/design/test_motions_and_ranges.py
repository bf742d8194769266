"""Motions with their verdict, spectra, ranges, and what is asked about."""

from __future__ import annotations

import numpy as np
import pytest

from trimmer import MotionKind, SerialRunner
from trimmer.design.design_file import DesignFile, design_file_of_text
from trimmer.design.found_motion import FoundMotion
from trimmer.design.linear import linear_states
from trimmer.design.motions import Motions, motions_from_starts
from trimmer.design.plausible import Oddity, questions
from trimmer.design.ranges import study_ranges
from trimmer.design.settings import DesignSettings
from trimmer.design.spectrum import LineKind, spectra
from trimmer.design.verdict import Outcome, Sureness, verdict_on
from trimmer.examples import example_text

QUICK = DesignSettings(starts=2, range_points=9, cell_periods=200)


def changed(*changes: tuple[str, str]) -> DesignFile:
    """Return the trimmer with play with some pieces of its file changed."""
    text = example_text("thesis-play")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return design_file_of_text(text, "mine.toml")


def alone(motion: FoundMotion) -> Motions:
    """Return a motion as the only one that was found."""
    return Motions((motion,), motion.starts, 0, 0, "", False)


def test_the_verdict_follows_the_bounds(trimmer_file: DesignFile, trimmer_motion: FoundMotion) -> None:
    verdict = verdict_on(trimmer_file.targets, alone(trimmer_motion), None)
    assert verdict.outcome is Outcome.MISSED
    assert [each.part for each in verdict.missed] == ["bridge"]
    met = changed(('"0.15 m/s"', '"0.2 m/s"'))
    verdict = verdict_on(met.targets, alone(trimmer_motion), None)
    assert (verdict.outcome, verdict.sureness) == (Outcome.MET, Sureness.SURE)
    near = changed(('"0.15 m/s"', '"0.177 m/s"'))
    assert verdict_on(near.targets, alone(trimmer_motion), None).sureness is Sureness.LIKELY
    assert verdict_on((), alone(trimmer_motion), None).outcome is Outcome.NO_TARGETS


def test_the_tabled_stroke_and_acceleration_come_out() -> None:
    """The reference case of the mechanism's definition, with 1 N of friction, computed twice by others."""
    found = motions_from_starts(changed(("force = 0.5", "force = 1.0")).mechanism, QUICK)
    motion = found.first
    assert motion is not None
    assert motion.outputs["stroke"].peak_to_peak == pytest.approx(2.933334121400e-3, rel=1e-11)
    assert motion.rms_acceleration["motor"] == pytest.approx(118.754895, rel=1e-8)
    assert motion.events == 14


def test_each_line_is_explained(trimmer_file: DesignFile, trimmer_motion: FoundMotion) -> None:
    states = linear_states(trimmer_file.mechanism)
    found = spectra(trimmer_motion, 110.0, states)["stroke"]
    kinds = {line.numerator: line.kind for line in found.lines}
    assert kinds[1] is LineKind.DRIVE
    assert kinds[3] is LineKind.HARMONIC
    assert all(line.numerator % 2 for line in found.lines)
    fifth = next(line for line in found.lines if line.numerator == 5)
    assert fifth.mode is not None
    assert fifth.mode.frequency == pytest.approx(549.6, abs=0.1)
    assert found.share == pytest.approx(1.0, abs=1e-6)


def test_a_longer_period_gives_fractions_of_the_drive() -> None:
    file = changed(("frequency = 110.0", "frequency = 100.0"), ("gap = 40e-6", "gap = 160e-6"))
    motion = next(each for each in motions_from_starts(file.mechanism, DesignSettings(starts=6)).found)
    lines = spectra(motion, 100.0, ())["stroke"].lines
    if motion.kind is MotionKind.PERIODIC and motion.period_count and motion.period_count > 1:
        assert any(line.kind is LineKind.FRACTION for line in lines)
    assert next(line for line in lines if line.kind is LineKind.DRIVE).frequency == pytest.approx(100.0)


def test_signals_are_those_of_the_measures(trimmer_motion: FoundMotion) -> None:
    signals = trimmer_motion.signals
    assert np.ptp(signals.outputs["stroke"]) == pytest.approx(
        trimmer_motion.outputs["stroke"].peak_to_peak, rel=1e-4
    )
    assert abs(signals.forces["bridge"]).max() == pytest.approx(
        trimmer_motion.contacts["bridge"].largest_force, rel=1e-3
    )
    touching = sum(length for _, length in signals.touching["bridge"])
    assert touching == pytest.approx(trimmer_motion.contacts["bridge"].share / 110, rel=1e-9)


def test_a_range_across_a_bound_leaves_the_verdict_open() -> None:
    file = changed(("gap = 40e-6", 'gap = "20 um..60 um"'))
    study = study_ranges(file.mechanism, file.ranges, file.targets, QUICK, SerialRunner())
    met = [trial.meets(file.targets) for trial in study.trials]
    assert met[0]
    assert not met[-1]
    assert study.meeting == pytest.approx(sum(met) / 9)
    assert study.doubt == pytest.approx(2 * study.meeting * (1 - study.meeting))
    motions = motions_from_starts(file.mechanism, QUICK)
    assert verdict_on(file.targets, motions, study).outcome is Outcome.DEPENDS


def test_the_number_that_matters_is_the_one_to_measure() -> None:
    file = changed(("gap = 40e-6", 'gap = "30 um..40 um"'), ("damping = 3.5", 'damping = "3.4..3.6 N s/m"'))
    few = DesignSettings(range_points=5, cell_periods=100)
    study = study_ranges(file.mechanism, file.ranges, file.targets, few, SerialRunner())
    first, second = study.narrowings
    assert first.range.place == "plays.bridge.gap"
    assert first.spread < 0.2 < second.spread
    assert first.doubt <= second.doubt


@pytest.mark.parametrize(
    ("old", "new", "oddity", "place"),
    [
        ("cutter = { mass = 0.003 }", "cutter = { mass = 3.0 }", Oddity.HEAVY_BODY, "bodies.cutter.mass"),
        ("amplitude = 1.5e-3", "amplitude = 1.0", Oddity.LONG_STROKE, "pins.pin.amplitude"),
        ("gap = 40e-6", "gap = 4e-3", Oddity.GAP_ABOVE_STROKE, "plays.bridge.gap"),
        ("frequency = 110.0", "frequency = 6600.0", Oddity.SLOW_OR_FAST, "frequency"),
    ],
)
def test_what_is_unlikely_is_asked_about(old: str, new: str, oddity: Oddity, place: str) -> None:
    file = changed((old, new))
    asked = questions(file.mechanism, None)
    assert [(each.oddity, each.place_text) for each in asked] == [(oddity, place)]


def test_a_heavy_cutter_beside_a_light_motor_alone_is_asked_about() -> None:
    text = """
frequency = "100 Hz"
[bodies]
motor = { mass = "35 g" }
cutter = { mass = 3 }
[links]
mount = { between = ["ground", "motor"], stiffness = "200 N/mm" }
spring = { between = ["motor", "cutter"], stiffness = "1 N/mm" }
[outputs]
stroke = { cutter = 1 }
"""
    asked = questions(design_file_of_text(text, "two.toml").mechanism, None)
    assert [(each.oddity, each.place_text) for each in asked] == [
        (Oddity.HEAVY_FOR_HAND, "bodies.cutter.mass")
    ]


def test_nothing_is_asked_about_the_examples(trimmer_file: DesignFile, trimmer_motion: FoundMotion) -> None:
    assert questions(trimmer_file.mechanism, trimmer_motion) == ()
    for name in ("den-hartog", "gear-pair", "two-mass-stop", "held", "foil-shaver", "servo"):
        file = design_file_of_text(example_text(name), name)
        assert questions(file.mechanism, None) == ()
