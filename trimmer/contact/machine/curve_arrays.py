"""The arrays of curves: a force that is straight between knots, over a distance or a speed.

The curve of a friction is its kinetic force where sliding begins, which is dry friction, and beside it an odd
function of the velocity that is zero at rest: that is what stands here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from trimmer.arrays import Reals
from trimmer.mechanism.parts import GROUND

if TYPE_CHECKING:
    from trimmer.contact.state.rows import EndRows
    from trimmer.mechanism.mechanism import Mechanism
    from trimmer.mechanism.parts import Curve


class Segments(NamedTuple):
    """A force that is slopes x + heights, each between two knots; one segment more than knots."""

    knots: Reals
    slopes: Reals
    heights: Reals


def curve_arrays(mechanism: Mechanism, rows: EndRows) -> dict[str, Any]:
    """Return the arrays of a machine for its curves: see ``Machine``."""
    names = rows.layout.curves
    parts = [(section, getattr(mechanism, section)[name]) for section, name in names]
    forces = [
        of_link(part.curve) if section == "links" else of_friction(part.curve) for section, part in parts
    ]
    most = max((len(each.knots) for each in forces), default=0)
    ends = [(section == "links", part.between) for section, part in parts]
    size, count = len(rows.displacement(GROUND)), len(rows.push(GROUND, GROUND))
    return {
        "curve_over": np.array(
            [rows.distance(each) if is_link else rows.speed(each) for is_link, each in ends]
        ).reshape(-1, size),
        "curve_push": np.array([-rows.push(*part.between) for _, part in parts]).reshape(-1, count),
        "curve_knots": _padded([each.knots for each in forces], most, np.inf),
        "curve_by_speed": np.array([not is_link for is_link, _ in ends], dtype=np.int64),
        "curve_slopes": _padded([each.slopes for each in forces], most + 1, 0.0),
        "curve_heights": _padded([each.heights for each in forces], most + 1, 0.0),
    }


def _padded(rows: list[Reals], width: int, filling: float) -> Reals:
    found = np.full((len(rows), width), filling)
    for row, values in zip(found, rows, strict=True):
        row[: len(values)] = values
    return found


def of_link(curve: Curve) -> Segments:
    """Return the force of a link by its elongation; the outer segments go on."""
    points = np.array(curve)
    slopes = np.diff(points[:, 1]) / np.diff(points[:, 0])
    return Segments(points[1:-1, 0], slopes, points[:-1, 1] - slopes * points[:-1, 0])


def of_friction(curve: Curve) -> Segments:
    """Return what sliding takes beyond the force at rest, by the velocity; constant beyond the last point."""
    points = np.array(curve) - [0.0, curve[0][1]]
    slopes = np.append(np.diff(points[:, 1]) / np.diff(points[:, 0]), 0.0)
    heights = points[:, 1] - slopes * points[:, 0]
    return Segments(
        np.concatenate([-points[:0:-1, 0], points[1:, 0]]),
        np.concatenate([slopes[:0:-1], slopes]),
        np.concatenate([-heights[:0:-1], heights]),
    )
