"""The corrected listings, run by GNU Octave, give what the library computes."""

import control
import numpy as np
import pytest

from tests.report.octave import points
from tests.report.octave.conftest import complexes
from trimmer import FrictionBacklash, InertiaBacklash, TrimmerParameters, ViscousBacklash, limit_cycles, modes
from trimmer.elements import CoulombFriction
from trimmer.linear import InputChannels, linear_model, pin_model, response_at, transfer_function

pytestmark = pytest.mark.octave
THESIS = TrimmerParameters.thesis()
RELATIVE = 1e-9
GAP = 4e-5


def same(values, expected):
    """Compare relative to each value's modulus; NaN where NaN is expected."""
    np.testing.assert_array_equal(np.isnan(values), np.isnan(expected))
    np.testing.assert_allclose(values, expected, rtol=RELATIVE, atol=0)


def test_matrices(octave_run):
    model, expected = octave_run.main["listing_a_1"], linear_model(THESIS)
    same(model["A"], expected.A)
    same(model["B"], expected.B)
    same([model["C"]], expected.C)
    same(model["pin_input"], pin_model(THESIS).B[:, 0])
    assert model["feedthrough"] == 0


@pytest.mark.parametrize(
    ("name", "channels"),
    [
        ("numerator", InputChannels.DISPLACEMENT_AND_VELOCITY),
        ("numerator_displacement", InputChannels.DISPLACEMENT_ONLY),
    ],
)
def test_transfer_function(octave_run, name, channels):
    model, expected = octave_run.main["listing_a_1"], transfer_function(THESIS, channels=channels)
    same(model[name], expected.num[0][0])
    same(model["denominator"], expected.den[0][0])


def test_eigenvalues(octave_run):
    values = complexes(octave_run.main["listing_a_1"]["eigenvalues"])
    expected = sorted((mode.eigenvalue for mode in modes(THESIS)), key=lambda value: value.imag)
    same(values.real, np.real(expected))
    same(values.imag, np.imag(expected))


def test_state_space_of_the_control_package(octave_run):
    same(complexes(octave_run.grid["response"]), response_at(pin_model(THESIS), points.OMEGAS))


@pytest.mark.parametrize("name", ["friction", "friction_again"])
def test_friction_backlash(octave_run, name):
    amplitude = points.GAP / points.FRICTION_RATIOS
    expected = FrictionBacklash(points.GAP).describing_function(amplitude)
    assert np.isnan(expected).sum() == 3
    same(complexes(octave_run.grid[name]), expected)


@pytest.mark.parametrize("name", ["inertia", "inertia_again"])
def test_inertia_backlash(octave_run, name):
    expected = InertiaBacklash(1.0).describing_function(1 / points.INERTIA_RATIOS)
    assert np.isnan(expected).sum() == 2
    same(complexes(octave_run.grid[name]), expected)


def test_viscous_backlash(octave_run):
    expected = ViscousBacklash(1.0, 1.0).describing_function(1 / points.VISCOUS_RATIOS, points.GAMMAS)
    assert np.isnan(expected).sum() == points.GAMMAS.size
    same(complexes(octave_run.grid["viscous"]), expected.ravel())


def test_backlash_and_coulomb_friction(octave_run):
    element = FrictionBacklash(points.GAP) + (1 / points.STIFFNESS) * CoulombFriction(points.FORCE)
    expected = element.describing_function(points.GAP / points.FRICTION_RATIOS)
    same(complexes(octave_run.grid["combined"]), expected)


def test_friction_backlash_moves_only_when_it_is_pushed(octave_run):
    """What defines the element, on a random walk: inside the play always, and moving at a wall only."""
    load, half = np.array(octave_run.grid["walk"]), 0.5 * points.GAP
    distance = load - points.WALK
    assert np.all(np.abs(distance) <= half * (1 + RELATIVE))
    moved = np.diff(load, prepend=0.0) != 0
    assert 0 < moved.sum() < moved.size
    np.testing.assert_allclose(np.abs(distance[moved]), half, rtol=RELATIVE)


