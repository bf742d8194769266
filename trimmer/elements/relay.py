"""Relay: ideal, with hysteresis, with a dead zone, or with both."""

from dataclasses import dataclass
from functools import cached_property
from typing import final

from trimmer.arguments import finite_number, positive_number
from trimmer.elements.derived_element import DerivedElement
from trimmer.elements.element import Element
from trimmer.elements.square_wave import IdealRelay
from trimmer.elements.threshold_relay import ThresholdRelay


@final
@dataclass(frozen=True)
class Relay(DerivedElement):
    """Relay, y = level * sign(x); with hysteresis and dead zone it switches at x = ±dead_zone ± hysteresis.

    The rising input switches from -level to 0 at hysteresis - dead_zone, and to level at dead_zone +
    hysteresis. The falling one switches from level to 0 at dead_zone - hysteresis, and to -level at
    -(dead_zone + hysteresis). Without dead zone the output changes between -level and level at once.

    N_n = 4 level / (π n A) for odd n if both are zero, at any amplitude. Else the amplitude has to exceed
    dead_zone + hysteresis. Up to that the output is zero, and N too, if hysteresis <= dead_zone; with more
    hysteresis the output stays at what it was, and N is NaN.

    Source: Gelb and Vander Velde, Multiple-Input Describing Functions (1968), section 2.3 and appendix B;
    Atherton, Nonlinear Control Engineering (1975), chapter 3; thesis, section 2.3.5, for the ideal one.

    Attributes:
        level: Output while the input is large, > 0, in the unit of the output.
        hysteresis: Half the width of each loop, >= 0, in the unit of the input.
        dead_zone: Half the width of the band without output, to the middle of the loops, >= 0, in the unit of
            the input.

    Raises:
        ValueError: if the level is not positive and finite, or another is negative or not finite;
            ``-Relay(level)`` has the other sign.
    """

    level: float
    hysteresis: float = 0.0
    dead_zone: float = 0.0

    def __post_init__(self) -> None:
        positive_number("level", self.level, "unit of the output")
        for name in ("hysteresis", "dead_zone"):
            if finite_number(name, getattr(self, name), "unit of the input") < 0:
                raise ValueError(
                    f"{name} must not be negative (unit of the input), not {getattr(self, name)!r}"
                )

    @property
    def thresholds(self) -> ThresholdRelay | None:
        """The inputs at which it switches; None for the ideal relay."""
        if self.hysteresis == 0 == self.dead_zone:
            return None
        return ThresholdRelay(self.level, self.dead_zone, self.hysteresis)

    @cached_property
    def _source(self) -> Element:
        return self.thresholds or IdealRelay(self.level)
