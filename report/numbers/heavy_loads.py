"""Limit cycles of viscous-controlled backlash with a constant M omega / D (figure 5.16)."""

from __future__ import annotations

import control

from trimmer.balance.limit_cycle import LimitCycle
from trimmer.balance.solve import limit_cycles
from trimmer.elements.viscous_backlash import ViscousBacklash


def cycles_of_constant_gamma(system: control.lti.LTI, gamma: float) -> tuple[LimitCycle, LimitCycle]:
    """Return the unstable and the stable one, in order of frequency, for a gap of one metre."""
    inner, outer = limit_cycles(system, ViscousBacklash(1.0, gamma).at(1.0))
    return inner, outer
