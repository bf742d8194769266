from __future__ import annotations

import numpy as np
import pytest

from tests.trimmer.maps.machines import impact_oscillator
from trimmer.errors import WrongTypeError
from trimmer.maps.coexistence import coexisting_motions
from trimmer.maps.motion_map import motion_map
from trimmer.runners.processes import ProcessRunner
from trimmer.runners.runner import SerialRunner

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


def test_what_is_no_map_is_refused() -> None:
    with pytest.raises(WrongTypeError, match="must be a MotionMap"):
        coexisting_motions(3)  # type: ignore[arg-type]
