import dataclasses
import math

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.trimmers import stable_systems
from trimmer import TrimmerParameters, pin_model, transfer_function
from trimmer.linear import gain_crossings, real_axis_crossings

THESIS = TrimmerParameters.thesis()
BUILDERS = [pin_model, transfer_function]


@settings(max_examples=10)
@given(stable_systems(), st.floats(-2, 2))
def test_no_grid_sees_a_gain_crossing_that_was_not_found(system, exponent) -> None:
    level = 10**exponent
    found = np.array(gain_crossings(system, level))
    np.testing.assert_allclose(np.abs(system(1j * found)), level, rtol=1e-6)
    omega = np.geomspace(1e-4, 1e4, 20_001)
    excess = np.abs(system(1j * omega)) - level
    excess[np.abs(excess) < 1e-9 * level] = np.nan
    for place in np.flatnonzero(np.sign(excess[:-1]) * np.sign(excess[1:]) < 0):
        assert np.count_nonzero((found >= omega[place]) & (found <= omega[place + 1])) % 2 == 1


@settings(max_examples=10)
@given(stable_systems())
def test_no_grid_sees_a_real_axis_crossing_that_was_not_found(system: control.TransferFunction) -> None:
    crossings = real_axis_crossings(system)
    found = np.array([crossing.omega for crossing in crossings])
    for crossing in crossings:
        response = complex(system(1j * crossing.omega))
        assert response.real == pytest.approx(crossing.value, rel=1e-5)
        assert abs(response.imag) <= 1e-5 * abs(response)
    omega = np.geomspace(1e-3, 1e3, 20_001)
    response = system(1j * omega)
    sine = response.imag / np.abs(response)
    sine[np.abs(sine) < 1e-9] = np.nan
    for place in np.flatnonzero(np.sign(sine[:-1]) * np.sign(sine[1:]) < 0):
        assert np.count_nonzero((found >= omega[place]) & (found <= omega[place + 1])) % 2 == 1


@pytest.mark.parametrize("unit", [1e-12, 1.0, 1e12])
def test_crossings_scale_with_time(unit: float) -> None:
    system = control.tf([unit**3], [1, 2 * unit, 2 * unit**2, 0])  # 1/(s (s^2 + 2 s + 2))
    (crossing,) = real_axis_crossings(system)
    assert crossing.omega == pytest.approx(math.sqrt(2) * unit, rel=1e-12, abs=0.0)
    assert crossing.value == pytest.approx(-0.25, rel=1e-12)
    (gain,) = gain_crossings(control.tf([unit], [1, unit]), 0.5)
    assert gain == pytest.approx(math.sqrt(3) * unit, rel=1e-12, abs=0.0)


@pytest.mark.parametrize("zeta", [1e-4, 1e-6, 1e-9, 1e-12])
def test_both_flanks_of_a_narrow_resonance_are_crossed(zeta: float) -> None:
    system = control.tf([1e-3], [1, 2 * zeta, 1])
    lower, upper = gain_crossings(system, 0.5)
    assert lower == pytest.approx(1 - 1e-3, abs=2e-5)
    assert upper == pytest.approx(1 + 1e-3, abs=2e-5)
    half_width = gain_crossings(system, 1e-3 / (2 * zeta) / math.sqrt(2))
    assert half_width[1] - half_width[0] == pytest.approx(2 * zeta, rel=1e-2, abs=0.0)


@pytest.mark.parametrize("level", [1e-200, 1e-3, 1.0, 1e30, 1e200])
@pytest.mark.parametrize("order", [1, 2, -1])
def test_straight_lines_are_followed_to_any_level(order: int, level: float) -> None:
    rational = ([1.0], np.eye(order + 1)[0]) if order > 0 else ([1.0, 0.0], [1.0])
    (omega,) = gain_crossings(control.tf(*rational), level)
    assert omega == pytest.approx(level ** (-1 / order), rel=1e-12, abs=0.0)


@pytest.mark.parametrize(
    ("numerator", "denominator", "level", "expected"),
    [
        ([1], [1, 1], 1.001, ()),
        ([-1, 1], [1, 1], 0.5, ()),
        ([3], [1], 1.0, ()),
        # The gain at zero frequency is not crossed there.
        ([1], [1, 1], 1.0, ()),
        # (4 - w^2)/(9 - w^2) = +-1 at w^2 = 13/2 only; the pole at 3 lies beyond it.
        ([1, 0, 4], [1, 0, 9], 1.0, (math.sqrt(6.5),)),
    ],
)
def test_levels_are_crossed_where_they_are_reached(numerator, denominator, level: float, expected) -> None:
    assert gain_crossings(control.tf(numerator, denominator), level) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("numerator", "denominator", "omega", "value"),
    [
        # A negative gain swaps the sides of the axis.
        ([-1], [1, 2, 2, 0], math.sqrt(2), 0.25),
        # (s^2 + 9/4)/(s + 1)^3 is real at sqrt(3), beyond its zero at 1.5: (9/4 - 3)/-8.
        ([1, 0, 2.25], np.poly([-1, -1, -1]), math.sqrt(3), 0.09375),
        # (1 - s)/(1 + s)^2 has phase -pi where 3 atan(w) = pi.
        ([-1, 1], [1, 2, 1], math.sqrt(3), -0.5),
        # Above 3j the phase of (s^2 + 9)/(s + 1)^3 is less by -pi than below; it passes no half turn between.
        ([1, 0, 9], np.poly([-1, -1, -1]), math.tan(math.pi / 3), -0.75),
    ],
)
def test_the_axis_is_crossed_at_closed_forms(numerator, denominator, omega: float, value: float) -> None:
    (crossing,) = real_axis_crossings(control.tf(numerator, denominator))
    assert (crossing.omega, crossing.value) == (
        pytest.approx(omega, rel=1e-9),
        pytest.approx(value, rel=1e-9),
    )


@pytest.mark.parametrize("level", [0.0, -1.0, math.inf, math.nan])
def test_a_level_must_be_positive_and_finite(level: float) -> None:
    with pytest.raises(ValueError, match="must be positive and finite"):
        gain_crossings(control.tf([1], [1, 1]), level)


def test_an_undamped_trimmer_stays_on_the_real_axis_without_crossing_it() -> None:
    undamped = dataclasses.replace(THESIS, c1=0, c2=0, c3=0, c4=0)
    for build in BUILDERS:
        assert real_axis_crossings(build(undamped)) == ()
