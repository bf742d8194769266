"""Limit cycles of a linear system in a negative feedback loop with a nonlinear element."""

import math
import warnings
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from control.lti import LTI

from trimmer.arguments import positive_number, real_values
from trimmer.balance.bounded import solve_bounded
from trimmer.balance.cells import Cells
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.limit_cycle import (
    Certificate,
    HarmonicBalance,
    LimitCycle,
    UndecidedRegion,
    doubts_of_search,
)
from trimmer.balance.loop import LoopEquation, inverse_response, loop_equation
from trimmer.balance.loop_first import takes_a_loop_or_data, takes_what_is_balanced
from trimmer.balance.many_harmonics.feedback import ORDER, FeedbackBalance, feedback_balance
from trimmer.balance.of_data import balance_of_data
from trimmer.balance.proportional import solve_proportional
from trimmer.balance.rational import turning_range
from trimmer.balance.sampled import solve_sampled, unproven
from trimmer.balance.search import SearchedRegion
from trimmer.balance.stability import limit_cycles_at
from trimmer.balance.winding_number import winding_number
from trimmer.elements.element import Element
from trimmer.errors import FrequencyRangeError, UndecidedWarning
from trimmer.loops import ClosedLoop, Feedback
from trimmer.loops.measured_loop import MeasuredLoop

CALLER = 3  # Level of the stack on which a warning of a function that takes a loop names its caller's line


@takes_a_loop_or_data
def limit_cycles(
    loop: ClosedLoop | MeasuredLoop,
    omega_range: tuple[float, float] | None = None,
    frozen_omega: float | None = None,
) -> tuple[LimitCycle, ...]:
    """Find all limit cycles that harmonic balance predicts.

    Arguments and errors are those of ``harmonic_balance``.

    Returns:
        In order of frequency, then of amplitude; empty if there are none.

    Warns:
        UndecidedWarning: if a part of the range is undecided, because the curves touch or coincide there; if
            solutions with a small |N| are not excluded; or if nothing excludes limit cycles beyond a range
            that was not given. The winding number, which takes as long as the search, is not computed; see
            ``harmonic_balance`` for that.
    """
    if isinstance(loop, MeasuredLoop):
        balance = _of_data(loop, omega_range, frozen_omega)
        for doubt in balance.certificate.doubts:
            warnings.warn(doubt, UndecidedWarning, stacklevel=CALLER)
        return balance.limit_cycles
    equation, outcome = _solve(loop, omega_range, frozen_omega)
    undecided = undecided_regions(outcome.result.undecided, equation.curve)
    doubts = [*_unproven(equation, outcome), *doubts_of_search(undecided, outcome.smallest_gain)]
    if omega_range is None and not outcome.outside_excluded:
        doubts.append(f"limit cycles outside {outcome.omegas} rad/s are not excluded; give omega_range")
    for doubt in doubts:
        warnings.warn(doubt, UndecidedWarning, stacklevel=CALLER)
    return limit_cycles_at(equation, outcome.result.u, outcome.result.x)


