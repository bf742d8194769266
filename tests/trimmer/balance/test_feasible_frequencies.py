"""Where bands of frequencies end, and what lies between."""

from __future__ import annotations

import math
from types import SimpleNamespace

import control
import numpy as np
import pytest

from tests.trimmer.balance.loops import GAP, THESIS_LOOP, s
from trimmer.balance import feasible_frequencies as feasible
from trimmer.balance.feasible_frequencies import BandEnd, feasible_bands
from trimmer.balance.solve import limit_cycles
from trimmer.elements.backlashes.backlash_motion import GAMMA_LIMITS
from trimmer.elements.backlashes.viscous_backlash import ViscousBacklash
from trimmer.linear.frequency_response import response_at


def test_neighbouring_bands_are_joined_where_the_border_is_only_touched(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    ends = [BandEnd(each, each / 100.0) for each in (10.0, 40.0, 90.0)]
    monkeypatch.setattr(feasible, "_limits", lambda G, gap: ends[:0:-1])
    monkeypatch.setattr(feasible, "_touching", lambda G: ends[:1])
    G = 1 / (s + 1)
    # Places between: 0.01, 20, 60 and 90e3 Hz.
    tried: list[float] = []

    def solvable(*frequencies: float):
        def at(frequency: float) -> bool:
            tried.append(frequency)
            return round(frequency, 6) in frequencies

        return at

    assert [each.frequencies for each in feasible_bands(G, GAP, solvable(20.0, 60.0))] == [(10.0, 90.0)]
    assert tried == pytest.approx([0.01, 20.0, 60.0, 9e4])
    (joined,) = feasible_bands(G, GAP, solvable(20.0, 60.0))
    assert (joined.lower, joined.upper) == (ends[0], ends[2])
    assert [each.frequencies for each in feasible_bands(G, GAP, solvable(20.0, 9e4))] == [
        (10.0, 40.0),
        (90.0, math.inf),
    ]
    assert [each.frequencies for each in feasible_bands(G, GAP, solvable(0.01, 60.0))] == [
        (0.0, 10.0),
        (40.0, 90.0),
    ]
    assert [each.frequencies for each in feasible_bands(G, GAP, solvable(0.01, 60.0, 9e4))] == [
        (0.0, 10.0),
        (40.0, math.inf),
    ]
    assert feasible_bands(G, GAP, solvable()) == ()


def test_between_two_ends_lies_their_geometric_mean_and_beyond_one_a_thousandfold() -> None:
    between = feasible._between
    G = 1 / (s + 1)
    assert between(G, 0.25, 9.0) == 1.5
    assert between(G, 0.25, math.inf) == 250.0
    assert between(G, 0.0, 0.5) == 0.0005


def test_without_ends_a_frequency_among_the_roots_stands_for_all() -> None:
    between = feasible._between
    assert between((s + 8) / ((s + 1) * (s + 27)), 0.0, math.inf) == pytest.approx(6.0 / (2.0 * math.pi))
    assert between(8 / (s * (s + 4) ** 2), 0.0, math.inf) == pytest.approx(4.0 / (2.0 * math.pi))
    assert between(1 / s**2, 0.0, math.inf) == 1.0


@pytest.mark.parametrize("G", [5 * (s + 3) / (s**2 + 2 * s + 9), (2 * s + 1) / (s + 4)])
def test_a_system_is_integrated_in_either_form(G: control.TransferFunction) -> None:
    omega = np.array([0.7, 3.0])
    expected = response_at(G, omega) / (1j * omega)
    assert response_at(feasible._integrated(G), omega) == pytest.approx(expected)
    assert response_at(feasible._integrated(control.ss(G)), omega) == pytest.approx(expected)


def test_where_the_pin_only_just_touches_n_is_negative_imaginary() -> None:
    for gamma in (0.2, 3.0):
        element = ViscousBacklash(1.0, gamma)
        gain = complex(element.describing_function(1.0 / (float(element.domain(1.0)) * (1.0 - 1e-12)), 1.0))
        assert abs(gain.real) < 1e-4 * abs(gain)
        assert feasible._touching_size(math.log(gamma)) == pytest.approx(-gain.imag, rel=1e-12)


def test_ends_where_the_pin_only_just_touches_have_their_load() -> None:
    # 1/G = ± size (s + 0.3 (s² + 1)) is imaginary at 1 rad/s only: ± j size, with the size of gamma = 0.8.
    gamma = 0.8
    size = feasible._touching_size(math.log(gamma))
    for sign, count in ((1.0, 1), (-1.0, 0)):
        G = sign / (size * (s + 0.3 * (s**2 + 1)))
        ends = list(feasible._touching(G))
        assert len(ends) == count
        for end in ends:
            assert end.frequency == pytest.approx(1.0 / (2.0 * math.pi))
            assert end.time_constant == pytest.approx(gamma, rel=1e-8)
            assert end.limit_cycle is None


def test_bands_end_where_friction_or_inertia_alone_oscillates() -> None:
    ends = list(feasible._limits(THESIS_LOOP, GAP))
    expected = [
        (cycle.frequency, time_constant, cycle)
        for time_constant in (0.0, math.inf)
        for cycle in limit_cycles(THESIS_LOOP, ViscousBacklash(GAP, time_constant))
    ]
    assert [(end.frequency, end.time_constant, end.limit_cycle) for end in ends] == expected


def test_only_between_the_sizes_of_the_extreme_loads_does_the_pin_just_touch(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    # With |N| = ln gamma between 0.5 and 4; -1/G = -j size.
    assert np.exp(feasible._LOG_GAMMAS) == pytest.approx(GAMMA_LIMITS, rel=1e-6, abs=0.0)
    monkeypatch.setattr(feasible, "_LOG_GAMMAS", (0.5, 4.0))
    monkeypatch.setattr(feasible, "_touching_size", lambda log_gamma: log_gamma)
    monkeypatch.setattr(feasible, "real_axis_crossings", lambda G: [SimpleNamespace(omega=691.0)])
    for size, count in ((0.5, 0), (2.0, 1), (4.0, 0), (8.0, 0), (0.25, 0), (-2.0, 0)):
        monkeypatch.setattr(feasible, "response_at", lambda G, omega, size=size: np.array(-1j / size))
        ends = list(feasible._touching(THESIS_LOOP))
        assert len(ends) == count
        for end in ends:
            assert end.frequency == pytest.approx(691.0 / (2.0 * math.pi), rel=1e-14)
            assert end.time_constant == pytest.approx(math.exp(size) / 691.0, rel=1e-11)
