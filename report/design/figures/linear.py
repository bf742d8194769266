"""Transfer functions from a drive to an output, with contacts closed and open."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from report.pages.drawing.style import FAINT, LINES, panels
from trimmer.design.linear import Contacts

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from trimmer.design.linear import LinearState

NAMES = {Contacts.CLOSED: "contacts closed", Contacts.OPEN: "contacts open"}


def transfer_functions(
    states: tuple[LinearState, ...], drive: str, output: str, frequency: float | None
) -> Figure:
    """Draw modulus and phase of one transfer function in each state of the contacts."""
    figure, (modulus, phase) = panels(3.9, 2, 1, sharex=True, height_ratios=(2, 1))
    unit = ""
    for state, look in zip(states, LINES, strict=False):
        for each in state.transfer:
            if (each.drive, each.output) == (drive, output) and abs(each.response).max() > 0:
                unit = "m/m" if each.unit == "m" else "m/N"
                name = NAMES[state.contacts] if len(states) > 1 else None
                modulus.plot(each.frequency, abs(each.response), label=name, **look)
                phase.plot(each.frequency, np.degrees(np.angle(each.response)), **look)
    modulus.set(xscale="log", yscale="log", ylabel=f"modulus [{unit}]")
    phase.set(xscale="log", xlabel="frequency [Hz]", ylabel="phase [°]", yticks=(-180, -90, 0, 90, 180))
    if frequency is not None:
        for axes in (modulus, phase):
            axes.axvline(frequency, **FAINT)
    if len(states) > 1:
        modulus.legend(loc="best")
    return figure
