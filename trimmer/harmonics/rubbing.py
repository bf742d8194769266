"""Dry friction in harmonic balance: its force changes its sign where the velocity does.

A trigonometric polynomial cannot stay at zero, so that there is no stick, only a velocity that is small.
"""

import numpy as np

from trimmer.harmonics.crossings import crossings
from trimmer.harmonics.forces import Harmonics, Pieces, piecewise, with_moving_ends
from trimmer.harmonics.waveform import PeriodicWaveform


def friction_harmonics(distance: PeriodicWaveform, drift: float, force: float) -> Harmonics:
    """Return the harmonics of force sign(v), N; v, m/s, is a drift and the rate of a distance, m."""
    velocity = PeriodicWaveform(distance.turning * distance.coefficients, distance.omega).shifted(drift)
    period = distance.period
    zeros = crossings(velocity, 0.0, period)
    edges = np.concatenate([[0.0], zeros, [period]])
    signs = np.sign(velocity.at(0.5 * (edges[1:] + edges[:-1])))
    pieces = Pieces(edges[:-1], edges[1:], -signs)
    fixed = piecewise(distance, np.zeros(len(distance.coefficients), dtype=complex), force, pieces)
    steepness = abs(velocity.slope(zeros))
    return with_moving_ends(fixed, distance, zeros, 2.0 * force / steepness, distance.turning)
