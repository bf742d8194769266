"""Calls of the command line answer as they did: ``transcript.py`` says what the files are and renews them."""

import json
import re
import shutil
from collections.abc import Iterator
from difflib import unified_diff
from pathlib import Path
from typing import Any

import pytest
from matplotlib import pyplot

from tests.json_document import documented
from tests.trimmer.command_line.alike import alike
from tests.trimmer.command_line.inputs import write_inputs
from tests.trimmer.command_line.transcript import FOLDER, Call, made, read, written
from trimmer.command_line.parser import WRONG_USE

WITH_JSON = {
    **{name: f"trimmer {name}" for name in ("linear", "limit-cycles", "identify", "orbits", "spectrum")},
    **{name: f"trimmer {name}" for name in ("overlay", "respond", "follow", "sweep", "map", "fit")},
    "linear-mechanisms": "trimmer linear, of a mechanism",
    "simulate-loops": "trimmer simulate",
    "simulate": "trimmer simulate, of a mechanism",
}
"""Files of transcripts, and what is documented of the JSON in them."""
NOT_SEEN = re.compile(
    r"(.*\.)?(families|faults|gaps|meetings|not_found|undecided|weak)\[\]\..*|(motions\[\]\.)?spectrum\..*"
    r"|waveforms_left_out|contacts\.NAME\.completed_chatters|(motions\[\]\.)?outputs\.NAME\.(peaks|own_frequency|multiples)"
    r"|(motions\[\]\.)?(swings|slowing).*"
)
"""Documented keys of what these calls have none of."""
MOST_LINES = 40


@pytest.fixture(scope="module")
def inputs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("inputs")
    write_inputs(folder)
    return folder


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow] if name.startswith("slow-") else [])
        for name in sorted(path.stem for path in FOLDER.glob("*.txt"))
    ],
)
def test_calls_answer_as_they_did(name: str, inputs: Path, tmp_path: Path) -> None:
    calls = read(FOLDER / f"{name}.txt")
    folder = tmp_path / "folder"
    shutil.copytree(inputs, folder, symlinks=True)
    open_before = pyplot.get_fignums()
    answers = list(made(calls, folder))
    assert pyplot.get_fignums() == open_before
    unlike = [pair for pair in zip(calls, answers, strict=True) if not pair[0].alike(pair[1])]
    if unlike:
        pytest.fail("\n\n".join(_difference(*pair) for pair in unlike), pytrace=False)
    if name in WITH_JSON:
        known = documented(WITH_JSON[name])
        found = {key for call in answers if "--json" in call.line for key in _keys(call.printed, known)}
        assert found - known == set()
        assert {key for key in known - found if not NOT_SEEN.match(key)} == set()


def _difference(kept: Call, found: Call) -> str:
    lines = list(unified_diff(str(kept).splitlines(), str(found).splitlines(), lineterm="", n=1))[2:]
    return "\n".join([f"$ {kept.line}", *lines[:MOST_LINES]])


def _keys(printed: str, known: set[str]) -> Iterator[str]:
    return _paths(json.loads(printed), known, "") if printed else iter(())


def _paths(value: Any, known: set[str], path: str) -> Iterator[str]:
    """Yield the paths in a JSON, down to those that are documented; NAME stands for any name."""
    below = any(each.startswith((f"{path}.", f"{path}[]")) for each in known) or not path
    if isinstance(value, dict) and value and below:
        named = any(each.startswith(f"{path}.NAME") for each in known)
        for key, each in value.items():
            yield from _paths(each, known, ".".join(filter(None, (path, "NAME" if named else key))))
    elif isinstance(value, list) and any(isinstance(each, dict) for each in value) and below:
        for each in value:
            yield from _paths(each, known, f"{path}[]")
    elif path in known or not below or value:
        yield path


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.txt")), ids=lambda path: path.stem)
def test_files_are_as_they_would_be_written(path: Path) -> None:
    assert path.read_text("utf-8") == written(read(path))


@pytest.mark.parametrize(
    ("kept", "found", "same"),
    [
        ("at 733.631 Hz", "at 733.632 Hz", True),
        ("at 733.631 Hz", "at 733.633 Hz", False),
        ("at 733.631 Hz", "at 733.631 s", False),
        ("at 733.631 Hz", "at  733.631 Hz", False),
        ("a  0.1", "a  0.100000001", True),
        ("a  0.1", "a  0.101", False),
        ("4e-05 m", "5e-05 m", False),
        ("4 cells", "5 cells", False),
        ("1e-15", "-3.5e-16", True),
        ("1e-9", "2e-9", False),
        ("q2-q4", "q2-q3", False),
        ("of 1 2", "of 1", False),
    ],
)
def test_digits_are_compared_by_value(kept: str, found: str, same: bool) -> None:
    assert alike(kept, found) is same


@pytest.mark.parametrize("path", sorted(FOLDER.glob("refused-*.txt")), ids=lambda path: path.stem)
def test_wrong_use_is_told_in_a_sentence_alone(path: Path) -> None:
    refused = [call for call in read(path) if call.code]
    assert {call.code for call in refused} == {WRONG_USE}
    for call in refused:
        first, *others = call.err.splitlines()
        assert (call.out, first[:9]) == ("", "trimmer: "), call.line
        assert all(line.startswith("  ") for line in others), call.line  # a list of problems
