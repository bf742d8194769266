"""The bounds of N where it is small, against N itself at many places, and that they are not far off."""

import numpy as np
import pytest

from trimmer import FrictionBacklash, InertiaBacklash, Relay, ViscousBacklash
from trimmer.elements.small_gains import BACKLASH_LARGEST, COASTING, GENTLEST, LEAST, STEEPEST


def places() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """gamma, |N| and the phase of jN with |N| <= BACKLASH_LARGEST, next to the edge of the domain."""
    element = ViscousBacklash(1.0, 1.0)
    gamma = np.geomspace(1e-6, 10.0, 200)[:, None]
    margin = np.geomspace(1e-13, 0.99, 300)
    u = element.domain(gamma) * (1.0 - margin)
    N = element.describing_function(1.0 / u, np.broadcast_to(gamma, u.shape))
    small = np.abs(N) <= BACKLASH_LARGEST
    return np.broadcast_to(gamma, u.shape)[small], np.abs(N[small]), np.angle(1j * N[small])


def test_the_phase_of_a_small_n_is_within_its_bounds() -> None:
    gamma, size, phase = places()
    assert size.size > 1000
    assert gamma.max() < 0.1
    exact = size > 1e-9  # below, u has too few digits for the phase
    assert np.all(phase >= -1e-6)
    assert np.all(phase[exact] <= STEEPEST * np.sqrt(size[exact]))
    assert phase[exact].max() > 0.2 * STEEPEST * np.sqrt(size[exact]).max()
    pushed = exact & (size >= COASTING * gamma**2)
    assert np.all(phase[pushed] >= GENTLEST * np.sqrt(size[pushed]))
    assert np.min(phase[pushed] / np.sqrt(size[pushed])) < 1.8 * GENTLEST


def test_a_small_n_is_no_smaller_than_its_bound() -> None:
    gamma, size, _ = places()
    share = size / (LEAST * gamma**2)
    assert share[gamma > 1e-4].min() >= 1.0
    assert share[gamma > 1e-4].min() < 4.0


def test_a_load_that_coasts_for_long_has_no_small_n() -> None:
    for gamma in (0.1, 1.0, 10.0, 1e4):
        element = ViscousBacklash(1.0, gamma)
        u = float(element.domain(1.0)) * (1.0 - np.geomspace(1e-13, 1.0, 300)[:-1])
        assert np.abs(element.describing_function(1.0 / u, 1.0)).min() > BACKLASH_LARGEST


@pytest.mark.parametrize(
    "element", [FrictionBacklash(1.0), ViscousBacklash(1.0, 0.0), -3.0 * FrictionBacklash(2.0)]
)
def test_n_tends_to_its_direction(element) -> None:
    small = element.small_gains()
    amplitude = element.amplitude_scale / (element.domain(1.0) * (1.0 - 1e-8))
    N = element.describing_function(amplitude, 1.0)
    assert abs(N / abs(N) - small.direction) < 1e-3
    assert small.largest == pytest.approx(BACKLASH_LARGEST * small.scale)
    assert small.scale == abs(getattr(element, "factor", 1.0))


def test_nothing_is_said_of_other_elements() -> None:
    assert InertiaBacklash(1.0).small_gains() is None
    assert (FrictionBacklash(1.0) + FrictionBacklash(1.0)).small_gains() is None
    assert ViscousBacklash(1.0, 0.5).at(2.0).small_gains() is None
    assert FrictionBacklash(1.0).at(2.0).small_gains() == FrictionBacklash(1.0).small_gains()


@pytest.mark.parametrize(
    "relay",
    [
        Relay(2.0, 0.5),
        Relay(2.0, 0.3, 0.2),
        Relay(2.0, 0.2, 0.3),
        Relay(2.0, 1e-3, 0.5),
        Relay(2.0, 0.0, 0.5),
    ],
    ids=repr,
)
def test_a_relay_with_thresholds_lags_by_no_more_than_is_told(relay: Relay) -> None:
    u = np.concatenate([np.geomspace(1e-9, 0.5, 4000), 1.0 - np.geomspace(0.5, 1e-9, 4000)])
    gain, small = relay.describing_function(relay.amplitude_scale / u), relay.small_gains()
    assert small is not None
    known = (np.abs(gain) <= small.largest) & (gain != 0)
    assert known.sum() > 1000
    ahead = np.angle(gain[known] / small.direction)
    assert np.all(ahead <= 1e-12)
    assert np.all(ahead >= -small.behind * np.abs(gain[known]) / small.scale - 1e-12)
    if relay.dead_zone == 0:
        # Without a dead zone the bound is of the size of the lag; else it is a rough one.
        assert ahead.min() < -0.4 * small.behind * np.abs(gain[known]).max() / small.scale
