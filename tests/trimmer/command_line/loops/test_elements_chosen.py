"""What options make of an element, and what is advised where its loop cannot be followed."""

from __future__ import annotations

import math
from argparse import Namespace

import pytest

import trimmer
from trimmer.command_line.loops import loop_options
from trimmer.command_line.parser import OptionError


def test_elements_get_their_options_in_order() -> None:
    def chosen(**options: object) -> trimmer.Element:
        names = dict.fromkeys(loop_options.ELEMENT_OPTIONS)
        return loop_options.chosen_element(Namespace(**names | options, given=frozenset(options)))

    assert chosen(element="friction", gap=4e-5) == trimmer.FrictionBacklash(4e-5)
    assert chosen(element="inertia", gap=4e-5) == trimmer.InertiaBacklash(4e-5)
    assert chosen(element="viscous", gap=4e-5, time_constant=0.0) == trimmer.ViscousBacklash(4e-5, 0.0)
    assert chosen(element="viscous", gap=4e-5, time_constant=math.inf).time_constant == math.inf
    assert chosen(element="coulomb", force=2.0) == trimmer.CoulombFriction(2.0)
    assert chosen(element="relay", force=2.0) == trimmer.Relay(2.0, 0.0, 0.0)
    assert chosen(element="relay", force=2.0, hysteresis=3e-6) == trimmer.Relay(2.0, 3e-6, 0.0)
    assert chosen(element="relay", force=2.0, dead_zone=5e-6, hysteresis=0.0) == trimmer.Relay(2.0, 0.0, 5e-6)
    assert chosen(element="saturation", threshold=3e-6) == trimmer.Saturation(3e-6, 1.0)
    assert chosen(element="saturation", threshold=3e-6, slope=0.5) == trimmer.Saturation(3e-6, 0.5)
    assert chosen(element="dead-zone", threshold=3e-6, slope=0.5) == trimmer.DeadZone(3e-6, 0.5)
    assert chosen(element="dead-zone", threshold=3e-6) == trimmer.DeadZone(3e-6, 1.0)
    assert chosen(element="preload", force=3.0) == trimmer.Preload(3.0, 1.0)
    assert chosen(element="preload", force=3.0, slope=2.0) == trimmer.Preload(3.0, 2.0)
    for wrong in (
        {"element": "friction"},
        {"element": "friction", "gap": 4e-5, "force": 1.0},
        {"element": "friction", "gap": 0.0},
        {"element": "viscous", "gap": 4e-5, "time_constant": -1.0},
        {"element": "viscous", "gap": 4e-5, "time_constant": math.nan},
        {"element": "relay", "force": 2.0, "hysteresis": math.inf},
        {"element": "relay", "force": 2.0, "slope": 1.0},
        {"element": "saturation", "threshold": 3e-6, "slope": 0.0},
    ):
        with pytest.raises(OptionError):
            chosen(**wrong)


def test_a_loop_that_cannot_be_followed_gets_advice() -> None:
    from trimmer.errors import IllPosedLoopError

    asked = Namespace(element="coulomb", channels="both")
    advice = str(loop_options.unusable(asked, IllPosedLoopError("x")))
    assert "--channels displacement" in advice
    assert str(loop_options.unusable(asked, ValueError("x"))) == "x"
    for name, other in (("element", "relay"), ("channels", "displacement")):
        asked = Namespace(**{"element": "coulomb", "channels": "both", name: other})
        assert str(loop_options.unusable(asked, IllPosedLoopError("x"))) == "x"
