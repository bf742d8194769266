"""The first zero of a polynomial and a known exponential, in plain Python: each way to an answer."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest

from tests.trimmer.uncompiled import uncompile
from trimmer.contact import relaxing_root as module
from trimmer.contact.relaxing_root import UNSURE
from trimmer.motion import first_event, linear_combination
from trimmer.motion.first_event import NOWHERE
from trimmer.motion.taylor import DEGREE, bernstein_from_taylor

COUNT = DEGREE + 1


@pytest.fixture(autouse=True)
def plain(monkeypatch: pytest.MonkeyPatch) -> None:
    uncompile(monkeypatch, module, first_event, linear_combination)


def search(taylor: list[float], stretch: float, decay: float) -> float:
    coefficients = np.zeros(COUNT)
    coefficients[: len(taylor)] = taylor
    bernstein = coefficients @ bernstein_from_taylor()[0]
    return module.relaxing_root(bernstein, coefficients, stretch, decay, np.full((3, COUNT + 2), np.nan))


def exact(taylor: list[float], stretch: float, decay: float, near: float) -> float:
    with mpmath.workdps(30):
        return float(
            mpmath.findroot(
                lambda s: mpmath.polyval(taylor[::-1], s) + stretch * mpmath.exp(-decay * s), near
            )
        )


@pytest.mark.parametrize(
    ("taylor", "stretch", "decay", "near"),
    [
        ([0.5, -1.0], 0.05, 4.0, 0.5),  # At once.
        ([0.5, -1.0], -0.05, 4.0, 0.5),
        ([0.5, 1.0, -2.5], 0.1, 22.0, 0.7),  # In the later half, where the spring has relaxed.
        ([0.5, 1.0, -2.5], -0.1, 5.0, 0.7),
        ([0.35, -0.36], -0.1, 4.0, 0.97),  # In the last quarter.
        ([0.3, -1.0, 0.0, 0.8], 0.01, 10.0, 0.33),  # In the earlier half: it returns later.
        ([0.3, -1.0, 0.0, 0.8], -0.01, 10.0, 0.33),
    ],
)
def test_the_zero_is_found_where_the_interval_is_halved(
    taylor: list[float], stretch: float, decay: float, near: float
) -> None:
    found = search(taylor, stretch, decay)
    assert found == pytest.approx(exact(taylor, stretch, decay, near), rel=1e-14, abs=0.0)
    grid = np.linspace(0.0, found - 1e-6, 999)
    assert (np.polyval(taylor[::-1], grid) + stretch * np.exp(-decay * grid) > 0).all()


def test_no_zero_in_either_half() -> None:
    assert search([1.0, 0.5, -0.9], 0.3, 10.0) == NOWHERE
    assert search([0.5, -1.2, 1.2], 0.01, 2.0) == NOWHERE  # Its smallest value is 1/5, in the middle.
    assert search([0.5], 0.4, 1.0) == NOWHERE


def test_what_shorter_steps_have_to_decide() -> None:
    assert search([0.1, 1.0, -3.0], 0.2, 10.0) == UNSURE  # Closer than the spring is stretched.
    assert search([0.2, 1.0, -3.0], -0.2, 10.0) == UNSURE
    assert search([0.32, -1.0], 0.2, 5.1) == UNSURE  # The spring may relax faster than the gap closes.
    assert search([0.5, -0.3], -0.4, 0.1) == UNSURE


def fallen(taylor: list[float], stretch: float, decay: float, low: float, high: float) -> float:
    return module._fallen(np.array(taylor), stretch, decay, low, high)


def test_the_only_zero_of_what_falls() -> None:
    assert fallen([0.5, -1.0], 0.0, 3.0, 0.0, 1.0) == 0.5
    # Level at its start, or so flat there that a tangent leads out of the interval.
    assert fallen([0.5, 0.0, -2.1], 0.0, 3.0, 0.0, 1.0) == pytest.approx(
        math.sqrt(0.5 / 2.1), rel=1e-14, abs=0.0
    )
    taylor = [0.5, -0.01, -2.0]
    zero = (-0.01 + math.sqrt(0.01**2 + 4.0)) / 4.0
    for low, high in ((0.0, 1.0), (0.25, 0.5), (0.0, 0.5), (0.4, 20.0)):
        assert fallen(taylor, 0.0, 3.0, low, high) == pytest.approx(zero, rel=1e-14, abs=0.0)
    for stretch in (0.3, -0.3):
        found = fallen(taylor, stretch, 1.5, 0.1, 0.9)
        assert found == pytest.approx(exact(taylor, stretch, 1.5, 0.5), rel=1e-14, abs=0.0)


def test_the_steepest_rise_is_the_largest_difference_of_neighbours() -> None:
    values = np.array([5.0, 2.0, 1.0, -3.0, -2.5, 9.0])
    assert module._steepest_rise(values, 2) == -3.0
    assert module._steepest_rise(values, 4) == -1.0
    assert module._steepest_rise(values, 5) == 0.5
    assert module._steepest_rise(values, 6) == 11.5
    assert module._steepest_rise(-values, 3) == 3.0
