"""Curves -1/N and N of backlash: python-control's intersections with G, distances, and what lies between."""

from __future__ import annotations

import math
import warnings

import control
import numpy as np
from matplotlib.path import Path

from report.thesis import PLOT_OFFSET
from trimmer import Element, FrictionBacklash, InertiaBacklash, ViscousBacklash, response_at

LIBRARY_GAP = 1e-4
"""m."""
LIBRARY_GRID = np.linspace(LIBRARY_GAP / 2 + PLOT_OFFSET, 0.0025, 50)
"""Amplitudes on which the library interpolates, over the range of Listing A.9, m."""
LIBRARY_OMEGA = np.geomspace(1e3, 1e4, 300)


def intersections_by_library(system: control.TransferFunction) -> list[tuple[float, float]]:
    """Return amplitude (m) and ω (rad/s) of what python-control finds, in order of frequency."""
    element = control.friction_backlash_nonlinearity(LIBRARY_GAP)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # it says that it could not refine one of them
        found = control.describing_function_response(system, element, LIBRARY_GRID, LIBRARY_OMEGA)
    return sorted(found.intersections, key=lambda point: point[1])


def distance_from_curve(system: control.TransferFunction, element: Element, omega: float) -> float:
    """Return how far G is from the curve -1/N at an angular frequency (rad/s)."""
    ratios = np.linspace(1e-4, 0.9999, 4000) * float(element.domain(1.0))
    curve = -1 / element.describing_function(1 / ratios)
    return float(np.abs(curve - complex(response_at(system, omega))).min())


def lies_between_the_limits(gamma: float) -> bool:
    """Return whether the contour of N for one γ stays in the region between friction's and inertia's."""
    ratios = np.linspace(1e-4, 1, 3000)
    friction = FrictionBacklash(1.0).describing_function(1 / (ratios * 1.9999))
    inertia = InertiaBacklash(1.0).describing_function(1 / (ratios * (math.pi - 1e-6)))
    outline = np.concatenate([friction, inertia[::-1]])
    element = ViscousBacklash(1.0, gamma)
    on_contour = np.linspace(0.02, 0.999, 200) * float(element.domain(1.0))
    contour = element.describing_function(1 / on_contour, 1.0)
    region = Path(np.column_stack([outline.real, outline.imag]))
    return bool(region.contains_points(np.column_stack([contour.real, contour.imag]), radius=1e-5).all())
