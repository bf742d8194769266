"""``--plot``: which commands have it, what they write, and what they refuse."""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

import pytest

from trimmer.command_line.main import installed_commands, main

EXAMPLES = Path(__file__).parents[3] / "examples"
TWIN = str(EXAMPLES / "thesis-play.toml")
PLAY = ["--element", "friction", "--gap", "4e-5"]
LINES = {
    "linear": ["linear"],
    "limit-cycles": ["limit-cycles", *PLAY],
    "identify": ["identify", "--gap", "4e-5", "--frequency", "740"],
    "orbits": ["orbits", *PLAY],
    "simulate": ["simulate", *PLAY, "--impulse", "1e-6", "--duration", "0.01"],
}
"""A call of each command that draws and has no test of its pictures of its own."""
ELSEWHERE = {"spectrum", "overlay", "respond", "follow", "map"}
WITHOUT_PICTURE = {"parameters", "derive", "report"}
BEGINNINGS = {"svg": b"<?xml", "png": b"\x89PNG", "pdf": b"%PDF-"}


def test_every_command_that_has_something_to_show_draws_it() -> None:
    with_plot = set()
    for command in installed_commands():
        parser = ArgumentParser()
        command.configure(parser)
        if "--plot" in parser.format_help():
            with_plot.add(command.name)
    assert with_plot >= set(LINES) | ELSEWHERE
    assert not with_plot & WITHOUT_PICTURE


@pytest.mark.parametrize("ending", BEGINNINGS)
def test_the_ending_gives_the_format(ending: str, tmp_path: Path, capsys) -> None:
    words, file = LINES["simulate"], tmp_path / f"picture.{ending.upper()}"
    assert main([*words, "--plot", str(file)]) == 0
    assert file.read_bytes().startswith(BEGINNINGS[ending])
    assert capsys.readouterr().out.endswith(f"wrote {file}\n")
    first = file.read_bytes()
    assert main([*words, "--plot", str(file)]) == 0  # over a picture of its kind
    assert file.read_bytes() == first


@pytest.mark.parametrize("words", LINES.values(), ids=LINES)
def test_only_what_may_be_written_is(words: list[str], tmp_path: Path, capsys) -> None:
    notes = tmp_path / "notes.svg"
    notes.write_text("notes")
    for file, message in (
        ("a.jpg", "--plot a.jpg: the name must end in .svg, .png, .pdf"),
        ("picture", "--plot picture: the name must end in .svg, .png, .pdf"),
        (str(notes), f"{notes} is there already and is no SVG picture"),
    ):
        assert main([*words, "--plot", file]) == 2
        told = capsys.readouterr()
        assert told.out == ""
        assert message in told.err
    assert notes.read_text() == "notes"
    assert main([*words, "--plot", str(notes), "--overwrite"]) == 0
    assert capsys.readouterr().out
    assert notes.read_bytes().startswith(b"<?xml")


def test_no_orbit_gives_no_picture(tmp_path: Path, capsys) -> None:
    file = tmp_path / "none.svg"
    assert main(["orbits", *PLAY, "--output", "q4", "--plot", str(file)]) == 0
    assert not file.exists()
    assert "was not written, because no orbit was found" in capsys.readouterr().err