@pytest.mark.parametrize(
    ("name", "element", "begin"),
    [
        ("friction_motion", FrictionBacklash(points.GAP), 0.5 / points.FREQUENCY),  # from the first push on
        ("inertia_motion", InertiaBacklash(points.GAP), -1.0),
    ],
)
def test_backlash_in_time(octave_run, name, element, begin):
    times = begin < points.TIMES
    expected = element.waveform(2 * np.pi * points.FREQUENCY * points.TIMES[times], points.AMPLITUDE)
    values = np.array(octave_run.grid[name])[times]
    np.testing.assert_allclose(values, expected, rtol=0, atol=RELATIVE * points.AMPLITUDE)


def test_inertia_backlash_at_contact_and_separation(octave_run):
    phase = 2 * np.pi * points.FREQUENCY * np.array(octave_run.grid["instants"])
    expected = InertiaBacklash(points.GAP).waveform(phase, points.AMPLITUDE)
    np.testing.assert_allclose(
        octave_run.grid["at_contact"], expected, rtol=0, atol=RELATIVE * points.AMPLITUDE
    )


BOTH, ONE = InputChannels.DISPLACEMENT_AND_VELOCITY, InputChannels.DISPLACEMENT_ONLY


@pytest.mark.parametrize(
    ("name", "element", "channels", "number"),
    [
        ("friction", FrictionBacklash(GAP), BOTH, 2),
        ("friction_displacement_only", FrictionBacklash(GAP), ONE, 2),
        ("inertia", InertiaBacklash(GAP), BOTH, 2),
        ("inertia_displacement_only", InertiaBacklash(GAP), ONE, 2),
        ("viscous", ViscousBacklash(GAP, 1 / 99), BOTH, 2),
        ("friction_and_coulomb", FrictionBacklash(GAP) + (1 / THESIS.k2) * CoulombFriction(0.015), BOTH, 2),
    ],
)
def test_limit_cycles(octave_run, name, element, channels, number):
    found = octave_run.main["listing_a_9"][name]
    expected = limit_cycles(transfer_function(THESIS, channels=channels), element)
    assert len(expected) == number
    same(found["amplitude"], [cycle.amplitude for cycle in expected])
    same(found["omega"], [cycle.omega for cycle in expected])
    same(found["frequency"], [cycle.frequency for cycle in expected])
    assert found["stable"] == [cycle.stable for cycle in expected]
    assert max(found["residual"]) < RELATIVE


RAISED = points.LOOP_GAIN * transfer_function(THESIS, channels=ONE)


@pytest.mark.parametrize(
    ("name", "system", "unstable"),
    [("raised", RAISED, 2), ("textbook", control.tf([points.NUMERATOR], [1, 2, 1, 0]), 0)],
)
def test_limit_cycles_beside_another_unstable_pole_and_with_an_integrator(octave_run, name, system, unstable):
    expected = limit_cycles(system, FrictionBacklash(1.0))
    assert len(expected) > 1
    assert sum(cycle.other_unstable_poles > 0 for cycle in expected) == unstable
    found = octave_run.grid[name]
    same(found["amplitude"], [cycle.amplitude for cycle in expected])
    same(found["omega"], [cycle.omega for cycle in expected])
    assert found["stable"] == [cycle.stable for cycle in expected]


def test_a_loop_without_limit_cycles(octave_run):
    assert octave_run.grid["none"] == 0


def test_main_numbers_of_the_elements(octave_run):
    amplitude = GAP * np.array([0.6, 1, 3, 10])
    expected = {
        "listing_a_2": FrictionBacklash(GAP),
        "listing_a_3": FrictionBacklash(GAP),
        "listing_a_4": InertiaBacklash(GAP),
        "listing_a_5": ViscousBacklash(GAP, 1.25).at(1.0),
        "listing_a_6": FrictionBacklash(GAP) + (1 / THESIS.k2) * CoulombFriction(0.015),
        "listing_a_10": InertiaBacklash(GAP),
    }
    for name, element in expected.items():
        same(complexes(octave_run.main[name]), element.describing_function(amplitude))


def test_nothing_in_the_programs_is_octave_alone(octave_run):
    """Octave warns of its own extensions of the language; its own files are full of them."""
    assert "language extension" in octave_run.warnings
    for paragraph in octave_run.warnings.split("\n\n"):
        first = paragraph.strip().partition("\n")[0]
        assert "listing_a" not in first, paragraph
        assert "main_numbers" not in first, paragraph
