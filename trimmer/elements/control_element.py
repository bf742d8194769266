"""The nonlinearities of python-control as elements."""

import copy
import math
import sys
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, final

import numpy as np

from trimmer.arguments import require_instance
from trimmer.arrays import Complexes, Reals
from trimmer.elements.element import Element
from trimmer.elements.quadrature import QuadratureEstimate
from trimmer.elements.unbounded import EVEN, UnboundedElement
from trimmer.errors import UnsupportedElementError

SETTLING = 2  # Periods that a nonlinearity with memory runs through before its output counts
_DECADES = 12  # How far on either side of 1 amplitudes are probed
_PROBES = 400
_MEMORY_DECADES = 6
_MEMORY_PROBES = 24
_PHASES = 61
_SEED = 4171
_OMEGA = 1.0  # Stands where an omega is wanted, rad/s; a nonlinearity knows none
_DIFFERENT = 0.01
"""Difference between a nonlinearity's own describing function and its output's, relative, that is told."""


@final
@dataclass(frozen=True, eq=False)
class ControlElement(UnboundedElement):
    """An element made of a copy of a ``control.DescribingFunctionNonlinearity``.

    N is its own ``describing_function`` if it has one, else it is integrated from its output, as the higher
    harmonics are. A nonlinearity with memory runs through two periods before its output counts. No bounds are
    known, so that harmonic balance is never complete with it.

    Attributes:
        nonlinearity: The copy.

    Raises:
        WrongTypeError: if it is no such object.
        UnsupportedElementError: if it is not odd, at inputs that are drawn at random over 24 decades.
    """

    nonlinearity: Any = field()

    def __post_init__(self) -> None:
        kind = _kind()
        wanted = "a control.DescribingFunctionNonlinearity"
        require_instance("nonlinearity", self.nonlinearity, kind or type(None), wanted)
        object.__setattr__(self, "nonlinearity", copy.deepcopy(self.nonlinearity))
        self._require_odd()

    def __repr__(self) -> str:
        fields = ", ".join(f"{name}={value!r}" for name, value in vars(self.nonlinearity).items())
        return f"ControlElement({type(self.nonlinearity).__name__}: {fields})"

    @cached_property
    def amplitude_scale(self) -> float:
        """The probed amplitude at which |N| bends most over the amplitude, on logarithmic scales; else 1."""
        amplitudes = np.geomspace(10.0**-_DECADES, 10.0**_DECADES, 8 * 2 * _DECADES + 1)
        with np.errstate(all="ignore"):
            sizes = np.log(np.abs(self._describing_function(amplitudes, np.ones_like(amplitudes), 1)))
            bend = np.abs(np.diff(sizes, 2))
        bend[~np.isfinite(bend)] = 0.0
        return float(amplitudes[1 + int(np.argmax(bend))]) if bend.max() > 1e-6 else 1.0

    def _mean_gain(self, amplitude: Reals) -> Reals | float:
        """Return the gain for the mean of the input; NaN for an element with memory."""
        return self._mean_slope(amplitude) if self.nonlinearity._isstatic() else super()._mean_gain(amplitude)

    def doubts_at(self, amplitude: float) -> tuple[str, ...]:
        """Hold the nonlinearity's own describing function against its output at an amplitude.

        Raises:
            UnsupportedElementError: if the output is not odd there.
        """
        own, estimate = self._own(amplitude), self._estimate(amplitude, _OMEGA, 1)
        if own is None or abs(own - estimate.value) <= _DIFFERENT * abs(own) + estimate.error:
            return ()
        return (
            f"the formula of {self!r} is not that of its output at the amplitude {amplitude:.6g}, "
            f"{own:.6g} in place of {estimate.value:.6g}",
        )

    def _describing_function(self, amplitude: Reals, omega: Reals, harmonic: int) -> Complexes:
        if harmonic == 1:
            own = [self._own(float(each)) for each in amplitude]
            if None not in own:
                return np.array(own, dtype=complex)
        return super()._describing_function(amplitude, omega, harmonic)

    def _own(self, amplitude: float) -> complex | None:
        """Return N by the nonlinearity's own formula; None if it has none."""
        if math.isinf(amplitude):
            return complex(math.nan, math.nan)
        try:
            return complex(copy.deepcopy(self.nonlinearity).describing_function(amplitude))
        except NotImplementedError:
            return None
        except (ValueError, ArithmeticError):
            # Below a threshold some answer with an error of mathematics.
            return complex(math.nan, math.nan)

    def _period(self, phases: Reals, amplitude: float, omega: float) -> Reals:
        turned = np.mod(phases, 2.0 * math.pi)
        function = copy.deepcopy(self.nonlinearity)
        if function._isstatic():
            return _values(function, amplitude * np.sin(turned))
        # With memory what counts is the way: in order, through both peaks.
        order = np.argsort(turned, kind="stable")
        way = np.concatenate([turned[order], 0.5 * math.pi * np.array([1.0, 3.0])])
        along = np.argsort(way, kind="stable")
        given = amplitude * np.sin(way[along])
        for _ in range(SETTLING):
            _values(function, given)
        outputs = np.empty(way.size)
        outputs[along] = _values(function, given)
        result = np.empty(phases.size)
        result[order] = outputs[: phases.size]
        return result

    def _halves(self, phases: Reals, amplitude: float, omega: float) -> tuple[Reals, Reals]:
        if not self.nonlinearity._isstatic():
            return super()._halves(phases, amplitude, omega)
        function, given = copy.deepcopy(self.nonlinearity), amplitude * np.sin(phases)
        return _values(function, given), _values(function, -given)

    def _require_odd(self) -> None:
        """Compare outputs at inputs of opposite signs, at places that no grid has."""
        random = np.random.default_rng(_SEED)
        if self.nonlinearity._isstatic():
            inputs = _drawn(random, _DECADES, _PROBES)
            function = copy.deepcopy(self.nonlinearity)
            up, down = _values(function, inputs), _values(function, -inputs)
            where = inputs[np.abs(up + down) > EVEN * np.abs(up)].tolist()
        else:
            amplitudes = _drawn(random, _MEMORY_DECADES, _MEMORY_PROBES).tolist()
            where = [each for each in amplitudes if self._is_even_at(each, random)]
        if where:
            place = where[0]
            raise UnsupportedElementError(
                f"{self!r} is not odd, at the input {place:.6g} for one; only elements whose output changes "
                "its sign with the input are taken, as the mean of the others does not vanish"
            )

    def _is_even_at(self, amplitude: float, random: np.random.Generator) -> bool:
        phases = np.sort(math.pi * random.random(_PHASES))
        first, second = self._halves(phases, amplitude, _OMEGA)
        # Where nothing switches an output may stay what it was; there N does not exist.
        own = self._own(amplitude)
        exists = own is None or not np.isnan(own)
        return bool(exists and np.abs(first + second).max() > EVEN * np.abs(first).max())

    def _estimate(self, amplitude: float, omega: float, harmonic: int) -> QuadratureEstimate:
        own = self._own(amplitude)
        if own is not None and np.isnan(own):
            return QuadratureEstimate(own, math.nan, math.nan)
        return super()._estimate(amplitude, omega, harmonic)


