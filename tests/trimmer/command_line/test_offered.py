"""What is offered for each word of a command, before any shell has its own script for it."""

from __future__ import annotations

from argparse import ArgumentParser
from itertools import product
from pathlib import Path
from types import SimpleNamespace as Made

import pytest

from trimmer.command_line import completion
from trimmer.command_line.file_options import file_to_read, file_to_write
from trimmer.command_line.main import _parser, installed_commands

shtab = pytest.importorskip("shtab")


@pytest.fixture(scope="module")
def offered() -> dict[tuple[str, str], object]:
    """What is offered, by the command and the option, or the word of the help in place of it."""
    parser = _parser(installed_commands())
    completion._prepare(parser, "")
    (commands,) = (each for each in parser._actions if isinstance(each.choices, dict))
    return {
        (name, (each.option_strings or [str(each.metavar)])[0]): getattr(each, "complete", each.choices)
        for name, below in commands.choices.items()
        for each in below._actions
    }


def test_each_word_is_offered_what_fits(offered: dict[tuple[str, str], object]) -> None:
    expected = {
        ("linear", "--parameters"): shtab.glob("*.toml"),
        ("linear", "--plot"): shtab.glob("*.svg", "*.png", "*.pdf"),
        ("linear", "--output"): completion.DISPLACEMENTS,
        ("linear", "--channels"): ("displacement", "both"),
        ("linear", "--json"): None,
        ("derive", "FILE"): shtab.glob("*.toml"),
        ("derive", "--module"): shtab.glob("*.py"),
        ("derive", "--latex"): shtab.glob("*.tex"),
        ("fit", "FILE"): shtab.glob("*.toml"),
        ("fit", "MEASURED"): shtab.glob("*.csv", "*.txt", "*.wav"),
        ("fit", "--output"): shtab.FILE,
        ("overlay", "FILE"): shtab.glob("*.csv", "*.txt", "*.wav"),
        ("overlay", "--against"): shtab.glob("*.toml"),
        ("spectrum", "--wav"): shtab.glob("*.wav"),
        ("spectrum", "--csv"): shtab.glob("*.csv"),
        ("spectrum", "--column"): None,
        ("report", "--directory"): shtab.DIRECTORY,
        ("init", "FILE"): shtab.FILE,
        ("sample", "FILE"): shtab.FILE,
    }
    assert {key: offered[key] for key in expected} == expected


def test_displacements_are_of_bodies_and_between_two_of_them() -> None:
    bodies = ("q1", "q2", "q3", "q4")
    between = {f"{one}-{other}" for one, other in product(bodies, bodies) if one != other}
    assert completion.DISPLACEMENTS[:4] == bodies
    assert set(completion.DISPLACEMENTS[4:]) == between
    assert len(completion.DISPLACEMENTS) == 16


@pytest.mark.parametrize(
    ("metavar", "kind", "takes"),
    [
        ("FILE", None, True),
        ("X", file_to_read, True),
        ("X", file_to_write, True),
        ("X", int, False),
        (None, None, False),
    ],
)
def test_what_takes_a_file(metavar: str | None, kind: object, takes: bool) -> None:
    assert completion._takes_file(Made(metavar=metavar, type=kind)) == takes


def test_options_of_others_that_are_paths_are_files() -> None:
    parser = ArgumentParser()
    parser.add_argument("--path", type=Path)
    parser.add_argument("--folder", type=Path, metavar="DIR")
    parser.add_argument("--plot", "-p", metavar="FILE")
    parser.add_argument("--number", type=int)
    completion._prepare(parser, "map")
    _, path, folder, plot, number = parser._actions
    assert (path.complete, folder.complete) == (shtab.FILE, shtab.DIRECTORY)
    assert plot.complete == shtab.glob("*.svg", "*.png", "*.pdf")
    assert not hasattr(number, "complete")
