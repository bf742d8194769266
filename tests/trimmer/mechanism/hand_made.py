"""A mechanism with a part of nearly each kind, one of whose names has a blank."""

from __future__ import annotations

from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.parts import Body, Friction, Link, Output, Pin, Play

MECHANISM = Mechanism(
    {"motor": Body(0.035), "2. guard": Body(0.03)},
    frequency=110.0,
    pins={"pin": Pin("motor", 1.5e-3)},
    links={"mount": Link(("ground", "motor"), 200e3, 3.5)},
    plays={"bridge": Play(("2. guard", "pin"), 30e3, 0.4, 40e-6)},
    frictions={"rub": Friction(("ground", "2. guard"), 0.5)},
    outputs={"stroke": Output({"motor": 1.0, "2. guard": -2.0})},
    start={"motor": (3.0, 4.0)},
)
