"""Numbers that a file leaves open, what is wrong with a file, and the advice on places that are not there."""

from __future__ import annotations

import math

import numpy as np
import pytest

from trimmer.errors import MechanismError
from trimmer.mechanism.mechanism import Mechanism
from trimmer.mechanism.open_values import OpenValue, open_values, replaced
from trimmer.mechanism.parts import Body, Force, Friction, Link, Output, Pin, Play
from trimmer.mechanism.place_text import key_text, parse_place, place_text, split_assignment, unit_of
from trimmer.mechanism.printed_symbols import natural_order, value_of
from trimmer.mechanism.problems import Problem, as_message, as_message_of_file
from trimmer.mechanism.quantities import DISPLACEMENT, FREQUENCY, QUANTITIES, Quantity, Range, is_number
from trimmer.mechanism.units import UnitError, quantity, unit

GAP = QUANTITIES[Play]["gap"]


def ends(text: str, measured: Quantity = GAP) -> tuple[float, float]:
    return OpenValue(("plays", "bridge", "gap"), text, measured).ends()


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("20 um..60 um", (20e-6, 60e-6)),
        ("20..60 um", (20e-6, 60e-6)),
        ("1.5..2.5 mm", (1.5e-3, 2.5e-3)),
        (" 20 um .. 0.06 mm ", (20e-6, 60e-6)),
        ("0 um..1 m", (0.0, 1.0)),
    ],
)
def test_a_range_has_two_ends(text: str, expected: tuple[float, float]) -> None:
    assert ends(text) == expected


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("unknown", "no range"),
        ("20 um", "no range"),
        ("60 um..20 um", "no length"),
        ("20 um..20 um", "no length"),
        ("-20 um..20 um", "has an end that"),
        ("20 um..60", "no unit"),
        ("20..60", "no unit"),
        ("20 um..60 kg", "does not measure"),
    ],
)
def test_what_is_no_range(text: str, reason: str) -> None:
    with pytest.raises(UnitError, match=reason):
        ends(text)


def test_open_values_are_found_in_every_section_by_their_keys() -> None:
    content = {
        "frequency": "100 Hz..120 Hz",
        "bodies": {"motor": {"mass": "unknown", "symbol": "m..n"}, "cutter": 3.0},
        "pins": {"pin": {"amplitude": " unknown ", "order": "1..2", "phase": "0.3 rad"}},
        "plays": {"bridge": {"gap": "20 um..60 um", "law": "a..b"}},
        "links": "unknown",
    }
    found = {each.place: each for each in open_values(content)}
    assert list(found) == [
        ("frequency",),
        ("bodies", "motor", "mass"),
        ("pins", "pin", "amplitude"),
        ("plays", "bridge", "gap"),
    ]
    assert [each.is_unknown for each in found.values()] == [False, True, True, False]
    assert [each.quantity for each in found.values()] == [
        FREQUENCY,
        QUANTITIES[Body]["mass"],
        DISPLACEMENT,
        GAP,
    ]
    assert list(open_values({"frequency": 110.0})) == []
    problems = [each.problem() for each in found.values()]
    assert [problem.place for problem in problems] == list(found)
    assert "plays.bridge.gap=VALUE" in problems[-1].reason
    assert ("nobody knows" in problems[1].reason, "a range" in problems[1].reason) == (True, False)
    assert ("nobody knows" in problems[0].reason, "a range" in problems[0].reason) == (False, True)


def test_open_values_are_replaced_in_a_copy() -> None:
    content = {"frequency": "unknown", "plays": {"bridge": {"gap": "1..2 m", "law": "x"}, "other": {}}}
    found = replaced(content, {("frequency",): 110.0, ("plays", "bridge", "gap"): 4e-5})
    assert found == {"frequency": 110.0, "plays": {"bridge": {"gap": 4e-5, "law": "x"}, "other": {}}}
    assert content["frequency"] == "unknown"
    assert content["plays"]["bridge"]["gap"] == "1..2 m"  # type: ignore[index]


