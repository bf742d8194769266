"""What was meant is asked for where a word is near, and nothing where none is."""

from pathlib import Path

import pytest

from trimmer import Mechanism
from trimmer.messages import near_file, near_match, near_or_all

ELEMENTS = ("friction", "inertia", "viscous", "coulomb", "relay")
COMMANDS = (
    "linear",
    "limit-cycles",
    "identify",
    "orbits",
    "simulate",
    "spectrum",
    "respond",
    "follow",
    "map",
)
UNITS = ("m", "mm", "um", "mN", "MN", "N", "kg", "Hz", "s")


@pytest.mark.parametrize(
    ("word", "known", "meant"),
    [
        ("frction", ELEMENTS, "friction"),
        ("FRICTION", ELEMENTS, "friction"),
        ("relais", ELEMENTS, "relay"),
        ("visc", ELEMENTS, "viscous"),
        ("limit_cycles", COMMANDS, "limit-cycles"),
        ("limitcycle", COMMANDS, "limit-cycles"),
        ("mpa", COMMANDS, "map"),
        ("simulation", COMMANDS, "simulate"),
        ("HZ", UNITS, "Hz"),
        ("mn", UNITS, "mN or MN"),
    ],
)
def test_a_near_word_is_asked_for(word: str, known: tuple[str, ...], meant: str) -> None:
    assert near_match(word, known) == f"did you mean {meant}?"


@pytest.mark.parametrize(
    ("word", "known"),
    [
        ("saturation", ELEMENTS),
        ("play", ELEMENTS),
        ("backlash", ELEMENTS),
        ("", ELEMENTS),
        ("re", ("report", "respond")),
        ("res", ("resume", "respond")),
        ("foo", COMMANDS),
        ("banana", COMMANDS),
        ("s" * 100_000, COMMANDS),
        ("inch", UNITS),
        ("-", ("--", "_")),
        ("friction", ()),
    ],
)
def test_what_is_not_near_is_not_asked_for(word: str, known: tuple[str, ...]) -> None:
    assert near_match(word, known) == ""


@pytest.mark.parametrize(
    ("known", "told"),
    [
        ([], "there is none"),
        (["mass"], "there is mass"),
        (["mass", "turned"], "there are mass and turned"),
        (["sows", "mass"], "did you mean sows?"),
    ],
)
def test_what_there_is_follows_a_name_that_nothing_has(known: list[str], told: str) -> None:
    assert near_or_all("sow", known) == told
    assert near_or_all("sow", iter(known)) == told


def test_a_file_with_a_near_name_is_asked_for(tmp_path: Path) -> None:
    there = tmp_path / "thesis-play.toml"
    there.write_text("")
    (tmp_path / "thesis-plya").mkdir()
    assert near_file(tmp_path / "thesis-plya.toml") == f"did you mean {there}?"
    assert near_file(tmp_path / "another.toml") == ""
    assert near_file(tmp_path / "nowhere" / "thesis-play.toml") == ""


@pytest.mark.parametrize(
    ("place", "advice"),
    [
        ("plays.brigde.gap", "did you mean plays.bridge.gap?"),
        ("play.bridge.gpa", "did you mean plays.bridge.gap?"),
        ("bridge.gap", "did you mean plays.bridge.gap?"),
        ("gap", "did you mean plays.bridge.gap?"),
        ("plays.slot.gap", "after plays comes bridge"),
        ("nothing", "a place begins with frequency, bodies,"),
        ("outputs.strok.cutter", "did you mean outputs.stroke.cutter?"),
    ],
)
def test_a_place_is_looked_for_name_by_name(project_folder: Path, place: str, advice: str) -> None:
    mechanism = Mechanism.from_toml(project_folder / "examples" / "thesis-play.toml")
    with pytest.raises(ValueError, match="there is no number at") as caught:
        mechanism.value(place)
    assert advice in str(caught.value)
