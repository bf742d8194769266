"""The load's time constant M/D behind a backlash, from the frequency of a measured limit cycle."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from trimmer.balance.element_curve import ElementCurve, GainTable
from trimmer.balance.inverse_response import ConstantResponse
from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.loop import LoopEquation, inverse_response
from trimmer.balance.search import Problem, find_all
from trimmer.balance.stability import limit_cycles_at
from trimmer.elements.viscous_backlash import ViscousBacklash

if TYPE_CHECKING:
    import control

    from trimmer.arrays import Reals
    from trimmer.balance.inverse_response import InverseResponse

GAMMA_RANGE = (1e-8, 1e8)
"""omega M/D that is searched; beyond it, no measured frequency distinguishes the load from a friction- or
inertia-controlled one."""

LIMIT_TOLERANCE = 1e-7
"""|1 + N G| below which a frequency counts as that of friction- or inertia-controlled backlash itself."""

_BLOCKS = 64
"""Intervals of ln(omega M/D) to begin with."""

_SAMPLES = 400


@dataclass(frozen=True)
class IdentifiedTimeConstant:
    """A time constant that gives a limit cycle at the measured frequency.

    Attributes:
        time_constant: M/D, s; 0 for friction-controlled, infinite for inertia-controlled backlash.
        limit_cycle: The limit cycle, at the measured frequency.
    """

    time_constant: float
    limit_cycle: LimitCycle

    @property
    def amplitude(self) -> float:
        """Amplitude of the limit cycle, half of peak to peak at the backlash, in the unit of the gap."""
        return self.limit_cycle.amplitude

    @property
    def stable(self) -> bool:
        """Whether that limit cycle is stable."""
        return self.limit_cycle.stable


def identify_time_constant(
    G: control.lti.LTI, gap: float, frequency: float
) -> tuple[IdentifiedTimeConstant, ...]:
    """Find all M/D >= 0 for which a limit cycle has a given frequency (equation 5.11 of the thesis).

    Solves 1 + N(gap/A, omega M/D) G(j omega) = 0 for gap/A and M/D with the search of
    ``trimmer.balance.search``, so that none is missed. The gap scales the amplitude only.

    Args:
        G: A rational, proper, continuous-time system with one input and one output.
        gap: Total clearance, > 0, m.
        frequency: Frequency of the limit cycle, Hz.

    Returns:
        In order of the time constant. Empty if no M/D gives a limit cycle at that frequency.

    Raises:
        UnsupportedSystemError: if G is not such a system.
        ValueError: if the gap or the frequency is not positive and finite.
    """
    if not 0 < frequency < math.inf:
        raise ValueError(f"frequency must be positive and finite, Hz, not {frequency!r}")
    response = inverse_response(G)
    omega = 2.0 * math.pi * frequency
    inverse = complex(response.value(np.array([math.log(omega)]))[0])
    # With a time constant of 1 s, x = ln omega of the element is ln gamma.
    curve = ElementCurve(ViscousBacklash(gap, 1.0))
    table = GainTable.of(curve, np.linspace(math.log(GAMMA_RANGE[0]), math.log(GAMMA_RANGE[1]), _BLOCKS + 1))
    result = find_all(Problem(ConstantResponse(inverse), curve, table, 0.0))
    found = [
        _identified(response, gap, math.exp(x) / omega, u, omega)
        for u, x in zip(result.u, result.x, strict=True)
    ]
    for time_constant in (0.0, math.inf):
        found += [
            _identified(response, gap, time_constant, u, omega)
            for u in _at_limit(ViscousBacklash(gap, time_constant), inverse, omega)
        ]
    return tuple(sorted(found, key=lambda each: (each.time_constant, each.amplitude)))


def _at_limit(element: ViscousBacklash, inverse: complex, omega: float) -> Reals:
    """Find u with N(u) + inverse = 0 to the tolerance, by the Gauss-Newton method from the nearest sample."""
    curve = ElementCurve(element.at(omega))
    x = np.array([math.log(omega)])
    samples = np.linspace(0.0, float(curve.edge(x).max()), _SAMPLES + 2)[1:-1]
    u = samples[[np.argmin(np.abs(curve.value(samples, np.full(_SAMPLES, x[0])) + inverse))]]
    for _ in range(8):
        gain, slope, _ = curve.expansion(u, x)
        u = u - ((gain + inverse) * slope.conj()).real / np.abs(slope) ** 2
    with np.errstate(invalid="ignore"):
        return u[np.abs(curve.value(u, x) / inverse + 1.0) <= LIMIT_TOLERANCE]


def _identified(
    response: InverseResponse, gap: float, time_constant: float, u: float, omega: float
) -> IdentifiedTimeConstant:
    curve = ElementCurve(ViscousBacklash(gap, time_constant))
    (cycle,) = limit_cycles_at(LoopEquation(response, curve), np.array([u]), np.array([math.log(omega)]))
    return IdentifiedTimeConstant(time_constant, cycle)
