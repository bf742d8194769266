"""What a signal of a motion is: displacement, velocity or acceleration, told by its unit."""

import re

from trimmer.choices import Choice

STANDARD_GRAVITY = 9.80665
"""m/s² in one g, by definition (3rd General Conference on Weights and Measures, 1901)."""


class MotionQuantity(Choice):
    """What a signal is; the value is its unit in SI, empty where it is no motion or its unit is not known."""

    DISPLACEMENT = "m"
    VELOCITY = "m/s"
    ACCELERATION = "m/s²"
    OTHER = ""

    @property
    def unit(self) -> str:
        """Unit in SI."""
        return str(self.value)

    @property
    def derivatives(self) -> int:
        """How many times displacement is differentiated to give it: 0, 1 or 2.

        Raises:
            ValueError: for what is no motion.
        """
        if self is MotionQuantity.OTHER:
            raise ValueError("it is not known how the signal follows from a displacement")
        return (MotionQuantity.DISPLACEMENT, MotionQuantity.VELOCITY, MotionQuantity.ACCELERATION).index(self)


_PREFIXES = {"": 1.0, "c": 1e-2, "m": 1e-3, "u": 1e-6, "µ": 1e-6, "μ": 1e-6, "n": 1e-9}
_SUFFIXES = {
    "m": MotionQuantity.DISPLACEMENT,
    **dict.fromkeys(("m/s", "m s^-1"), MotionQuantity.VELOCITY),
    **dict.fromkeys(("m/s²", "m/s2", "m/s^2", "m/s**2", "m s^-2"), MotionQuantity.ACCELERATION),
}
MOTION_UNITS = {
    prefix + suffix: (quantity, factor)
    for prefix, factor in _PREFIXES.items()
    for suffix, quantity in _SUFFIXES.items()
} | {
    "g": (MotionQuantity.ACCELERATION, STANDARD_GRAVITY),
    "mg": (MotionQuantity.ACCELERATION, 1e-3 * STANDARD_GRAVITY),
}
"""Quantity of each unit of a motion, and its size in SI."""


def quantity_of(unit: str) -> MotionQuantity:
    """Return what a unit measures; ``OTHER`` for what is no unit of a motion."""
    return MOTION_UNITS.get(unit, (MotionQuantity.OTHER, 1.0))[0]


def in_si(unit: str) -> float:
    """Return the size of a unit of a motion in that of SI, 1 for another."""
    return MOTION_UNITS.get(unit, (MotionQuantity.OTHER, 1.0))[1]


SECONDS = {"": 1.0, "s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9}
"""Units of time, in seconds; a heading without unit means seconds."""

_OTHERS = {*MOTION_UNITS, "N", "Pa", "V", "mV"}
_BRACKETED = re.compile(r"\[[^][]*\]|\([^()]*\)")


def is_unit(cell: str) -> bool:
    """Return whether a cell of a heading holds a unit alone, in brackets or a common one; or nothing."""
    return cell.strip() in SECONDS or cell.strip() in _OTHERS or _is_bracketed(cell)


def in_brackets(cell: str) -> str:
    """Return a unit in brackets, with those that it has or new ones; an empty cell stays empty."""
    unit = cell.strip()
    return unit if not unit or _is_bracketed(unit) else f"[{unit}]"


def _is_bracketed(cell: str) -> bool:
    return _BRACKETED.fullmatch(cell.strip()) is not None
