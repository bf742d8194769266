"""Lines of keys, places and open values of mechanisms, each written out by hand."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.trimmer.mechanism.hand_made import MECHANISM
from trimmer.errors import MechanismError
from trimmer.mechanism import places
from trimmer.mechanism.matrices import linear_matrices
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.open_values import OpenValue, open_values, replaced
from trimmer.mechanism.parts import Body, Force, Link, Pin
from trimmer.mechanism.place_text import parse_place, place_text, quoted, split_assignment, unit_of
from trimmer.mechanism.quantities import DISPLACEMENT, FREQUENCY, QUANTITIES
from trimmer.mechanism.reading import mechanism_of_text, read_mechanism
from trimmer.mechanism.toml_lines import lines_of_keys
from trimmer.mechanism.units import UnitError

TEXT = """\
title = "x"
a.b . c = [1, [2,
  3], { d = 4, e.f = 5 }]

[[g]]
h = '''
k'''
[[g]]
[[g.i]]
[g.i.j]
[[g.i]]
l = {}
m = []
[ "n.o" . p ]
"""


def test_every_key_and_entry_of_a_text_has_its_line() -> None:
    found = {".".join(place): line for place, line in lines_of_keys(TEXT).items()}
    assert found == {
        "title": 1,
        **dict.fromkeys(("a", "a.b", "a.b.c", "a.b.c.0", "a.b.c.1", "a.b.c.1.0"), 2),
        **dict.fromkeys(("a.b.c.1.1", "a.b.c.2", "a.b.c.2.d", "a.b.c.2.e", "a.b.c.2.e.f"), 3),
        **dict.fromkeys(("g", "g.0"), 5),
        "g.0.h": 6,
        "g.1": 8,
        **dict.fromkeys(("g.1.i", "g.1.i.0"), 9),
        "g.1.i.0.j": 10,
        "g.1.i.1": 11,
        "g.1.i.1.l": 12,
        "g.1.i.1.m": 13,
        **dict.fromkeys(("n.o", "n.o.p"), 14),
    }
    assert lines_of_keys(TEXT.replace("\n", "\r\n")) == lines_of_keys(TEXT)
    assert lines_of_keys("") == lines_of_keys("# a = 1\n") == {}


def test_numbers_are_read_and_set_at_their_places() -> None:
    for place, value in {
        "frequency": 110.0,
        'outputs.stroke."2. guard"': -2.0,
        "start.motor.displacement": 3.0,
        "start.motor.velocity": 4.0,
        'start."2. guard".velocity': 0.0,
        'start."2. guard".displacement': 0.0,
        "frictions.rub.static": 0.5,
        "plays.bridge.gap": 40e-6,
    }.items():
        assert MECHANISM.value(place) == value
    changed = MECHANISM.with_value('start."2. guard".velocity', "20 mm/s").with_value(
        "start.motor.velocity", 7
    )
    assert dict(changed.start) == {"motor": (3.0, 7.0), "2. guard": (0.0, 0.02)}
    changed = MECHANISM.with_value('start."2. guard".displacement', 5.0)
    assert changed.start["2. guard"] == (5.0, 0.0)
    changed = MECHANISM.with_value("outputs.stroke.motor", 5)
    assert dict(changed.outputs["stroke"].weights) == {"motor": 5.0, "2. guard": -2.0}
    assert (MECHANISM.start["motor"], MECHANISM.outputs["stroke"].weights["motor"]) == ((3.0, 4.0), 1.0)


@pytest.mark.parametrize(
    ("place", "advice"),
    [
        ("plays", "after plays comes bridge"),
        ("plays.bridge", "after plays.bridge comes stiffness, damping or gap"),
        ("plays.brige", "did you mean plays.bridge.gap?"),
        ("plays.bridge.gap.x", "did you mean plays.bridge.gap?"),
        ("bridge.gap", "did you mean plays.bridge.gap?"),
        ("gap", "did you mean plays.bridge.gap?"),
        ("pin.amplitude", "did you mean pins.pin.amplitude?"),
        ("mass", 'did you mean bodies.motor.mass or bodies."2. guard".mass?'),
        ("outputs.stroke.pin", 'after outputs.stroke comes motor or "2. guard"'),
        ("outputs.x.motor", "after outputs comes stroke"),
        ("start.pin.velocity", 'after start comes motor or "2. guard"'),
        ("start.motor.x", "after start.motor comes displacement or velocity"),
        (
            "forces.x.constant",
            "a place begins with frequency, bodies, pins, links, plays, frictions, outputs or start",
        ),
        ("title", "a place begins with frequency"),
        ("frequncy", "did you mean frequency?"),
    ],
)
def test_advice_for_places_that_are_not_there(place: str, advice: str) -> None:
    with pytest.raises(MechanismError) as raised:
        MECHANISM.value(place)
    assert str(raised.value).startswith(f"there is no number at {place}; {advice}")


def test_of_two_names_that_are_near_the_nearest_is_meant() -> None:
    known = [("bodies", name, "mass") for name in ("motor1", "motor2", "motor12")]
    assert places._near(("bodies", "moter2", "mas"), known) == [("bodies", "motor2", "mass")]
    (found,) = places._near(("bodies", "motor3", "mass"), known)
    assert found in known
    assert places._near(("mass",), known[:2]) == known[:2]
    assert places._near(("x", "y"), known) == []


def test_places_that_end_alike_are_named_if_they_are_few() -> None:
    known = [("a", str(k), "mass") for k in range(4)]
    assert places._ending(("mass",), known[:3]) == known[:3]
    assert places._ending(("mass",), known) == []
    assert places._ending(("1", "mass"), known) == [known[1]]
    assert [places._goes_on(("a", "b"), each) for each in ((), ("a",), ("a", "b"), ("b",))] == [
        True,
        True,
        False,
        False,
    ]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("a.b", ("a", "b")),
        (" a . b c ", ("a", "b c")),
        ('\'a.b\'."c\\"d"', ("a.b", 'c"d')),
        ("a", ("a",)),
        ("µ.b", ("µ", "b")),
    ],
)
def test_places_as_text(text: str, names: tuple[str, ...]) -> None:
    assert parse_place(text) == names
    assert parse_place(place_text(names)) == names
    for wrong in (f"{text}.", f".{text}", f"{text}..x", "", f'{text}."', f"{text}=1"):
        with pytest.raises(MechanismError, match="is no place"):
            parse_place(wrong)


def test_assignments_and_units_of_places() -> None:
    assert split_assignment(' "a=b".c = d = e ') == ('"a=b".c', "d = e")
    assert split_assignment("a=") == ("a", "")
    with pytest.raises(MechanismError, match="sets nothing"):
        split_assignment('"a=b"')
    assert places.assignment("a.b=3") == ("a.b", 3.0)
    assert places.assignment("a.b c=3 mm") == ('a."b c"', "3 mm")
    assert quoted('µ"') == '"µ\\""'
    units = {"a.gap": "m", "a.order": "1"}
    assert [unit_of(units, each) for each in (" a . gap", "a.order", "x")] == ["m", "", ""]


def test_which_values_are_open() -> None:
    content = {
        "frequency": " unknown ",
        "pins": {"p": {"on": "a..b", "amplitude": "1 mm..2 mm", "order": "unknown", "phase": 3}, "q": 4},
        "bodies": {"a": {"mass": "unknowns"}},
        "links": 5,
        "outputs": {"y": {"a": "unknown"}},
    }
    assert list(open_values(content)) == [
        OpenValue(("frequency",), " unknown ", FREQUENCY),
        OpenValue(("pins", "p", "amplitude"), "1 mm..2 mm", DISPLACEMENT),
    ]
    first, second = open_values(content)
    assert (first.is_unknown, second.is_unknown) == (True, False)
    assert "nobody knows this value" in first.problem().reason
    assert "this is a range" in second.problem().reason
    assert (second.problem().place, second.problem().value) == (("pins", "p", "amplitude"), "1 mm..2 mm")
    new = replaced(content, {("frequency",): 3.0, ("pins", "p", "amplitude"): "1 m"})
    assert (new["frequency"], new["pins"]["p"]["amplitude"], new["pins"]["p"]["phase"]) == (3.0, "1 m", 3)
    assert (content["frequency"], content["pins"]["p"]["amplitude"]) == (" unknown ", "1 mm..2 mm")


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("20 um..60 um", (20e-6, 60e-6)),
        ("20..60 um", (20e-6, 60e-6)),
        (" -.5 .. 1.5 mm", (-0.5e-3, 1.5e-3)),
        ("1.5 mm..2 m", (1.5e-3, 2.0)),
        ("1e-3..2. m", (1e-3, 2.0)),
    ],
)
def test_both_ends_of_a_range(text: str, ends: tuple[float, float]) -> None:
    assert OpenValue(("x",), text, DISPLACEMENT).ends() == pytest.approx(ends, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "wanted", "reason"),
    [
        ("unknown", DISPLACEMENT, "is no range"),
        ("2 m..1 m", DISPLACEMENT, "has no length"),
        ("1 m..1 m", DISPLACEMENT, "has no length"),
        ("1..2", DISPLACEMENT, "has no unit"),
        ("1 m..2", DISPLACEMENT, "has no unit"),
        ("1..m", DISPLACEMENT, "has no unit"),
        ("0..1 kg", QUANTITIES[Body]["mass"], "has an end that must be greater than zero"),
        ("-2..-1 kg", QUANTITIES[Body]["mass"], "has an end that must be greater than zero"),
        ("1 m..2 s", DISPLACEMENT, "'s' does not measure"),
    ],
)
def test_what_is_no_range(text: str, wanted, reason: str) -> None:
    with pytest.raises(UnitError, match=reason):
        OpenValue(("x",), text, wanted).ends()


def test_files_leave_values_open_that_are_given_by_place(tmp_path: Path) -> None:
    link = 'l = { between = ["ground", "a"], stiffness = "1..2 N/m" }'
    text = f'[bodies]\na = {{ mass = "unknown" }}\n[links]\n{link}\n'
    values = {"bodies.a.mass": "3 g", "links.l.stiffness": 1.5, "links.l.damping": 9.0}
    mechanism = mechanism_of_text(text, "f", values)
    assert mechanism == Mechanism({"a": Body(3e-3)}, links={"l": Link(("ground", "a"), 1.5)})
    with pytest.raises(
        MechanismError, match=r"^f: line 4: links\.l\.stiffness = '1\.\.2 N/m': this is a range"
    ):
        mechanism_of_text(text, "f", {"bodies.a.mass": 1.0})
    with pytest.raises(MechanismError, match="2 problems"):
        mechanism_of_text(text, "f")
    (tmp_path / "f.toml").write_text(text)
    assert read_mechanism(tmp_path / "f.toml", values) == mechanism
    with pytest.raises(MechanismError, match=r"f\.toml: 2 problems"):
        read_mechanism(tmp_path / "f.toml")


def test_matrices_in_a_line() -> None:
    pins = {"p": Pin("ground"), "q": Pin("ground")}
    mechanism = Mechanism({"a": Body(1.0)}, pins=pins, forces={f: Force("a", 1.0) for f in "xyz"})
    assert linear_matrices(mechanism)._told() == "1 body, 2 pins, 3 forces"


def test_a_mechanism_in_a_line() -> None:
    assert MECHANISM._told() == "2 bodies, 1 pin, 1 link, 1 play, 1 friction"
    one = Mechanism({"a": Body(1.0)}, links={"l": Link(("ground", "a"), 1.0)}, title="T")
    assert one._told() == "T, 1 body, 1 link"
    assert (one == MECHANISM, one != MECHANISM, one == 3) == (False, True, False)
