"""Sizes of numbers that can be computed with: their squares and products neither overflow nor vanish."""

import math

SMALLEST, LARGEST = 1e-50, 1e50


def reason_against_size(value: float) -> str:
    """Return why the size of a number cannot be used, as a piece of a message; empty if it can.

    Zero can, and what is not finite is for others to judge.
    """
    if value == 0 or not math.isfinite(value) or SMALLEST <= abs(value) <= LARGEST:
        return ""
    return f"is beyond what can be computed with: sizes from {SMALLEST:g} to {LARGEST:g}, and zero"
