"""The linear trimmer of the thesis (section 2.2.1, figure 2.1b) as a mechanism."""

from __future__ import annotations

from typing import TYPE_CHECKING

from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import GROUND, Body, Link, Output, Pin

if TYPE_CHECKING:
    from trimmer.parameters import TrimmerParameters


def linear_mechanism(parameters: TrimmerParameters, amplitude: float, frequency: float) -> Mechanism:
    """Return the trimmer with a bridge that is a link.

    Args:
        parameters: Masses, stiffnesses and dampings.
        amplitude: Amplitude of the pin relative to the motor, m.
        frequency: Frequency of the drive, Hz.

    Raises:
        MechanismError: if amplitude or frequency is no such number.
    """
    p = parameters
    return Mechanism(
        title="Linear trimmer",
        frequency=frequency,
        bodies={
            "motor": Body(p.m1, "m_1"),
            "cutter": Body(p.m2, "m_2"),
            "housing": Body(p.m3, "m_3"),
            "guard": Body(p.m4, "m_4"),
        },
        pins={"pin": Pin("motor", amplitude, symbol="u")},
        links={
            "motor mount": Link((GROUND, "motor"), p.k1, p.c1, "k_1"),
            "bridge": Link(("pin", "cutter"), p.k2, p.c2, "k_2"),
            "housing mount": Link((GROUND, "housing"), p.k3, p.c3, "k_3"),
            "guard spring": Link(("housing", "guard"), p.k4, p.c4, "k_4"),
            "coil spring": Link(("housing", "cutter"), p.k5, symbol="k_5"),
        },
        outputs={"stroke": Output({"cutter": 1.0, "guard": -1.0})},
    )
