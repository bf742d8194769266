"""A file to go on with that somebody changed by hand or exchanged for a stream is refused in a sentence."""

import json
import os
from pathlib import Path
from typing import Any

import pytest

from tests.hostile.commands import called

EXAMPLES = Path(__file__).parents[2] / "examples"
MAP = ("map", str(EXAMPLES / "den-hartog.toml"), "--vary", "frequency=0.1:0.12:2", "--periods", "20")
SAMPLE = ("sample", str(EXAMPLES / "scatter.toml"), "--count", "2", "--periods", "20")
KEPT = ("--jobs", "1", "--output", "kept")


@pytest.fixture(autouse=True)
def own_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def changed(line: str, place: tuple[str | int, ...], value: object) -> str:
    data = json.loads(line)
    inside: Any = data
    for name in place[:-1]:
        inside = inside[name]
    inside[place[-1]] = value
    return json.dumps(data)


MOTION = ("motions", 0)
OF_MAP: list[tuple[tuple[str | int, ...], object]] = [
    ((*MOTION, "period_count"), 0),
    ((*MOTION, "kind"), "chaotic"),
    ((*MOTION, "states", 0, 0), 1e200),
    ((*MOTION, "largest_multiplier"), -1.0),
    ((*MOTION, "lyapunov"), 1e300),
    ((*MOTION, "holding"), [1]),
    ((*MOTION, "failure"), "a\x1b[31m"),
    ((*MOTION, "measures", "peak_to_peak", "block"), -1.0),
    ((*MOTION, "measures", "rms_acceleration", "block"), 1e60),
    ((*MOTION, "measures", "wear_power", "floor"), 1e60),
    ((*MOTION, "measures", "impact_speed"), -0.5),
    (("number",), 1),
]
OF_SAMPLE: list[tuple[tuple[str | int, ...], object]] = [
    (("kind",), None),
    (("period_count",), 0),
    (("period_count",), 77),
    *((("period_count",), "one"), (("kind",), "nonsense"), (("measures",), [1.0]), (("measures",), 3)),
    *((("measures", 0), -1.0), (("number",), 1), (("number",), 17), (("number",), "a")),
]


@pytest.mark.parametrize(("words", "changes"), [(MAP, OF_MAP), (SAMPLE, OF_SAMPLE)], ids=["map", "sample"])
def test_numbers_that_cannot_be_are_not_gone_on_with(capsys, words, changes) -> None:
    assert called(capsys, *words, *KEPT)[0] == 0
    path = Path("kept")
    head, first, second = path.read_text("utf-8").splitlines()
    _, right, _ = called(capsys, *words, *KEPT, "--resume")
    for place, value in changes:
        path.write_text(f"{head}\n{changed(first, place, value)}\n{second}\n", "utf-8")
        code, out, told = called(capsys, *words, *KEPT, "--resume")
        assert (code, out) == (2, ""), place
        line = 3 if (place, value) == (("number",), 1) else 2  # as the second is of the first cell then
        assert told.startswith(f"trimmer: kept, line {line}: is no "), place
        assert told.count("\n") == 1
    path.write_text(f"{head}\n{first}\n", "utf-8")
    assert called(capsys, *words, *KEPT, "--resume")[:2] == (0, right)


@pytest.mark.parametrize("words", [MAP, SAMPLE], ids=["map", "sample"])
@pytest.mark.parametrize("kind", ["pipe", "zero"])
def test_nothing_goes_on_with_a_stream(capsys, words: tuple[str, ...], kind: str) -> None:
    if kind == "pipe":
        os.mkfifo("kept")
    else:
        os.symlink("/dev/zero", "kept")
    code, out, told = called(capsys, *words, *KEPT, "--resume")
    assert (code, out) == (2, "")
    assert told == "trimmer: kept is a stream, from which nothing can go on: name a file\n"
