"""What the parser takes for an option, a value or a command, and what it tells of words that are none."""

from __future__ import annotations

import io
import math
import os
import sys
from argparse import Namespace
from pathlib import Path

import pytest

from trimmer.command_line import help_text, main
from trimmer.command_line.command import Command
from trimmer.command_line.file_options import _kind, add_overwrite_option, check_targets
from trimmer.command_line.output_options import write_picture
from trimmer.command_line.parser import (
    OptionError,
    Parser,
    as_option,
    drop,
    is_given,
    note,
    refuse_unused,
    require_positive,
    tell,
)
from trimmer.command_line.patience import LINE, patience
from trimmer.files import CSV, SVG
from trimmer.progress import is_silenced, silenced


@pytest.fixture
def parser() -> Parser:
    made = Parser(prog="x")
    made.add_argument("--size", "-s", type=float, default=2.0)
    made.add_argument("--count", type=int)
    made.add_argument("--kind", choices=("one", "two"))
    made.add_argument("--bits", type=int, choices=(16, 24))
    made.add_argument("words", nargs="*", type=str)
    return made


def wrong(parser: Parser, capsys: pytest.CaptureFixture[str], *words: str) -> str:
    with pytest.raises(SystemExit) as ended:
        parser.parse_args(words)
    assert ended.value.code == 2
    told = capsys.readouterr().err
    assert told.startswith("trimmer: ") and told.count("\n") == 1
    return told.removeprefix("trimmer: ").strip()


def test_numbers_in_every_notation_are_values(parser: Parser) -> None:
    for text in ("-1", "-1.5", "-.5", "-1e-3", "-2.E5", "-inf", "-Infinity", "1_000"):
        assert parser.parse_args(["--size", text]).size == float(text)
    assert math.isnan(parser.parse_args(["--size", "-nan"]).size)
    assert parser.parse_args(["-s", "3"]).size == 3.0
    assert parser.parse_args(["--si=4"]).size == 4.0
    assert parser.parse_args(["-2 mm", "-", "- a", "--", "--strange"]).words == [
        "-2 mm",
        "-",
        "- a",
        "--strange",
    ]
    for text in ("1000000000", "-1000000000"):
        assert parser.parse_args(["--count", text]).count == int(text)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--size", "a"], "argument --size/-s: 'a' is no number; see x --help"),
        (["--count", "1.5"], "argument --count: '1.5' is no whole number; see x --help"),
        (["--count", "1000000001"], "argument --count: '1000000001' is more than 1000000000"),
        (["--count", "-1000000001"], "argument --count: '-1000000001' is more than 1000000000"),
        (["--sise", "3"], "there is no option --sise; did you mean --size? See x --help"),
        (["--sise=3"], "there is no option --sise; did you mean --size? See x --help"),
        (["-q"], "there is no option -q; see x --help"),
        (["--", "--size", "-x", "--kind"], ""),
        (["--kind", "tow"], "argument --kind: there is no 'tow'; did you mean two? See x --help"),
        (["--kind", "xyz"], "argument --kind: there is no 'xyz'; choose one or two; see x --help"),
        (["--bits", "8"], "argument --bits: there is no 8; choose 16 or 24; see x --help"),
        (["--size", "1", "--size", "1"], "argument --size/-s: given twice, but only one value can be used"),
    ],
    ids=lambda each: " ".join(each) if isinstance(each, list) else None,
)
def test_words_that_are_none_are_told(parser: Parser, capsys, words: list[str], told: str) -> None:
    if told:
        assert wrong(parser, capsys, *words).startswith(told)
    else:
        assert parser.parse_args(words).words == words[1:]


def test_options_of_a_command_are_its_own(capsys) -> None:
    made = Parser(prog="x")
    below = made.add_subparsers(required=True).add_parser("run")
    below.add_argument("--size", type=float)
    assert made.parse_args(["run", "--size", "2"]).size == 2.0
    assert wrong(made, capsys, "--size", "2").startswith("there is no option --size; see x --help")
    assert wrong(made, capsys, "rnu").startswith("there is no command 'rnu'; did you mean run? See x")


def test_words_are_those_of_the_process_unless_they_are_given(parser: Parser, monkeypatch) -> None:
    monkeypatch.setattr(sys, "argv", ["program", "--size", "7"])
    assert parser.parse_args().size == 7.0
    assert parser.parse_args([]).size == 2.0


def test_what_was_given_is_known_by_its_name(parser: Parser) -> None:
    given = parser.parse_args(["--size", "2.0", "--kind", "one"])
    assert [is_given(given, name) for name in ("size", "kind", "count")] == [True, True, False]
    refuse_unused(given, ["count", "bits"], "use")
    for names in (["kind"], ["count", "size"]):
        with pytest.raises(OptionError, match=f"--{names[-1]} has no effect without use: add that"):
            refuse_unused(given, names, "use")
    assert not is_given(Namespace(), "size")
    assert as_option("time_constant") == "--time-constant"
    with pytest.raises(OptionError, match=r"^--dead-zone -1: dead zone must be positive and finite \(m\)$"):
        require_positive(Namespace(dead_zone=-1.0), "dead_zone", "m")


