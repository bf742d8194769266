"""The instants at which the signals of a motion stand in a table."""

import numpy as np

from trimmer.arguments import whole_number
from trimmer.arrays import Reals

POINTS = 1000  # Instants that are evenly spread, if no number is given


def moments(duration: float, events: Reals, points: int) -> Reals:
    """Return instants that are evenly spread over a motion, and those of its events, s, in their order."""
    even = np.linspace(0.0, duration, whole_number("points", points, 2))
    return np.union1d(even, events)
