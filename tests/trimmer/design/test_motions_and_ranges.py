"""Motions with their verdict, spectra, ranges, and what is asked about."""

from __future__ import annotations

import pytest

from trimmer import SerialRunner
from trimmer.design import DesignFile, DesignOutcome, DesignSettings, FoundMotion, LineKind, Motions
from trimmer.design.design_file import design_file_of_text
from trimmer.design.linear import linear_states
from trimmer.design.motions import motions_from_starts
from trimmer.design.plausible import questions
from trimmer.design.ranges import study_ranges
from trimmer.design.spectrum import spectra
from trimmer.design.verdict import verdict_on
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


def test_a_range_across_a_bound_leaves_the_verdict_open() -> None:
    file = changed(("gap = 40e-6", 'gap = "20 um..60 um"'))
    study = study_ranges(file.mechanism, file.ranges, file.targets, QUICK, SerialRunner())
    met = [trial.meets(file.targets) for trial in study.trials]
    assert met[0]
    assert not met[-1]
    assert study.meeting == pytest.approx(sum(met) / 9)
    assert study.doubt == pytest.approx(2 * study.meeting * (1 - study.meeting))
    motions = motions_from_starts(file.mechanism, QUICK)
    assert verdict_on(file.targets, motions, study).outcome is DesignOutcome.DEPENDS


def test_nothing_is_asked_about_the_examples(trimmer_file: DesignFile, trimmer_motion: FoundMotion) -> None:
    assert questions(trimmer_file.mechanism, trimmer_motion) == ()
    for name in ("den-hartog", "gear-pair", "two-mass-stop", "held", "foil-shaver", "servo"):
        file = design_file_of_text(example_text(name), name)
        assert questions(file.mechanism, None) == ()
