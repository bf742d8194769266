"""The loop as the first argument of a function, or a system and an element in its place."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from inspect import signature
from typing import TYPE_CHECKING, Any, Concatenate, ParamSpec, Protocol, TypeAlias, TypeVar, cast, overload

import control

from trimmer.balance.loop import require_element
from trimmer.elements.control_element import is_element
from trimmer.errors import WrongTypeError
from trimmer.linear.frequency_response import require_siso
from trimmer.linear.measured_response import MeasuredResponse
from trimmer.linear.plant_forms import adopted_system
from trimmer.loops import Feedback, TrimmerLoop
from trimmer.loops.loops import ClosedLoop, Loop
from trimmer.loops.measured_loop import MeasuredLoop

if TYPE_CHECKING:
    import scipy.signal

    from trimmer.balance.limit_cycle import HarmonicBalance
    from trimmer.elements.element import Element

    Plant: TypeAlias = control.LTI | scipy.signal.lti | tuple[Any, ...] | MeasuredResponse
    Range: TypeAlias = tuple[float, float] | None
    Rest = ParamSpec("Rest")
    Result = TypeVar("Result", covariant=True)

    class OfLoop(Protocol[Rest, Result]):
        """A function of a loop: ``f(loop, ...)`` or ``f(system, element, ...)``."""

        __name__: str
        __qualname__: str

        @overload
        def __call__(
            self, loop: ClosedLoop | Feedback | TrimmerLoop, *rest: Rest.args, **named: Rest.kwargs
        ) -> Result: ...
        @overload
        def __call__(
            self, system: Plant, element: Element, *rest: Rest.args, **named: Rest.kwargs
        ) -> Result: ...

    class OfBalanced(Protocol):
        """``harmonic_balance``: what it gives depends on whether the loop has one element."""

        __name__: str
        __qualname__: str

        @overload
        def __call__(
            self, loop: ClosedLoop | TrimmerLoop, omega_range: Range = None, frozen_omega: float | None = None
        ) -> HarmonicBalance: ...
        @overload
        def __call__(
            self,
            loop: Feedback,
            omega_range: Range = None,
            frozen_omega: float | None = None,
            *,
            order: int | None = None,
        ) -> Any: ...
        @overload
        def __call__(
            self,
            system: Plant,
            element: Element,
            omega_range: Range = None,
            frozen_omega: float | None = None,
        ) -> HarmonicBalance: ...


def takes_a_loop(function: Callable[Concatenate[ClosedLoop, Rest], Result]) -> OfLoop[Rest, Result]:
    """Let a function of a closed loop also take a system and an element in its place.

    A ``TrimmerLoop`` without drive and frictions is a closed loop too, and so is a ``Feedback`` of one
    element without a drive. What is none of these is refused by a ``WrongTypeError``,
    ``UnsupportedSystemError`` or ``UnsupportedElementError``.
    """
    return _taking(function, _closed)


def takes_a_loop_or_data(
    function: Callable[Concatenate[ClosedLoop | MeasuredLoop, Rest], Result],
) -> OfLoop[Rest, Result]:
    """Let a function do as ``takes_a_loop`` does, and also take frequency-response data as the system."""
    return _taking(function, _closed, of_data=True)


def takes_what_is_balanced(function: Callable[..., Any]) -> OfBalanced:
    """Let a function do as ``takes_a_loop_or_data``, and also take a ``Feedback`` of several elements."""
    taking: Any = _taking(function, _closed_or_several, of_data=True)
    return cast("OfBalanced", taking)


def takes_any_loop(
    function: Callable[Concatenate[ClosedLoop | Feedback, Rest], Result],
) -> OfLoop[Rest, Result]:
    """Let a function do as ``takes_a_loop`` does, and also take a ``Feedback`` without a drive."""
    return _taking(function, _closed_or_feedback)


def _taking(
    function: Callable[Concatenate[Any, Rest], Result], closed: Callable[[Loop], Loop], of_data: bool = False
) -> OfLoop[Rest, Result]:
    @wraps(function)
    def of_either(*given: Any, **named: Any) -> Result:
        loop, rest = _loop_and_rest(function.__name__, given, named, closed, of_data)
        return function(loop, *rest, **named)

    # What help() shows is the form with the loop, not the names of system and element.
    of_either.__signature__ = signature(function)  # type: ignore[attr-defined]
    return of_either


def _loop_and_rest(
    name: str, given: tuple[Any, ...], named: dict[str, Any], closed: Callable[[Loop], Loop], of_data: bool
) -> tuple[Loop | MeasuredLoop, tuple[Any, ...]]:
    """Return the loop that was given in either form, and the arguments after it; take it out of ``named``."""
    if not given and not ("loop" in named or "system" in named):
        raise WrongTypeError(f"{_wanted(name)}: neither is given")
    if not given:
        given = (named.pop("loop") if "loop" in named else named.pop("system"),)
    first, *rest = given
    if isinstance(first, Loop):
        if {"system", "element"} & named.keys() or (rest and is_element(rest[0])):
            raise WrongTypeError(f"{_wanted(name)}: a loop holds its system and its element already")
        return closed(first), tuple(rest)
    if not rest and "element" not in named:
        raise WrongTypeError(f"{_wanted(name)}: {type(first).__name__} is given without an element")
    element = rest.pop(0) if rest else named.pop("element")
    adopted = require_element(element)
    first = adopted_system(first)
    if of_data and isinstance(first, control.FrequencyResponseData | MeasuredResponse):
        data = first if isinstance(first, MeasuredResponse) else MeasuredResponse.of(first)
        return MeasuredLoop(data, adopted), tuple(rest)
    require_siso(first)
    return ClosedLoop(first, adopted), tuple(rest)


def _wanted(name: str) -> str:
    return f"{name} needs a loop, as ClosedLoop(system, element), or a system and an element"


def _closed(loop: Loop) -> ClosedLoop:
    """Return a loop as a closed one: without a drive, without frictions between bodies, with an element."""
    if isinstance(loop, ClosedLoop):
        require_siso(loop.system)
        return loop
    reason = "it has a drive, so that forced_orbit finds its periodic motion"
    if isinstance(loop, TrimmerLoop) and loop.drive is None:
        if loop.element is not None and not loop.frictions:
            return ClosedLoop(loop.model, loop.element)
        reason = "it has frictions between bodies" if loop.frictions else "it has no element"
    if isinstance(loop, Feedback):
        one = loop.as_closed_loop()
        if one is not None:
            return one
        if not loop.drives:
            reason = (
                "it has several elements or frictions; harmonic_balance, periodic_orbits and respond find "
                "its motions"
            )
    kind = type(loop).__name__
    raise WrongTypeError(f"loop must be a closed one of a system and an element, not this {kind}: {reason}")


def _closed_or_feedback(loop: Loop) -> Loop:
    if isinstance(loop, Feedback) and loop.drives:
        raise WrongTypeError("loop must not have a drive: forced_orbit finds its periodic motion")
    return loop if isinstance(loop, Feedback) else _closed(loop)


def _closed_or_several(loop: Loop) -> Loop:
    several = isinstance(loop, Feedback) and not loop.drives and loop.as_closed_loop() is None
    return loop if several else _closed(loop)
