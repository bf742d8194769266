"""Limit cycles of a linear system in a negative feedback loop with a nonlinear element."""

from __future__ import annotations

import math
import warnings
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.bounded import solve_bounded
from trimmer.balance.cycles import limit_cycles_at
from trimmer.balance.element_curve import ElementCurve
from trimmer.balance.errors import FrequencyRangeError, UndecidedWarning
from trimmer.balance.inverse_response import InverseResponse
from trimmer.balance.limit_cycle import Certificate, HarmonicBalance, LimitCycle
from trimmer.balance.proportional import solve_proportional
from trimmer.balance.regions import undecided_regions
from trimmer.frequency_domain import UnsupportedSystemError
from trimmer.zero_pole_gain import ZeroPoleGain

if TYPE_CHECKING:
    import control

    from trimmer.elements.element import Element


def limit_cycles(
    G: control.lti.LTI,
    element: Element,
    omega_range: tuple[float, float] | None = None,
    frozen_omega: float | None = None,
) -> list[LimitCycle]:
    """Find all limit cycles that harmonic balance predicts.

    Arguments and errors are those of ``harmonic_balance``.

    Returns:
        In order of frequency; empty if there are none.

    Warns:
        UndecidedWarning: if a part of the range is undecided, because the curves touch or coincide there.
    """
    balance = harmonic_balance(G, element, omega_range, frozen_omega)
    for region in balance.certificate.undecided:
        warnings.warn(
            f"undecided between {region.omegas[0]:.9g} and {region.omegas[1]:.9g} rad/s: the curves of N and "
            "-1/G touch or coincide there, and limit cycles in that range may be missing from the list",
            UndecidedWarning,
            stacklevel=2,
        )
    return list(balance.limit_cycles)


def harmonic_balance(
    G: control.lti.LTI,
    element: Element,
    omega_range: tuple[float, float] | None = None,
    frozen_omega: float | None = None,
) -> HarmonicBalance:
    """Solve 1 + N(A, omega) G(j omega) = 0 for all amplitudes and frequencies (equation 2.25 of the thesis).

    The plane of u = amplitude_scale/A and ln omega is covered with boxes. A box is excluded where bounds of
    N and 1/G over it prove that there is no solution, or accepted where bounds of their slopes prove that
    there is at most one, which Newton's method then finds (``trimmer.balance.search``). So no solution in
    the range is missed and none is found twice, in exact arithmetic; rounding of the bounds is not
    accounted for. Where N is proportional to 1/A the amplitude is eliminated first
    (``trimmer.balance.proportional``).

    Not looked for are limit cycles with |N| below a millionth of its maximum: amplitudes within about that of
    the edge of a dead band.

    Args:
        G: A rational, proper, continuous-time system with one input and one output; it may be unstable.
        element: The nonlinear element, in negative feedback.
        omega_range: Lowest and highest angular frequency, rad/s. If not given, a range outside of which
            there is no solution is derived.
        frozen_omega: Angular frequency, rad/s, at which N is evaluated whatever the frequency of the loop; as
            the thesis does with an N that depends on frequency.

    Raises:
        UnsupportedSystemError: if G is not such a system, or has no dynamics.
        FrequencyRangeError: if the range is not 0 < lowest < highest < inf; or if it is needed, because |G|
            does not fall below 1/max|N|.
        LinearElementError: if N does not depend on the amplitude.
        UnsupportedElementError: if N is unbounded, yet not proportional to 1/A, as of a relay and viscous
            friction together.
        ValueError: if ``frozen_omega`` is not positive and finite.
    """
    response = inverse_response(G)
    if frozen_omega is not None:
        _require_positive(frozen_omega)
        element = element.at(frozen_omega)
    curve = ElementCurve(element)
    given = None if omega_range is None else _checked_range(omega_range)
    unbounded = bool(np.isinf(curve.edge(np.zeros(1)))[0])
    outcome = (solve_proportional if unbounded else solve_bounded)(response, curve, given)
    cycles = limit_cycles_at(response, curve, outcome.result.u, outcome.result.x)
    certificate = Certificate(
        method=outcome.method,
        omegas=outcome.omegas,
        outside_excluded=outcome.outside_excluded,
        boxes=outcome.result.examined,
        undecided=undecided_regions(outcome.result.undecided, curve),
    )
    return HarmonicBalance(cycles, certificate)


def inverse_response(G: control.lti.LTI) -> InverseResponse:
    """Take 1/G from a proper system that has dynamics.

    Raises:
        UnsupportedSystemError: if it is not one that ``harmonic_balance`` accepts.
    """
    factored = ZeroPoleGain.of(G)
    if factored.relative_degree < 0:
        raise UnsupportedSystemError("the system has more zeros than poles: give a proper one")
    if not factored.poles:
        raise UnsupportedSystemError(
            "the system is a constant gain: nothing sets the frequency of a limit cycle"
        )
    return InverseResponse.of(factored)


def _checked_range(omega_range: tuple[float, float]) -> tuple[float, float]:
    lowest, highest = omega_range
    if not 0 < lowest < highest < math.inf:
        raise FrequencyRangeError(
            "omega_range must be (lowest, highest) with 0 < lowest < highest < inf, rad/s, "
            f"not {omega_range!r}"
        )
    return float(lowest), float(highest)


def _require_positive(frozen_omega: float) -> None:
    if not 0 < frozen_omega < math.inf:
        raise ValueError(f"frozen_omega must be positive and finite, rad/s, not {frozen_omega!r}")
