from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.trimmer.mechanism.mechanisms import NAMES, mechanisms
from trimmer import Body, Force, Friction, Link, Mechanism, MechanismError, Output, Pin, Play, Stop
from trimmer.mechanism.place_text import parse_place, place_text
from trimmer.mechanism.places import assignment

TRIMMER = Mechanism(
    {"motor": Body(0.035), "cutter": Body(0.003), "2. guard": Body(0.03)},
    frequency=110.0,
    pins={"pin": Pin("motor", 1.5e-3)},
    links={
        "motor mount": Link(("ground", "motor"), 200e3, 3.5),
        "guard spring": Link(("ground", "2. guard"), 100e3, 4.0),
    },
    plays={"bridge": Play(("cutter", "pin"), 30e3, 0.4, 40e-6)},
    stops={"wall": Stop(("ground", "cutter"), 1e3, gap=1e-3)},
    frictions={"blade": Friction(("2. guard", "cutter"), 0.5)},
    forces={"rotor": Force("motor", unbalance=1e-5)},
    outputs={"stroke": Output({"cutter": 1.0, "2. guard": -1.0})},
)


EXAMPLES = sorted((Path(__file__).parents[3] / "examples").glob("*.toml"))


@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_a_changed_mechanism_is_the_one_that_is_checked_as_a_whole(file: Path) -> None:
    mechanism = Mechanism.from_toml(file)
    before = hash(mechanism)
    for place in mechanism.places:
        if mechanism.frequency is None and place.endswith(("frequency", ".amplitude", ".unbalance")):
            continue
        factor = 1.1 if place.endswith(".static") else 1.01 if place.endswith(".time") else 0.9
        value = 2 if place.endswith(".order") else factor * mechanism.value(place) or 0.25
        changed = mechanism.with_value(place, value)
        whole = replace(changed)
        assert changed == whole
        assert hash(changed) == hash(whole)
        assert changed.to_toml() == whole.to_toml()
        assert changed.value(place) == value
        assert type(changed.value(place)) is type(whole.value(place))
    assert hash(mechanism) == before


def test_numbers_that_do_not_go_together_are_refused_one_by_one_too() -> None:
    with pytest.raises(MechanismError, match=r"frictions\.blade\.static.*less than the kinetic one"):
        TRIMMER.with_value("frictions.blade.static", 0.2)
    with pytest.raises(MechanismError, match=r"plays\.bridge\.stiffness.*needs a stiffness"):
        TRIMMER.with_value("plays.bridge.stiffness", 0.0)
    block = Mechanism(
        {"block": Body(1.0)}, pins={"belt": Pin("ground")}, links={"spring": Link(("belt", "block"), 1.0)}
    )
    with pytest.raises(MechanismError, match=r"pins\.belt\.amplitude.*no frequency"):
        block.with_value("pins.belt.amplitude", 1.0)
    with pytest.raises(MechanismError, match="must be finite"):
        TRIMMER.with_value("plays.bridge.gap", float("nan"))


def test_all_numbers_have_places() -> None:
    assert dict(TRIMMER.places) == {
        "frequency": "Hz", "bodies.motor.mass": "kg", "bodies.cutter.mass": "kg",
        'bodies."2. guard".mass': "kg", "pins.pin.amplitude": "m", "pins.pin.phase": "rad",
        "pins.pin.offset": "m", "pins.pin.velocity": "m/s", "pins.pin.order": "1",
        'links."motor mount".stiffness': "N/m", 'links."motor mount".damping': "N s/m",
        'links."guard spring".stiffness': "N/m", 'links."guard spring".damping': "N s/m",
        "plays.bridge.stiffness": "N/m", "plays.bridge.damping": "N s/m", "plays.bridge.gap": "m",
        "stops.wall.stiffness": "N/m", "stops.wall.damping": "N s/m", "stops.wall.gap": "m",
        "frictions.blade.force": "N", "frictions.blade.static": "N", "frictions.blade.viscous": "N s/m",
        "forces.rotor.constant": "N", "forces.rotor.amplitude": "N", "forces.rotor.phase": "rad",
        "forces.rotor.order": "1", "forces.rotor.unbalance": "kg m", "outputs.stroke.cutter": "1",
        'outputs.stroke."2. guard"': "1", "start.motor.displacement": "m", "start.motor.velocity": "m/s",
        "start.cutter.displacement": "m", "start.cutter.velocity": "m/s",
        'start."2. guard".displacement': "m", 'start."2. guard".velocity': "m/s",
    }  # fmt: skip


@settings(max_examples=8)
@given(mechanisms(), st.data())
def test_a_number_that_is_set_is_read_back_and_no_other_changes(mechanism: Mechanism, data) -> None:
    place = data.draw(st.sampled_from(sorted(mechanism.places)))
    number = data.draw(st.integers(1, 9))
    if place.endswith(".static"):
        number += mechanism.value(place)
    if place.endswith(".force"):
        number = mechanism.value(place) / 2
    changed = mechanism.with_value(place, number)
    assert changed.value(place) == number
    others = set(mechanism.places) - {place, place.removesuffix("force") + "static"}
    assert {each: changed.value(each) for each in others} == {each: mechanism.value(each) for each in others}
    assert changed.with_value(place, mechanism.value(place)).value(place) == mechanism.value(place)


def test_the_static_force_is_the_kinetic_one_until_it_is_set() -> None:
    assert TRIMMER.with_value("frictions.blade.force", 0.7).value("frictions.blade.static") == 0.7
    stuck = TRIMMER.with_value("frictions.blade.static", 0.6)
    with pytest.raises(MechanismError, match=r"frictions\.blade\.static = 0\.6: the static force is less"):
        stuck.with_value("frictions.blade.force", 0.7)


