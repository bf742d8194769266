"""Listings A.3 and A.4, describing functions, repeated line by line."""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq


def friction_listing(amplitude: complex, width: float) -> complex:
    """Return what Listing A.3 returns: its last line overwrites the zeros that its sixth line has set."""
    ratio = np.complex128(1 - width / amplitude)
    real = 0.5 + ratio * np.sqrt(1 - ratio**2) / np.pi + np.arcsin(ratio) / np.pi
    return complex(real - 1j * (1 - ratio**2) / np.pi)


def inertia_listing(ratio: float, scale: float) -> complex:
    """Return what Listing A.4 returns for its arguments Beta and w, with the root of its equation."""
    root = brentq(lambda x: scale * x - ratio - np.sin(scale * x), 0.0, 10.0 / scale)
    return inertia_formula(root, ratio)


def inertia_formula(angle: float, ratio: float) -> complex:
    """Return what the lines of Listing A.4 after its search make of the root that it found."""
    nested = np.sin(angle) + ratio
    real = (np.pi + 2 * np.sin(nested) - angle - np.sin(nested) * np.cos(nested)) / np.pi
    return complex(real, -((1 - np.cos(nested)) ** 2) / np.pi)