def test_notes_are_told_unless_nothing_is(capsys) -> None:
    note("hear")
    with silenced():
        note("hear nothing")
    assert capsys.readouterr().err == "trimmer: hear\n"


def test_what_is_told_is_there_at_once(monkeypatch) -> None:
    class Slow(io.StringIO):
        shown = ""

        def flush(self) -> None:
            self.shown = self.getvalue()

    slow = Slow()
    monkeypatch.setattr(sys, "stderr", slow)
    tell("now")
    assert slow.shown == "trimmer: now\n"


def test_a_purpose_breaks_between_words() -> None:
    assert help_text._told("word " * 14 + "a-bcdefghijkl").splitlines()[1] == "    a-bcdefghijkl"
    typed = help_text._typed("trimmer " + "word " * 13 + "--bcdefghijkl c")
    assert typed.splitlines()[1] == "      --bcdefghijkl c"


def test_what_is_dropped_goes_nowhere(tmp_path: Path) -> None:
    path = tmp_path / "a"
    with path.open("w") as stream:
        stream.write("left")
        drop(stream)
    assert path.read_text() == ""
    drop(io.StringIO())


def test_who_waits_is_told_after_a_while(monkeypatch) -> None:
    told = []

    class Timer:
        def __init__(self, seconds: float, function: object, given: tuple[str, ...]) -> None:
            told.append((seconds, given))
            self.daemon = False

        def start(self) -> None:
            told.append(("started", self.daemon))

        def cancel(self) -> None:
            told.append("cancelled")

    monkeypatch.setattr("trimmer.command_line.patience.Timer", Timer)
    with patience(7.0):
        told.append("inside")
    assert told == [(7.0, (LINE,)), ("started", True), "inside", "cancelled"]
    told.clear()
    with pytest.raises(ValueError, match="no"), patience():
        raise ValueError("no")
    assert told == [(2.0, (LINE,)), ("started", True), "cancelled"]
    told.clear()
    with silenced(), patience():
        told.append("inside")
    assert told == ["inside"]


def test_kinds_of_files_go_by_the_end_of_the_name(monkeypatch) -> None:
    assert _kind("plot", Path("a.SVG"), {".svg": SVG, "": CSV}) is SVG
    assert _kind("plot", Path("a.txt"), {".svg": SVG, "": CSV}) is CSV
    with pytest.raises(OptionError, match=r"^--plot a.txt: the name must end in .svg$"):
        _kind("plot", Path("a.txt"), {".svg": SVG})
    module = "trimmer.command_line.file_options"
    for stream, output in ((True, False), (False, True)):
        monkeypatch.setattr(f"{module}.is_stream", lambda path, stream=stream: stream)
        monkeypatch.setattr(f"{module}.is_standard_output", lambda path, output=output: output)
        assert _kind("plot", Path("a"), {".svg": SVG}) is SVG
        with pytest.raises(OptionError, match="must end in"):
            _kind("plot", Path("a"), {".svg": SVG, ".csv": CSV})


def test_a_picture_is_written_as_its_name_ends(tmp_path: Path, monkeypatch) -> None:
    asked = []
    monkeypatch.setattr(
        "trimmer.drawing.content.content_of", lambda figure, ending: asked.append((figure, ending)) or b"x"
    )
    made = Parser()
    add_overwrite_option(made)
    path = tmp_path / "a.PNG"
    figure: object = "figure"
    write_picture(Namespace(plot=path, overwrite=False), figure)  # type: ignore[arg-type]
    assert (asked, path.read_bytes()) == ([("figure", "png")], b"x")
    assert made.parse_args(["--overwrite"]).overwrite is True


def test_two_files_may_both_go_nowhere() -> None:
    nowhere = Path(os.devnull)
    kinds = {"csv": {"": CSV}, "plot": {".svg": SVG}}
    asked = Namespace(csv=nowhere, plot=nowhere, file=None, overwrite=False)
    check_targets(asked, kinds, {"file": "the source"})
    asked.csv = asked.plot = Path("a.svg")
    with pytest.raises(OptionError, match=r"^--csv and --plot both write a\.svg: name two files$"):
        check_targets(asked, kinds, {"file": "the source"})


def test_each_run_prepares_its_streams_and_drawing(monkeypatch, capsys) -> None:
    told = []
    monkeypatch.setattr(main, "_prepare_streams", lambda: told.append("streams"))
    monkeypatch.setattr(main, "_hush_drawing", lambda: told.append("drawing"))
    monkeypatch.setattr(sys.stdout, "flush", lambda: told.append("flushed"))

    def run(arguments: Namespace) -> int:
        told.append((is_silenced(), arguments.size))
        return 7

    command = Command("other", "another", lambda parser: parser.add_argument("--size", type=int), run)
    monkeypatch.setattr(main, "installed_commands", lambda: [command])
    assert main.main(["other", "--size", "3"]) == 7
    assert told == ["streams", "drawing", (False, 3), "flushed"]
    assert main.main(["other", "--quiet"]) == 7
    assert told[6] == (True, None)
    assert capsys.readouterr() == ("", "")
