"""Exact limit cycles: against closed forms, long simulations, and the balance of every harmonic."""

import functools
import math
from itertools import pairwise

import control
import numpy as np
import pytest
import scipy.linalg
import scipy.optimize

from trimmer import ClosedLoop, Feedback, Relay, TrimmerParameters, ViscousBacklash, periodic_orbits, simulate
from trimmer.elements import CoulombFriction, Element, FrictionBacklash, InertiaBacklash
from trimmer.errors import OrbitNotFoundWarning
from trimmer.linear import InputChannels, pin_model
from trimmer.orbits import PeriodicOrbit, PeriodicOrbits

THIRD_ORDER = [
    control.tf([1], [1, 2, 1, 0]),
    control.tf([1], [1, 3, 3, 1]),
    control.tf([2], np.polymul([1, 0.4, 4], [1, 1])),
]
BACKLASHES = [FrictionBacklash(1.0), ViscousBacklash(1.0, 3e-4), InertiaBacklash(1.0)]


def thesis_loop() -> control.StateSpace:
    return pin_model(TrimmerParameters.thesis(), channels=InputChannels.DISPLACEMENT_ONLY)


@functools.cache
def exact(element: Element) -> PeriodicOrbits:
    return periodic_orbits(thesis_loop(), element)


def tsypkin_half_period(system: control.StateSpace, near: float) -> float:
    """Solve for the half period of an ideal relay in closed form (Tsypkin 1984; Åström 1995)."""
    A, B, C = system.A, system.B, system.C

    def switching(half: float) -> float:
        order = len(A)
        augmented = np.zeros((order + 1, order + 1))
        augmented[:order, :order], augmented[:order, order:] = A, B
        flow = scipy.linalg.expm(augmented * half)
        at_switch = -np.linalg.solve(np.eye(order) + flow[:order, :order], flow[:order, order])
        return float(C[0] @ at_switch)

    return float(scipy.optimize.brentq(switching, 0.8 * near, 1.2 * near, xtol=1e-14))


@pytest.mark.parametrize("plant", THIRD_ORDER)
def test_relay_has_the_period_and_multipliers_of_its_closed_form(plant: control.TransferFunction) -> None:
    (orbit,) = orbits = periodic_orbits(plant, Relay(1.0))
    model = ClosedLoop(plant, Relay(1.0)).model
    half = tsypkin_half_period(model, 0.5 * orbit.period)
    assert orbit.period == pytest.approx(2 * half, rel=1e-11)
    # Derivative of the map from switch to switch: (I - f c / (c f)) exp(A half), f being the rate there.
    flow = scipy.linalg.expm(model.A * half)
    at_switch = orbit.motion.state(orbit.switching_times[0])
    plus = orbit.motion.element_output(orbit.switching_times[0] * (1 - 1e-9))
    rate = model.A @ at_switch + model.B[:, 0] * plus
    projection = np.eye(len(flow)) - np.outer(rate, model.C[0]) / (model.C[0] @ rate)
    expected = np.sort(abs(np.linalg.eigvals(projection @ flow)) ** 2)[1:]
    assert np.sort(abs(orbit.nontrivial_multipliers)) == pytest.approx(expected, rel=1e-6, abs=1e-12)
    assert (orbit.stable, orbit.neutral, orbits.families) == (bool((expected < 1).all()), False, ())


@pytest.mark.parametrize("element", BACKLASHES)
def test_stable_orbit_is_where_a_long_simulation_ends(element: Element) -> None:
    orbit = exact(element)[0]
    motion = simulate(ClosedLoop(thesis_loop(), element), 1.0, impulse=0.5)
    times = motion.event_times
    assert orbit.stable
    assert times[-1] - times[-5] == pytest.approx(orbit.period, rel=1e-9)
    last = motion.element_input(np.linspace(0.99, 1.0, 20001))
    assert 0.5 * np.ptp(last) == pytest.approx(orbit.amplitude, rel=1e-6)


def piece(orbit: PeriodicOrbit, number: int, begin: float, end: float) -> complex:
    """Integrate the output of the element times exp(-j n omega t) over a smooth piece."""
    nodes, weights = np.polynomial.legendre.leggauss(60)
    times = begin + 0.5 * (end - begin) * (nodes + 1.0)
    values = orbit.motion.element_output(times) * np.exp(-1j * number * orbit.omega * times)
    return complex(0.5 * (end - begin) * (values @ weights))


