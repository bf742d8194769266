"""The motions behind the sliders: solved for where they stand, and as a closed form says."""

import itertools
import math
from dataclasses import dataclass

import numpy as np
import pytest

from tests.trimmer.design.made import OSCILLATOR
from trimmer import MotionKind, SerialRunner
from trimmer.deadline import Deadline
from trimmer.design import DesignSettings, NumberRole, Remedies, Remedy, Stage, Study, VariedNumber
from trimmer.design.parameter_studies.solved_grid import MovedNumber, SolvedGrid, numbers_to_move, solved_grid
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.design.trials.remedies import Change
from trimmer.design.trials.surroundings import Around

SPEED = VariedNumber(NumberRole.SPEED, "frequency", "", "Hz", 20.0, 10.0, 30.0)
DAMPING = VariedNumber(NumberRole.OTHER, "links.spring.damping", "", "N s/m", 4.0, 0.0, 16.0)
FILE = design_file_of_text(OSCILLATOR + "[targets]\nstroke_at_least = { block = '10 mm' }\n", "mine.toml")


def grid(*moved: MovedNumber, size: int = 4, shaken: str | None = None) -> SolvedGrid:
    settings = DesignSettings(cell_periods=2000, grid=size)
    found = solved_grid(FILE.mechanism, moved, FILE.targets, shaken, settings, SerialRunner(), switched=False)
    assert found is not None
    return found


def amplitude(frequency: float, damping: float) -> complex:
    """Return that of 7 N sin(w t) over 0.5 s² + c s + 9000, m."""
    omega = 2 * np.pi * frequency
    return 7.0 / complex(9e3 - 0.5 * omega**2, damping * omega)


def test_each_motion_is_the_closed_form_at_its_own_numbers() -> None:
    found = grid(MovedNumber(SPEED), MovedNumber(DAMPING, (5.5,)), shaken="block")
    assert found.values == ((10.0, 15.0, 20.0, 25.0), (4.0, 5.5, 8.0, 12.0, 16.0))
    assert found.signals == (("block", "m"), ("acceleration of block", "m/s²"))
    for (frequency, damping), motion in zip(itertools.product(*found.values), found.motions, strict=True):
        wave, omega = amplitude(frequency, damping), 2 * np.pi * frequency
        assert (motion.kind, motion.period_count) == (MotionKind.PERIODIC, 1)
        assert motion.measures[0] == pytest.approx(2 * abs(wave), rel=1e-9)
        assert motion.duration == pytest.approx(1 / frequency)
        times = np.linspace(0, motion.duration, motion.curves.shape[1])
        expected = (wave * np.exp(1j * omega * times)).imag
        np.testing.assert_allclose(motion.curves[0], expected, atol=1e-9 * abs(wave))
        np.testing.assert_allclose(motion.curves[1], -(omega**2) * expected, atol=1e-9 * omega**2 * abs(wave))
        ((p, k, size),) = motion.lines[1]
        assert (p, k) == (1, 1)
        assert size == pytest.approx(omega**2 * abs(wave), rel=1e-9)


def test_a_finer_grid_holds_the_coarse_one() -> None:
    coarse, fine = grid(MovedNumber(SPEED)), grid(MovedNumber(SPEED), size=8)
    assert set(coarse.values[0]) < set(fine.values[0])
    assert len(fine.motions) == 8


@dataclass(frozen=True)
class Leaving:
    """Does no cell above a speed."""

    most: float

    def results(self, work, cells):
        return (work(each) for each in cells if each[0] <= self.most)


def test_a_grid_that_is_not_whole_is_not_shown() -> None:
    moved, settings = (MovedNumber(SPEED),), DesignSettings(cell_periods=200, grid=8)

    def found(most: float) -> SolvedGrid | None:
        return solved_grid(FILE.mechanism, moved, FILE.targets, None, settings, Leaving(most), switched=False)

    coarse = found(26.0)
    assert coarse is not None
    assert len(coarse.motions) == 4
    assert found(22.0) is None


def test_what_grows_or_cannot_be_is_kept_as_such() -> None:
    less = VariedNumber(NumberRole.OTHER, "links.spring.damping", "", "N s/m", 4.0, -12.0, 4.0)
    found = grid(MovedNumber(less))
    assert found.values == ((-8.0, -4.0, 0.0, 4.0),)
    assert found.motions[-1].kind is MotionKind.PERIODIC
    assert all(each.kind in (None, MotionKind.DIVERGING) for each in found.motions[:2])
    assert math.isnan(found.motions[0].measures[0]) or found.motions[0].kind is MotionKind.DIVERGING


def test_what_is_recommended_comes_first_and_is_on_the_grid() -> None:
    change = Change("links.spring.damping", "N s/m", 4.0, 1.25)
    best = Remedy((change,), Around((), ()), beside=True)
    moved = numbers_to_move(FILE.mechanism, (SPEED,), (), Remedies((best,), None, (), 1, (), 1))
    assert [each.number.place for each in moved] == ["links.spring.damping", "frequency"]
    assert {1.25, 4.0} <= set(moved[0].values(4))
    assert moved[1].also == ()


def test_without_time_the_sliders_are_left_out_and_named() -> None:
    told = []
    study = Study(
        FILE, DesignSettings(starts=1, grid=1), SerialRunner(),
        told=lambda *each: told.append(each), deadline=Deadline(0.0, 1.0),
    )  # fmt: skip
    assert study.grid(study.motions(), (MovedNumber(SPEED),)) is None
    assert told[-1] == (Stage.SLIDERS, ("frequency",), 0, 0)