@takes_what_is_balanced
def harmonic_balance(
    loop: ClosedLoop | MeasuredLoop | Feedback,
    omega_range: tuple[float, float] | None = None,
    frozen_omega: float | None = None,
    *,
    order: int | None = None,
) -> HarmonicBalance | FeedbackBalance:
    """Solve 1 + N(A, omega) G(j omega) = 0 for all amplitudes and frequencies (equation 2.25 of the thesis).

    What is linear in the element, as viscous friction, is moved to 1/G
    (``trimmer.balance.linear_part``). The plane of u = amplitude_scale/A and ln omega is then covered with
    boxes. A box is excluded where bounds of N and 1/G over it prove that there is no solution, or accepted
    where bounds of their slopes prove that there is at most one, which Newton's method then finds
    (``trimmer.balance.search``). So no solution is missed and none is found twice, in exact arithmetic;
    rounding of the bounds is not accounted for, but what rounding of coefficients, poles and zeros changes
    in G is (``trimmer.balance.factoring_error``). Where N is proportional to 1/A the amplitude is eliminated
    first (``trimmer.balance.proportional``). A winding number, computed apart from all this and in a range
    of its own, checks the result (``trimmer.balance.winding_number``).

    Without a range all frequencies are covered, up to 55 decades on either side of the roots of G. There are
    four limits to what is proven, and the certificate tells each. First, regions are undecided where the
    curves of N and -1/G touch or coincide: at a tangency, with a relay where G is real on a stretch of the
    axis, and with backlash at zero frequency and infinite amplitude if G(0) = -1. Second, where G
    has a pole on the imaginary axis and N vanishes at the edge of a dead band, their limits decide
    (``trimmer.balance.vanishing``); where they do not, ``smallest_gain`` is not 0. Third, the winding number
    may differ from the sum of the indices: then the search has failed. Fourth, with N proportional to 1/A,
    limit cycles beyond a million times the outermost roots are not excluded if -1/G and
    N get parallel there faster than linearly, as without damping; give the range that matters then. Where
    the system does not tell its poles and zeros, as by the coefficients of a high order, that is a doubt.

    An element without bounds, as one of python-control's or a user's own, or a relay beside what saturates,
    is searched on a grid (``trimmer.balance.sampled``), and the certificate says that nothing is proven then.
    So it is with a plant that is known at some frequencies alone: limit cycles are predicted between these,
    each with a bound of what the interpolation leaves open (``bounds``), and never beyond them.

    Of a ``Feedback`` of several elements, or with frictions, the odd harmonics up to an order are balanced by
    Newton's method from starts on a grid (``trimmer.balance.many_harmonics``); there is no certificate, the
    result is a ``FeedbackBalance``.

    Args:
        loop: The closed loop; or ``system, element`` in its place. The system is rational, proper, continuous
            in time, with one input and one output; it may be unstable. A delay must be approximated, as by
            ``control.pade``. It may also be a system of SciPy, a tuple (num, den), (z, p, k) or
            (A, B, C, D), or frequency-response data: a ``control.FrequencyResponseData`` or a
            ``trimmer.linear.MeasuredResponse`` of arrays.
        omega_range: Lowest and highest angular frequency, rad/s, to search; all if not given.
        frozen_omega: Angular frequency, rad/s, at which N is evaluated whatever the frequency of the loop; as
            the thesis does with an N that depends on frequency.
        order: Highest harmonic, odd, with several elements; 15 if not given.

    Raises:
        WrongTypeError: if neither a closed loop nor a system and an element are given.
        UnsupportedSystemError: if G is not such a system, has a coefficient that is infinite or NaN, or has
            no dynamics; or if viscous friction cancels its highest derivative.
        FrequencyRangeError: if the range is not 0 < lowest < highest < inf, or goes beyond data.
        LinearElementError: if N does not depend on the amplitude.
        UnsupportedElementError: if the element is none; or, of a kind defined elsewhere, has an N that is
            unbounded yet not proportional to 1/A.
        ValueError: if ``frozen_omega`` is not positive and finite, the order not odd and positive, or one of
            them does not go with the loop.
    """
    if isinstance(loop, Feedback):
        return _of_several(loop, omega_range, frozen_omega, order)
    if order is not None:
        raise ValueError(
            f"order {order!r} is for several elements; multi_harmonic_balance takes orders of one"
        )
    if isinstance(loop, MeasuredLoop):
        return _of_data(loop, omega_range, frozen_omega)
    equation, outcome = _solve(loop, omega_range, frozen_omega)
    element = loop.element if frozen_omega is None else loop.element.at(frozen_omega)
    cycles = limit_cycles_at(equation, outcome.result.u, outcome.result.x)
    check = _check(loop.system, equation, outcome, omega_range is None)
    certificate = Certificate(
        method=outcome.method,
        omegas=outcome.omegas,
        outside_excluded=outcome.outside_excluded,
        boxes=outcome.result.examined,
        undecided=undecided_regions(outcome.result.undecided, equation.curve),
        smallest_gain=outcome.smallest_gain,
        winding_number=check.turns,
        index_sum=sum(cycle.index for cycle in cycles),
        zero_on_axis=_has_zero_on_axis(equation.response, check.omegas or outcome.omegas),
        unproven=(*_unproven(equation, outcome), *check.unproven),
        winding_omegas=check.omegas,
    )
    return HarmonicBalance(cycles, certificate, ClosedLoop(loop.system, element))


def _of_several(
    loop: Feedback, omega_range: tuple[float, float] | None, frozen_omega: float | None, order: int | None
) -> FeedbackBalance:
    if frozen_omega is not None:
        raise ValueError("frozen_omega is for one element; leave it out with several")
    given = None if omega_range is None else checked_range(omega_range)
    return feedback_balance(loop, given, ORDER if order is None else order)


def _of_data(
    loop: MeasuredLoop, omega_range: tuple[float, float] | None, frozen_omega: float | None
) -> HarmonicBalance:
    given = None if omega_range is None else checked_range(omega_range)
    return balance_of_data(replace(loop, element=_frozen(loop.element, frozen_omega)), given)


def _frozen(element: Element, frozen_omega: float | None) -> Element:
    """Return an element, at one frequency if that is given, rad/s."""
    return (
        element
        if frozen_omega is None
        else element.at(positive_number("frozen_omega", frozen_omega, "rad/s"))
    )


class _Check(NamedTuple):
    """The winding number, the range of omega, rad/s, in which it counts, and what that leaves unproven."""

    turns: int | None
    omegas: tuple[float, float] | None
    unproven: tuple[str, ...] = ()


