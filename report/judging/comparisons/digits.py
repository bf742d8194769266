"""Agreement of a computed number with printed digits."""

from __future__ import annotations

from dataclasses import dataclass, replace
from decimal import Decimal
from fractions import Fraction
from typing import Self, final

import mpmath

from report.judging.claim import Agreement
from report.judging.shown import Number

LEAST_DIGITS_SHOWN = 6
GUARD_DIGITS = 3
LARGEST_PLAIN_INTEGER = 10**6


@final
@dataclass(frozen=True)
class PrintedDigits:
    """Whether a computed number rounds to the printed digits.

    ``printed`` is the string of digits as printed, ``derived`` the number computed; the tolerance is half a
    unit of the last printed digit and nothing else.
    """

    printed: str
    derived: float | Fraction
    unit: str = ""

    def compare(self) -> Agreement:
        """Compare to half a unit in the last printed place."""
        printed = Decimal(self.printed)
        half_unit = Fraction(Decimal(1).scaleb(int(printed.as_tuple().exponent))) / 2
        difference = abs(Fraction(self.derived) - Fraction(printed))
        return Agreement(difference <= half_unit, "held against every printed digit")

    def with_derived(self, derived: float | Fraction) -> Self:
        """Hold the same printed digits against another number."""
        return replace(self, derived=derived)

    @property
    def printed_shown(self) -> Number:
        """The digits as printed, with their unit."""
        return Number(self.printed, self.unit)

    @property
    def derived_shown(self) -> Number:
        """The computed number, to more digits than were printed."""
        exact_value = Fraction(self.derived)
        if exact_value.denominator == 1 and abs(exact_value) < LARGEST_PLAIN_INTEGER:
            return Number(str(exact_value), self.unit)
        printed_digits = len(Decimal(self.printed).as_tuple().digits)
        digits = max(printed_digits + GUARD_DIGITS, LEAST_DIGITS_SHOWN)
        rounded = mpmath.mpf(exact_value.numerator) / exact_value.denominator
        return Number(mpmath.nstr(rounded, digits, strip_zeros=False, min_fixed=-4, max_fixed=7), self.unit)


@final
@dataclass(frozen=True)
class CloseNumbers:
    """Whether two computed numbers agree to a stated relative accuracy, as a confirmation asks."""

    printed: complex
    derived: complex
    relative: float = 1e-9

    def compare(self) -> Agreement:
        """Compare the difference with the larger magnitude."""
        difference = abs(complex(self.printed) - complex(self.derived))
        scale = max(abs(complex(self.printed)), abs(complex(self.derived)))
        return Agreement(
            difference <= self.relative * scale, f"relative difference at most {self.relative:g}"
        )

    def with_derived(self, derived: complex) -> Self:
        """Hold the first number against another one."""
        return replace(self, derived=derived)

    @property
    def printed_shown(self) -> Number:
        """The first number, to ten digits."""
        return Number(f"{self.printed:.10g}")

    @property
    def derived_shown(self) -> Number:
        """The second number, to ten digits."""
        return Number(f"{self.derived:.10g}")


@final
@dataclass(frozen=True)
class Equal:
    """Whether two things are exactly the same, such as two counts."""

    first: object
    second: object

    def compare(self) -> Agreement:
        """Compare the two as Python does."""
        return Agreement(self.first == self.second, "the same")


@final
@dataclass(frozen=True)
class Small:
    """Whether what has to vanish stays below a bound in size."""

    value: complex
    bound: float = 1e-9

    def compare(self) -> Agreement:
        """Compare the size with the bound."""
        return Agreement(abs(self.value) <= self.bound, f"at most {self.bound:g}")
