"""The parameters with the digits that Listing A.1 prints, and how much these digits leave open."""

from __future__ import annotations

from decimal import Decimal
from types import MappingProxyType
from typing import Final

PRINTED: Final = MappingProxyType(
    {
        **{"m1": "0.035", "m2": "0.003", "m3": "0.005", "m4": "0.030"},
        **{"k1": "200e3", "k2": "30e3", "k3": "150e3", "k4": "100e3", "k5": "1e3"},
        **{"c1": "3.5", "c2": "0.4", "c3": "1.0", "c4": "4.0"},
    }
)
"""Lines 4 to 18 of Listing A.1, SI units."""


def significant_digits(printed: str) -> int:
    """Return how many digits a printed number certainly has.

    Zeros at the end of a number without a point may only hold the place, and are not counted.
    """
    mantissa = printed.split("e")[0]
    digits = mantissa.replace(".", "").lstrip("0")
    return len(digits if "." in mantissa else digits.rstrip("0"))


def left_open(printed: str) -> float:
    """Return half a unit of the last certain digit as a share of the number."""
    value = Decimal(printed)
    last = value.adjusted() - significant_digits(printed) + 1
    return float(Decimal(5).scaleb(last - 1) / value)
