"""From where and how often the orbit of a driven mechanism is looked for, with a solver that is given."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from trimmer import OrbitNotFoundError, UnsupportedMotionError, forced_orbit
from trimmer.contact.advance import Ending
from trimmer.mechanism import Body, Force, Link, Mechanism
from trimmer.response import forced_orbit as module

DRIVEN = Mechanism(
    {"one": Body(1.0)},
    frequency=1.2,
    links={"spring": Link(("ground", "one"), 40.0, 0.5)},
    forces={"push": Force("one", amplitude=100.0)},
)
FREE = Mechanism({"one": Body(1.0)}, links={"spring": Link(("ground", "one"), 40.0, 1.0)})


class Followed:
    """A motion that tells how it is followed, and a solver that answers what it is given."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, answers: list, ending=Ending.REACHED_END) -> None:
        self.asked: list = []
        self.answers, self.ending, self.period = answers, ending, 0.5
        monkeypatch.setattr("trimmer.response.starts.instant_of", self._instant)
        monkeypatch.setattr("trimmer.response.shooting.solve", self._solve)
        monkeypatch.setattr("trimmer.response.orbit.orbit_of", self._orbit)

    def _instant(self, flow, guess):
        assert flow is self
        return SimpleNamespace(state=(guess, 0), phase=0.0)

    def strobe(self, instant, periods):
        self.asked.append(("strobe", instant.state, periods))
        guess, before = instant.state
        end = SimpleNamespace(state=(guess, before + periods), phase=0.25)
        return SimpleNamespace(ending=self.ending, end=end)

    def at(self, state, phase, like):
        assert (like.state, like.phase) == (state, phase)
        return SimpleNamespace(state=state, phase=phase)

    def _solve(self, problem, instant):
        assert problem.flow is self
        self.asked.append(("solve", problem.periods, *instant.state, instant.phase))
        return self.answers.pop(0)

    def _orbit(self, flow, shot, periods):
        assert flow is self
        return SimpleNamespace(success=shot == "good", shot=shot, periods=periods)


def test_from_rest_newtons_method_is_tried_after_ever_more_periods(monkeypatch: pytest.MonkeyPatch) -> None:
    flow = Followed(monkeypatch, [None, "bad", "good"])
    found = module._driven(flow, 3, None, None)
    assert (found.shot, found.periods) == ("good", 3)
    assert flow.asked == [
        ("strobe", (None, 0), 8),
        ("solve", 3, None, 8, 0.25),
        ("strobe", (None, 8), 56),
        ("solve", 3, None, 64, 0.25),
        ("strobe", (None, 64), 448),
        ("solve", 3, None, 512, 0.25),
    ]
    flow = Followed(monkeypatch, ["good"])
    module._driven(flow, 1, None, None)
    assert len(flow.asked) == 2


def test_a_guess_is_tried_at_once_and_a_number_of_periods_is_kept_to(monkeypatch: pytest.MonkeyPatch) -> None:
    flow = Followed(monkeypatch, ["good"])
    module._driven(flow, 2, "guess", None)
    assert flow.asked == [("solve", 2, "guess", 0, 0.0)]
    for guess in (None, "guess"):
        flow = Followed(monkeypatch, ["good"])
        module._driven(flow, 1, guess, 5)
        assert flow.asked == [("strobe", (guess, 0), 5), ("solve", 1, guess, 5, 0.25)]
    flow = Followed(monkeypatch, ["good"])
    module._driven(flow, 1, None, 0)
    assert flow.asked == [("solve", 1, None, 0, 0.0)]


def test_what_does_not_return_is_given_back_and_what_cannot_be_followed_is_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert module._driven(Followed(monkeypatch, ["bad", "bad", "worse"]), 1, None, None).shot == "worse"
    with pytest.raises(OrbitNotFoundError, match="cannot be followed over 7 drive periods"):
        module._driven(Followed(monkeypatch, ["bad", "bad", None]), 7, None, None)
    flow = Followed(monkeypatch, [], Ending.DIVERGED)
    with pytest.raises(OrbitNotFoundError, match=f"cannot be followed: {Ending.DIVERGED.value}"):
        module._driven(flow, 1, None, None)
    assert len(flow.asked) == 1


def test_mechanisms_and_loops_are_handed_on(monkeypatch: pytest.MonkeyPatch) -> None:
    def handed_on(flow: object, *given: object) -> SimpleNamespace:
        return SimpleNamespace(edge=None, given=(flow.mechanism, *given))

    monkeypatch.setattr(module, "_driven", handed_on)
    assert module.mechanism_orbit(DRIVEN).given == (DRIVEN, 1, None, None)
    assert forced_orbit(DRIVEN).given == (DRIVEN, 1, None, None)
    assert forced_orbit(DRIVEN, 0, periods=3, guess="guess").given == (DRIVEN, 3, "guess", 0)
    with pytest.raises(ValueError, match="settling"):
        forced_orbit(DRIVEN, -1)
    with pytest.raises(ValueError, match="periods"):
        forced_orbit(DRIVEN, periods=0)
    monkeypatch.setattr("trimmer.orbits.forced_orbit.loop_orbit", lambda *given: given)
    assert forced_orbit("loop", 7) == ("loop", 7)


def test_without_a_drive_the_period_is_its_own(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "trimmer.response.self_excited.self_excited_orbit",
        lambda flow, instant: SimpleNamespace(edge=None, given=(flow, instant)),
    )
    flow, instant = forced_orbit(FREE, guess={"one": (2.0, 3.0)}).given
    assert flow.mechanism is FREE
    np.testing.assert_array_equal(instant.state, [2.0, 3.0])


def test_what_leans_on_a_pin_that_goes_on_never_repeats() -> None:
    def flow(ramp: bool) -> SimpleNamespace:
        return SimpleNamespace(modes=SimpleNamespace(layout=SimpleNamespace(ramp=ramp)))

    module.require_repeating(flow(False))
    with pytest.raises(UnsupportedMotionError, match="nothing repeats"):
        module.require_repeating(flow(True))
