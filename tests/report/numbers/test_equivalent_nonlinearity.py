"""The variants of the equivalent nonlinearity, against the listing's lines and the equation's print."""

import math

import numpy as np
import pytest

from report.numbers.equivalent_nonlinearity import (
    FORCE,
    FORCES,
    listing_element,
    printed_function,
    right_element,
)
from report.numbers.thesis import DRIVE_OMEGA, SMALL_GAP
from trimmer import response_at
from trimmer.balance.solve import limit_cycles
from trimmer.elements.backlashes.friction_backlash import FrictionBacklash


@pytest.fixture(scope="module")
def system(evidence):
    return evidence.numbers.displacement_only


@pytest.fixture(scope="module")
def numbers(evidence):
    return evidence.cycles.equivalent


def line_by_line(A, D, w, Fc):
    """Listing A.6, its lines 10 to 18 as they stand."""
    N_re = (
        0.5 + 1 / np.pi * (1 - (D / A)) * np.sqrt(1 - (1 - D / A) ** 2) + 1 / np.pi * np.arcsin(1 - (D / A))
    )
    N_im = -(1 / np.pi) * (1 - (1 - D / A) ** 2)
    Nr = N_re + 1j * N_im
    a_1 = 0
    b_1 = (4 * Fc) / np.pi
    Nf = (1 / A) * (b_1 + 1j * a_1)
    return Nr - (1j / w) * Nf


def test_the_listing_element_is_the_listing():
    amplitudes = SMALL_GAP * np.geomspace(0.51, 1e4, 60)
    ours = listing_element(FORCE).describing_function(amplitudes)
    np.testing.assert_allclose(ours, line_by_line(amplitudes, SMALL_GAP, DRIVE_OMEGA, FORCE), rtol=1e-9)


def test_the_right_element_damps_where_the_listing_feeds():
    """Friction takes energy where the imaginary part of what it adds is positive: a force ahead of x."""
    amplitude, k2 = 3 * SMALL_GAP, 30e3
    backlash = FrictionBacklash(SMALL_GAP).describing_function(amplitude)
    right = (right_element(FORCE, k2).describing_function(amplitude) - backlash) * k2
    assert right == pytest.approx(4j * FORCE / (math.pi * amplitude))
    wrong = listing_element(FORCE).describing_function(amplitude) - backlash
    assert wrong.real == pytest.approx(0, abs=1e-9)
    assert wrong.imag < 0


@pytest.mark.parametrize("factor", [1e-3, 7.0])
def test_only_force_over_frequency_and_gap_counts(factor):
    """One family of contours, as the claim on figure 5.21 says."""
    amplitudes = np.geomspace(0.6, 50, 20)
    reference = listing_element(FORCE).describing_function(SMALL_GAP * amplitudes)
    for changed, gap in (
        (listing_element(factor * FORCE, SMALL_GAP, factor * DRIVE_OMEGA), SMALL_GAP),
        (listing_element(factor * FORCE, factor * SMALL_GAP), factor * SMALL_GAP),
        (listing_element(FORCE, SMALL_GAP / factor, factor * DRIVE_OMEGA), SMALL_GAP / factor),
    ):
        np.testing.assert_allclose(changed.describing_function(gap * amplitudes), reference, rtol=1e-9)


def test_the_printed_equation_needs_pi_and_the_amplitude_in_its_real_part():
    """With A/π in its real part, one A fewer under friction and b half of the gap it is the listing."""
    amplitude = 2.3 * SMALL_GAP
    printed = printed_function(amplitude, FORCE, SMALL_GAP / 2)
    friction = -4 * FORCE / (DRIVE_OMEGA * math.pi * amplitude)
    real = printed.real * amplitude / math.pi
    imaginary = printed.imag - friction / amplitude + friction
    assert complex(real, imaginary) == pytest.approx(listing_element(FORCE).describing_function(amplitude))


def test_every_prediction_closes_its_loop(numbers, system, evidence):
    def distance(gain, omega, plant=system):
        return abs(1 + gain * complex(response_at(plant, omega)))

    rounded = evidence.cycles.listing
    for cycle in numbers.rounded:
        assert (
            distance(line_by_line(cycle.amplitude, SMALL_GAP, DRIVE_OMEGA, FORCE), cycle.omega, rounded)
            < 1e-9
        )
    for cycle in numbers.listing:
        assert distance(line_by_line(cycle.amplitude, SMALL_GAP, DRIVE_OMEGA, FORCE), cycle.omega) < 1e-9
    for cycle, force in zip(numbers.by_force, FORCES, strict=True):
        assert distance(line_by_line(cycle.amplitude, SMALL_GAP, DRIVE_OMEGA, force), cycle.omega) < 1e-9
    printed = numbers.as_printed
    assert distance(printed_function(printed.amplitude, FORCE), printed.omega) < 1e-9


def test_the_listing_with_its_coefficients_gives_the_reviewed_frequency(numbers):
    """737.517 Hz at 16.8 mm; the thesis prints 737.514 and no amplitude."""
    (cycle,) = numbers.rounded
    assert f"{cycle.frequency:.3f}" == "737.517"
    assert f"{1e3 * cycle.amplitude:.1f}" == "16.8"


def test_without_force_it_is_backlash(system, evidence):
    almost = limit_cycles(system, listing_element(1e-12))
    for cycle, pair in zip(
        almost, (evidence.cycles.friction.unstable, evidence.cycles.friction.stable), strict=True
    ):
        assert cycle.amplitude / SMALL_GAP == pytest.approx(pair.amplitude, rel=1e-6)


def test_the_frequency_tends_to_where_the_real_part_of_the_inverse_is_minus_one(numbers, system):
    strongest = numbers.by_force[-1]
    inverse = 1 / complex(response_at(system, strongest.omega))
    assert inverse.real == pytest.approx(-1, abs=1e-4)
    assert all(np.diff([cycle.frequency for cycle in numbers.by_force]) > 0)


def test_friction_that_takes_energy_leaves_no_limit_cycle(numbers):
    assert numbers.sign_turned == ()
    assert numbers.over_stiffness == ()
    assert numbers.over_stiffness_both_channels == ()
    assert numbers.in_place.limit_cycles(FORCE / SMALL_GAP) == 0
    assert 0.03 < numbers.force_of_merger < 0.035


def test_over_the_stiffness_and_in_its_place_friction_ends_the_limit_cycle_at_nearly_one_force(
    numbers, system
):
    k2, merger = 30e3, numbers.in_place.merger.force_per_gap
    assert len(limit_cycles(system, right_element(0.95 * merger * SMALL_GAP, k2))) == 2
    assert limit_cycles(system, right_element(1.02 * merger * SMALL_GAP, k2)) == ()
