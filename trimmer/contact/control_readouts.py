"""What is read of controllers: what acts, what is demanded, and at which limit they are."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from trimmer.contact.control_limits import first_control, limited
from trimmer.contact.statuses import AT_LOWER, AT_UPPER
from trimmer.motion.part import Part
from trimmer.motion.signals import Steady

if TYPE_CHECKING:
    from collections.abc import Iterator

    from trimmer.arrays import Reals
    from trimmer.contact.system import MechanismSystem
    from trimmer.hybrid.tables import Modes
    from trimmer.motion.signals import Signal


def control_signal(modes: Modes[MechanismSystem], name: str) -> Signal:
    """Return what a controller acts with, N, after limit, hold and delay."""
    layout = modes.system.layout
    if name in layout.held:
        return Steady(np.eye(1, layout.size, layout.held[name].acting)[0])
    control = modes.system.layout.controllers.index(name)

    def row(mode: int) -> Reals:
        machine = modes.system.machine
        status = modes[mode].statuses[first_control(machine) + control]
        through = machine.control_through[control] * limited(machine, control, status)
        found: Reals = machine.control_rest[control] + through
        return found

    return row


def demand_signal(modes: Modes[MechanismSystem], name: str) -> Signal:
    """Return what a controller demands, N, before its limit."""
    return Steady(modes.system.machine.control_demand[modes.system.layout.controllers.index(name)])


def parts_of_controls(names: tuple[str, ...]) -> Iterator[Part]:
    """Yield the controllers as parts with statuses; to reach a limit is no phase that counts."""
    return (Part(name, {}, {AT_UPPER: AT_LOWER, AT_LOWER: AT_UPPER}) for name in names)
