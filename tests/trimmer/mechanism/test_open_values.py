"""Numbers that a file leaves open: where they may stand, what is said of them, and how they are given."""

from pathlib import Path

import pytest

from trimmer import Body, Force, Link, Mechanism, MechanismError, Pin
from trimmer.mechanism.open_values import OpenValue, open_values
from trimmer.mechanism.quantities import DISPLACEMENT, QUANTITIES, NumberField
from trimmer.mechanism.reading import read_mechanism
from trimmer.mechanism.units import UnitError

TEXT = """\
frequency = " unknown "
[bodies]
a = { mass = "unknown", symbol = "m" }
[pins]
p = { on = "a", amplitude = "1 mm..2 mm", order = 2 }
[links]
l = { between = ["ground", "a"], stiffness = "1..2 N/m" }
"""


def test_a_file_with_open_values_is_no_mechanism_yet() -> None:
    with pytest.raises(MechanismError) as raised:
        Mechanism.from_toml_text(TEXT, "f")
    first, *told = str(raised.value).splitlines()
    assert first == "f: 4 problems:"
    assert [line.split(": ")[:3] for line in told] == [
        ["  line 1", "frequency = ' unknown '", told[0].split(": ")[2]],
        ["  line 3", "bodies.a.mass = 'unknown'", told[1].split(": ")[2]],
        ["  line 5", "pins.p.amplitude = '1 mm..2 mm'", told[2].split(": ")[2]],
        ["  line 7", "links.l.stiffness = '1..2 N/m'", told[3].split(": ")[2]],
    ]
    assert ["nobody knows this value" in line for line in told] == [True, True, False, False]
    assert ["this is a range" in line for line in told] == [False, False, True, True]
    assert "--set 'pins.p.amplitude=VALUE'" in told[2]


def test_open_values_are_given_by_their_places(tmp_path: Path) -> None:
    file = tmp_path / "f.toml"
    file.write_text(TEXT)
    values = {"frequency": "50 Hz", "bodies.a.mass": "3 g", "links.l.stiffness": 1.5, "links.l.damping": 9.0}
    with pytest.raises(MechanismError, match=r"f\.toml: line 5: pins\.p\.amplitude = '1 mm\.\.2 mm'"):
        read_mechanism(file, values)
    # What the file does not leave open is set by what asks for it.
    assert read_mechanism(file, {**values, "pins.p.amplitude": 1e-3}) == Mechanism(
        {"a": Body(3e-3, "m")},
        50.0,
        pins={"p": Pin("a", 1e-3, order=2)},
        links={"l": Link(("ground", "a"), 1.5)},
    )


@pytest.mark.parametrize("text", ["unknowns", "a..b"])
def test_what_is_no_open_value_is_no_number(text: str) -> None:
    with pytest.raises(MechanismError, match=r"line 5: pins\.p\.order = '[a-z.]+': "):
        Mechanism.from_toml_text(TEXT.replace("order = 2", f'order = "{text}"').replace("1 mm..2 mm", "1 mm")
                                 .replace('" unknown "', "1").replace('"unknown"', "1")
                                 .replace("1..2 N/m", "1 N/m"))  # fmt: skip
    assert not [*open_values({"pins": {"p": {"on": text, "order": "unknown"}}, "links": 5, "bodies": "x"})]


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("20 um..60 um", (20e-6, 60e-6)),
        ("20..60 um", (20e-6, 60e-6)),
        (" 20 um .. 0.06 mm ", (20e-6, 60e-6)),
        (" -.5 .. 1.5 mm", (-0.5e-3, 1.5e-3)),
        ("1e-3..2. m", (1e-3, 2.0)),
    ],
)
def test_a_range_has_two_ends(text: str, ends: tuple[float, float]) -> None:
    assert OpenValue(("x",), text, DISPLACEMENT).ends() == pytest.approx(ends, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "wanted", "reason"),
    [
        ("unknown", DISPLACEMENT, "is no range"),
        ("20 um", DISPLACEMENT, "is no range"),
        ("2 m..1 m", DISPLACEMENT, "has no length"),
        ("1 m..1 m", DISPLACEMENT, "has no length"),
        ("1..2", DISPLACEMENT, "has no unit"),
        ("1 m..2", DISPLACEMENT, "has no unit"),
        ("1..m", DISPLACEMENT, "has no unit"),
        ("0..1 kg", QUANTITIES[Body]["mass"], "has an end that must be greater than zero"),
        ("-2..-1 N", QUANTITIES[Force]["constant"], ""),
        ("-2..1 N/m", QUANTITIES[Link]["stiffness"], "has an end that must be zero or greater"),
        ("1 m..2 s", DISPLACEMENT, "'s' does not measure"),
    ],
)
def test_what_is_no_range(text: str, wanted: NumberField, reason: str) -> None:
    value = OpenValue(("x",), text, wanted)
    if not reason:
        assert value.ends() == (-2.0, -1.0)
        return
    with pytest.raises(UnitError, match=reason):
        value.ends()
