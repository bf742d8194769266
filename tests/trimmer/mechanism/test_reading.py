"""Bad files: each problem is named with file, line, key and value, and what to do."""

import io
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trimmer import Mechanism, MechanismError, TrimmerParameters

GOOD = """\
frequency = 110.0
[bodies]
a = { mass = 1 }
b = { mass = 2 }
[pins]
p = { on = "a", amplitude = 1e-3 }
[links]
mount = { between = ["ground", "a"], stiffness = 3 }
[plays]
slot = { between = ["b", "p"], stiffness = 4, damping = 0.5, gap = 1e-4 }
[frictions]
rub = { between = ["a", "b"], force = 1 }
[forces]
push = { on = "b", constant = 1 }
[outputs]
y = { b = 1, p = -1 }
[start]
a = [0, 0.5]
"""


def message_for(text: str) -> str:
    with pytest.raises(MechanismError) as raised:
        Mechanism.from_toml_text(text, "mine.toml")
    return str(raised.value)


def test_the_good_file_is_good(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text("\ufeff" + GOOD, encoding="utf-8")
    mechanism = Mechanism.from_toml(str(tmp_path / "mine.toml"))
    assert mechanism == Mechanism.from_toml_text(GOOD)
    assert mechanism.start == {"a": (0.0, 0.5)}


def test_standard_input_is_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(GOOD.encode())))
    assert Mechanism.from_toml("-") == Mechanism.from_toml_text(GOOD)


