"""Files that keep results as they come, and the processes and clusters that do the work."""

from __future__ import annotations

import os
import re
from concurrent.futures import Future
from pathlib import Path

import pytest

from trimmer.errors import MapFileError
from trimmer.files import FileKind, FileWriteError
from trimmer.runners import cluster, processes
from trimmer.runners.chunks import AHEAD, handed_back
from trimmer.runners.record_file import RecordFile, appended, as_line, cut

RECORDS = RecordFile(
    FileKind("file of a map", re.compile(rb'\{"trimmer map"')),
    "trimmer map",
    3,
    "map",
    "cell of a map",
    {"seed": "another seed"},
)
HEADER = {"trimmer map": 3, "seed": 5}


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "a.map"
    RECORDS.begin(path, HEADER)
    return path


def test_a_file_is_begun_once(file: Path) -> None:
    with pytest.raises(MapFileError, match="already"):
        RECORDS.begin(file, HEADER)
    RECORDS.begin(file, HEADER | {"seed": 6}, overwrite=True)
    assert RECORDS.header(file)["seed"] == 6
    other = file.with_name("other.txt")
    other.write_text("notes")
    with pytest.raises(FileWriteError):
        RECORDS.begin(other, HEADER)
    RECORDS.begin(other, HEADER, overwrite=True)
    with pytest.raises(MapFileError, match="is a stream"):
        RECORDS.begin(Path(os.devnull), HEADER)


def test_results_are_there_as_soon_as_they_are_done(file: Path) -> None:
    done = appended(file, iter([1, 2]), lambda number: {"é": number})
    assert next(done) == 1
    assert file.read_text("utf-8").splitlines()[1:] == ['{"é": 1}']
    assert list(done) == [2]
    assert list(RECORDS.entries(file, HEADER)) == [(2, {"é": 1}), (3, {"é": 2})]


def test_half_a_line_does_not_count(file: Path) -> None:
    whole = file.read_bytes()
    file.write_bytes(whole + b'{"a": 1}\n{"a"')
    assert list(RECORDS.entries(file, HEADER)) == [(2, {"a": 1})]
    cut(file)
    assert file.read_bytes() == whole + b'{"a": 1}\n'
    file.write_bytes(b'{"trimmer map"')
    with pytest.raises(MapFileError, match="is no file of a map"):
        RECORDS.header(file)
    cut(file)
    assert file.read_bytes() == b""


def test_what_a_file_was_begun_with_is_held_to(file: Path) -> None:
    with pytest.raises(MapFileError, match="begun with another seed"):
        list(RECORDS.entries(file, HEADER | {"seed": 6}))
    file.write_bytes(file.read_bytes() + b"nonsense\n")
    with pytest.raises(MapFileError, match="line 2: is no cell of a map"):
        list(RECORDS.entries(file, HEADER))
    for content, told in (
        ('{"other": 3}\n', "is no file of a map"),
        ("[1]\n", "is no file of a map"),
        ("nonsense\n", "is no file of a map"),
        (as_line(HEADER | {"trimmer map": 2}), "has format 2"),
    ):
        file.write_text(content, "utf-8")
        with pytest.raises(MapFileError, match=told):
            RECORDS.header(file)
    with pytest.raises(MapFileError, match="cannot be read"):
        RECORDS.header(file.with_name("none"))


def test_chunks_are_sent_ahead_for_all_who_work() -> None:
    sent: list[list[int]] = []
    waiting: list[int] = []

    def submit(chunk: list[int]) -> Future[list[int]]:
        sent.append(chunk)
        future: Future[list[int]] = Future()
        future.set_result([10 * number for number in chunk])
        waiting.append(len(sent))
        return future

    results = handed_back(submit, range(25), 2, lambda: 2)
    first = next(results)
    assert len(sent) == 2 * AHEAD
    assert sorted([first, *results]) == [10 * number for number in range(25)]
    assert [len(chunk) for chunk in sent] == [2] * 12 + [1]


def test_processes_are_as_many_as_asked_or_as_cores() -> None:
    assert processes.ProcessRunner(3).count == 3
    assert processes.ProcessRunner().count == processes.cores() == len(os.sched_getaffinity(0))
    for wrong in ({"processes": 0}, {"chunk": 0}):
        with pytest.raises(ValueError, match="from 1 on"):
            processes.ProcessRunner(**wrong)


@pytest.mark.parametrize("wrong", [{"chunk": 0}, {"patience": 0}])
def test_a_cluster_needs_whole_numbers(wrong: dict[str, int]) -> None:
    with pytest.raises(ValueError, match="from 1 on"):
        cluster.ClusterRunner("tcp://127.0.0.1:1", **wrong)
