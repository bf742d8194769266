import math
from itertools import pairwise

import control
import numpy as np
import pytest
from hypothesis import given, settings

from tests.trimmer.trimmers import stable_systems
from trimmer import TrimmerParameters, resonance_peaks
from trimmer.linear import Extremum, antiresonances

THESIS = TrimmerParameters.thesis()


def test_a_second_order_system_peaks_where_the_textbook_says() -> None:
    omega_n, zeta = 50.0, 0.1
    (peak,) = resonance_peaks(control.tf([omega_n**2], [1, 2 * zeta * omega_n, omega_n**2]))
    assert peak.omega == pytest.approx(omega_n * math.sqrt(1 - 2 * zeta**2), rel=1e-14)
    assert peak.magnitude == pytest.approx(1 / (2 * zeta * math.sqrt(1 - zeta**2)), rel=1e-14)


@pytest.mark.parametrize("zeta", [1e-3, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e12])
def test_narrow_resonances_are_found_at_any_scale(zeta: float, unit: float) -> None:
    wide = control.tf([unit], [1, unit])
    narrow = control.tf([(7 * unit) ** 2], [1, 14 * zeta * unit, (7 * unit) ** 2])
    (peak,) = resonance_peaks(wide * narrow)
    assert peak.omega == pytest.approx(7 * unit, rel=1e-3)
    assert peak.magnitude == pytest.approx(1 / (2 * zeta * math.sqrt(50)), rel=1e-2)


def test_roots_on_the_axis_are_infinite_peaks_and_zero_antiresonances() -> None:
    system = control.tf([1, 0, 4], [1, 0, 9]) * control.tf([1], [1, 1])
    assert resonance_peaks(system) == (Extremum(pytest.approx(3.0, rel=1e-14), math.inf),)
    assert antiresonances(system) == (Extremum(pytest.approx(2.0, rel=1e-14), 0.0),)


@pytest.mark.parametrize(
    "system",
    [
        *(control.tf([-1, 1], [1, 1]), control.tf([1, -2, 5], [1, 2, 5])),  # all-pass
        *(control.tf([5], [1]), control.tf([1], [1, 0, 0]), control.tf([1], [1, 1.42, 1])),
    ],
)
def test_systems_without_extrema(system: control.TransferFunction) -> None:
    assert resonance_peaks(system) == antiresonances(system) == ()


def test_a_candidate_next_to_zero_does_not_hide_the_only_peak() -> None:
    # For this damping an eigenvalue at the origin comes out with an imaginary part of 1e-33.
    damping = 0.276076852920577
    (peak,) = resonance_peaks(control.tf([-3.0], [1.0, damping, 1.0]))
    assert peak.omega == pytest.approx(math.sqrt(1.0 - 0.5 * damping**2), rel=1e-12)


@settings(max_examples=10)
@given(stable_systems())
def test_no_grid_sees_an_extremum_that_was_not_found(system: control.TransferFunction) -> None:
    omega = np.geomspace(1e-3, 1e3, 20_001)
    magnitude = np.abs(system(1j * omega))
    peaks, valleys = resonance_peaks(system), antiresonances(system)
    rising = np.diff(magnitude) > 1e-9 * magnitude[1:]
    falling = np.diff(magnitude) < -1e-9 * magnitude[1:]
    for place in np.flatnonzero(rising[:-1] & falling[1:]) + 1:
        assert sum(omega[place - 1] < peak.omega < omega[place + 1] for peak in peaks) >= 1
    for place in np.flatnonzero(falling[:-1] & rising[1:]) + 1:
        assert sum(omega[place - 1] < lowest.omega < omega[place + 1] for lowest in valleys) >= 1


@settings(max_examples=10)
@given(stable_systems())
def test_peaks_and_antiresonances_take_turns_and_are_extrema(system: control.TransferFunction) -> None:
    found = [(peak, 1) for peak in resonance_peaks(system)] + [(low, -1) for low in antiresonances(system)]
    found.sort(key=lambda pair: pair[0].omega)
    assert all(first[1] != second[1] for first, second in pairwise(found))
    for extremum, sign in found:
        around = np.abs(system(1j * extremum.omega * np.array([1 - 1e-4, 1 + 1e-4])))
        here = abs(system(1j * extremum.omega))
        assert (sign * around <= sign * here * (1 + sign * 1e-9)).all()
