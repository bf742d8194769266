"""Bounds that do not depend on amplitude and frequency, in the shape of the arguments."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.elements.expansion import GainSensitivity, GainVariation

if TYPE_CHECKING:
    from trimmer.elements.element import Range


def constant_sensitivity(
    by_u: float, by_log_omega: float, u_range: Range, omega_range: Range | None
) -> GainSensitivity:
    """Return bounds that hold everywhere, in the shape of the ranges."""
    shape = range_shape(u_range, omega_range)
    return GainSensitivity(np.full(shape, by_u)[()], np.full(shape, by_log_omega)[()])


def no_variation(u_range: Range, omega_range: Range | None) -> GainVariation:
    """Return zeros, in the shape of the ranges: the derivatives are constant."""
    shape = range_shape(u_range, omega_range)
    return GainVariation(np.zeros(shape)[()], np.zeros(shape)[()])


def range_shape(u_range: Range, omega_range: Range | None) -> tuple[int, ...]:
    """Return the shape that the limits of both ranges broadcast to."""
    shapes = {np.shape(limit) for limit in (*u_range, *(omega_range or ()))}
    return shapes.pop() if len(shapes) == 1 else np.broadcast_shapes(*shapes)
