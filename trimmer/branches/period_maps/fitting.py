"""The map whose orbits a driven motion can join and leave: of half its period, mirrored, or doubled."""

from dataclasses import replace

import numpy as np

from trimmer.arrays import Reals
from trimmer.branches.period_maps.driven_map import DrivenMap

SYMMETRIC = 1e-6
"""Difference of half a period and its mirror image, relative to the sizes, within which they are the same."""


def fitting(map: DrivenMap, value: float, state: Reals) -> DrivenMap:
    """Return the map whose orbits a motion can join and leave, doubled so often that the motion is its orbit.

    A motion that is its own mirror image is an orbit of half a period already. Where the number of periods
    was given, and the motion repeats after half of it, nothing is doubled.
    """
    if map.periods % 2 == 0:
        half = replace(map, periods=map.periods // 2)
        return map if _repeats(half, map, value, state) else _asymmetric(half).doubled()
    if not map.is_mirror_symmetric:
        return map
    mirrored = replace(map, mirrored=True)
    return mirrored if _repeats(mirrored, map, value, state) else mirrored.doubled()


def shortest_map(map: DrivenMap, value: float, state: Reals) -> DrivenMap:
    """Return the map of half the periods, and so on, as long as a motion repeats after them.

    So it does where a branch of doubled periods joins the one that it parts from.
    """
    while map.periods % 2 == 0:
        half = replace(map, periods=map.periods // 2)
        if not _repeats(half, map, value, state):
            break
        map = half
    return map


def is_symmetric(map: DrivenMap, value: float, state: Reals) -> bool:
    """Say whether a motion is its own mirror image half a period later, as far as it is known."""
    if map.periods % 2 == 0 or not map.is_mirror_symmetric:
        return False
    return _repeats(replace(map, mirrored=True), map, value, state)


def _asymmetric(map: DrivenMap) -> DrivenMap:
    """Return the map of an asymmetric motion, doubled from that of the simplest motion there can be."""
    if map.periods % 2 == 0:
        return _asymmetric(replace(map, periods=map.periods // 2)).doubled()
    return replace(map, mirrored=True).doubled() if map.is_mirror_symmetric else map


def _repeats(half: DrivenMap, map: DrivenMap, value: float, state: Reals) -> bool:
    """Say whether a motion, as far as it is known, is an orbit of half of the map already."""
    passage, whole = half.passage(value, state), map.passage(value, state)
    sizes = np.where(passage.sizes > 0.0, passage.sizes, 1.0)
    unsettled = float(abs((whole.end - state) / sizes).max())
    return float(abs((passage.end - state) / sizes).max()) <= SYMMETRIC + 10.0 * unsettled