@pytest.mark.parametrize(
    ("limits", "good", "bad"),
    [
        (Range.ANY, (-1.0, 0, np.float64(2.0)), (math.inf, math.nan, "1", True, None, 1j)),
        (Range.NOT_NEGATIVE, (0.0, 1e-300), (-1e-300, -1)),
        (Range.POSITIVE, (1e-300, 7), (0.0, -1)),
        (Range.WHOLE, (1, 2.0, np.int64(3)), (0, 1.5, -1, math.inf)),
    ],
)
def test_which_numbers_will_do(limits: Range, good: tuple[object, ...], bad: tuple[object, ...]) -> None:
    wanted = Quantity("N", "1 N", limits)
    assert [wanted.reason_against(each) for each in good] == [""] * len(good)
    assert all(wanted.reason_against(each) for each in bad)


def test_numbers_are_taken_as_floats_or_whole_ones() -> None:
    assert isinstance(Quantity("1", "2", Range.WHOLE).taken(2.0), int)
    assert isinstance(Quantity("1", "2").taken(2), float)
    assert Quantity("1", "2").taken(10**400) == math.inf
    assert "too large" in Quantity("N", "1 N").reason_against(10**400)
    assert "angular frequency" in FREQUENCY.reason_against(1e308)
    assert "angular frequency" not in DISPLACEMENT.reason_against(1e308)
    assert [is_number(each) for each in (1, np.float32(1), True, np.bool_(True), np.ones(1), "1")] == [
        *(True, True, False, False, False, False)
    ]
    assert ", in " not in Quantity("1", "2", Range.POSITIVE).reason_against(0)
    assert ", in N" in Quantity("N", "2 N", Range.POSITIVE).reason_against(0)


@pytest.mark.parametrize(
    ("text", "si_unit", "number"),
    [
        ("3 t", "kg", 3000.0),
        ("90 rpm", "Hz", 1.5),
        ("2 min", "s", 120.0),
        ("180 deg", "rad", math.pi),
        ("2 N/mm/mm", "N/m^2", 2e6),
        ("5 mm^2", "m²", 5e-6),
        ("4 s⁻²", "1/s^2", 4.0),
        ("7 kN", "N", 7000.0),
        ("7 Ns/m", "N s/m", 7.0),
        ("3 kg·m", "kg m", 3.0),
        ("2", "1", 2.0),
        ("8 ng", "kg", 8e-12),
        ("6 MHz", "Hz", 6e6),
        ("1 cm", "m", 0.01),
        ("9 mrad", "rad", 0.009),
        ("2 °/s", "rad/s", math.pi / 90),
    ],
)
def test_units(text: str, si_unit: str, number: float) -> None:
    assert quantity(text, si_unit) == pytest.approx(number, rel=1e-15, abs=0.0)


@pytest.mark.parametrize(
    "text", ["1 cs", "1 krad", "1 cN", "1 nHz", "1 Mg", "1 N/m s", "1e401 m", "1e-330 m", "9e308 km"]
)
def test_units_that_are_none(text: str) -> None:
    with pytest.raises(UnitError):
        quantity(text, "m")


def test_units_multiply() -> None:
    assert unit("deg") * unit("s") == unit("s deg")
    assert (unit("deg") ** -2).half_turns == -2
    assert unit("N").dimension == (1, 1, -2, 0)
    assert (unit("km") ** 2).scale == 10**6
    assert (unit("N") ** 3).dimension == (3, 3, -6, 0)


def test_places_as_text() -> None:
    assert place_text(("links", "motor mount", "k_1")) == 'links."motor mount".k_1'
    assert parse_place(' links . motor mount . "a.b" ') == ("links", "motor mount", "a.b")
    assert key_text("") == '""'
    assert split_assignment("a.'b=c' = 3 = 4") == ("a.'b=c'", "3 = 4")
    units = {"plays.bridge.gap": "m", "pins.pin.order": "1"}
    assert [unit_of(units, each) for each in ('plays."bridge".gap', "pins.pin.order", "x")] == ["m", "", ""]
    for text in ("a..b", "", ".a", "a.", '"\\q".a'):
        with pytest.raises(MechanismError):
            parse_place(text)


