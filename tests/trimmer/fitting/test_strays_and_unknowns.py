"""Lines between harmonics, coordinates of numbers, and weak directions, on both sides of each limit."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tests.trimmer.fitting.made import trimmer
from trimmer import Mechanism
from trimmer.errors import FitError
from trimmer.fitting.stray import (
    StrayLine,
    fraction_of,
    in_words,
    peaks_of,
    place_of,
    repeats_after,
    tolerance,
)
from trimmer.fitting.unknowns import Unknown, bounds_of, unknowns_of, values_at
from trimmer.fitting.weak import TOLD, weak_directions


def stray(fraction: tuple[int, int] | None) -> StrayLine:
    return StrayLine("s", 1.0, 1.0, 1.0, fraction)


def test_fractions_are_found_within_their_tolerance() -> None:
    assert fraction_of(25.0 + 0.0625, 50.0, 0.0625) == (1, 2)
    assert fraction_of(25.0 - 0.0626, 50.0, 0.0625) is None
    assert fraction_of(50.0 * 7 / 8, 50.0, 1e-6) == (7, 8)
    assert fraction_of(50.0 * 10 / 9, 50.0, 1e-6) is None
    assert fraction_of(100.0, 50.0, 1e-6) is None
    assert fraction_of(0.5, 50.0, 1.0) is None
    assert fraction_of(691.0 * 5 / 6, 691.0, 1e-6) == (5, 6)


def test_a_strong_line_is_found_more_closely() -> None:
    assert tolerance(1e4) == pytest.approx(0.07)
    assert tolerance(100.0) == pytest.approx(0.25)
    assert tolerance(4.0) == 0.4


def test_a_motion_repeats_after_the_least_common_multiple_up_to_eight() -> None:
    assert repeats_after(()) == 1
    assert repeats_after((stray(None),)) == 1
    assert repeats_after((stray((1, 2)), stray((5, 3)), stray(None))) == 6
    assert repeats_after((stray((1, 3)), stray((1, 5)), stray((1, 2)))) == 6
    assert repeats_after((stray((1, 8)),)) == 8


@pytest.mark.parametrize("offset", [0.3, -0.3, 0.0, 0.45])
def test_a_line_between_bins_has_its_place(offset: float) -> None:
    count, place = 400, 37 + offset
    wave = np.hanning(count + 1)[:-1] * np.exp(2j * np.pi * place * np.arange(count) / count)
    for turn in (1.0, -1.0, 1.0j, -1.0j):
        assert place_of(turn * np.fft.fft(wave), 37) == pytest.approx(place, abs=1e-4)


def test_peaks_are_local_maxima_above_a_limit() -> None:
    power = np.array([9.0, 1.0, 3.0, 2.0, 5.0, 5.0, 1.0, 2.0, 1.0, 8.0])
    assert peaks_of(power, 1.5) == [2, 5, 7]
    assert peaks_of(power, 2.0) == [2, 5]


def test_periods_in_words() -> None:
    assert (in_words(1), in_words(3)) == ("one drive period", "3 drive periods")


def test_coordinates_are_logarithms_or_shares_of_the_start() -> None:
    gap = Unknown("plays.bridge.gap", "m", 4e-5, True)
    assert (gap.value(0.0), gap.value(math.log(3))) == pytest.approx((4e-5, 1.2e-4))
    assert gap.reach == pytest.approx(math.log(1000))
    offset = Unknown("pins.pin.offset", "m", -2e-3, False)
    assert (offset.value(0.5), offset.scale, offset.reach) == pytest.approx((-1e-3, 2e-3, 1000.0))
    phase = Unknown("pins.pin.phase", "rad", 0.25, False)
    assert (phase.value(0.5), phase.scale) == (0.75, 1.0)
    assert values_at((gap, phase), np.array([0.0, 1.0])) == [4e-5, 1.25]
    least, largest = bounds_of((gap, phase))
    assert largest == pytest.approx([math.log(1000), 1000.0])
    assert least == pytest.approx(-largest)
    assert (gap.short, Unknown("frequency", "Hz", 1.0, True).short) == ("gap of bridge", "frequency")


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
