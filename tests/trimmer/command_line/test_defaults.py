"""Options have the defaults that their help tells, and those that cannot be left out are asked for."""

from __future__ import annotations

import re
from argparse import Action, ArgumentParser, Namespace
from collections.abc import Iterator
from pathlib import Path

import pytest

from trimmer.command_line import help_text, number_options
from trimmer.command_line.command import Command, Example
from trimmer.command_line.main import _parser, installed_commands, main
from trimmer.command_line.parser import Parser, is_given, require_positive
from trimmer.command_line.runner_options import check_runner_options, chosen_runner
from trimmer.errors import TrimmerError
from trimmer.runners.cluster import ClusterRunner
from trimmer.runners.processes import ProcessRunner
from trimmer.runners.runner import CHUNK, SerialRunner


def options() -> Iterator[tuple[str, Action]]:
    for command in installed_commands():
        parser = Parser()
        command.configure(parser)
        for action in parser._actions:
            yield command.name, action


def test_defaults_are_those_of_the_help() -> None:
    told = 0
    for command, action in options():
        found = re.search(r"\(default: (-?[\d.]+|refuse|both|mark|hann)\b", action.help or "")
        if found is None or action.default in (None, []):
            continue
        told += 1
        word = found[1].rstrip(".")
        same = float(word) == action.default if word[0].isdigit() else word == action.default
        assert same, (command, action.option_strings, action.default, word)
    assert told > 25


def test_what_cannot_be_left_out() -> None:
    needed: dict[str, set[str]] = {}
    for command, action in options():
        if action.required and action.option_strings:
            needed.setdefault(command, set()).add(action.option_strings[0])
    expected = {
        "follow": {"--vary", "--from", "--to"},
        "identify": {"--gap", "--frequency"},
        "limit-cycles": {"--element"},
        "orbits": {"--element"},
        "overlay": {"--against"},
    }
    assert {name: needed[name] for name in expected} == expected
    assert not {"simulate", "respond", "map", "sample", "fit", "spectrum", "linear"} & set(needed)


def test_what_is_given_once_replaces_a_default_that_stays_for_the_next() -> None:
    whole = _parser(installed_commands())
    first = whole.parse_args(["respond", "a.toml", "--set", "x=1", "--set", "y=2", "--seed", "3"])
    assert (first.set, first.seed, first.file) == (["x=1", "y=2"], 3, Path("a.toml"))
    assert first.whole is whole
    second = whole.parse_args(["respond", "a.toml"])
    assert (second.set, second.seed, second.state, second.starts) == ([], 0, [], 1)
    assert is_given(first, "seed") and not is_given(second, "seed")


@pytest.mark.parametrize("name", ["MISSING", "COMMAND"])
def test_a_command_is_asked_for(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main([] if name == "MISSING" else ["simulat"])
    assert ended.value.code == 2
    assert capsys.readouterr().err.startswith("trimmer: ")


def test_the_version_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    import trimmer

    with pytest.raises(SystemExit) as ended:
        main(["--version"])
    assert ended.value.code == 0
    assert capsys.readouterr().out == f"trimmer {trimmer.__version__}\n"


def test_words_that_have_no_use_are_named(capsys: pytest.CaptureFixture[str]) -> None:
    for words, told in (
        (["a"], "'a' has no use here; leave it out"),
        (["a", "b"], "have no use here; leave them"),
    ):
        with pytest.raises(SystemExit):
            main(["linear", *words])
        assert told in capsys.readouterr().err


@pytest.mark.parametrize(
    ("jobs", "scheduler", "chunk", "expected"),
    [
        (None, None, None, None),
        (1, None, 3, SerialRunner()),
        (2, None, None, ProcessRunner(2, CHUNK)),
        (2, None, 3, ProcessRunner(2, 3)),
        (None, "tcp://127.0.0.1:1", None, ClusterRunner("tcp://127.0.0.1:1", CHUNK)),
        (None, "tcp://127.0.0.1:1", 3, ClusterRunner("tcp://127.0.0.1:1", 3)),
    ],
)
def test_who_does_the_work(
    jobs: int | None,
    scheduler: str | None,
    chunk: int | None,
    expected: object,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("trimmer.command_line.runner_options._silence_dask", lambda: None)
    arguments = Namespace(jobs=jobs, scheduler=scheduler)
    check_runner_options(arguments)
    assert chosen_runner(arguments, chunk) == expected


@pytest.mark.parametrize(
    ("jobs", "scheduler"), [(0, None), (-1, None), (1, "tcp://127.0.0.1:1"), (None, ""), (None, "  ")]
)
def test_nobody_can_do_the_work(jobs: int | None, scheduler: str | None) -> None:
    with pytest.raises(TrimmerError):
        check_runner_options(Namespace(jobs=jobs, scheduler=scheduler))


def test_numbers_of_options() -> None:
    positive, finite = number_options.positive("m"), number_options.finite("s")
    assert (positive("2e-3"), finite("-2.5"), finite("0")) == (2e-3, -2.5, 0.0)
    assert number_options.positive_whole("1") == 1
    assert number_options.positive_whole("1000000000") == 10**9
    for kind, wrong in (
        (positive, ("0", "-1", "inf", "nan", "a")),
        (finite, ("inf", "-inf", "nan", "a")),
        (number_options.positive_whole, ("0", "-1", "1.0", "1000000001", "10000000000000", "²", "", "a")),
    ):
        for text in wrong:
            with pytest.raises(Exception, match="is not a"):
                kind(text)


@pytest.mark.parametrize("value", [0.0, -1.0, float("inf"), float("nan")])
def test_what_must_be_positive(value: float) -> None:
    with pytest.raises(TrimmerError, match="positive"):
        require_positive(Namespace(sample_rate=value), "sample_rate", "Hz")
    require_positive(Namespace(sample_rate=1e-9), "sample_rate", "Hz")


def test_examples_stand_below_the_options_as_they_are_typed() -> None:
    def unused(*_: object) -> int:
        return 0

    plain = Command("a", "b", unused, unused)
    assert help_text.epilog(plain) == help_text.EXIT_CODES
    words = "trimmer a " + " ".join(f"--option-{number} value" for number in range(6))
    told = help_text.epilog(Command("a", "b", unused, unused, examples=(Example(words, "long " * 30),)))
    examples, codes = told.split("\n\n")
    lines = examples.split("\n")
    assert (lines[0], codes) == ("Examples:", help_text.EXIT_CODES)
    assert all(len(line) <= 79 for line in lines)
    assert " ".join(examples.replace("\\\n", " ").split()) == f"Examples: {words} {'long ' * 30}".strip()
    typed = [line for line in lines if "--option" in line]
    assert typed[0].startswith("  trimmer a") and typed[0].endswith(" \\")
    assert typed[1].startswith("      --option") or typed[1].startswith("      value")
    purpose = [line for line in lines if "long" in line]
    assert all(line.startswith("    long") for line in purpose)


def test_paragraphs_are_filled_and_examples_are_not() -> None:
    parser = ArgumentParser(
        prog="x", formatter_class=help_text.HelpText, epilog=f"{'word ' * 40}\n\n  as it\n    is typed\n\nend"
    )
    shown = parser.format_help()
    assert "\n\n  as it\n    is typed\n\nend" in shown
    assert max(map(len, shown.splitlines())) < 120
