"""What is begun before an instant is finished, and nothing is begun after it."""

from dataclasses import replace

import numpy as np
import pytest

from tests.trimmer.design.made import OSCILLATOR, oscillator
from tests.trimmer.runners.cells import double, zero
from trimmer import FollowSettings, SerialRunner, follow, respond
from trimmer.branches import BranchEnd
from trimmer.deadline import NEVER, Deadline
from trimmer.design import DesignFile, DesignOutcome, DesignSettings, Stage, Study
from trimmer.design.motions import FEWEST, periods_within
from trimmer.design.specification.design_file import design_file_of_text
from trimmer.runners import ProcessRunner, Runner
from trimmer.runners.timed import TimedRunner

PAST = Deadline(0.0, 1.0)
FEW = DesignSettings(
    starts=2, cells=2, cell_periods=20, neighbours=3, trials=1, most_points=3, range_points=2, grid=1
)


def test_a_deadline_passes_and_is_shared() -> None:
    assert PAST.passed and PAST.left == 0
    assert not NEVER.passed and NEVER.share(0.3) == NEVER
    hour = Deadline.after(3600.0)
    assert not hour.passed and 3590 < hour.left <= 3600
    assert hour.share(0.25).end == pytest.approx(hour.begun + 900.0)


@pytest.mark.parametrize("runner", [SerialRunner(), ProcessRunner(2, chunk=2)])
def test_cells_after_the_deadline_are_left_out_or_replaced(runner: Runner) -> None:
    told: list[tuple[int, int]] = []
    whole = TimedRunner(runner, NEVER, told=lambda *each: told.append(each))
    assert sorted(whole.results(double, range(1, 6))) == [2, 4, 6, 8, 10]
    assert told == [(done, 5) for done in range(1, 6)]
    assert list(TimedRunner(runner, PAST).results(double, range(1, 6))) == []
    assert list(TimedRunner(runner, PAST, zero).results(double, range(1, 6))) == [0] * 5


def test_starts_and_orbits_end_at_the_deadline() -> None:
    made = oscillator()
    assert respond(made, starts=5, deadline=PAST).starts == 1
    assert respond(made, starts=5, deadline=Deadline.after(3600.0)).starts == 5
    cut = follow(made, "frequency", 20.0, 21.0, settings=FollowSettings(quiet=True, deadline=PAST))
    assert (cut.reason, len(cut.points)) == (BranchEnd.OUT_OF_TIME, 1)
    assert not cut.reason.is_success


def test_as_many_periods_are_followed_as_there_is_time_for() -> None:
    made = oscillator()
    assert periods_within(made, 1000, np.inf) == periods_within(made, 1000, 3600.0) == 1000
    assert periods_within(made, 1000, 1e-9) == FEWEST
    some = {periods_within(made, 10**6, seconds) for seconds in (0.03, 0.05, 0.07)}
    assert some <= {FEWEST * 2**doublings for doublings in range(14)}
    assert periods_within(replace(made, frequency=None, forces={}), 1000, 1e-9) == 1000


@pytest.fixture(scope="module")
def stopped() -> DesignFile:
    text = OSCILLATOR.replace("mass = 0.5", 'mass = "0.4 kg..0.6 kg"')
    return design_file_of_text(text + WANTED, "open.toml")


WANTED = """
[stops]
wall = { between = ["ground", "block"], stiffness = 2e4, damping = 50.0, gap = 4e-3 }
[targets]
stroke_at_least = "20 mm"
"""


def test_without_time_a_design_has_its_verdict_and_says_what_it_lacks(stopped: DesignFile) -> None:
    cut = Study(stopped, FEW, SerialRunner(), deadline=PAST).whole()
    assert cut.verdict.outcome is DesignOutcome.MISSED and cut.motion is not None
    assert {stage for stage, _ in cut.cut} == set(Stage)
    assert (cut.ranges, cut.remedies, cut.sensitivities, cut.maps, cut.paths) == (None, None, None, (), ())
    assert cut.motions.neighbours is None and cut.motions.starts == 1


def test_with_time_enough_a_design_is_that_without_a_limit(stopped: DesignFile) -> None:
    free, timed = (
        Study(stopped, FEW, SerialRunner(), deadline=each).whole() for each in (NEVER, Deadline.after(3600.0))
    )
    assert free.cut == timed.cut == ()
    assert free.settings == timed.settings and free.verdict == timed.verdict
    assert free.remedies == timed.remedies and free.ranges == timed.ranges
    assert [each.result.cells for each in free.maps] == [each.result.cells for each in timed.maps]
