"""Bars, examples, kinds of TOML files, and words of choices: small modules that all others rest on."""

import warnings
from pathlib import Path

import numpy as np
import pytest

from trimmer import MechanismError, examples
from trimmer.choices import Choice, ChoiceError
from trimmer.progress import is_silenced, silenced
from trimmer.thesis import parameter_table
from trimmer.toml_files import is_mechanism_file, is_parameter_file, parsed, read_text


def test_silence_ends_with_its_block_whatever_happens() -> None:
    with pytest.raises(ValueError, match="no"), silenced():
        assert is_silenced()
        with silenced():
            assert is_silenced()
        assert is_silenced()
        warnings.warn("not heard", UserWarning, stacklevel=1)
        raise ValueError("no")
    assert not is_silenced()
    with pytest.warns(UserWarning, match="heard"):
        warnings.warn("heard", UserWarning, stacklevel=1)


def test_files_are_told_apart_by_what_they_hold() -> None:
    for content, parameters, mechanism in (
        ({}, False, False),
        ({"x": 1}, False, False),
        ({"c4": 1}, True, False),
        ({"m1": 1, "x": 2}, True, False),
        ({"m1": 1, "bodies": 3}, False, False),
        ({"bodies": {}}, False, True),
        ({"m1": 1, "bodies": {}}, False, True),
    ):
        assert (is_parameter_file(content), is_mechanism_file(content)) == (parameters, mechanism)
    assert all(is_parameter_file({parameter.symbol: 1}) for parameter in parameter_table())
    assert not any(is_parameter_file({symbol: 1}) for symbol in ("m5", "k6", "c5", "m11", "xm1"))


def test_what_is_wrong_with_a_file_is_told_in_its_own_error(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_bytes(b"\xef\xbb\xbfx = 3\n")
    assert read_text(path, MechanismError, "advice") == "x = 3\n"
    path.write_bytes(b"ab\xff")
    with pytest.raises(MechanismError, match=r"a\.toml: not UTF-8 text \(byte 2\); save it"):
        read_text(path, MechanismError, "advice")
    path.write_text(" \n")
    with pytest.raises(MechanismError, match=r"a\.toml: is empty; advice$"):
        read_text(path, MechanismError, "advice")
    with pytest.raises(MechanismError, match=r"b\.toml: no such file; did you mean .*a\.toml\?$"):
        read_text(tmp_path / "b.toml", MechanismError, "advice")
    with pytest.raises(MechanismError, match=r"horse: no such file; advice$"):
        read_text(tmp_path / "horse", MechanismError, "advice")
    with pytest.raises(MechanismError, match=r"is a folder; name the file in it$"):
        read_text(tmp_path, MechanismError, "advice")
    with pytest.raises(MechanismError, match=r"File name too long; advice$"):
        read_text(tmp_path / ("x" * 300), MechanismError, "advice")
    assert parsed("x = 3", "a.toml", MechanismError, "advice") == {"x": 3}
    for text in ("x =", f"x = {'9' * 5000}", "x = " + 5000 * "["):
        with pytest.raises(MechanismError, match=r"^mine: not valid TOML: .*; advice$"):
            parsed(text, "mine", MechanismError, "advice")


class Size(Choice):
    FLAT_TOP = 1
    EIGHT = 2

    @property
    def word(self) -> str:
        return "8" if self is Size.EIGHT else super().word


def test_a_choice_is_meant_by_itself_by_its_word_or_by_its_number() -> None:
    assert [Size.chosen(each, "size") for each in (Size.EIGHT, "flat-top", "8", 8, np.int64(8))] == [
        Size.EIGHT,
        Size.FLAT_TOP,
        *(3 * [Size.EIGHT]),
    ]
    with pytest.raises(ChoiceError, match=r"^size is 'flattop': did you mean flat-top\?$"):
        Size.chosen("flattop", "size")
    for wrong in ("xyz", 9, 8.0, None):
        with pytest.raises(ChoiceError, match=r"^size is .*: choose flat-top or 8$"):
            Size.chosen(wrong, "size")  # type: ignore[arg-type]


def test_examples_are_named_in_their_order_and_asked_for() -> None:
    names = examples.examples()
    assert list(names) == sorted(names) and examples.USUAL in names
    assert examples.example_text() == examples.example_text("thesis-play")
    with pytest.raises(
        examples.UnknownExampleError, match=r"^there is no example 'den-harto'; did you mean den-hartog\?"
    ):
        examples.example_text("den-harto")
    with pytest.raises(examples.UnknownExampleError, match=r"there are .*den-hartog.* and"):
        examples.example_text("xyz")
