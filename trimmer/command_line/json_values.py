"""Infinite, missing and complex numbers in a form that JSON has."""

from __future__ import annotations

import math


def finite(value: float) -> float | None:
    """Return a number as it is, and None, which is null in JSON, in place of infinity and NaN."""
    return value if math.isfinite(value) else None


def pair(value: complex) -> tuple[float, float]:
    """Return the real and the imaginary part, which are a list of two numbers in JSON."""
    return value.real, value.imag
