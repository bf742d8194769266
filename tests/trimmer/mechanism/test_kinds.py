"""Rotations and points: kinds and units of everything, and what is refused, as a file and as data."""

import math

import numpy as np
import pytest

from trimmer.errors import MechanismError
from trimmer.mechanism import Body, Force, Friction, Link, Mechanism, Output, Pin, Point, linear_matrices
from trimmer.mechanism.kinds import Kind

LEVER = """
frequency = 40.0
[bodies]
arm = { inertia = "20 g mm^2" }
gear = { inertia = 2e-6 }
housing = { mass = "0.2 kg" }
[points]
tip = { arm = "50 mm", housing = 1 }
wheel = { arm = -2.5 }
rack = { gear = "20 mm" }
[pins]
crank = { on = "ground", amplitude = "2 deg", velocity = "60 rpm" }
slot = { on = "tip", offset = "1 mm" }
[links]
shaft = { between = ["crank", "gear"], stiffness = "2 N m/rad", damping = "1e-3 N m s/rad" }
mount = { between = ["ground", "housing"], stiffness = "20 N/mm" }
return = { between = ["ground", "arm"], stiffness = 2.0 }
[plays]
mesh = { between = ["wheel", "gear"], stiffness = 300.0, gap = "0.5 deg" }
joint = { between = ["slot", "rack"], stiffness = 15e3, gap = "0.1 mm" }
[frictions]
bearing = { between = ["ground", "arm"], force = "2 mN m", viscous = 1e-4 }
[forces]
moment = { on = "wheel", amplitude = "60 mN m", unbalance = "3 g mm^2" }
push = { on = "rack", constant = "1 N" }
[outputs]
angle = { arm = 1, gear = -1 }
edge = { arm = 0.05, housing = "1" }
reach = { tip = 1, rack = -1 }
[start]
arm = ["90 deg", "30 rpm"]
"""


@pytest.fixture(scope="module")
def lever() -> Mechanism:
    return Mechanism.from_toml_text(LEVER)


def test_units_are_those_of_the_kind(lever: Mechanism) -> None:
    assert {
        place: lever.places[place]
        for place in ("bodies.arm.inertia", "pins.crank.amplitude", "pins.slot.offset", "links.shaft.damping",
                      "plays.mesh.gap", "plays.joint.gap", "frictions.bearing.force", "forces.push.constant",
                      "forces.moment.unbalance", "points.tip.arm", "points.tip.housing", "points.wheel.arm",
                      "points.rack.gear", "outputs.angle.arm", "outputs.edge.arm", "start.arm.velocity")
    } == {
        "bodies.arm.inertia": "kg m²", "pins.crank.amplitude": "rad", "pins.slot.offset": "m",
        "links.shaft.damping": "N m s/rad", "plays.mesh.gap": "rad", "plays.joint.gap": "m",
        "frictions.bearing.force": "N m", "forces.push.constant": "N", "forces.moment.unbalance": "kg m²",
        "points.tip.arm": "m", "points.tip.housing": "1", "points.wheel.arm": "1", "points.rack.gear": "m",
        "outputs.angle.arm": "1", "outputs.edge.arm": "m", "start.arm.velocity": "rad/s",
    }  # fmt: skip
    assert "bodies.arm.mass" not in lever.places
    numbers = {
        "bodies.arm.inertia": 2e-8, "pins.crank.amplitude": math.radians(2), "pins.crank.velocity": math.tau,
        "plays.mesh.gap": math.radians(0.5), "frictions.bearing.force": 2e-3, "points.tip.arm": 0.05,
        "start.arm.displacement": math.pi / 2, "start.arm.velocity": math.pi,
    }  # fmt: skip
    assert {place: lever.value(place) for place in numbers} == pytest.approx(numbers, rel=1e-15)
    kinds = {name: kind.value for name, kind in lever.kinds.items()}
    assert {name for name in kinds if kinds[name] == "rotation"} == {"arm", "gear", "wheel", "crank"}
    assert lever.kind_of("outputs", "edge") is Kind.TRANSLATION


def test_it_is_written_and_read_back_equal(lever: Mechanism) -> None:
    text = lever.to_toml()
    assert 'rack = { gear = "0.02 m" }' in text
    assert Mechanism.from_toml_text(text) == lever
    assert lever.with_value("points.tip.arm", "60 mm").points["tip"] == Point(
        {"arm": 0.06, "housing": 1.0}, by_length=True
    )
    forces, geared = linear_matrices(lever).forces, lever.with_value("points.wheel.arm", -5.0)
    np.testing.assert_array_equal(linear_matrices(geared).forces, forces * [[2, 1], [1, 1], [1, 1]])


def test_a_length_is_told_in_python_as_in_a_file(lever: Mechanism) -> None:
    def made(**points: Point) -> Mechanism:
        bodies = {"arm": Body(inertia=1.0), "housing": Body(1.0)}
        links = {"a": Link(("ground", "arm"), 1.0), "b": Link(("ground", "housing"), 1.0)}
        return Mechanism(bodies, links=links, points=points)

    assert made(tip=Point({"arm": 0.05, "housing": 1.0})) == made(
        tip=Point({"arm": 0.05, "housing": 1.0}, by_length=True)
    )
    rack = made(rack=Point({"arm": 0.02}, by_length=True))
    assert rack != made(rack=Point({"arm": 0.02}))
    assert (rack.places["points.rack.arm"], rack.kinds["rack"]) == ("m", Kind.TRANSLATION)
    assert Mechanism.from_toml_text(rack.to_toml()) == rack
    with pytest.raises(MechanismError, match="none of its coordinates turns"):
        made(rack=Point({"housing": 0.02}, by_length=True))


