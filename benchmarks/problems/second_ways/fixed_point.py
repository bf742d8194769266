"""Newton's method for what a map leaves as it is, with derivatives by differences."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np


def jacobian(
    of: Callable[[np.ndarray], np.ndarray], x: np.ndarray, steps: np.ndarray, order: int
) -> np.ndarray:
    """Return the derivative by central differences of second or fourth order."""
    columns = []
    for i, step in enumerate(steps):
        shift = np.zeros(len(x))
        shift[i] = step
        near = of(x + shift) - of(x - shift)
        if order == 2:
            columns.append(near / (2.0 * step))
        else:
            columns.append((8.0 * near - of(x + 2 * shift) + of(x - 2 * shift)) / (12.0 * step))
    return np.array(columns).T


def fixed_point(of: Callable[[np.ndarray], np.ndarray], x: np.ndarray, scale: np.ndarray, order: int = 4):
    """Return x = of(x) by Newton's method, and the derivative of ``of`` there."""
    x = np.array(x, dtype=float)
    for step in range(30):
        if step % 5 == 0:
            derivative = jacobian(of, x, 1e-5 * scale, 2)
        change = np.linalg.solve(derivative - np.eye(len(x)), x - of(x))
        x = x + change
        if np.max(np.abs(change) / scale) < 2e-13:
            break
    else:
        raise ValueError(
            f"no periodic motion was found: the last change is {np.max(np.abs(change) / scale):.1e}"
        )
    return x, jacobian(of, x, 1e-4 * scale, order)
