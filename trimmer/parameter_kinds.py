"""What a parameter of the linear trimmer measures, and which numbers can be one."""

import math
from dataclasses import dataclass
from enum import Enum
from typing import final

from trimmer.sizes import reason_against_size


class ParameterKind(Enum):
    """What a parameter measures; the value is its SI unit."""

    MASS = "kg"
    STIFFNESS = "N/m"
    DAMPING = "N s/m"

    @property
    def unit(self) -> str:
        """SI unit as plain text, such as ``N/m``."""
        return self.value


@final
@dataclass(frozen=True)
class Parameter:
    """A field of ``TrimmerParameters``, such as ``m1``, what it is, and what it measures."""

    symbol: str
    meaning: str
    quantity: ParameterKind

    @property
    def unit(self) -> str:
        """SI unit of the parameter as plain text, such as ``N/m``."""
        return self.quantity.unit


def reason_against(value: object, quantity: ParameterKind) -> str:
    """Return why a value cannot be used as such a quantity, as a piece of a message; empty if it can.

    NumPy's real scalars count as numbers; truth values, text and complex numbers do not.
    """
    if isinstance(value, bool) or not hasattr(value, "__float__") or isinstance(value, complex):
        return f"give a number in {quantity.unit}"
    try:
        number = float(value)
    except OverflowError:
        return "too large for a floating-point number"
    except (TypeError, ValueError):
        return f"give a number in {quantity.unit}"
    if not math.isfinite(number):
        return "must be finite"
    if reason := reason_against_size(number):
        return reason
    if quantity is ParameterKind.MASS and number <= 0:
        return "a mass must be greater than zero"
    if number < 0:
        return f"{quantity.name.lower()} must not be negative"
    return ""