@pytest.mark.parametrize("element", [*BACKLASHES, FrictionBacklash(1.0) + CoulombFriction(0.01)])
def test_every_harmonic_is_in_balance(element: Element) -> None:
    system = thesis_loop()
    for orbit in exact(element):
        breaks = np.concatenate([[0.0], orbit.switching_times, [orbit.period]])
        for number in (1, 3, 5):
            integral = sum(piece(orbit, number, *ends) for ends in pairwise(breaks))
            returned = -complex(system(1j * number * orbit.omega)) * integral * 2j / orbit.period
            scale = abs(orbit.harmonics[0])
            assert abs(orbit.harmonics[number - 1] - returned) < 1e-11 * scale
        assert abs(orbit.harmonics[1::2]).max() < 1e-12 * abs(orbit.harmonics[0])


@pytest.mark.parametrize(("element", "of_load"), [*zip(BACKLASHES, (1, 2, 2), strict=True)])
def test_one_multiplier_is_one_and_residual_is_rounding(element: Element, of_load: int) -> None:
    for orbit in exact(element):
        assert abs(orbit.multipliers - 1).min() < 1e-9
        assert orbit.residual < 1e-13
        assert len(orbit.multipliers) == 8 + of_load
        assert abs(orbit.multipliers[8:]).max() < 1e-12  # Contact fixes the load.
        assert len(orbit.nontrivial_multipliers) == 7 + of_load


def test_prediction_and_its_error_stand_beside_the_orbit() -> None:
    orbit = periodic_orbits(thesis_loop(), FrictionBacklash(4e-6))[0]
    assert orbit.prediction.amplitude == pytest.approx(orbit.amplitude * (1 + orbit.amplitude_error))
    assert orbit.prediction.frequency == pytest.approx(orbit.frequency * (1 + orbit.frequency_error))
    # 8.31520 gap at 733.6306 Hz by harmonic balance, 8.28949 gap at 733.5681 Hz exactly.
    assert orbit.amplitude_error == pytest.approx(3.1e-3, rel=0.01)
    assert orbit.frequency_error == pytest.approx(8.5e-5, rel=0.01)


def test_guesses_are_pairs_too_and_lead_to_the_same_orbit_once() -> None:
    expected = exact(FrictionBacklash(1.0))[0]
    found = periodic_orbits(thesis_loop(), FrictionBacklash(1.0), [(8.0, 4600.0), (8.5, 4620.0)])
    assert len(found) == 1
    assert found[0].period == pytest.approx(expected.period, rel=1e-12)
    assert math.isnan(found[0].amplitude_error)


def test_no_orbit_means_a_warning_and_an_empty_list() -> None:
    with pytest.warns(OrbitNotFoundWarning, match="amplitude 2 and omega 9 rad/s"):
        assert periodic_orbits(control.tf([1], [1, 1, 1]), FrictionBacklash(1.0), [(2.0, 9.0)]) == []
    with pytest.warns(OrbitNotFoundWarning):  # Inside the gap.
        assert periodic_orbits(thesis_loop(), FrictionBacklash(1.0), [(0.3, 4600.0)]) == []


@pytest.mark.parametrize("guess", [(-1.0, 3.0), (1.0, 0.0), (math.nan, 1.0), (1.0, math.inf)])
def test_a_guess_must_be_positive_and_finite(guess: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match="of a guess must be positive and finite"):
        periodic_orbits(thesis_loop(), FrictionBacklash(1.0), [guess])


@pytest.mark.filterwarnings("ignore::trimmer.UndecidedWarning")
def test_a_double_integrator_with_a_relay_keeps_any_amplitude_and_is_told_once() -> None:
    """x'' = -sign x from A takes sqrt(2 A) to zero, a quarter of the period."""
    found = periodic_orbits(ClosedLoop(control.tf([1], [1, 0, 0]), Relay(1.0)))
    (orbit,), (family,) = found, found.families
    assert orbit.period == pytest.approx(4 * math.sqrt(2 * orbit.amplitude), rel=1e-12)
    assert (orbit.stable, orbit.neutral) == (False, True)
    assert family.member is orbit
    assert family.met > 20
    assert family.amplitudes[0] < 0.1 < 100 < family.amplitudes[1] == orbit.amplitude
    assert "stands for a continuum" in found.message


@pytest.mark.parametrize("gap", [2.4, 2.5, 2.6])
def test_a_continuum_ends_where_a_play_just_touches(gap: float) -> None:
    """From outside the load is pushed to there, with contacts as short as rounding makes them."""
    names = ["relay", "play"]
    matrices = [
        [[0, 1, 0], [-1.75, -0.47, 0], [1.41, 0, -2.45]],
        [[0, 0], [-2.25, 0.14], [-0.13, 0.1]],
        [[0.48, 0, 1.16], [0.36, 0, 0.98]],
    ]
    plant = control.ss(*matrices, 0, inputs=names, outputs=names)
    found = periodic_orbits(
        Feedback(plant, {"relay": Relay(0.8, hysteresis=0.2), "play": FrictionBacklash(gap)})
    )
    ((orbit,), (family,)) = found, found.families
    assert orbit.neutral and orbit.edge is None and family.member is orbit
