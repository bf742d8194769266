"""Where a quadrature begins, when it ends, and what it tells of outputs that are not odd or not there."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.elements import quadrature
from trimmer.elements.quadrature import harmonic_by_quadrature


class Counted:
    """An output at phases and half a period later, and how many panels were asked for at once."""

    def __init__(self, first, second=None) -> None:
        self.first, self.second, self.panels = first, second, []

    def __call__(self, phases: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        self.panels.append(phases.size // quadrature.PLACES.size)
        first = self.first(phases)
        return first, -first if self.second is None else self.second(phases)


def jump(phases: np.ndarray) -> np.ndarray:
    return np.sign(np.sin(phases - 0.3))


@pytest.mark.parametrize("harmonic", [1, 3])
def test_first_panels_are_even_ones_and_narrow_ones_on_either_side_of_the_peak(harmonic: int) -> None:
    cuts = quadrature._first_cuts(harmonic, ())
    even = [math.pi * k / (8 + 2 * harmonic) for k in range(9 + 2 * harmonic)]
    peak = [0.5 * math.pi * (1.0 + sign * 0.5**k) for k in range(1, 17) for sign in (1, -1)]
    assert cuts == pytest.approx(sorted({*even, *peak}), rel=1e-15)
    assert cuts.size == 41 + 2 * harmonic


@pytest.mark.parametrize("breaks", [(0.3,), (0.3 + math.pi,), (0.3 - 3 * math.pi, math.nan)])
def test_jumps_that_are_named_need_no_closing_in(breaks: tuple[float, ...]) -> None:
    named, unnamed = Counted(jump), Counted(jump)
    found = harmonic_by_quadrature(named, 2.0, 1, breaks)
    # The widest panels are halved once.
    assert named.panels == [43, 8]
    exact = 4.0 / (2.0 * math.pi) * np.exp(-0.3j)
    assert found.value == pytest.approx(exact, rel=1e-14)
    closed_in = harmonic_by_quadrature(unnamed, 2.0, 1)
    assert len(unnamed.panels) > 30
    assert (unnamed.panels[:2], set(unnamed.panels[2:])) == ([42, 8], {2})
    assert closed_in.value == pytest.approx(exact, rel=1e-12)


def test_the_error_is_that_of_rounding_at_least() -> None:
    found = harmonic_by_quadrature(Counted(lambda phases: 5.0 * np.sin(phases)), 4e-5, 1)
    assert found.value == pytest.approx(5.0 / 4e-5, rel=1e-14)
    assert found.error >= 2.0 / (math.pi * 4e-5) * 1e-15 * math.pi * 5.0 * 0.99
    assert found.error < 1e-12 * 5.0 / 4e-5
    assert harmonic_by_quadrature(Counted(np.zeros_like), 2.0, 1) == (0, 0.0, 0.0)


def test_panels_are_halved_up_to_a_limit_and_the_rest_is_error(monkeypatch: pytest.MonkeyPatch) -> None:
    best = harmonic_by_quadrature(Counted(jump), 1.0, 1)
    errors = []
    for most in (0, 1, 4):
        monkeypatch.setattr(quadrature, "MOST_LEVELS", most)
        counted = Counted(jump)
        found = harmonic_by_quadrature(counted, 1.0, 1)
        assert counted.panels == [42, 8, 2, 2, 2][: 1 + most]
        assert 0 < abs(found.value - best.value) <= found.error
        errors.append(found.error)
    assert errors[0] > 1.5 * errors[1] > 3.0 * errors[2]
    monkeypatch.setattr(quadrature, "MOST_LEVELS", 50)
    for most, goes_on in ((3, False), (4, True)):
        monkeypatch.setattr(quadrature, "MOST_PANELS", most)
        counted = Counted(jump)
        harmonic_by_quadrature(counted, 1.0, 1)
        assert (len(counted.panels) > 1) is goes_on


def test_outputs_that_are_larger_half_a_period_later() -> None:
    """The odd part of sin θ and -3 sin θ is 2 sin θ; both together are 2 of 3."""
    found = harmonic_by_quadrature(Counted(np.sin, lambda phases: -3.0 * np.sin(phases)), 0.5, 1)
    assert (found.value, found.odd) == (pytest.approx(4.0), pytest.approx(2.0 / 3.0))
    other = harmonic_by_quadrature(
        Counted(lambda phases: 3.0 * np.sin(phases), lambda phases: -np.sin(phases)), 0.5, 1
    )
    assert (other.value, other.odd) == (pytest.approx(4.0), pytest.approx(2.0 / 3.0))


@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_one_value_that_is_not_there_is_enough(value: float) -> None:
    def lacking(phases: np.ndarray) -> np.ndarray:
        return np.where((phases > 1.0) & (phases < 1.2), value, np.sin(phases))

    for first, second in ((lacking, np.sin), (np.sin, lacking), (lacking, lacking)):
        found = harmonic_by_quadrature(Counted(first, second), 1.0, 1)
        assert np.isnan([found.value, found.error, found.odd]).all()


def test_a_square_wave_of_an_odd_harmonic_is_that_of_the_period_whatever_its_phase() -> None:
    for shift in (0.0, 1.0, 0.5 * math.pi, 3.0):
        found = harmonic_by_quadrature(Counted(lambda phases, s=shift: np.cos(3 * (phases - s))), 1.0, 3)
        assert found.value == pytest.approx(1j * np.exp(-3j * shift), abs=1e-13)


def test_places_of_a_panel_are_fifteen_and_two_just_inside_its_ends() -> None:
    assert (quadrature.PLACES.size, quadrature.NODES.size) == (17, 15)
    np.testing.assert_array_equal(quadrature.NODES, -quadrature.NODES[::-1])
    assert quadrature.ENDS.tolist() == [1e-9 - 1.0, 1.0 - 1e-9]
    assert quadrature.PLACES[-2:].tolist() == quadrature.ENDS.tolist()
    # Gauss's seven points are every other one, from the second on.
    gauss = np.polynomial.legendre.leggauss(7)[0]
    assert quadrature.NODES[quadrature.COARSE] == pytest.approx(gauss, abs=1e-15)
    assert quadrature.NODES[quadrature.OTHERS].size == 8
    values = quadrature._continuation(np.array([0.0, 1.0, 3.0]), np.array([2.0, -1.0]))
    assert np.array([0.0, 1.0, 9.0]) @ values == pytest.approx([4.0, 1.0])