def test_starts_are_set_one_number_by_one() -> None:
    changed = TRIMMER.with_value("start.cutter.velocity", "20 mm/s").with_value("start.motor.displacement", 3)
    assert dict(changed.start) == {"cutter": (0.0, 0.02), "motor": (3.0, 0.0)}
    assert (changed.value("start.cutter.velocity"), changed.value("start.cutter.displacement")) == (0.02, 0.0)


def test_a_mechanism_may_get_a_frequency() -> None:
    still = Mechanism({"a": Body(1.0)}, links={"l": Link(("ground", "a"), 1.0)})
    with pytest.raises(MechanismError, match="frequency: the mechanism has none"):
        still.value("frequency")
    assert still.with_value("frequency", "50 Hz").value("frequency") == 50.0


@pytest.mark.parametrize(
    ("place", "value", "reason"),
    [
        ("plays.bridge.gap", -1e-6, "plays.bridge.gap = -1e-06: must be zero or greater, in m"),
        ("plays.bridge.gap", "3 kg", "plays.bridge.gap = '3 kg': 'kg' does not measure what m does"),
        ("plays.bridge.gap", "3", "has no unit"),
        ("plays.bridge.gap", "__import__('os').getpid()", "is no number with a unit; text is not evaluated"),
        ("plays.bridge.gap", True, "give a number"),
        ("plays.bridge.gap", None, "give a number"),
        ("pins.pin.order", 1.5, "must be a whole number from 1 on"),
        ("pins.pin.order", 0, "must be a whole number from 1 on"),
        ("pins.pin.order", "two", "is no number; text is not evaluated"),
        ("frequency", 0, "must be greater than zero, in Hz"),
        ("frequenzy", 1, "did you mean frequency?"),
        ("bridge.gap", 1, "did you mean plays.bridge.gap?"),
        ("gap", 1, "did you mean plays.bridge.gap or stops.wall.gap?"),
        ("mass", 1, 'did you mean bodies.motor.mass, bodies.cutter.mass or bodies."2. guard".mass?'),
        ("damping", 1, "a place begins with"),  # too many to ask for
        ("outputs.stroke.pin", 1, 'after outputs.stroke comes cutter or "2. guard"'),
        ("outputs.x.motor", 1, "after outputs comes stroke"),
        ("start.pin.velocity", 1, 'after start comes motor, cutter or "2. guard"'),
        ("start.motor.x", 1, "after start.motor comes displacement or velocity"),
        ("plays.brigde.gap", 1, "no number at plays.brigde.gap; did you mean plays.bridge.gap?"),
        ("play.bridge.gap", 1, "did you mean plays.bridge.gap?"),
        ("plays.bridge", 1, "after plays.bridge comes stiffness, damping or gap"),
        ("bodies", 1, 'after bodies comes motor, cutter or "2. guard"'),
        ("x", 1, "a place begins with frequency, bodies, pins"),
        ("plays.bridge.gap.more", 1, "did you mean plays.bridge.gap?"),
        ("plays.bridge.law", 1, "no number at plays.bridge.law"),
        ("bodies.2. guard.mass", 1, 'did you mean bodies."2. guard".mass?'),
        ("plays..gap", 1, "is no place"),
        ("", 1, "is no place"),
        ('plays."bridge.gap', 1, "is no place"),
        ('plays."bri\\qdge".gap', 1, "is no place"),
        ("plays.bridge.", 1, "is no place"),
    ],
)
def test_what_cannot_be_set_is_refused_with_advice(place: str, value: object, reason: str) -> None:
    with pytest.raises(MechanismError) as raised:
        TRIMMER.with_value(place, value)
    assert reason in str(raised.value)


@pytest.mark.parametrize(
    ("text", "place", "number"),
    [
        ("plays.bridge.gap=40 um", "plays.bridge.gap", 40e-6),
        ("plays.bridge.gap = 40um", "plays.bridge.gap", 40e-6),
        ("plays.bridge.gap=4e-5", "plays.bridge.gap", 4e-5),
        ("pins.pin.offset=-0.1mm", "pins.pin.offset", -1e-4),
        ('links."motor mount".damping=3', 'links."motor mount".damping', 3.0),
        ("links.'motor mount'.damping=3", 'links."motor mount".damping', 3.0),
        ("links.motor mount.damping=3", 'links."motor mount".damping', 3.0),
        (' bodies . "2. guard" . mass = 1 g', 'bodies."2. guard".mass', 1e-3),
        ("frequency=6600 rpm", "frequency", 110.0),
        ("pins.pin.order=2", "pins.pin.order", 2),
        ("outputs.stroke.cutter=-1", "outputs.stroke.cutter", -1.0),
    ],
)
def test_assignments_of_the_command_line(text: str, place: str, number: float) -> None:
    assigned, value = assignment(text)
    assert assigned == place
    assert TRIMMER.with_value(assigned, value).value(place) == number


@pytest.mark.parametrize("text", ["plays.bridge.gap", "=3", "plays.bridge.gap=", '"a=3', "", "a..b=3"])
def test_what_sets_nothing_is_refused(text: str) -> None:
    with pytest.raises(MechanismError, match=r"sets nothing|is no place"):
        assignment(text)


@given(st.lists(NAMES, min_size=1, max_size=4).map(tuple))
def test_places_are_read_as_they_are_written(place: tuple[str, ...]) -> None:
    assert parse_place(place_text(place)) == place
    assert assignment(f"{place_text(place)}=1") == (place_text(place), 1.0)
