"""The linear trimmer as a mechanism has each number in its place."""

from __future__ import annotations

from trimmer.mechanism.thesis import linear_mechanism
from trimmer.parameters import TrimmerParameters

MASSES = {"m1": 0.1, "m2": 0.2, "m3": 0.3, "m4": 0.4}
STIFFNESSES = {"k1": 1e3, "k2": 2e3, "k3": 3e3, "k4": 4e3, "k5": 5e3}
DAMPINGS = {"c1": 1.0, "c2": 2.0, "c3": 3.0, "c4": 4.0}


def test_the_linear_trimmer_has_each_number_in_its_place() -> None:
    mechanism = linear_mechanism(TrimmerParameters(**MASSES, **STIFFNESSES, **DAMPINGS), 1.5e-3, 110.0)
    assert (mechanism.title, mechanism.frequency) == ("Linear trimmer", 110.0)
    bodies = {name: (body.mass, body.symbol) for name, body in mechanism.bodies.items()}
    assert bodies == {
        "motor": (0.1, "m_1"),
        "cutter": (0.2, "m_2"),
        "housing": (0.3, "m_3"),
        "guard": (0.4, "m_4"),
    }
    links = [(tuple(each.between), each.stiffness, each.damping) for each in mechanism.links.values()]
    assert links == [
        (("ground", "motor"), 1e3, 1.0),
        (("pin", "cutter"), 2e3, 2.0),
        (("ground", "housing"), 3e3, 3.0),
        (("housing", "guard"), 4e3, 4.0),
        (("housing", "cutter"), 5e3, 0.0),
    ]
    assert [each.symbol for each in mechanism.links.values()] == ["k_1", "k_2", "k_3", "k_4", "k_5"]
    (pin,) = mechanism.pins.values()
    assert (pin.on, pin.amplitude, pin.symbol) == ("motor", 1.5e-3, "u")
    assert dict(mechanism.outputs["stroke"].weights) == {"cutter": 1.0, "guard": -1.0}
