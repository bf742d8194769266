"""Elasticities of measures that are powers of a number, and of an oscillator in closed form."""

from __future__ import annotations

from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tests.trimmer.design.made import motion, oscillator, oscillator_amplitude
from trimmer import Mechanism
from trimmer.design import sensitivity
from trimmer.design.sensitivity import Elasticity, Sensitivities, Sensitivity, designable, sensitivities
from trimmer.design.targets import Measure
from trimmer.design.trial import Asked
from trimmer.mechanism import Body, Force, Friction, Link, Pin, Play

STROKE, WEAR = Asked(Measure.STROKE, "block"), Asked(Measure.WEAR_POWER, "blade")
DOUBLE = Asked(Measure.STROKE, "double")
ENDS = ("ground", "block")


def change(power: float, step: float) -> float:
    """Return the central difference of x^power at 1 over the mean of both sides."""
    above, below = (1 + step) ** power, (1 - step) ** power
    return (above - below) / (step * (above + below))


def test_two_slopes_agree_within_a_tenth_and_a_thousandth() -> None:
    assert sensitivity._agree(1.0, 1.112)
    assert sensitivity._agree(1.112, 1.0)
    assert not sensitivity._agree(1.0, 1.113)
    assert not sensitivity._agree(-1.113, -1.0)
    assert sensitivity._agree(-1.0, -1.112)
    assert sensitivity._agree(-1.112, -1.0)
    assert not sensitivity._agree(1.0, -1.0)
    assert sensitivity._agree(0.0009, -0.0001)


def test_numbers_that_are_zero_or_no_sizes_are_not_changed() -> None:
    made = Mechanism(
        bodies={"block": Body(0.5)},
        frequency=110.0,
        pins={"pin": Pin("ground", 1e-3, 0.3, 0.2, -0.1, 2)},
        links={"spring": Link(("pin", "block"), 2e3)},
        plays={"play": Play(ENDS, 3e3, 0.0, 4e-5)},
        frictions={"blade": Friction(ENDS, 0.5, 0.7)},
        forces={"push": Force("block", 0.0, 2.0, 0.1, 3)},
    )
    assert list(designable(made)) == [
        ("frequency", "Hz", 110.0),
        ("bodies.block.mass", "kg", 0.5),
        ("pins.pin.amplitude", "m", 1e-3),
        ("pins.pin.velocity", "m/s", -0.1),
        ("links.spring.stiffness", "N/m", 2e3),
        ("plays.play.stiffness", "N/m", 3e3),
        ("plays.play.gap", "m", 4e-5),
        ("frictions.blade.force", "N", 0.5),
        ("frictions.blade.static", "N", 0.7),
        ("forces.push.amplitude", "N", 2.0),
    ]
    free = Mechanism(bodies={"block": Body(0.5)}, links={"spring": Link(ENDS, 2e3)})
    assert [each[0] for each in designable(free)] == ["bodies.block.mass", "links.spring.stiffness"]


def test_ranks_go_by_size_and_leave_out_what_has_no_influence() -> None:
    def entry(place: str, value: float | None) -> Sensitivity:
        entries = () if value is None else (Elasticity(WEAR, 9.0, True), Elasticity(STROKE, value, True))
        return Sensitivity(place, "m", 1.0, entries)

    values = {"a": 0.5, "b": -2.0, "c": 0.001, "d": None, "e": 0.0011, "f": -0.9}
    found = Sensitivities(1e-3, tuple(entry(*each) for each in values.items()), ())
    assert [each.place for each in found.ranked(STROKE)] == ["b", "f", "a", "e"]
    assert found.entries[3].of(STROKE) is None
    assert found.entries[1].of(STROKE) == Elasticity(STROKE, -2.0, True)


def test_slopes_are_central_differences_over_half_a_thousandth(monkeypatch: pytest.MonkeyPatch) -> None:
    made, moving = oscillator(), motion()

    def measures(
        mechanism: Mechanism, place: str, value: float, near: object, asked: tuple[Asked, ...]
    ) -> Mapping[Asked, float] | None:
        assert (mechanism, near) == (made, moving)
        assert Measure.PERIOD not in {each.measure for each in asked}
        factor = value / mechanism.value(place)
        if place == "links.spring.damping" and abs(factor - 1) < 0.75e-3:
            return None
        if place == "links.spring.stiffness" and factor > 1.0008:
            return None
        kinked = factor**2 if factor < 1.0007 else factor**3
        powers = {STROKE: factor**3, DOUBLE: kinked}
        return {each: powers.get(each, 0.0) for each in asked}

    monkeypatch.setattr(sensitivity, "_measures", measures)
    found = sensitivities(made, moving)
    assert found.step == 1e-3
    assert found.failed == ("links.spring.stiffness", "links.spring.damping")
    assert [(each.place, each.unit, each.value) for each in found.entries] == [
        ("frequency", "Hz", 20.0),
        ("bodies.block.mass", "kg", 0.5),
        ("forces.shaker.amplitude", "N", 7.0),
    ]
    for each in found.entries:
        first, second = each.elasticities  # of the acceleration, which is zero, there is none
        assert (first.asked, first.smooth) == (STROKE, True)
        assert first.value == pytest.approx(change(3.0, 0.5e-3), rel=1e-12)
        assert (second.asked, second.smooth) == (DOUBLE, False)
        assert second.value == pytest.approx(change(2.0, 0.5e-3), rel=1e-12)


def test_slopes_of_an_oscillator_are_those_of_its_formula() -> None:
    moving: Any = motion(state=np.zeros(2), period_count=1)
    found = {each.place: each for each in sensitivities(oscillator(), moving).entries}
    sizes = [oscillator_amplitude(stiffness=9e3 * factor) for factor in (1 - 5e-4, 1 + 5e-4)]
    exact = (sizes[1] - sizes[0]) / (5e-4 * sum(sizes))
    for asked in (STROKE, DOUBLE):
        stiffness = found["links.spring.stiffness"].of(asked)
        assert stiffness is not None
        assert (stiffness.value, stiffness.smooth) == (pytest.approx(exact, rel=1e-6), True)
        force = found["forces.shaker.amplitude"].of(asked)
        assert force is not None
        assert force.value == pytest.approx(1.0, rel=1e-8)


def test_what_no_mechanism_can_have_has_no_measures() -> None:
    assert sensitivity._measures(oscillator(), "bodies.block.mass", -0.5, motion(), (STROKE,)) is None
    below_zero = sensitivity._slopes(oscillator(), "bodies.block.mass", 0.5, motion(), (STROKE,), 1.5)
    assert below_zero is None


def test_measures_are_those_of_the_orbit_of_the_changed_mechanism(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []

    def solved(mechanism: Mechanism, period_count: int, state: object) -> SimpleNamespace:
        asked.append((mechanism.value("bodies.block.mass"), period_count, state))
        return SimpleNamespace(success=len(asked) < 3, measures="measures", period_count=5)

    monkeypatch.setattr(sensitivity, "mechanism_orbit", solved)
    monkeypatch.setattr(sensitivity, "measured", lambda *given: given)
    found = motion(period_count=3)
    of = sensitivity._measures(oscillator(), "bodies.block.mass", 2.5, found, (STROKE,))
    assert of == {STROKE: ("measures", STROKE, 5)}
    free = motion(period_count=None)
    assert sensitivity._measures(oscillator(), "bodies.block.mass", 2.5, free, (STROKE,))
    assert asked == [(2.5, 3, found.state), (2.5, 1, free.state)]
    assert sensitivity._measures(oscillator(), "bodies.block.mass", 2.5, found, (STROKE,)) is None
