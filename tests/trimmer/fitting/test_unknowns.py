"""Which numbers are fitted, and which directions of them a measurement says little of."""

import control
import numpy as np
import pytest

from tests.trimmer.fitting.made import trimmer
from trimmer import ClosedLoop, DeadZone, Mechanism
from trimmer.errors import FitError
from trimmer.fitting.unknowns import Unknown, unknowns_of
from trimmer.fitting.weak import TOLD, weak_directions


def test_numbers_above_zero_of_plays_and_frictions_are_usual() -> None:
    mechanism = trimmer().with_value("plays.bridge.damping", 0.0)
    found = unknowns_of(mechanism)
    assert [(each.place, each.unit, each.start, each.positive) for each in found] == [
        ("plays.bridge.gap", "m", 4e-5, True),
        ("plays.bridge.stiffness", "N/m", 3e4, True),
        ("frictions.blade.force", "N", 1.0, True),
    ]
    with pytest.raises(FitError, match="no play and no friction"):
        unknowns_of(Mechanism.from_toml("examples/den-hartog.toml").with_value("frictions.floor.force", 0.0))


def test_named_numbers_may_have_any_sign() -> None:
    mechanism = trimmer().with_value("pins.pin.offset", -1e-3)
    offset, phase = unknowns_of(mechanism, ["pins.pin.offset", "pins.pin.phase"])
    assert (offset.positive, offset.start) == (False, -1e-3)
    assert (phase.positive, phase.start, phase.unit) == (False, 0.0, "rad")
    (mass,) = unknowns_of(mechanism, ["bodies.motor.mass"])
    assert mass.positive
    loop = ClosedLoop(control.tf([1.0], [1.0, 1.0, 1.0]), 2.0 * DeadZone(1.0))
    factor, threshold = unknowns_of(loop, ["element.factor", "element.threshold"])
    assert (factor.positive, threshold.positive) == (False, True)


UNKNOWNS = (
    Unknown("plays.p.gap", "m", 4e-5, True),
    Unknown("pins.pin.offset", "m", -2e-3, False),
    Unknown("plays.p.damping", "N s/m", 1.0, True),
)


def test_a_number_that_changes_nothing_is_named_alone() -> None:
    jacobian = np.diag([50.0, 3.0, 80.0])
    (weak,) = weak_directions(UNKNOWNS, jacobian, 3.84)
    assert (weak.places, weak.changes) == (("pins.pin.offset",), (pytest.approx(TOLD),))
    assert weak.chi_square == pytest.approx((3.0 * TOLD) ** 2)
    assert "says little of the offset of pin: raising the offset of pin by 0.00019 m changes" in weak.message
    assert weak_directions(UNKNOWNS, jacobian, (2.99 * TOLD) ** 2) == ()
    assert weak_directions(UNKNOWNS, jacobian, (3.01 * TOLD) ** 2) == (weak,)
    (gap,) = weak_directions(UNKNOWNS, np.diag([3.0, 50.0, 80.0]), 3.84)
    assert "raising the gap of p by 10 %" in gap.message


def test_the_weakest_direction_stands_first_and_small_shares_are_left_out() -> None:
    jacobian = np.array([[1.0, 0.0, 0.1], [0.0, 2.0, 0.0], [0.0, 0.0, 0.0], [-30.0, 0.0, 300.0]])
    first, second = weak_directions(UNKNOWNS, jacobian, 3.84)
    assert first.chi_square < second.chi_square < 3.84
    # The damping changes by a tenth of the gap, too little to be named.
    assert (first.places, second.places) == (("plays.p.gap",), ("pins.pin.offset",))
    assert first.chi_square == pytest.approx((TOLD * 1.01) ** 2, rel=1e-3)


def test_numbers_that_make_up_for_each_other_are_named_together() -> None:
    jacobian = np.array([[20.0, 40.0, 0.0], [0.0, 0.0, 90.0], [0.1, 0.0, 0.0]])
    (weak,) = weak_directions(UNKNOWNS, jacobian, 3.84)
    assert weak.places == ("plays.p.gap", "pins.pin.offset")
    assert weak.changes == pytest.approx((TOLD, -TOLD / 2), rel=1e-4)
    assert "gap of p and offset of pin cannot be told apart" in weak.message
    assert "lowering the offset of pin by 9.5e-05 m" in weak.message
