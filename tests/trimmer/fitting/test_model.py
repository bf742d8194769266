"""Lines of an oscillator in displacement, velocity and acceleration, against its formula."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import oscillator
from trimmer.fitting import model as module
from trimmer.fitting.model import Model
from trimmer.fitting.unknowns import Unknown

STIFFNESS = Unknown("links.spring.stiffness", "N/m", 9e3, True)
MASS = Unknown("bodies.block.mass", "kg", 0.5, False)


def model(derivatives: int, period_count: int = 1, count: int = 3) -> Model:
    outputs = ("double", "block")
    return Model(oscillator(), (STIFFNESS, MASS), outputs, (derivatives, 0), period_count, count)


def wave(stiffness: float, mass: float) -> complex:
    """Return the complex amplitude of the displacement, driven by 7 N sin(w t)."""
    omega = 40 * math.pi
    return -7j / (stiffness - mass * omega**2 + 4j * omega)


@pytest.mark.parametrize("derivatives", [0, 1, 2])
def test_lines_are_those_of_the_quantity_that_was_measured(derivatives: int) -> None:
    found = model(derivatives).settled(np.array([math.log(1.1), 0.2]))
    assert found is not None
    expected = wave(9.9e3, 0.6)
    assert found.lines[0, 0] == pytest.approx(-2 * expected * (40j * math.pi) ** derivatives, rel=1e-9)
    assert found.lines[0, 1] == pytest.approx(expected, rel=1e-9)
    assert abs(found.lines[1:]).max() < 1e-9 * abs(found.lines[0]).min() * (40 * math.pi) ** derivatives * 9
    assert found.coordinates.tolist() == [math.log(1.1), 0.2]
    assert found.orbit.mechanism.value(STIFFNESS.place) == pytest.approx(9.9e3)


def test_lines_lie_at_fractions_of_the_drive_if_the_motion_was_measured_so() -> None:
    found = model(1, 3, 4).settled(np.zeros(2))
    assert found is not None
    expected = wave(9e3, 0.5)
    assert found.lines.shape == (4, 2)
    np.testing.assert_allclose(found.lines[2], [-2 * expected * 40j * math.pi, expected], rtol=1e-9)
    assert abs(found.lines[[0, 1, 3], 1]).max() < 1e-9 * abs(expected)


def test_a_motion_goes_on_from_a_neighbour() -> None:
    of = model(0)
    near = of.settled(np.zeros(2))
    assert near is not None
    for settling in (0, 48):
        found = of.continued(np.array([math.log(1.2), -0.1]), near, settling)
        assert found is not None
        assert found.lines[0, 1] == pytest.approx(wave(1.08e4, 0.45), rel=1e-9)


def test_numbers_that_no_mechanism_can_have_have_no_motion() -> None:
    of = model(0)
    near = of.settled(np.zeros(2))
    assert near is not None
    assert of.settled(np.array([0.0, -1.5])) is None
    assert of.continued(np.array([0.0, -1.5]), near) is None


class Followed:
    """Stands in for what a model asks of motions, and keeps it."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.asked = list[Any]()
        self.orbit: Any = None
        self.shot: Any = "shot"
        monkeypatch.setattr(
            module, "Settling", lambda flow, begin: SimpleNamespace(until_settled=self.settled(begin))
        )
        monkeypatch.setattr(module, "Return", lambda flow, periods: ("return", periods))
        monkeypatch.setattr(module, "solve", self.solve)
        monkeypatch.setattr(module, "orbit_of", self.orbit_of)
        monkeypatch.setattr(Model, "_lines", lambda model, orbit: "lines")

    def settled(self, begin: Any) -> Any:
        def until(within: int) -> Any:
            self.asked.append(("settled", begin, within))
            return self.orbit

        return until

    def solve(self, back: Any, instant: Any, patience: Any) -> Any:
        self.asked.append((back, instant, patience))
        return self.shot

    def orbit_of(self, flow: Any, shot: Any, periods: int) -> Any:
        self.asked.append(("orbit", shot, periods))
        return self.orbit


@pytest.mark.parametrize(
    ("stable", "neutral", "found"), [(True, False, True), (False, True, True), (False, False, False)]
)
def test_a_motion_is_solved_for_over_the_measured_periods_and_must_be_stable(
    monkeypatch: pytest.MonkeyPatch, stable: bool, neutral: bool, found: bool
) -> None:
    followed = Followed(monkeypatch)
    followed.orbit = SimpleNamespace(stable=stable, neutral=neutral)
    solved: Any = model(0, 3)._solved("flow", "there", "instant")  # type: ignore[arg-type]
    assert (solved is not None) is found
    if found:
        assert (solved.coordinates, solved.orbit, solved.lines) == ("there", followed.orbit, "lines")
    assert followed.asked == [(("return", 3), "instant", module.PATIENCE), ("orbit", "shot", 3)]
    followed.shot = None
    assert model(0, 3)._solved("flow", "there", "instant") is None  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("settles", "found"), [(None, False), (1, True), (2, False), (3, True), (6, True), (12, False)]
)
def test_what_settles_must_repeat_within_the_measured_periods(
    monkeypatch: pytest.MonkeyPatch, settles: int | None, found: bool
) -> None:
    followed = Followed(monkeypatch)
    if settles is not None:
        followed.orbit = SimpleNamespace(period_count=settles, instant="end", stable=True, neutral=False)
    of = model(0, 6 if settles != 2 else 3)
    assert (of._settled("flow", "there", "begin", 7) is not None) is found  # type: ignore[arg-type]
    assert followed.asked[0] == ("settled", "begin", 7)
    assert [each[1] for each in followed.asked[1:2]] == ["end"] * found


@pytest.mark.parametrize(
    ("solved", "settling", "expected"),
    [("motion", 5, "motion"), (None, 5, "settled"), (None, 0, None), (None, None, "settled")],
)
def test_a_motion_that_is_lost_is_followed_to_what_it_settles_to(
    monkeypatch: pytest.MonkeyPatch, solved: str | None, settling: int | None, expected: str | None
) -> None:
    asked = []
    flow = SimpleNamespace(at=lambda state, like: ("at", state, like), rest=lambda: "rest")
    monkeypatch.setattr(Model, "_flow", lambda model, coordinates: None if coordinates == "nowhere" else flow)
    monkeypatch.setattr(Model, "_solved", lambda model, *given: asked.append(given) or solved)
    monkeypatch.setattr(Model, "_settled", lambda model, *given: asked.append(given) or "settled")
    instant = SimpleNamespace(state="state")
    near: Any = SimpleNamespace(orbit=SimpleNamespace(instant=instant))
    given: Any = {} if settling is None else {"settling": settling}
    assert model(0).continued("there", near, **given) == expected  # type: ignore[arg-type, comparison-overlap]
    begun = (flow, "there", ("at", "state", instant))
    assert asked == [begun, (*begun, 48 if settling is None else 5)][: 1 + (expected == "settled")]
    assert model(0).continued("nowhere", near) is None  # type: ignore[arg-type]
    asked.clear()
    assert model(0).settled("there") == "settled"  # type: ignore[arg-type, comparison-overlap]
    assert asked == [(flow, "there", "rest", 400)]
