"""How commands end that meet trouble: exit codes, and what is told of it."""

from __future__ import annotations

import io
import logging
import sys
import warnings
from pathlib import Path
from types import SimpleNamespace as Made

import numpy as np
import pytest

import trimmer.command_line.main as command_line
from trimmer.command_line.command import Command
from trimmer.command_line.file_options import _same, check_targets, file_to_read, file_to_write, show
from trimmer.command_line.mechanisms.state_option import chosen_state
from trimmer.command_line.parser import OptionError, drop, tell
from trimmer.errors import TrimmerError
from trimmer.files import PNG, SVG
from trimmer.progress import silenced


def ends(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> int:
    def run(_: object) -> int:
        raise error

    other = Command("other", "another", lambda parser: None, run)
    monkeypatch.setattr(command_line, "installed_commands", lambda: [other])
    return command_line.main(["other"])


def test_errors_have_their_codes(monkeypatch, capsys) -> None:
    dropped = []
    monkeypatch.setattr(command_line, "drop", dropped.append)
    for error, code, told in (
        (TrimmerError("wrong"), 2, "trimmer: wrong"),
        (OSError(28, "No space", "disk"), 2, "trimmer: disk: No space; send"),
        (OSError(28, "No space"), 2, "trimmer: standard output: No space"),
        (OSError("no folder for pictures"), 2, "trimmer: no folder for pictures\n"),
        (
            FileNotFoundError(2, "No usable temporary directory"),
            2,
            "trimmer: No usable temporary directory; set",
        ),
        (MemoryError(), 2, "no more could be had"),
        (MemoryError("1 TB"), 2, "memory for that (1 TB)"),
        (KeyboardInterrupt(), 130, "interrupted"),
        (BrokenPipeError(), 0, ""),
    ):
        assert ends(monkeypatch, error) == code
        assert told in capsys.readouterr().err
    assert dropped == [sys.stdout] * 5


def test_closed_streams_are_told_or_stood_in_for(monkeypatch, capsys) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(sys, "stdout", None)
        assert command_line.main(["linear"]) == 2
    assert "standard output is closed" in capsys.readouterr().err
    with monkeypatch.context() as patch:
        patch.setattr(sys, "stderr", None)
        command_line._prepare_streams()
        assert sys.stderr.name.endswith("null")
        sys.stderr.close()


def test_signs_that_an_encoding_lacks(monkeypatch) -> None:
    written = io.BytesIO()
    stream = io.TextIOWrapper(written, encoding="ascii")
    monkeypatch.setattr(sys, "stdout", stream)
    command_line._prepare_streams()
    stream.write("4 µm · ω ± 2 é")
    stream.flush()
    assert written.getvalue() == rb"4 um * omega +- 2 \xe9"


def test_warnings_are_told_in_a_sentence(capsys) -> None:
    logging.getLogger("matplotlib").setLevel(logging.NOTSET)
    with command_line._warnings_told():
        warnings.warn("careful", UserWarning, stacklevel=1)
        numbers = np.array([1e300, 0.0])
        numbers / numbers + numbers * numbers
    own, strange = capsys.readouterr().err.splitlines()
    assert own == "trimmer: warning: careful"
    assert strange.startswith("trimmer: warning: some numbers on the way became too large")
    command_line._hush_drawing()
    assert logging.getLogger("matplotlib").level == logging.ERROR


def test_commands_of_others_that_are_broken_are_left_out(monkeypatch, capsys) -> None:
    good = Command("good", "a", lambda parser: None, lambda arguments: 0)

    def broken() -> object:
        raise RuntimeError("no way")

    entries = [Made(name=name, value=name, load=load) for name, load in (
        ("bad", broken), ("odd", lambda: 3), ("good", lambda: good))]  # fmt: skip
    monkeypatch.setattr(command_line, "entry_points", lambda group: entries)
    found = command_line.installed_commands()
    assert found[-1] is good
    assert [each.name for each in found[:3]] == ["linear", "limit-cycles", "identify"]
    assert len(found) == 17
    first, second = capsys.readouterr().err.splitlines()
    assert "'bad' (bad) does not load: no way" in first
    assert "'odd' (odd) is not a Command" in second


def test_nobody_reads_what_is_told(monkeypatch) -> None:
    dropped = []
    monkeypatch.setattr("trimmer.command_line.parser.drop", dropped.append)

    class Gone(io.StringIO):
        def write(self, text: str) -> int:
            raise OSError("gone")

    gone = Gone()
    monkeypatch.setattr(sys, "stderr", gone)
    tell("hello")
    assert dropped == [gone]
    drop(io.StringIO())  # which is no file of the system


def test_control_characters_are_shown(capsys) -> None:
    tell("a\x1bb\x7fc\nd")
    assert capsys.readouterr().err == "trimmer: a\\x1bb\\x7fc\nd\n"


def test_what_is_told_makes_way_for_a_file(monkeypatch, capsys) -> None:
    out = Path("out")
    monkeypatch.setattr("trimmer.command_line.file_options.is_standard_output", lambda path: path == out)
    show("told", None, Path("other"))
    assert capsys.readouterr() == ("told\n", "")
    show("told", None, out)
    assert capsys.readouterr() == ("", "told\n")
    with silenced():
        show("told", out)
        assert capsys.readouterr() == ("", "")
        show("told", None)
        assert capsys.readouterr() == ("told\n", "")


def test_names_of_files() -> None:
    assert file_to_read("-") == Path("-")
    assert file_to_read("./-").is_absolute()
    assert file_to_read("a.toml") == Path("a.toml")
    assert file_to_write("./-") == Path("-")
    with pytest.raises(Exception, match="is no file"):
        file_to_write("-")


def test_files_that_are_written_do_not_collide(tmp_path: Path) -> None:
    first, second = tmp_path / "a.svg", tmp_path / "b.svg"
    kinds = {"one": {".svg": SVG}, "two": {".svg": SVG, ".png": PNG}}

    def check(one: object, two: object, source: object = None, overwrite: bool = False) -> None:
        check_targets(Made(one=one, two=two, file=source, overwrite=overwrite), kinds, {"file": "the source"})

    check(None, None)
    check(first, second)
    check(first, None, Path("-"), overwrite=True)
    with pytest.raises(OptionError, match="--one or --two"):
        check(None, None, overwrite=True)
    with pytest.raises(OptionError, match="both write"):
        check(first, tmp_path / "." / "a.svg")
    with pytest.raises(OptionError, match="is the source"):
        check(first, None, first)
    with pytest.raises(OptionError, match=r"--two .*must end in \.svg, \.png"):
        check(None, tmp_path / "a.txt")
    first.write_text("notes")
    with pytest.raises(TrimmerError, match="is no SVG picture"):
        check(first, None)
    check(first, None, overwrite=True)
    assert _same(first, tmp_path / "." / "a.svg")
    assert not _same(first, second)


def test_bodies_begin_where_they_are_put() -> None:
    mechanism = Made(bodies=["a", "b"])
    assert chosen_state([], mechanism) is None
    assert chosen_state(["a=1mm,-2", " 'b' = 3, 4 mm/s"], mechanism) == {
        "a": (1e-3, -2.0),
        "b": (3.0, pytest.approx(4e-3)),
    }
    for wrong in (["a=1"], ["a"], ["c=1,2"], ["a=1,2", "a=3,4"], ["a=1kg,2"], ["a=1,2mm"]):
        with pytest.raises(OptionError):
            chosen_state(wrong, mechanism)
