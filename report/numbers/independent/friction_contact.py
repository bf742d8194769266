"""Where backlash with friction begins to move its load."""

from __future__ import annotations

import sympy


def least_amplitude_with_contact() -> float:
    """Return the amplitude over the gap from which there is a phase of contact, where 1 - b/A is a sine."""
    amplitude = sympy.Symbol("a", positive=True)
    return float(sympy.solve(sympy.Eq(1 - 1 / amplitude, -1), amplitude)[0])
