"""Which values are tried for a remedy, with trials whose answer is known."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import motion, oscillator, output
from trimmer import Mechanism, MotionKind, SerialRunner
from trimmer.design import remedies as module
from trimmer.design.motions import Motions
from trimmer.design.remedies import Remedy, _interleaved, _nearest, _places, _rounded, remedies, remedies_by
from trimmer.design.sensitivity import Elasticity, Sensitivities, Sensitivity
from trimmer.design.settings import DesignSettings
from trimmer.design.targets import Measure, Target
from trimmer.design.trial import Asked, Trial
from trimmer.mechanism import Link

STROKE = Asked(Measure.STROKE, "block")
TARGET = Target("stroke_at_least", Measure.STROKE, "block", 1.0)
SETTINGS = DesignSettings(starts=3, trials=4, cell_periods=55)


@dataclasses.dataclass
class Limit:
    """A trial whose stroke is 1 m where a value is beyond a limit, and 0 m before; it counts its calls."""

    smallest: float = -math.inf
    largest: float = math.inf
    asked: list[float] = dataclasses.field(default_factory=list)

    def __call__(self, values: tuple[float, ...]) -> Trial:
        self.asked.append(values[0])
        met = not self.smallest < values[0] < self.largest
        return Trial(values, MotionKind.PERIODIC, 1, ((STROKE, float(met)),))


@pytest.mark.parametrize(
    ("value", "away_from", "rounded"),
    [
        (1.23456, 1.0, 1.24),
        (1.23456, 2.0, 1.23),
        (0.0451234, 0.05, 0.0451),
        (0.0451234, 0.04, 0.0452),
        (123456.0, 1e5, 124000.0),
        (1.23, 1.0, 1.23),
        (1.23, 2.0, 1.23),
        (0.999, 0.5, 0.999),
        (-2.345, -3.0, -2.34),
        (-2.345, -2.0, -2.35),
    ],
)
def test_values_are_rounded_away_from_the_bound(value: float, away_from: float, rounded: float) -> None:
    assert _rounded(value, away_from) == rounded


def test_places_are_taken_from_each_list_in_turn() -> None:
    assert _interleaved([["a", "b", "c"], ["b"], ["d", "a"]]) == ["a", "b", "d", "c"]
    assert _interleaved([]) == []


def test_the_nearest_value_is_bracketed_by_six_halvings() -> None:
    limit, before, best = Limit(largest=1.7), 1.5, 2.0
    side = [limit((each,)) for each in (1.2, before, best, 3.0)]
    limit.asked.clear()
    found = _nearest(limit, 1.0, side, (TARGET,))  # type: ignore[arg-type]
    expected = []
    for _ in range(6):
        middle = math.sqrt(before * best)
        expected.append(middle)
        before, best = (before, middle) if middle >= 1.7 else (middle, best)
    assert limit.asked[:-1] == pytest.approx(expected, rel=1e-12)
    assert found is not None
    assert found.values == (math.ceil(100 * best) / 100,) == (limit.asked[-1],)


def test_a_first_trial_that_meets_is_bracketed_from_the_value_itself() -> None:
    limit = Limit(smallest=0.8)
    found = _nearest(limit, 1.0, [limit((0.5,))], (TARGET,))  # type: ignore[arg-type]
    assert limit.asked[1] == pytest.approx(math.sqrt(0.5))
    assert found is not None
    assert 0.78 <= found.values[0] <= 0.8


def test_a_rounded_value_that_misses_is_not_taken() -> None:
    class Gap(Limit):
        def __call__(self, values: tuple[float, ...]) -> Trial:
            trial = super().__call__(values)
            few = values[0] == float(f"{values[0]:.3g}") and len(self.asked) > 1
            return dataclasses.replace(trial, measures=((STROKE, 0.0),)) if few else trial

    gap = Gap(largest=1.7)
    found = _nearest(gap, 1.0, [gap((math.pi,))], (TARGET,))  # type: ignore[arg-type]
    assert found is not None
    assert found.values[0] != gap.asked[-1]
    assert 1.7 <= found.values[0] < 1.74


def test_where_nothing_meets_nothing_is_nearest() -> None:
    limit = Limit(largest=9.0)
    assert _nearest(limit, 1.0, [limit((2.0,)), limit((3.0,))], (TARGET,)) is None  # type: ignore[arg-type]
    assert len(limit.asked) == 2


def use(monkeypatch: pytest.MonkeyPatch, limit: Limit) -> list[tuple[Any, ...]]:
    """Let a limit stand for the motions; return what is asked of it."""
    made: list[tuple[Any, ...]] = []

    def work(*arguments: Any) -> Limit:
        made.append(arguments)
        return limit

    monkeypatch.setattr(module, "TrialWork", work)
    return made


def test_both_sides_of_a_number_are_tried_up_to_a_factor_of_three(monkeypatch: pytest.MonkeyPatch) -> None:
    limit = Limit(largest=1.4e4)
    made = use(monkeypatch, limit)
    found, trials = remedies_by(
        oscillator(), "links.spring.stiffness", "N/m", (TARGET,), SETTINGS, SerialRunner()
    )
    ((mechanism, places, asked, periods),) = made
    assert (places, periods) == (("links.spring.stiffness",), 55)
    assert STROKE in asked
    assert mechanism.value("links.spring.stiffness") == 9e3
    steps = 3.0 ** (np.arange(1, 5) / 4)
    assert limit.asked[:8] == pytest.approx([*(9e3 / steps), *(9e3 * steps)])
    (remedy,) = found
    assert (remedy.place, remedy.unit, remedy.before) == ("links.spring.stiffness", "N/m", 9e3)
    assert 1.4e4 <= remedy.after < 1.42e4
    assert (remedy.trial.values, remedy.meeting) == ((remedy.after,), 0)
    assert trials == len(limit.asked) == 15
    assert remedy.change == pytest.approx(math.log(remedy.after / 9e3))


def test_remedies_from_all_starts_stand_first_and_then_the_smaller_ones(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    use(monkeypatch, Limit(largest=1.4e4, smallest=8e3))
    big, small = output(0.0, 2.0), output(0.0, 0.5)

    def motions(mechanism: Mechanism, settings: DesignSettings) -> Motions:
        assert settings is SETTINGS
        fully = mechanism.value("links.spring.stiffness") > 9e3
        parts = [("block", big, 3 if fully else 2), ("block", small, 0 if fully else 1)]
        made = tuple(motion(outputs={name: each}, starts=count) for name, each, count in parts)
        return Motions(made, 3, 0, 0, "", False)

    monkeypatch.setattr(module, "motions_from_starts", motions)
    monkeypatch.setattr(module, "PLACES", 1)
    ranked = Sensitivity("links.spring.stiffness", "N/m", 9e3, (Elasticity(STROKE, 1.0, True),))
    slopes = Sensitivities(1e-3, (ranked,), ())
    found = remedies(oscillator(), (TARGET,), (TARGET,), slopes, SETTINGS, SerialRunner())
    assert [each.meeting for each in found.found] == [3, 2]
    assert found.found[0].after > 1.4e4 > 8e3 > found.found[1].after
    assert (found.starts, found.tried, found.farthest) == (3, ("links.spring.stiffness",), 3.0)
    assert found.trials == 8 + 2 * 7
    assert abs(found.found[1].change) < abs(found.found[0].change)


def test_smaller_changes_stand_first(monkeypatch: pytest.MonkeyPatch) -> None:
    use(monkeypatch, Limit(largest=1.4e4, smallest=8e3))
    alike = Motions((motion(outputs={"block": output(0.0, 2.0)}, starts=3),), 3, 0, 0, "", False)
    monkeypatch.setattr(module, "motions_from_starts", lambda mechanism, settings: alike)
    ranked = Sensitivity("links.spring.stiffness", "N/m", 9e3, (Elasticity(STROKE, 1.0, True),))
    monkeypatch.setattr(module, "PLACES", 1)
    slopes = Sensitivities(1e-3, (ranked,), ())
    found = remedies(oscillator(), (TARGET,), (TARGET,), slopes, SETTINGS, SerialRunner()).found
    assert [each.after < 9e3 for each in found] == [True, False]


def entry(place: str, value: float) -> Sensitivity:
    return Sensitivity(place, "N/m", 1.0, (Elasticity(STROKE, value, True),))


def test_numbers_of_influence_are_tried_before_the_others() -> None:
    links = {f"l{number}": Link(("ground", "block"), 1.0 + number) for number in range(20)}
    made = dataclasses.replace(oscillator(), links=links)
    every = [each[0] for each in _places(made, (), None)]
    assert every == [
        "frequency",
        "bodies.block.mass",
        *(f"links.l{number}.stiffness" for number in range(10)),
    ]
    slopes = Sensitivities(1e-3, (entry("links.l3.stiffness", 1.0), entry("links.l15.stiffness", -2.0)), ())
    found = _places(made, (TARGET,), slopes)
    assert len(found) == 12
    assert found[0] == ("links.l3.stiffness", "N/m", 4.0)
    assert [each[0] for each in found[1:4]] == ["links.l15.stiffness", "frequency", "bodies.block.mass"]
    many = tuple(entry(f"links.l{number}.stiffness", 1.0 + number) for number in range(20))
    best = [each[0] for each in _places(made, (TARGET,), Sensitivities(1e-3, many, ()))]
    assert best == [f"links.l{number}.stiffness" for number in range(8, 20)]


def test_a_change_is_the_logarithm_of_its_factor() -> None:
    trial = Limit()((1.0,))
    assert Remedy("p", "m", 2.0, 1.0, trial).change == pytest.approx(-math.log(2))
