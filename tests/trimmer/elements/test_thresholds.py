"""A relay's thresholds by hand: phases of switching, harmonics, derivatives and every bound of them."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest

from trimmer.elements.backlashes.backlash_bounds import ROUNDED_UP
from trimmer.elements.relay import Relay
from trimmer.elements.small_gains import SmallGains, real_small_gains
from trimmer.elements.threshold_relay import Thresholds

LOOP = Thresholds(level=3.0, dead_zone=0.2, hysteresis=0.5)
REST = Thresholds(level=3.0, dead_zone=0.5, hysteresis=0.2)
EDGE = Thresholds(level=3.0, dead_zone=0.35, hysteresis=0.35)
BARE = Thresholds(level=3.0, dead_zone=0.7, hysteresis=0.0)
ALL = (LOOP, REST, EDGE, BARE)
SIZE = 6.0 / (math.pi * 0.7)


def angles(relay: Thresholds, u: float) -> tuple[float, float]:
    """asin u and asin(u off/on), with the same ``on`` = 0.7 for all."""
    return math.asin(u), math.asin(u * (relay.dead_zone - relay.hysteresis) / 0.7)


@pytest.mark.parametrize(("relay", "off"), [*zip(ALL, (-0.3, 0.3, 0.0, 0.7), strict=True)])
def test_where_a_relay_switches(relay: Thresholds, off: float) -> None:
    assert (relay.on, relay.off) == pytest.approx((0.7, off), abs=1e-16)
    assert relay.size == pytest.approx(SIZE, rel=1e-15)
    assert relay.rests is (off >= 0)
    assert relay.silence == 0.0 if off >= 0 else math.isnan(relay.silence)
    assert relay.silent(np.array([0.6, relay.on, 0.8])).tolist() == [True, True, False]
    rising, falling = relay.cosines(np.array([0.9, 2.0, math.inf]))
    np.testing.assert_allclose(rising[:2], [math.sqrt(1 - (0.7 / a) ** 2) for a in (0.9, 2.0)], rtol=1e-15)
    np.testing.assert_allclose(falling[:2], [math.sqrt(1 - (off / a) ** 2) for a in (0.9, 2.0)], rtol=1e-15)
    assert (rising[2], falling[2]) == (1.0, 1.0)


@pytest.mark.parametrize("relay", ALL)
@pytest.mark.parametrize("amplitude", [0.7001, 0.9, 1.3, 20.0])
def test_harmonics_slope_and_gain_of_the_mean_are_those_of_the_four_phases(
    relay: Thresholds, amplitude: float
) -> None:
    u, given = 0.7 / amplitude, np.array([amplitude])
    alpha, rho = angles(relay, u)
    for n in (1, 3, 5, 7):
        exact = SIZE * u / n * (cmath.exp(-1j * n * alpha) + cmath.exp(1j * n * rho))
        assert abs(relay.harmonic(given, n)[0] - exact) < 1e-13 * SIZE
    rising, falling = relay.cosines(given)
    assert relay._lag(given, rising, falling)[0] == pytest.approx(0.5 * (alpha - rho), rel=1e-11, abs=1e-15)
    slope = SIZE * (cmath.exp(-2j * alpha) / math.cos(alpha) + cmath.exp(2j * rho) / math.cos(rho))
    assert relay.slope(given)[0] == pytest.approx(slope, rel=1e-10)
    gain = 3.0 / (math.pi * amplitude) * (1.0 / math.cos(alpha) + 1.0 / math.cos(rho))
    assert relay.mean_gain(given)[0] == pytest.approx(gain, rel=1e-10)


def test_the_output_changes_at_its_phases_and_not_next_to_them() -> None:
    relay, amplitude = LOOP, np.full(6, 0.8)
    rising, falling = (float(each) for each in relay.cosines(np.array(0.8)))
    start = math.atan2(relay.on / 0.8, rising)
    duration = math.pi - start - math.atan2(relay.off / 0.8, falling)
    assert ((start + duration) - start, (start + math.pi) - start) == (duration, math.pi)
    end = start + math.pi + duration
    assert end - start - math.pi == duration
    phases = np.array([start, start + 0.5 * duration, start + duration, start + math.pi, end - 1e-9, end])
    assert relay.output(phases, amplitude).tolist() == [3.0, 3.0, 0.0, -3.0, -3.0, 0.0]
    with np.errstate(invalid="ignore"):
        assert np.isnan(relay.output(np.zeros(2), np.array([0.7, 0.1]))).all()
        assert REST.output(np.ones(2), np.array([0.7, 0.1])).tolist() == [0.0, 0.0]


def test_what_is_told_of_small_gains() -> None:
    assert LOOP.small_gains() == SmallGains(
        1.0, LOOP.size, 0.0, steepest=0.0, gentlest=0.0, behind=0.61, reach=math.sqrt(0.5 / 0.7) / ROUNDED_UP
    )
    assert REST.small_gains().reach == math.sqrt(0.2 / 0.7) / ROUNDED_UP
    assert BARE.small_gains() == real_small_gains(BARE.size)


@pytest.mark.parametrize("relay", ALL)
def test_the_bounds_of_the_slope_are_those_of_the_two_circles(relay: Thresholds) -> None:
    lower, upper = np.array([[0.1], [0.4]]), np.array([0.5, 0.8, 0.9])
    steepest, change = relay.steepest(upper), relay.change_of_slope(lower, upper)
    assert (steepest.shape, change.shape) == ((3,), (2, 3))
    for column, u in enumerate(upper.tolist()):
        last = angles(relay, u)
        assert steepest[column] == pytest.approx(SIZE * sum(1 / math.cos(a) for a in last), rel=3e-9)
        assert steepest[column] > SIZE * sum(1 / math.cos(a) for a in last)
        for row, first in enumerate(angles(relay, each) for each in (0.1, 0.4)):
            parts = (
                abs(b - a) * math.sqrt(4 + math.tan(b) ** 2) / math.cos(b)
                for a, b in zip(first, last, strict=True)
            )
            assert change[row, column] == pytest.approx(SIZE * sum(parts), rel=3e-9)
    assert relay.steepest(1.0) > 1e7
    assert relay.steepest(1.7) == relay.steepest(1.0)


@pytest.mark.parametrize("relay", ALL)
@pytest.mark.parametrize(("lower", "upper"), [(0.1, 0.3), (0.3, 0.95), (0.9, 1.0)])
def test_the_reach_is_the_longer_chord_from_the_middle(relay: Thresholds, lower: float, upper: float) -> None:
    middle = angles(relay, 0.5 * (lower + upper))
    ends = [angles(relay, u) for u in (lower, upper)]
    chords = [max(abs(math.sin(end[k] - middle[k])) for end in ends) for k in (0, 1)]
    ratio = abs(relay.dead_zone - relay.hysteresis) / 0.7
    # For off = 0 the second term is u itself.
    expected = chords[0] + (chords[1] / ratio if ratio else 0.5 * (upper - lower))
    found = relay.reach(lower, upper)
    assert found == pytest.approx(SIZE * expected, rel=4e-9)
    assert found > SIZE * expected


def test_beyond_the_threshold_only_a_relay_without_hysteresis_has_a_reach() -> None:
    for relay in (LOOP, REST, EDGE):
        assert relay.reach(0.9, 1.0) < 10.0
        assert relay.reach([0.1, 0.5], [1.1, 0.6]).tolist()[0] == math.inf
        assert relay.reach([0.1, 0.5], [1.1, 0.6])[1] < 10.0
    # α = ρ = asin(min(u, 1)): the middle 0.9 has asin 0.9, from which asin 1 is as far as its cosine says.
    assert BARE.reach(0.7, 1.1) == pytest.approx(2.0 * SIZE * math.sqrt(1 - 0.9**2), rel=3e-9)


def test_a_relay_hands_on_what_its_thresholds_say_in_the_shape_of_the_box() -> None:
    relay, u, omegas = (
        Relay(3.0, hysteresis=0.5, dead_zone=0.2),
        (np.array([[0.1], [0.4]]), 0.8),
        (1.0, np.ones(3)),
    )
    sensitivity, variation, reach = (
        relay.sensitivity(u, omegas),
        relay.variation(u, omegas),
        relay.reach(u, omegas),
    )
    for found, expected in (
        (sensitivity.by_u, np.full((2, 3), LOOP.steepest(0.8))),
        (variation.by_u, np.repeat(LOOP.change_of_slope(*u), 3, axis=1)),
        (reach, np.repeat(LOOP.reach(*u), 3, axis=1)),
        (sensitivity.by_log_omega, np.zeros((2, 3))),
        (variation.by_log_omega, np.zeros((2, 3))),
    ):
        np.testing.assert_array_equal(found, expected)
    ideal = Relay(3.0)
    assert (ideal.thresholds, ideal.reach((0.1, 0.2)), ideal.small_gains()) == (None, None, None)
    assert ideal.sensitivity((0.1, 0.2)) == (4.0 / math.pi, 0.0)
    assert ideal.variation((0.1, 0.2)) == (0.0, 0.0)
    assert ideal.mean_gain([2.0, 0.5]) == pytest.approx([3.0 / math.pi, 12.0 / math.pi])
    scales = [each.amplitude_scale for each in (ideal, Relay(3.0, 0.5), Relay(3.0, 0.0, 0.2), relay)]
    assert scales == [3.0, 0.5, 0.2, 0.7]
    kinds = (ideal, relay, Relay(3.0, 0.2, 0.5), Relay(3.0, 0.5, 0.5))
    assert [each.constant_from for each in kinds] == [math.inf, math.inf, 1.0, 1.0]
    assert [each.domain([1.0, 2.0]).tolist() for each in kinds] == [
        [math.inf] * 2,
        [1.0, 1.0],
        [math.inf] * 2,
        [math.inf] * 2,
    ]
    assert relay.mean_gain([0.9, 2.0]).tolist() == LOOP.mean_gain(np.array([0.9, 2.0])).tolist()
    with pytest.raises(ValueError, match="amplitude must be positive"):
        relay.mean_gain([0.9, -2.0])
    assert (kinds[1].height, kinds[1].mean_gain(0.9)) == (3.0, LOOP.mean_gain(np.array(0.9)))
