"""Each example in the help of a command runs, and answers."""

import json
import shutil
from collections.abc import Callable, Iterator
from contextlib import chdir
from pathlib import Path

import pytest

from tests.report.rendering.page_checks import MOST_TAB_STOPS, tab_stops, visited
from trimmer.command_line.command import Command, Example
from trimmer.command_line.help_text import WIDTH, epilog
from trimmer.command_line.main import installed_commands, main

COMMANDS = {command.name: command for command in installed_commands()}
FIRST = ("parameters", "simulate")  # What these write, the examples of others read
TAKES_LONG = (
    *(f"trimmer {name}" for name in ("compare", "derive", "design", "fit", "follow", "judge", "sample")),
    "trimmer identify --gap 4e-5 --frequency 740 --uncertainty",
    "trimmer limit-cycles --element viscous",
    "trimmer overlay vibration.csv --column q2-q4 --against examples/thesis-play.toml --set",
    "trimmer spectrum vibration.csv --column q2-q4 --as",
    "trimmer spectrum vibration.csv --column q2-q4 --window",
)
"""Beginnings of calls; transcripts make others of their commands."""
OF_THE_REPORT = "trimmer report"
"""Lines that begin so take minutes, open a browser, or read a file that a report has written."""


def examples() -> Iterator[tuple[str, Example]]:
    for name in sorted(COMMANDS, key=lambda name: name not in FIRST):
        yield from ((name, example) for example in COMMANDS[name].examples)


def marked() -> Iterator[object]:
    for name, example in examples():
        if example.words.startswith(OF_THE_REPORT):
            continue
        marks = [pytest.mark.slow] if example.words.startswith(TAKES_LONG) else []
        yield pytest.param(name, example, id=example.words.removeprefix("trimmer "), marks=marks)


def given(option: str) -> list[Example]:
    return [example for _, example in examples() if option in example.words]


def written_by_examples(example: Example) -> Iterator[Example]:
    """Find the examples that write what another one reads."""
    recorded = (("vibration.csv", "--csv"), ("motion.csv", "--csv"))
    for name, option in (("mine.toml", "--output"), *recorded, ("cells.map", "--output")):
        writes = [each for each in given(f"{option} {name}") if "--resume" not in each.words]
        reads = name in example.words and example not in writes
        yield from writes if reads else ()


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory, project_folder: Path) -> Callable[[Example], Path]:
    """A folder with what an example reads, which others write; each is run once."""
    folders: dict[str, Path] = {}

    def filled(example: Example) -> Path:
        folder = tmp_path_factory.mktemp("example")
        (folder / "examples").symlink_to(project_folder / "examples")
        for before in written_by_examples(example):
            if before.words not in folders:
                folders[before.words] = filled(before)
                with chdir(folders[before.words]):
                    assert main(before.arguments) == 0
            for file in folders[before.words].iterdir():
                if not file.is_symlink():
                    shutil.copy(file, folder)
        return folder

    return filled


@pytest.mark.parametrize(("name", "example"), [*marked()])
def test_an_example_runs(
    written: Callable[[Example], Path],
    monkeypatch,
    capfd: pytest.CaptureFixture[str],
    name: str,
    example: Example,
) -> None:
    folder = written(example)
    monkeypatch.chdir(folder)
    capfd.readouterr()
    assert main(example.arguments) == 0
    told = capfd.readouterr()
    assert told.out.strip()
    if "--json" in example.arguments:
        json.loads(told.out)
    for option, file in zip(example.arguments, example.arguments[1:], strict=False):
        if option in ("--plot", "--csv", "--wav", "--output", "--latex") and "." in file:
            assert (folder / file).stat().st_size > 0


@pytest.mark.parametrize("command", COMMANDS.values(), ids=list(COMMANDS))
def test_the_help_shows_the_examples(capsys: pytest.CaptureFixture[str], command: Command) -> None:
    assert 2 <= len(command.examples) <= 3
    for example in command.examples:
        assert example.words.split()[:2] == ["trimmer", command.name]
    with pytest.raises(SystemExit) as stopped:
        main([command.name, "--help"])
    assert stopped.value.code == 0
    shown = capsys.readouterr().out
    examples = epilog(command).split("\n\n")[0]
    assert examples in shown
    assert max(map(len, examples.split("\n"))) <= WIDTH
    typed = " ".join(shown.replace("\\\n", " ").split())
    for example in command.examples:
        assert f"{example.words} {example.purpose}" in typed


@pytest.mark.slow
@pytest.mark.browser
def test_the_examples_of_the_report_run(
    tmp_path: Path,
    capfd: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    request: pytest.FixtureRequest,
) -> None:
    """They do, and Tab is not pressed too often on the whole page."""
    monkeypatch.chdir(tmp_path)
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    whole, chapter, compared = COMMANDS["report"].examples
    assert main(whole.arguments) == 0
    page = tmp_path / "build" / "report" / "report.html"
    told = {Path(line).name for line in capfd.readouterr().out.splitlines() if line.startswith("  ")}
    assert told == {each.name for each in page.parent.iterdir() if not each.name.startswith(".")}
    kept = page.rename(tmp_path / "whole.html").as_uri()
    (tmp_path / "claims.json").write_bytes(page.with_name("claims.json").read_bytes())
    assert main(compared.arguments) == 0
    assert ": 0 changed" in capfd.readouterr().out
    assert main(chapter.arguments) == 0
    assert opened == [page.as_uri()]
    with visited(request.getfixturevalue("browser"), kept) as visit:  # begun after the builds, which fork
        assert 100 < tab_stops(visit.page) <= MOST_TAB_STOPS
