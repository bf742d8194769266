"""Listing A.5 repeated: its lines 11 to 21 are right, its line 6 is solved as printed."""

import math

import control
import numpy as np
import pytest

from report.numbers import listed_functions
from report.numbers.listed_functions import (
    RATIOS,
    START,
    contact_angle,
    intersections,
    listing_contour,
    listing_gain,
)
from trimmer import ViscousBacklash


@pytest.mark.parametrize("gamma", [0.4, 1.25, 3.0])
@pytest.mark.parametrize("ratio", [0.1, 1.0, 1.6])
def test_with_the_right_contact_angle_the_listing_gives_the_describing_function(gamma, ratio):
    element = ViscousBacklash(1.0, gamma)
    expected = element.describing_function(1 / ratio, 1.0)
    separation, root = math.atan(1 / gamma), math.sqrt(1 + gamma**2)
    angles = separation + np.linspace(1e-6, math.pi, 200001)
    flight = gamma**2 * np.exp((separation - angles) / gamma) / root
    angle = np.interp(ratio, root - np.sin(angles) - flight, angles)
    assert listing_gain(gamma, ratio, complex(angle)) == pytest.approx(expected, abs=1e-8)


@pytest.mark.parametrize("gamma", [1.05, 1.25, 1.45])
def test_line_6_is_solved_as_printed(gamma):
    root = START
    for ratio in RATIOS:
        root = contact_angle(gamma, float(ratio), root)
        left = np.sqrt(complex(1 - gamma**2)) - ratio
        flight = gamma**2 * np.exp(1 / gamma * (math.atan(1 / gamma) - root))
        assert np.sin(root) + flight / np.sqrt(1 + gamma**2) == pytest.approx(left, abs=1e-11)
        assert abs(root.imag) > 0.1


def test_the_listings_contours_stay_away_from_the_critical_point():
    for gamma in (1.05, 1.25, 1.45):
        assert np.abs(listing_contour(gamma) + 1).min() > 0.5


def test_a_polygon_meets_a_known_locus_where_it_should():
    """1/(s/w + 1) runs on the half circle around 1/2; at w it is at (1 - j)/2, at 2 w at (1 - 2j)/5."""
    omega = 2 * np.pi * 400.0
    plant = control.tf([1], [1 / omega, 1])
    polygon = np.array([0.5 - 2j, 0.5 + 0.2j, 0.2 + 0.2j, 0.2 - 2j])
    assert np.array(intersections(polygon, plant)) / omega == pytest.approx([1.0, 2.0], rel=1e-4)
    assert intersections(np.array([2 + 0j, 2 - 1j]), plant) == ()


def test_distances_of_contours_are_those_to_the_nearest_point():
    assert listed_functions.mean_distance(
        np.array([0j, 3.0]), np.array([4j, 3.0 + 1j, 9.0])
    ) == pytest.approx((np.sqrt(10) + 1) / 2)


def test_contours_begin_and_end_where_the_elements_do():
    fast = listed_functions.equivalent_contour(0.15, 2e-3, 1e9)
    assert fast[-1] == pytest.approx(-1 / listed_functions.friction_listing(60.0, 1.0), rel=1e-6)
    heavy = listed_functions.inertia_contour(2e-3)
    by_listing = [-1 / listed_functions.inertia_listing(1 / each, 1.0) for each in listed_functions.IN_GAPS]
    np.testing.assert_allclose(heavy, by_listing, rtol=1e-9)
