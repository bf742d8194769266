"""Special points of published examples, rad/s. Digits: two independent computations."""

from __future__ import annotations

from trimmer.branches.special import SpecialKind

OSCILLATOR_WITH_STOP = [
    (SpecialKind.GRAZING, 5.534678554),
    (SpecialKind.PERIOD_DOUBLING, 5.5567187941),
    (SpecialKind.PERIOD_DOUBLING, 5.7079092816),
    (SpecialKind.FOLD, 8.566393659),
    (SpecialKind.FOLD, 6.9976281194),
    (SpecialKind.GRAZING, 6.997666276),
]
"""An example of pyHarm, from 5 to 12 rad/s."""
DEAD_ZONE = [
    (SpecialKind.GRAZING, 0.8206310877),
    (SpecialKind.FOLD, 0.8284639844),
    (SpecialKind.FOLD, 0.7080316187),
    (SpecialKind.GRAZING, 1.4070884660),
]
"""A body in a dead zone, from 0.5 to 1.6 rad/s."""