def is_element(value: object) -> bool:
    """Return whether a value is an element, or a nonlinearity of python-control."""
    kind = _kind()
    return isinstance(value, Element) or (kind is not None and isinstance(value, kind))


def adopted(name: str, element: object) -> Element:
    """Return an element as it is, and a nonlinearity of python-control, if it is odd, as one."""
    if is_element(element) and not isinstance(element, Element):
        return ControlElement(element)
    wanted = "an element, such as FrictionBacklash(4e-5)"
    if isinstance(element, list | tuple | dict):
        wanted += "; several elements go into trimmer.Feedback(plant, {name: element})"
    require_instance(name, element, Element, wanted)
    assert isinstance(element, Element)
    return element


def _kind() -> type[Any] | None:
    """Return the class of python-control; None where that was not imported, so none can be given."""
    return getattr(sys.modules.get("control"), "DescribingFunctionNonlinearity", None)


def _drawn(random: np.random.Generator, decades: int, count: int) -> Reals:
    """Draw numbers over some decades on either side of 1, evenly on a logarithmic scale."""
    return np.asarray(10.0 ** random.uniform(-decades, decades, count))


def _values(function: Any, inputs: Reals) -> Reals:
    return np.array([float(np.squeeze(function(x))) for x in inputs.tolist()])
