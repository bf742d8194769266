"""After how many periods the orbit of a driven loop is looked for, with a solver that is given."""

from __future__ import annotations

import control
import numpy as np
import pytest

from trimmer import ClosedLoop, Drive, FrictionBacklash, OpenLoop, OrbitNotFoundError, Relay
from trimmer.orbits import forced_orbit as module
from trimmer.orbits.forced_orbit import _later, loop_orbit

DRIVE = Drive(2.0, 3.0, 0.4)
LOOP = OpenLoop(control.ss([[-0.7]], [[2.0]], [[1.0]], [[0.0]]), FrictionBacklash(0.5), DRIVE)


class Followed:
    """A loop that tells how it is followed, and a solver that answers what it is given."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, answers: list) -> None:
        self.asked: list = []
        self.answers, self.begun = answers, np.array([0.0])
        monkeypatch.setattr(module, "_later", self._later)
        monkeypatch.setattr(module, "_sizes", lambda loop, mode, state: ("sizes", mode, state))
        monkeypatch.setattr(module, "solve", self._solve)
        monkeypatch.setattr(module, "orbit_of", lambda loop, problem, shot, prediction: (shot, prediction))

    def _later(self, loop, mode, state, duration):
        periods = duration / DRIVE.period
        self.asked.append(pytest.approx(periods))
        return mode + 1, state + 1.0

    def _solve(self, problem, mode, state, span):
        assert (problem.modes, problem.mirrored, problem.driven) == (LOOP.modes, False, True)
        assert problem.sizes[:2] == ("sizes", mode)
        assert problem.sizes[2] is state
        assert span == DRIVE.period
        return self.answers.pop(0)


def test_newtons_method_is_tried_after_ever_more_periods(monkeypatch: pytest.MonkeyPatch) -> None:
    followed = Followed(monkeypatch, [None, None, "shot"])
    assert loop_orbit(LOOP) == ("shot", None)
    assert followed.asked == [8, 56, 448]
    followed = Followed(monkeypatch, ["shot"])
    assert loop_orbit(LOOP) == ("shot", None)
    assert followed.asked == [8]
    with pytest.raises(OrbitNotFoundError, match=r"the drive, 2\.0944 s, was found after 512 periods"):
        Followed(monkeypatch, [None] * 3)
        loop_orbit(LOOP)


def test_a_number_of_periods_is_kept_to(monkeypatch: pytest.MonkeyPatch) -> None:
    for settling in (0, 5):
        followed = Followed(monkeypatch, ["shot"])
        loop_orbit(LOOP, settling)
        assert followed.asked == [settling]
        Followed(monkeypatch, [None])
        with pytest.raises(OrbitNotFoundError, match=f"was found after {settling} periods"):
            loop_orbit(LOOP, settling)
    with pytest.raises(ValueError, match="settling"):
        loop_orbit(LOOP, -1)
    with pytest.raises(ValueError, match="the loop has no drive"):
        loop_orbit(ClosedLoop(control.tf([1.0], [1.0, 1.0]), Relay(1.0)))


def test_accumulating_events_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "follow", lambda modes, mode, state, duration: None)
    with pytest.raises(OrbitNotFoundError, match="events accumulate"):
        _later(LOOP, 0, np.zeros(LOOP.modes.layout.size), 1.0)
