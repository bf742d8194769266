"""What a mechanism that is put together wrongly is told: every place, and nothing beside them."""

import math
import re

import numpy as np
import pytest

from trimmer import Mechanism, MechanismError
from trimmer.mechanism import Body, ContactLaw, Force, Friction, Link, Output, Pin, Play, Stop

A, B = Body(1.0), Body(2.0)
MOUNT = {"mount": Link(("ground", "a"), 3.0)}
ONE_LINE = "a name must be text on one line, without spaces around it"


def told(**fields: object) -> list[str]:
    """Return what is said of a mechanism of one body on a link with other fields, a sentence each."""
    try:
        Mechanism(**{"bodies": {"a": A}, "links": MOUNT} | fields)
    except MechanismError as error:
        first, *others = str(error).splitlines()
        return [line.strip() for line in others] or [first.removeprefix("the mechanism: ")]
    return []


def places(**fields: object) -> list[str]:
    return [re.split(r": | = ", sentence)[0] for sentence in told(**fields)]


@pytest.mark.parametrize(
    ("title", "frequency", "wrong"),
    [
        ("a b", 1, []),
        ("a\nb", 2.8e307, ["title"]),
        (3, 2.9e307, ["title", "frequency"]),
        ("", 0.0, ["frequency"]),
    ],
)
def test_titles_and_frequencies(title: object, frequency: float, wrong: list[str]) -> None:
    assert places(title=title, frequency=frequency) == wrong


@pytest.mark.parametrize("name", [" a", "a ", "a\tb", "\n"])
def test_names_are_text_on_one_line(name: str) -> None:
    for fields in (
        {"bodies": {name: A}},
        {"outputs": {name: Output({"a": 1.0})}},
        {"outputs": {"y": Output({name: 1.0})}},
        {"start": {name: (0.0, 0.0)}},
    ):
        assert ONE_LINE in "".join(told(**fields))
        (section,) = fields
        assert told(**{section: {3: A}})[0].startswith(f"{section}: a name must be text, not 3")
    assert told(bodies={"a b": A}, links={"l": Link(("ground", "a b"))}) == []


@pytest.mark.parametrize(
    ("section", "part", "wrong"),
    [
        ("links", Link(["ground", "a"], symbol="k_1"), []),
        ("links", Link(("ground", "a"), symbol="1"), ["symbol"]),
        ("links", Link("ab"), ["between"]),
        ("links", Link(("ground", "a", "c")), ["between"]),
        ("links", Link((1, "a"), -1.0, -2.0), ["between", "stiffness", "damping"]),
        ("plays", Play(("ground", "a"), law="pulling"), []),
        ("plays", Play(("ground", "a"), law=3, gap=-1.0), ["gap", "law"]),
        ("plays", Play(("ground", "a"), 0.0, 1.0), ["stiffness"]),
        ("plays", Play(("ground", "a"), 0.0, 1.0, law="truncated"), []),
        ("plays", Play(("ground", "a"), 1e-9, 1.0), []),
        ("plays", Play(("ground", "a")), []),
        ("stops", Stop(("ground", "a"), gap=-1.0, law=ContactLaw.TRUNCATED), []),
        ("stops", Stop(("ground", "a"), 0.0, 1.0, law="relaxing"), ["stiffness"]),
        ("pins", Pin("a", order=0), ["order"]),
        ("pins", Pin("a", order=1.5), ["order"]),
        ("pins", Pin("a", order=np.float64(3.0)), []),
        ("pins", Pin(None, math.inf), ["on", "amplitude"]),
        ("frictions", Friction(("ground", "a"), 0.5, 0.5), []),
        ("frictions", Friction(("ground", "a"), 0.5, 0.4), ["static"]),
        ("frictions", Friction(("ground", "a"), 1.0, -1.0), ["static"]),
        ("frictions", Friction(("ground", "a"), None, viscous=None), ["force", "viscous"]),
        ("forces", Force("a", symbol="F_1", order=2), []),
        ("forces", Force(3, order=1.5), ["on", "order"]),
        ("bodies", Body(None), ["mass"]),
        ("bodies", Body(10**400), ["mass"]),
    ],
)
def test_each_field_of_a_part_is_looked_at(section: str, part: object, wrong: list[str]) -> None:
    name = "a" if section == "bodies" else "x"
    assert sorted(places(**{section: {name: part}})) == sorted(f"{section}.{name}.{each}" for each in wrong)


def test_outputs_are_of_one_kind_and_their_names_are_free() -> None:
    loose = {"u": Output(kind="speed"), "v": Output({"a": 1.0}, "force", "mount"), "w": Output(kind="force")}
    assert places(outputs=loose) == ["outputs.u.kind", "outputs.v", "outputs.w.force"]
    assert places(outputs={"u": Output({"a": 1.0}, part="mount")}) == ["outputs.u.part"]
    twice = {"links": MOUNT, "frictions": {"mount": Friction(("ground", "a"), 1.0)}}
    force, speed = Output(kind="force", part="mount"), Output({"a": 1.0}, "velocity")
    assert "a part of this name is in links and frictions" in told(**twice, outputs={"u": force})[0]
    bodies, links = {"force": A}, {"mount": Link(("ground", "force"), 3.0)}
    for output in (force, Output({"force": 1.0}, "velocity")):
        (sentence,) = told(bodies=bodies, links=links, outputs={"u": output})
        assert sentence.startswith("bodies.force: this name says of which kind an output is")
    (sentence,) = told(bodies=bodies, links=links, outputs={"u": Output({"force": 1.0})})
    assert "with the one key 'force' it is no displacement" in sentence
    assert told(outputs={"u": force, "v": speed}) == []


def test_what_moves_by_a_wave_needs_a_frequency() -> None:
    moving = {
        "pins": {"p": Pin("a", 1e-3), "q": Pin("a"), "r": Pin("a", velocity=1.0)},
        "forces": {"f": Force("a", 1.0), "g": Force("a", amplitude=1.0), "h": Force("a", unbalance=1.0)},
    }
    assert places(**moving) == ["pins.p.amplitude", "forces.g.amplitude", "forces.h.unbalance"]
    assert "there is an unbalance, but no frequency" in told(**moving)[2]
    assert told(frequency=1.0, **moving) == []


def test_symbols_are_carried_once() -> None:
    links = {"l": Link(("ground", "a"), 1.0, symbol="k_1"), "m": Link(("ground", "a"), 1.0, symbol="k_2")}
    others = {
        "bodies": {"a": Body(1.0, "c_1")},
        "forces": {"f": Force("a", symbol="k_2")},
        "frictions": {"r": Friction(("ground", "a"), 1.0, symbol="F_1")},
        "pins": {"p": Pin("a", symbol="F_1"), "q": Pin("a")},
        "plays": {"s": Play(("ground", "a"), symbol="c_3")},  # its damping is called c_3 too
    }
    owners = ["bodies.a", "pins.p", "links.l", "links.m", "plays.s", "frictions.r", "forces.f"]
    assert places(links=links, **others) == [f"{owner}.symbol" for owner in owners]