def _check(system: LTI, equation: LoopEquation, outcome: SearchedRegion, is_everywhere: bool) -> _Check:
    """Count the solutions, in a range that does not come from the search if none was given."""
    if not equation.curve.element.has_bounds:
        return _Check(None, None)
    if not is_everywhere:
        return _Check(winding_number(equation, outcome.omegas), outcome.omegas)
    curve = equation.curve
    if math.isinf(curve.edge(np.zeros(1)).item()):
        coefficient = complex(curve.value(np.ones(1), np.zeros(1))[0])
        own = turning_range(system, inverse_response(system), equation.linear, coefficient)
        if own is not None:
            return _Check(winding_number(equation, own), own)
        doubt = (
            "rounding of the coefficients of G decides whether there are limit cycles beyond "
            "{:.6g} to {:.6g} rad/s, so some may be missing from the list; give omega_range"
        ).format(*outcome.omegas)
        unproven = (doubt,) if outcome.outside_excluded else ()
        return _Check(winding_number(equation, outcome.omegas), outcome.omegas, unproven)
    own = turning_range(system, inverse_response(system), equation.linear, None) or outcome.omegas
    wide = min(own[0], outcome.omegas[0]), max(own[1], outcome.omegas[1])
    turns = winding_number(equation, wide)
    if turns is None:
        return _Check(winding_number(equation, outcome.omegas), outcome.omegas)
    return _Check(turns, wide)


def _unproven(equation: LoopEquation, outcome: SearchedRegion) -> tuple[str, ...]:
    return (*unproven(equation.curve, outcome), *equation.unproven)


def _has_zero_on_axis(response: InverseResponse, omegas: tuple[float, float]) -> bool:
    places = response.zeros[response.zeros.real == 0].imag * response.reference
    return bool(np.any((places >= omegas[0]) & (places <= omegas[1])))


def _solve(
    loop: ClosedLoop, omega_range: tuple[float, float] | None, frozen_omega: float | None
) -> tuple[LoopEquation, SearchedRegion]:
    given = None if omega_range is None else checked_range(omega_range)
    equation = loop_equation(loop.system, _frozen(loop.element, frozen_omega))
    if not equation.curve.element.has_bounds:
        return equation, solve_sampled(equation.response, equation.curve, given)
    unbounded = math.isinf(equation.curve.edge(np.zeros(1)).item())
    solve = solve_proportional if unbounded else solve_bounded
    return equation, solve(equation.response, equation.curve, given)


def checked_range(omega_range: tuple[float, float]) -> tuple[float, float]:
    """Return a range of angular frequencies, rad/s, if it is 0 < lowest < highest < inf."""
    limits = real_values("omega_range", omega_range)
    lowest, highest = limits.tolist() if limits.shape == (2,) else (math.nan, math.nan)
    if not 0 < lowest < highest < math.inf:
        raise FrequencyRangeError(
            "omega_range must be (lowest, highest) with 0 < lowest < highest < inf, rad/s, "
            f"not {omega_range!r}"
        )
    return float(lowest), float(highest)


_AT_EDGE = 1.0 - 1e-9  # u over its largest value from which on N has lost most of its digits

_TOUCHING = 1e-9  # Gap in x below which two boxes belong together


def undecided_regions(cells: Cells, curve: ElementCurve) -> tuple[UndecidedRegion, ...]:
    """Join boxes whose ranges of x touch, and give the range of amplitude and frequency of each group."""
    if len(cells) == 0:
        return ()
    order = np.argsort(cells.x_lower)
    reached = np.maximum.accumulate(cells.x_upper[order])
    starts = np.flatnonzero(cells.x_lower[order][1:] > reached[:-1] + _TOUCHING) + 1
    regions = []
    for group in np.split(order, starts):
        members = cells[group]
        largest, smallest = members.u_upper.max(), members.u_lower.min()
        amplitudes = (float(curve.amplitude(largest)), _amplitude_of_lowest(curve, float(smallest)))
        omegas = (float(np.exp(members.x_lower.min())), float(np.exp(members.x_upper.max())))
        edge = np.minimum(curve.edge(members.x_lower), curve.edge(members.x_upper))
        at_edge = bool((members.u_upper >= _AT_EDGE * edge).any())
        if at_edge and _goes_on(curve):
            # There N is the same at all smaller amplitudes.
            amplitudes, at_edge = (0.0, amplitudes[1]), False
        regions.append(UndecidedRegion(amplitudes, omegas, at_edge))
    return tuple(regions)


def _goes_on(curve: ElementCurve) -> bool:
    """Return whether N exists beyond the edge and is not zero there, as that of a saturation."""
    edge = curve.element.constant_from
    if curve.depends_on_x or math.isinf(edge):
        return False
    beyond = complex(curve.value(np.full(1, 2.0 * edge), np.zeros(1))[0])
    return beyond != 0 and math.isfinite(abs(beyond))


def _amplitude_of_lowest(curve: ElementCurve, u: float) -> float:
    return float(curve.amplitude(np.asarray(u))) if u > 0 else float("inf")
