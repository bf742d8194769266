"""What is wrong with mechanisms of a few parts: every place, value and reason, and nothing beside them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.mechanism.checks import problems_of_types
from trimmer.mechanism.parts import Body, ContactLaw, Force, Friction, Link, Output, Pin, Play, Stop
from trimmer.mechanism.problems import NOTHING, Problem, as_message, as_message_of_file, in_one
from trimmer.mechanism.quantities import DISPLACEMENT, FREQUENCY, Quantity, Range, is_number
from trimmer.mechanism.sense import _no_such, problems_of_numbers, problems_of_sense

EMPTY = {
    **{"title": "", "frequency": None},
    **{section: {} for section in ("bodies", "pins", "links", "plays", "stops", "frictions", "forces")},
    **{"outputs": {}, "start": {}},
}
A, B = Body(1.0), Body(2.0)
MOUNT = Link(("ground", "a"), 3.0)


def types(**sections: object) -> list[tuple[str, object]]:
    """Places with values; the begin of the reason in place of the value where there is none."""
    return [(".".join(each.place), _shown(each)) for each in problems_of_types({**EMPTY, **sections})]


def sense(**sections: object) -> list[tuple[str, object]]:
    return [(".".join(each.place), _shown(each)) for each in problems_of_sense({**EMPTY, **sections})]


def _shown(problem: Problem) -> object:
    return problem.reason if problem.value is NOTHING else problem.value


def test_titles_and_frequencies() -> None:
    assert types(title="a\nb") == [("title", "a\nb")]
    assert types(title=3) == [("title", 3)]
    assert types(title="a b") == types(frequency=1) == types() == []
    assert types(frequency=0.0) == [("frequency", 0.0)]
    assert types(frequency="x") == [("frequency", "x")]


ONE_LINE = "a name must be text on one line, without spaces around it"


@pytest.mark.parametrize("name", ["", " a", "a ", "a\tb", "\n"])
def test_names_are_text_on_one_line(name: str) -> None:
    for section, content in (("bodies", A), ("outputs", Output({"a": 1.0})), ("start", (0.0, 0.0))):
        assert types(**{section: {name: content}}) == [(f"{section}.{name}", ONE_LINE)]
        assert types(**{section: {3: content}}) == [(section, "a name must be text, not 3")]
        assert types(**{section: {"a b": content}}) == []
    assert types(outputs={"y": Output({name: 1.0})}) == [(f"outputs.y.{name}", ONE_LINE)]
    assert types(outputs={"y": Output({3: 1.0})}) == [("outputs.y", "a name must be text, not 3")]


def test_parts_are_of_their_kind_and_the_others_are_looked_at_too() -> None:
    assert types(bodies=[A], links={"l": 3, "k": Link(("a", 1))}, start=3, outputs=4) == [
        ("bodies", [A]),
        ("links.l", 3),
        ("links.k.between", ("a", 1)),
        ("outputs", 4),
        ("start", 3),
    ]
    assert types(plays={"p": Stop(("a", "b"))}) == [("plays.p", Stop(("a", "b")))]


@pytest.mark.parametrize(
    ("part", "wrong"),
    [
        (Link(("a", "b"), symbol="k_1"), {}),
        (Link(["a", "b"], symbol="1"), {"symbol": "1"}),
        (Link("ab"), {"between": "ab"}),
        (Link(("a", "b", "c")), {"between": ("a", "b", "c")}),
        (Link((1, "b"), -1.0, -2.0), {"between": (1, "b"), "stiffness": -1.0, "damping": -2.0}),
        (Play(("a", "b"), law="pulling"), {}),
        (Play(("a", "b"), law=3, gap=-1.0), {"law": 3, "gap": -1.0}),
        (Stop(("a", "b"), gap=-1.0, law=ContactLaw.TRUNCATED), {}),
        (Pin("a", order=0), {"order": 0}),
        (Pin(None, math.inf), {"on": None, "amplitude": math.inf}),
        (Friction(("a", "b"), 1.0), {}),
        (Friction(("a", "b"), 1.0, -1.0), {"static": -1.0}),
        (Friction(("a", "b"), None, viscous=None), {"force": "missing; give a number, in N",
                                                    "viscous": "missing; give a number, in N s/m"}),
        (Force("a", symbol="F_1", order=2), {}),
        (Force(3, order=1.5), {"on": 3, "order": 1.5}),
        (Body(None), {"mass": "missing; give a number, in kg"}),
    ],
)  # fmt: skip
def test_fields_of_parts(part: object, wrong: dict[str, object]) -> None:
    section = {Body: "bodies", Link: "links", Play: "plays", Stop: "stops", Pin: "pins", Force: "forces"}.get(
        type(part), "frictions"
    )
    found = dict(types(**{section: {"x": part}}))
    assert found == {f"{section}.x.{name}": value for name, value in wrong.items()}


def test_outputs_and_starts() -> None:
    outputs = {"u": 3, "v": Output(4), "w": Output({"a": math.nan, "b": 1}), "x": Output({"a": None})}
    found = types(outputs=outputs)
    assert [place for place, _ in found] == ["outputs.u", "outputs.v", "outputs.w.a", "outputs.x.a"]
    assert found[3][1] == "missing; give a number"
    starts = {"a": (0.0,), "b": [0.0, math.inf], "c": (True, "x"), "d": [1, 2], "e": 3, "f": (10**400, 0)}
    found_problems = list(problems_of_types({**EMPTY, "start": starts}))
    assert [(each.place[1], each.reason, each.value) for each in found_problems] == [
        ("a", "give two numbers: [displacement in m, velocity in m/s]", (0.0,)),
        ("b", "inf must be finite", [0.0, math.inf]),
        ("c", "give a number, in m", (True, "x")),
        ("c", "give a number, in m/s", (True, "x")),
        ("e", "give two numbers: [displacement in m, velocity in m/s]", 3),
        ("f", "is too large for a floating-point number", (10**400, 0)),
    ]


@pytest.mark.parametrize(
    ("quantity", "value", "reason"),
    [
        (Quantity("m", "", Range.ANY), -1.0, ""),
        (Quantity("m", "", Range.NOT_NEGATIVE), 0.0, ""),
        (Quantity("m", "", Range.NOT_NEGATIVE), -1e-300, "must be zero or greater, in m"),
        (Quantity("m", "", Range.POSITIVE), 0, "must be greater than zero, in m"),
        (Quantity("m", "", Range.POSITIVE), 1e-300, ""),
        (Quantity("1", "", Range.WHOLE), 1, ""),
        (Quantity("1", "", Range.WHOLE), np.float64(3.0), ""),
        (Quantity("1", "", Range.WHOLE), 0, "must be a whole number from 1 on"),
        (Quantity("1", "", Range.WHOLE), 1.5, "must be a whole number from 1 on"),
        (DISPLACEMENT, math.nan, "must be finite"),
        (DISPLACEMENT, 10**400, "is too large for a floating-point number"),
        (FREQUENCY, 1e308, "is too large: its angular frequency must be finite"),
        (Quantity("m", ""), 1e308, ""),
        (FREQUENCY, 2.8e307, ""),
        (FREQUENCY, 2.9e307, "is too large: its angular frequency must be finite"),
    ],
)
def test_what_is_against_a_number(quantity: Quantity, value: object, reason: str) -> None:
    assert quantity.reason_against(value) == reason


def test_numbers_as_parts_hold_them() -> None:
    assert [is_number(each) for each in (1, 1.5, np.int8(3), np.array(2.0))] == [True] * 4
    assert [is_number(each) for each in (True, np.bool_(True), "1", 1j, None, np.ones(1))] == [False] * 6
    whole, plain = Quantity("1", "2", Range.WHOLE), Quantity("1", "2")
    assert [type(each) for each in (whole.taken(2.0), whole.taken(2.5), plain.taken(2))] == [
        int,
        float,
        float,
    ]
    assert (whole.taken(2.0), plain.taken(np.array(3))) == (2, 3.0)


def test_bodies_there_must_be_and_names_are_unique() -> None:
    assert [place for place, _ in sense()] == ["bodies"]
    assert [place for place, _ in sense(links={"l": MOUNT})] == ["bodies"]
    clash = sense(bodies={"a": A, "ground": B}, pins={"a": Pin("x"), "ground": Pin("a"), "p": Pin("y")})
    assert [place for place, _ in clash] == ["bodies.ground", "pins.ground", "pins.a", "pins.ground"]


def test_carriers_of_pins_and_forces() -> None:
    pins = {"p": Pin("a"), "q": Pin("ground"), "r": Pin("p"), "s": Pin("c")}
    forces = {"f": Force("a"), "g": Force("p"), "h": Force("ground"), "i": Force("c")}
    assert sense(bodies={"a": A}, links={"l": MOUNT}, pins=pins, forces=forces) == [
        ("pins.r.on", "p"),
        ("pins.s.on", "c"),
        ("forces.g.on", "p"),
        ("forces.h.on", "ground"),
        ("forces.i.on", "c"),
    ]


def test_ends_are_two_that_move_against_each_other() -> None:
    pins = {"p": Pin("a"), "q": Pin("a"), "g": Pin("ground"), "r": Pin("b")}
    pairs = {
        "good": ("p", "b"), "other": ("g", "r"), "one": ("x", "x"), "two": ("x", "y"), "same": ("p", "p"),
        "fixed": ("g", "ground"), "carried": ("p", "q"), "itself": ("a", "p"), "half": ("a", "y"),
    }  # fmt: skip
    found = list(
        problems_of_sense(
            {**EMPTY, "bodies": {"a": A, "b": B}, "pins": pins}
            | {"links": {name: Link(pair) for name, pair in pairs.items()}}
        )
    )
    assert {each.place[::2] for each in found} == {("links", "between")}
    assert [(each.place[1], each.reason[:33], each.value) for each in found] == [
        ("one", "there is no body or pin 'x'; ther", ["x", "x"]),
        ("two", "there is no body or pin 'x'; ther", ["x", "y"]),
        ("two", "there is no body or pin 'y'; ther", ["x", "y"]),
        ("same", "both ends are the same; name two ", ["p", "p"]),
        ("fixed", "both ends move as prescribed, so ", ["g", "ground"]),
        ("carried", "both ends are on 'a', so that not", ["p", "q"]),
        ("itself", "both ends are on 'a', so that not", ["a", "p"]),
        ("half", "there is no body or pin 'y'; ther", ["a", "y"]),
    ]
    for section, part in (
        ("plays", Play(("a", "z"))),
        ("stops", Stop(("a", "z"))),
        ("frictions", Friction(("a", "z"), 1.0)),
    ):
        assert sense(bodies={"a": A}, **{section: {"x": part}}) == [(f"{section}.x.between", ["a", "z"])]


def test_advice_names_what_is_there() -> None:
    assert _no_such("body", "x", ["abc"]) == "there is no body 'x'; there is 'abc'"
    assert _no_such("body", "x", iter(["abc", "def"])) == "there is no body 'x'; there are 'abc' and 'def'"
    assert _no_such("body", "motr", ["motor"]) == "there is no body 'motr'; did you mean motor?"


def numbers(**sections: object) -> list[tuple[str, object]]:
    return [(".".join(each.place), _shown(each)) for each in problems_of_numbers({**EMPTY, **sections})]


@pytest.mark.parametrize("section", ["plays", "stops"])
def test_a_relaxing_contact_with_damping_has_a_stiffness(section: str) -> None:
    kind, ends = {"plays": Play, "stops": Stop}[section], ("ground", "a")
    parts = {
        "bad": kind(ends, 0.0, 1.0),
        "worse": kind(ends, 0.0, 1.0, law="relaxing"),
        "stiff": kind(ends, 1e-9, 1.0),
        "idle": kind(ends),
        "truncated": kind(ends, 0.0, 1.0, law="truncated"),
        "pulling": kind(ends, 0.0, 1.0, law=ContactLaw.PULLING),
    }
    assert numbers(**{section: parts}) == [
        (f"{section}.bad.stiffness", 0.0),
        (f"{section}.worse.stiffness", 0.0),
    ]


def test_a_static_force_is_never_less_and_a_motion_needs_a_frequency() -> None:
    frictions = {
        str(k): Friction(("ground", "a"), 0.5, static) for k, static in enumerate((None, 0.4, 0.5, 0.6))
    }
    assert numbers(frictions=frictions) == [("frictions.1.static", 0.4)]
    moving = {
        "pins": {"p": Pin("a", 1e-3), "q": Pin("a"), "r": Pin("a", velocity=1.0)},
        "forces": {"f": Force("a", 1.0), "g": Force("a", amplitude=1.0), "h": Force("a", unbalance=1.0)},
    }
    found = numbers(**moving)
    assert [place for place, _ in found] == ["pins.p.amplitude", "forces.g.amplitude", "forces.h.unbalance"]
    assert [str(reason).split(",")[0] for _, reason in found] == [
        "there is an amplitude",
        "there is an amplitude",
        "there is an unbalance",
    ]
    assert numbers(frequency=1.0, **moving) == []


def test_outputs_and_starts_are_of_what_moves() -> None:
    outputs = {
        "u": Output({"a": 1.0, "p": -1.0}),
        "v": Output({}),
        "w": Output({"ground": 2.0, "x": 3.0, "a": 1.0}),
    }
    start = {"a": (0.0, 0.0), "p": (1.0, 0.0), "x": (2.0, 0.0)}
    found = sense(bodies={"a": A}, pins={"p": Pin("a")}, links={"l": MOUNT}, outputs=outputs, start=start)
    assert [place for place, _ in found] == [
        "outputs.v",
        "outputs.w.ground",
        "outputs.w.x",
        "start.p",
        "start.x",
    ]
    assert [value for _, value in found[1:]] == [2.0, 3.0, (1.0, 0.0), (2.0, 0.0)]


def test_every_body_is_touched_by_something() -> None:
    bodies = {name: Body(1.0) for name in "abcdefg"}
    parts = {
        "pins": {"p": Pin("e"), "g1": Pin("ground")},
        "links": {"l": MOUNT},
        "plays": {"p": Play(("b", "c"))},
        "frictions": {"r": Friction(("g1", "d"), 1.0)},
        "stops": {"s": Stop(("p", "g1"))},
        "forces": {"w": Force("f", 1.0)},
    }
    assert [place for place, _ in sense(bodies=bodies, **parts)] == ["bodies.g"]
    # What is wrong otherwise may be what would have touched it.
    wrong = sense(bodies=bodies, **parts, start={"x": (0.0, 0.0)})
    assert [place for place, _ in wrong] == ["start.x"]


def test_symbols_are_carried_once() -> None:
    links = {"l": Link(("ground", "a"), 1.0, symbol="k_1"), "m": Link(("ground", "a"), 1.0, symbol="k_2")}
    others = {
        "bodies": {"a": Body(1.0, "c_1")},
        "forces": {"f": Force("a", symbol="k_2")},
        "frictions": {"r": Friction(("ground", "a"), 1.0, symbol="F_1")},
        "pins": {"p": Pin("a", symbol="F_1"), "q": Pin("a")},
        "plays": {"s": Play(("ground", "a"), symbol="c_3")},
    }
    assert sense(links=links, **others) == [
        ("bodies.a.symbol", "c_1"),
        ("pins.p.symbol", "F_1"),
        ("links.l.symbol", "c_1"),
        ("links.m.symbol", "k_2"),
        # A stiffness c_3 has a damping c_3 too.
        ("plays.s.symbol", "c_3"),
        ("frictions.r.symbol", "F_1"),
        ("forces.f.symbol", "k_2"),
    ]


def test_messages_of_one_and_of_several_problems() -> None:
    one, two = Problem(("a", "b c"), "is bad", 3), Problem(("a",), "is missing")
    assert (one.sentence(), one.sentence("3 m"), two.sentence("x")) == (
        'a."b c" = 3: is bad',
        "a.\"b c\" = '3 m': is bad",
        "a: is missing",
    )
    assert Problem((), "all is bad", NOTHING).sentence() == "all is bad"
    assert as_message([one]) == 'the mechanism: a."b c" = 3: is bad'
    assert in_one(["x", "y"], "f") == "f: 2 problems:\n  x\n  y"
    three = Problem(("z", "y"), "is lost", 5)
    content = {"a": {"b c": "3 mm"}}
    lines = {("a",): 7, ("a", "b c"): 4}
    assert as_message_of_file("f", [two, three, one], content, lines) == (
        "f: 3 problems:\n  z.y = 5: is lost\n  line 4: a.\"b c\" = '3 mm': is bad\n  line 7: a: is missing"
    )
    deep = Problem(("a", "b c", "d"), "is deep", 1)
    assert as_message_of_file("f", [deep], content, lines) == 'f: line 4: a."b c".d = 1: is deep'
