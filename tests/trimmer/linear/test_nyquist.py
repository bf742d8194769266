import math
from dataclasses import replace

import control
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.trimmer.trimmers import stable_systems
from trimmer import TrimmerParameters, pin_model, transfer_function
from trimmer.linear import PointOnLocusError, UnsupportedSystemError, encirclements, real_axis_crossings
from trimmer.thesis import Displacement, TrimmerBody

THESIS = TrimmerParameters.thesis()
CUTTER = Displacement(TrimmerBody.CUTTER)
POINTS = st.sampled_from([-30.0, -2.0, -1.0, -0.3, 0.4, 3.0])


def winding(system: control.lti.LTI, point: float, omega: np.ndarray) -> int:
    """Clockwise turns of G(j omega) - point, from the phase of python-control's samples."""
    count = control.nyquist_response(system / -point, omega=omega, warn_encirclements=False).count
    return int(count)


@settings(max_examples=10)
@given(stable_systems(), POINTS)
def test_encirclements_are_those_of_python_control(system: control.TransferFunction, point: float) -> None:
    poles = system.poles()
    assume(np.abs(poles.real).min() > 2e-4)  # nearer ones python-control takes to be on the axis
    near_poles = np.abs(poles.imag + np.outer(np.tan(np.linspace(-1.5, 1.5, 51)), poles.real))
    omega = np.unique(np.concatenate([np.geomspace(1e-4, 1e4, 501), near_poles.ravel()]))
    assume(np.abs(system(1j * omega) - point).min() > 0.05 and abs(system.dcgain() - point) > 0.05)
    assert encirclements(system, point) == winding(system, point, omega)


@settings(max_examples=10)
@given(stable_systems(), POINTS)
def test_encirclements_are_the_crossings_of_the_axis_beyond_the_point(system, point) -> None:
    """The locus goes round a point as often as it crosses the ray that runs from the point away from 0.

    On the right of 0 clockwise means downwards, on the left upwards. The half of negative frequencies is the
    mirror image, so that a crossing counts twice; the locus passes its static value once.
    """
    crossings = real_axis_crossings(system)
    static = float(system.dcgain())
    assume(all(abs(c.value - point) > 1e-3 for c in crossings) and abs(static - point) > 1e-3)
    starts = [1e-3 * crossings[0].omega if crossings else 1e-6, *(c.omega for c in crossings)]
    downwards = 0
    for start, crossing in zip(starts, crossings, strict=False):
        if crossing.value / point > 1:
            before = complex(system(1j * math.sqrt(start * crossing.omega)))
            downwards += 2 * int(np.sign(before.imag))
    if static / point > 1:
        downwards -= int(np.sign(complex(system(1j * starts[0])).imag))
    assert encirclements(system, point) == downwards * int(np.sign(point))


@pytest.mark.parametrize(
    ("numerator", "denominator", "turns"),
    [
        # 8/(s + 1)^3 passes -1 at sqrt(3); with more gain the closed loop has two roots on the right.
        ([9], np.poly([-1, -1, -1]), 2),
        ([7], np.poly([-1, -1, -1]), 0),
        # An unstable pole that feedback makes stable is encircled counter-clockwise.
        ([2], [1, -1], -1),
        ([0.5], [1, -1], 0),
        # Poles on the axis are passed on the right.
        ([1], [1, 1, 0], 0),
        ([3], [1, 2, 1, 0], 2),
    ],
)
def test_clockwise_is_positive(numerator, denominator, turns: int) -> None:
    assert encirclements(control.tf(numerator, denominator)) == turns


@pytest.mark.parametrize("damping", [1e-5, 1e-8, 1e-11])
def test_light_damping_counts_although_the_contour_of_a_sampled_locus_would_miss_it(damping: float) -> None:
    system = control.tf([-1.0, 0.0], [1, 2 * damping, 1])  # peaks on the negative axis at -1/(2 damping)
    assert (encirclements(system), encirclements(system, -1 / damping)) == (2, 0)


def test_a_point_on_the_locus_or_at_infinity_and_an_improper_system_are_refused() -> None:
    for system, point in (
        (control.tf([8], np.poly([-1, -1, -1])), -1.0),
        (control.tf([1], [1, 1]), 1.0),
        (control.tf([1], [1, 1]), 0.0),
        (control.tf([2, 1], [1, 1]), 2.0),
    ):
        with pytest.raises(PointOnLocusError, match="lies on the Nyquist locus"):
            encirclements(system, point)
    with pytest.raises(UnsupportedSystemError, match="more zeros than poles"):
        encirclements(control.tf([1, 0, 0], [1, 1]))
    for point in (math.nan, math.inf):
        with pytest.raises(ValueError, match="must be finite"):
            encirclements(control.tf([1], [1, 1]), point)


@pytest.mark.parametrize("build", [pin_model, transfer_function])
def test_an_undamped_mode_that_the_output_does_not_show_is_not_on_the_locus(build) -> None:
    parted = replace(THESIS, k5=0.0, c3=0.0, c4=0.0)  # motor and cutter here, housing and guard there
    for point in (-1.0, 0.5, -4.0):
        assert encirclements(build(parted, CUTTER), point) == encirclements(build(THESIS, CUTTER), point)
