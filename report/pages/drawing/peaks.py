"""Peaks of drawn spectra, to which a page leads its reader."""

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from report.pages.drawing.marks import STABLE, UNSTABLE
from trimmer.arrays import Flags, Reals

MOST: Final = 12  # Most peaks of a line, the highest
SEEN: Final = 5.0
"""Least height of a peak above the higher one of the valleys beside it, in pixels of the drawing."""


def peaks(line: Line2D, axes: Axes) -> Reals:
    """Return the peaks of a line that are inside of its axes, as rows of x and y, the highest first.

    Of a line without strokes, as stems have at their ends, each symbol is a peak.
    """
    x, y = (np.asarray(each, float) for each in line.get_data(orig=False))
    if line.get_label() in (STABLE, UNSTABLE):
        return np.empty((0, 2))
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    inside = (x >= left) & (x <= right) & (y > low) & (y <= high)
    chosen = inside if line.get_linestyle() == "None" else inside & _are_tops(_heights(line, axes))
    tops = np.flatnonzero(chosen)
    highest = tops[np.argsort(-y[tops], kind="stable")][:MOST]
    return np.column_stack([x[highest], y[highest]])


def _heights(line: Line2D, axes: Axes) -> Reals:
    """Return how high samples are drawn, in pixels; what cannot be drawn is as low as the lowest."""
    up = axes.transData.transform(np.column_stack(line.get_data(orig=False)))[:, 1]
    return np.where(np.isfinite(up), up, min(up[np.isfinite(up)], default=0.0))


def _are_tops(up: Reals) -> Flags:
    """Say which samples are higher than their neighbours and stand out from the valleys beside them."""
    tops = np.zeros(up.size, bool)
    tops[1:-1] = (up[1:-1] > up[:-2]) & (up[1:-1] >= up[2:])
    for top in np.flatnonzero(tops):
        higher = np.flatnonzero(up > up[top])
        before, after = higher[higher < top], higher[higher > top]
        begin, end = (before[-1] if before.size else 0), (after[0] if after.size else up.size - 1)
        valley = max(up[begin : top + 1].min(), up[top : end + 1].min())
        tops[top] = up[top] - valley >= SEEN
    return tops
