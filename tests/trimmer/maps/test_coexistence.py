"""Motions that coexist, found from those of the cells around."""

import numpy as np
import pytest

from tests.trimmer.maps.machines import impact_oscillator, linear_oscillator
from trimmer import SerialRunner, WrongTypeError, coexisting_motions, motion_map
from trimmer.runners import ProcessRunner

SERIAL = SerialRunner()
OMEGA = np.linspace(6.5, 9.0, 26)
GRAZING, FOLD = 6.997666276, 8.566393659
"""Definition of the twin, reference cases: published example of pyHarm, rad/s; digits of the definition."""


@pytest.fixture(scope="module")
def swept():
    return motion_map(impact_oscillator(), {"frequency": OMEGA / (2 * np.pi)}, runner=SERIAL)


@pytest.fixture(scope="module")
def found(swept):
    return coexisting_motions(swept, runner=SERIAL)


def test_two_motions_coexist_between_grazing_and_fold_and_nowhere_else(found) -> None:
    between = (OMEGA > GRAZING) & (OMEGA < FOLD)
    np.testing.assert_array_equal(found.result.motion_count[0], np.where(between, 2, 1))
    assert found.several == tuple((0, int(column)) for column in np.flatnonzero(between))


def test_the_motion_that_was_found_first_stays_the_first(swept, found) -> None:
    np.testing.assert_array_equal(found.result.stroke, swept.stroke)


def test_it_is_said_what_was_searched(found) -> None:
    assert found.complete
    assert found.rounds > 5
    assert f"{found.tried} starts in {found.rounds} rounds" in found.searched
    assert "16 cells have several motions" in found.searched
    assert "was not looked for" in found.searched


def test_a_search_that_ends_early_says_so(swept) -> None:
    found = coexisting_motions(swept, runner=SERIAL, most_rounds=2)
    assert not found.complete
    assert "ended before it was done" in found.searched


@pytest.mark.slow
def test_processes_find_the_same(swept, found) -> None:
    assert coexisting_motions(swept, runner=ProcessRunner(2)).result.cells == found.result.cells


def test_each_motion_of_each_cell_has_a_row(found) -> None:
    frame = found.to_dataframe()
    assert len(frame) == 26 + 16
    several = frame[frame["frequency"] == OMEGA[10] / (2 * np.pi)]
    assert several["motion"].tolist() == [1, 2]
    assert several["kind"].tolist() == ["periodic", "periodic"]
    assert several["period_count"].tolist() == [1, 1]
    multipliers = [motion.largest_multiplier for motion in found.result.cells[10].motions]
    assert several["largest_multiplier"].tolist() == multipliers
    assert (several["largest_multiplier"] < 1.0).all()
    assert "16 of 26 cells have several motions" in repr(found)


@pytest.mark.slow
def test_a_map_on_its_side_has_the_same_motions() -> None:
    """Each motion goes to the eight cells around, along rows as along columns."""
    values = {"frequency": OMEGA[3:13:3] / (2 * np.pi), "stops.wall.gap": [9.5, 10.0, 10.5]}
    maps = [
        motion_map(impact_oscillator(), dict(each), runner=SERIAL)
        for each in (values.items(), reversed(values.items()))
    ]
    upright, aside = (coexisting_motions(each, runner=SERIAL) for each in maps)
    assert upright.result.motion_count.max() == 2
    np.testing.assert_array_equal(upright.result.motion_count, aside.result.motion_count.T)
    assert (upright.tried, upright.rounds) == (aside.tried, aside.rounds)


def test_motions_that_are_carried_on_everywhere_are_tried_nowhere() -> None:
    found = coexisting_motions(
        motion_map(linear_oscillator(), {"frequency": [1.3, 1.31]}, starts=2, runner=SERIAL), runner=SERIAL
    )
    assert (found.tried, found.rounds, found.complete, found.several) == (0, 0, True, ())
    assert "from 2 starts each" in found.searched
    assert "until no cell had a new one" in found.searched


def test_a_search_has_a_round_at_least(swept) -> None:
    with pytest.raises(ValueError, match="most_rounds"):
        coexisting_motions(swept, most_rounds=0, runner=SERIAL)


def test_what_is_no_map_is_refused() -> None:
    with pytest.raises(WrongTypeError, match="must be a MotionMap"):
        coexisting_motions(3)  # type: ignore[arg-type]