def test_messages_of_a_file_stand_in_its_order_with_its_values() -> None:
    problems = [
        Problem(("plays", "bridge", "gap"), "is bad", 4e-5),
        Problem(("bodies", "motor", "mass"), "is missing"),
        Problem((), "is empty"),
    ]
    content = {"plays": {"bridge": {"gap": "40 um"}}, "bodies": {"motor": 1.0}}
    lines = {("plays", "bridge", "gap"): 9, ("bodies", "motor"): 3}
    told = as_message_of_file("file", problems, content, lines).splitlines()
    assert told == [
        "file: 3 problems:",
        "  is empty",
        "  line 3: bodies.motor.mass: is missing",
        "  line 9: plays.bridge.gap = '40 um': is bad",
    ]
    assert as_message(problems[:1]) == "the mechanism: plays.bridge.gap = 4e-05: is bad"
    assert as_message_of_file("file", problems[1:2], content, {}) == "file: bodies.motor.mass: is missing"


def mechanism() -> Mechanism:
    return Mechanism(
        {"motor": Body(0.03), "cutter": Body(0.003)},
        110.0,
        pins={"pin": Pin("motor", 1e-3)},
        links={"mount": Link(("ground", "motor"), 5.0), "spring": Link(("motor", "cutter"), 7.0)},
        plays={"bridge": Play(("cutter", "pin"), 3e4, 0.4, 4e-5)},
        frictions={"blade": Friction(("motor", "cutter"), 0.5, 0.8)},
        forces={"push": Force("motor", 1.0)},
        outputs={"relative": Output({"cutter": 1.0, "motor": -2.0})},
        start={"motor": (0.1, 0.2)},
    )


@pytest.mark.parametrize(
    ("place", "advice"),
    [
        ("plays.bridge.stifness", "plays.bridge.stiffness"),
        ("plays.brigde.gap", "plays.bridge.gap"),
        ("bridge.gap", "plays.bridge.gap"),
        ("frequenzy", "frequency"),
        ("links.mount", "after links.mount comes stiffness or damping"),
        ("plays", "after plays comes bridge"),
        ("nothing at all", "a place begins with"),
        ("start.motor.nothing", "after start.motor comes displacement or velocity"),
    ],
)
def test_advice_on_places(place: str, advice: str) -> None:
    with pytest.raises(MechanismError) as caught:
        mechanism().value(place)
    assert advice in str(caught.value)


def test_numbers_of_all_places() -> None:
    given = mechanism()
    expected = {
        "frequency": 110.0,
        "outputs.relative.motor": -2.0,
        "start.motor.displacement": 0.1,
        "start.motor.velocity": 0.2,
        "start.cutter.velocity": 0.0,
        "frictions.blade.static": 0.8,
        "frictions.blade.force": 0.5,
        "links.spring.stiffness": 7.0,
    }
    assert {place: given.value(place) for place in expected} == expected
    changed = given.with_value("start.cutter.velocity", 3.0).with_value("outputs.relative.cutter", 4)
    assert changed.start == {"motor": (0.1, 0.2), "cutter": (0.0, 3.0)}
    assert changed.outputs["relative"].weights == {"cutter": 4.0, "motor": -2.0}
    assert len(given.places) == len(set(given.places))
    with pytest.raises(MechanismError):
        Mechanism({"a": Body(1.0)}, links={"k": Link(("ground", "a"), 1.0)}).value("frequency")


def test_what_symbols_stand_for() -> None:
    given = mechanism()
    assert value_of(given, ("frictions", "blade", "static")) == 0.8
    assert value_of(given, ("plays", "bridge", "gap")) == 4e-5
    assert value_of(given, ("plays", "bridge", "distance")) is None
    assert sorted(["q_10", "q_2", "q", "p_2"], key=natural_order) == ["q", "p_2", "q_2", "q_10"]
