"""Parameters of the thesis's trimmer, and files of them: what is wrong is told with its key."""

import dataclasses
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given

from derivations.symbols import PARAMETERS
from tests.trimmer.trimmers import DAMPINGS, MASSES, STIFFNESSES, trimmers
from trimmer import TrimmerParameters
from trimmer.thesis import ParameterError, parameter_table

TEMPLATE = TrimmerParameters.thesis().to_toml()


def written(folder: Path, text: str | bytes) -> Path:
    path = folder / "mine.toml"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


def with_line(key: str, line: str) -> str:
    """The template with the line of one key replaced."""
    text, count = re.subn(rf"^{key} = .*$", lambda match: line, TEMPLATE, flags=re.MULTILINE)
    assert count == 1
    return text


def message_for(path: Path) -> str:
    with pytest.raises(ParameterError) as raised:
        TrimmerParameters.from_toml(path)
    assert str(raised.value).startswith(f"{path}: ")
    return str(raised.value)


def test_the_template_states_meaning_and_unit_of_each_key() -> None:
    lines = TEMPLATE.splitlines()
    for parameter in parameter_table():
        line = next(line for line in lines if line.startswith(f"{parameter.symbol} = "))
        assert line.endswith(f"# {parameter.unit}, {parameter.meaning}")


@pytest.mark.parametrize(
    ("line", "shown", "reason"),
    [
        ('m2 = "3e-3"', "m2 = '3e-3'", "give a number in kg, without quotation marks"),
        ('m2 = "1+1"', "m2 = '1+1'", "text is not evaluated"),
        ("m2 = \"__import__('os').getcwd()\"", "m2 = ", "text is not evaluated"),
        ("m2 = true", "m2 = True", "give a number in kg"),
        ("m2 = [0.003]", "m2 = [0.003]", "give a number in kg"),
        ("m2 = 2020-01-01", "m2 = ", "give a number in kg"),
        ("m2 = nan", "m2 = nan", "must be finite"),
        ("m2 = inf", "m2 = inf", "must be finite"),
        ("m2 = -inf", "m2 = -inf", "must be finite"),
        ("m2 = 0", "m2 = 0", "greater than zero"),
        ("m2 = -0.0", "m2 = -0.0", "greater than zero"),
        ("m2 = -0.003", "m2 = -0.003", "greater than zero"),
        ("m2 = 1" + "0" * 400, "m2 = 1000", "too large for a floating-point number"),
        ("m2 = 0x1" + "0" * 9000, "m2 = an integer of thousands of digits", "too large"),
    ],
)
def test_an_unusable_value_is_named_with_its_key_and_reason(tmp_path, line, shown, reason) -> None:
    message = message_for(written(tmp_path, with_line("m2", line)))
    assert shown in message
    assert reason in message
    assert len(message.splitlines()[1]) < 160


@pytest.mark.parametrize(
    ("line", "advice"),
    [
        ("M1 = 1", "M1 = 1: unknown key; did you mean m1?"),
        ("k55 = 2.0", "k55 = 2.0: unknown key; did you mean k5?"),
        ("colour = 'red'", "colour = 'red': unknown key; known keys: m1, m2,"),
        ("[masses]\nm1 = 1", "[masses]: tables are not used"),
    ],
)
def test_an_unknown_key_is_named_with_the_nearest_known_one(tmp_path: Path, line: str, advice: str) -> None:
    assert advice in message_for(written(tmp_path, f"{TEMPLATE}\n{line}\n"))


def test_all_problems_of_a_file_are_reported_at_once(tmp_path: Path) -> None:
    text = with_line("m1", "m9 = 1").replace("k1 = 200000.0", "k1 = -1")
    message = message_for(written(tmp_path, text))
    assert "3 problems" in message
    missing = "m1: missing; add 'm1 = NUMBER' (kg, mass of the motor)"
    for problem in ("m9 = 1: unknown key", missing, "k1 = -1: stiffness must not be negative"):
        assert f"\n  {problem}" in message


