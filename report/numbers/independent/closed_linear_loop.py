"""The loop of section 5.2 closed without play, so that it is linear."""

from __future__ import annotations

import control


def slowest_growth(system: control.TransferFunction) -> float:
    """Return the largest real part of its poles, 1/s: growth of the slowest motion, negative if it decays."""
    return float(max(pole.real for pole in control.poles(control.feedback(system, 1))))
