"""Loci of G and of describing functions on grids: crossings, solutions, angles and distances; poles."""

import math
import warnings

import control
import numpy as np
from matplotlib.path import Path

from report.numbers.thesis import PLOT_OFFSET
from trimmer import FrictionBacklash, InertiaBacklash, LimitCycle, ViscousBacklash, response_at
from trimmer.arrays import Complexes
from trimmer.elements import Element

GRID = np.geomspace(1, 1e6, 20_000)
FINE_GRID = np.geomspace(100, 1e5, 40_001)  # Angular frequencies of crossings and of solutions, rad/s
STEP = 1e-6  # Relative step of a difference
LIBRARY_GAP = 1e-4
LIBRARY_GRID = np.linspace(LIBRARY_GAP / 2 + PLOT_OFFSET, 0.0025, 50)
"""Amplitudes on which python-control interpolates, over the range of Listing A.9, m."""
LIBRARY_OMEGA = np.geomspace(1e3, 1e4, 300)
LEADING_OMEGA = np.linspace(1.0, 2e4, 20_001)
"""Angular frequencies at which a lead is looked for, rad/s: far beyond the last natural mode."""
AMPLITUDES = np.geomspace(0.5001, 1e7, 4_000)
"""Amplitudes over the gap, from the edge of the dead band to where the gap no longer matters."""


def crossings(system: control.TransferFunction) -> int:
    """Return how often a locus crosses the negative real axis."""
    response = response_at(system, GRID)
    return int((np.diff(np.sign(response.imag)).astype(bool) & (response.real[1:] < 0)).sum())


def solutions(system: control.TransferFunction, share: float) -> int:
    """Return the number of solutions of 1 + N G = 0 for backlash with a term j 4 share/(π A), A in gaps.

    At each frequency of a grid the real part of N, which rises with A, gives A; what is left of the imaginary
    part then changes its sign at a solution.
    """
    needed = -1 / np.asarray(response_at(system, FINE_GRID))
    amplitudes = 0.5 + np.geomspace(1e-9, 1e6, FINE_GRID.size)
    element = FrictionBacklash(1.0).describing_function(amplitudes)
    amplitude = np.interp(needed.real, element.real, amplitudes, left=np.nan, right=np.nan)
    imaginary = np.interp(needed.real, element.real, element.imag) + 4 * share / (np.pi * amplitude)
    left = imaginary - needed.imag
    return int((left[:-1] * left[1:] < 0).sum())


def angle(system: control.TransferFunction, element: Element, cycle: LimitCycle) -> float:
    """Return the angle between N and -1/G at a limit cycle, rad, at most π/2."""
    around = np.array([1 - STEP, 1 + STEP])
    gains = element.describing_function(cycle.amplitude * around)
    inverse = -1 / response_at(system, cycle.omega * around)
    directions = [complex(np.diff(curve)[0]) for curve in (gains, inverse)]
    turned = abs(np.angle(directions[1] / directions[0]))
    return float(min(turned, np.pi - turned))


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


def gains_where_phases_match(system: control.StateSpace | control.TransferFunction) -> tuple[float, float]:
    """Return the least and the largest |N G| over all frequencies where G leads by what backlash lags."""
    library = control.friction_backlash_nonlinearity(1.0)
    lag = np.array([-np.angle(library.describing_function(float(each))) for each in AMPLITUDES])
    response = np.asarray(response_at(system, LEADING_OMEGA))
    response = response[np.angle(response) > 0]
    matching = np.interp(np.angle(response), lag[::-1], AMPLITUDES[::-1])
    gains = [
        abs(value * library.describing_function(float(amplitude)))
        for value, amplitude in zip(response, matching, strict=True)
    ]
    return float(min(gains)), float(max(gains))


def decays(plant: control.TransferFunction) -> bool:
    """Return whether all poles of a plant lie in the left half plane."""
    return bool((plant.poles().real < 0).all())


def feedback_poles(plant: control.TransferFunction) -> Complexes:
    """Return the poles of a plant in negative unit feedback, 1/s."""
    return np.asarray(control.feedback(plant, 1).poles())