REFUSED = [
    ("inertia = 2e-6", "mass = 1, inertia = 2e-6", "a body has a mass or, if it turns, an inertia"),
    ("inertia = 2e-6", 'symbol = "J"', "line 5: bodies.gear.mass: missing; add mass = 0.035, or"),
    ("inertia = 2e-6", "inertia = 0", "must be greater than zero, in kg m²"),
    ("inertia = 2e-6", 'inertia = "2 kg"', "'kg' does not measure what kg m² does"),
    ("wheel = { arm = -2.5 }", "wheel = { tip = 2 }", "points.wheel.tip = 2: is a point itself"),
    ("wheel = { arm = -2.5 }", "wheel = { crank = 2 }", "a pin moves as prescribed"),
    ("wheel = { arm = -2.5 }", "wheel = { ground = 2 }", "the ground does not move"),
    ("wheel = { arm = -2.5 }", "wheel = { amr = 2 }", "no body 'amr'; did you mean arm?"),
    ("wheel = { arm = -2.5 }", "wheel = {}", "points.wheel: has no weights"),
    ("wheel = { arm = -2.5 }", "wheel = { arm = 0 }", "all its weights are 0"),
    ("wheel = { arm = -2.5 }", 'wheel = { arm = "3 N" }', "'N' does not measure what 1 does"),
    ("wheel = { arm = -2.5 }", "wheel = { arm = -2.5 }\ngear = { arm = 1 }", "a body has this name already"),
    ("wheel = { arm = -2.5 }", "wheel = { arm = -2.5 }\nslot = { arm = 1 }", "has this name already"),
    ("rack = { gear", 'rack = { arm = 1, gear', "the weight of 'gear' is a length; write this one with"),
    ('tip = { arm = "50 mm", housing = 1', 'tip = { arm = 1, housing = "1 mm"', "'housing' is a translation"),
    ('["wheel", "gear"]', '["tip", "gear"]', "'tip' is a translation and 'gear' a rotation; both ends are"),
    ('["crank", "gear"]', '["crank", "rack"]', "'crank' is a rotation and 'rack' a translation"),
    ('["wheel", "gear"]', '["wheel", "wheel"]', "both ends are the same"),
    ('["slot", "rack"]', '["slot", "tip"]', "both ends are on 'tip', so that nothing between them can move"),
    ('rack = { gear = "20 mm" }', "rack = { arm = -2.5 }\ntwin = { arm = -2.5 }",
     "'slot' is a translation and 'rack' a rotation"),
    ("velocity = \"60 rpm\"", 'velocity = "1 m/s"', "'m/s' does not measure what rad/s does"),
    ("edge = { arm = 0.05, housing = \"1\" }", 'edge = { arm = "50 mm" }', "give a point this length"),
    ('gap = "0.5 deg"', 'gap = "0.5 mm"', "\"0.5 deg\" would do"),
    ("force = \"2 mN m\"", "force = 2e-3, static = 1e-3", "less than the kinetic one, 0.002 N m; it is"),
    ('"30 rpm"]', '"30 rpm"]\ntip = [0, 1]', "a point starts where its coordinates put it"),
    ('on = "wheel"', 'on = "whel"', "there is no body or point 'whel'; did you mean wheel?"),
    ('["ground", "housing"]', '["ground", "slide"]', "there is no body, pin or point 'slide'"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "expected"), REFUSED)
def test_what_does_not_fit_is_refused(old: str, new: str, expected: str) -> None:
    assert LEVER.count(old) == 1
    with pytest.raises(MechanismError) as raised:
        Mechanism.from_toml_text(LEVER.replace(old, new))
    assert expected in str(raised.value)


def test_ends_with_equal_weights_are_refused_also_later() -> None:
    mechanism = Mechanism(
        {"a": Body(1.0), "b": Body(2.0)},
        points={"p": Point({"a": 0.5, "b": 0.5}), "q": Point({"a": 0.5, "b": 0.25})},
        frictions={"rub": Friction(("p", "q"), 1.0), "hold": Friction(("ground", "a"), 1.0)},
    )
    with pytest.raises(MechanismError, match="both ends have the same weights, so that nothing between"):
        mechanism.with_value("points.q.b", 0.5)
    assert mechanism.with_value("points.q.b", 0.4).value("points.q.b") == 0.4


def test_what_points_touch_is_touched_and_nothing_else() -> None:
    bodies = {"a": Body(1.0), "b": Body(1.0)}
    points = {"p": Point({"a": 1.0, "b": 0.5})}
    assert Mechanism(bodies, points=points, forces={"f": Force("p", 1.0)}).points
    with pytest.raises(MechanismError, match="nothing touches body 'b'"):
        Mechanism(bodies, points=points, forces={"f": Force("a", 1.0)}, outputs={"y": Output({"p": 1.0})})


@pytest.mark.parametrize("joined", ["gear", "slide"])
def test_a_pin_on_the_ground_is_what_it_is_joined_to(joined: str) -> None:
    mechanism = Mechanism(
        {"gear": Body(inertia=1.0), "slide": Body(1.0)},
        pins={"base": Pin("ground", velocity=1.0)},
        links={"a": Link(("ground", "gear"), 1.0), "b": Link(("ground", "slide"), 1.0)},
        frictions={"rub": Friction(("base", joined), 1.0)},
    )
    units = ("rad/s", "N m") if joined == "gear" else ("m/s", "N")
    assert (mechanism.places["pins.base.velocity"], mechanism.places["frictions.rub.force"]) == units