WALL = "[walls]\nw = { between = ['ground', 'a']%s }\n[forces]\n"
CASES = {
    "mass = 1 ": {
        "mass = 0 ": "line 3: bodies.a.mass = 0: must be greater than zero, in kg",
        "mass = -1 ": "line 3: bodies.a.mass = -1: must be greater than zero",
        "mass = '1 g ": "not valid TOML: ",
        "mass = true ": "line 3: bodies.a.mass = True: give a number, in kg",
        "": "line 3: bodies.a.mass: missing; add mass = 0.035",
        "mas = 1 ": "line 3: bodies.a.mas = 1: unknown key; did you mean mass?",
    },
    "a = { mass = 1 }": {"a = 1": "line 3: bodies.a = 1: give its keys in braces, as in { mass = 0.035 }"},
    "gap = 1e-4": {
        'gap = "3 kg"': "line 10: plays.slot.gap = '3 kg': 'kg' does not measure what m does",
        'gap = "3"': "line 10: plays.slot.gap = '3': has no unit",
        "gap = -1e-4": "line 10: plays.slot.gap = -0.0001: must be zero or greater",
        'gap = "-1 mm"': "line 10: plays.slot.gap = '-1 mm': must be zero or greater",
        "gap = nan": "line 10: plays.slot.gap = nan: must be finite",
        "gap = inf": "line 10: plays.slot.gap = inf: must be finite",
        'law = "relax"': "line 10: plays.slot.law = 'relax': did you mean relaxing?",
        'law = "soft"': "line 10: plays.slot.law = 'soft': choose relaxing, truncated or pulling",
    },
    "damping = 0.5": {"damping = -1": "line 10: plays.slot.damping = -1: must be zero or greater, in N s/m"},
    "stiffness = 4": {
        "stiffness = -4": "line 10: plays.slot.stiffness = -4: must be zero or greater",
        "stiffness = 0": "line 10: plays.slot.stiffness = 0: a relaxing contact with damping",
    },
    "force = 1": {
        "force = -1": "line 12: frictions.rub.force = -1: must be zero or greater, in N",
        "force = 1, static = 0.5": "line 12: frictions.rub.static = 0.5: the static force is less",
        "force = 1, viscous = -1": "line 12: frictions.rub.viscous = -1: must be zero or greater",
    },
    ", force = 1": {
        "": "line 12: frictions.rub.force: missing; add force = 0.5",
        ", force = 1, curve = [[0, 1]]": "line 12: frictions.rub.force = 1: the curve gives the kinetic",
        ", curve = 3": "line 12: frictions.rub.curve = 3: give at least one point [speed in",
        ", curve = [[0, 1], [2]]": "give at least one point [speed in m/s and force in N], as in [[0.0, 1.0]",
        ", curve = [[1, 1]]": "line 12: frictions.rub.curve.1.speed = 1.0: the curve of a friction begins at",
        ", curve = [[0, 1], [1, -1]]": "line 12: frictions.rub.curve.2.force = -1: must be zero or greater",
        ", curve = [[0, 1], ['2 m', 1]]": "rub.curve.2.speed = '2 m': 'm' does not measure what m/s does",
        ", curve = [[0, 1]], static = 0.5": "line 12: frictions.rub.static = 0.5: the static force is less",
    },
    '["a", "b"]': {
        '["a", "c"]': "line 12: frictions.rub.between = ['a', 'c']: there is no body or pin 'c'",
        '["a", "a"]': "line 12: frictions.rub.between = ['a', 'a']: both ends are the same",
        '["a", "p"]': "both ends are on 'a', so that nothing between them can move it",
        '["a"]': "name two ends, as in",
        '"ab"': "name two ends, as in",
        '["a", 3]': "name two ends, as in",
    },
    "[forces]\n": {
        WALL % "": "line 14: walls.w.restitution: missing; add restitution = 0.5",
        WALL % ", restitution = 1.2": "line 14: walls.w.restitution = 1.2: must be from 0 to 1",
        WALL % ", restitution = -0.1": "line 14: walls.w.restitution = -0.1: must be from 0 to 1",
    },
    '["ground", "a"]': {'["Ground", "a"]': "there is no body or pin 'Ground'; did you mean ground?"},
    "[links]": {
        'belt = { on = "ground" }\n[links]\nx = { between = ["belt", "ground"] }': "nothing to act on",
        'q = { on = "p" }\n[links]': "line 7: pins.q.on = 'p': a pin sits on a body or on the ground",
        'q = { on = "c" }\n[links]': "line 7: pins.q.on = 'c': there is no body 'c';",
        'a = { on = "b" }\n[links]': "line 7: pins.a: a body has this name already",
        'ground = { on = "b" }\n[links]': "line 7: pins.ground: this name stands for the fixed frame",
        'q = { on = "a", order = 0 }\n[links]': "pins.q.order = 0: must be a whole number from 1 on",
        'q = { on = "a", order = 1.5 }\n[links]': "pins.q.order = 1.5: must be a whole number",
    },
    "[pins]": {
        "c = { mass = 1 }\n[pins]": "line 5: bodies.c: nothing touches body 'c'; add a link",
        "ground = { mass = 1 }\n[pins]": "line 5: bodies.ground: this name stands for the fixed frame",
        "[pin]": "line 5: pin: unknown key; did you mean pins?",
    },
    "frequency = 110.0": {
        "": "line 6: pins.p.amplitude: there is an amplitude, but no frequency",
        "frequency = 0": "line 1: frequency = 0: must be greater than zero, in Hz",
        "frequency = -1.5": "line 1: frequency = -1.5: must be greater than zero",
        'frequency = "691 rad/s"': "'rad/s' does not measure what Hz does; \"110 Hz\"",
        "frequncy = 110.0": "line 1: frequncy = 110.0: unknown key; did you mean frequency?",
        "frequency = 110.0\ntitle = 3": "line 2: title = 3: must be text on one line",
    },
    'on = "b"': {
        'on = "ground"': "forces.push.on = 'ground': a force on the ground moves nothing",
        'on = "p"': "forces.push.on = 'p': a force acts on a body; this is a pin on 'a'",
        'on = "c"': "forces.push.on = 'c': there is no body 'c'",
        "on = 3": "forces.push.on = 3: name a body",
    },
    "y = { b = 1, p = -1 }": {
        "y = {}": "line 16: outputs.y: has no weights; write them",
        "y = 3": "line 16: outputs.y = 3: give weights",
        "y = { c = 1 }": "line 16: outputs.y.c = 1: there is no body or pin 'c'",
        "y = { ground = 1 }": "outputs.y.ground = 1: the ground does not move",
        "y = { b = '1 m' }": "outputs.y.b = '1 m': 'b' is a translation, so that its weight is a",
        "y = { velocity = { c = 1 } }": "line 16: outputs.y.velocity.c = 1: there is no body or pin 'c'",
        "y = { velocity = {} }": "line 16: outputs.y: has no weights",
        "y = { acceleration = 1 }": "outputs.y.acceleration = 1: give weights, as in { acceleration = {",
        "y = { force = 3 }": 'line 16: outputs.y.force = 3: name a part, as in { force = "bridge" }',
        "y = { force = 'mont' }": "there is no link, play, stop, wall or friction 'mont'",
        "y = { control = 'axis' }": "line 16: outputs.y.control = 'axis': there is no controller",
        "y = { velocity = { b = '1 m' } }": "outputs.y.velocity.b = '1 m': 'b' is a translation, so that its",
        "y = { velocity = { b = 1 }, b = 1 }": "outputs.y.velocity = {'b': 1}: give a number",
        "y = { velocity = 1, b = 1 }": "outputs.y.velocity = 1: there is no body or pin 'velocity'",
    },
    "a = [0, 0.5]": {
        "c = [0, 0.5]": "line 18: start.c = [0, 0.5]: there is no body 'c'",
        "p = [0, 0.5]": "line 18: start.p = [0, 0.5]: a pin starts where its motion puts it",
        "a = [0]": "line 18: start.a = [0]: give two numbers",
        "a = 3": "line 18: start.a = 3: give two numbers",
        "a = [0, '3 N']": "start.a = [0, '3 N']: 'N' does not measure what m/s does",
        "a = [0, false]": "line 18: start.a = [0, False]: give a number, in m/s",
    },
    "stiffness = 3": {
        "curve = [[0, 1]]": "line 8: links.mount.curve = [[0, 1]]: give at least two points [elongation in",
        "curve = [[0, 1], [0, 2]]": "line 8: links.mount.curve.2.elongation = 0.0: the elongation must rise",
        "curve = [[0, nan], [1, 2]]": "line 8: links.mount.curve.1.force = nan: must be finite",
        'symbol = "\\\\input"': "links.mount.symbol = '\\\\input': a symbol is a letter",
        'symbol = "c_1"': "the symbol c_1 is taken twice",
    },
}
"""Good text, bad text in its place, and what the message says."""