def test_an_empty_file_lacks_every_key(tmp_path: Path) -> None:
    assert ": is empty; 'trimmer parameters --output FILE' writes one" in message_for(written(tmp_path, ""))
    assert "13 problems" in message_for(written(tmp_path, "# nothing"))
    assert "not UTF-8 text (byte 3)" in message_for(written(tmp_path, b"# \n\xff"))


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("m1 = 0.035\nm2 : 0.003\n", "line 2"),
        ("m1 = 1\nm1 = 2\n", "line 2"),
        ("m1 = 3e\n", "line 1"),
        ("m1 = " + "[" * 100_000, "not valid TOML"),
        ("m1 = 1" + "0" * 5000, "not valid TOML"),
    ],
)
def test_a_syntax_error_is_reported_with_its_line(tmp_path: Path, text: str, place: str) -> None:
    message = message_for(written(tmp_path, text))
    assert "not valid TOML" in message
    assert place in message


def test_a_mechanism_is_no_parameter_file(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_text("bodies.block = { mass = 1.0 }")
    with pytest.raises(ParameterError, match="this is a mechanism"):
        TrimmerParameters.from_toml(path)
    path.write_text("[uncertainty]\nm1 = 3\n[other]\n")
    with pytest.raises(ParameterError) as error:
        TrimmerParameters.from_toml(path)
    problems = str(error.value).splitlines()
    assert problems[0].endswith("14 problems in the parameters:")
    assert problems[1].startswith("  [other]: tables are not used")
    assert problems[2].startswith("  m1: missing; add 'm1 = NUMBER' (kg, mass of the motor)")
    assert len(problems) == 15


@pytest.mark.parametrize(("unknown", "shown", "more"), [(5, 18, 0), (6, 17, 2)])
def test_of_many_problems_the_first_are_shown(tmp_path: Path, unknown: int, shown: int, more: int) -> None:
    """Thirteen keys are missing, too."""
    text = "".join(f"colour{number} = 1\n" for number in range(unknown))
    _, *lines = message_for(written(tmp_path, text)).splitlines()
    assert len(lines) == shown + bool(more)
    assert (f"  ... and {more} more: put these right first" in lines) is bool(more)


THESIS = TrimmerParameters.thesis()


def test_thesis_values_are_those_of_listing_a1() -> None:
    assert THESIS.values() == (0.035, 0.003, 0.005, 0.03, 200e3, 30e3, 150e3, 100e3, 1e3, 3.5, 0.4, 1, 4)


def test_meanings_and_units_are_those_of_the_derivation() -> None:
    derived = [(str(q.symbol).replace("_", ""), q.meaning, q.unit.text) for q in PARAMETERS]
    assert [(p.symbol, p.meaning, p.unit) for p in parameter_table()] == derived


def test_integers_and_numpy_numbers_become_floats() -> None:
    parameters = dataclasses.replace(THESIS, k1=200_000, c1=np.float32(3.5), m1=np.int64(1))
    assert [type(value) for value in parameters.values()] == [float] * 13
    assert (parameters.k1, parameters.c1, parameters.m1) == (200e3, 3.5, 1.0)


@pytest.mark.parametrize("symbol", MASSES)
@pytest.mark.parametrize("value", [0, 0.0, -0.001])
def test_masses_must_be_positive(symbol: str, value: float) -> None:
    with pytest.raises(ParameterError, match=rf"^{symbol} = {value!r}: a mass must be greater than zero$"):
        dataclasses.replace(THESIS, **{symbol: value})


@pytest.mark.parametrize("symbol", STIFFNESSES + DAMPINGS)
def test_stiffness_and_damping_may_be_zero_but_not_negative(symbol: str) -> None:
    assert getattr(dataclasses.replace(THESIS, **{symbol: 0.0}), symbol) == 0.0
    with pytest.raises(
        ParameterError, match=rf"^{symbol} = -1e-09: (stiffness|damping) must not be negative$"
    ):
        dataclasses.replace(THESIS, **{symbol: -1e-9})


def test_parameters_cannot_be_changed() -> None:
    with pytest.raises(dataclasses.FrozenInstanceError):
        THESIS.m1 = 1.0  # type: ignore[misc]


@given(trimmers())
def test_toml_text_reads_back_equal(parameters: TrimmerParameters) -> None:
    assert TrimmerParameters(**tomllib.loads(parameters.to_toml())) == parameters
