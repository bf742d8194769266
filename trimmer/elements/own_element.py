"""A user's own element: by its output over one period, or by an odd function of the input."""

import math
from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import final

import numpy as np
from numpy.typing import ArrayLike

from trimmer.arguments import positive_number, real_values, shown
from trimmer.arrays import Reals
from trimmer.elements.unbounded import UnboundedElement
from trimmer.errors import WrongTypeError


class OwnElement(UnboundedElement):
    """The base of an element of one's own: a subclass gives its output over one period, and a scale.

    Write ``output`` and ``amplitude_scale``, and ``breaks`` if you know where the output has kinks or jumps.
    Where N depends on frequency, set ``depends_on_frequency = True`` in the class. Harmonics are integrated,
    with an estimate of the error in ``describing_function_estimate``. There is no motion in time.
    """

    def __repr__(self) -> str:
        fields = ", ".join(f"{name}={value!r}" for name, value in vars(self).items())
        return f"{type(self).__name__}({fields})"

    @property
    @abstractmethod
    def amplitude_scale(self) -> float:
        """An amplitude of the size at which N changes, > 0, in the unit of the input.

        Limit cycles are searched from 1e-8 to 1e8 times it.
        """

    @abstractmethod
    def output(self, phase: Reals, amplitude: float, omega: float) -> ArrayLike:
        """Return the steady output for the input A sin θ.

        It has to be odd: the output at θ + π is minus that at θ.

        Args:
            phase: θ, rad, shape (n,), in any order, from 0 to 2π.
            amplitude: A, in the unit of the input.
            omega: Angular frequency, rad/s; 1 where N does not depend on it.

        Returns:
            Shape (n,); NaN where there is no steady output at this amplitude.
        """

    def breaks(self, amplitude: float, omega: float) -> Sequence[float]:
        """Return phases θ, rad, at which the output has a kink or a jump, or none.

        Those that are not named are closed in on, which takes longer; one may be missed that matters for less
        than about 1e-4 of the period.
        """
        return ()

    def _period(self, phases: Reals, amplitude: float, omega: float) -> Reals:
        output = real_values("output", self.output(np.mod(phases, 2.0 * math.pi), amplitude, omega))
        if output.shape != phases.shape:
            raise WrongTypeError(f"output must return shape {phases.shape}, not {output.shape}")
        return np.asarray(output, dtype=float)

    def _breaks(self, amplitude: float, omega: float) -> Sequence[float]:
        return self.breaks(amplitude, omega)


@final
@dataclass(frozen=True)
class StaticElement(UnboundedElement):
    """An element without memory, y = f(x) with an odd f, whose harmonics are integrated.

    Attributes:
        function: f, from inputs of shape (n,) to outputs of shape (n,); odd.
        scale: An input of the size at which f changes its shape, > 0, in the unit of the input; limit cycles
            are searched from 1e-8 to 1e8 times it.
        kinks: Inputs at which f has a kink or a jump, in the unit of the input; one of each pair ±x will do,
            and 0 too. Those that are not named are closed in on.

    Raises:
        WrongTypeError: if the function is none, or a number is none.
        ValueError: if the scale is not positive and finite.
    """

    function: Callable[[Reals], ArrayLike]
    scale: float = 1.0
    kinks: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        if not callable(self.function) or isinstance(self.function, type):
            raise WrongTypeError(f"function must be a function of the input, not {shown(self.function)}")
        positive_number("scale", self.scale, "unit of the input")
        kinks = real_values("kinks", self.kinks)
        if kinks.ndim != 1:
            raise WrongTypeError(f"kinks must be a sequence of inputs, not {shown(self.kinks)}")
        object.__setattr__(self, "kinks", tuple(kinks.tolist()))

    def __repr__(self) -> str:
        name = getattr(self.function, "__name__", type(self.function).__name__)
        return f"StaticElement({name}, scale={self.scale!r}, kinks={self.kinks!r})"

    @property
    def amplitude_scale(self) -> float:
        """The scale, in the unit of the input."""
        return self.scale

    def _mean_gain(self, amplitude: Reals) -> Reals:
        """Return the mean slope of f over a period."""
        return self._mean_slope(amplitude)

    def _period(self, phases: Reals, amplitude: float, omega: float) -> Reals:
        return self._of(amplitude * np.sin(phases))

    def _halves(self, phases: Reals, amplitude: float, omega: float) -> tuple[Reals, Reals]:
        # The sine of a phase half a period later would be rounded otherwise, beside a kink too.
        given = amplitude * np.sin(phases)
        return self._of(given), self._of(-given)

    def _of(self, given: Reals) -> Reals:
        output = real_values("function", self.function(given))
        if output.shape != given.shape:
            raise WrongTypeError(f"function must return shape {given.shape}, not {output.shape}")
        return np.asarray(output, dtype=float)

    def _breaks(self, amplitude: float, omega: float) -> Sequence[float]:
        sizes = [abs(kink) for kink in self.kinks if abs(kink) < amplitude]
        # To the last digit next to the peak too.
        rises = [math.atan2(size, math.sqrt((amplitude - size) * (amplitude + size))) for size in sizes]
        return [phase for rise in rises for phase in (rise, math.pi - rise)]
