"""JSON as commands print it, with infinite, missing and complex numbers in a form that it has."""

from __future__ import annotations

import json
import math


def document(content: object) -> str:
    """Return what a command prints as JSON.

    Raises:
        ValueError: if a number is infinite or none, which JSON does not have.
    """
    return json.dumps(content, indent=2, allow_nan=False)


def finite(value: float) -> float | None:
    """Return a number as it is, and None, which is null in JSON, in place of infinity and NaN."""
    return value if math.isfinite(value) else None


def pair(value: complex) -> tuple[float, float]:
    """Return the real and the imaginary part, which are a list of two numbers in JSON."""
    return value.real, value.imag