@pytest.mark.parametrize(
    ("old", "new", "expected"), [(old, new, cases[new]) for old, cases in CASES.items() for new in cases]
)
def test_each_problem_is_named(old: str, new: str, expected: str) -> None:
    assert GOOD.count(old) == 1
    message = message_for(GOOD.replace(old, new))
    assert message.startswith("mine.toml: ")
    assert expected in message
    assert len(message.splitlines()) == 1


def test_a_symbol_on_two_parts_is_named_at_both() -> None:
    text = GOOD.replace("mass = 1 ", 'mass = 1, symbol = "m"').replace("mass = 2 ", 'mass = 2, symbol = "m"')
    assert [line.split(": the")[0] for line in message_for(text).splitlines()[1:]] == [
        "  line 3: bodies.a.symbol = 'm'",
        "  line 4: bodies.b.symbol = 'm'",
    ]


def test_problems_stand_in_the_order_of_the_file() -> None:
    text = GOOD.replace("mass = 2", "mass = 0").replace("110.0", "-1").replace("gap = 1e-4", "gap = -1")
    lines = message_for(text).splitlines()
    assert lines[0] == "mine.toml: 3 problems:"
    assert [line.split(":")[0] for line in lines[1:]] == ["  line 1", "  line 4", "  line 10"]


@pytest.mark.parametrize("text", ["", "title = 'x'", "[bodies]", "[links]"])
def test_a_file_without_bodies_is_told_how_to_write_one(text: str) -> None:
    assert "there is none; write one, as in motor = { mass = 0.035 } below [bodies]" in message_for(text)


@pytest.mark.parametrize(
    ("text", "place"),
    [("[bodies", "(at "), ("a = 1\nb =", "(at end of document)"), ("a = 1\na = 2", "document")],
)
def test_what_is_no_toml_is_named_with_its_place(text: str, place: str) -> None:
    message = message_for(text)
    assert message.startswith("mine.toml: not valid TOML: ")
    assert place in message
    assert len(message.splitlines()) == 1


@pytest.mark.parametrize("text", ["bodies = 3", "[[bodies]]\nmass = 1", "bodies = [1]"])
def test_bodies_must_be_a_section(text: str) -> None:
    assert "is a section: write [bodies] on a line of its own" in message_for(text)


def test_a_parameter_file_is_named_and_what_takes_it(tmp_path: Path) -> None:
    path = tmp_path / "parameters.toml"
    path.write_text(TrimmerParameters.thesis().to_toml())
    with pytest.raises(MechanismError, match="this is a parameter file, for 'trimmer linear"):
        Mechanism.from_toml(path)


@given(st.text(st.sampled_from('\n[]{}=",.ab1 '), max_size=40), st.integers(0, len(GOOD)), st.integers(0, 20))
def test_no_file_ends_in_a_traceback(noise: str, at: int, length: int) -> None:
    try:
        Mechanism.from_toml_text(GOOD[:at] + noise + GOOD[at + length :])
    except MechanismError as error:
        assert str(error).startswith("the text: ")
